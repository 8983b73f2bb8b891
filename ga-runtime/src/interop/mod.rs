//! Other crates: conversions from and to their types, and their traits for ours, each behind its
//! feature and off by default.
//!
//! - `approx-05`: approx 0.5; comparisons with a tolerance for every declared type.
//! - `bytemuck-1`: bytemuck 1; every type of the algebras here as plain memory.
//! - `glam-034`: glam 0.34; conversions of points, directions, motions, similarities and affine
//!   maps in `f32` and `f64`.
//! - `mint-05`: mint 0.5; conversions of points, directions, rotors and 4×4 matrices in any scalar.
//! - `nalgebra-035`: nalgebra 0.35; conversions of points, directions, motions, similarities and
//!   affine maps in any scalar.
//! - `num-traits-02`: num-traits 0.2; zero and one for the types that have them, and foreign
//!   floating-point numbers as scalars.
//! - `serde-1`: serde 1; every declared type read and written, by the names of its blades.
//!
//! All work without the standard library. The number in a feature is the version of the crate; one
//! for another version would stand beside it. "Every declared type" includes those of your own
//! algebras, and your crate needs no feature for it: `algebra!` writes what the features of
//! ga-runtime ask for.
//!
//! `From` stands where every value has a counterpart. Where one may have none, as a matrix that
//! shears is not a motor, it is `TryFrom` with the error [`NotRigid`] or
//! [`NotConformal`](crate::geometry::NotConformal). Quaternions are `w + x i + y j + z k` and
//! rotate by `q v q*` in all these crates; the rotor of the same rotation is
//! `w − x e23 + y e13 − z e12`. Matrices are for columns, `x' = M x`, however a crate stores them.

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

/// A quaternion, displacement or matrix that is not a rigid motion: it vanishes, is not finite,
/// shears, scales or mirrors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum NotRigid {
    /// The quaternion is zero or not finite, so that it has no direction.
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
