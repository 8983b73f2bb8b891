//! Quadrangles: dark regions with four straight edges.

use ga_image::filter::Border;
use ga_image::plane::Plane;
use ga_image::threshold::adaptive;

use super::edge::distance;
use crate::contour::{Contour, borders, signed_area};

/// Pixels are dark that are darker by this number of levels than the mean around them.
const DARKER: i16 = 7;
/// The reach of that mean to either side, in pixels; each is used in turn. The edges of a border
/// that is wider than the reach are still dark, and it is a ring.
const REACHES: [u16; 4] = [4, 12, 32, 80];
/// The least side of a quadrangle in pixels.
const LEAST_SIDE: f64 = 10.0;
/// The border is that of the bright pixels around, which lie half a pixel beyond the edge; where
/// these have grown, half a pixel within. At corners that is so far.
const INSIDE: f64 = 0.7;
/// The greatest distance of its border from its edges: this part of the shortest edge, and pixels.
const STRAIGHT: (f64, f64) = (0.1, 2.0);

/// The corners of dark quadrangles, clockwise as seen, about as accurate as pixels. The same
/// quadrangle may be found several times.
pub(super) fn quads(levels: &Plane<f32>) -> Vec<[[f64; 2]; 4]> {
    let bytes = levels.map(|level| (level + 0.5) as u8);
    let side = levels.width().max(levels.height());
    let reaches = REACHES
        .into_iter()
        .filter(|reach| usize::from(*reach) < side);
    reaches
        .flat_map(|reach| {
            // Regions that are not dark connect to eight neighbours, so that dark ones, which are
            // holes in them, do to four: tags that touch at corners are divided.
            let bright = adaptive(&bytes, reach, DARKER, Border::Mirror);
            let of = |bright: &Plane<u8>, outwards: f64| {
                let holes = borders(bright).into_iter().filter(|border| border.is_hole);
                holes
                    .filter_map(|hole| quad(&hole, outwards))
                    .collect::<Vec<_>>()
            };
            // Blur joins tags where they touch; they fall apart where dark regions are thinner.
            [of(&bright, -INSIDE), of(&grown(&bright), INSIDE)].concat()
        })
        .collect()
}

/// The bright pixels and their eight neighbours.
fn grown(bright: &Plane<u8>) -> Plane<u8> {
    let [right, bottom] = [bright.width(), bright.height()].map(|side| side.saturating_sub(1));
    Plane::from_fn(bright.width(), bright.height(), |column, row| {
        let columns = column.saturating_sub(1)..=(column + 1).min(right);
        let mut rows = row.saturating_sub(1)..=(row + 1).min(bottom);
        let is_near = rows.any(|row| bright.row(row)[columns.clone()].iter().any(|v| *v != 0));
        if is_near { u8::MAX } else { 0 }
    })
}

/// The quadrangle that a border is, where it is one, with its corners moved outwards.
fn quad(border: &Contour, outwards: f64) -> Option<[[f64; 2]; 4]> {
    let points = border.points();
    if (points.len() as f64) < 3.0 * LEAST_SIDE {
        return None;
    }
    let mut vertices = vertices(&points);
    vertices.sort_unstable();
    let corners: [usize; 4] = vertices.try_into().ok()?;
    let edges = [0, 1, 2, 3].map(|k| (corners[k], corners[(k + 1) % 4]));
    let lengths = edges.map(|(a, b)| distance(points[a], points[b]));
    let shortest = lengths.into_iter().fold(f64::INFINITY, f64::min);
    let tolerance = STRAIGHT.1.max(STRAIGHT.0 * shortest);
    let is_straight = |(from, to): (usize, usize)| {
        between(points.len(), from, to)
            .all(|k| from_line(points[from], points[to], points[k]).abs() <= tolerance)
    };
    if shortest < LEAST_SIDE || !edges.into_iter().all(is_straight) {
        return None;
    }
    let mut quad = corners.map(|corner| points[corner]);
    let centre = [0, 1].map(|k| quad.iter().map(|corner| corner[k]).sum::<f64>() / 4.0);
    for corner in &mut quad {
        let away = distance(*corner, centre);
        *corner = [0, 1].map(|k| corner[k] + (corner[k] - centre[k]) * outwards / away);
    }
    if signed_area(&quad) < 0.0 {
        quad.reverse();
    }
    is_convex(&quad).then_some(quad)
}

/// Four points of a closed border: two that are far apart, and twice the one that is farthest from
/// the polygon of those before (U. Ramer, 1972; D. Douglas and T. Peucker, 1973).
fn vertices(points: &[[f64; 2]]) -> Vec<usize> {
    let count = points.len() as f64;
    let centre = [0, 1].map(|k| points.iter().map(|point| point[k]).sum::<f64>() / count);
    let farthest = |from: [f64; 2]| {
        let distances = points.iter().map(|point| distance(*point, from));
        let order = distances.enumerate().max_by(|a, b| a.1.total_cmp(&b.1));
        order.map_or(0, |(index, _)| index)
    };
    let first = farthest(centre);
    let mut vertices = vec![first, farthest(points[first])];
    for _ in 0..2 {
        vertices.sort_unstable();
        let edges = (0..vertices.len()).map(|k| (vertices[k], vertices[(k + 1) % vertices.len()]));
        let candidates = edges.flat_map(|(from, to)| {
            between(points.len(), from, to)
                .map(move |k| (k, from_line(points[from], points[to], points[k]).abs()))
        });
        if let Some((next, _)) = candidates.max_by(|a, b| a.1.total_cmp(&b.1)) {
            vertices.push(next);
        }
    }
    vertices
}

/// The indices between two of a closed chain.
fn between(count: usize, from: usize, to: usize) -> impl Iterator<Item = usize> {
    let length = (to + count - from) % count;
    (1..length.max(1)).map(move |step| (from + step) % count)
}

/// The signed distance of a point from a line; from its first point, where it has one only.
fn from_line(a: [f64; 2], b: [f64; 2], point: [f64; 2]) -> f64 {
    let length = distance(a, b);
    match length > 0.0 {
        true => 2.0 * signed_area(&[a, b, point]) / length,
        false => distance(a, point),
    }
}

/// Whether each corner, clockwise, turns to the right by 15° to 165°.
fn is_convex(quad: &[[f64; 2]; 4]) -> bool {
    const LEAST_SINE: f64 = 0.26;
    (0..4).all(|k| {
        let [before, here, after] = [k + 3, k, k + 1].map(|k| quad[k % 4]);
        let sides = distance(before, here) * distance(here, after);
        2.0 * signed_area(&[before, here, after]) > LEAST_SINE * sides
    })
}
