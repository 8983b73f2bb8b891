//! The noise of observations of which a threshold has kept the smaller errors.

use statrs::function::gamma::gamma_lr;

use crate::least_squares::region_factor;

/// What Gaussian errors were, of which only those within a threshold are left.
///
/// An error has D components, each with the variance σ², and is kept where its square is below
/// that of the threshold t. With `a = D/2`, `x = t²/2σ²` and the regularised incomplete gamma
/// function P, the mean square of a component of those that are kept is `q σ²`, where
///
/// ```text
/// q = P(a + 1, x) / P(a, x)
/// ```
///
/// An estimate from them also varies more than their mean square shows, because an error that grows
/// is left out instead of pulling back: its covariance is that of least squares divided by q²
/// (P. J. Huber, "Robust Statistics", 1981, section 6.3, for the least squares of what is kept).
/// The p unknowns of the estimate therefore take `p σ²` from the sum of squares of n components,
/// which is `(n − p/q) q σ²` in the mean.
///
/// ```
/// use ga_numerics::ransac::SelectedNoise;
///
/// // A threshold of two standard deviations: kept errors have 0.774 of the variance.
/// let noise = SelectedNoise::new(774.0, [1000, 0], 2.0, 1).unwrap();
/// assert!((noise.variance - 1.0).abs() < 1e-3);
/// assert!((noise.of_estimates - 0.774_f64.recip()).abs() < 1e-2);
/// // Without a threshold, it is the usual variance of residuals.
/// let all = SelectedNoise::new(90.0, [100, 10], f64::INFINITY, 1).unwrap();
/// assert!((all.of_estimates - 1.0).abs() < 1e-12 && (all.redundancy - 90.0).abs() < 1e-9);
/// // Errors that are spread evenly up to the threshold do not show how large they were.
/// assert!(SelectedNoise::new(1333.0, [1000, 0], 2.0, 1).is_none());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SelectedNoise {
    /// The variance σ² of a component before the selection.
    pub variance: f64,
    /// The variance with which an estimate has the covariance of least squares of what is kept:
    /// `σ²/q`.
    pub of_estimates: f64,
    /// How well that is known: the redundancy with which errors that nothing was left out of would
    /// show their variance as well.
    pub redundancy: f64,
}

impl SelectedNoise {
    /// The noise of errors of `components` components, from the sum of the squares of those that
    /// are below a threshold; from the numbers of the components of all these and of the unknowns
    /// that were fitted to them. `None` where the threshold is below about a standard deviation, so
    /// that what is left does not show it, and where as many components as unknowns are left.
    #[must_use]
    pub fn new(
        sum_of_squares: f64,
        [kept, unknowns]: [usize; 2],
        threshold: f64,
        components: usize,
    ) -> Option<Self> {
        /// The least x = t²/2σ².
        const LEAST: f64 = 0.5;
        /// Beyond this x nothing is left out.
        const GREATEST: f64 = 64.0;
        /// Steps of x in which a solution is looked for, by their ratio.
        const RATIO: f64 = 0.9;
        // Neither may be NaN.
        if !(sum_of_squares >= 0.0 && threshold > 0.0) || components == 0 {
            return None;
        }
        let (kept, unknowns) = (kept as f64, unknowns as f64);
        let selection = |x: f64| Selection::new(x, components);
        // The sum of squares in squares of the threshold, as x lets expect it. From the largest x
        // down, at which it is the least, the first one counts that agrees.
        let expected = |x: f64| (kept * selection(x).part - unknowns) / (2.0 * x);
        let found = sum_of_squares / (threshold * threshold);
        let [mut low, mut high] = [GREATEST; 2];
        while expected(low) < found {
            (low, high) = (low * RATIO, low);
            if low < LEAST {
                return None;
            }
        }
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            match expected(middle) < found {
                true => high = middle,
                false => low = middle,
            }
        }
        let Selection { part, efficiency } = selection(low);
        let redundancy = kept - unknowns / part;
        let variance = sum_of_squares / (part * redundancy);
        (redundancy > 0.0 && variance.is_finite()).then(|| Self {
            variance,
            of_estimates: variance / part,
            redundancy: efficiency * redundancy,
        })
    }

    /// The variance with which the covariance of least squares of what is kept has an ellipsoid for
    /// 95 % of all errors of the unknowns: [`of_estimates`](Self::of_estimates) times
    /// [`region_factor`]. `None` for a redundancy up to 2, from which the variance is not known.
    #[must_use]
    pub fn of_region(&self, unknowns: usize) -> Option<f64> {
        let factor = region_factor(unknowns, self.redundancy)?;
        (self.redundancy > 2.0).then_some(self.of_estimates * factor)
    }
}

/// What a threshold does to errors.
struct Selection {
    /// The part q of the variance that those which are kept have.
    part: f64,
    /// The number of errors without a selection that show `σ²/q` as well, for each that is kept.
    efficiency: f64,
}

impl Selection {
    /// For `x = t²/2σ²`. Halved squares of errors in variances have a gamma distribution, of which
    /// the moments are quotients of P.
    fn new(x: f64, components: usize) -> Self {
        let a = 0.5 * components as f64;
        let [first, second, third] = [a, a + 1.0, a + 2.0].map(|a| gamma_lr(a, x));
        let [part, next] = [second / first, third / second];
        // The variance of a square over the square of its mean.
        let spread = (a + 1.0) / a * next / part - 1.0;
        // d ln q / d ln x, by which the mean square q σ² changes less than σ², and σ²/q more.
        let slope = (a + 1.0) * (1.0 - next) - a * (1.0 - part);
        let gain = (1.0 + slope) / (1.0 - slope);
        Self {
            part,
            efficiency: (a * spread * gain * gain).recip(),
        }
    }
}
