//! The rates of the films of a person.

use ga_video::Properties;

/// Rates differ where they do by more than this part.
const DIFFERENCE: f64 = 0.01;

/// Frames in a second, where the film states it.
pub(crate) fn stated_rate(film: &Properties) -> Option<f64> {
    let [numerator, denominator] = film.frames_per_second?;
    Some(f64::from(numerator) / f64::from(denominator))
}

/// Whether a rate is another one than that which holds.
pub(crate) fn is_other_rate(own: f64, rate: f64) -> bool {
    (own - rate).abs() > DIFFERENCE * rate
}
