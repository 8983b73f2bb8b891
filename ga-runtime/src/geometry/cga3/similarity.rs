//! Similarities: composition from parts, decomposition, powers and interpolation.
//!
//! Matrices are in [`homogeneous`](super::homogeneous).

use super::affine::{self, Affine};
use crate::Element;
use crate::cga3::{Even, EvenVersor, Motor, Point, Quaternion, Rotor, Similarity, Translator};
use crate::geometry::number::are_numbers;
use crate::scalar::{Maybe, Optional, Real};
use crate::vga3::Vector;

crate::__private::surface! { { renormalized Similarity } }

impl<S: Real> Similarity<S> {
    /// The similarity nearest to a sum of similarities, or to a similarity whose norm has drifted
    /// in a long chain of products: `V (V ~V)^(−½)`, as for [`EvenVersor::normalize`]. Coefficients
    /// of blades that similarities do not have are dropped. `None` where there is no such
    /// similarity, as for zero, or where a coefficient is not finite.
    ///
    /// ```
    /// use ga_runtime::cga3::{Even, Rotor, Similarity};
    /// let similarity =
    ///     Similarity::from_parts([1.0, 2.0, 3.0], Rotor::default(), 4.0_f64).unwrap();
    /// let again = Similarity::normalize(Even::from(similarity) * 1.5).unwrap();
    /// assert!((again.factor() - 4.0).abs() < 1e-14);
    /// ```
    #[must_use]
    pub fn normalize(sum: Even<S>) -> Maybe<Self, S> {
        let part = |element: Even<S>| -> Self {
            Self::from_coefficients_unchecked(&mut |blade| element.coefficient(blade))
        };
        EvenVersor::normalize(Even::from(part(sum))).map(|unit| part(unit.into()))
    }
}

impl<S: Real<Mask = bool>> Similarity<S> {
    /// `T R D`: scaling about the origin, then the rotation, then the translation, so that
    /// `x' = s R x + t`. `None` where the factor is not positive and finite, or the displacement is
    /// not finite.
    ///
    /// ```
    /// use ga_runtime::cga3::{Point, Rotor, Similarity};
    /// let quarter = Rotor::from_axis_angle([0.0, 0.0, 1.0], std::f64::consts::FRAC_PI_2).unwrap();
    /// let similarity = Similarity::from_parts([1.0, 2.0, 3.0], quarter, 2.0).unwrap();
    /// let [x, y, z] = similarity.transform_point(Point::new(1.0, 0.0, 0.0)).coordinates();
    /// assert!((x - 1.0).abs() < 1e-14 && (y - 4.0).abs() < 1e-14 && (z - 3.0).abs() < 1e-14);
    /// ```
    #[must_use]
    pub fn from_parts(displacement: [S; 3], rotor: Rotor<S>, factor: S) -> Option<Self> {
        if !are_numbers(displacement) || !S::zero().less_than(factor) {
            return None;
        }
        affine::similarity(rotor, factor, displacement).ok()
    }

    /// The factor s of `T R D`.
    ///
    /// ```
    /// use ga_runtime::cga3::{Rotor, Similarity};
    /// let similarity =
    ///     Similarity::from_parts([1.0, 2.0, 3.0], Rotor::default(), 1e-6_f64).unwrap();
    /// assert!((similarity.factor() / 1e-6 - 1.0).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn factor(self) -> S {
        let (turn, is_growth) = self.scaled_rotor();
        let size = quaternion_length(turn);
        let square = size * size;
        if is_growth { square } else { square.recip() }
    }

    /// The motion `T R` of `T R D`, which is applied after the scaling about the origin.
    ///
    /// ```
    /// use ga_runtime::cga3::{Motor, Rotor, Similarity, Translator};
    /// let rotation = Rotor::from_axis_angle([1.0, 2.0, 3.0], 0.7).unwrap();
    /// let similarity = Similarity::from_parts([1.0, 2.0, 3.0], rotation, 5.0).unwrap();
    /// let expected: Motor<f64> = Translator::from_displacement([1.0, 2.0, 3.0]) * rotation;
    /// assert!((similarity.motor().e123i() - expected.e123i()).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn motor(self) -> Motor<S> {
        Translator::from_displacement(self.displacement()) * self.rotor()
    }

    /// The rotation R of `T R D`.
    #[must_use]
    pub fn rotor(self) -> Rotor<S> {
        let (turn, _) = self.scaled_rotor();
        let unit = turn * quaternion_length(turn).recip();
        Rotor::new_unchecked(unit.scalar, unit.e12, unit.e13, unit.e23)
    }

    /// The translation of the origin, t in `x' = s R x + t`.
    #[must_use]
    pub fn displacement(self) -> [S; 3] {
        Affine::from(self).translation
    }

    /// The fixed point, about which the similarity rotates and scales; `None` where the factor is 1
    /// or so close to 1 that the point is beyond the range of the scalar.
    ///
    /// ```
    /// use ga_runtime::cga3::{Point, Rotor, Similarity};
    /// let similarity = Similarity::from_parts([1.0, 0.0, 0.0], Rotor::default(), 0.5).unwrap();
    /// let [x, y, z]: [f64; 3] = similarity.fixed_point().unwrap().coordinates();
    /// assert!((x - 2.0).abs() < 1e-14 && y.abs() < 1e-14 && z.abs() < 1e-14);
    /// ```
    #[must_use]
    pub fn fixed_point(self) -> Option<Point<S>> {
        // (1 − s R) c = t. Along the axis n of R that is (1 − s) (n·c) = n·t; perpendicular to it R
        // acts as a complex number of absolute value 1.
        let (factor, zero, one) = (self.factor(), S::zero(), S::one());
        let (vector, w) = self.rotor().to_quaternion();
        let t = self.displacement();
        let shrunk = one - factor;
        if shrunk.is_zero() {
            return None;
        }
        let (vector, t) = (Vector::from(vector), Vector::from(t));
        let half_sine = vector.length();
        let axis = vector.normalized().unwrap_or(Vector::new(zero, zero, one));
        let along = axis.dot(t);
        let rest = t - axis * along;
        let along = if along.is_zero() {
            zero
        } else {
            along / shrunk
        };
        // 1 − s cos θ, computed without cancellation, and s sin θ.
        let two = one + one;
        let real = shrunk + two * factor * half_sine * half_sine;
        let imaginary = two * factor * w * half_sine;
        let size = real * real + imaginary * imaginary;
        let turned = axis.cross(rest);
        let coordinates =
            [0, 1, 2].map(|k| axis[k] * along + (real * rest[k] + imaginary * turned[k]) / size);
        are_numbers(coordinates).then(|| Point::from(coordinates))
    }

    /// The image of a point, divided by its weight.
    ///
    /// ```
    /// use ga_runtime::cga3::{Dilator, Point};
    /// let double = Dilator::from_factor(2.0_f64).unwrap().about(Point::new(1.0, 0.0, 0.0));
    /// let [x, y, z] = double.transform_point(Point::new(2.0, 1.0, 0.0)).coordinates();
    /// assert!((x - 3.0).abs() < 1e-14 && (y - 2.0).abs() < 1e-14 && z == 0.0);
    /// ```
    #[inline]
    #[must_use]
    pub fn transform_point(self, point: Point<S>) -> Point<S> {
        let image = self.transform(point);
        Point::new(
            image.e1 / image.eo,
            image.e2 / image.eo,
            image.e3 / image.eo,
        )
    }

    /// The similarity with half the logarithm; see [`log`](Self::log). `None` as for
    /// [`powf`](Self::powf).
    #[must_use]
    pub fn sqrt(self) -> Option<Self> {
        self.powf(S::from_ratio(1, 2))
    }

    /// The power `exp(t log)`. `None` where t is not finite, or the power is beyond the range of
    /// the scalar.
    #[must_use]
    pub fn powf(self, t: S) -> Option<Self> {
        (self.log() * t).exp()
    }

    /// The interpolation from `self` at t = 0 to `other` at t = 1, `A exp(t log(~A B))`, by the
    /// shorter rotation: points move along logarithmic spirals about the fixed point, and the
    /// factor changes by equal ratios in equal times. `None` as for [`powf`](Self::powf).
    ///
    /// ```
    /// use ga_runtime::cga3::{Dilator, Similarity};
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

    /// R times √s where that is more than 1, otherwise R times 1/√s, and whether it is the former.
    fn scaled_rotor(self) -> (Quaternion<S>, bool) {
        let even = Quaternion::new(self.scalar(), self.e12(), self.e13(), self.e23());
        let odd = Quaternion::new(self.eoi(), self.e12oi(), self.e13oi(), self.e23oi());
        let products = [
            even.scalar * odd.scalar,
            even.e12 * odd.e12,
            even.e13 * odd.e13,
            even.e23 * odd.e23,
        ];
        let sign = products[0] + products[1] + products[2] + products[3];
        if sign.less_than(S::zero()) {
            (even - odd, false)
        } else {
            (even + odd, true)
        }
    }
}

fn quaternion_length<S: Real<Mask = bool>>(q: Quaternion<S>) -> S {
    let part = Vector::new(q.scalar, q.e12, q.e13).length();
    Vector::new(part, q.e23, S::zero()).length()
}
