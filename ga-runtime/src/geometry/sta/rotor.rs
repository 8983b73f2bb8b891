//! Lorentz transformations of spacetime as rotors.

use super::complex::{Complex, sinh_cosh};
use super::velocity::{NotSlowerThanLight, lorentz_factor};
use crate::geometry::number::are_numbers;
use crate::scalar::Real;
use crate::sta::{Bivector, Rotor, Vector};
use crate::vga3;

impl<S: Real<Mask = bool>> Rotor<S> {
    /// The boost from rest to a velocity: it maps g0 to the proper velocity `γ (g0 + v)`. Along v
    /// it is `cosh ½φ + sinh ½φ σ` with the rapidity `φ = artanh |v|`.
    ///
    /// # Errors
    ///
    /// [`NotSlowerThanLight`] where |v| is not below 1, or is NaN.
    ///
    /// ```
    /// use ga_runtime::sta::{Rotor, Vector};
    /// let boost = Rotor::from_velocity([0.0, 0.8, 0.0]).unwrap();
    /// let moved = boost.transform(Vector::from_time_place(3.0, [0.0; 3]));
    /// assert!((moved.g0 - 5.0_f64).abs() < 1e-14 && (moved.g2 - 4.0).abs() < 1e-14);
    /// assert!(Rotor::from_velocity([0.8, 0.8, 0.0]).is_err());
    /// ```
    pub fn from_velocity(velocity: [S; 3]) -> Result<Self, NotSlowerThanLight<S>> {
        let gamma = lorentz_factor(velocity).ok_or(NotSlowerThanLight { velocity })?;
        let half = S::from_ratio(1, 2);
        // cosh ½φ = √(½(γ + 1)), and sinh ½φ = ½ sinh φ / cosh ½φ with sinh φ = γ|v|.
        let cosh = ((gamma + S::one()) * half).sqrt();
        let sinh = velocity.map(|x| x * (gamma * half / cosh));
        Ok(Self::boost(cosh, sinh))
    }

    /// The boost by a rapidity in a direction, which need not have length 1; rapidities in one
    /// direction add. `None` where the direction is zero or not finite, or the rapidity is not
    /// finite or beyond the range of the scalar.
    ///
    /// ```
    /// use ga_runtime::sta::Rotor;
    /// let boost = Rotor::from_rapidity([0.0, 0.0, 2.0], 1.5).unwrap();
    /// let [_, _, z]: [f64; 3] = boost.velocity();
    /// assert!((z - 1.5_f64.tanh()).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn from_rapidity(direction: [S; 3], rapidity: S) -> Option<Self> {
        let axis = vga3::Vector::from(direction).normalized()?;
        let (sinh, cosh) = sinh_cosh(rapidity * S::from_ratio(1, 2));
        let sinh = axis * sinh;
        let usable = cosh.is_finite() && sinh.is_finite();
        usable.then(|| Self::boost(cosh, sinh.into()))
    }

    /// The rotation of space by an angle in radians about an axis, right-handed:
    /// `cos ½θ − sin ½θ I n`. The axis need not have length 1; `None` where it is zero or not
    /// finite, or the angle is not finite.
    #[must_use]
    pub fn from_axis_angle(axis: [S; 3], angle: S) -> Option<Self> {
        if !angle.is_finite() {
            return None;
        }
        let (sine, cosine) = (angle * S::from_ratio(1, 2)).sin_cos();
        let axis = vga3::Vector::from(axis).normalized()? * -sine;
        Some(Self::rotation(cosine, axis.into()))
    }

    /// The velocity that a body at rest has after the transformation: that of `R g0 ~R`. For very
    /// large rapidities its size is rounded to 1.
    #[must_use]
    pub fn velocity(self) -> [S; 3] {
        let one = Vector::new(S::one(), S::zero(), S::zero(), S::zero());
        let image = self.transform(one);
        image.place().map(|x| x / image.time())
    }

    /// The rotation U and the boost L with `R = L U`: first the rotation, then the boost by
    /// [`velocity`](Self::velocity).
    ///
    /// The product of two boosts in different directions contains a rotation, the Wigner rotation.
    ///
    /// ```
    /// use ga_runtime::sta::Rotor;
    /// let (a, b) = ([0.6, 0.0, 0.0], [0.0, 0.6, 0.0]);
    /// let both = Rotor::from_velocity(a).unwrap() * Rotor::from_velocity(b).unwrap();
    /// let (boost, rotation): (Rotor<f64>, Rotor<f64>) = both.boost_and_rotation();
    /// // tan ½θ = sinh ½φ sinh ½χ / (cosh ½φ cosh ½χ) for perpendicular boosts.
    /// assert!(((rotation.g21() / rotation.scalar()).abs() - 1.0 / 9.0).abs() < 1e-15);
    /// assert!(((boost * rotation).g0123() - both.g0123()).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn boost_and_rotation(self) -> (Self, Self) {
        // With L = c + s n the part of R that commutes with g0 is c U.
        let vector = [self.g32(), self.g13(), self.g21()];
        let cosh = hypotenuse(vga3::Vector::from(vector).length(), self.scalar());
        let rotation = Self::rotation(self.scalar() / cosh, vector.map(|x| x / cosh));
        let boost = self * rotation.reverse();
        (
            Self::boost(cosh, [boost.g10(), boost.g20(), boost.g30()]),
            rotation,
        )
    }

    /// The former name of [`boost_and_rotation`](Self::boost_and_rotation).
    #[deprecated(note = "renamed to `boost_and_rotation`")]
    #[must_use]
    pub fn boost_and_turn(self) -> (Self, Self) {
        self.boost_and_rotation()
    }

    /// A bivector F with `exp(F) = R`, including the sign of R. The logarithm of −1 is `π g21`.
    /// `None` for the negative of the exponential of a null bivector, which has no logarithm, and
    /// where a number is not finite; null means here that `|F²|` is below `8 ε |F|²`.
    ///
    /// ```
    /// use ga_runtime::sta::{Bivector, Rotor};
    /// let field = Bivector::from_fields([0.3_f64, 0.2, 0.0], [0.0, 0.5, 1.0]);
    /// let again = field.exp().unwrap().log().unwrap();
    /// assert!((again.g10 - 0.3).abs() < 1e-15 && (again.g21 - 1.0).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn log(self) -> Option<Bivector<S>> {
        let cosine = Complex::new(self.scalar(), self.g0123());
        let whole = Bivector::from_fields(
            [self.g10(), self.g20(), self.g30()],
            [self.g32(), self.g13(), self.g21()],
        );
        let [electric, magnetic] = [whole.electric(), whole.magnetic()].map(vga3::Vector::from);
        let size = hypotenuse(electric.length(), magnetic.length());
        if !size.is_finite() || !cosine.modulus().is_finite() {
            return None;
        }
        let is_negative = cosine.real.less_than(S::zero());
        if !S::zero().less_than(size) {
            let pi = S::from_f64(core::f64::consts::PI);
            let turn = if is_negative { pi } else { S::zero() };
            return Some(Bivector::from_fields(
                [S::zero(); 3],
                [S::zero(), S::zero(), turn],
            ));
        }
        // Scaled, so that no square is beyond the range of the scalar.
        let unit = whole / size;
        let square = unit.square();
        let least = S::epsilon() * S::from_integer(8);
        if is_negative && square.modulus().less_than(least) {
            return None;
        }
        // w² is the square of the bivector part and also C² − 1; of both the one with less rounding
        // error is used, which for a null F is the second.
        let (one, modulus) = (S::one(), cosine.modulus());
        let mut sine = if (one + modulus * (modulus + size)).less_than(size * size) {
            let below = Complex::new(cosine.real - one, cosine.imaginary);
            let above = Complex::new(cosine.real + one, cosine.imaginary);
            below.times(above).root()
        } else {
            let root = square.root();
            Complex::new(root.real * size, root.imaginary * size)
        };
        // The sign for which |C + w| is at least one.
        if (cosine.real * sine.real + cosine.imaginary * sine.imaginary).less_than(S::zero()) {
            sine = sine.negative();
        }
        let ratio = cosine.arcosh_over_sinh(sine);
        let log = whole.times(ratio);
        let usable = are_numbers(log.electric()) && are_numbers(log.magnetic());
        usable.then_some(log)
    }

    pub(super) fn boost(cosh: S, [x, y, z]: [S; 3]) -> Self {
        let zero = S::zero();
        Self::new_unchecked(cosh, x, y, z, zero, zero, zero, zero)
    }

    pub(super) fn rotation(cosine: S, [x, y, z]: [S; 3]) -> Self {
        let zero = S::zero();
        Self::new_unchecked(cosine, zero, zero, zero, x, y, z, zero)
    }
}

/// `√(a² + b²)` without intermediate overflow or underflow.
fn hypotenuse<S: Real>(a: S, b: S) -> S {
    vga3::Vector::new(a, b, S::zero()).length()
}
