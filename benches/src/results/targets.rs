//! The ratios that we hold ourselves to.

/// How far above a ratio still counts as reached: two runs of the same code differ by as much.
pub(super) const TOLERANCE: f64 = 0.05;

/// The ratio that one of ours is to keep against a rival, if one is set.
pub(super) fn target(flags: &str, group: &str, ours: &str, rival: &str) -> Option<f64> {
    let is_native = flags.contains("target-cpu=native");
    match (group, ours, rival) {
        ("sandwich/motor-point-f32", "nullcone", "glam Mat4") => Some(1.0),
        ("sandwich/motor-point-f64", "nullcone", "glam DMat4") => Some(1.0),
        ("product/motor-motor-f32", "nullcone", "glam Affine3A") => Some(0.9),
        ("batch/one-motor-points-f32", "nullcone dispatched", "glam Affine3A") => {
            Some(if is_native { 0.6 } else { 1.0 })
        }
        (sandwich, "nullcone", "clifford") => sandwich.starts_with("sandwich/").then_some(0.1),
        _ => None,
    }
}
