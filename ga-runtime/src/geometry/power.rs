//! Powers of rigid motions, and motion at constant speed from one to another.

use super::logarithm::{Halves, assemble};
use super::vector3::scaled;
use crate::cga3::Motor;
use crate::scalar::Real;

impl<S: Real> Motor<S> {
    /// The part t of the motion along its screw, `Mᵗ = exp(t log M)`: a turn by tθ about the same axis with t times the shift
    /// along it, for θ in [0, 2π]. Half of `−M` is therefore not half of M but goes the other way round; see [`log`](Self::log)
    /// for `−1` and minus a translator.
    ///
    /// ```
    /// use ga_runtime::cga3::{Motor, Rotor, Translator};
    /// let screw = Translator::from_displacement([0.0, 0.0, 3.0_f64])
    ///     * Rotor::from_axis_angle([0.0, 0.0, 1.0], 1.5).unwrap();
    /// let third = screw.powf(1.0 / 3.0);
    /// let expected = Translator::from_displacement([0.0, 0.0, 1.0])
    ///     * Rotor::from_axis_angle([0.0, 0.0, 1.0], 0.5).unwrap();
    /// assert!((third.e12() - expected.e12()).abs() < 1e-15 && (third.e3i() - expected.e3i()).abs() < 1e-15);
    /// assert_eq!(Motor::<f64>::default().powf(0.3), Motor::default());
    /// ```
    #[inline(always)]
    #[must_use]
    pub fn powf(self, t: S) -> Self {
        (self.log() * t).exp()
    }

    /// The motion on the way from `self` at t = 0 to `other` at t = 1 along a screw of constant speed, by the short way
    /// round: `M (~M N)ᵗ`, with `−N` for N where that is nearer.
    ///
    /// ```
    /// use ga_runtime::cga3::{Motor, Point, Rotor};
    /// let quarter = Rotor::from_axis_angle([0.0, 0.0, 1.0], std::f64::consts::FRAC_PI_2).unwrap();
    /// let middle = Motor::default().interpolate(quarter.into(), 0.5);
    /// let [x, y, _]: [f64; 3] = middle.transform(Point::new(1.0, 0.0, 0.0)).coordinates();
    /// assert!((x - 0.5_f64.sqrt()).abs() < 1e-15 && (y - 0.5_f64.sqrt()).abs() < 1e-15);
    /// ```
    #[inline(always)]
    #[must_use]
    pub fn interpolate(self, other: Self, t: S) -> Self {
        let between = self.reverse() * other;
        let Halves { c, q, d0, d } = Halves::of(between);
        let one = S::one();
        let sign = S::select(c.less_than(S::zero()), -one, one);
        self * assemble(c * sign, scaled(q, sign), d0 * sign, scaled(d, sign)).powf(t)
    }
}
