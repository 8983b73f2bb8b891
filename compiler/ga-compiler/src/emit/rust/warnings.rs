//! Warnings from procedural macros, which Rust has no other means for.
//!
//! The use of a deprecated constant, at the place in question, makes the compiler print its note.
//! Attributes of the item such as `#[allow(deprecated)]` apply to it.

use proc_macro2::{Ident, TokenStream};
use quote::quote;
use syn::Attribute;

use crate::diag::Warning;

/// Items that make the compiler print warnings about an item, with its attributes. `constant` names
/// the kind of warning, `item` the kind of item.
pub(super) fn emit(
    attributes: &[Attribute],
    warnings: &[Warning],
    constant: &str,
    item: &str,
) -> TokenStream {
    let is_lint = |attribute: &&Attribute| {
        let levels = ["allow", "warn", "deny", "forbid"];
        levels.iter().any(|level| attribute.path().is_ident(level))
    };
    let lints: Vec<_> = attributes.iter().filter(is_lint).collect();
    let warnings = warnings.iter().map(|warning| {
        let message = &warning.message;
        let note = format!("{message}; `#[allow(deprecated)]` on the {item} silences this");
        let constant = Ident::new(constant, warning.span);
        quote! {
            #[allow(clippy::all, clippy::pedantic)]
            #(#lints)*
            const _: () = {
                mod ga {
                    #[deprecated(note = #note)]
                    pub(super) const #constant: () = ();
                }
                ga::#constant
            };
        }
    });
    warnings.collect()
}
