//! By how much the parallax of a video should be shifted.

use super::{Dimension, Scale, Viewing};

/// The part of the limits of comfort that is aimed at, so that points stay within them when they
/// are measured again.
const AIM: f64 = 0.95;

/// The shift of parallax, in per cent of the picture's width, after which points from the nearest
/// to the farthest, as parallax in the same unit, are comfortable: the smallest one, and 0 where
/// they are already. Where they are too far apart for that, it goes as far as the other end allows.
///
/// ```
/// use ga_video::comfort::{Viewing, comfortable_shift};
///
/// // A degree is 2.9 % of the width.
/// let viewing = Viewing::default();
/// assert_eq!(comfortable_shift([-2.0, 2.0], &viewing), 0.0);
/// assert!((comfortable_shift([-1.0, 4.0], &viewing) + 1.2).abs() < 0.1);
/// assert!((comfortable_shift([-4.0, 1.0], &viewing) - 1.2).abs() < 0.1);
/// // Nothing in front may come nearer than the limit.
/// assert!((comfortable_shift([-2.5, 6.0], &viewing) + 0.3).abs() < 0.1);
/// ```
#[must_use]
pub fn comfortable_shift([nearest, farthest]: [f64; 2], viewing: &Viewing) -> f64 {
    let limit = |dimension, sign: f64| {
        let scale = Scale::of(dimension, viewing);
        scale.map_or(0.0, |scale| {
            viewing.parallax_of_degrees(sign * AIM * scale.comfortable())
        })
    };
    let in_front = limit(Dimension::OverConvergence, -1.0) - nearest;
    let behind = farthest - limit(Dimension::OverDivergence, 1.0);
    match (in_front > 0.0, behind > 0.0) {
        (true, false) => in_front.min(-behind),
        (false, true) => -behind.min(-in_front),
        _ => 0.0,
    }
}
