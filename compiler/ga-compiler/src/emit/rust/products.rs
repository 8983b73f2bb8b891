//! The declared products: an operator or a trait for each pair of types, and methods of the
//! textbook's names.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::body::Needs;
use super::context::{Context, other, receiver};
use crate::algebra::Product;
use crate::define::{Definition, Operation, ProductDefinition, TypeDefinition};

/// How an operation on two operands appears in Rust.
pub(super) struct Face {
    /// The trait's path.
    pub(super) path: TokenStream,
    /// The trait's method.
    pub(super) method: &'static str,
    /// The formula, for the documentation.
    formula: &'static str,
}

pub(super) fn emit(context: &Context<'_>) -> TokenStream {
    let mut items = TokenStream::new();
    let products = &context.definition.products;
    let mut needs: Vec<Option<Needs>> = vec![None; products.len()];
    for (place, product) in products.iter().enumerate() {
        let face = match product.operation {
            Operation::Unary(_) => {
                items.extend(unary(context, product));
                continue;
            }
            Operation::Product(operation) => product_face(context, operation),
            Operation::Sandwich => sandwich_face(context),
        };
        let earlier = exchanged(context.definition, place).and_then(|earlier| needs[earlier]);
        let (body, needed) = match earlier {
            Some(needed) => {
                let (path, method) = (&face.path, format_ident!("{}", face.method));
                (quote! { #path::#method(other, self) }, needed)
            }
            None => binary_body(context, product),
        };
        items.extend(binary(context, product, &face, &body, needed));
        needs[place] = Some(needed);
    }
    for (index, kind) in context.definition.types.iter().enumerate() {
        items.extend(methods(context, index, kind));
    }
    items
}

pub(super) fn product_face(context: &Context<'_>, product: Product) -> Face {
    let operator = |name: &str, method, formula| {
        let name = format_ident!("{name}");
        Face {
            path: quote! { ::core::ops::#name },
            method,
            formula,
        }
    };
    match product {
        Product::Geometric => operator("Mul", "mul", "a b"),
        Product::Wedge => operator("BitXor", "bitxor", "a ∧ b"),
        Product::LeftContraction => operator("BitOr", "bitor", "a ⌋ b"),
        Product::Vee => operator("BitAnd", "bitand", "a ∨ b"),
        Product::RightContraction => {
            own_face(context, "RightContraction", "right_contraction", "a ⌊ b")
        }
        Product::ScalarProduct => own_face(context, "ScalarProduct", "scalar_product", "⟨a b⟩₀"),
        Product::Commutator => own_face(context, "Commutator", "commutator", "(a b − b a)/2"),
    }
}

fn sandwich_face(context: &Context<'_>) -> Face {
    own_face(context, "Sandwich", "sandwich", "a b ~a")
}

/// A trait of ga-runtime, for what has no operator.
fn own_face(
    context: &Context<'_>,
    name: &str,
    method: &'static str,
    formula: &'static str,
) -> Face {
    let (runtime, name) = (context.runtime, format_ident!("{name}"));
    Face {
        path: quote! { #runtime::products::#name },
        method,
        formula,
    }
}

/// The earlier of two products that are the same with their operands exchanged: `b ∧ a` beside
/// `a ∧ b`, where one of the grades is even. The later one calls it.
fn exchanged(definition: &Definition, place: usize) -> Option<usize> {
    let product = &definition.products[place];
    let Operation::Product(operation) = product.operation else {
        return None;
    };
    let dimension = definition.algebra.dimension();
    let is_even = |index: &usize, of_dual: bool| {
        let mut blades = definition.types[*index].coefficients.iter();
        blades.all(|c| {
            let is_odd = c.blade.grade() % 2 == 1;
            is_odd == (of_dual && dimension % 2 == 1)
        })
    };
    let mut operands = product.operands.iter();
    let is_symmetric = match operation {
        Product::Wedge => operands.any(|index| is_even(index, false)),
        Product::Vee => operands.any(|index| is_even(index, true)),
        Product::ScalarProduct => true,
        _ => false,
    };
    let is_of_blades = |p: &ProductDefinition| p.as_blades.iter().any(Option::is_some);
    let is_exchanged = |p: &ProductDefinition| {
        p.operation == product.operation
            && p.result == product.result
            && p.operands.iter().eq(product.operands.iter().rev())
            && !is_of_blades(p)
    };
    if !is_symmetric || is_of_blades(product) {
        return None;
    }
    definition.products[..place].iter().position(is_exchanged)
}

/// The body of a product of two operands, and what it requires of the scalar.
fn binary_body(context: &Context<'_>, product: &ProductDefinition) -> (TokenStream, Needs) {
    if is_of_products(context.definition, product) {
        let multiply = quote! { ::core::ops::Mul::mul };
        let body = quote! { #multiply(#multiply(self, other), self.reverse()) };
        return (body, Needs::Ring);
    }
    let result = product.result.map(|index| context.kind(index));
    let [first, second] = [0, 1].map(|place| operand_kind(context, product, place));
    let operands = [(first, receiver()), (second, other())];
    context.compile(&operands, &product.operation.expression(), result)
}

fn binary(
    context: &Context<'_>,
    product: &ProductDefinition,
    face: &Face,
    body: &TokenStream,
    needs: Needs,
) -> TokenStream {
    let (left, right) = (
        context.kind(product.operands[0]),
        context.kind(product.operands[1]),
    );
    let result = product.result.map(|index| context.kind(index));
    let (path, argument, output) = (
        context.path(left),
        context.path(right),
        context.result_path(result),
    );
    let (bound, name) = (context.bound(needs), &face.path);
    let method = format_ident!("{}", face.method);
    let inline = inline(&[left, right]);
    let text = format!(
        "`{}`: {}, {} → {}.",
        face.formula,
        left.name,
        right.name,
        result.map_or("scalar".to_owned(), |kind| kind.name.to_string())
    );
    quote! {
        #[doc = #text]
        impl<S: #bound> #name<#argument> for #path {
            type Output = #output;
            #inline
            fn #method(self, other: #argument) -> #output { #body }
        }
    }
}

/// The type of an operand, with what the product knows of it beside.
fn operand_kind<'a>(
    context: &Context<'a>,
    product: &'a ProductDefinition,
    place: usize,
) -> &'a TypeDefinition {
    let as_blade = product.as_blades[place].as_ref();
    as_blade.unwrap_or_else(|| context.kind(product.operands[place]))
}

/// Whether a product is `a b ~a` of two multivectors with all of many blades. No rule saves
/// anything there, and as two calls of their product it takes much less time to compile.
fn is_of_products(definition: &Definition, product: &ProductDefinition) -> bool {
    const LEAST: usize = 32;
    let [left, ..] = product.operands[..] else {
        return false;
    };
    let algebra = &definition.algebra;
    let dimension = algebra.dimension();
    let metric = algebra.metric();
    let mut places = (0..dimension).flat_map(|a| (0..dimension).map(move |b| (a, b)));
    let kind = &definition.types[left];
    let is_same = |p: &ProductDefinition, operation: Operation| {
        p.operation == operation && p.operands == [left, left] && p.result == Some(left)
    };
    let has_all = kind.is_linear() && kind.coefficients.len() == 1 << dimension;
    let geometric = Operation::Product(Product::Geometric);
    has_all
        && kind.coefficients.len() >= LEAST
        && is_same(product, Operation::Sandwich)
        && definition.products.iter().any(|p| is_same(p, geometric))
        && places.all(|(a, b)| metric.get(a, b).is_integer())
}

/// A product is inlined into its caller, and so is compiled for the instructions that the caller
/// may use: otherwise a loop over lanes in a function with `#[target_feature]` would call a
/// function without it. Products of the largest types are not inlined, since each copy of them is
/// long.
fn inline(operands: &[&TypeDefinition]) -> TokenStream {
    const LARGEST: usize = 12;
    let is_small = operands
        .iter()
        .all(|kind| kind.coefficients.len() <= LARGEST);
    if is_small {
        quote! { #[inline(always)] }
    } else {
        quote! { #[inline] }
    }
}

fn unary(context: &Context<'_>, product: &ProductDefinition) -> TokenStream {
    let kind = context.kind(product.operands[0]);
    let result = product.result.map(|index| context.kind(index));
    let operand = [(kind, receiver())];
    let (body, needs) = context.compile(&operand, &product.operation.expression(), result);
    let (path, output) = (context.path(kind), context.result_path(result));
    let (bound, name) = (
        context.bound(needs),
        format_ident!("{}", product.operation.name()),
    );
    let is_degenerate = context.definition.algebra.is_degenerate();
    let text = match (product.operation.name(), is_degenerate) {
        ("dual", false) => "The dual `a I⁻¹`.",
        ("dual", true) => "The right complement: `a ∧ dual a = I` for basis blades.",
        (_, false) => "The inverse of the dual, `a I`.",
        (_, true) => {
            "The left complement, inverse of the dual: `undual a ∧ a = I` for basis blades."
        }
    };
    quote! {
        impl<S: #bound> #path {
            #[doc = #text]
            #[inline]
            #[must_use]
            pub fn #name(self) -> #output { #body }
        }
    }
}

/// Inherent methods of the products that a type starts, so that no trait needs importing.
fn methods(context: &Context<'_>, index: usize, kind: &TypeDefinition) -> TokenStream {
    let mut methods = TokenStream::new();
    let operations = Product::ALL
        .into_iter()
        .map(|product| (Operation::Product(product), product_face(context, product)))
        .chain([(Operation::Sandwich, sandwich_face(context))]);
    for (operation, face) in operations {
        let starts = |product: &ProductDefinition| {
            product.operation == operation && product.operands[0] == index
        };
        if !context.definition.products.iter().any(starts) {
            continue;
        }
        let Face {
            path,
            method,
            formula,
        } = face;
        let (name, method) = (
            format_ident!("{}", operation.name()),
            format_ident!("{method}"),
        );
        let text = method_text(operation, formula, kind);
        methods.extend(quote! {
            #[doc = #text]
            #[inline(always)]
            #[must_use]
            pub fn #name<B>(self, other: B) -> <Self as #path<B>>::Output
            where
                Self: #path<B>,
            {
                #path::#method(self, other)
            }
        });
        if operation == Operation::Sandwich && kind.facts.unit_versor {
            methods.extend(quote! {
                /// Moves another element by this versor, `x ↦ M x ~M`; the same as
                /// [`sandwich`](Self::sandwich).
                #[inline(always)]
                #[must_use]
                pub fn transform<B>(self, other: B) -> <Self as #path<B>>::Output
                where
                    Self: #path<B>,
                {
                    #path::#method(self, other)
                }
            });
        }
    }
    if methods.is_empty() {
        return TokenStream::new();
    }
    let path = context.path(kind);
    let generics = (!kind.is_constant()).then(|| quote! { <S> });
    quote! { impl #generics #path { #methods } }
}

fn method_text(operation: Operation, formula: &str, kind: &TypeDefinition) -> String {
    match operation {
        Operation::Sandwich if is_odd(kind) => {
            "The action of an odd versor, `a b̂ ~a` with the grade involution of b.".to_owned()
        }
        Operation::Sandwich => "The action of a versor, `a b ~a`.".to_owned(),
        Operation::Product(_) | Operation::Unary(_) => format!(
            "The {} product, `{formula}`.",
            operation.name().replace('_', " ")
        )
        .replace("contraction product", "contraction")
        .replace("scalar product product", "scalar product")
        .replace("commutator product", "commutator")
        .replace("vee product", "regressive product (vee)"),
    }
}

fn is_odd(kind: &TypeDefinition) -> bool {
    kind.coefficients
        .iter()
        .all(|c| c.blade.involute_is_negative())
}
