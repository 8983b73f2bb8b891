//! A checked declaration: names resolved to blades and types, every error found.

mod basis;
mod polynomial;
mod products;
mod types;

pub use polynomial::{Polynomial, PolynomialStep};
pub use products::{Operation, ProductDefinition};
pub use types::{CONSTANTS, Coefficient, Role, TypeDefinition};

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
    /// Checks a parsed declaration. `runtime` is the path of ga-runtime, where the declaration does
    /// not say it.
    ///
    /// # Errors
    /// Everything that is wrong with the declaration, each error at its token. What depends on a
    /// faulty part is not judged, so that no error merely follows from another.
    pub fn check(syntax: DeclarationSyntax, runtime: TokenStream) -> syn::Result<Self> {
        let mut diagnostics = Diagnostics::default();
        let algebra = basis::check(&syntax.basis, &syntax.metric, &mut diagnostics)?;
        let is_sound = diagnostics.count() == 0;
        let (types, sound) = types::check(&algebra, is_sound, &syntax.types, &mut diagnostics);
        let products =
            products::check(&algebra, &types, &sound, &syntax.products, &mut diagnostics);
        diagnostics.into_result()?;
        Ok(Self {
            attributes: syntax.attributes,
            visibility: syntax.visibility,
            name: syntax.name,
            runtime: syntax.runtime.map_or(runtime, |path| quote!(#path)),
            algebra,
            types,
            products,
        })
    }

    /// The type of that name.
    #[must_use]
    pub fn type_named(&self, name: &str) -> Option<&TypeDefinition> {
        self.types.iter().find(|kind| kind.name == name)
    }
}
