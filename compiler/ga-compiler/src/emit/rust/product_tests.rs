//! Tests of an algebra, written from its declaration: every declared product against the dense
//! reference.

use heck::ToSnakeCase;
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};
use syn::ext::IdentExt;

use super::body::Needs;
use super::coefficients::needs;
use super::context::Context;
use super::surface::{has_product, takes_references};
use crate::algebra::{Product, Ratio};
use crate::define::{Definition, Operation, ProductDefinition, Role, TypeDefinition};

/// One test for each declared product of a definition, demanding exact equality with the dense
/// reference over the prime field. `path` is where the module of the algebra is found. Types by
/// parameters that cannot be read, or whose formulas have roots or angles, have no tests.
#[must_use]
pub fn product_tests(definition: &Definition, path: &TokenStream) -> TokenStream {
    let context = Context::new(definition);
    let is_exact =
        |kind: &TypeDefinition| kind.is_readable() && needs(&context, kind) <= Needs::Field;
    let are_exact: Vec<bool> = definition.types.iter().map(is_exact).collect();
    let tests = definition
        .products
        .iter()
        .filter(|product| {
            let mut kinds = product.operands.iter().chain(&product.result);
            kinds.all(|index| are_exact[*index])
        })
        .map(|product| product_test(definition, path, product));
    let types = definition
        .types
        .iter()
        .zip(&are_exact)
        .filter(|(kind, is_exact)| !kind.is_constant() && **is_exact)
        .map(|(kind, _)| type_test(definition, path, kind));
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
    let names: Vec<_> = kinds
        .iter()
        .map(|kind| kind.name.unraw().to_string().to_snake_case())
        .collect();
    // With `and` between the names, so that `PointPair, Line` and `Point, PairLine` differ.
    let name = format_ident!("{}_{}", product.operation.name(), names.join("_and_"));
    let locals: Vec<_> = (0..kinds.len())
        .map(|place| format_ident!("operand{place}"))
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
                    quote! { #runtime::testing::to_dense(algebra, &result) },
                )
            }
        }
        None => (
            scalar,
            quote! { #runtime::dense::Algebra::scalar(algebra, result) },
        ),
    };
    let expected = match product.operation {
        Operation::Product(Product::ScalarProduct) => {
            quote! { #runtime::dense::Algebra::scalar(algebra, #reference) }
        }
        _ => reference,
    };
    let text = name.to_string();
    let references = references(product.operation, &kinds, &locals);
    let body = quote! {
        let dense = [#(#dense_operands),*];
        let result: #result = #call;
        #runtime::testing::assert_same(#text, &[#(&#locals),*], &#found, &#expected);
        #references
    };
    let kinds: Vec<_> = (kinds.into_iter())
        .zip(&product.as_blades)
        .map(|(kind, as_blade)| (kind, as_blade.is_some()))
        .collect();
    test(runtime, path, &name, &kinds, &body)
}

/// The operators on references, where there are some, against those on values.
fn references(operation: Operation, kinds: &[&TypeDefinition], locals: &[Ident]) -> TokenStream {
    let (Some(operator), [left, right], [a, b]) = (operator(operation), kinds, locals) else {
        return TokenStream::new();
    };
    let mut checks = TokenStream::new();
    let mut check = |found: TokenStream| {
        checks.extend(quote! { ::std::assert_eq!(#found, result); });
    };
    if takes_references(left) {
        check(quote! { &#a #operator #b });
        if takes_references(right) {
            check(quote! { #a #operator &#b });
            check(quote! { &#a #operator &#b });
        }
    }
    checks
}

/// The operator of a product in Rust.
fn operator(operation: Operation) -> Option<TokenStream> {
    let Operation::Product(product) = operation else {
        return None;
    };
    match product {
        Product::Geometric => Some(quote! { * }),
        Product::Wedge => Some(quote! { ^ }),
        Product::LeftContraction => Some(quote! { | }),
        Product::Vee => Some(quote! { & }),
        Product::RightContraction | Product::ScalarProduct | Product::Commutator => None,
    }
}

/// A test of random members of some types, or of blades among them, which are called `operand0` and
/// so on, or `number` for further numbers beside them.
fn test(
    runtime: &TokenStream,
    path: &TokenStream,
    name: &Ident,
    kinds: &[(&TypeDefinition, bool)],
    body: &TokenStream,
) -> TokenStream {
    let (mut makers, mut counts, mut values) = (Vec::new(), Vec::new(), Vec::new());
    for (place, (kind, is_blade)) in kinds.iter().enumerate() {
        let (local, maker) = (
            format_ident!("operand{place}"),
            format_ident!("members{place}"),
        );
        let name = &kind.name;
        if kind.is_constant() {
            counts.push(quote! { 0 });
            values.push(quote! { let #local = #path::#name; });
        } else {
            let members = format_ident!("{}", if *is_blade { "blades" } else { "members" });
            makers.push(quote! { let #maker = #runtime::testing::#members::<#path::#name<_>>(); });
            counts.push(quote! { #runtime::testing::Members::count(&#maker) });
            values.push(quote! {
                let #local: #path::#name<_> =
                    #runtime::testing::Members::member(&#maker, &numbers[#place])?;
            });
        }
    }
    quote! {
        #[::core::prelude::v1::test]
        fn #name() {
            #(#makers)*
            let counts = [#(#counts,)* 1];
            #runtime::testing::for_all_numbers(#path::METRIC, #path::BASIS, &counts, &|algebra, numbers| {
                #(#values)*
                #body
                ::core::option::Option::Some(())
            });
        }
    }
}

/// The dense form of a member that is called `local`.
fn dense(runtime: &TokenStream, kind: &TypeDefinition, local: &Ident) -> TokenStream {
    if !kind.is_constant() {
        return quote! { #runtime::testing::to_dense(algebra, &#local) };
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
    quote! { #runtime::testing::constant_to_dense(algebra, &[#(#terms),*]) }
}

fn call(operation: Operation, locals: &[Ident]) -> TokenStream {
    let first = &locals[0];
    let Some(second) = locals.get(1) else {
        let method = format_ident!("{}", operation.name());
        return quote! { #first.#method() };
    };
    if let Some(operator) = operator(operation) {
        return quote! { #first #operator #second };
    }
    let method = format_ident!("{}", operation.name());
    quote! { #first.#method(#second) }
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
    let test_name = format_ident!("type_{}", kind.name.unraw().to_string().to_snake_case());
    let multivector = quote! { #runtime::dense::Multivector };
    let dimension = definition.algebra.dimension();
    let same = |text: &str, found: TokenStream, expected: TokenStream| {
        quote! {
            #runtime::testing::assert_same(
                #text,
                &[&a, &b, &factor],
                &#runtime::testing::to_dense(algebra, &#found),
                &#expected,
            );
        }
    };
    let checks = [
        same(
            "~a",
            quote! { a.reverse() },
            quote! { #multivector::reverse(&x) },
        ),
        same(
            "involute(a)",
            quote! { a.involute() },
            quote! { #multivector::involute(&x) },
        ),
        same(
            "conjugate(a)",
            quote! { a.conjugate() },
            quote! { #multivector::conjugate(&x) },
        ),
        same("a + b", quote! { (a + b) }, quote! { (&x + &y) }),
        same("a - b", quote! { (a - b) }, quote! { (&x - &y) }),
        same("-a", quote! { (-a) }, quote! { (-&x) }),
        same(
            "a * factor",
            quote! { (a * factor) },
            quote! { #multivector::scale(&x, factor) },
        ),
        same(
            "a / factor",
            quote! { (a / factor) },
            quote! { #multivector::scale(&x, #runtime::scalar::Field::recip(factor)) },
        ),
    ];
    let of_grade = same(
        "a part of a",
        quote! { a.grade(grade) },
        quote! { #multivector::grade(&x, grade) },
    );
    let name = &kind.name;
    let linear = kind.is_linear().then(|| {
        quote! { #runtime::testing::check_linear::<#path::#name<_>>(a, b, factor); }
    });
    let product = has_product(definition, kind).then(|| {
        quote! { #runtime::testing::check_product::<#path::#name<_>>(a, b); }
    });
    let references = takes_references(kind).then(|| {
        quote! {
            ::std::assert_eq!((&a + b, a + &b, &a + &b), (a + b, a + b, a + b));
            ::std::assert_eq!((&a - b, a - &b, &a - &b), (a - b, a - b, a - b));
            ::std::assert_eq!((-&a, &a * factor, &a / factor), (-a, a * factor, a / factor));
        }
    });
    let body = quote! {
        let (a, b, factor) = (operand0, operand1, numbers[2][0]);
        let x = #runtime::testing::to_dense(algebra, &a);
        let y = #runtime::testing::to_dense(algebra, &b);
        #(#checks)*
        ::std::assert_eq!(a.norm_squared(), #multivector::norm_squared(&x));
        #runtime::testing::check_coefficients(a, algebra);
        #linear
        #product
        #references
        for grade in 0..=#dimension {
            #of_grade
        }
    };
    test(
        runtime,
        path,
        &test_name,
        &[(kind, false), (kind, false)],
        &body,
    )
}
