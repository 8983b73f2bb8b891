//! A checked declaration as plain data: the algebra, its types and its products.
//!
//! The crate `ga-compiler` makes it from what was parsed, with a check of everything.

mod formulas;
mod polynomial;
mod products;
mod types;

pub use formulas::Formulas;
pub use polynomial::{Polynomial, PolynomialStep};
pub use products::{Operation, ProductDefinition};
pub use types::{CONSTANTS, Coefficient, Parameter, Parameters, Role, SCALAR_TYPE, TypeDefinition};

use std::cell::OnceCell;

use proc_macro2::{Ident, TokenStream};

use crate::algebra::Algebra;

/// An algebra with its types and products.
pub struct Definition {
    /// Doc comments and other attributes of the module.
    pub attributes: TokenStream,
    /// The visibility of the module.
    pub visibility: TokenStream,
    /// The name of the module.
    pub name: Ident,
    /// The path at which the emitted code finds ga-runtime.
    pub runtime: TokenStream,
    /// The basis and the metric.
    pub algebra: Algebra,
    /// The type of plain numbers, which every algebra has.
    pub scalar: TypeDefinition,
    /// The types in the order of their declaration.
    pub types: Vec<TypeDefinition>,
    /// The products to emit, in the order of their declaration.
    pub products: Vec<ProductDefinition>,
    /// The types with the fact that members are blades, where that is one; made when an operand
    /// needs them.
    pub as_blades: OnceCell<Vec<Option<TypeDefinition>>>,
}

impl Definition {
    /// The type of that name.
    #[must_use]
    pub fn type_named(&self, name: &str) -> Option<&TypeDefinition> {
        self.types.iter().find(|kind| kind.name == name)
    }
}
