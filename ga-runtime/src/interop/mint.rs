//! mint 0.5: the types for exchange between mathematics crates.
//!
//! ```
//! use ga_runtime::cga3::{Point, Rotor};
//! let p = Point::from(mint_05::Point3 { x: 1.0, y: 2.0, z: 3.0 });
//! assert_eq!(mint_05::Point3::from(p), mint_05::Point3 { x: 1.0, y: 2.0, z: 3.0 });
//! let zero = mint_05::Quaternion { v: mint_05::Vector3 { x: 0.0, y: 0.0, z: 0.0 }, s: 0.0 };
//! assert!(Rotor::try_from(zero).is_err());
//! ```

use mint_05::{ColumnMatrix4, Point3, Quaternion, RowMatrix4, Vector3, Vector4};

use super::NotRigid;
use crate::cga3::{Direction, Motor, Point, Rotor};
use crate::geometry::{Affine, NotConformal};
use crate::scalar::{Field, Real, Ring};
use crate::vga3::Vector;

impl<S> From<Point3<S>> for Point<S> {
    #[inline]
    fn from(Point3 { x, y, z }: Point3<S>) -> Self {
        Self::new(x, y, z)
    }
}

impl<S: Ring> From<Point<S>> for Point3<S> {
    #[inline]
    fn from(point: Point<S>) -> Self {
        point.coordinates().into()
    }
}

impl<S> From<Vector3<S>> for Vector<S> {
    #[inline]
    fn from(Vector3 { x, y, z }: Vector3<S>) -> Self {
        Self::new(x, y, z)
    }
}

impl<S> From<Vector<S>> for Vector3<S> {
    #[inline]
    fn from(vector: Vector<S>) -> Self {
        <[S; 3]>::from(vector).into()
    }
}

impl<S> From<Vector3<S>> for Direction<S> {
    #[inline]
    fn from(Vector3 { x, y, z }: Vector3<S>) -> Self {
        Self::new(x, y, z)
    }
}

impl<S> From<Direction<S>> for Vector3<S> {
    #[inline]
    fn from(direction: Direction<S>) -> Self {
        Self {
            x: direction.e1i,
            y: direction.e2i,
            z: direction.e3i,
        }
    }
}

/// The rotor of the normalized quaternion.
impl<S: Real<Mask = bool>> TryFrom<Quaternion<S>> for Rotor<S> {
    type Error = NotRigid;

    #[inline]
    fn try_from(Quaternion { v, s }: Quaternion<S>) -> Result<Self, NotRigid> {
        Self::from_quaternion([v.x, v.y, v.z], s).ok_or(NotRigid::Quaternion)
    }
}

impl<S: Ring> From<Rotor<S>> for Quaternion<S> {
    #[inline]
    fn from(rotor: Rotor<S>) -> Self {
        let (vector, s) = rotor.to_quaternion();
        Self {
            v: vector.into(),
            s,
        }
    }
}

impl<S: Ring> From<Affine<S>> for RowMatrix4<S> {
    #[inline]
    fn from(map: Affine<S>) -> Self {
        let [x, y, z, w] = map.to_homogeneous().map(Vector4::from);
        Self { x, y, z, w }
    }
}

/// The last row must be 0 0 0 1.
impl<S: Ring> TryFrom<RowMatrix4<S>> for Affine<S> {
    type Error = NotConformal;

    #[inline]
    fn try_from(matrix: RowMatrix4<S>) -> Result<Self, NotConformal> {
        let RowMatrix4 { x, y, z, w } = matrix;
        Self::from_homogeneous([x, y, z, w].map(Into::into))
    }
}

impl<S: Ring> From<Affine<S>> for ColumnMatrix4<S> {
    #[inline]
    fn from(map: Affine<S>) -> Self {
        let [x, y, z, w] = transposed(map.to_homogeneous()).map(Vector4::from);
        Self { x, y, z, w }
    }
}

/// The last row must be 0 0 0 1.
impl<S: Ring> TryFrom<ColumnMatrix4<S>> for Affine<S> {
    type Error = NotConformal;

    #[inline]
    fn try_from(matrix: ColumnMatrix4<S>) -> Result<Self, NotConformal> {
        let ColumnMatrix4 { x, y, z, w } = matrix;
        Self::from_homogeneous(transposed([x, y, z, w].map(Into::into)))
    }
}

macro_rules! motors {
    ($($Matrix:ident),*) => { $(
        impl<S: Field> From<Motor<S>> for $Matrix<S> {
            #[inline]
            fn from(motor: Motor<S>) -> Self {
                Affine::from(motor).into()
            }
        }

        /// A rotation within √ε and a translation; the last row must be 0 0 0 1.
        impl<S: Real<Mask = bool>> TryFrom<$Matrix<S>> for Motor<S> {
            type Error = NotConformal;

            #[inline]
            fn try_from(matrix: $Matrix<S>) -> Result<Self, NotConformal> {
                Affine::try_from(matrix)?.try_into()
            }
        }
    )* };
}

motors!(RowMatrix4, ColumnMatrix4);

fn transposed<S: Copy>(rows: [[S; 4]; 4]) -> [[S; 4]; 4] {
    [0, 1, 2, 3].map(|k| rows.map(|row| row[k]))
}
