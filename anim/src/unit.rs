//! The length of a unit of a motion that does not state it.
//!
//! BVH has no unit: recordings are in metres, in centimetres, in inches, and in the unit of CMU's
//! motion capture, 0.0254/0.45 m. What a unit is long follows from the length of the legs, which is
//! read off the body in motion: it does not depend on the pose in which rotations are zero, so that
//! a body may lie, stand or be folded there.

use crate::retarget::Source;
use crate::retarget::body::Body;

/// The units that motions have, in metres: a metre, CMU's, an inch, a centimetre and a millimetre.
pub const UNITS: [f64; 5] = [1.0, 0.0254 / 0.45, 0.0254, 0.01, 0.001];

/// Thigh and shin of an adult together, in metres.
const LEG: f64 = 0.82;
/// A leg that is longer or shorter than an adult's by more than this factor leaves the unit
/// unclear: half-way to the next unit is a factor of 1.5.
const CLEAR: f64 = 1.3;

/// What a unit is likely to be long.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LikelyUnit {
    /// Its length in metres: the one of [`UNITS`] with which thigh and shin are most like an
    /// adult's, or 1 where no legs are known.
    pub metres: f64,
    /// Thigh and shin together in metres with this unit; `None` where no legs are known.
    pub leg_metres: Option<f64>,
}

impl LikelyUnit {
    /// Whether thigh and shin are as long as a person's with this unit.
    #[must_use]
    pub fn is_clear(&self) -> bool {
        let is_near = |leg: f64| (leg / LEG).ln().abs() <= CLEAR.ln();
        self.leg_metres.is_some_and(is_near)
    }

    /// What is not clear, as a sentence; `None` where all is.
    #[must_use]
    pub fn doubt(&self) -> Option<String> {
        let metres = self.metres;
        match self.leg_metres {
            _ if self.is_clear() => None,
            None => Some(format!(
                "the length of a unit is not clear, since no legs of a body are known: {metres} m \
                 is taken"
            )),
            Some(leg) => Some(format!(
                "the length of a unit is not clear: {metres:.6} m is taken, with which thigh and \
                 shin are {leg:.2} m long, beside {LEG} m of an adult"
            )),
        }
    }
}

/// The likely unit of a motion whose lengths are in that unit.
///
/// ```
/// use ga_anim::bvh;
/// use ga_anim::unit::likely_unit;
///
/// // A body in centimetres that lies in the pose in which rotations are zero.
/// let leg = |side: &str, z: f64| {
///     format!(
///         "JOINT {side}UpLeg {{ OFFSET 0 0 {z} CHANNELS 3 Zrotation Xrotation Yrotation
///          JOINT {side}Leg {{ OFFSET 42 0 0 CHANNELS 3 Zrotation Xrotation Yrotation
///          JOINT {side}Foot {{ OFFSET 40 0 0 CHANNELS 3 Zrotation Xrotation Yrotation }} }} }}"
///     )
/// };
/// let text = format!(
///     "HIERARCHY ROOT Hips {{ OFFSET 0 0 0 CHANNELS 3 Zrotation Xrotation Yrotation {} {} }}
///      MOTION Frames: 1 Frame Time: 0.04
///      {}",
///     leg("Left", 9.0),
///     leg("Right", -9.0),
///     "0 ".repeat(21)
/// );
/// let unit = likely_unit(&bvh::decode(text.as_bytes())?);
/// assert_eq!((unit.metres, unit.is_clear()), (0.01, true));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn likely_unit(motion: &dyn Source) -> LikelyUnit {
    let length = Body::of(motion).and_then(|body| body.leg_length(motion));
    of_leg(length)
}

/// The likely unit where thigh and shin together have this length.
fn of_leg(length: Option<f64>) -> LikelyUnit {
    let unknown = LikelyUnit {
        metres: 1.0,
        leg_metres: None,
    };
    length.map_or(unknown, |length| {
        let misses = |unit: f64| (length * unit / LEG).ln().abs();
        let nearest = UNITS
            .into_iter()
            .min_by(|a, b| misses(*a).total_cmp(&misses(*b)));
        let metres = nearest.unwrap_or(1.0);
        LikelyUnit {
            metres,
            leg_metres: Some(length * metres),
        }
    })
}

#[cfg(test)]
mod tests {
    use super::{UNITS, of_leg};

    #[test]
    fn legs_of_people_have_each_unit() {
        for unit in UNITS {
            for leg in [0.7, 0.77, 0.82, 0.87, 1.0] {
                let found = of_leg(Some(leg / unit));
                assert!(found.is_clear(), "{leg} {unit}");
                assert_eq!(found.metres, unit, "{leg}");
            }
        }
    }

    #[test]
    fn legs_unlike_an_adults_and_none_at_all_are_said() {
        let giant = of_leg(Some(1.5));
        assert_eq!(giant.metres, 1.0);
        assert!(giant.doubt().unwrap().contains("1.50 m long"));
        let none = of_leg(None);
        assert_eq!(none.metres, 1.0);
        assert!(none.doubt().unwrap().contains("no legs"));
    }
}
