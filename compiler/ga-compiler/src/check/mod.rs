//! Checks declarations: names are resolved to blades and types, and every error is found.

mod basis;
mod limits;
mod parameters;
mod polynomial;
mod products;
mod types;

use std::cell::OnceCell;

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};

use crate::define::{Definition, TypeDefinition};
use crate::diag::{Diagnostics, Warning};
use crate::parse::DeclarationSyntax;

/// Checks a parsed declaration. `runtime` is the path of ga-runtime, if the declaration does
/// not give it.
///
/// # Errors
/// Everything that is wrong with the declaration, each error at its token. What depends on a
/// faulty part is not checked, so that no error is only a consequence of another.
pub fn check(syntax: DeclarationSyntax, runtime: TokenStream) -> syn::Result<Definition> {
    check_with_warnings(syntax, runtime).map(|(definition, _)| definition)
}

/// The same, with what is allowed but is probably a mistake.
///
/// # Errors
/// As for [`check`].
pub fn check_with_warnings(
    syntax: DeclarationSyntax,
    runtime: TokenStream,
) -> syn::Result<(Definition, Vec<Warning>)> {
    limits::check_types(&syntax.types)?;
    limits::check_products(&syntax.products)?;
    let mut diagnostics = Diagnostics::default();
    let algebra = basis::check(&syntax.basis, &syntax.metric, &mut diagnostics)?;
    let is_sound = diagnostics.count() == 0;
    let (types, mut sound) =
        types::check_stored(&algebra, is_sound, &syntax.types, &mut diagnostics);
    let mut definition = Definition {
        attributes: syntax
            .attributes
            .iter()
            .map(ToTokens::to_token_stream)
            .collect(),
        visibility: syntax.visibility.into_token_stream(),
        name: syntax.name,
        runtime: syntax.runtime.map_or(runtime, |path| quote!(#path)),
        algebra,
        scalar: TypeDefinition::scalar(),
        types,
        products: Vec::new(),
        as_blades: OnceCell::new(),
    };
    if is_sound {
        parameters::check(&mut definition, &mut sound, &syntax.types, &mut diagnostics);
    }
    definition.products = products::check(&definition, &sound, &syntax.products, &mut diagnostics);
    let warnings = diagnostics.into_result()?;
    Ok((definition, warnings))
}
