//! Rust code: a module with the types, and a macro that passes the definition on.

mod arithmetic;
mod blades;
mod blocks;
mod body;
mod coefficients;
mod context;
mod conversions;
mod functions;
mod interoperation;
mod involutions;
mod norm;
mod product_tests;
mod products;
mod surface;
mod types;
mod undeclared;
mod versors;
mod warnings;

pub use blocks::{ask_for_import, block_handover, pending};
#[cfg(feature = "source")]
pub use functions::text;
pub use functions::{function_stand_ins, functions, stand_ins_of_functions};
pub use product_tests::product_tests;

use proc_macro2::{Delimiter, Group, Ident, Span, TokenStream, TokenTree};
use quote::{ToTokens, format_ident, quote};
use syn::Visibility;
use syn::ext::IdentExt;

use super::item::{attributes_of, visibility_of};
use crate::define::{CONSTANTS, Definition};
use crate::diag::Warning;
use crate::fingerprint::fingerprint;
use crate::parse::{Outline, parse_outline};
use context::Context;

/// The module of an algebra and its macro. `source` are the tokens of the declaration.
#[must_use]
pub fn algebra(definition: &Definition, source: &TokenStream, warnings: &[Warning]) -> TokenStream {
    let context = Context::new(definition);
    let mut items = TokenStream::new();
    items.extend(constants(definition));
    for kind in &definition.types {
        items.extend(types::emit(&context, kind));
        items.extend(arithmetic::emit(&context, kind));
        items.extend(involutions::emit(&context, kind));
        if !kind.is_constant() {
            items.extend(norm::emit(&context, kind));
        }
        items.extend(blades::emit(&context, kind));
        items.extend(conversions::emit(&context, kind));
    }
    items.extend(products::emit(&context));
    items.extend(undeclared::emit(&context));
    items.extend(surface::emit(&context));
    for kind in &definition.types {
        items.extend(types::unchecked_constructor(&context, kind));
    }
    items.extend(interoperation::emit(&context));
    let module = module(definition, items);
    let handover = handover(definition, source);
    let attributes = attributes_of(&definition.attributes);
    let warnings = warnings::emit(&attributes, warnings, "DECLARATION", "module");
    quote! { #module #handover #warnings }
}

/// Stand-ins for the module and the macro of a declaration with errors.
///
/// rustc reports no errors about names that are imported from a module with a `compile_error!` in
/// it, nor about their uses. So the errors go into a module of their own, from which all names are
/// imported, those of functions in `ga!` blocks too.
#[must_use]
pub fn stand_ins(runtime: &TokenStream, source: &TokenStream, errors: &TokenStream) -> TokenStream {
    let Ok(Outline {
        attributes,
        visibility,
        name,
        types,
    }) = parse_outline(source.clone())
    else {
        return errors.clone();
    };
    let attributes = attributes.iter().filter(|a| !a.path().is_ident("doc"));
    let constants = CONSTANTS.map(|constant| format_ident!("{constant}"));
    let mut names = types;
    names.extend(constants);
    names.sort();
    names.dedup();
    let handover = macro_of(
        &name,
        &visibility,
        source,
        &quote! {
            ($($input:tt)*) => { #runtime::__private::macros::stand_ins! { $($input)* } }
        },
    );
    quote! {
        #(#attributes)*
        #[doc(hidden)]
        #[allow(unused_imports)]
        #visibility mod #name {
            #[doc(hidden)]
            pub mod __errors { #errors }
            pub use self::__errors::{#(#names),*};
        }
        #handover
    }
}

fn module(definition: &Definition, items: TokenStream) -> TokenStream {
    let (name, visibility) = (&definition.name, &definition.visibility);
    let declared = attributes_of(&definition.attributes);
    let mut docs = Vec::new();
    let mut attributes = Vec::new();
    for attribute in &declared {
        match attribute.meta.require_name_value() {
            // As inner attributes, so that links in the text find the types.
            Ok(meta) if meta.path.is_ident("doc") => docs.push(&meta.value),
            _ => attributes.push(attribute),
        }
    }
    quote! {
        #(#attributes)*
        #[allow(clippy::all, clippy::pedantic, clippy::nursery, dead_code, unused_variables)]
        #visibility mod #name { #(#![doc = #docs])* #items }
    }
}

/// The basis and the metric as data, for references and tests.
fn constants(definition: &Definition) -> TokenStream {
    let algebra = &definition.algebra;
    let dimension = algebra.dimension();
    let names = (0..dimension).map(|k| algebra.names().name(crate::algebra::Blade::vector(k)));
    let rows = (0..dimension).map(|row| {
        let entries = (0..dimension).map(|column| {
            let entry = algebra.metric().get(row, column);
            let part = |value| i64::try_from(value).unwrap_or(i64::MAX);
            let (numerator, denominator) = (part(entry.numerator()), part(entry.denominator()));
            quote! { (#numerator, #denominator) }
        });
        quote! { &[#(#entries),*] }
    });
    quote! {
        /// The names of the basis vectors. Bit `k` of a blade's number stands for the `k`-th of
        /// them.
        pub const BASIS: &[&::core::primitive::str] = &[#(#names),*];
        /// The inner products of the basis vectors as (numerator, denominator).
        pub const METRIC: &[&[(::core::primitive::i64, ::core::primitive::i64)]] = &[#(#rows),*];
    }
}

/// A macro of the algebra's name that passes the definition to another macro. Its own name is
/// unique to the definition, so that two algebras of one name in two modules do not collide.
fn handover(definition: &Definition, source: &TokenStream) -> TokenStream {
    let runtime = from_anywhere(&definition.runtime);
    let declaration = without_runtime(source);
    let rule = quote! {
        ([$($callback:tt)*] $($input:tt)*) => {
            $($callback)* ! { [#runtime] { #declaration } $($input)* }
        }
    };
    macro_of(
        &definition.name,
        &visibility_of(&definition.visibility),
        source,
        &rule,
    )
}

/// A path with `$crate` for a leading `crate`, so that a macro can pass it on to another crate.
fn from_anywhere(path: &TokenStream) -> TokenStream {
    let starts_here =
        |token: &TokenTree| matches!(token, TokenTree::Ident(name) if name == "crate");
    let dollar = path
        .clone()
        .into_iter()
        .next()
        .filter(starts_here)
        .map(|_| quote! { $ });
    quote! { #dollar #path }
}

/// A declaration without its `crate = path;`, which another crate would misread.
fn without_runtime(source: &TokenStream) -> TokenStream {
    let strip = |token| match token {
        TokenTree::Group(body) if body.delimiter() == Delimiter::Brace => {
            let mut tokens = body.stream().into_iter().peekable();
            if tokens
                .peek()
                .is_some_and(|first| first.to_string() == "crate")
            {
                tokens.find(|token| token.to_string() == ";");
            }
            TokenTree::Group(Group::new(Delimiter::Brace, tokens.collect()))
        }
        token => token,
    };
    source.clone().into_iter().map(strip).collect()
}

fn macro_of(
    name: &Ident,
    visibility: &Visibility,
    source: &TokenStream,
    rule: &TokenStream,
) -> TokenStream {
    let unique = unique_name(name, source);
    let is_public = matches!(visibility, Visibility::Public(_));
    let export = is_public.then(|| quote! { #[macro_export] });
    let visibility = match visibility {
        Visibility::Inherited => quote! { pub(crate) },
        stated => stated.to_token_stream(),
    };
    quote! {
        #[doc(hidden)]
        #export
        macro_rules! #unique { #rule }
        #[doc(hidden)]
        #[allow(unused_imports)]
        #visibility use #unique as #name;
    }
}

/// A name that no other declaration gives: by its text and its place.
fn unique_name(name: &Ident, source: &TokenStream) -> Ident {
    let hash = fingerprint(&format!("{source}{:?}", name.span()));
    let name = name.unraw();
    format_ident!("__nullcone_{name}_{hash:016x}", span = Span::call_site())
}
