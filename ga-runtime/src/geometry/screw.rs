//! Exponential and logarithm of rigid motions, and motion along a screw.
//!
//! The element `ω = e123i` commutes with every motor and squares to zero, so a motor is `Q + ω D` with two elements
//! Q, D of the span of 1, e12, e13, e23, and a generator is `g + ω h` with two bivectors g, h of space. Since
//! `(g + ω h)² = −φ̂²` with the dual number `φ̂² = φ² + 2 ω g·h`, φ = |g|, the exponential is that of a complex number,
//! `cos φ̂ + (g + ω h) sin φ̂/φ̂`, with both functions taken of a dual number (Selig, Geometric Fundamentals of Robotics, 2005).

use super::vector3::{dot, length, scaled};
use crate::cga3::{Motor, MotorGenerator};
use crate::scalar::{Field, Real};

impl<S: Real<Mask = bool>> MotorGenerator<S> {
    /// The motor `exp(G)`: for `G = −½θB` a turn by θ in the plane B, for `G = −½ t ei` a shift by t.
    ///
    /// ```
    /// use ga_runtime::cga3::{MotorGenerator, Translator};
    /// let shift = MotorGenerator::new(0.0, 0.0, 0.0, -0.5, -1.0, -1.5).exp();
    /// assert_eq!(shift, Translator::from_displacement([1.0, 2.0, 3.0]).into());
    /// ```
    #[must_use]
    pub fn exp(self) -> Motor<S> {
        let g = [self.e12, self.e13, self.e23];
        let h = [-self.e3i, self.e2i, -self.e1i];
        let angle = length(g);
        let (sine, cosine) = angle.sin_cos();
        let ratio = if S::zero().less_than(angle) {
            sine / angle
        } else {
            S::one()
        };
        let q = scaled(g, ratio);
        // By the unit axis where the square of a large angle would leave the range of the scalar.
        let (axis, along, change) = if S::one().less_than(angle) {
            let axis = g.map(|x| x / angle);
            (axis, dot(axis, h), cosine - ratio)
        } else {
            (g, dot(g, h), sine_ratio_slope(angle, cosine, ratio))
        };
        let d = [0, 1, 2].map(|k| h[k] * ratio + axis[k] * along * change);
        let d0 = -dot(q, h);
        assemble(cosine, q, d0, d)
    }
}

impl<S: Real<Mask = bool>> Motor<S> {
    /// The generator G with `exp(G) = M`, for a turn by θ in [0, 2π], so that the sign of M comes back too.
    ///
    /// `−1` is taken as a whole turn in the plane e12, and minus a translator as one about the axis of its shift.
    ///
    /// ```
    /// use ga_runtime::cga3::{Rotor, Translator};
    /// let motor = Translator::from_displacement([1.0_f64, 2.0, 3.0])
    ///     * Rotor::from_axis_angle([0.0, 1.0, 0.0], 2.0).unwrap();
    /// let again = motor.log().exp();
    /// assert!((again.e1i() - motor.e1i()).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn log(self) -> MotorGenerator<S> {
        let (cosine, q) = (self.scalar(), [self.e12(), self.e13(), self.e23()]);
        let (d0, d) = (self.e123i(), [-self.e3i(), self.e2i(), -self.e1i()]);
        let sine = length(q);
        let angle = sine.atan2(cosine);
        if !S::zero().less_than(sine) && cosine.less_than(S::zero()) {
            return whole_turn(d);
        }
        let ratio = if S::zero().less_than(angle) {
            sine / angle
        } else {
            S::one()
        };
        let scale = ratio.recip();
        let g = scaled(q, scale);
        let slope = -(d0 * scale) * sine_ratio_slope(angle, cosine, ratio);
        let h = [0, 1, 2].map(|k| (d[k] - g[k] * slope) * scale);
        generator(g, h)
    }

    /// The motion on the way from `self` at t = 0 to `other` at t = 1 along a screw of constant speed, by the short way
    /// round: `M exp(t log(~M N))`.
    ///
    /// ```
    /// use ga_runtime::cga3::{Motor, Point, Rotor};
    /// let quarter = Rotor::from_axis_angle([0.0, 0.0, 1.0], std::f64::consts::FRAC_PI_2).unwrap();
    /// let middle = Motor::default().interpolate(quarter.into(), 0.5);
    /// let [x, y, _]: [f64; 3] = middle.transform(Point::new(1.0, 0.0, 0.0)).coordinates();
    /// assert!((x - 0.5_f64.sqrt()).abs() < 1e-15 && (y - 0.5_f64.sqrt()).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn interpolate(self, other: Self, t: S) -> Self {
        let mut between = self.reverse() * other;
        if between.scalar().less_than(S::zero()) {
            between = -between;
        }
        self * (between.log() * t).exp()
    }
}

/// `(cos φ − sin φ/φ)/φ²`, by its series where the difference cancels.
fn sine_ratio_slope<S: Real<Mask = bool>>(angle: S, cosine: S, ratio: S) -> S {
    let square = angle * angle;
    if S::from_ratio(1, 16).less_than(square) {
        return (cosine - ratio) / square;
    }
    // −1/3 + φ²/30 − φ⁴/840 + φ⁶/45360 − φ⁸/3991680 + φ¹⁰/518918400
    let coefficients = [
        S::from_ratio(1, 518_918_400),
        S::from_ratio(-1, 3_991_680),
        S::from_ratio(1, 45_360),
        S::from_ratio(-1, 840),
        S::from_ratio(1, 30),
        S::from_ratio(-1, 3),
    ];
    coefficients
        .into_iter()
        .fold(S::zero(), |sum, coefficient| sum * square + coefficient)
}

/// The logarithm of `−1 + ω d`: a whole turn about the axis of the shift.
fn whole_turn<S: Real<Mask = bool>>(d: [S; 3]) -> MotorGenerator<S> {
    let pi = S::from_f64(core::f64::consts::PI);
    match super::vector3::normalized(d) {
        Some(axis) => generator(scaled(axis, pi), d.map(|x| -x)),
        None => generator([pi, S::zero(), S::zero()], [S::zero(); 3]),
    }
}

/// `g + ω h` by blades.
fn generator<S: Field>(g: [S; 3], h: [S; 3]) -> MotorGenerator<S> {
    MotorGenerator::new(g[0], g[1], g[2], -h[2], h[1], -h[0])
}

/// `(q0 + q) + ω (d0 + d)` by blades.
fn assemble<S: Field>(q0: S, q: [S; 3], d0: S, d: [S; 3]) -> Motor<S> {
    Motor::new_unchecked(q0, q[0], q[1], q[2], -d[2], d[1], -d[0], d0)
}
