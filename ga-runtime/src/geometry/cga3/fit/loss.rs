//! Losses of distances, by which far points count less.

use crate::scalar::Real;

/// How much a distance r counts in an M-estimate, in units of the scale s of the noise: the
/// estimate makes `Σ ρ(r/s)` least.
///
/// The constants are those for which the estimate has 95 % of the efficiency of least squares if
/// the distances from a surface are normally distributed (Huber and Ronchetti, Robust Statistics,
/// 2009; Beaton and Tukey, The fitting of power series, Technometrics 16, 1974).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Loss {
    /// Squares up to 1.345 s, then linear: distant points have a bounded influence.
    Huber,
    /// The biweight: distances above 4.685 s have no influence.
    Tukey,
}

impl Loss {
    /// The distance, in units of the scale, at which the loss ceases to grow with the square.
    pub(super) fn constant<S: Real>(self) -> S {
        match self {
            Self::Huber => S::from_f64(1.345),
            Self::Tukey => S::from_f64(4.685),
        }
    }
}

/// A loss with its limit as a length; `None` for squares.
pub(super) type Limited<S> = Option<(Loss, S)>;

/// The loss ρ of a squared distance, its weight `ψ(r)/r`, and `ψ′(r)`, with `ψ = ½ρ′`. A loss is
/// the square for small distances.
#[inline]
pub(super) fn loss<S: Real<Mask = bool>>(limited: Limited<S>, square: S) -> [S; 3] {
    let (zero, one) = (S::zero(), S::one());
    match limited {
        None => [square, one, one],
        Some((Loss::Huber, limit)) => {
            if square.less_or_equal(limit * limit) {
                return [square, one, one];
            }
            let distance = square.sqrt();
            let excess = distance + distance - limit;
            [limit * excess, limit / distance, zero]
        }
        Some((Loss::Tukey, limit)) => {
            let most = limit * limit;
            if !square.less_than(most) {
                return [most * S::from_ratio(1, 3), zero, zero];
            }
            let part = square / most;
            let rest = one - part;
            let cube = one - rest * rest * rest;
            let slope = rest * (one - part * S::from_integer(5));
            [most * cube * S::from_ratio(1, 3), rest * rest, slope]
        }
    }
}
