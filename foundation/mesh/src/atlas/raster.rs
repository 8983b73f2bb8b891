//! Which texels a triangle covers. Texel (i, j) is the square from (i, j) to (i + 1, j + 1).

use super::chart::Flat;

/// Calls `span(row, columns)` with the texels that the triangle touches, also with a corner only,
/// each row once. Parts within `slack` of a texel touch it.
pub(crate) fn touched(corners: [Flat; 3], slack: f64, mut span: impl FnMut(i64, [i64; 2])) {
    let low = corners.iter().fold(f64::INFINITY, |y, p| y.min(p[1])) - slack;
    let high = corners.iter().fold(f64::NEG_INFINITY, |y, p| y.max(p[1])) + slack;
    for row in low.floor() as i64..=high.floor() as i64 {
        let (bottom, top) = (row as f64 - slack, row as f64 + 1.0 + slack);
        let mut left = f64::INFINITY;
        let mut right = f64::NEG_INFINITY;
        for (p, q) in [(0, 1), (1, 2), (2, 0)] {
            let (p, q) = (corners[p], corners[q]);
            let (p, q) = if p[1] <= q[1] { (p, q) } else { (q, p) };
            if q[1] < bottom || p[1] > top {
                continue;
            }
            let slope = (q[0] - p[0]) / (q[1] - p[1]);
            let at = |y: f64| (p[0] + (y - p[1]) * slope).clamp(p[0].min(q[0]), p[0].max(q[0]));
            let first = if p[1] >= bottom { p[0] } else { at(bottom) };
            let last = if q[1] <= top { q[0] } else { at(top) };
            left = left.min(first.min(last));
            right = right.max(first.max(last));
        }
        if left <= right {
            span(
                row,
                [
                    (left - slack).floor() as i64,
                    (right + slack).floor() as i64,
                ],
            );
        }
    }
}

/// Calls `span(row, columns)` with the texels whose centres lie in the triangle. Of two triangles
/// with a common side, exactly one has a centre that lies on it.
pub(crate) fn centres(corners: [Flat; 3], mut span: impl FnMut(i64, [i64; 2])) {
    let low = corners.iter().fold(f64::INFINITY, |y, p| y.min(p[1]));
    let high = corners.iter().fold(f64::NEG_INFINITY, |y, p| y.max(p[1]));
    for row in (low - 0.5).ceil() as i64..(high - 0.5).ceil() as i64 {
        let y = row as f64 + 0.5;
        let mut ends = [f64::INFINITY, f64::NEG_INFINITY];
        for (p, q) in [(0, 1), (1, 2), (2, 0)] {
            if let Some(x) = at_height(y, corners[p], corners[q]) {
                ends = [ends[0].min(x), ends[1].max(x)];
            }
        }
        let [first, after] = ends.map(|x| (x - 0.5).ceil() as i64);
        if first < after {
            span(row, [first, after - 1]);
        }
    }
}

/// Calls `cross(row, column)` for each row of texel centres that a segment crosses, with the first
/// column whose centre is not to the left of the segment.
pub(super) fn crossings([p, q]: [Flat; 2], mut cross: impl FnMut(i64, i64)) {
    let (low, high) = (p[1].min(q[1]), p[1].max(q[1]));
    for row in (low - 0.5).ceil() as i64..(high - 0.5).ceil() as i64 {
        if let Some(x) = at_height(row as f64 + 0.5, p, q) {
            cross(row, (x - 0.5).ceil() as i64);
        }
    }
}

/// Where a segment, without its upper end, has this height.
fn at_height(y: f64, p: Flat, q: Flat) -> Option<f64> {
    // The same order of the ends in both triangles at a side gives the same rounding.
    let (p, q) = if p[1] <= q[1] { (p, q) } else { (q, p) };
    let inside = p[1] <= y && y < q[1];
    inside.then(|| p[0] + (y - p[1]) * ((q[0] - p[0]) / (q[1] - p[1])))
}
