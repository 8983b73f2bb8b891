//! Interpolation of rotations and rigid motions: slerp at constant speed, and the cheaper nlerp.
//!
//! Slerp of two rotors is a sum `A R + B R′` whose factors depend on t and on the cosine of half
//! the angle between them, their scalar product. The formula holds for motors too: with
//! `ω = e123i`, which commutes with every motor and squares to zero, the scalar product of two
//! motors is a dual number `c + d ω`, and so are the factors, `A(c) + d A′(c) ω`. The sum moves
//! along the screw from one motor to the other: neither a logarithm nor an exponential is needed.

use super::RotationPath;
use super::logarithm::select_motor;
use crate::cga3::{Motor, Rotor};
use crate::scalar::{Mask, Real};

impl<S: Real> Rotor<S> {
    /// The interpolation from `self` at t = 0 to `other` at t = 1 at constant angular velocity, by
    /// the shorter rotation: `R (~R R′)ᵗ`, with `−R′` instead of R′ where that is nearer.
    ///
    /// This is the slerp of Cui, eqs. 18 to 22, `(sin (1 − t)φ R + sin tφ R′)/sin φ` with φ half
    /// the angle between them, in a form without special cases for small angles (see
    /// [`Real::arc_factors`]). Both must be unit rotors, as their type states. t may be outside
    /// [0, 1]; NaN and infinity give NaN. The cases of the flow chart of Cui, fig. 4, are
    ///
    /// | case | here |
    /// | --- | --- |
    /// | negative scalar product | `−R′` in place of R′; the longer way: [`interpolate_along`] |
    /// | nearly equal rotations | no case: the factors are smooth functions of the product |
    /// | nearly opposite rotors | nearly equal rotations: the longer way is nearly a full turn |
    /// | half a turn apart | both ways are equally long; the sign of the scalar product decides |
    ///
    /// [`interpolate_along`]: Self::interpolate_along
    ///
    /// ```
    /// use ga_runtime::cga3::Rotor;
    /// let (start, end) = (
    ///     Rotor::<f64>::default(),
    ///     Rotor::from_axis_angle([0.0, 0.0, 1.0], 1.0).unwrap(),
    /// );
    /// let (_, angle) = start.interpolate(end, 0.25).to_axis_angle();
    /// assert!((angle - 0.25).abs() < 1e-15);
    /// ```
    #[inline(always)]
    #[must_use]
    pub fn interpolate(self, other: Self, t: S) -> Self {
        let (from, to) = (coefficients(self), coefficients(other));
        let cosine = product(from, to);
        let (cosine, sign) = shorter(cosine);
        let factors = cosine.arc_factors(t);
        let second = factors.second * sign;
        let [s, e12, e13, e23] =
            core::array::from_fn(|k| from[k].mul_add(factors.first, to[k] * second));
        let is_regular = is_regular(cosine, t, S::zero());
        if is_regular.all() {
            return Self::new_unchecked(s, e12, e13, e23);
        }
        let careful = rotor_by_power(rotor(from), rotor(to), t, RotationPath::Short);
        let careful = coefficients(careful);
        let select = |k: usize, x: S| S::select(is_regular, x, careful[k]);
        Self::new_unchecked(select(0, s), select(1, e12), select(2, e13), select(3, e23))
    }

    /// As [`interpolate`](Self::interpolate), by the shorter or the longer rotation. The longer
    /// rotation between equal rotors is a full turn in the plane e12 of `self`.
    ///
    /// ```
    /// use ga_runtime::cga3::Rotor;
    /// use ga_runtime::geometry::RotationPath;
    /// let (start, end) = (
    ///     Rotor::<f64>::default(),
    ///     Rotor::from_axis_angle([0.0, 0.0, 1.0], 1.0).unwrap(),
    /// );
    /// let (axis, angle) = start
    ///     .interpolate_along(end, 0.25, RotationPath::Long)
    ///     .to_axis_angle();
    /// assert!(
    ///     axis[2] < -0.9 && (angle - 0.25 * (2.0 * std::f64::consts::PI - 1.0)).abs() < 1e-15
    /// );
    /// ```
    #[inline]
    #[must_use]
    pub fn interpolate_along(self, other: Self, t: S, path: RotationPath) -> Self {
        match path {
            RotationPath::Short => self.interpolate(other, t),
            RotationPath::Long => rotor_by_power(self, other, t, path),
        }
    }

    /// The normalised linear interpolation from `self` at t = 0 to `other` at t = 1, nlerp:
    /// `((1 − t) R ± t R′)/|(1 − t) R ± t R′|`, with the sign of the shorter rotation.
    ///
    /// It rotates in the same plane as [`interpolate`](Self::interpolate), is the same at t = 0, ½
    /// and 1, and in between differs by up to 8.2° for rotors half a turn apart, 0.92° for a
    /// quarter turn and 0.12° for an eighth. The sum cannot vanish, for any t. NaN and infinity
    /// give NaN.
    ///
    /// ```
    /// use ga_runtime::cga3::Rotor;
    /// let quarter = Rotor::from_axis_angle([0.0, 0.0, 1.0], std::f64::consts::FRAC_PI_2).unwrap();
    /// let (_, half) = Rotor::default().nlerp(quarter, 0.5).to_axis_angle();
    /// assert!((half - std::f64::consts::FRAC_PI_4).abs() < 1e-15);
    /// ```
    #[inline(always)]
    #[must_use]
    pub fn nlerp(self, other: Self, t: S) -> Self {
        let (from, to) = (coefficients(self), coefficients(other));
        let (_, sign) = shorter(product(from, to));
        let (first, second) = (S::one() - t, t * sign);
        let sum = core::array::from_fn(|k| from[k].mul_add(first, to[k] * second));
        let scale = product(sum, sum).sqrt().recip();
        let [s, e12, e13, e23] = sum.map(|x| x * scale);
        Self::new_unchecked(s, e12, e13, e23)
    }
}

impl<S: Real> Motor<S> {
    /// The interpolation from `self` at t = 0 to `other` at t = 1 along a screw at constant speed,
    /// by the shorter rotation: `M (~M N)ᵗ`, with `−N` instead of N where that is nearer. t may be
    /// outside [0, 1].
    ///
    /// It is computed as `A M + B N`, slerp with dual numbers as factors (Kavan, Collins,
    /// O'Sullivan and Žára, Dual quaternions for rigid transformation blending, 2006, call it
    /// ScLERP). Both must be unit motors, as their type states; NaN and infinity give NaN.
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
        let (a, b) = (all_coefficients(self), all_coefficients(other));
        let (cosine, sign) = shorter(a[0] * b[0] + a[1] * b[1] + (a[2] * b[2] + a[3] * b[3]));
        let part = (a[0] * b[7] + a[7] * b[0] - a[1] * b[6] - a[6] * b[1])
            + (a[2] * b[5] + a[5] * b[2] - a[3] * b[4] - a[4] * b[3]);
        let factors = cosine.arc_factors(t);
        let second = factors.second * sign;
        let first_part = factors.first_slope * (part * sign);
        let second_part = factors.second_slope * part;
        // A M + B N without, and with, ω and the dual parts of the factors.
        let sum = |k: usize| a[k] * factors.first + b[k] * second;
        let change = |k: usize| a[k] * first_part + b[k] * second_part;
        let between = Self::new_unchecked(
            sum(0),
            sum(1),
            sum(2),
            sum(3),
            sum(4) - change(3),
            sum(5) + change(2),
            sum(6) - change(1),
            sum(7) + change(0),
        );
        // Zero, or NaN where the result may be beyond the range of the scalar.
        let overflow = part * S::from_integer(8) * S::zero();
        let is_regular = is_regular(cosine, t, overflow);
        if is_regular.all() {
            return between;
        }
        // From the coefficients: if the operands themselves were passed, they would be kept in
        // memory from the start.
        let careful = motor_by_power(motor(a), motor(b), t, RotationPath::Short);
        select_motor(is_regular, between, careful)
    }

    /// As [`interpolate`](Self::interpolate), by the shorter or the longer rotation. The longer
    /// rotation between two motors that differ by a translation is a full turn about the axis of
    /// the translation; where they are equal, it is in the plane e12 of `self`.
    ///
    /// ```
    /// use ga_runtime::cga3::{Motor, Point, Rotor};
    /// use ga_runtime::geometry::RotationPath;
    /// let quarter = Rotor::from_axis_angle([0.0, 0.0, 1.0], std::f64::consts::FRAC_PI_2).unwrap();
    /// let middle = Motor::default().interpolate_along(quarter.into(), 0.5, RotationPath::Long);
    /// let [x, y, _]: [f64; 3] = middle.transform(Point::new(1.0, 0.0, 0.0)).coordinates();
    /// assert!((x + 0.5_f64.sqrt()).abs() < 1e-15 && (y + 0.5_f64.sqrt()).abs() < 1e-15);
    /// ```
    #[inline]
    #[must_use]
    pub fn interpolate_along(self, other: Self, t: S, path: RotationPath) -> Self {
        match path {
            RotationPath::Short => self.interpolate(other, t),
            RotationPath::Long => motor_by_power(self, other, t, path),
        }
    }

    /// The normalised linear interpolation from `self` at t = 0 to `other` at t = 1, nlerp:
    /// `((1 − t) M ± t N)/|(1 − t) M ± t N|`, with the sign of the shorter rotation and a norm that
    /// has a scalar part and a part of grade 4, as in [`Motor::blend`]. Up to its sign, which is
    /// that of `self`, it is that blend of the two with the weights 1 − t and t.
    ///
    /// It is a motion about the same screw axis as [`interpolate`](Self::interpolate), but neither
    /// at constant speed nor of constant pitch: the rotation is that of [`Rotor::nlerp`].
    /// Translations are interpolated linearly. NaN and infinity give NaN.
    ///
    /// ```
    /// use ga_runtime::cga3::{Motor, Translator};
    /// let [near, far] =
    ///     [2.0, 6.0].map(|x| Motor::from(Translator::from_displacement([x, 0.0, 0.0])));
    /// let between = near.nlerp(-far, 0.25);
    /// assert_eq!(between.translator().displacement(), [3.0, 0.0, 0.0]);
    /// ```
    #[inline(always)]
    #[must_use]
    pub fn nlerp(self, other: Self, t: S) -> Self {
        let (_, sign) = shorter(product(
            coefficients(self.rotor()),
            coefficients(other.rotor()),
        ));
        let sum = self * (S::one() - t) + other * (t * sign);
        sum.divided_by_norm().0
    }
}

/// The interpolation by a power of the motion from one to the other: for the longer way, and where
/// the formula without angles does not apply.
#[cold]
#[inline(never)]
fn rotor_by_power<S: Real>(from: Rotor<S>, to: Rotor<S>, t: S, path: RotationPath) -> Rotor<S> {
    from * (from.reverse() * to).along(path).powf(t)
}

#[cold]
#[inline(never)]
fn motor_by_power<S: Real>(from: Motor<S>, to: Motor<S>, t: S, path: RotationPath) -> Motor<S> {
    from * (from.reverse() * to).along(path).powf(t)
}

/// The absolute value of a scalar product of two versors, and the sign of the second one that gives
/// the shorter rotation.
#[inline(always)]
fn shorter<S: Real>(product: S) -> (S, S) {
    let is_opposite = product.less_than(S::zero());
    (product.abs(), S::select(is_opposite, -S::one(), S::one()))
}

/// Whether [`Real::arc_factors`] applies, and `overflow` is zero, not NaN.
#[inline(always)]
fn is_regular<S: Real>(cosine: S, t: S, overflow: S) -> S::Mask {
    // The cosine of unit versors is at most 1 to rounding; for others it is not a cosine.
    (cosine + overflow).less_than(S::from_ratio(17, 16)) & t.abs().less_or_equal(S::one())
}

#[inline(always)]
fn coefficients<S: Real>(rotor: Rotor<S>) -> [S; 4] {
    [rotor.scalar(), rotor.e12(), rotor.e13(), rotor.e23()]
}

#[inline(always)]
fn rotor<S: Real>([s, e12, e13, e23]: [S; 4]) -> Rotor<S> {
    Rotor::new_unchecked(s, e12, e13, e23)
}

#[inline(always)]
fn motor<S: Real>([s, e12, e13, e23, e1i, e2i, e3i, e123i]: [S; 8]) -> Motor<S> {
    Motor::new_unchecked(s, e12, e13, e23, e1i, e2i, e3i, e123i)
}

#[inline(always)]
fn all_coefficients<S: Real>(motor: Motor<S>) -> [S; 8] {
    [
        motor.scalar(),
        motor.e12(),
        motor.e13(),
        motor.e23(),
        motor.e1i(),
        motor.e2i(),
        motor.e3i(),
        motor.e123i(),
    ]
}

#[inline(always)]
fn product<S: Real>(a: [S; 4], b: [S; 4]) -> S {
    a[0] * b[0] + a[1] * b[1] + (a[2] * b[2] + a[3] * b[3])
}
