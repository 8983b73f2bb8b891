//! What every type has beside its products, as entries of a macro of ga-runtime that holds the
//! code: coefficients by name, text, assignment, sums and products of many, conversions that check.

use heck::ToShoutySnakeCase;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::ext::IdentExt;

use super::arithmetic::type_of_multiples;
use super::coefficients::needs;
use super::context::Context;
use super::types::is_identity;
use super::versors::in_norm;
use crate::algebra::{Blade, Product, Ratio};
use crate::define::{Coefficient, Definition, Operation, ProductDefinition, TypeDefinition};

pub(super) fn emit(context: &Context<'_>) -> TokenStream {
    let runtime = context.runtime;
    let types = context.definition.types.iter();
    let entries = types
        .filter(|kind| !kind.is_constant() && kind.is_readable())
        .flat_map(|kind| entries(context, kind));
    quote! { #runtime::__private::surface! { #({ #entries })* } }
}

fn entries(context: &Context<'_>, kind: &TypeDefinition) -> Vec<TokenStream> {
    let name = &kind.name;
    let bound = format_ident!("{}", needs(context, kind).name());
    let hull = context.hull(kind);
    let graded = &hull.name;
    let mut entries = vec![quote! { element #name #graded #bound }];
    if kind.is_linear() {
        entries.push(quote! { linear #name });
        let measured = in_norm(context, kind);
        if !measured.is_empty() {
            let fields = kind.stored().map(|c| &c.name);
            entries.push(quote! { normalized #name [#(#measured)*] [#(#fields)*] });
        }
    } else if kind.parameters.is_some() && type_of_multiples(context, kind).name == *name {
        entries.push(quote! { unit_multiple #name });
    }
    if !kind.is_linear() && is_closed(context.definition, kind, |_| true) {
        entries.push(quote! { multiplied #name });
    }
    if kind.facts.unit_versor && kind.facts_are_implied {
        entries.push(quote! { always_unit #name });
    }
    if has_product(context.definition, kind) {
        entries.push(quote! { product #name });
    }
    entries.extend(constants(kind));
    entries.extend(checked_sources(context, kind).into_iter().map(|source| {
        let source = &source.name;
        quote! { try_from #source #name }
    }));
    if let Some(scalar) = hull.stored().find(|c| c.blade == Blade::SCALAR) {
        let (hull, scalar) = (&hull.name, &scalar.name);
        entries.push(quote! { with_scalar #name #hull #scalar #bound });
        if kind.is_linear() {
            entries.push(quote! { number_and #name #hull });
        }
    }
    if takes_references(kind) {
        entries.extend(references(context, kind));
    }
    entries
}

/// Whether there are operators on references to the type. Each costs time when the algebra is
/// built, so there are some for what programs keep in lists: points, vectors, directions, planes
/// and rigid versors.
pub(super) fn takes_references(kind: &TypeDefinition) -> bool {
    let grades = || kind.coefficients.iter().map(|c| c.blade.grade());
    let is_of_one_grade = grades().min() == grades().max();
    match kind.count() {
        2..=4 => is_of_one_grade || kind.facts.unit_versor,
        5..=8 => kind.facts.unit_versor,
        _ => false,
    }
}

/// The trait and the method of a product's operator.
fn operator(operation: Operation) -> Option<TokenStream> {
    let Operation::Product(product) = operation else {
        return None;
    };
    match product {
        Product::Geometric => Some(quote! { Mul mul }),
        Product::Wedge => Some(quote! { BitXor bitxor }),
        Product::LeftContraction => Some(quote! { BitOr bitor }),
        Product::Vee => Some(quote! { BitAnd bitand }),
        Product::RightContraction | Product::ScalarProduct | Product::Commutator => None,
    }
}

fn references(context: &Context<'_>, kind: &TypeDefinition) -> [TokenStream; 2] {
    let name = &kind.name;
    let is_kind = |index: usize| context.kind(index).name == *name;
    let products = &context.definition.products;
    // Every type has sums and multiples.
    let mut traits = vec![
        quote! { Add add },
        quote! { Sub sub },
        quote! { Mul mul },
        quote! { Div div },
    ];
    for product in [Product::Wedge, Product::LeftContraction, Product::Vee] {
        let operation = Operation::Product(product);
        let starts = |p: &ProductDefinition| p.operation == operation && is_kind(p.operands[0]);
        if products.iter().any(starts) {
            traits.extend(operator(operation));
        }
    }
    let lefts = products.iter().filter_map(|product| {
        let operator = operator(product.operation)?;
        let left = context.kind(product.operands[0]);
        let is_right = is_kind(*product.operands.get(1)?) && takes_references(left);
        let left = &left.name;
        is_right.then(|| quote! { #left #operator })
    });
    [
        quote! { references #name [#(#traits)*] },
        quote! { reference_to #name #name Add add #name Sub sub #(#lefts)* },
    ]
}

/// Whether the geometric product of a member with some type on the right is a member.
fn is_closed(
    definition: &Definition,
    kind: &TypeDefinition,
    right: impl Fn(&TypeDefinition) -> bool,
) -> bool {
    let is_kind = |index: usize| definition.types[index].name == kind.name;
    definition.products.iter().any(|product| {
        product.operation == Operation::Product(Product::Geometric)
            && is_kind(product.operands[0])
            && right(&definition.types[product.operands[1]])
            && product.result.is_some_and(is_kind)
    })
}

/// Whether 1 is a member, and so are products of members.
pub(super) fn has_product(definition: &Definition, kind: &TypeDefinition) -> bool {
    is_identity(kind, &one) && is_closed(definition, kind, |right| right.name == kind.name)
}

/// The stored coefficients of 1.
fn one(c: &Coefficient) -> Ratio {
    if c.blade == Blade::SCALAR {
        Ratio::ONE
    } else {
        Ratio::ZERO
    }
}

/// Zero, one and the basis vectors, where they are members.
fn constants(kind: &TypeDefinition) -> Vec<TokenStream> {
    if kind.parameters.is_some() {
        return Vec::new();
    }
    let name = &kind.name;
    let fields = || kind.stored().map(|c| &c.name);
    let mut constants = Vec::new();
    if is_identity(kind, &one) {
        let values = kind.stored().map(|c| {
            let constant = format_ident!("{}", if one(c).is_zero() { "ZERO" } else { "ONE" });
            let field = &c.name;
            quote! { #field #constant }
        });
        let constant = format_ident!("{}", if kind.is_linear() { "ONE" } else { "IDENTITY" });
        constants.push(quote! { one #name #constant [#(#values)*] });
    }
    if !kind.is_linear() {
        return constants;
    }
    let is_vector = kind.coefficients.iter().all(|c| c.blade.grade() == 1);
    let mut basis: Vec<_> = fields()
        .filter(|_| is_vector)
        .map(|field| (field, field.unraw().to_string().to_shouty_snake_case()))
        .collect();
    let names: Vec<_> = basis.iter().map(|(_, name)| name.clone()).collect();
    basis.retain(|(_, name)| {
        let is_unique = names.iter().filter(|other| *other == name).count() == 1;
        is_unique && !["ZERO", "ONE"].contains(&name.as_str())
    });
    let basis = basis.iter().map(|(field, name)| {
        let name = format_ident!("{name}");
        quote! { #field #name }
    });
    let fields = fields();
    constants.push(quote! { zero #name [#(#fields)*] [#(#basis)*] });
    constants
}

/// The types with a `TryFrom` to a type, some of whose elements are members: its hull, the smallest
/// and the largest linear type of more blades, and, for unit versors, all wider types of them. Any
/// other type has `try_from_element`.
fn checked_sources<'a>(context: &Context<'a>, kind: &TypeDefinition) -> Vec<&'a TypeDefinition> {
    let covers = |a: &TypeDefinition, b: &TypeDefinition| {
        let mut blades = b.coefficients.iter();
        blades.all(|c| a.coefficient(c.blade).is_some())
    };
    let wider: Vec<_> = context
        .definition
        .types
        .iter()
        .filter(|source| {
            let is_other = source.name != kind.name && source.is_readable();
            is_other && !source.is_constant() && covers(source, kind)
        })
        .collect();
    let linear = || {
        let is_source = |source: &&&TypeDefinition| {
            source.is_linear() && (!kind.is_linear() || !covers(kind, source))
        };
        wider.iter().filter(is_source).copied()
    };
    let size = |source: &&TypeDefinition| source.coefficients.len();
    let hull = kind.hull.map(|hull| context.kind(hull));
    let ends = [hull, linear().min_by_key(size), linear().max_by_key(size)];
    let versors = wider.iter().copied().filter(|source| {
        source.facts.unit_versor && kind.facts.unit_versor && !covers(kind, source)
    });
    let mut sources: Vec<&TypeDefinition> = Vec::new();
    for source in ends.into_iter().flatten().chain(versors) {
        if sources.iter().all(|known| known.name != source.name) {
            sources.push(source);
        }
    }
    sources
}
