//! The skin of the body as a mesh: marched over the left half, made even, and completed by its
//! mirror image.

mod marching_tetrahedra;
mod remesh;
mod topology;

use crate::landmarks::{Landmarks, WRIST};
use crate::shape::Body;
use crate::{Vector, mirror};
use ga_runtime::scalar::smooth_step;
pub(crate) use marching_tetrahedra::Surface;
use marching_tetrahedra::{Grid, march};
use remesh::remesh;

/// The grid must be finer than the gaps between the fingers.
const SPACING: f64 = 0.007;
/// How much faster than one metre a metre the body's distance may change, away from the skin.
const STRETCH: f64 = 1.5;
/// Rounds of remeshing; more do not change the triangles visibly.
const ROUNDS: usize = 5;

/// The length of edges in metres on the large surfaces, and on what has details.
const COARSE: f64 = 0.0170;
const HAND: f64 = 0.0068;
const FACE: f64 = 0.0044;
/// What is farther from the middle of the face than the first of these has longer edges, up to the
/// second.
const FACE_REACH: [f64; 2] = [0.050, 0.120];
const HEAD: f64 = 0.0090;
const FOOT: f64 = 0.010;

/// A closed surface, symmetric about x = 0 vertex by vertex: the left half, then the mirror images
/// of its vertices off the middle, in the same order.
pub(crate) fn surface(body: &Body, landmarks: &Landmarks) -> Surface {
    let [low, high] = body.left_bounds();
    let cubes = std::array::from_fn(|k| ((high[k] - low[k]) / SPACING).ceil() as usize);
    let grid = Grid {
        origin: low,
        spacing: SPACING,
        cubes,
    };
    let rough = march(grid, STRETCH, |point, limit| body.distance(point, limit));
    let length = |point| edge_length(landmarks, point);
    // No vertex leaves the skin by as much as the length of an edge.
    mirrored(remesh(rough, ROUNDS, length, |point| {
        body.distance(point, COARSE)
    }))
}

/// How long the edges should be at a point of the skin.
fn edge_length(landmarks: &Landmarks, point: Vector) -> f64 {
    let between = |fine: f64, [from, to]: [f64; 2], distance: f64| {
        fine + (COARSE - fine) * smooth_step(from, to, distance)
    };
    let past_wrist = (point - landmarks.arm.origin).dot(landmarks.arm.along) - WRIST;
    let hand = between(HAND, [-0.06, 0.03], -past_wrist);
    let face = between(
        FACE,
        FACE_REACH,
        point.distance(Vector::new(0.0, 1.61, 0.11)),
    );
    let head = between(
        HEAD,
        [0.11, 0.18],
        point.distance(Vector::new(0.0, 1.635, 0.01)),
    );
    let foot = between(FOOT, [0.04, 0.14], point.e2);
    hand.min(face).min(head).min(foot)
}

/// A surface cut off at x = 0 together with its mirror image.
fn mirrored(half: Surface) -> Surface {
    let Surface {
        mut positions,
        mut triangles,
    } = half;
    let count = positions.len();
    let mut image = Vec::with_capacity(count);
    for vertex in 0..count {
        if positions[vertex].e1 == 0.0 {
            image.push(vertex as u32);
        } else {
            image.push(positions.len() as u32);
            positions.push(mirror(positions[vertex]));
        }
    }
    for i in 0..triangles.len() {
        let [a, b, c] = triangles[i].map(|vertex| image[vertex as usize]);
        triangles.push([a, c, b]);
    }
    Surface {
        positions,
        triangles,
    }
}
