//! How much residuals count.

/// The loss ρ of a residual r, a vector of one or more components, as a function of `s = |r|`. What
/// is made least is the sum of the losses.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Loss {
    /// `ρ = s²`.
    #[default]
    Squares,
    /// `ρ = s²` up to the scale h, and `2hs − h²` beyond: an outlier counts by its distance (P. J.
    /// Huber, "Robust estimation of a location parameter", 1964).
    Huber(f64),
    /// `ρ = h² ln(1 + s²/h²)`: an outlier hardly counts.
    Cauchy(f64),
    /// `ρ = h² s² / (h² + s²)`: what is far away does not count (S. Geman, D. McClure, "Statistical
    /// methods for tomographic image reconstruction", 1987).
    GemanMcClure(f64),
}

impl Loss {
    /// The loss of a residual with the square of the length `s²`, and the weight of its squares in
    /// the equations of a step, `dρ / d(s²)`.
    #[must_use]
    pub fn of(self, squared: f64) -> (f64, f64) {
        match self {
            Self::Squares => (squared, 1.0),
            Self::Huber(scale) if squared <= scale * scale => (squared, 1.0),
            Self::Huber(scale) => {
                let length = squared.sqrt();
                (scale * (2.0 * length - scale), scale / length)
            }
            Self::Cauchy(scale) => {
                let ratio = squared / (scale * scale);
                (scale * scale * ratio.ln_1p(), 1.0 / (1.0 + ratio))
            }
            Self::GemanMcClure(scale) => {
                let near = 1.0 / (1.0 + squared / (scale * scale));
                (squared * near, near * near)
            }
        }
    }
}
