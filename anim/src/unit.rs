//! The length of a unit of a recording that does not state it.
//!
//! BVH has no unit: recordings are in metres, in centimetres, in inches, and in the unit of CMU's
//! motion capture, 0.0254/0.45 m. What a unit is long follows from the size of the body, which is
//! read off the lengths of its bones: they are the same in every pose, so that a body may lie,
//! stand or be folded at rest.

use crate::recording::Recording;

/// The units that recordings have, in metres: a metre, a decimetre, CMU's, an inch, a centimetre
/// and a millimetre.
pub const UNITS: [f64; 6] = [1.0, 0.1, 0.0254 / 0.45, 0.0254, 0.01, 0.001];

/// The longest way along the bones of an adult, in metres: mostly from a wrist over shoulders,
/// spine and hip to the toes.
const ADULT: f64 = 2.05;
/// A body that is larger or smaller than an adult by more than this factor leaves its unit unclear.
const CLEAR: f64 = 1.3;

/// What a unit is likely to be long.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LikelyUnit {
    /// Its length in metres: that of [`UNITS`] with which the body is most like an adult, or where
    /// it is not like one with any of them, the length with which it is as large as an adult.
    pub metres: f64,
    /// Whether it is one of [`UNITS`].
    pub is_clear: bool,
}

/// The likely unit of a recording whose lengths are in that unit; `None` for a body without bones.
///
/// ```
/// use ga_anim::bvh;
/// use ga_anim::recording::Recording;
/// use ga_anim::unit::likely_unit;
///
/// // A body in centimetres that is recorded lying.
/// let text = b"HIERARCHY
/// ROOT Hips
/// {
///   OFFSET 0 0 0
///   CHANNELS 3 Zrotation Xrotation Yrotation
///   JOINT Neck
///   {
///     OFFSET 55 0 0
///     CHANNELS 3 Zrotation Xrotation Yrotation
///     JOINT Wrist
///     {
///       OFFSET 65 0 0
///       CHANNELS 3 Zrotation Xrotation Yrotation
///     }
///   }
///   JOINT Foot
///   {
///     OFFSET -90 0 0
///     CHANNELS 3 Zrotation Xrotation Yrotation
///   }
/// }
/// MOTION
/// Frames: 1
/// Frame Time: 0.04
/// 0 0 0 0 0 0 0 0 0 0 0 0
/// ";
/// let unit = likely_unit(&Recording::from_bvh(&bvh::decode(text)?, 1.0)?).ok_or("no bones")?;
/// assert_eq!((unit.metres, unit.is_clear), (0.01, true));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn likely_unit(recording: &Recording) -> Option<LikelyUnit> {
    of_size(longest_way(recording))
}

/// The likely unit of a body whose longest way along its bones has this length.
fn of_size(size: f64) -> Option<LikelyUnit> {
    if size.is_nan() || size <= 0.0 || size.is_infinite() {
        return None;
    }
    let misses = |unit: f64| (size * unit / ADULT).ln().abs();
    let nearest = UNITS
        .into_iter()
        .min_by(|a, b| misses(*a).total_cmp(&misses(*b)));
    let clear = nearest.filter(|unit| misses(*unit) <= CLEAR.ln());
    Some(LikelyUnit {
        metres: clear.unwrap_or(ADULT / size),
        is_clear: clear.is_some(),
    })
}

/// The longest way along bones between two joints.
fn longest_way(recording: &Recording) -> f64 {
    let joints = recording.joints();
    let mut below = vec![0.0_f64; joints.len()];
    let mut longest = 0.0_f64;
    // Parents come first, so that all below a joint is known when it is reached.
    for (index, joint) in joints.iter().enumerate().rev() {
        let Some(parent) = joint.parent else { continue };
        let way = below[index] + joint.rest.translation().length();
        longest = longest.max(below[parent] + way);
        below[parent] = below[parent].max(way);
    }
    longest
}

#[cfg(test)]
mod tests {
    use super::of_size;

    #[test]
    fn a_body_of_no_size_has_no_unit() {
        for size in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(of_size(size), None);
        }
    }

    #[test]
    fn a_body_unlike_an_adult_is_scaled_to_one_and_unclear() {
        let giant = of_size(5.0e5).unwrap();
        assert!(!giant.is_clear && (giant.metres * 5.0e5 - 2.05).abs() < 1e-12);
    }
}
