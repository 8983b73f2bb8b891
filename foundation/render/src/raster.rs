//! Scan conversion of projected triangles.
//!
//! Corners are snapped to a grid of 1/4096 pixel and all coverage is decided in integers (Pineda
//! 1988, *A parallel algorithm for polygon rasterization*). A pixel centre on an edge shared by two
//! triangles belongs to exactly one of them by the top-left rule, so a closed mesh has neither
//! cracks nor pixels drawn twice.

use std::ops::Range;

/// Grid steps per pixel. Corners up to 2¹⁶ pixels away then make products of up to 2⁵⁹.
const STEPS: i64 = 4096;

/// A corner: column and row in pixels, and a value that is affine across the triangle on the
/// picture (such as the inverse depth).
pub(crate) type Corner = [f64; 3];

/// Calls `visit(index, value)` for each pixel of a `width` × `height` picture whose centre the
/// triangle covers.
///
/// Corners may lie up to 65,536 pixels away. Triangles without area cover nothing; both
/// orientations are drawn.
pub(crate) fn fill(
    width: usize,
    height: usize,
    triangle: [Corner; 3],
    visit: impl FnMut(usize, f32),
) {
    fill_rows(width, 0..height, triangle, visit);
}

/// As [`fill`], for some rows of the picture alone; the index counts from its first row.
pub(crate) fn fill_rows(
    width: usize,
    within: Range<usize>,
    mut triangle: [Corner; 3],
    mut visit: impl FnMut(usize, f32),
) {
    let snap = |c: f64| (c * STEPS as f64).round() as i64;
    let mut corners = triangle.map(|[x, y, _]| [snap(x), snap(y)]);
    let mut area = edge(corners[0], corners[1], corners[2]);
    if area == 0 {
        return;
    }
    if area < 0 {
        corners.swap(1, 2);
        triangle.swap(1, 2);
        area = -area;
    }

    let columns = pixel_range(corners.map(|c| c[0]), width);
    let rows = pixel_range(corners.map(|c| c[1]), within.end);
    let rows = rows.start.max(within.start)..rows.end;
    if columns.is_empty() || rows.is_empty() {
        return;
    }

    // Edge i lies opposite corner i, so its function divided by the area is that corner's
    // barycentric coordinate.
    let edges = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| Edge::new(corners[i], corners[j]));
    let values = triangle.map(|c| c[2]);
    let per_area = values.map(|v| v / area as f64);
    let (low, high) = bounds(values);

    let first = [centre(columns.start), centre(rows.start)];
    let mut row_starts = edges.each_ref().map(|e| e.at(first));
    for row in rows {
        let mut at = row_starts;
        for column in columns.clone() {
            let inside = (0..3).all(|i| at[i] + edges[i].bias >= 0);
            if inside {
                let value: f64 = (0..3).map(|i| at[i] as f64 * per_area[i]).sum();
                visit(row * width + column, value.clamp(low, high) as f32);
            }
            for i in 0..3 {
                at[i] += edges[i].column_step;
            }
        }
        for i in 0..3 {
            row_starts[i] += edges[i].row_step;
        }
    }
}

struct Edge {
    from: [i64; 2],
    column_step: i64,
    row_step: i64,
    /// 0 where a centre on the edge is inside, −1 where it is outside.
    bias: i64,
}

impl Edge {
    fn new(from: [i64; 2], to: [i64; 2]) -> Self {
        let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
        // Rows run downwards, so with positive area a left edge rises and a top edge runs to the
        // right.
        let top_or_left = dy < 0 || (dy == 0 && dx > 0);
        Self {
            from,
            column_step: -dy * STEPS,
            row_step: dx * STEPS,
            bias: if top_or_left { 0 } else { -1 },
        }
    }

    fn at(&self, point: [i64; 2]) -> i64 {
        let [dx, dy] = [self.row_step / STEPS, -self.column_step / STEPS];
        dx * (point[1] - self.from[1]) - dy * (point[0] - self.from[0])
    }
}

/// Twice the signed area of the triangle a b c.
fn edge(a: [i64; 2], b: [i64; 2], c: [i64; 2]) -> i64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

fn centre(pixel: usize) -> i64 {
    pixel as i64 * STEPS + STEPS / 2
}

/// The rows of a picture of this height whose centres a triangle may cover.
pub(crate) fn rows_of(corners: impl Iterator<Item = Corner>, height: usize) -> Range<usize> {
    let (low, high) = corners.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), c| {
        (low.min(c[1]), high.max(c[1]))
    });
    // A cast from float saturates; the grid may move a corner by less than a row.
    let end = (high.max(0.0) as usize).saturating_add(1).min(height);
    (low.max(0.0) as usize).saturating_sub(1).min(end)..end
}

/// The pixels within a picture of `size` whose centres lie between the least and the greatest
/// coordinate.
fn pixel_range(coordinates: [i64; 3], size: usize) -> Range<usize> {
    let least = coordinates[0].min(coordinates[1]).min(coordinates[2]);
    let greatest = coordinates[0].max(coordinates[1]).max(coordinates[2]);
    let clamp = |pixel: i64| pixel.clamp(0, size as i64) as usize;
    let start = (least + STEPS / 2 - 1).div_euclid(STEPS);
    let end = (greatest - STEPS / 2).div_euclid(STEPS) + 1;
    clamp(start)..clamp(end)
}

fn bounds(values: [f64; 3]) -> (f64, f64) {
    let [a, b, c] = values;
    (a.min(b).min(c), a.max(b).max(c))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const SIZE: usize = 24;

    fn corner() -> impl Strategy<Value = Corner> {
        // Quarter pixels, so that many centres fall exactly on edges and corners.
        [-20i32..116, -20i32..116].prop_map(|[x, y]| {
            let (x, y) = (f64::from(x) / 4.0, f64::from(y) / 4.0);
            [x, y, 0.25 * x - 0.5 * y + 3.0]
        })
    }

    fn count(triangles: &[[Corner; 3]]) -> Vec<u32> {
        let mut counts = vec![0; SIZE * SIZE];
        for triangle in triangles {
            fill(SIZE, SIZE, *triangle, |pixel, _| counts[pixel] += 1);
        }
        counts
    }

    proptest! {
        /// A fan of triangles around a point covers every centre inside its convex outline exactly
        /// once.
        #[test]
        fn a_fan_over_the_picture_draws_every_pixel_once(x in 1i32..95, y in 1i32..95) {
            let middle = [f64::from(x) / 4.0, f64::from(y) / 4.0, 0.0];
            let size = SIZE as f64;
            let ring = [[0.0, 0.0, 0.0], [size, 0.0, 0.0], [size, size, 0.0], [0.0, size, 0.0]];
            let fan: Vec<_> = (0..4).map(|i| [middle, ring[i], ring[(i + 1) % 4]]).collect();
            prop_assert!(count(&fan).iter().all(|&n| n == 1));
        }

        /// Two triangles on opposite sides of a shared edge never both draw a pixel.
        #[test]
        fn a_shared_edge_is_drawn_once(a in corner(), b in corner(), c in corner(), d in corner()) {
            let side = |p: Corner| (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
            prop_assume!(side(c) * side(d) < 0.0);
            prop_assert!(count(&[[a, b, c], [a, b, d]]).iter().all(|&n| n <= 1));
        }

        /// Centres strictly inside are drawn, strictly outside are not, whatever the orientation;
        /// and the value is the affine function that the corners were taken from.
        #[test]
        fn coverage_and_values_agree_with_barycentric_coordinates(a in corner(), b in corner(), c in corner()) {
            let cross = |p: Corner, q: Corner, r: [f64; 2]| {
                (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
            };
            let area = cross(a, b, [c[0], c[1]]);
            let mut value = vec![None; SIZE * SIZE];
            fill(SIZE, SIZE, [a, b, c], |pixel, v| value[pixel] = Some(v));
            for row in 0..SIZE {
                for column in 0..SIZE {
                    let p = [column as f64 + 0.5, row as f64 + 0.5];
                    let weights = [cross(b, c, p) / area, cross(c, a, p) / area, cross(a, b, p) / area];
                    let drawn = value[row * SIZE + column];
                    if area != 0.0 && weights.iter().all(|&w| w > 0.0) {
                        prop_assert!(drawn.is_some());
                    }
                    if area == 0.0 || weights.iter().any(|&w| w < 0.0) {
                        prop_assert!(drawn.is_none());
                    }
                    if let Some(v) = drawn {
                        let expected = 0.25 * p[0] - 0.5 * p[1] + 3.0;
                        prop_assert!((f64::from(v) - expected).abs() < 1e-5 * (1.0 + expected.abs()));
                    }
                }
            }
        }
    }
}
