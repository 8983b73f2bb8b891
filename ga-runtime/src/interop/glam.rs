//! glam 0.34, in both of its precisions.
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
//! // A matrix that scales is no rigid motion.
//! assert!(Motor::try_from(DAffine3::from_scale(DVec3::splat(2.0))).is_err());
//! ```

use glam_034::{
    Affine3A, DAffine3, DMat3, DMat4, DQuat, DVec3, DVec4, Mat3, Mat4, Quat, Vec3, Vec4,
};

use super::NotRigid;
use crate::cga3::{Direction, Motor, Point, Rotor, Translator};

macro_rules! conversions {
    ($S:ty, $Vec3:ident, $Vec4:ident, $Quat:ident, $Mat3:ident, $Mat4:ident, $Affine:ident) => {
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

        /// The rotor of the quaternion's direction; its size is left out.
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

        /// The motor that turns by the quaternion's direction and then shifts.
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

        /// The turn, which comes first, and the shift.
        impl From<Motor<$S>> for ($Quat, $Vec3) {
            #[inline]
            fn from(motor: Motor<$S>) -> Self {
                (motor.rotor().into(), motor.translator().into())
            }
        }

        impl From<Motor<$S>> for $Affine {
            #[inline]
            fn from(motor: Motor<$S>) -> Self {
                let [a, b, c] = motor.to_matrix();
                let column = |k: usize| $Vec3::new(a[k], b[k], c[k]);
                let rotation = $Mat3::from_cols(column(0), column(1), column(2));
                Self::from_mat3_translation(rotation, column(3))
            }
        }

        impl From<Motor<$S>> for $Mat4 {
            #[inline]
            fn from(motor: Motor<$S>) -> Self {
                $Affine::from(motor).into()
            }
        }

        impl TryFrom<$Affine> for Motor<$S> {
            type Error = NotRigid;

            #[inline]
            fn try_from(affine: $Affine) -> Result<Self, NotRigid> {
                $Mat4::from(affine).try_into()
            }
        }

        /// The last row must be 0 0 0 1 to the bit.
        impl TryFrom<$Mat4> for Motor<$S> {
            type Error = NotRigid;

            #[inline]
            fn try_from(matrix: $Mat4) -> Result<Self, NotRigid> {
                if matrix.row(3) != $Vec4::W {
                    return Err(NotRigid::Matrix);
                }
                let rows = [0, 1, 2].map(|k| matrix.row(k).to_array());
                Self::from_matrix(rows).ok_or(NotRigid::Matrix)
            }
        }
    };
}

conversions!(f32, Vec3, Vec4, Quat, Mat3, Mat4, Affine3A);
conversions!(f64, DVec3, DVec4, DQuat, DMat3, DMat4, DAffine3);
