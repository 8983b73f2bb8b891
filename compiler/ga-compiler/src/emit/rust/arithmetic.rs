//! Sums, differences, negatives and multiples, in the type itself if it is closed under them, else
//! in its hull.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::body::Needs;
use super::context::{Context, other, receiver};
use crate::algebra::Product;
use crate::define::TypeDefinition;
use crate::expression::Expression;
use crate::verify;

pub(super) fn emit<'a>(context: &Context<'a>, kind: &'a TypeDefinition) -> TokenStream {
    if kind.is_constant() {
        return TokenStream::new();
    }
    let mut items = TokenStream::new();
    items.extend(sums(context, kind));
    items.extend(negative(context, kind));
    items.extend(multiples(context, kind));
    items
}

fn sums(context: &Context<'_>, kind: &TypeDefinition) -> TokenStream {
    let hull = context.hull(kind);
    let (path, output) = (context.path(kind), context.path(hull));
    let mut items = TokenStream::new();
    for (name, method, sign) in [("Add", "add", 1), ("Sub", "sub", -1)] {
        let (first, second) = (Expression::Operand(0), Expression::Operand(1));
        let sum = if sign == 1 {
            Expression::sum(first, second)
        } else {
            Expression::difference(first, second)
        };
        let operands = [(kind, receiver()), (kind, other())];
        let (body, needs) = context.compile(&operands, &sum, Some(hull));
        let bound = context.bound(needs);
        let (name, method) = (format_ident!("{name}"), format_ident!("{method}"));
        items.extend(quote! {
            impl<S: #bound> ::core::ops::#name for #path {
                type Output = #output;
                #[inline]
                fn #method(self, other: Self) -> #output { #body }
            }
        });
    }
    items
}

fn negative(context: &Context<'_>, kind: &TypeDefinition) -> TokenStream {
    // Negation does not change a constant or derived blade; all facts but the weight are kept.
    let negative = Expression::Negative(Box::new(Expression::Operand(0)));
    let stays = match kind.parameters {
        None => kind.is_stored_whole() && kind.facts.weight.is_none(),
        Some(_) => {
            let algebra = &context.definition.algebra;
            verify::result_fits(algebra, &[kind], &negative, Some(kind)).is_ok()
        }
    };
    let result = if stays { kind } else { context.hull(kind) };
    let (body, needs) = context.compile(&[(kind, receiver())], &negative, Some(result));
    let (path, output, bound) = (
        context.path(kind),
        context.path(result),
        context.bound(needs),
    );
    quote! {
        impl<S: #bound> ::core::ops::Neg for #path {
            type Output = #output;
            #[inline]
            fn neg(self) -> #output { #body }
        }
    }
}

/// The type of multiples: the type itself, if they are members.
pub(super) fn type_of_multiples<'a>(
    context: &Context<'a>,
    kind: &'a TypeDefinition,
) -> &'a TypeDefinition {
    let (element, number) = (Expression::Operand(0), Expression::Operand(1));
    let product = Expression::binary(Product::Geometric, element, number);
    let algebra = &context.definition.algebra;
    let operands = [kind, &context.definition.scalar];
    let stays = || verify::result_fits(algebra, &operands, &product, Some(kind)).is_ok();
    match kind.parameters.is_some() && stays() {
        true => kind,
        false => context.hull(kind),
    }
}

fn multiples<'a>(context: &Context<'a>, kind: &'a TypeDefinition) -> TokenStream {
    let hull = type_of_multiples(context, kind);
    let (path, output) = (context.path(kind), context.path(hull));
    let scalar = [format_ident!("scalar")];
    let compile = |expression| {
        context.compile_scaled(&[(kind, receiver())], &scalar, &expression, Some(hull))
    };
    let (element, number) = (Expression::Operand(0), Expression::Operand(1));
    let (product, needs) = compile(Expression::binary(
        Product::Geometric,
        element.clone(),
        number.clone(),
    ));
    let (quotient, _) = compile(Expression::quotient(element, number));
    let (bound, field) = (context.bound(needs), context.bound(needs.max(Needs::Field)));
    let floats = [format_ident!("f32"), format_ident!("f64")];
    let from_left = floats.iter().map(|float| from_left(kind, hull, float));
    quote! {
        impl<S: #bound> ::core::ops::Mul<S> for #path {
            type Output = #output;
            #[inline]
            fn mul(self, scalar: S) -> #output { #product }
        }
        impl<S: #field> ::core::ops::Div<S> for #path {
            type Output = #output;
            #[inline]
            fn div(self, scalar: S) -> #output { #quotient }
        }
        #(#from_left)*
    }
}

fn from_left(kind: &TypeDefinition, hull: &TypeDefinition, float: &Ident) -> TokenStream {
    let (name, hull) = (&kind.name, &hull.name);
    quote! {
        impl ::core::ops::Mul<#name<::core::primitive::#float>> for ::core::primitive::#float {
            type Output = #hull<::core::primitive::#float>;
            #[inline]
            fn mul(self, element: #name<::core::primitive::#float>) -> Self::Output { element * self }
        }
    }
}
