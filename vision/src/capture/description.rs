//! The paper's description constant of an animated picture.

use crate::capture::CaptureError;

/// The description constant of an animated picture (Cui, eq. 1),
///
/// ```text
/// H = (1 − m) h + Σ hᵢ ϖⁱ    i = 1 … m
/// ```
///
/// with the conversion description ratio h, the ratios h₁ … hₘ of the m times of description and
/// the controllable frame value ϖ; m is the length of `times`. The paper prints `hi` for hᵢ. H is a
/// heuristic of the paper in units of h, and nothing else here depends on it.
///
/// ```
/// use ga_vision::capture::description_constant;
///
/// // m = 2: −1 · 3 + 0.5 · 2 + 0.25 · 2² = −1.
/// assert_eq!(description_constant(3.0, &[0.5, 0.25], 2.0)?, -1.0);
/// # Ok::<(), ga_vision::capture::CaptureError>(())
/// ```
///
/// # Errors
/// [`CaptureError`] where a number or the result is not finite.
pub fn description_constant(
    ratio: f64,
    times: &[f64],
    frame_value: f64,
) -> Result<f64, CaptureError> {
    if !ratio.is_finite() {
        return Err(CaptureError::Ratio(ratio));
    }
    if let Some(index) = times.iter().position(|ratio| !ratio.is_finite()) {
        return Err(CaptureError::Term {
            time: index + 1,
            ratio: times[index],
        });
    }
    if !frame_value.is_finite() {
        return Err(CaptureError::FrameValue(frame_value));
    }
    let terms = times.len();
    // Horner's rule; the sum begins with the first power.
    let backwards = times.iter().rev();
    let sum = backwards.fold(0.0, |sum, ratio| (sum + ratio) * frame_value);
    let result = (1.0 - terms as f64) * ratio + sum;
    if result.is_finite() {
        Ok(result)
    } else {
        Err(CaptureError::DescriptionOutOfRange { terms, frame_value })
    }
}
