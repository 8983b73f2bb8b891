//! glam 0.34, in both of its precisions.
//!
//! | here | glam | |
//! | --- | --- | --- |
//! | [`Vector`], [`Point`], [`Direction`], [`Translator`] | `Vec3`, `Vec3A`, `DVec3` | both ways |
//! | [`Rotor`] | `Quat`, `DQuat`; `Mat3`, `Mat3A`, `DMat3` | to; from is checked |
//! | [`Motor`] | `(Quat, Vec3)`, `(DQuat, DVec3)` | to; from is checked |
//! | [`Motor`] | `Affine3`, `Affine3A`, `DAffine3`; `Mat4`, `DMat4` | to; from is checked |
//! | [`Similarity`] | `Affine3`, `Affine3A`, `DAffine3`; `Mat4`, `DMat4` | to; from is checked |
//! | [`Affine`] | `Affine3`, `Affine3A`, `DAffine3` | both ways |
//! | [`Affine`] | `Mat4`, `DMat4` | to; from is checked |
//! | [`LinearMap`] of as many blades | `Mat2` to `Mat4`, `DMat2` to `DMat4` | both ways |
//!
//! glam does not have a type of quaternions of length 1. A quaternion is therefore normalized, and
//! one that cannot be normalized is an error.
//!
//! ```
//! use ga_runtime::cga3::{Motor, Point, Rotor};
//! use glam_034::{DAffine3, DQuat, DVec3};
//!
//! let motor = Motor::try_from((DQuat::from_rotation_y(0.5), DVec3::new(1.0, 2.0, 3.0))).unwrap();
//! let p = DVec3::new(0.3, -0.4, 2.0);
//! let moved = DVec3::from(motor.transform(Point::from(p)));
//! assert!(moved.abs_diff_eq(DAffine3::from(motor).transform_point3(p), 1e-15));
//!
//! // A matrix that scales is not a rigid motion.
//! assert!(Motor::try_from(DAffine3::from_scale(DVec3::splat(2.0))).is_err());
//! ```

use core::ops::Add;

use glam_034::{
    Affine3, Affine3A, DAffine3, DMat2, DMat3, DMat4, DQuat, DVec3, Mat2, Mat3, Mat3A, Mat4, Quat,
    Vec3, Vec3A,
};

use super::NotRigid;
use crate::Element;
use crate::cga3::{Direction, Motor, Point, Rotor, Similarity, Translator};
use crate::geometry::{Affine, NotConformal};
use crate::linear::LinearMap;
use crate::vga3::Vector;

macro_rules! vectors {
    ($S:ty, $Vec3:ident) => {
        impl From<$Vec3> for Vector<$S> {
            #[inline]
            fn from(v: $Vec3) -> Self {
                Self::new(v.x, v.y, v.z)
            }
        }

        impl From<Vector<$S>> for $Vec3 {
            #[inline]
            fn from(vector: Vector<$S>) -> Self {
                vector.coordinates().into()
            }
        }

        impl From<$Vec3> for Point<$S> {
            #[inline]
            fn from(v: $Vec3) -> Self {
                Self::new(v.x, v.y, v.z)
            }
        }

        impl From<Point<$S>> for $Vec3 {
            #[inline]
            fn from(point: Point<$S>) -> Self {
                point.coordinates().into()
            }
        }

        impl From<$Vec3> for Direction<$S> {
            #[inline]
            fn from(v: $Vec3) -> Self {
                Self::new(v.x, v.y, v.z)
            }
        }

        impl From<Direction<$S>> for $Vec3 {
            #[inline]
            fn from(direction: Direction<$S>) -> Self {
                Self::new(direction.e1i, direction.e2i, direction.e3i)
            }
        }

        /// The translator by a displacement.
        impl From<$Vec3> for Translator<$S> {
            #[inline]
            fn from(displacement: $Vec3) -> Self {
                Self::from_displacement(displacement.to_array())
            }
        }

        /// The displacement.
        impl From<Translator<$S>> for $Vec3 {
            #[inline]
            fn from(translator: Translator<$S>) -> Self {
                translator.displacement().into()
            }
        }
    };
}

macro_rules! rotations {
    ($S:ty, $Mat3:ident) => {
        impl From<Rotor<$S>> for $Mat3 {
            #[inline]
            fn from(rotor: Rotor<$S>) -> Self {
                let rows = rotor.to_matrix().map(Into::into);
                Self::from_cols(rows[0], rows[1], rows[2]).transpose()
            }
        }

        impl TryFrom<$Mat3> for Rotor<$S> {
            type Error = NotRigid;

            #[inline]
            fn try_from(matrix: $Mat3) -> Result<Self, NotRigid> {
                let rows = [0, 1, 2].map(|k| matrix.row(k).to_array());
                Self::from_matrix(rows).ok_or(NotRigid::Matrix)
            }
        }
    };
}

macro_rules! affine_maps {
    ($S:ty, $Mat4:ident, $Affine:ident) => {
        impl From<Affine<$S>> for $Affine {
            #[inline]
            fn from(map: Affine<$S>) -> Self {
                let [a, b, c] = map.linear;
                let column = |k: usize| [a[k], b[k], c[k]].into();
                Self::from_cols(column(0), column(1), column(2), map.translation.into())
            }
        }

        impl From<$Affine> for Affine<$S> {
            #[inline]
            fn from(map: $Affine) -> Self {
                let [a, b, c, d] = map.to_cols_array_2d();
                let row = |k: usize| [a[k], b[k], c[k]];
                Self::new([row(0), row(1), row(2)], d)
            }
        }

        impl From<Motor<$S>> for $Affine {
            #[inline]
            fn from(motor: Motor<$S>) -> Self {
                Affine::from(motor).into()
            }
        }

        impl TryFrom<$Affine> for Motor<$S> {
            type Error = NotRigid;

            #[inline]
            fn try_from(map: $Affine) -> Result<Self, NotRigid> {
                $Mat4::from(map).try_into()
            }
        }

        impl From<Similarity<$S>> for $Affine {
            #[inline]
            fn from(similarity: Similarity<$S>) -> Self {
                Affine::from(similarity).into()
            }
        }

        impl TryFrom<$Affine> for Similarity<$S> {
            type Error = NotConformal;

            #[inline]
            fn try_from(map: $Affine) -> Result<Self, NotConformal> {
                Affine::from(map).try_into()
            }
        }
    };
}

macro_rules! quaternions {
    ($S:ty, $Vec3:ident, $Quat:ident) => {
        /// The rotor of the normalized quaternion.
        impl TryFrom<$Quat> for Rotor<$S> {
            type Error = NotRigid;

            #[inline]
            fn try_from(q: $Quat) -> Result<Self, NotRigid> {
                Self::from_quaternion([q.x, q.y, q.z], q.w).ok_or(NotRigid::Quaternion)
            }
        }

        impl From<Rotor<$S>> for $Quat {
            #[inline]
            fn from(rotor: Rotor<$S>) -> Self {
                let ([x, y, z], w) = rotor.to_quaternion();
                Self::from_xyzw(x, y, z, w)
            }
        }

        /// The motor that rotates by the normalized quaternion and then translates.
        impl TryFrom<($Quat, $Vec3)> for Motor<$S> {
            type Error = NotRigid;

            #[inline]
            fn try_from((rotation, displacement): ($Quat, $Vec3)) -> Result<Self, NotRigid> {
                if !displacement.is_finite() {
                    return Err(NotRigid::Displacement);
                }
                let rotor = Rotor::<$S>::try_from(rotation)?;
                Ok(Translator::<$S>::from(displacement) * rotor)
            }
        }

        /// The rotation, which comes first, and the translation.
        impl From<Motor<$S>> for ($Quat, $Vec3) {
            #[inline]
            fn from(motor: Motor<$S>) -> Self {
                (motor.rotor().into(), motor.translator().into())
            }
        }
    };
}

macro_rules! matrices {
    ($S:ty, $Mat4:ident) => {
        impl From<Affine<$S>> for $Mat4 {
            #[inline]
            fn from(map: Affine<$S>) -> Self {
                Self::from_cols_array_2d(&map.to_homogeneous()).transpose()
            }
        }

        /// The last row must be 0 0 0 1.
        impl TryFrom<$Mat4> for Affine<$S> {
            type Error = NotConformal;

            #[inline]
            fn try_from(matrix: $Mat4) -> Result<Self, NotConformal> {
                Self::from_homogeneous(matrix.transpose().to_cols_array_2d())
            }
        }

        impl From<Motor<$S>> for $Mat4 {
            #[inline]
            fn from(motor: Motor<$S>) -> Self {
                Affine::from(motor).into()
            }
        }

        /// The last row must be exactly 0 0 0 1.
        impl TryFrom<$Mat4> for Motor<$S> {
            type Error = NotRigid;

            #[inline]
            fn try_from(matrix: $Mat4) -> Result<Self, NotRigid> {
                let map = Affine::try_from(matrix).map_err(|_| NotRigid::Matrix)?;
                map.try_into().map_err(|_| NotRigid::Matrix)
            }
        }

        impl From<Similarity<$S>> for $Mat4 {
            #[inline]
            fn from(similarity: Similarity<$S>) -> Self {
                Affine::from(similarity).into()
            }
        }

        /// The last row must be exactly 0 0 0 1.
        impl TryFrom<$Mat4> for Similarity<$S> {
            type Error = NotConformal;

            #[inline]
            fn try_from(matrix: $Mat4) -> Result<Self, NotConformal> {
                Affine::try_from(matrix)?.try_into()
            }
        }
    };
}

macro_rules! linear_maps {
    ($S:ty, $Mat:ident, $size:literal) => {
        /// A map of another size does not compile.
        impl<A, B> From<&LinearMap<A, B>> for $Mat
        where
            A: Element<Scalar = $S> + Add<Output = A>,
            B: Element<Scalar = $S> + Add<Output = B>,
        {
            fn from(map: &LinearMap<A, B>) -> Self {
                let rows: [[$S; $size]; $size] = map.to_rows();
                Self::from_cols_array_2d(&rows).transpose()
            }
        }

        /// A map of another size does not compile.
        impl<A, B> From<$Mat> for LinearMap<A, B>
        where
            A: Element<Scalar = $S> + Add<Output = A>,
            B: Element<Scalar = $S> + Add<Output = B>,
        {
            fn from(matrix: $Mat) -> Self {
                Self::from_rows(matrix.transpose().to_cols_array_2d())
            }
        }
    };
}

vectors!(f32, Vec3);
vectors!(f32, Vec3A);
vectors!(f64, DVec3);
rotations!(f32, Mat3);
rotations!(f32, Mat3A);
rotations!(f64, DMat3);
affine_maps!(f32, Mat4, Affine3);
affine_maps!(f32, Mat4, Affine3A);
affine_maps!(f64, DMat4, DAffine3);
quaternions!(f32, Vec3, Quat);
quaternions!(f64, DVec3, DQuat);
matrices!(f32, Mat4);
matrices!(f64, DMat4);
linear_maps!(f32, Mat2, 2);
linear_maps!(f32, Mat3, 3);
linear_maps!(f32, Mat4, 4);
linear_maps!(f64, DMat2, 2);
linear_maps!(f64, DMat3, 3);
linear_maps!(f64, DMat4, 4);
