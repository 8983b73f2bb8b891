//! Products that no declaration provides, so that the error about an operator names the line which
//! would declare it.
//!
//! Each has an implementation whose bound is never satisfied, and the trait of that bound has the
//! message. These traits are those of ga-runtime, with the types as they are printed: an attribute
//! with the bare names would not be known in a module without the prelude. rustc comes to look at
//! that bound only where the operator may exist for some right operand, so a type without a
//! declared product has one with a type that has no values. Since each of these costs time when the
//! algebra is built, a large algebra has them only for the geometric products of rigid versors with
//! what they move, which newcomers write.

use proc_macro2::{Group, Span, TokenStream, TokenTree};
use quote::{format_ident, quote};

use super::context::Context;
use super::products::product_face;
use super::surface::takes_references;
use crate::algebra::Product;
use crate::define::{Operation, ProductDefinition, TypeDefinition};

/// Up to how many types all pairs have messages.
const LARGEST: usize = 10;

/// The products that have operators, with the bounds of ga-runtime.
const OPERATORS: [(Product, &str); 4] = [
    (Product::Geometric, "GeometricFactor"),
    (Product::Wedge, "WedgeFactor"),
    (Product::LeftContraction, "ContractionFactor"),
    (Product::Vee, "VeeFactor"),
];

pub(super) fn emit(context: &Context<'_>) -> TokenStream {
    let types = &context.definition.types;
    let is_small = types.len() <= LARGEST;
    let mut implementations = TokenStream::new();
    for (product, bound) in OPERATORS {
        let operation = Operation::Product(product);
        for (left, kind) in types.iter().enumerate() {
            let mut is_met = false;
            let starts = |p: &ProductDefinition| p.operation == operation && p.operands[0] == left;
            for (right, other) in types.iter().enumerate() {
                let operands = [left, right];
                let is_declared = is_declared(context, operation, operands);
                // Without a scalar parameter no bound can be left open.
                let is_generic = !kind.is_constant() && !other.is_constant();
                let is_wanted = is_small
                    || product == Product::Geometric && is_often_written(context, operands);
                if is_declared || !is_generic || !is_wanted {
                    continue;
                }
                let undeclared = Undeclared {
                    context,
                    product,
                    bound,
                    operands,
                };
                // Notes of rustc show where this is: at the name of the algebra.
                let span = context.definition.name.span();
                implementations.extend(placed(undeclared.implementation(), span));
                is_met = true;
            }
            if is_met && !context.definition.products.iter().any(starts) {
                implementations.extend(without_values(context, product, kind));
            }
        }
    }
    implementations
}

fn is_declared(context: &Context<'_>, operation: Operation, operands: [usize; 2]) -> bool {
    let mut products = context.definition.products.iter();
    products.any(|known| known.operation == operation && known.operands == operands)
}

/// Whether the left type is one of rigid versors that move the right one, of few coefficients.
fn is_often_written(context: &Context<'_>, operands: [usize; 2]) -> bool {
    let [left, right] = operands.map(|index| context.kind(index));
    is_declared(context, Operation::Sandwich, operands)
        && left.facts.unit_versor
        && takes_references(left)
        && (1..=6).contains(&right.stored().count())
}

/// Tokens with one place for all of them.
fn placed(tokens: TokenStream, span: Span) -> TokenStream {
    let at_span = |mut token| {
        if let TokenTree::Group(group) = &token {
            let inner = placed(group.stream(), span);
            token = TokenTree::Group(Group::new(group.delimiter(), inner));
        }
        token.set_span(token.span().located_at(span));
        token
    };
    tokens.into_iter().map(at_span).collect()
}

/// Products with types that have no values: so many that rustc cannot take one for the only one.
/// `*` has one with a scalar already.
fn without_values(context: &Context<'_>, product: Product, kind: &TypeDefinition) -> TokenStream {
    let (runtime, path) = (context.runtime, context.path(kind));
    let face = product_face(context, product);
    let (operator, method) = (&face.path, format_ident!("{}", face.method));
    let nothing = quote! { #runtime::__private::NoFactor<S> };
    let others = match product {
        Product::Geometric => vec![nothing],
        _ => vec![quote! { (#nothing,) }, nothing],
    };
    quote! {
        #(
            #[doc(hidden)]
            impl<S: #runtime::scalar::Ring> #operator<#others> for #path {
                type Output = #path;
                fn #method(self, _: #others) -> #path { self }
            }
        )*
    }
}

struct Undeclared<'a> {
    context: &'a Context<'a>,
    product: Product,
    bound: &'static str,
    operands: [usize; 2],
}

impl Undeclared<'_> {
    fn types(&self) -> [&TypeDefinition; 2] {
        self.operands.map(|index| self.context.kind(index))
    }

    fn implementation(&self) -> TokenStream {
        let runtime = self.context.runtime;
        let bound = match self.is_zero() {
            true => format_ident!("VanishingFactor"),
            false => format_ident!("{}", self.bound),
        };
        let [left, right] = self.types().map(|kind| self.context.path(kind));
        let face = product_face(self.context, self.product);
        let (operator, method) = (&face.path, format_ident!("{}", face.method));
        quote! {
            #[doc(hidden)]
            impl<S: #runtime::scalar::Ring> #operator<#right> for #left
            where
                #right: #runtime::products::#bound<#left>,
            {
                type Output = #right;
                fn #method(self, other: #right) -> #right { other }
            }
        }
    }

    /// Whether the product of any two blades of the types is zero.
    fn is_zero(&self) -> bool {
        let algebra = &self.context.definition.algebra;
        let [left, right] = self.types();
        let mut lefts = left.coefficients.iter();
        lefts.all(|a| {
            let mut rights = right.coefficients.iter();
            rights.all(|b| {
                let terms = self.product.of_blades(algebra, a.blade, b.blade);
                terms.iter().all(|(_, factor)| factor.is_zero())
            })
        })
    }
}
