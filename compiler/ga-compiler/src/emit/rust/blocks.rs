//! How blocks of functions use each other: a macro named like each function passes its whole block
//! on.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::Visibility;

use super::unique_name;
use crate::parse::{Block, Pending, UseSyntax};

/// The tokens of functions that wait for imports, in the form in which they are parsed.
#[must_use]
pub fn pending(pending: &Pending) -> TokenStream {
    let Pending {
        runtime,
        declaration,
        path,
        imports,
        source,
    } = pending;
    quote! { [#runtime] { #declaration } [#path] [#imports] #source }
}

/// A call of the macro of a function that is used, with all that has been handed over so far.
#[must_use]
pub fn ask_for_import(all: &Pending, import: &UseSyntax, rest: &TokenStream) -> TokenStream {
    let UseSyntax {
        path,
        original,
        name,
    } = import;
    let Pending {
        runtime,
        declaration,
        path: algebra,
        imports,
        ..
    } = all;
    quote! {
        #path ! {
            [#runtime::__private::macros::import] (#name #original)
            [#runtime] { #declaration } [#algebra] [#imports] #rest
        }
    }
}

/// The macro that passes a block on, under the names of its functions. `algebra` identifies its
/// algebra, `source` are the tokens of the block.
#[must_use]
pub fn block_handover(block: &Block, algebra: u64, source: &TokenStream) -> TokenStream {
    let Some(first) = block
        .functions
        .iter()
        .find_map(|function| function.name.as_ref())
    else {
        return TokenStream::new();
    };
    let unique = unique_name(first, source);
    let is_public = |visibility: &Visibility| matches!(visibility, Visibility::Public(_));
    let export = block
        .functions
        .iter()
        .any(|function| is_public(&function.visibility))
        .then(|| quote! { #[macro_export] });
    let names = block.functions.iter().filter_map(|function| {
        let (name, visibility) = (function.name.as_ref()?, &function.visibility);
        let name = format_ident!("{name}");
        Some(quote! {
            #[doc(hidden)]
            #[allow(unused_imports)]
            #visibility use #unique as #name;
        })
    });
    quote! {
        #[doc(hidden)]
        #[allow(non_local_definitions, unused_macros)]
        #export
        macro_rules! #unique {
            ([$($callback:tt)*] $($input:tt)*) => {
                $($callback)* ! { { #algebra #source } $($input)* }
            }
        }
        #(#names)*
    }
}
