//! Conversions between types: `From` where nothing is lost, methods by name where something may be.

use heck::ToSnakeCase;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::ext::IdentExt;

use super::context::{Context, receiver};
use crate::define::TypeDefinition;
use crate::expression::Expression;
use crate::verify;

pub(super) fn emit(context: &Context<'_>, kind: &TypeDefinition) -> TokenStream {
    let others = context.definition.types.iter();
    others
        .filter(|other| other.name != kind.name)
        .map(|other| {
            let mut items = lossless(context, kind, other);
            items.extend(lossy(context, kind, other));
            items
        })
        .collect()
}

/// `From<kind> for target`, where every member of `kind` is one of `target`.
fn lossless(context: &Context<'_>, kind: &TypeDefinition, target: &TypeDefinition) -> TokenStream {
    let covers = kind
        .coefficients
        .iter()
        .all(|c| target.coefficient(c.blade).is_some());
    // What is by parameters is read, which may lose digits; `TryFrom` does it.
    if target.is_constant() || target.parameters.is_some() || !covers {
        return TokenStream::new();
    }
    let identity = Expression::Operand(0);
    let algebra = &context.definition.algebra;
    if !target.is_linear()
        && verify::result_fits(algebra, &[kind], &identity, Some(target)).is_err()
    {
        return TokenStream::new();
    }
    let value = format_ident!("value");
    let (body, needs) = context.compile(&[(kind, value)], &identity, Some(target));
    let (path, output) = (context.path(kind), context.path(target));
    let bound = context.bound(needs);
    quote! {
        impl<S: #bound> ::core::convert::From<#path> for #output {
            #[inline]
            fn from(value: #path) -> Self { #body }
        }
    }
}

/// A method that keeps the blades of a smaller type and drops the rest.
fn lossy(context: &Context<'_>, kind: &TypeDefinition, target: &TypeDefinition) -> TokenStream {
    let is_part = target.coefficients.len() < kind.coefficients.len()
        && target
            .coefficients
            .iter()
            .all(|c| kind.coefficient(c.blade).is_some());
    if !kind.is_linear() || !target.is_linear() || !is_part {
        return TokenStream::new();
    }
    let (body, needs) =
        context.compile(&[(kind, receiver())], &Expression::Operand(0), Some(target));
    let (path, output, bound) = (
        context.path(kind),
        context.path(target),
        context.bound(needs),
    );
    let name = format_ident!(
        "extract_{}",
        target.name.unraw().to_string().to_snake_case()
    );
    let text = format!(
        "The coefficients that [`{}`] has; all others are dropped.",
        target.name
    );
    quote! {
        impl<S: #bound> #path {
            #[doc = #text]
            #[inline]
            #[must_use]
            pub fn #name(self) -> #output { #body }
        }
    }
}
