//! The ratios that we hold ourselves to.

/// How far above a ratio still counts as reached: two runs of the same code differ by as much.
pub(super) const TOLERANCE: f64 = 0.05;

/// The ratio that a group is to keep against a rival, if one is set.
pub(super) fn target(group: &str, rival: &str) -> Option<f64> {
    let fixed = [
        ("sandwich/motor-point-f32", "glam Mat4", 1.0),
        ("sandwich/motor-point-f64", "glam DMat4", 1.0),
        ("product/motor-motor-f32", "glam Affine3A", 0.9),
        ("batch/one-motor-points-f32", "glam Affine3A", 0.6),
    ];
    let found = fixed
        .iter()
        .find(|(name, other, _)| *name == group && *other == rival);
    let sandwich = group.starts_with("sandwich/") && rival == "clifford";
    found.map(|(.., ratio)| *ratio).or(sandwich.then_some(0.1))
}
