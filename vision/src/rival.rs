//! Explanations of the same observations that these do not tell apart.

/// Whether observations do not tell an explanation from the one that is best, from the squared
/// errors that both leave, observation by observation; `variance` is that of one of the
/// `components` of an error of the best explanation, and sums over errors vary by `correlation`
/// times as much as if these were independent.
///
/// The difference of the sums of squares is compared with its own standard deviation, which the
/// differences of the single squares show (Q. H. Vuong, "Likelihood ratio tests for model selection
/// and non-nested hypotheses", Econometrica 57, 1989). Noise alone does not make these vary by more
/// than `4 · components · variance²`: what goes beyond speaks against the explanation. A difference
/// of less than nine variances, a ratio of the likelihoods below e^4.5, never decides.
pub(crate) fn is_rival(
    [best, other]: [&[f64]; 2],
    variance: f64,
    components: usize,
    correlation: f64,
) -> bool {
    /// The standard deviations within which explanations are equal.
    const DEVIATIONS: f64 = 3.0;
    /// The variances within which they are.
    const VARIANCES: f64 = 9.0;
    /// The square of what rounding may do to an error, in pixels.
    const ROUNDING: f64 = 1e-14;
    let count = best.len() as f64;
    let (mut sum, mut squares) = (0.0, 0.0);
    for (best, other) in best.iter().zip(other) {
        let difference = other - best;
        sum += difference;
        squares += difference * difference;
    }
    let noise = 4.0 * components as f64 * variance * variance;
    let spread = (squares / count - (sum / count).powi(2)).clamp(0.0, noise);
    let equal = DEVIATIONS * (count * spread * correlation).sqrt();
    let equal = equal.max(VARIANCES * variance * correlation);
    sum <= equal + count * ROUNDING
}

/// Whether the angles between two explanations, in radians, are within the standard deviations of
/// one of them, where these are known: both are the same.
pub(crate) fn is_same(angles: impl IntoIterator<Item = (f64, Option<f64>)>) -> bool {
    /// How many standard deviations are within.
    const DEVIATIONS: f64 = 3.0;
    /// An angle that may be rounding.
    const ROUNDING: f64 = 1e-6;
    /// A deviation where none is known.
    const UNKNOWN: f64 = 1e-3;
    let mut angles = angles.into_iter();
    angles.all(|(angle, deviation)| angle <= DEVIATIONS * deviation.unwrap_or(UNKNOWN) + ROUNDING)
}
