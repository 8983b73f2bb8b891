//! The paper's description constant of an animated picture.

/// Why there is no description constant.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DescriptionError {
    /// The conversion description ratio h is not finite.
    #[error("the conversion description ratio h = {0} is not finite")]
    Ratio(f64),
    /// A ratio hᵢ of a time is not finite.
    #[error("the ratio h{time} = {ratio} is not finite")]
    Term {
        /// Its number i, from 1.
        time: usize,
        /// The ratio.
        ratio: f64,
    },
    /// The controllable frame value ϖ is not finite.
    #[error("the controllable frame value ϖ = {0} is not finite")]
    FrameValue(f64),
    /// The sum is beyond the range of the numbers.
    #[error("H is beyond the range of double precision for {terms} terms and ϖ = {frame_value}")]
    OutOfRange {
        /// m.
        terms: usize,
        /// ϖ.
        frame_value: f64,
    },
}

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
/// # Ok::<(), ga_vision::capture::DescriptionError>(())
/// ```
///
/// # Errors
/// [`DescriptionError`] where a number or the result is not finite.
pub fn description_constant(
    ratio: f64,
    times: &[f64],
    frame_value: f64,
) -> Result<f64, DescriptionError> {
    if !ratio.is_finite() {
        return Err(DescriptionError::Ratio(ratio));
    }
    if let Some(index) = times.iter().position(|ratio| !ratio.is_finite()) {
        return Err(DescriptionError::Term {
            time: index + 1,
            ratio: times[index],
        });
    }
    if !frame_value.is_finite() {
        return Err(DescriptionError::FrameValue(frame_value));
    }
    let terms = times.len();
    // Horner's rule; the sum begins with the first power.
    let backwards = times.iter().rev();
    let sum = backwards.fold(0.0, |sum, ratio| (sum + ratio) * frame_value);
    let result = (1.0 - terms as f64) * ratio + sum;
    if result.is_finite() {
        Ok(result)
    } else {
        Err(DescriptionError::OutOfRange { terms, frame_value })
    }
}
