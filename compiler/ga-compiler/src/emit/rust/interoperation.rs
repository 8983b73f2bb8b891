//! What the traits of other crates need to know of the types.
//!
//! The descriptions go to a macro of ga-runtime, whose features choose the traits. It expands to
//! nothing if all are off, and a crate that declares an algebra needs no features of its own.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};
use syn::ext::IdentExt;

use super::context::Context;
use super::types::is_identity;
use crate::algebra::{Blade, Product, Ratio};
use crate::define::{Coefficient, Operation, TypeDefinition};

/// One invocation for all types, since rustc resolves the macro for each invocation.
pub(super) fn emit(context: &Context<'_>) -> TokenStream {
    let runtime = context.runtime;
    let types = context.definition.types.iter();
    let descriptions = types.map(|kind| description(context, kind));
    quote! { #runtime::__private::interoperate! { #({ #descriptions })* } }
}

fn description(context: &Context<'_>, kind: &TypeDefinition) -> TokenStream {
    let name = &kind.name;
    let text = name.unraw().to_string();
    if kind.is_constant() {
        return quote! { constant #name #text };
    }
    if let Some(parameters) = &kind.parameters {
        let fields = parameters
            .list
            .iter()
            .enumerate()
            .map(|(place, parameter)| {
                let (field, place) = (&parameter.name, Literal::usize_unsuffixed(place));
                let text = field.unraw().to_string();
                let path = context.result_path(parameter.index.map(|_| &parameter.kind));
                quote! { #field #place #text [#path] }
            });
        return quote! { parameters #name #text { #(#fields),* } };
    }
    let role = format_ident!(
        "{}",
        if !kind.facts_are_implied {
            "checked"
        } else if kind.is_linear() {
            "linear"
        } else {
            "free"
        }
    );
    let fields = kind.stored().enumerate().map(|(place, c)| {
        let (field, place) = (&c.name, Literal::usize_unsuffixed(place));
        let text = field.unraw().to_string();
        quote! { #field #place #text }
    });
    let one = one(context, kind);
    quote! { #role #name #text { #(#fields),* } [#(#one),*] }
}

/// The stored coefficients of 1, where it is a member and members multiply to members.
fn one(context: &Context<'_>, kind: &TypeDefinition) -> Vec<TokenStream> {
    let is_kind = |index: usize| context.kind(index).name == kind.name;
    let multiplies = context.definition.products.iter().any(|product| {
        product.operation == Operation::Product(Product::Geometric)
            && product.operands.iter().all(|&operand| is_kind(operand))
            && product.result.is_some_and(is_kind)
    });
    let is_scalar = |c: &Coefficient| c.blade == Blade::SCALAR;
    let stored = |c: &Coefficient| {
        if is_scalar(c) {
            Ratio::ONE
        } else {
            Ratio::ZERO
        }
    };
    if !multiplies || !is_identity(kind, &stored) {
        return Vec::new();
    }
    let entry = |c: &Coefficient| {
        let value = format_ident!("{}", if is_scalar(c) { "one" } else { "zero" });
        let field = &c.name;
        quote! { #field #value }
    };
    kind.stored().map(entry).collect()
}
