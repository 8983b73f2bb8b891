//! A checked declaration: names resolved to blades and types, every error found.

mod basis;
mod polynomial;
mod products;
mod types;

pub use polynomial::{Polynomial, PolynomialStep};
pub use products::{Operation, ProductDefinition};
pub use types::{Coefficient, Role, TypeDefinition};

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Attribute, Ident, Visibility};

use crate::algebra::Algebra;
use crate::diag::Diagnostics;
use crate::parse::DeclarationSyntax;

/// An algebra with its types and products.
pub struct Definition {
    /// Doc comments and other attributes of the module.
    pub attributes: Vec<Attribute>,
    /// The visibility of the module.
    pub visibility: Visibility,
    /// The name of the module.
    pub name: Ident,
    /// The path at which the emitted code finds ga-runtime.
    pub runtime: TokenStream,
    /// The basis and the metric.
    pub algebra: Algebra,
    /// The types in the order of their declaration.
    pub types: Vec<TypeDefinition>,
    /// The products to emit, in the order of their declaration.
    pub products: Vec<ProductDefinition>,
}

impl Definition {
    /// Checks a parsed declaration. Everything wrong with it goes to `diagnostics`; what comes back then is good
    /// for emitting stand-ins of the types only.
    #[must_use]
    pub fn check(
        syntax: DeclarationSyntax,
        runtime: TokenStream,
        diagnostics: &mut Diagnostics,
    ) -> Self {
        let algebra = basis::check(&syntax.basis, &syntax.metric, diagnostics);
        let types = types::check(&algebra, &syntax.types, diagnostics);
        let products = if diagnostics.is_empty() {
            products::check(&algebra, &types, &syntax.products, diagnostics)
        } else {
            Vec::new()
        };
        Self {
            attributes: syntax.attributes,
            visibility: syntax.visibility,
            name: syntax.name,
            runtime: syntax.runtime.map_or(runtime, |path| quote!(#path)),
            algebra,
            types,
            products,
        }
    }

    /// The type of that name.
    #[must_use]
    pub fn type_named(&self, name: &str) -> Option<&TypeDefinition> {
        self.types.iter().find(|kind| kind.name == name)
    }
}
