//! Conversions from and to other crates, each behind the feature of its name and off by default.
//!
//! | feature | crate | brings |
//! | --- | --- | --- |
//! | `glam-034` | glam 0.34 | points, directions, rotors, translators and motors in `f32` and `f64` |
//! | `mint-05` | mint 0.5 | points, directions and rotors in any scalar |
//!
//! `From` stands where every value has a counterpart. Where one may have none, as a matrix that shears is no motor, it is
//! `TryFrom` with the error [`NotRigid`]. Quaternions are `w + x i + y j + z k` and turn by `q v q*` in all these crates; the rotor of
//! the same turn is `w − x e23 + y e13 − z e12`.

#[cfg(feature = "glam-034")]
pub mod glam;
#[cfg(feature = "mint-05")]
pub mod mint;

use core::fmt::{Display, Formatter, Result};

/// A quaternion, displacement or matrix that makes no rigid motion: it vanishes, is not finite, shears, scales or mirrors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum NotRigid {
    /// The quaternion is zero or not finite, so that it has no direction.
    Quaternion,
    /// The displacement is not finite.
    Displacement,
    /// The matrix is not a rotation and a shift.
    Matrix,
}

impl Display for NotRigid {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        f.write_str(match self {
            Self::Quaternion => "the quaternion is zero or not finite and stands for no rotation",
            Self::Displacement => "the displacement is not finite",
            Self::Matrix => "the matrix is not a rotation and a shift",
        })
    }
}

impl core::error::Error for NotRigid {}
