//! The noise of observations of which a threshold has kept the smaller errors.

/// What Gaussian errors were, of which only those within a threshold are left.
///
/// An error has D components, each with the variance σ², and is kept where its square is below
/// that of the threshold t. With `x = t²/2σ²` the mean square of a component of those that are kept
/// is `q σ²`, where
///
/// ```text
/// q = 1 − 1/M(x),   M(x) = 1 + x/(a + 1) + x²/((a + 1)(a + 2)) + …,   a = D/2
/// ```
///
/// An estimate from them also varies more than their mean square shows, because an error that grows
/// is left out instead of pulling back: its covariance is that of least squares divided by q²
/// (P. J. Huber, "Robust Statistics", 1981, section 6.3, for the least squares of what is kept).
///
/// ```
/// use ga_numerics::ransac::SelectedNoise;
///
/// // A threshold of two standard deviations: kept errors have 0.774 of the variance.
/// let noise = SelectedNoise::new(0.774, 2.0, 1).unwrap();
/// assert!((noise.variance - 1.0).abs() < 1e-3);
/// assert!((noise.factor - 0.774_f64.powi(-2)).abs() < 1e-2);
/// // Errors that are spread evenly up to the threshold do not show how large they were.
/// assert!(SelectedNoise::new(4.0 / 3.0, 2.0, 1).is_none());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SelectedNoise {
    /// The variance σ² of a component before the selection.
    pub variance: f64,
    /// By how much the covariance of an estimate is greater than that of least squares with the
    /// mean square of what is kept.
    pub factor: f64,
}

impl SelectedNoise {
    /// The noise of errors of `components` components, from the mean square of a component of those
    /// that are below a threshold. `None` where the threshold is below about a standard deviation,
    /// so that what is left does not show it.
    #[must_use]
    pub fn new(mean_square: f64, threshold: f64, components: usize) -> Option<Self> {
        /// The least x = t²/2σ².
        const LEAST: f64 = 0.5;
        /// Beyond this x nothing is left out.
        const GREATEST: f64 = 64.0;
        let part = |x: f64| 1.0 - 1.0 / series(x, 0.5 * components as f64);
        // It falls with x.
        let quotient = |x: f64| part(x) / (2.0 * x);
        let wanted = mean_square / (threshold * threshold);
        if wanted.is_nan() || wanted > quotient(LEAST) {
            return None;
        }
        if wanted <= quotient(GREATEST) {
            return Some(Self {
                variance: mean_square,
                factor: 1.0,
            });
        }
        let [mut low, mut high] = [LEAST, GREATEST];
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            match quotient(middle) > wanted {
                true => low = middle,
                false => high = middle,
            }
        }
        let part = part(low);
        Some(Self {
            variance: mean_square / part,
            factor: (part * part).recip(),
        })
    }
}

/// `1 + x/(a + 1) + x²/((a + 1)(a + 2)) + …`.
fn series(x: f64, a: f64) -> f64 {
    let (mut sum, mut term, mut n) = (1.0, 1.0, 1.0);
    while term > f64::EPSILON * sum {
        term *= x / (a + n);
        sum += term;
        n += 1.0;
    }
    sum
}
