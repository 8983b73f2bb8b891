//! The unknowns of a view: how its camera is moved, and when it begins.

use ga_camera::Camera;
use ga_runtime::cga3::{Direction, MotorGenerator};

/// A rotation, a displacement of the origin, both in the axes of the camera, and an offset.
pub(super) const SIZE: usize = 7;
pub(super) const OFFSET: usize = 6;
/// An offset is not determined that is known no better than to this many frames.
pub(super) const UNKNOWN: f64 = 10.0;

/// The unknowns of a view.
pub(super) type Motion = [f64; SIZE];

/// Cameras moved by twists of their own frames.
pub(super) fn all_moved(cameras: &[Camera], motions: &[Motion]) -> Vec<Camera> {
    let moved = cameras.iter().zip(motions);
    moved
        .map(|(camera, twist)| moved_by(camera, twist))
        .collect()
}

/// A camera moved by a twist of its own frame.
pub(super) fn moved_by(camera: &Camera, motion: &Motion) -> Camera {
    let [x, y, z, u, v, w, _] = *motion;
    let generator =
        MotorGenerator::from_velocities(Direction::new(x, y, z), Direction::new(u, v, w));
    Camera {
        world_to_camera: generator.exp() * camera.world_to_camera,
        ..*camera
    }
}

/// The same motion of the camera.
pub(super) fn without_offset(motion: Motion) -> Motion {
    let mut own = motion;
    own[OFFSET] = 0.0;
    own
}
