//! The types of an algebra: their blades, where each coefficient comes from, and their facts. Types
//! by parameters have numbers that need not be coefficients, with the multivector that they give
//! and the formulas by which they are read of one.

use proc_macro2::{Ident, Span, TokenStream};

use super::formulas::Formulas;
use super::polynomial::Polynomial;
use crate::algebra::{Blade, Ratio, SCALAR};
use crate::ir::Facts;

/// The name of the type of plain numbers, in declarations and in functions.
pub const SCALAR_TYPE: &str = "Scalar";

/// The names of the constants of every algebra.
pub const CONSTANTS: [&str; 2] = ["BASIS", "METRIC"];

/// A type of multivectors.
#[derive(Clone)]
pub struct TypeDefinition {
    /// Doc comments.
    pub docs: TokenStream,
    /// The name.
    pub name: Ident,
    /// The blades in the order of their declaration.
    pub coefficients: Vec<Coefficient>,
    /// What every member satisfies.
    pub facts: Facts,
    /// Whether the facts hold for all stored coefficients, so that members can be built without a
    /// check.
    pub facts_are_implied: bool,
    /// The type of sums and multiples, as an index; none where it is the type itself.
    pub hull: Option<usize>,
    /// What members are stored as, where that is not the coefficients.
    pub parameters: Option<Parameters>,
}

/// A blade of a type.
#[derive(Clone, Debug)]
pub struct Coefficient {
    /// The name as declared, which is the name of the field.
    pub name: Ident,
    /// The blade in rising order.
    pub blade: Blade,
    /// Whether the declared order of the vectors has the opposite sign.
    pub is_negative: bool,
    /// Where the coefficient comes from.
    pub role: Role,
}

/// Where a coefficient comes from.
#[derive(Clone, Debug, PartialEq)]
pub enum Role {
    /// It is a field.
    Stored,
    /// It is always the same.
    Constant(Ratio),
    /// It follows from the stored ones.
    Derived(Polynomial),
}

/// The parameters of a type.
#[derive(Clone)]
pub struct Parameters {
    /// The parameters in the order of their declaration.
    pub list: Vec<Parameter>,
    /// The multivector of some parameters, which are the operands.
    pub value: Formulas,
    /// The parameters of a multivector, which is the operand. A type without them has no value of a
    /// function.
    pub readings: Option<Formulas>,
}

/// A parameter: a number, or a member of a type that has no parameters.
#[derive(Clone)]
pub struct Parameter {
    /// The name.
    pub name: Ident,
    /// The type, as an index; none for a number.
    pub index: Option<usize>,
    /// The type.
    pub kind: TypeDefinition,
}

impl TypeDefinition {
    /// The plain numbers, as an operand of expressions.
    #[must_use]
    pub fn scalar() -> Self {
        let name = Ident::new(SCALAR, Span::call_site());
        let coefficient = Coefficient {
            name: name.clone(),
            blade: Blade::SCALAR,
            is_negative: false,
            role: Role::Stored,
        };
        Self {
            docs: TokenStream::new(),
            name,
            coefficients: vec![coefficient],
            facts: Facts::default(),
            facts_are_implied: true,
            hull: None,
            parameters: None,
        }
    }

    /// The stored coefficients in order.
    pub fn stored(&self) -> impl Iterator<Item = &Coefficient> {
        self.coefficients
            .iter()
            .filter(|coefficient| coefficient.role == Role::Stored)
    }

    /// Whether nothing is stored, so that the type has one member and no scalar parameter.
    #[must_use]
    pub fn is_constant(&self) -> bool {
        self.stored().next().is_none()
    }

    /// Whether members can be made of their coefficients: not of a type by parameters that are not
    /// read.
    #[must_use]
    pub fn is_readable(&self) -> bool {
        let mut parameters = self.parameters.iter();
        parameters.all(|parameters| parameters.readings.is_some())
    }

    /// How many numbers a member is stored as.
    #[must_use]
    pub fn count(&self) -> usize {
        match &self.parameters {
            None => self.stored().count(),
            Some(parameters) => parameters.list.iter().map(|p| p.kind.count()).sum(),
        }
    }

    /// Whether every coefficient is stored.
    #[must_use]
    pub fn is_stored_whole(&self) -> bool {
        self.coefficients.iter().all(|c| c.role == Role::Stored)
    }

    /// Whether any coefficients make a member and sums stay in the type.
    #[must_use]
    pub fn is_linear(&self) -> bool {
        self.is_stored_whole() && self.facts.is_empty() && self.parameters.is_none()
    }

    /// The coefficient of a blade.
    #[must_use]
    pub fn coefficient(&self, blade: Blade) -> Option<&Coefficient> {
        self.coefficients.iter().find(|c| c.blade == blade)
    }
}
