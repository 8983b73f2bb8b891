//! Warnings from procedural macros, which Rust has no other means for.
//!
//! The use of a deprecated constant, at the place in question, makes the compiler print its note.
//! Attributes of the function such as `#[allow(deprecated)]` apply to it.

use proc_macro2::{Ident, TokenStream};
use quote::quote;
use syn::Attribute;

use crate::function::CompiledFunction;

/// Items that make the compiler print the warnings of a function.
pub(super) fn emit(function: &CompiledFunction) -> TokenStream {
    let is_lint = |attribute: &&Attribute| {
        let levels = ["allow", "warn", "deny", "forbid"];
        levels.iter().any(|level| attribute.path().is_ident(level))
    };
    let lints: Vec<_> = function.attributes.iter().filter(is_lint).collect();
    let warnings = function.warnings.iter().map(|warning| {
        let note = format!(
            "{}; `#[allow(deprecated)]` on the function silences this",
            warning.message
        );
        let constant = Ident::new("ALWAYS_ZERO", warning.span);
        quote! {
            #[allow(clippy::all, clippy::pedantic)]
            #(#lints)*
            const _: () = {
                mod ga {
                    #[deprecated(note = #note)]
                    pub(super) const ALWAYS_ZERO: () = ();
                }
                ga::#constant
            };
        }
    });
    warnings.collect()
}
