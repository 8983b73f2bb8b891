//! Dilators and similarities of cga2.

use crate::cga2::{Dilator, Point, Rotor, Similarity, Translator};
use crate::geometry::number::are_numbers;
use crate::geometry::vector2::{dot, length};
use crate::scalar::Real;

impl<S: Real<Mask = bool>> Dilator<S> {
    /// The scaling by s about the origin, `D = exp(½ ln s · eo∧ei)`; `None` where s is not positive
    /// and finite.
    ///
    /// ```
    /// use ga_runtime::cga2::{Dilator, Point};
    /// let image = Dilator::from_factor(4.0).unwrap().transform(Point::new(1.0, 2.0));
    /// assert_eq!(image.centre(), Some(Point::new(4.0, 8.0)));
    /// // Its weight is 1/s.
    /// assert_eq!(image.eo, 0.25);
    /// ```
    #[must_use]
    pub fn from_factor(factor: S) -> Option<Self> {
        if !S::zero().less_than(factor) || !factor.is_finite() {
            return None;
        }
        let root = factor.sqrt();
        let (inverse, half) = (root.recip(), S::from_ratio(1, 2));
        Some(Self::new_unchecked(
            half * (root + inverse),
            half * (root - inverse),
        ))
    }

    /// The factor s, `(cosh + sinh)²` or `1/(cosh − sinh)²`, whichever is computed without
    /// cancellation.
    #[inline]
    #[must_use]
    pub fn factor(self) -> S {
        let root = self.scalar() + self.eoi().abs();
        let squared = root * root;
        if self.eoi().less_than(S::zero()) {
            squared.recip()
        } else {
            squared
        }
    }
}

impl<S: Real<Mask = bool>> Similarity<S> {
    /// `T R D`: scaling about the origin, then the rotation, then the translation, so that
    /// `x' = s R x + t`. `None` where the factor is not positive and finite, or the displacement is
    /// not finite.
    ///
    /// ```
    /// use ga_runtime::cga2::{Point, Rotor, Similarity};
    /// let quarter = Rotor::from_angle(std::f64::consts::FRAC_PI_2).unwrap();
    /// let similarity = Similarity::from_parts([1.0, 2.0], quarter, 2.0).unwrap();
    /// let image = similarity.transform_point(Point::new(1.0, 0.0));
    /// assert!(image.distance(Point::new(1.0, 4.0)) < 1e-14);
    /// ```
    #[must_use]
    pub fn from_parts(displacement: [S; 2], rotor: Rotor<S>, factor: S) -> Option<Self> {
        let dilator = Dilator::from_factor(factor).filter(|_| are_numbers(displacement))?;
        let motor = |displacement| Translator::from_displacement(displacement) * rotor;
        // In the blades with ei the displacement is multiplied by the factor of D that is below 1
        // in the first form, and above 1 in the second; the one without cancellation is used.
        Some(if factor.less_than(S::one()) {
            motor(displacement) * dilator
        } else {
            dilator * motor(displacement.map(|x| x / factor))
        })
    }

    /// The rotation R of `T R D`.
    #[must_use]
    pub fn rotor(self) -> Rotor<S> {
        let (turn, scaling) = ([self.scalar(), self.e12()], [self.eoi(), self.e12oi()]);
        // R times √s and R times 1/√s: the larger of the two.
        let shrinks = dot(turn, scaling).less_than(S::zero());
        let sign = if shrinks { -S::one() } else { S::one() };
        let scaled = [0, 1].map(|k| turn[k] + scaling[k] * sign);
        let size = length(scaled);
        Rotor::new_unchecked(scaled[0] / size, scaled[1] / size)
    }

    /// The translation of the origin, t in `x' = s R x + t`.
    #[must_use]
    pub fn displacement(self) -> [S; 2] {
        self.transform_point(Point::default()).coordinates()
    }

    /// The image of a point, divided by its weight.
    #[inline]
    #[must_use]
    pub fn transform_point(self, point: Point<S>) -> Point<S> {
        let image = self.transform(point);
        Point::new(image.e1 / image.eo, image.e2 / image.eo)
    }

    /// The power: for a rotation by θ in [−2π, 2π] and a scaling by s about a fixed point, the
    /// rotation by tθ and the scaling by `sᵗ` about the same point; for a translation, t times the
    /// translation. `None` for minus a translation other than the identity, where t is not finite,
    /// and where the power is beyond the range of the scalar.
    ///
    /// As complex numbers the map is `z ↦ a z + b` with `a = s exp(iθ)`, and its power is
    /// `z ↦ aᵗ z + b (aᵗ − 1)/(a − 1)`.
    #[must_use]
    pub fn powf(self, t: S) -> Option<Self> {
        let (angle, factor, ends) = (self.rotor().angle(), self.factor(), self.displacement());
        let (whole, part) = (
            exponential_less_one(factor.ln(), angle),
            exponential_less_one(factor.ln() * t, angle * t),
        );
        let size = length(whole);
        let rounding = S::epsilon() * S::from_integer(16);
        let is_full_turn = S::one().less_than(angle.abs()) && size.less_than(rounding);
        if is_full_turn && ends != [S::zero(); 2] {
            return None;
        }
        let ratio = if S::zero().less_than(size) && !is_full_turn {
            let [x, y] = whole.map(|x| x / size);
            [dot(part, [x, y]) / size, dot(part, [-y, x]) / size]
        } else {
            [t, S::zero()]
        };
        let displacement = [
            ends[0] * ratio[0] - ends[1] * ratio[1],
            ends[0] * ratio[1] + ends[1] * ratio[0],
        ];
        let rotor = Rotor::from_angle(angle * t)?;
        Self::from_parts(displacement, rotor, (factor.ln() * t).exp())
    }

    /// The interpolation from `self` at t = 0 to `other` at t = 1, `A (~A B)ᵗ`, by the shorter
    /// rotation: points move along logarithmic spirals about the fixed point, and the factor
    /// changes by equal ratios in equal times. t may be outside [0, 1]. `None` where a number is
    /// not finite, or the result is beyond the range of the scalar.
    ///
    /// ```
    /// use ga_runtime::cga2::{Dilator, Similarity};
    /// let grown = Dilator::from_factor(4.0).unwrap().into();
    /// let middle = Similarity::default().interpolate(grown, 0.5).unwrap();
    /// let factor: f64 = middle.factor();
    /// assert!((factor - 2.0).abs() < 1e-14);
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

    /// The factor s by which all lengths are multiplied.
    ///
    /// ```
    /// use ga_runtime::cga2::{Dilator, Rotor, Translator};
    /// let motor = Translator::from_displacement([1.0, 2.0]) * Rotor::from_angle(0.5).unwrap();
    /// let similarity = motor * Dilator::from_factor(4.0).unwrap();
    /// assert!((similarity.factor() - 4.0_f64).abs() < 1e-14);
    /// ```
    #[must_use]
    pub fn factor(self) -> S {
        // (scalar, e12) is a rotor times cosh, (eoi, e12oi) the same times sinh.
        let (c, s) = ([self.scalar(), self.e12()], [self.eoi(), self.e12oi()]);
        let cross = dot(c, s);
        let squared = dot(c, c) + dot(s, s) + (cross.abs() + cross.abs());
        if cross.less_than(S::zero()) {
            squared.recip()
        } else {
            squared
        }
    }
}

/// `exp(x + iy) − 1` without cancellation near zero, as real and imaginary part:
/// `eˣ − 1 − 2 eˣ sin² ½y` and `eˣ sin y`.
fn exponential_less_one<S: Real<Mask = bool>>(x: S, y: S) -> [S; 2] {
    let exponential = x.exp();
    let difference = exponential - S::one();
    // (u − 1) x / ln u for u = eˣ (Higham, Accuracy and Stability of Numerical Algorithms, 2002,
    // 1.14.1).
    let logarithm = exponential.ln();
    let real = if logarithm == S::zero() {
        x
    } else {
        difference * (x / logarithm)
    };
    let (half_sine, _) = (y * S::from_ratio(1, 2)).sin_cos();
    let (sine, _) = y.sin_cos();
    let drop = exponential * half_sine * half_sine;
    [real - (drop + drop), exponential * sine]
}
