//! Reverse, involute and conjugate.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::context::{Context, receiver};
use crate::algebra::Unary;
use crate::define::TypeDefinition;
use crate::expression::Expression;
use crate::verify;

pub(super) fn emit(context: &Context<'_>, kind: &TypeDefinition) -> TokenStream {
    if kind.is_constant() {
        return TokenStream::new();
    }
    let mut items = TokenStream::new();
    let involutions = [
        (
            Unary::Reverse,
            "The reverse `~x`: the order of all vectors reversed, grade k with the sign (−1)^(k(k−1)/2).",
        ),
        (
            Unary::Involute,
            "The grade involution `x̂`: grade k with the sign (−1)^k.",
        ),
        (
            Unary::Conjugate,
            "The Clifford conjugate: reverse and involution together, grade k with the sign (−1)^(k(k+1)/2).",
        ),
    ];
    for (operation, text) in involutions {
        items.extend(involution(context, kind, operation, text));
    }
    items
}

fn involution(
    context: &Context<'_>,
    kind: &TypeDefinition,
    operation: Unary,
    text: &str,
) -> TokenStream {
    let expression = Expression::unary(operation, Expression::Operand(0));
    let algebra = &context.definition.algebra;
    let stays = verify::result_fits(algebra, &[kind], &expression, Some(kind)).is_ok();
    let result = if stays { kind } else { context.hull(kind) };
    let (body, needs) = context.compile(&[(kind, receiver())], &expression, Some(result));
    let (path, output, bound) = (
        context.path(kind),
        context.path(result),
        context.bound(needs),
    );
    let name = format_ident!("{}", operation.name());
    quote! {
        impl<S: #bound> #path {
            #[doc = #text]
            #[inline]
            #[must_use]
            pub fn #name(self) -> #output { #body }
        }
    }
}
