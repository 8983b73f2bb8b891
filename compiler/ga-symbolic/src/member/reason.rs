//! Why a value is not a member of a type.

use std::fmt;

use crate::algebra::{Blade, Ratio};

/// One reason.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reason {
    /// The value has these blades, and the type does not.
    LeftOver(Vec<(Blade, String)>),
    /// The coefficient of this blade is not the constant that the type declares.
    NotConstant(Blade, String, Ratio),
    /// The coefficient of this blade does not follow from the others as the type declares.
    NotDerived(Blade, String),
    /// The type has parameters, and no formulas by which they are read.
    NoReadings,
    /// What is read of the value for the parameter of that name is not of its type.
    NotParameter(String),
    /// The value is zero, of which no parameters can be read.
    Zero,
    /// The parameters that are read of the value give another one.
    NotReadable,
    /// A fact of the type does not hold.
    Fact(&'static str),
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::LeftOver(blades) => {
                let names: Vec<_> = blades.iter().map(|(_, name)| name.as_str()).collect();
                write!(f, "left over: {}", names.join(", "))
            }
            Self::NotConstant(_, name, constant) => write!(f, "{name} is not {constant}"),
            Self::NotDerived(_, name) => write!(f, "{name} is not as derived"),
            Self::NoReadings => write!(f, "its parameters have no formulas by which they are read"),
            Self::NotParameter(name) => write!(f, "what is read for `{name}` is not of its type"),
            Self::Zero => write!(f, "it is always zero"),
            Self::NotReadable => write!(f, "the parameters that are read give another multivector"),
            Self::Fact(fact) => write!(f, "not `{fact}`"),
        }
    }
}
