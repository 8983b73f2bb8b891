//! Why operations have no value.

use std::fmt;

use super::limits::{MAX_EXPONENT, MAX_STEPS};

/// Why an operation has no value here.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum OperationError {
    /// It takes a scalar, and the operand has these blades.
    NotScalar(String),
    /// It takes a scalar or a bivector, and the operand has these blades.
    NotBivector(String),
    /// It takes a scalar or an even unit versor.
    NotEvenUnitVersor,
    /// It takes a blade or a versor a, and `a ~a` has these blades.
    NotVersor(String),
    /// A value of that name must be a scalar and a part that commutes and has square zero; the part
    /// has these blades.
    NotScalarAndNullPart(&'static str, String),
    /// It takes what has a place in space, and the operand has these blades.
    NoPlace(String),
    /// It takes a point pair, and the operand has these blades.
    NotPointPair(String),
    /// It needs the type of points of a conformal model, and these types could be it; the metric
    /// in words.
    NoPoints(Vec<String>, String),
    /// It takes a root, and the operand has these blades.
    RootNotOfScalar(String),
    /// Its exponent is too large.
    ExponentTooLarge,
    /// It divides by what is zero for all operands.
    DivisorZero,
    /// It exists for none of the operands that were tried.
    NoValue,
    /// The function has too many steps.
    TooManySteps,
}

impl OperationError {
    /// Whether the text is a sentence of its own, rather than the end of one that begins with the
    /// name of the operation.
    #[must_use]
    pub const fn is_sentence(&self) -> bool {
        match self {
            Self::DivisorZero | Self::NoValue | Self::TooManySteps | Self::ExponentTooLarge => true,
            Self::NotScalar(_)
            | Self::NotBivector(_)
            | Self::NotEvenUnitVersor
            | Self::NotVersor(_)
            | Self::NoPlace(_)
            | Self::NotPointPair(_)
            | Self::NoPoints(..)
            | Self::RootNotOfScalar(_)
            | Self::NotScalarAndNullPart(..) => false,
        }
    }
}

impl fmt::Display for OperationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotScalar(found) => write!(f, "takes a scalar, but this has {found}"),
            Self::NotBivector(found) => {
                write!(f, "takes a scalar or a bivector, but this has {found}")
            }
            Self::NotEvenUnitVersor => {
                f.write_str("takes a scalar or an even versor with M ~M = 1; `normalize` makes one")
            }
            Self::NotVersor(found) => write!(
                f,
                "takes a blade or a versor, for which a ~a is a scalar; here it has {found}; \
                 an operand that is always a blade can be marked with `blade` before its name"
            ),
            Self::NotScalarAndNullPart(what, found) => write!(
                f,
                "needs {what} to be the sum of a scalar and a part that commutes and has square zero; \
                 here that part has {found}"
            ),
            Self::NoPlace(found) => write!(
                f,
                "takes a vector, a flat point or a round (a sphere, a circle, a point pair); this is \
                 none of them or is always at infinity: it has {found}"
            ),
            Self::NotPointPair(found) => write!(
                f,
                "takes a point pair, a 2-blade without infinity, but this has {found}"
            ),
            Self::NoPoints(types, metric) if types.is_empty() => write!(
                f,
                "needs a type of points as null vectors, with derived blades, such as \
                 `struct Point {{ e1, e2, e3, eo = 1, ei = (e1*e1 + e2*e2 + e3*e3)/2 }}`; \
                 this algebra, in which {metric}, does not declare one"
            ),
            Self::NoPoints(types, _) => write!(
                f,
                "needs one type of points as null vectors, but this algebra has {}",
                types.join(" and ")
            ),
            Self::RootNotOfScalar(found) => write!(
                f,
                "takes a scalar where its exponent is a fraction, but this has {found}; \
                 a fraction t of a motion m is `exp(t * log(m))`"
            ),
            Self::ExponentTooLarge => {
                write!(
                    f,
                    "exponents lie between -{MAX_EXPONENT} and {MAX_EXPONENT}"
                )
            }
            Self::DivisorZero => f.write_str("the divisor is always zero"),
            Self::NoValue => f.write_str("this has no value for any operands that were tried"),
            Self::TooManySteps => write!(f, "the function takes more than {MAX_STEPS} steps"),
        }
    }
}
