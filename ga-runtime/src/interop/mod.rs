//! Other crates: conversions from and to their types, and implementations of their traits. Each
//! crate has its feature, which is off by default.
//!
//! | feature | crate | adds |
//! | --- | --- | --- |
//! | `approx-05` | approx 0.5 | comparisons with a tolerance for every declared type |
//! | `bytemuck-1` | bytemuck 1 | every type of the algebras here as plain memory |
//! | `glam-034` | glam 0.34 | conversions from and to its types in `f32` and `f64` |
//! | `mint-05` | mint 0.5 | conversions from and to its types in any scalar |
//! | `nalgebra-035` | nalgebra 0.35 | conversions from and to its types in any scalar |
//! | `num-traits-02` | num-traits 0.2 | `Zero` and `One`; foreign floating-point types as scalars |
//! | `serde-1` | serde 1 | every declared type read and written, by the names of its blades |
//!
//! The traits of serde are also implemented for lanes, dual numbers and affine maps, those of
//! approx for affine maps.
//!
//! glam and nalgebra have counterparts of vectors, points, directions, motions, similarities,
//! affine maps and matrices of [linear maps](crate::linear). mint has those of vectors, points,
//! directions and rotors, and its 4×4 matrices are converted to motors and affine maps. All
//! features work without the standard library. The number in a feature is the version of the crate;
//! another version would have a feature of its own. "Every declared type" includes those of your
//! own algebras, and your crate needs no feature for it: `algebra!` emits the traits that the
//! features of ga-runtime enable.
//!
//! A conversion is `From` where every value has a counterpart. Otherwise it is `TryFrom` (a matrix
//! that shears, for instance, is not a motor), with the error [`NotRigid`] or
//! [`NotConformal`](crate::geometry::NotConformal). Quaternions are `w + x i + y j + z k` and
//! rotate by `q v q*` in all these crates; the rotor of the same rotation is
//! `w − x e23 + y e13 − z e12`. Matrices act on column vectors, `x' = M x`, however a crate stores
//! them.

#[cfg(feature = "approx-05")]
pub mod approx;
#[cfg(feature = "bytemuck-1")]
pub mod bytemuck;
mod declared;
#[cfg(feature = "glam-034")]
pub mod glam;
#[cfg(feature = "mint-05")]
pub mod mint;
#[cfg(feature = "nalgebra-035")]
pub mod nalgebra;
#[cfg(feature = "num-traits-02")]
pub mod num_traits;
#[cfg(feature = "serde-1")]
pub mod serde;

use core::fmt::{Display, Formatter, Result};

/// A quaternion, displacement or matrix that is not a rigid motion: it is zero, is not finite,
/// shears, scales or mirrors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum NotRigid {
    /// The quaternion is zero or not finite, so that it cannot be normalized.
    Quaternion,
    /// The displacement is not finite.
    Displacement,
    /// The matrix is not a rotation and a translation.
    Matrix,
}

impl Display for NotRigid {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        f.write_str(match self {
            Self::Quaternion => "the quaternion is zero or not finite, so it is not a rotation",
            Self::Displacement => "the displacement is not finite",
            Self::Matrix => "the matrix is not a rotation and a translation",
        })
    }
}

impl core::error::Error for NotRigid {}
