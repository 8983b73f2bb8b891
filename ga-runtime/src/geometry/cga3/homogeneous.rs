//! The transformations of homogeneous coordinates, as 4×4 matrices and as versors.
//!
//! A point x is the column `(x, y, z, 1)`, a matrix is an array of rows, and `x' = M x`; so the
//! matrix of a composition is the product of the matrices, with the one applied first on the right,
//! as with versors. These are the equations 3 to 11 of Cui:
//!
//! | transformation | matrix | versor |
//! | --- | --- | --- |
//! | translation (3, 4) | [`translation`] | [`Translator::from_displacement`] |
//! | rotation about x (5, 6) | [`rotation_about_x`] | [`Rotor::about_x`] |
//! | rotation about y (7) | [`rotation_about_y`] | [`Rotor::about_y`] |
//! | rotation about z (8) | [`rotation_about_z`] | [`Rotor::about_z`] |
//! | rotation about an axis through the origin (9) | [`rotation`] | [`Rotor::from_axis_angle`] |
//! | rotation about an axis through a point | [`rotation_about_axis`] | [`Motor::about_axis`] |
//! | uniform scaling (10, 11) | [`scaling`] | [`Dilator::from_factor`] |
//! | uniform scaling about a point | [`scaling_about`] | [`Dilator::about`] |
//! | scaling along each axis (10, 11) | [`scaling`], [`scaling_about`] | none |
//!
//! Equation 9 holds for an axis of length 1; here the axis may have any length and is normalised.
//! The last transformation has no versor because it is not a conformal map: it maps spheres to
//! ellipsoids and changes angles. [`Affine`] is the type for it, and for all other affine maps.
//!
//! `to_homogeneous` and `from_homogeneous` convert [`Translator`], [`Rotor`], [`Motor`],
//! [`Dilator`] and [`Similarity`] to the matrix and back. A versor and its negative have the same
//! matrix; the versor of a matrix has a positive scalar part or, where that is zero, another
//! coefficient that is positive. For a matrix that is only nearly that of a versor,
//! [`Affine::nearest_motion`] and [`Affine::nearest_similarity`] find the nearest one.
//!
//! ```
//! use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
//! use ga_runtime::geometry::homogeneous::{product, rotation_about_z, transform, translation};
//!
//! let angle = 0.3;
//! let matrix = product(
//!     translation([1.0, 2.0, 3.0]),
//!     rotation_about_z(angle).unwrap(),
//! );
//! let motor: Motor<f64> =
//!     Translator::from_displacement([1.0, 2.0, 3.0]) * Rotor::about_z(angle).unwrap();
//!
//! let p = Point::new(0.5, -1.0, 2.0);
//! assert!(transform(matrix, p).unwrap().distance(motor.transform(p)) < 1e-15);
//! assert!((Motor::from_homogeneous(matrix).unwrap().e12() - motor.e12()).abs() < 1e-15);
//! ```

use super::affine::{Affine, NotConformal};
use crate::cga3::{Dilator, Motor, Point, Rotor, Similarity, Translator};
use crate::geometry::number::{are_numbers, is_finite_number};
use crate::scalar::{Field, Real, Ring};
use crate::vga3::Vector;

/// A 4×4 matrix by rows.
pub type Matrix<S> = [[S; 4]; 4];

/// The matrix of the translation by t (Cui, eqs. 3 and 4). A number that is not finite is passed on
/// to the matrix, as in all functions here that do not return an `Option`.
#[inline]
#[must_use]
pub fn translation<S: Ring>(displacement: [S; 3]) -> Matrix<S> {
    Affine::from_translation(displacement).to_homogeneous()
}

/// The matrix of the rotation about the x axis, right-handed, by an angle in radians (Cui, eqs. 5
/// and 6): from y to z. `None` where the angle is not finite.
#[must_use]
pub fn rotation_about_x<S: Real<Mask = bool>>(angle: S) -> Option<Matrix<S>> {
    let (sine, cosine) = sine_and_cosine(angle)?;
    let (zero, one) = (S::zero(), S::one());
    Some(linear([
        [one, zero, zero],
        [zero, cosine, -sine],
        [zero, sine, cosine],
    ]))
}

/// The matrix of the rotation about the y axis, right-handed, by an angle in radians (Cui, eq. 7):
/// from z to x. `None` where the angle is not finite.
#[must_use]
pub fn rotation_about_y<S: Real<Mask = bool>>(angle: S) -> Option<Matrix<S>> {
    let (sine, cosine) = sine_and_cosine(angle)?;
    let (zero, one) = (S::zero(), S::one());
    Some(linear([
        [cosine, zero, sine],
        [zero, one, zero],
        [-sine, zero, cosine],
    ]))
}

/// The matrix of the rotation about the z axis, right-handed, by an angle in radians (Cui, eq. 8):
/// from x to y. `None` where the angle is not finite.
#[must_use]
pub fn rotation_about_z<S: Real<Mask = bool>>(angle: S) -> Option<Matrix<S>> {
    let (sine, cosine) = sine_and_cosine(angle)?;
    let (zero, one) = (S::zero(), S::one());
    Some(linear([
        [cosine, -sine, zero],
        [sine, cosine, zero],
        [zero, zero, one],
    ]))
}

/// The matrix of the rotation about an axis through the origin, right-handed, by an angle in
/// radians (Cui, eq. 9). `None` where the axis is zero, or the axis or the angle is not finite.
///
/// ```
/// use ga_runtime::geometry::homogeneous::rotation;
/// // A third of a full turn about the diagonal maps x to y, y to z and z to x.
/// let [x, y, z, _] = rotation([1.0, 1.0, 1.0], std::f64::consts::TAU / 3.0).unwrap();
/// assert!((y[0] - 1.0).abs() < 1e-15 && (z[1] - 1.0).abs() < 1e-15 && (x[2] - 1.0).abs() < 1e-15);
/// assert_eq!(rotation([0.0; 3], 0.7), None);
/// ```
#[must_use]
pub fn rotation<S: Real<Mask = bool>>(axis: [S; 3], angle: S) -> Option<Matrix<S>> {
    let [x, y, z] = Vector::from(axis).normalized()?.coordinates();
    let (sine, cosine) = sine_and_cosine(angle)?;
    let rest = S::one() - cosine;
    Some(linear([
        [
            x * x * rest + cosine,
            x * y * rest - z * sine,
            x * z * rest + y * sine,
        ],
        [
            x * y * rest + z * sine,
            y * y * rest + cosine,
            y * z * rest - x * sine,
        ],
        [
            x * z * rest - y * sine,
            y * z * rest + x * sine,
            z * z * rest + cosine,
        ],
    ]))
}

/// The matrix of the rotation about an axis through a point p, `T(p) R T(−p)`:
/// `x' = p + R (x − p)`. `None` as for [`rotation`], and where the point is not finite.
#[must_use]
pub fn rotation_about_axis<S: Real<Mask = bool>>(
    point: Point<S>,
    axis: [S; 3],
    angle: S,
) -> Option<Matrix<S>> {
    let (there, back) = (point.coordinates(), point.coordinates().map(|x| -x));
    if !are_numbers(there) {
        return None;
    }
    let turned = product(rotation(axis, angle)?, translation(back));
    Some(product(translation(there), turned))
}

/// The matrix of the scaling by a factor along each axis about the origin (Cui, eqs. 10 and 11).
#[inline]
#[must_use]
pub fn scaling<S: Ring>(factors: [S; 3]) -> Matrix<S> {
    Affine::scaling(factors).to_homogeneous()
}

/// The matrix of the scaling by a factor along each axis about a point p: `x' = p + s (x − p)` in
/// each coordinate.
#[inline]
#[must_use]
pub fn scaling_about<S: Ring>(point: Point<S>, factors: [S; 3]) -> Matrix<S> {
    Affine::scaling_about(point, factors).to_homogeneous()
}

/// The matrix product: the transformation `first`, then `second`.
#[must_use]
pub fn product<S: Ring>(second: Matrix<S>, first: Matrix<S>) -> Matrix<S> {
    second.map(|[a, b, c, d]| {
        core::array::from_fn(|k| {
            a * first[0][k] + b * first[1][k] + c * first[2][k] + d * first[3][k]
        })
    })
}

/// The image of a point: `M (x, 1)` divided by its last coordinate, which is 1 for all matrices
/// here but may not be for others. `None` where that is zero or the image is not finite.
#[must_use]
pub fn transform<S: Field>(matrix: Matrix<S>, point: Point<S>) -> Option<Point<S>> {
    let [x, y, z] = point.coordinates();
    let [a, b, c, weight] = matrix.map(|[a, b, c, d]| a * x + b * y + c * z + d);
    if !weight.is_invertible() {
        return None;
    }
    let image = [a / weight, b / weight, c / weight];
    let is_finite = image.into_iter().all(is_finite_number);
    is_finite.then(|| Point::from(image))
}

impl<S: Real<Mask = bool>> Rotor<S> {
    /// The rotation about the x axis, right-handed, by an angle in radians: `cos ½θ − sin ½θ e23`.
    /// `None` where the angle is not finite.
    #[inline]
    #[must_use]
    pub fn about_x(angle: S) -> Option<Self> {
        let (sine, cosine) = half(angle)?;
        let zero = S::zero();
        Some(Self::new_unchecked(cosine, zero, zero, -sine))
    }

    /// The rotation about the y axis, right-handed, by an angle in radians: `cos ½θ + sin ½θ e13`.
    /// `None` where the angle is not finite.
    #[inline]
    #[must_use]
    pub fn about_y(angle: S) -> Option<Self> {
        let (sine, cosine) = half(angle)?;
        let zero = S::zero();
        Some(Self::new_unchecked(cosine, zero, sine, zero))
    }

    /// The rotation about the z axis, right-handed, by an angle in radians: `cos ½θ − sin ½θ e12`.
    /// `None` where the angle is not finite.
    #[inline]
    #[must_use]
    pub fn about_z(angle: S) -> Option<Self> {
        let (sine, cosine) = half(angle)?;
        let zero = S::zero();
        Some(Self::new_unchecked(cosine, -sine, zero, zero))
    }

    /// The rotor of a 4×4 matrix by rows.
    ///
    /// # Errors
    /// The matrix is not a rotation about an axis through the origin, within √ε in its
    /// entries; the last column and row must be exact.
    pub fn from_homogeneous(rows: Matrix<S>) -> Result<Self, NotConformal> {
        let motor = Motor::from_homogeneous(rows)?;
        if has_translation(rows) {
            return Err(NotConformal::Translates);
        }
        Ok(motor.rotor())
    }
}

impl<S: Ring> Rotor<S> {
    /// The 4×4 matrix by rows: `(x', 1) = M (x, 1)`.
    #[inline]
    #[must_use]
    pub fn to_homogeneous(self) -> Matrix<S> {
        Affine::from(self).to_homogeneous()
    }
}

impl<S: Field> Translator<S> {
    /// The 4×4 matrix by rows: `(x', 1) = M (x, 1)`. For floating-point numbers it is exact, and so
    /// is the conversion back.
    ///
    /// ```
    /// use ga_runtime::cga3::Translator;
    /// let translation = Translator::from_displacement([1.0, 2.0, 0.1]);
    /// assert_eq!(Translator::from_homogeneous(translation.to_homogeneous()), Ok(translation));
    /// ```
    #[inline]
    #[must_use]
    pub fn to_homogeneous(self) -> Matrix<S> {
        Affine::from(self).to_homogeneous()
    }
}

impl<S: Real<Mask = bool>> Translator<S> {
    /// The translator of a 4×4 matrix by rows.
    ///
    /// # Errors
    /// The matrix is not a translation, within √ε in its entries; the last row must be exact.
    pub fn from_homogeneous(rows: Matrix<S>) -> Result<Self, NotConformal> {
        let map = Affine::from_homogeneous(rows)?;
        Motor::try_from(map)?;
        if turns(map.linear, S::one()) {
            return Err(NotConformal::Rotates);
        }
        Ok(Self::from_displacement(map.translation))
    }
}

impl<S: Field> Motor<S> {
    /// The 4×4 matrix by rows: `(x', 1) = M (x, 1)`.
    #[inline]
    #[must_use]
    pub fn to_homogeneous(self) -> Matrix<S> {
        Affine::from(self).to_homogeneous()
    }
}

impl<S: Real<Mask = bool>> Motor<S> {
    /// The rotation about an axis through a point p, right-handed, by an angle in radians:
    /// `T(p) R T(−p)`. The axis need not have length 1; `None` where it is zero, or a number is not
    /// finite.
    ///
    /// ```
    /// use ga_runtime::cga3::{Motor, Point};
    /// let half_turn = Motor::about_axis(
    ///     Point::new(1.0, 0.0, 0.0),
    ///     [0.0, 0.0, 1.0],
    ///     std::f64::consts::PI,
    /// )
    /// .unwrap();
    /// assert!(
    ///     half_turn
    ///         .transform(Point::new(3.0, 0.0, 5.0))
    ///         .distance(Point::new(-1.0, 0.0, 5.0))
    ///         < 1e-15
    /// );
    /// ```
    #[must_use]
    pub fn about_axis(point: Point<S>, axis: [S; 3], angle: S) -> Option<Self> {
        if !are_numbers(point.coordinates()) {
            return None;
        }
        Some(Self::about(point, Rotor::from_axis_angle(axis, angle)?))
    }

    /// The motor of a 4×4 matrix by rows.
    ///
    /// # Errors
    /// The matrix is not a rigid motion within √ε in its entries; the last row must be exact.
    pub fn from_homogeneous(rows: Matrix<S>) -> Result<Self, NotConformal> {
        Affine::from_homogeneous(rows)?.try_into()
    }
}

impl<S: Real<Mask = bool>> Dilator<S> {
    /// The scaling about a point p instead of the origin: `T(p) D T(−p) = D + s p ei` for
    /// `D = c + s eo∧ei`. A coordinate that is not finite is passed on to the coefficients.
    ///
    /// ```
    /// use ga_runtime::cga3::{Dilator, Point};
    /// let double = Dilator::from_factor(4.0).unwrap().about(Point::new(1.0, 0.0, 0.0));
    /// let image = double.transform(Point::new(2.0, 0.0, 0.0)).centre().unwrap();
    /// assert_eq!(image, Point::new(5.0, 0.0, 0.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn about(self, point: Point<S>) -> Similarity<S> {
        let (scalar, eoi, zero) = (self.scalar(), self.eoi(), S::zero());
        let [x, y, z] = point.coordinates().map(|x| x * eoi);
        Similarity::new_unchecked(
            scalar, zero, zero, zero, x, y, z, zero, eoi, zero, zero, zero,
        )
    }

    /// The 4×4 matrix by rows: `(x', 1) = M (x, 1)`.
    #[inline]
    #[must_use]
    pub fn to_homogeneous(self) -> Matrix<S> {
        Affine::from(self).to_homogeneous()
    }

    /// The dilator of a 4×4 matrix by rows.
    ///
    /// # Errors
    /// The matrix is not a scaling by one positive factor about the origin, within √ε of it in its
    /// entries; the last column and row must be exact.
    pub fn from_homogeneous(rows: Matrix<S>) -> Result<Self, NotConformal> {
        let map = Affine::from_homogeneous(rows)?;
        let (_, factor) = map.rotation_and_factor()?;
        if has_translation(rows) {
            return Err(NotConformal::Translates);
        }
        if turns(map.linear, factor) {
            return Err(NotConformal::Rotates);
        }
        Self::from_factor(factor).ok_or(NotConformal::NotFinite)
    }
}

impl<S: Real<Mask = bool>> Similarity<S> {
    /// The 4×4 matrix by rows: `(x', 1) = M (x, 1)`.
    #[inline]
    #[must_use]
    pub fn to_homogeneous(self) -> Matrix<S> {
        Affine::from(self).to_homogeneous()
    }

    /// The similarity of a 4×4 matrix by rows.
    ///
    /// # Errors
    /// The matrix is not a motion with a scaling by one positive factor, within √ε of it in its
    /// entries; the last row must be exact.
    pub fn from_homogeneous(rows: Matrix<S>) -> Result<Self, NotConformal> {
        Affine::from_homogeneous(rows)?.try_into()
    }
}

fn sine_and_cosine<S: Real<Mask = bool>>(angle: S) -> Option<(S, S)> {
    angle.is_finite().then(|| angle.sin_cos())
}

fn half<S: Real<Mask = bool>>(angle: S) -> Option<(S, S)> {
    sine_and_cosine(angle * S::from_ratio(1, 2))
}

fn linear<S: Ring>(rows: [[S; 3]; 3]) -> Matrix<S> {
    Affine::new(rows, [S::zero(); 3]).to_homogeneous()
}

fn has_translation<S: Ring>(rows: Matrix<S>) -> bool {
    rows[..3].iter().any(|row| row[3] != S::zero())
}

/// Whether a multiple of a rotation is more than √ε away from that multiple of the identity.
fn turns<S: Real<Mask = bool>>(rows: [[S; 3]; 3], factor: S) -> bool {
    let tolerance = S::epsilon().sqrt() * factor;
    (0..9).any(|k| {
        let (row, column) = (k / 3, k % 3);
        let expected = if row == column { factor } else { S::zero() };
        tolerance.less_than((rows[row][column] - expected).abs())
    })
}
