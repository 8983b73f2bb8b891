//! Powers and square roots of rotations and rigid motions.

use super::logarithm::{Halves, assemble, length_and_direction, select_motor, turn_exponential};
use crate::cga3::{Motor, Rotor};
use crate::scalar::{Mask, Real};
use crate::vga3::Vector;

impl<S: Real> Rotor<S> {
    /// The power `Rᵗ = exp(t log R)` of a rotation by θ in [0, 2π]: the rotation by tθ in the same
    /// plane. Powers of `−R` rotate the other way round; see [`along`](Self::along). `−1` is
    /// treated as a full turn in the plane e12. NaN and infinity give NaN.
    ///
    /// ```
    /// use ga_runtime::cga3::Rotor;
    /// let rotation = Rotor::from_axis_angle([0.0, 3.0, 4.0], 1.5_f64).unwrap();
    /// let third = Rotor::from_axis_angle([0.0, 3.0, 4.0], 0.5).unwrap();
    /// assert!((rotation.powf(1.0 / 3.0).e12() - third.e12()).abs() < 1e-15);
    /// ```
    #[inline(always)]
    #[must_use]
    pub fn powf(self, t: S) -> Self {
        let turn = self.log();
        turn_exponential(Vector::new(turn.e12, turn.e13, turn.e23) * t)
    }

    /// The square root of a rotation by θ in [0, 2π]: the rotation by ½θ in the same plane,
    /// `(1 + R)/|1 + R|`, computed without cancellation for more than a half turn. The root of `−1`
    /// is a half turn in the plane e12, `e12`.
    ///
    /// ```
    /// use ga_runtime::cga3::Rotor;
    /// let quarter = Rotor::from_axis_angle([0.0, 0.0, 1.0], std::f64::consts::FRAC_PI_2).unwrap();
    /// let eighth = quarter.sqrt();
    /// assert!((eighth.scalar() - (std::f64::consts::PI / 8.0).cos()).abs() < 1e-15);
    /// let minus_one = -Rotor::<f64>::default();
    /// assert_eq!(minus_one.sqrt(), Rotor::new_unchecked(0.0, 1.0, 0.0, 0.0));
    /// ```
    #[must_use]
    pub fn sqrt(self) -> Self {
        let c = self.scalar();
        let q = [self.e12(), self.e13(), self.e23()];
        // |1 ± R|² = 2 (1 + |c|), the larger of the two.
        let more = S::one() + c.abs();
        let scale = (more + more).sqrt().recip();
        let is_past = c.less_than(S::zero());
        let near = (more * scale, Vector::from(q) * scale);
        if !is_past.any() {
            return Self::from_halves(near);
        }
        let (sine, axis) = length_and_direction(Vector::from(q));
        let first = S::select(sine.is_zero(), S::one(), axis[0]);
        let axis = [first, axis[1], axis[2]];
        let past = (sine * scale, Vector::from(axis) * (more * scale));
        Self::from_halves((
            S::select(is_past, past.0, near.0),
            Vector::from(core::array::from_fn(|k| {
                S::select(is_past, past.1[k], near.1[k])
            })),
        ))
    }

    fn from_halves((scalar, vector): (S, Vector<S>)) -> Self {
        Self::new_unchecked(scalar, vector.e1, vector.e2, vector.e3)
    }
}

impl<S: Real> Motor<S> {
    /// The power `Mᵗ = exp(t log M)` of a motion, for a rotation by θ in [0, 2π]: the rotation by
    /// tθ about the same screw axis with t times the translation along it. Powers of `−M` rotate
    /// the other way round; see [`along`](Self::along), and [`log`](Self::log) for `−1` and
    /// negative translators. NaN and infinity give NaN.
    ///
    /// ```
    /// use ga_runtime::cga3::{Motor, Rotor, Translator};
    /// let screw = Translator::from_displacement([0.0, 0.0, 3.0_f64])
    ///     * Rotor::from_axis_angle([0.0, 0.0, 1.0], 1.5).unwrap();
    /// let third = screw.powf(1.0 / 3.0);
    /// let expected = Translator::from_displacement([0.0, 0.0, 1.0])
    ///     * Rotor::from_axis_angle([0.0, 0.0, 1.0], 0.5).unwrap();
    /// assert!(
    ///     (third.e12() - expected.e12()).abs() < 1e-15
    ///         && (third.e3i() - expected.e3i()).abs() < 1e-15
    /// );
    /// assert_eq!(Motor::<f64>::default().powf(0.3), Motor::default());
    /// ```
    #[inline(always)]
    #[must_use]
    pub fn powf(self, t: S) -> Self {
        (self.log() * t).exp()
    }

    /// The square root of a motion, for a rotation by θ in [0, 2π]: half of the screw,
    /// `(1 + M)/|1 + M|` up to a half turn and `exp(½ log M)` beyond.
    ///
    /// `|1 + M|² = (1 + M)(1 + ~M)` is the dual number `2 (1 + c) + 2 d0 e123i`, where c and d0 are
    /// the coefficients of 1 and e123i. The root of `−1` is `e12`; that of the negative of a
    /// translator is a half turn about the axis of its translation with half of the translation.
    ///
    /// ```
    /// use ga_runtime::cga3::{Motor, Translator};
    /// let translation = Motor::from(Translator::from_displacement([2.0, 4.0, -6.0]));
    /// assert_eq!(translation.sqrt(), Translator::from_displacement([1.0, 2.0, -3.0]).into());
    /// ```
    #[must_use]
    pub fn sqrt(self) -> Self {
        let Halves { c, q, d0, d } = Halves::of(self);
        let half = S::from_ratio(1, 2);
        let more = S::one() + c;
        let scale = (more + more).sqrt().recip();
        let change = half * d0 / more;
        let root = assemble(
            more * scale,
            q * scale,
            half * d0 * scale,
            (d - q * change) * scale,
        );
        let is_past = c.less_than(S::zero());
        if !is_past.any() {
            return root;
        }
        select_motor(!is_past, root, self.powf(half))
    }
}
