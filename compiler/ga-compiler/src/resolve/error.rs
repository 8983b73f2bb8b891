//! Errors in functions: names without a meaning, operations without a value, types that do not fit.

use std::fmt;

use crate::parse::{MAX_NESTING, Place};

use super::limits::{MAX_CALL_DEPTH, MAX_CALLS, MAX_LEVELS, MAX_OPERANDS};
use crate::program::OperationError;

/// An error in a function, with its place in the source.
#[derive(Clone, Debug)]
pub struct ResolveError(Box<(ResolveErrorKind, Place)>);

/// What is wrong with a function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ResolveErrorKind {
    /// The operands' types have no members, or none were found.
    NoOperands,
    /// The operands hold too many values.
    TooManyOperands,
    /// The algebra does not have a type of that name; a hint what may be meant.
    UnknownType(String, String),
    /// There is no value of that name; a hint what may be meant.
    UnknownName(String, String),
    /// There is no operation or function of that name; a hint what may be meant.
    UnknownOperation(String, String),
    /// The name can be read as several blades.
    AmbiguousBlade(String, Vec<String>),
    /// The algebra does not have a blade of that name.
    UnknownBlade(String),
    /// The formula does not have that blade; it has these.
    MissingBlade {
        /// The formula.
        formula: String,
        /// The blade.
        blade: String,
        /// The blades that it has.
        found: String,
    },
    /// The name of a type stands where a value is needed.
    TypeAsValue(String),
    /// Several values stand where one is needed.
    SeveralValues,
    /// An element is taken of a single value.
    NoElements,
    /// The element that is taken is behind the last one; the number of elements.
    ElementOutOfRange(usize),
    /// The number of parts of a pattern, and the different number of values for it.
    PatternParts(usize, ValueCount),
    /// The name of something, the number of its values, and the type that it is declared as.
    ShapeMismatch(String, ValueCount, String),
    /// An operand of that type, in which everything is a blade, is marked `blade`.
    NeedlessBlade(String),
    /// An operand of that type, whose blades cannot be described, is marked `blade`.
    NoBlades(String),
    /// The thing named must be a blade; it has these blades of the basis.
    NotBlade(String, String),
    /// The thing named is not of the type of that name, for a reason.
    TypeMismatch(String, String, String),
    /// The divisor of `/` has these blades.
    DivisorNotScalar(String),
    /// A condition stands where a multivector is needed.
    ConditionAsValue,
    /// The operation or operator of that name takes conditions.
    NotCondition(&'static str),
    /// An operand of that comparison has these blades.
    ComparedNotScalar(&'static str, String),
    /// `select` chooses between different numbers of values.
    UnequalChoices(ValueCount, ValueCount),
    /// The grade of `grade` is not a whole number as it is written.
    GradeNotWhole,
    /// The exponent of `pow` is not a number as it is written.
    ExponentNotConstant,
    /// A product of two scalars is not written as such.
    ProductOfScalars {
        /// The formula.
        formula: String,
        /// The product that it is.
        name: &'static str,
        /// What may be meant.
        instead: String,
    },
    /// An operation or function, the number of operands that it takes, and the number given.
    OperandCount(String, usize, usize),
    /// An operator has no value.
    Operator(OperationError),
    /// An operation of that name has no value.
    Operation(&'static str, OperationError),
    /// These functions call each other in a circle.
    Recursion(Vec<String>),
    /// The calls of functions nest too deep, at a call of that one.
    CallsTooDeep(String),
    /// The calls of functions and the formulas in them nest too deep together.
    LevelsTooDeep,
    /// Too many calls of functions are copied in.
    TooManyCalls,
    /// The multivector of the parameters has blades that the hull of that name does not have.
    NotInHull(String, String),
    /// A formula is not for one of the type's parameters.
    NotParameter(String),
    /// A name bound by `let` is that of a parameter.
    LetOfParameter(String),
    /// A parameter is read twice.
    ReadTwice(String),
    /// Some parameters are read, and not this one.
    NotRead(String),
    /// What is read for the parameter of that name is another number, so that it gives another
    /// multivector.
    NotInverse(String),
}

/// How many values stand somewhere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ValueCount {
    /// One, which is not in a tuple or an array.
    One,
    /// A condition.
    Condition,
    /// The number of values in a tuple or an array.
    Several(usize),
}

impl ResolveError {
    pub(super) fn new(kind: ResolveErrorKind, place: Place) -> Self {
        Self(Box::new((kind, place)))
    }

    /// What is wrong.
    #[must_use]
    pub const fn kind(&self) -> &ResolveErrorKind {
        &self.0.0
    }
}

impl fmt::Display for ResolveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.kind().fmt(f)
    }
}

impl std::error::Error for ResolveError {}

impl From<ResolveError> for syn::Error {
    fn from(error: ResolveError) -> Self {
        let (kind, place) = *error.0;
        place.error(kind)
    }
}

impl fmt::Display for ValueCount {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::One => f.write_str("one value"),
            Self::Condition => f.write_str("a condition"),
            Self::Several(1) => f.write_str("1 value in a tuple or an array"),
            Self::Several(count) => write!(f, "{count} values"),
        }
    }
}

impl fmt::Display for ResolveErrorKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoOperands => f.write_str("no members of the operands' types were found"),
            Self::TooManyOperands => {
                write!(
                    f,
                    "the operands hold more than {MAX_OPERANDS} values together"
                )
            }
            Self::UnknownType(name, hint) => write!(f, "unknown type `{name}`{hint}"),
            Self::UnknownName(name, hint) => write!(
                f,
                "unknown name `{name}`: it is neither an operand, nor bound by `let`, nor a blade{hint}"
            ),
            Self::UnknownOperation(name, hint) => write!(
                f,
                "unknown operation `{name}`: neither the algebra nor this block has it{hint}"
            ),
            Self::AmbiguousBlade(name, readings) => {
                write!(f, "`{name}` can be read as {}", readings.join(" or "))
            }
            Self::UnknownBlade(name) => write!(f, "`{name}` is not a blade of the algebra"),
            Self::MissingBlade {
                formula,
                blade,
                found,
            } => write!(
                f,
                "`{formula}` does not have the blade {blade}; it has {found}"
            ),
            Self::TypeAsValue(name) => write!(f, "`{name}` is a type, not a value"),
            Self::SeveralValues => f.write_str("these are several values, where one is needed"),
            Self::NoElements => f.write_str("this is one value, which does not have elements"),
            Self::ElementOutOfRange(count) => element_out_of_range(f, *count),
            Self::PatternParts(parts, found) => {
                let plural = plural(*parts);
                write!(
                    f,
                    "the pattern has {parts} part{plural}, but this is {found}"
                )
            }
            Self::ShapeMismatch(what, found, declared) => {
                write!(f, "{what} is {found}, but its type is `{declared}`")
            }
            Self::TypeMismatch(what, name, reason) => {
                write!(f, "{what} is not of type `{name}`: {reason}")
            }
            Self::NeedlessBlade(kind) => {
                write!(f, "every `{kind}` is a blade; leave out the mark `blade`")
            }
            Self::NoBlades(kind) => write!(
                f,
                "`{kind}` cannot be marked `blade`: the blades among its values do not form one \
                 family that outer products of vectors generate"
            ),
            Self::NotBlade(what, found) => write!(
                f,
                "{what} must be a blade, an outer product of vectors, \
                 but not every value of this is one; it has {found}"
            ),
            Self::DivisorNotScalar(found) => write!(
                f,
                "the divisor is not a scalar, it has {found}; \
                 `a * inverse(b)` divides by a blade or a versor"
            ),
            Self::ConditionAsValue => f.write_str(
                "this is a condition, where a multivector is needed; \
                 `select(condition, 1, 0)` makes a number of it",
            ),
            Self::NotCondition(what) => write!(
                f,
                "`{what}` takes a condition, such as `x < y`, but this is a value"
            ),
            Self::ComparedNotScalar(symbol, found) => write!(
                f,
                "`{symbol}` compares scalars, but one of its sides has {found}; \
                 compare coefficients or norms"
            ),
            Self::UnequalChoices(a, b) => write!(
                f,
                "`select` chooses between two values of the same shape, but these are {a} and {b}"
            ),
            Self::GradeNotWhole => f.write_str("the grade must be a whole number"),
            Self::ExponentNotConstant => f.write_str(
                "the exponent must be a number as it is written, such as 3, -2, 1/2 or 0.5; \
                 x to the power of a variable y is `exp(y * ln(x))`",
            ),
            Self::ProductOfScalars {
                formula,
                name,
                instead,
            } => write!(f, "`{formula}` is the {name} of two scalars, {instead}"),
            Self::OperandCount(name, wanted, found) => {
                let plural = plural(*wanted);
                write!(f, "`{name}` takes {wanted} operand{plural}, not {found}")
            }
            Self::Operator(error) => error.fmt(f),
            Self::Operation(name, error) => {
                let link = if error.is_sentence() { ":" } else { "" };
                write!(f, "`{name}`{link} {error}")
            }
            Self::Recursion(circle) => recursion(f, circle),
            Self::CallsTooDeep(name) => write!(
                f,
                "the call of `{name}` is more than {MAX_CALL_DEPTH} calls deep; \
                 write some of the functions that lead here out where they are called"
            ),
            Self::LevelsTooDeep => write!(
                f,
                "calls and formulas nest more than {MAX_LEVELS} levels deep together \
                 (one formula up to {MAX_NESTING}); bind inner parts to names with `let`"
            ),
            Self::NotInHull(hull, blades) => {
                write!(
                    f,
                    "the hull `{hull}` does not have the blades {blades} of this multivector"
                )
            }
            Self::NotParameter(name) => write!(
                f,
                "`{name}` is not a parameter of this type; a value between is bound by `let`"
            ),
            Self::LetOfParameter(name) => {
                write!(f, "`{name}` is a parameter: leave out `let`")
            }
            Self::ReadTwice(name) => write!(f, "`{name}` is read twice"),
            Self::NotRead(name) => write!(
                f,
                "a formula that reads `{name}` of `self` is missing: all parameters are read, or none"
            ),
            Self::NotInverse(name) => write!(
                f,
                "what is read for `{name}` is not the parameter that was written: the parameters \
                 that are read of `self` give another multivector"
            ),
            Self::TooManyCalls => write!(
                f,
                "more than {MAX_CALLS} calls are copied into this function; \
                 bind results that are used twice to names with `let`"
            ),
        }
    }
}

fn element_out_of_range(f: &mut fmt::Formatter<'_>, count: usize) -> fmt::Result {
    match count {
        0 => f.write_str("there are no elements"),
        1 => f.write_str("there is 1 element, number 0"),
        _ => write!(
            f,
            "there are {count} elements, numbered from 0 to {}",
            count - 1
        ),
    }
}

const fn plural(count: usize) -> &'static str {
    if count == 1 { "" } else { "s" }
}

fn recursion(f: &mut fmt::Formatter<'_>, circle: &[String]) -> fmt::Result {
    let Some((first, others)) = circle.split_first() else {
        return Ok(());
    };
    write!(f, "`{first}` calls itself")?;
    for (place, other) in others.iter().enumerate() {
        let link = match place {
            0 => " through",
            _ if place + 1 == others.len() => " and",
            _ => ",",
        };
        write!(f, "{link} `{other}`")?;
    }
    f.write_str("; the body of a function takes the place of each call, which would never end here")
}
