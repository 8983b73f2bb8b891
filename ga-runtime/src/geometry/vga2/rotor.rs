//! Rotors of vga2.

use crate::geometry::vector2::normalized;
use crate::scalar::{Field, Real};
use crate::vga2::{Bivector, Complex, Rotor, Vector};

impl<S: Field> Rotor<S> {
    /// The complex number of the rotation, `cos θ + sin θ e12`: the square of the reverse. A single
    /// product with it rotates the complex number of a vector; a rotor rotates a vector by two
    /// products.
    #[inline]
    #[must_use]
    pub fn to_complex(self) -> Complex<S> {
        let (c, s) = (self.scalar(), self.e12());
        let cs = c * s;
        Complex::new(c * c - s * s, -(cs + cs))
    }

    /// The rotation matrix by rows: `x' = matrix · x`.
    #[inline]
    #[must_use]
    pub fn to_matrix(self) -> [[S; 2]; 2] {
        let z = self.to_complex();
        [[z.scalar, -z.e12], [z.e12, z.scalar]]
    }
}

impl<S: Real<Mask = bool>> Rotor<S> {
    /// The rotation by an angle in radians, positive from e1 towards e2: `R = cos ½θ − sin ½θ e12`.
    /// `None` where the angle is not finite.
    ///
    /// ```
    /// use ga_runtime::vga2::{Rotor, Vector};
    /// let quarter = Rotor::from_angle(std::f64::consts::FRAC_PI_2).unwrap();
    /// let rotated = quarter.transform(Vector::new(1.0, 0.0));
    /// assert!(rotated.e1.abs() < 1e-15 && (rotated.e2 - 1.0).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn from_angle(angle: S) -> Option<Self> {
        if !angle.is_finite() {
            return None;
        }
        let (sine, cosine) = (angle * S::from_ratio(1, 2)).sin_cos();
        Some(Self::new_unchecked(cosine, -sine))
    }

    /// The angle in [−2π, 2π]; a rotor and its negative rotate to the same orientation, and their
    /// angles differ by 2π.
    #[must_use]
    pub fn angle(self) -> S {
        let half = (-self.e12()).atan2(self.scalar());
        half + half
    }

    /// The shortest rotation from the direction of one vector to that of another; counterclockwise
    /// where they are opposite. `None` where one is zero or not finite.
    #[must_use]
    pub fn between(from: Vector<S>, to: Vector<S>) -> Option<Self> {
        let (a, b) = (
            normalized(from.coordinates())?,
            normalized(to.coordinates())?,
        );
        Self::from_complex(Vector::from(a) * Vector::from(b))
    }

    /// The rotation by the argument of a complex number, in (−π, π]; `None` for zero and for
    /// numbers that are not finite.
    ///
    /// ```
    /// use ga_runtime::vga2::{Complex, Rotor, Vector};
    /// let quarter = Rotor::from_complex(Complex::new(0.0_f64, 3.0)).unwrap();
    /// assert!((quarter.angle() - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn from_complex(number: Complex<S>) -> Option<Self> {
        let [cosine, sine] = normalized([number.scalar, number.e12])?;
        // Both 1 + z and i (1 − z) have half the argument of z; the larger is accurate.
        let half = if !cosine.less_than(S::zero()) {
            [S::one() + cosine, sine]
        } else if sine.less_than(S::zero()) {
            [-sine, cosine - S::one()]
        } else {
            [sine, S::one() - cosine]
        };
        let [cosine, sine] = normalized(half)?;
        Some(Self::new_unchecked(cosine, -sine))
    }

    /// The bivector B with `exp(B) = R`: `−½θ e12` for the rotation by θ, with its coefficient in
    /// [−π, π].
    #[must_use]
    pub fn log(self) -> Bivector<S> {
        Bivector::new(self.e12().atan2(self.scalar()))
    }
}

impl<S: Real<Mask = bool>> Bivector<S> {
    /// The rotor `exp(B)`: for `B = −½θ e12` the rotation by θ. NaN stays NaN.
    #[must_use]
    pub fn exp(self) -> Rotor<S> {
        let (sine, cosine) = self.e12.sin_cos();
        Rotor::new_unchecked(cosine, sine)
    }
}
