//! How well a motion explains pairs of points that are in front of both cameras.

use ga_runtime::cga3::{Direction, Motor};
use ga_runtime::vga3::Vector;

use super::sampson::BearingPair;

/// What a motion makes of a pair.
#[derive(Clone, Copy, Debug)]
pub(super) struct Explained {
    /// The squared distance, in square pixels, from the nearest pixels that are the images of a
    /// point in front of both cameras.
    pub(super) squared_distance: f64,
    /// Whether the rays meet in front of both cameras.
    pub(super) is_in_front: bool,
}

/// What a motion makes of a pair. Where the rays come closest behind a camera, the nearest point
/// that both cameras may see is at infinity.
pub(super) fn explained(pair: &BearingPair, left_to_right: Motor<f64>) -> Explained {
    let d = Direction::from_vector(pair.left.direction.coordinates());
    let first = Vector::from(left_to_right.transform(d));
    let second = pair.right.direction;
    let translation = Vector::from(left_to_right.translator().displacement());
    let normal = first.cross(second);
    // The depths s and s' along both directions, up to a positive factor, for which
    // `s R d + t − s' d'` is perpendicular to both rays.
    let depths = [second, first].map(|ray| ray.cross(translation).dot(normal));
    let is_in_front = depths.into_iter().all(|depth| depth > 0.0);
    let epipolar = pair.sampson_distance(left_to_right).powi(2);
    Explained {
        squared_distance: match is_in_front {
            true => epipolar,
            false => epipolar.max(pair.right.half_squared_distance(first)),
        },
        is_in_front,
    }
}
