//! Single and double precision, each with the types of glam that users would choose instead.

use ga_runtime::scalar::Real;

/// A floating-point type, with glam's transformations of that precision.
pub trait Precision: Real<Mask = bool> + Copy + 'static {
    /// `f32` or `f64`.
    const NAME: &'static str;
    /// The name of [`Precision::Matrix`].
    const MATRIX: &'static str;
    /// The name of [`Precision::Affine`].
    const AFFINE: &'static str;
    /// The name of [`Precision::Quaternion`].
    const QUATERNION: &'static str;

    /// A vector of three numbers.
    type Vector: Copy;
    /// A matrix of four rows and columns.
    type Matrix: Copy;
    /// A matrix of three rows and a translation.
    type Affine: Copy;
    /// A quaternion.
    type Quaternion: Copy;

    /// The vector with these coordinates.
    fn vector(coordinates: [Self; 3]) -> Self::Vector;
    /// The matrix `[R | t]` with these rows.
    fn matrix(rows: [[Self; 4]; 3]) -> Self::Matrix;
    /// The affine map `[R | t]` with these rows.
    fn affine(rows: [[Self; 4]; 3]) -> Self::Affine;
    /// The quaternion with these vector and scalar parts.
    fn quaternion(vector: [Self; 3], scalar: Self) -> Self::Quaternion;

    /// A point moved by a matrix.
    fn by_matrix(matrix: &Self::Matrix, point: &Self::Vector) -> Self::Vector;
    /// A point moved by an affine map.
    fn by_affine(affine: &Self::Affine, point: &Self::Vector) -> Self::Vector;
    /// A direction rotated by an affine map.
    fn rotated_by_affine(affine: &Self::Affine, direction: &Self::Vector) -> Self::Vector;
    /// A point rotated by a quaternion and translated.
    fn by_quaternion(
        quaternion: &Self::Quaternion,
        translation: &Self::Vector,
        point: &Self::Vector,
    ) -> Self::Vector;
    /// The product of two matrices.
    fn matrix_product(a: &Self::Matrix, b: &Self::Matrix) -> Self::Matrix;
    /// The product of two affine maps.
    fn affine_product(a: &Self::Affine, b: &Self::Affine) -> Self::Affine;
    /// The product of two quaternions.
    fn quaternion_product(a: &Self::Quaternion, b: &Self::Quaternion) -> Self::Quaternion;
    /// Spherical linear interpolation.
    fn slerp(a: &Self::Quaternion, b: &Self::Quaternion, t: Self) -> Self::Quaternion;
}

macro_rules! precision {
    ($scalar:ident, $vector:ident, $matrix:ident, $affine:ident, $quaternion:ident) => {
        impl Precision for $scalar {
            const NAME: &'static str = stringify!($scalar);
            const MATRIX: &'static str = concat!("glam ", stringify!($matrix));
            const AFFINE: &'static str = concat!("glam ", stringify!($affine));
            const QUATERNION: &'static str = concat!("glam ", stringify!($quaternion));

            type Vector = glam::$vector;
            type Matrix = glam::$matrix;
            type Affine = glam::$affine;
            type Quaternion = glam::$quaternion;

            fn vector(coordinates: [Self; 3]) -> Self::Vector {
                glam::$vector::from_array(coordinates)
            }
            fn matrix([x, y, z]: [[Self; 4]; 3]) -> Self::Matrix {
                glam::$matrix::from_cols_array_2d(&[x, y, z, [0.0, 0.0, 0.0, 1.0]]).transpose()
            }
            fn affine(rows: [[Self; 4]; 3]) -> Self::Affine {
                glam::$affine::from_mat4(Self::matrix(rows))
            }
            fn quaternion([x, y, z]: [Self; 3], scalar: Self) -> Self::Quaternion {
                glam::$quaternion::from_xyzw(x, y, z, scalar)
            }

            #[inline(always)]
            fn by_matrix(matrix: &Self::Matrix, point: &Self::Vector) -> Self::Vector {
                matrix.transform_point3(*point)
            }
            #[inline(always)]
            fn by_affine(affine: &Self::Affine, point: &Self::Vector) -> Self::Vector {
                affine.transform_point3(*point)
            }
            #[inline(always)]
            fn rotated_by_affine(affine: &Self::Affine, direction: &Self::Vector) -> Self::Vector {
                affine.transform_vector3(*direction)
            }
            #[inline(always)]
            fn by_quaternion(
                quaternion: &Self::Quaternion,
                translation: &Self::Vector,
                point: &Self::Vector,
            ) -> Self::Vector {
                *quaternion * *point + *translation
            }
            #[inline(always)]
            fn matrix_product(a: &Self::Matrix, b: &Self::Matrix) -> Self::Matrix {
                *a * *b
            }
            #[inline(always)]
            fn affine_product(a: &Self::Affine, b: &Self::Affine) -> Self::Affine {
                *a * *b
            }
            #[inline(always)]
            fn quaternion_product(a: &Self::Quaternion, b: &Self::Quaternion) -> Self::Quaternion {
                *a * *b
            }
            #[inline(always)]
            fn slerp(a: &Self::Quaternion, b: &Self::Quaternion, t: Self) -> Self::Quaternion {
                a.slerp(*b, t)
            }
        }
    };
}

precision!(f32, Vec3, Mat4, Affine3A, Quat);
precision!(f64, DVec3, DMat4, DAffine3, DQuat);
