//! Tests of an algebra, written from its declaration: every declared product against the dense
//! reference.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::context::snake_case;
use crate::algebra::{Product, Ratio};
use crate::define::{Definition, Operation, ProductDefinition, Role, TypeDefinition};

/// One test for each declared product of a definition, demanding exact equality with the dense
/// reference over the prime field. `path` is where the module of the algebra is found.
#[must_use]
pub fn product_tests(definition: &Definition, path: &TokenStream) -> TokenStream {
    let tests = definition
        .products
        .iter()
        .map(|product| product_test(definition, path, product));
    let types = definition
        .types
        .iter()
        .filter(|kind| !kind.is_constant())
        .map(|kind| type_test(definition, path, kind));
    quote! { #(#tests)* #(#types)* }
}

fn product_test(
    definition: &Definition,
    path: &TokenStream,
    product: &ProductDefinition,
) -> TokenStream {
    let runtime = &definition.runtime;
    let kinds: Vec<_> = product
        .operands
        .iter()
        .map(|&index| &definition.types[index])
        .collect();
    let names: Vec<_> = kinds.iter().map(|kind| snake_case(&kind.name)).collect();
    // With a word between, so that `PointPair, Line` and `Point, PairLine` differ.
    let name = format_ident!("{}_{}", product.operation.name(), names.join("_and_"));
    let locals: Vec<_> = (0..kinds.len())
        .map(|place| format_ident!("operand{place}"))
        .collect();
    let strategies: Vec<_> = kinds
        .iter()
        .map(|kind| strategy(runtime, path, kind))
        .collect();
    let dense_operands = kinds
        .iter()
        .zip(&locals)
        .map(|(kind, local)| dense(runtime, kind, local));
    let call = call(product.operation, &locals);
    let reference = reference(runtime, product.operation, &kinds);
    let scalar = quote! { #runtime::scalar::Prime61 };
    let (result, found) = match product.result {
        Some(index) => {
            let kind = &definition.types[index];
            let name = &kind.name;
            if kind.is_constant() {
                (
                    quote! { #path::#name },
                    dense(runtime, kind, &format_ident!("result")),
                )
            } else {
                (
                    quote! { #path::#name<#scalar> },
                    quote! { #runtime::testing::to_dense(&algebra, &result) },
                )
            }
        }
        None => (
            scalar,
            quote! { #runtime::dense::Algebra::scalar(&algebra, result) },
        ),
    };
    let expected = match product.operation {
        Operation::Product(Product::ScalarProduct) => {
            quote! { #runtime::dense::Algebra::scalar(&algebra, #reference) }
        }
        _ => reference,
    };
    quote! {
        #[::core::prelude::v1::test]
        fn #name() {
            let algebra = #runtime::testing::algebra_of(#path::METRIC);
            #runtime::testing::for_all((#(#strategies,)*), |(#(#locals,)*)| {
                let dense = [#(#dense_operands),*];
                let result: #result = #call;
                ::std::assert_eq!(#found, #expected);
            });
        }
    }
}

/// Members of a type; a type without stored coefficients has but one.
fn strategy(runtime: &TokenStream, path: &TokenStream, kind: &TypeDefinition) -> TokenStream {
    let name = &kind.name;
    if kind.is_constant() {
        quote! { #runtime::testing::only(#path::#name) }
    } else {
        quote! { #runtime::testing::exact_member::<#path::#name<_>>() }
    }
}

/// The dense form of a member that is called `local`.
fn dense(runtime: &TokenStream, kind: &TypeDefinition, local: &Ident) -> TokenStream {
    if !kind.is_constant() {
        return quote! { #runtime::testing::to_dense(&algebra, &#local) };
    }
    let terms = kind.coefficients.iter().map(|c| {
        let value = match &c.role {
            Role::Constant(value) if c.is_negative => -*value,
            Role::Constant(value) => *value,
            _ => Ratio::ZERO,
        };
        let part = |value| i64::try_from(value).unwrap_or(i64::MAX);
        let (numerator, denominator) = (part(value.numerator()), part(value.denominator()));
        let blade = c.blade.0 as usize;
        quote! { (#blade, #numerator, #denominator) }
    });
    quote! { #runtime::testing::constant_to_dense(&algebra, &[#(#terms),*]) }
}

fn call(operation: Operation, locals: &[Ident]) -> TokenStream {
    let first = &locals[0];
    let Some(second) = locals.get(1) else {
        let method = format_ident!("{}", operation.name());
        return quote! { #first.#method() };
    };
    match operation {
        Operation::Product(Product::Geometric) => quote! { #first * #second },
        Operation::Product(Product::Wedge) => quote! { #first ^ #second },
        Operation::Product(Product::LeftContraction) => quote! { #first | #second },
        Operation::Product(Product::Vee) => quote! { #first & #second },
        operation => {
            let method = format_ident!("{}", operation.name());
            quote! { #first.#method(#second) }
        }
    }
}

/// The operation by the reference. All methods are called by their paths, since traits of the user
/// may be in scope.
fn reference(
    runtime: &TokenStream,
    operation: Operation,
    kinds: &[&TypeDefinition],
) -> TokenStream {
    let method = format_ident!("{}", operation.name());
    let multivector = quote! { #runtime::dense::Multivector };
    let is_odd = kinds[0]
        .coefficients
        .iter()
        .all(|c| c.blade.involute_is_negative());
    match operation {
        Operation::Unary(_) => quote! { #multivector::#method(&dense[0]) },
        Operation::Sandwich if is_odd => {
            quote! { #multivector::sandwich(&dense[0], &#multivector::involute(&dense[1])) }
        }
        _ => quote! { #multivector::#method(&dense[0], &dense[1]) },
    }
}

/// Involutions, norm and arithmetic of a type against the reference.
fn type_test(definition: &Definition, path: &TokenStream, kind: &TypeDefinition) -> TokenStream {
    let runtime = &definition.runtime;
    let (name, test) = (&kind.name, format_ident!("type_{}", snake_case(&kind.name)));
    let multivector = quote! { #runtime::dense::Multivector };
    let dimension = definition.algebra.dimension();
    quote! {
        #[::core::prelude::v1::test]
        fn #test() {
            let algebra = #runtime::testing::algebra_of(#path::METRIC);
            let operands = (
                #runtime::testing::exact_member::<#path::#name<_>>(),
                #runtime::testing::exact_member::<#path::#name<_>>(),
                #runtime::testing::strategy::prime(),
            );
            #runtime::testing::for_all(operands, |(a, b, factor)| {
                let x = #runtime::testing::to_dense(&algebra, &a);
                let y = #runtime::testing::to_dense(&algebra, &b);
                ::std::assert_eq!(#runtime::testing::to_dense(&algebra, &a.reverse()), #multivector::reverse(&x));
                ::std::assert_eq!(#runtime::testing::to_dense(&algebra, &a.involute()), #multivector::involute(&x));
                ::std::assert_eq!(#runtime::testing::to_dense(&algebra, &a.conjugate()), #multivector::conjugate(&x));
                ::std::assert_eq!(a.norm_squared(), #multivector::norm_squared(&x));
                ::std::assert_eq!(#runtime::testing::to_dense(&algebra, &(a + b)), &x + &y);
                ::std::assert_eq!(#runtime::testing::to_dense(&algebra, &(a - b)), &x - &y);
                ::std::assert_eq!(#runtime::testing::to_dense(&algebra, &-a), -&x);
                ::std::assert_eq!(#runtime::testing::to_dense(&algebra, &(a * factor)), #multivector::scale(&x, factor));
                ::std::assert_eq!(
                    #runtime::testing::to_dense(&algebra, &(a / factor)),
                    #multivector::scale(&x, #runtime::scalar::Field::recip(factor))
                );
                for grade in 0..=#dimension {
                    ::std::assert_eq!(
                        #runtime::testing::to_dense(&algebra, &a.grade(grade)), #multivector::grade(&x, grade)
                    );
                }
            });
        }
    }
}
