//! Exponential and logarithm of rigid motions.
//!
//! The element `ω = e123i` commutes with every motor and squares to zero, so a motor is `Q + ω D`
//! with two elements Q, D of the span of 1, e12, e13, e23, and a generator is `g + ω h` with two
//! bivectors g, h of space. Since `(g + ω h)² = −φ̂²` with the dual number `φ̂² = φ² + 2 ω g·h`, φ
//! = |g|, the exponential has the form of that of a complex number, `cos φ̂ + (g + ω h) sin φ̂/φ̂`,
//! with both functions of a dual number (Selig, Geometric Fundamentals of Robotics, 2005).
//!
//! Written out, with `c + q` and `d0 + d` for the parts of the motor,
//!
//! ```text
//! exp   c = cos φ           q = A g   d0 = −g·h A   d = A h + g (g·h) B
//!       with A = sin φ/φ, B = (cos φ − A)/φ²
//! log   φ = atan2(|q|, c)   g = A q                 h = A d + q (q·d B − d0)
//!       with A = φ/sin φ, B = (c − A)/sin² φ
//! ```
//!
//! A and B are smooth at φ = 0 and are computed by [`Real::sine_by_angle`] and
//! [`Real::angle_by_sine`], so that there is no branch on the angle. Where an intermediate result
//! would leave the range of the scalar, a slower method is used.

use core::f64::consts::{FRAC_PI_2, PI};

use crate::cga3::{Motor, MotorGenerator, Rotor};
use crate::scalar::{Field, Mask, Real};
use crate::vga3::Vector;

impl<S: Real> MotorGenerator<S> {
    /// The motor `exp(G)`: for `G = −½θB` a rotation by θ in the plane B, for `G = −½ t ei` a
    /// translation by t.
    ///
    /// Every finite generator has an exponential. A coefficient beyond the range of the scalar is
    /// infinite; NaN or infinity in G gives NaN.
    ///
    /// ```
    /// use ga_runtime::cga3::{MotorGenerator, Translator};
    /// let translation = MotorGenerator::new(0.0, 0.0, 0.0, -0.5, -1.0, -1.5).exp();
    /// assert_eq!(translation, Translator::from_displacement([1.0, 2.0, 3.0]).into());
    /// ```
    #[inline(always)]
    #[must_use]
    pub fn exp(self) -> Motor<S> {
        let (g, h) = parts(self);
        let square = g.dot(g);
        let (cosine, ratio, slope) = square.sine_by_angle();
        let q = g * ratio;
        let d0 = -q.dot(h);
        let along = g.dot(h);
        let d = h * ratio + g * (along * slope);
        let motor = assemble(cosine, q, d0, d);
        // Zero, or NaN where a product with h may be beyond the range of the scalar.
        let overflow = along * S::from_integer(8) * S::zero();
        let is_regular = (square + overflow).less_than(largest_square());
        if is_regular.all() {
            return motor;
        }
        select_motor(is_regular, motor, exponential_of_any(generator(g, h)))
    }
}

impl<S: Real> Motor<S> {
    /// The generator G with `exp(G) = M`, for a rotation by θ in [0, 2π], so that `exp(G)` restores
    /// the sign of M too.
    ///
    /// `−1` is treated as a full turn in the plane e12, and the negative of a translator as a full
    /// turn about the axis of its translation. So are motors that differ from these by less than ε,
    /// where half the angle rounds to π. Near these the axis is ill-conditioned: the error of
    /// `exp(log M)` is that of M divided by the sine of half the angle.
    ///
    /// A coefficient beyond the range of the scalar is infinite; NaN or infinity in M gives NaN.
    ///
    /// ```
    /// use ga_runtime::cga3::{Rotor, Translator};
    /// let motor = Translator::from_displacement([1.0_f64, 2.0, 3.0])
    ///     * Rotor::from_axis_angle([0.0, 1.0, 0.0], 2.0).unwrap();
    /// let again = motor.log().exp();
    /// assert!((again.e1i() - motor.e1i()).abs() < 1e-15);
    /// ```
    #[inline(always)]
    #[must_use]
    pub fn log(self) -> MotorGenerator<S> {
        let Halves { c, q, d0, d } = Halves::of(self);
        let square = q.dot(q);
        let (ratio, slope) = angle_by_sine(c, square);
        let g = q * ratio;
        let h = d * ratio + q * (q.dot(d) * slope - d0);
        // Zero, or NaN where a product with d may be beyond the range of the scalar.
        let overflow = (d.dot(d) + d0 * d0) * S::zero();
        let is_regular = is_regular_turn(c, square, overflow);
        if is_regular.all() {
            return generator(g, h);
        }
        let (careful_g, careful_h) = logarithm_of_any(assemble(c, q, d0, d));
        generator(
            select_vector(is_regular, g, careful_g),
            select_vector(is_regular, h, careful_h),
        )
    }
}

impl<S: Real> Rotor<S> {
    /// The generator G with `exp(G) = R`, for a rotation by θ in [0, 2π]: `−½θB` in the plane B of
    /// the rotation, without a translation.
    ///
    /// `−1` is treated as a full turn in the plane e12, and a rotor that differs from it by less
    /// than ε as a full turn in its own plane. [`MotorGenerator::exp`] is the inverse function and
    /// gives a motor. NaN or infinity in R gives NaN.
    ///
    /// ```
    /// use ga_runtime::cga3::{Motor, MotorGenerator, Rotor};
    /// let rotation = Rotor::from_axis_angle([0.0, 0.0, 1.0_f64], 0.5).unwrap();
    /// let generator = rotation.log();
    /// assert!((generator.e12 + 0.25).abs() < 1e-16);
    /// assert_eq!((-Rotor::<f64>::default()).log().e12, std::f64::consts::PI);
    /// ```
    #[inline(always)]
    #[must_use]
    pub fn log(self) -> MotorGenerator<S> {
        let (c, q) = (self.scalar(), [self.e12(), self.e13(), self.e23()]);
        let zero = [S::zero(); 3];
        let (q, zero) = (Vector::from(q), Vector::from(zero));
        let square = q.dot(q);
        let (ratio, _) = angle_by_sine(c, square);
        let g = q * ratio;
        let is_regular = is_regular_turn(c, square, S::zero());
        if is_regular.all() {
            return generator(g, zero);
        }
        let (careful_g, _) = logarithm_of_any(assemble(c, q, S::zero(), zero));
        generator(select_vector(is_regular, g, careful_g), zero)
    }
}

/// `φ/sin φ` and `(cos φ − φ/sin φ)/sin² φ` from cos φ and sin² φ, for φ in [0, π].
#[inline(always)]
fn angle_by_sine<S: Real>(c: S, square: S) -> (S, S) {
    let (ratio, slope) = c.abs().angle_by_sine();
    // For φ beyond ½π: φ = π − φ′, where φ′ belongs to −c.
    let inverse = square.max(tiny_square()).sqrt().recip();
    let sign = S::select(c.less_than(S::zero()), -S::one(), S::one());
    let rest = (S::one() - sign) * S::from_f64(FRAC_PI_2) * inverse;
    (
        ratio.mul_add(sign, rest),
        slope.mul_sub(sign, rest * inverse * inverse),
    )
}

/// Whether these are approximately the cosine and the squared sine of an angle that is not within ε
/// of π, and `overflow` is zero, not NaN.
#[inline(always)]
fn is_regular_turn<S: Real>(c: S, square: S, overflow: S) -> S::Mask {
    let deviation = (c * c + square - S::one()).abs() + overflow;
    deviation.less_than(S::from_ratio(1, 16)) & tiny_square::<S>().less_than(square.max(c))
}

/// The square of the sine below which half the angle rounds to π.
#[inline(always)]
fn tiny_square<S: Real>() -> S {
    S::epsilon() * S::epsilon()
}

/// The rotor `exp(g)`.
#[inline(always)]
pub(super) fn turn_exponential<S: Real>(g: Vector<S>) -> Rotor<S> {
    let square = g.dot(g);
    let (cosine, ratio, _) = square.sine_by_angle();
    let q = g * ratio;
    let is_regular = square.less_than(largest_square());
    if is_regular.all() {
        return Rotor::new_unchecked(cosine, q[0], q[1], q[2]);
    }
    let careful = Halves::of(exponential_of_any(generator(g, Vector::default())));
    let q = select_vector(is_regular, q, careful.q);
    Rotor::new_unchecked(S::select(is_regular, cosine, careful.c), q[0], q[1], q[2])
}

/// A motor as `(c + q) + ω (d0 + d)`.
pub(super) struct Halves<S> {
    pub(super) c: S,
    pub(super) q: Vector<S>,
    pub(super) d0: S,
    pub(super) d: Vector<S>,
}

impl<S: Field> Halves<S> {
    pub(super) fn of(motor: Motor<S>) -> Self {
        Self {
            c: motor.scalar(),
            q: Vector::new(motor.e12(), motor.e13(), motor.e23()),
            d0: motor.e123i(),
            d: Vector::new(-motor.e3i(), motor.e2i(), -motor.e1i()),
        }
    }
}

/// The motor `(q0 + q) + ω (d0 + d)`, with its coefficients.
pub(super) fn assemble<S: Field>(q0: S, q: Vector<S>, d0: S, d: Vector<S>) -> Motor<S> {
    Motor::new_unchecked(q0, q[0], q[1], q[2], -d[2], d[1], -d[0], d0)
}

/// The largest φ² for which the polynomials are used.
fn largest_square<S: Real>() -> S {
    S::from_ratio(995, 100)
}

#[inline(always)]
pub(super) fn select_motor<S: Real>(mask: S::Mask, a: Motor<S>, b: Motor<S>) -> Motor<S> {
    let (a, b) = (Halves::of(a), Halves::of(b));
    assemble(
        S::select(mask, a.c, b.c),
        select_vector(mask, a.q, b.q),
        S::select(mask, a.d0, b.d0),
        select_vector(mask, a.d, b.d),
    )
}

#[inline(always)]
fn select_vector<S: Real>(mask: S::Mask, a: Vector<S>, b: Vector<S>) -> Vector<S> {
    Vector::new(
        S::select(mask, a.e1, b.e1),
        S::select(mask, a.e2, b.e2),
        S::select(mask, a.e3, b.e3),
    )
}

/// The exponential for g and h of any size: from the unit axis, with h scaled down until the last
/// step.
#[cold]
#[inline(never)]
fn exponential_of_any<S: Real>(any: MotorGenerator<S>) -> Motor<S> {
    let (g, h) = parts(any);
    let (angle, axis) = length_and_direction(g);
    // Where the angle is beyond the range of the scalar, from its half.
    let half = S::from_ratio(1, 2);
    let is_beyond = !angle.is_finite() & axis.dot(axis).is_finite();
    let (sine, cosine) = S::select(is_beyond, (g * half).length(), angle).sin_cos();
    let (double_sine, double_cosine) = (sine * cosine, cosine * cosine - sine * sine);
    let sine = S::select(is_beyond, double_sine + double_sine, sine);
    let cosine = S::select(is_beyond, double_cosine, cosine);

    let (zero, one) = (S::zero(), S::one());
    let is_zero = angle.is_zero();
    let ratio = S::select(is_zero, one, sine / S::select(is_zero, one, angle));
    let ratio = S::select(is_beyond, zero, ratio);
    let h = h * S::from_ratio(1, 8);
    let along = axis.dot(h);
    let eight = S::from_integer(8);
    let d = h * ratio + axis * (along * (cosine - ratio));
    let d0 = -(along * sine);
    assemble(cosine, axis * sine, d0 * eight, d * eight)
}

/// The logarithm for coefficients of any size, as g and h: of the motor divided by its length, from
/// the unit axis, with the size of d divided out until the last step.
#[cold]
#[inline(never)]
fn logarithm_of_any<S: Real>(motor: Motor<S>) -> (Vector<S>, Vector<S>) {
    let (zero, one) = (S::zero(), S::one());
    // This keeps the length within the range of the scalar.
    let quarter = S::from_ratio(1, 4);
    let Halves { c, q, d0, d } = Halves::of(motor);
    let largest = c.abs().max(q[0].abs()).max(q[1].abs()).max(q[2].abs());
    let scale = S::select(one.less_than(largest), quarter, one);
    let (c, q) = (c * scale, q * scale);
    let (d0, d) = (d0 * scale, d * scale);
    let size = Vector::new(q.length(), c, zero).length();
    let size = S::select(size.is_zero(), one, size);
    let (c, q) = (c / size, q.divided(size));
    let largest = d0.abs().max(d[0].abs()).max(d[1].abs()).max(d[2].abs());
    let is_regular = zero.less_than(largest) & largest.is_finite();
    let largest = S::select(is_regular, largest, one);
    let (d0, d) = (d0 / largest, d.divided(largest));

    let (sine, axis) = length_and_direction(q);
    let angle = sine.atan2(c);
    let is_zero = sine.is_zero();
    let ratio = S::select(is_zero, one, angle / S::select(is_zero, one, sine));
    let along = axis.dot(d);
    let across = d - axis * along;
    let advance = c * along - sine * d0;
    let g = q * ratio;
    let h = across * ratio + axis * advance;

    let is_whole = sine.less_than(S::epsilon()) & c.less_than(zero);
    let pi = S::from_f64(PI);
    let (shift, direction) = length_and_direction(d);
    let (_, turned) = length_and_direction(q);
    let plane = select_vector(is_zero, Vector::new(one, zero, zero), turned);
    let plane = select_vector(shift.is_zero(), plane, direction);
    // The component that a full turn leaves out must not hide a NaN.
    let none = d0 * zero;
    let whole_h = Vector::new(none, none, none) - d;
    (
        select_vector(is_whole, plane * pi, g),
        (select_vector(is_whole, whole_h, h).divided(size.max(one)) * largest)
            .divided(size.min(one)),
    )
}

/// The length and the unit vector of the same direction, which is zero for zero.
pub(super) fn length_and_direction<S: Real>(a: Vector<S>) -> (S, Vector<S>) {
    let largest = a[0].abs().max(a[1].abs()).max(a[2].abs());
    let is_regular = S::zero().less_than(largest) & largest.is_finite();
    let size = S::select(is_regular, largest, S::one());
    let unit = a.divided(size);
    let relative = unit.dot(unit).sqrt();
    let divisor = S::select(relative.is_zero(), S::one(), relative);
    (relative * size, unit.divided(divisor))
}

/// A generator as g and h of `g + ω h`.
pub(super) fn parts<S: Field>(generator: MotorGenerator<S>) -> (Vector<S>, Vector<S>) {
    let MotorGenerator {
        e12,
        e13,
        e23,
        e1i,
        e2i,
        e3i,
    } = generator;
    (Vector::new(e12, e13, e23), Vector::new(-e3i, e2i, -e1i))
}

/// The generator `g + ω h`, with its coefficients.
pub(super) fn generator<S: Field>(g: Vector<S>, h: Vector<S>) -> MotorGenerator<S> {
    MotorGenerator::new(g[0], g[1], g[2], -h[2], h[1], -h[0])
}
