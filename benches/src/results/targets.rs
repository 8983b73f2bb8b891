//! The ratios that are the targets of this project.

/// A ratio counts as reached up to this part above it, since two runs of the same code differ by as
/// much.
pub(super) const TOLERANCE: f64 = 0.05;

/// The largest ratio that one of our contenders should have to a rival, if there is a target.
pub(super) fn target(flags: &str, group: &str, ours: &str, rival: &str) -> Option<f64> {
    let is_native = flags.contains("target-cpu=native");
    match (group, ours, rival) {
        ("sandwich/motor-point-f32", "nullcone", "glam Mat4") => Some(1.0),
        ("sandwich/motor-point-f64", "nullcone", "glam DMat4") => Some(1.0),
        ("product/motor-motor-f32", "nullcone", "glam Affine3A") => Some(0.9),
        ("batch/one-motor-points-f32", "nullcone dispatched", "glam Affine3A") => {
            Some(if is_native { 0.6 } else { 1.0 })
        }
        ("scene/ray-trace", "methods, as a textbook", "glam DVec3") => Some(1.5),
        ("scene/ray-trace", "ga!, as a textbook", "glam DVec3") => Some(1.1),
        ("geometry/motion from 1000 pairs of points", "nullcone", _) => Some(1.2),
        (sandwich, "nullcone", "clifford") => sandwich.starts_with("sandwich/").then_some(0.1),
        _ => None,
    }
}
