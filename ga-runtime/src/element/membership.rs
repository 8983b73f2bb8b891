//! Whether given coefficients are those of a member of a type.

use alloc::string::String;
use core::fmt;

use crate::scalar::Real;

/// Why an element is not a member of a type: the error of `TryFrom` and of
/// [`Element::try_from_element`](super::Element::try_from_element).
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum NotMember {
    /// A coefficient is infinite or NaN.
    NotFinite {
        /// The name of the type.
        type_name: &'static str,
        /// The blade.
        blade: String,
    },
    /// A coefficient differs from that of the member with the same stored coefficients.
    Coefficient {
        /// The name of the type.
        type_name: &'static str,
        /// The blade.
        blade: String,
        /// The coefficient of the element.
        found: String,
        /// The coefficient of the member.
        expected: String,
    },
    /// The coefficients do not satisfy `M ~M = 1`, which holds for all members of the type.
    NotUnitVersor {
        /// The name of the type.
        type_name: &'static str,
    },
    /// The coefficients are not those of a blade, an outer product of vectors.
    NotBlade {
        /// The name of the type.
        type_name: &'static str,
    },
}

impl fmt::Display for NotMember {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { type_name, blade } => {
                write!(
                    f,
                    "not a {type_name}: the coefficient of {blade} is not finite"
                )
            }
            Self::Coefficient {
                type_name,
                blade,
                found,
                expected,
            } => write!(
                f,
                "not a {type_name}: the coefficient of {blade} is {found} instead of {expected}"
            ),
            Self::NotUnitVersor { type_name } => {
                write!(f, "not a {type_name}: M ~M is not 1 up to the tolerance")
            }
            Self::NotBlade { type_name } => {
                write!(
                    f,
                    "not a {type_name}: it is not a blade up to the tolerance"
                )
            }
        }
    }
}

impl core::error::Error for NotMember {}

/// Whether no defect is larger than the tolerance, or not a number.
#[inline]
pub fn are_within<S: Real<Mask = bool>>(defects: &[S], tolerance: S) -> bool {
    // Comparisons with NaN are false.
    defects.iter().all(|defect| {
        let size = defect.abs();
        size.is_finite() && size.less_or_equal(tolerance)
    })
}
