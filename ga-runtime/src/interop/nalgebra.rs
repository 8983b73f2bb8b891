//! nalgebra 0.35: points, directions, motions and matrices in any scalar that both crates support,
//! such as `f32` and `f64`.
//!
//! | here | nalgebra | |
//! | --- | --- | --- |
//! | [`Point`] | `Point3` | both ways |
//! | [`Vector`], [`Direction`] | `Vector3` | both ways |
//! | [`Translator`] | `Translation3` | both ways |
//! | [`Rotor`] | `UnitQuaternion` | both ways; the sign is kept |
//! | [`Rotor`] | `Rotation3`, `Matrix3` | to; from is checked |
//! | [`Motor`] | `Isometry3` | both ways; the sign is kept |
//! | [`Motor`] | `IsometryMatrix3`, `Matrix4` | to; from is checked |
//! | [`Similarity`] | `Similarity3`, `Matrix4` | to; from is checked |
//! | [`Affine`] | `Affine3`, `Matrix4` | to; from is checked |
//! | [`LinearMap`] | `SMatrix` with a row and a column for each blade | both ways |
//!
//! A `UnitQuaternion` has length 1 by its own contract and is converted without a check,
//! coefficient by coefficient. A `Similarity3` may have a negative factor, which mirrors and has no
//! counterpart here.
//!
//! ```
//! use ga_runtime::cga3::{Motor, Point};
//! use nalgebra_035::{Isometry3, Point3, Vector3};
//!
//! let isometry = Isometry3::new(Vector3::new(1.0, 2.0, 3.0), Vector3::y() * 0.5);
//! let motor = Motor::from(isometry);
//! let p = Point3::new(0.3, -0.4, 2.0);
//! let moved = Point3::from(motor.transform(Point::from(p)));
//! assert!((moved - isometry * p).norm() < 1e-15);
//! assert_eq!(Isometry3::from(motor).rotation, isometry.rotation);
//! ```

use nalgebra_035::{
    Affine3, Isometry3, IsometryMatrix3, Matrix3, Matrix4, Point3, Quaternion, RealField,
    Rotation3, SMatrix, Scalar, Similarity3, Translation3, Unit, UnitQuaternion, Vector3,
};

use core::ops::Add;

use super::NotRigid;
use crate::Element;
use crate::cga3::{Direction, Motor, Point, Rotor, Similarity, Translator};
use crate::geometry::{Affine, NotConformal, affine};
use crate::linear::LinearMap;
use crate::scalar::{Field, Real, Ring};
use crate::vga3::Vector;

impl<S: Scalar + Copy> From<Point3<S>> for Point<S> {
    #[inline]
    fn from(point: Point3<S>) -> Self {
        let [[x, y, z]] = point.coords.data.0;
        Self::new(x, y, z)
    }
}

impl<S: Scalar + Ring> From<Point<S>> for Point3<S> {
    #[inline]
    fn from(point: Point<S>) -> Self {
        let [x, y, z] = point.coordinates();
        Self::new(x, y, z)
    }
}

impl<S: Scalar + Copy> From<Vector3<S>> for Vector<S> {
    #[inline]
    fn from(vector: Vector3<S>) -> Self {
        let [[x, y, z]] = vector.data.0;
        Self::new(x, y, z)
    }
}

impl<S: Scalar> From<Vector<S>> for Vector3<S> {
    #[inline]
    fn from(vector: Vector<S>) -> Self {
        <[S; 3]>::from(vector).into()
    }
}

impl<S: Scalar + Copy> From<Vector3<S>> for Direction<S> {
    #[inline]
    fn from(vector: Vector3<S>) -> Self {
        let [[x, y, z]] = vector.data.0;
        Self::new(x, y, z)
    }
}

impl<S: Scalar> From<Direction<S>> for Vector3<S> {
    #[inline]
    fn from(direction: Direction<S>) -> Self {
        Self::new(direction.e1i, direction.e2i, direction.e3i)
    }
}

impl<S: Scalar + Field> From<Translation3<S>> for Translator<S> {
    #[inline]
    fn from(translation: Translation3<S>) -> Self {
        let [displacement] = translation.vector.data.0;
        Self::from_displacement(displacement)
    }
}

impl<S: Scalar + Field> From<Translator<S>> for Translation3<S> {
    #[inline]
    fn from(translator: Translator<S>) -> Self {
        let [x, y, z] = translator.displacement();
        Self::new(x, y, z)
    }
}

/// Coefficient by coefficient, without a check: nalgebra's type guarantees the length 1.
impl<S: Scalar + Ring> From<UnitQuaternion<S>> for Rotor<S> {
    #[inline]
    fn from(quaternion: UnitQuaternion<S>) -> Self {
        let [[x, y, z, w]] = quaternion.into_inner().coords.data.0;
        Self::new_unchecked(w, -z, y, -x)
    }
}

impl<S: Scalar + Ring> From<Rotor<S>> for UnitQuaternion<S> {
    #[inline]
    fn from(rotor: Rotor<S>) -> Self {
        let ([x, y, z], w) = rotor.to_quaternion();
        Unit::new_unchecked(Quaternion::from([x, y, z, w]))
    }
}

impl<S: Scalar + Ring> From<Rotor<S>> for Matrix3<S> {
    #[inline]
    fn from(rotor: Rotor<S>) -> Self {
        matrix3(rotor.to_matrix())
    }
}

/// The matrix must be a rotation within √ε.
impl<S: Scalar + Real<Mask = bool>> TryFrom<Matrix3<S>> for Rotor<S> {
    type Error = NotRigid;

    #[inline]
    fn try_from(matrix: Matrix3<S>) -> Result<Self, NotRigid> {
        Self::from_matrix(transposed(matrix.data.0)).ok_or(NotRigid::Matrix)
    }
}

impl<S: Scalar + Ring> From<Rotor<S>> for Rotation3<S> {
    #[inline]
    fn from(rotor: Rotor<S>) -> Self {
        Self::from_matrix_unchecked(rotor.into())
    }
}

/// The matrix must be a rotation within √ε.
impl<S: Scalar + Real<Mask = bool>> TryFrom<Rotation3<S>> for Rotor<S> {
    type Error = NotRigid;

    #[inline]
    fn try_from(rotation: Rotation3<S>) -> Result<Self, NotRigid> {
        rotation.into_inner().try_into()
    }
}

/// The rotation, which comes first, and the translation.
impl<S: Scalar + Field> From<Isometry3<S>> for Motor<S> {
    #[inline]
    fn from(isometry: Isometry3<S>) -> Self {
        Translator::from(isometry.translation) * Rotor::from(isometry.rotation)
    }
}

impl<S: RealField + Field> From<Motor<S>> for Isometry3<S> {
    #[inline]
    fn from(motor: Motor<S>) -> Self {
        Self::from_parts(motor.translator().into(), motor.rotor().into())
    }
}

/// The matrix must be a rotation within √ε.
impl<S: Scalar + Real<Mask = bool>> TryFrom<IsometryMatrix3<S>> for Motor<S> {
    type Error = NotRigid;

    #[inline]
    fn try_from(isometry: IsometryMatrix3<S>) -> Result<Self, NotRigid> {
        let [displacement] = isometry.translation.vector.data.0;
        if !displacement.into_iter().all(<S as Real>::is_finite) {
            return Err(NotRigid::Displacement);
        }
        let rotor = Rotor::try_from(isometry.rotation)?;
        Ok(Translator::from_displacement(displacement) * rotor)
    }
}

impl<S: RealField + Field> From<Motor<S>> for IsometryMatrix3<S> {
    #[inline]
    fn from(motor: Motor<S>) -> Self {
        Self::from_parts(motor.translator().into(), motor.rotor().into())
    }
}

impl<S: Scalar + Field> From<Motor<S>> for Matrix4<S> {
    #[inline]
    fn from(motor: Motor<S>) -> Self {
        Affine::from(motor).into()
    }
}

/// A rotation within √ε and a translation; the last row must be 0 0 0 1.
impl<S: Scalar + Real<Mask = bool>> TryFrom<Matrix4<S>> for Motor<S> {
    type Error = NotConformal;

    #[inline]
    fn try_from(matrix: Matrix4<S>) -> Result<Self, NotConformal> {
        Affine::try_from(matrix)?.try_into()
    }
}

impl<S: Scalar + Real<Mask = bool>> From<Similarity<S>> for Matrix4<S> {
    #[inline]
    fn from(similarity: Similarity<S>) -> Self {
        Affine::from(similarity).into()
    }
}

/// A positive multiple of a rotation, within √ε of it, and a translation; the last row must be 0 0
/// 0 1.
impl<S: Scalar + Real<Mask = bool>> TryFrom<Matrix4<S>> for Similarity<S> {
    type Error = NotConformal;

    #[inline]
    fn try_from(matrix: Matrix4<S>) -> Result<Self, NotConformal> {
        Affine::try_from(matrix)?.try_into()
    }
}

/// The scaling, which comes first, the rotation and the translation. A negative factor mirrors.
impl<S: RealField + Real<Mask = bool>> TryFrom<Similarity3<S>> for Similarity<S> {
    type Error = NotConformal;

    #[inline]
    fn try_from(similarity: Similarity3<S>) -> Result<Self, NotConformal> {
        let factor = similarity.scaling();
        if factor.less_than(<S as Ring>::zero()) {
            return Err(NotConformal::Mirrors);
        }
        let [translation] = similarity.isometry.translation.vector.data.0;
        if !translation.into_iter().all(<S as Real>::is_finite) {
            return Err(NotConformal::NotFinite);
        }
        affine::similarity(similarity.isometry.rotation.into(), factor, translation)
    }
}

/// Fails where the factor is outside of the range of the scalar, since nalgebra does not allow a
/// factor of zero.
impl<S: RealField + Real<Mask = bool>> TryFrom<Similarity<S>> for Similarity3<S> {
    type Error = NotConformal;

    fn try_from(similarity: Similarity<S>) -> Result<Self, NotConformal> {
        let map = Affine::from(similarity);
        let (rotor, factor) = map.rotation_and_factor()?;
        let [x, y, z] = map.translation;
        Ok(Self::from_parts(
            Translation3::new(x, y, z),
            rotor.into(),
            factor,
        ))
    }
}

impl<S: Scalar + Ring> From<Affine<S>> for Matrix4<S> {
    #[inline]
    fn from(map: Affine<S>) -> Self {
        let [a, b, c, d] = map.to_homogeneous();
        Self::new(
            a[0], a[1], a[2], a[3], b[0], b[1], b[2], b[3], c[0], c[1], c[2], c[3], d[0], d[1],
            d[2], d[3],
        )
    }
}

/// The last row must be 0 0 0 1.
impl<S: Scalar + Ring> TryFrom<Matrix4<S>> for Affine<S> {
    type Error = NotConformal;

    #[inline]
    fn try_from(matrix: Matrix4<S>) -> Result<Self, NotConformal> {
        let [a, b, c, d] = matrix.data.0;
        Self::from_homogeneous([0, 1, 2, 3].map(|k| [a[k], b[k], c[k], d[k]]))
    }
}

impl<S: RealField + Ring> From<Affine<S>> for Affine3<S> {
    #[inline]
    fn from(map: Affine<S>) -> Self {
        Self::from_matrix_unchecked(map.into())
    }
}

/// The last row must be 0 0 0 1.
impl<S: RealField + Ring> TryFrom<Affine3<S>> for Affine<S> {
    type Error = NotConformal;

    #[inline]
    fn try_from(map: Affine3<S>) -> Result<Self, NotConformal> {
        map.into_inner().try_into()
    }
}

/// A matrix of another size than the map does not compile.
impl<A, B, S, const ROWS: usize, const COLUMNS: usize> From<&LinearMap<A, B>>
    for SMatrix<S, ROWS, COLUMNS>
where
    S: Scalar + Ring,
    A: Element<Scalar = S> + Add<Output = A>,
    B: Element<Scalar = S> + Add<Output = B>,
{
    fn from(map: &LinearMap<A, B>) -> Self {
        let rows: [[S; COLUMNS]; ROWS] = map.to_rows();
        Self::from_fn(|row, column| rows[row][column])
    }
}

/// A matrix of another size than the map does not compile.
impl<A, B, S, const ROWS: usize, const COLUMNS: usize> From<SMatrix<S, ROWS, COLUMNS>>
    for LinearMap<A, B>
where
    S: Scalar + Ring,
    A: Element<Scalar = S> + Add<Output = A>,
    B: Element<Scalar = S> + Add<Output = B>,
{
    fn from(matrix: SMatrix<S, ROWS, COLUMNS>) -> Self {
        let entry = |row, column| matrix[(row, column)];
        let row = |row| core::array::from_fn(|column| entry(row, column));
        Self::from_rows::<ROWS, COLUMNS>(core::array::from_fn(row))
    }
}

fn matrix3<S: Scalar>([a, b, c]: [[S; 3]; 3]) -> Matrix3<S> {
    let rows = [a, b, c].map(nalgebra_035::RowVector3::from);
    Matrix3::from_rows(&rows)
}

fn transposed<S: Copy>([a, b, c]: [[S; 3]; 3]) -> [[S; 3]; 3] {
    [0, 1, 2].map(|k| [a[k], b[k], c[k]])
}
