//! Whether given coefficients are those of a member of a type.

use alloc::format;
use alloc::string::String;
use core::fmt;

use super::Element;
use crate::scalar::{Real, Ring};

/// Why an element is not a member of a type: the error of `TryFrom` and of
/// [`Element::try_from_element`].
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

/// The member of `T` with these coefficients on these blades and zero on all others, up to a
/// tolerance relative to the largest coefficient.
pub(crate) fn member<T: Element>(
    blades: &[usize],
    coefficient: &dyn Fn(usize) -> T::Scalar,
    tolerance: T::Scalar,
) -> Result<T, NotMember>
where
    T::Scalar: Real<Mask = bool>,
{
    let type_name = T::NAME;
    let mut largest = T::Scalar::zero();
    for &blade in blades {
        let size = coefficient(blade).abs();
        if !size.is_finite() {
            let blade = name(T::BASIS, blade);
            return Err(NotMember::NotFinite { type_name, blade });
        }
        largest = largest.max(size);
    }
    let allowed = tolerance * largest;
    let member = T::from_coefficients_unchecked(&mut |blade| coefficient(blade));
    for &blade in blades.iter().chain(T::BLADES) {
        let (found, expected) = (coefficient(blade), member.coefficient(blade));
        if !are_within(&[found - expected], allowed) {
            return Err(NotMember::Coefficient {
                type_name,
                blade: name(T::BASIS, blade),
                found: format!("{found:?}"),
                expected: format!("{expected:?}"),
            });
        }
    }
    if !member.satisfies_facts(tolerance) {
        return Err(if T::IS_UNIT_VERSOR {
            NotMember::NotUnitVersor { type_name }
        } else {
            NotMember::NotBlade { type_name }
        });
    }
    Ok(member)
}

/// Whether no defect is larger than the tolerance, or not a number.
#[inline]
pub fn are_within<S: Real<Mask = bool>>(defects: &[S], tolerance: S) -> bool {
    // Comparisons with NaN are false.
    defects.iter().all(|defect| {
        let size = defect.abs();
        size.is_finite() && size.less_or_equal(tolerance)
    })
}

/// The name of a blade in rising order.
fn name(basis: &[&str], blade: usize) -> String {
    crate::dense::blade_name(basis, blade)
}
