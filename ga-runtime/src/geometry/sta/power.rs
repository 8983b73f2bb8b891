//! Powers of Lorentz transformations, and interpolation between them.

use crate::scalar::Real;
use crate::sta::Rotor;

impl<S: Real<Mask = bool>> Rotor<S> {
    /// The power `Rᵗ = exp(t log R)`: a boost by t times the rapidity, a rotation by t times the
    /// angle, or both in commuting planes. `None` where R has no [`log`](Self::log), or where the
    /// result is beyond the range of the scalar.
    ///
    /// ```
    /// use ga_runtime::sta::Rotor;
    /// let boost = Rotor::from_rapidity([1.0, 0.0, 0.0], 3.0).unwrap();
    /// let [x, _, _]: [f64; 3] = boost.powf(0.5).unwrap().velocity();
    /// assert!((x - 1.5_f64.tanh()).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn powf(self, t: S) -> Option<Self> {
        (self.log()? * t).exp()
    }

    /// The square root, `exp(½ log R)`; `None` as for [`powf`](Self::powf).
    #[must_use]
    pub fn sqrt(self) -> Option<Self> {
        self.powf(S::from_ratio(1, 2))
    }

    /// The interpolation from `self` at t = 0 to `other` at t = 1, `R exp(t log(~R R'))`, by the
    /// shorter rotation, with −R' instead of R' where the scalar part of `~R R'` is negative. From
    /// the frame of R the generator is constant: the rapidity and the angle grow evenly. t may be
    /// outside [0, 1]. `None` where a number is not finite or beyond the range of the scalar.
    ///
    /// A null rotation, the exponential of a null bivector, is interpolated too. Only minus a null
    /// rotation has no logarithm, and its sign is changed here.
    ///
    /// ```
    /// use ga_runtime::sta::Rotor;
    /// let [slow, fast] =
    ///     [1.0, 3.0].map(|rapidity| Rotor::from_rapidity([0.0, 1.0, 0.0], rapidity).unwrap());
    /// let [_, y, _]: [f64; 3] = slow.interpolate(fast, 0.5).unwrap().velocity();
    /// assert!((y - 2.0_f64.tanh()).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn interpolate(self, other: Self, t: S) -> Option<Self> {
        let between = self.reverse() * other;
        let between = if between.scalar().less_than(S::zero()) {
            -between
        } else {
            between
        };
        Some(self * between.powf(t)?)
    }
}
