//! The products without an operator in Rust, as traits for generic code.
//!
//! Where the types of the operands are known, the inherent method of the same name does the same
//! and needs no import. The other products are `*` ([`Mul`](core::ops::Mul), geometric), `^`
//! ([`BitXor`](core::ops::BitXor), wedge), `|` ([`BitOr`](core::ops::BitOr), left contraction) and
//! `&` ([`BitAnd`](core::ops::BitAnd), vee).

/// The right contraction `a ⌊ b`: of grades r and s the part of grade r − s of `a b`.
pub trait RightContraction<B> {
    /// The type of the result.
    type Output;
    /// `self ⌊ other`.
    fn right_contraction(self, other: B) -> Self::Output;
}

/// The scalar product `⟨a b⟩₀`, without reversal.
pub trait ScalarProduct<B> {
    /// The type of the result.
    type Output;
    /// `⟨self other⟩₀`.
    fn scalar_product(self, other: B) -> Self::Output;
}

/// The commutator `(a b − b a)/2`.
pub trait Commutator<B> {
    /// The type of the result.
    type Output;
    /// `(self other − other self)/2`.
    fn commutator(self, other: B) -> Self::Output;
}

/// The action of a versor: `M x ~M` for an even M, `M x̂ ~M` with the grade involution of x for an
/// odd one.
///
/// For a unit versor it preserves inner products, and `M` and `−M` act in the same way.
pub trait Sandwich<B> {
    /// The type of the result.
    type Output;
    /// The action of `self` on `other`.
    fn sandwich(self, other: B) -> Self::Output;
}

/// The bound of a geometric product that is not declared, so that the error says how to declare it.
/// No type implements it.
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "the product `{V} * {Self}` is not declared",
    label = "not a declared product",
    note = "a versor moves an element by `versor.transform(element)`",
    note = "the line `geometric({V}, {Self});` in `products` of the algebra would declare it, with the \
            bare names of the types",
    note = "in `ga!` there are all products of all types"
)]
pub trait GeometricFactor<V> {}

/// The same of an outer product. No type implements it.
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "the product `{V} ^ {Self}` is not declared",
    label = "not a declared product",
    note = "the line `wedge({V}, {Self});` in `products` of the algebra would declare it, with the \
            bare names of the types",
    note = "in `ga!` there are all products of all types"
)]
pub trait WedgeFactor<V> {}

/// The same of a left contraction. No type implements it.
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "the product `{V} | {Self}` is not declared",
    label = "not a declared product",
    note = "the line `left_contraction({V}, {Self});` in `products` of the algebra would declare it, with the \
            bare names of the types",
    note = "in `ga!` there are all products of all types"
)]
pub trait ContractionFactor<V> {}

/// The same of a regressive product. No type implements it.
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "the product `{V} & {Self}` is not declared",
    label = "not a declared product",
    note = "the line `vee({V}, {Self});` in `products` of the algebra would declare it, with the \
            bare names of the types",
    note = "in `ga!` there are all products of all types"
)]
pub trait VeeFactor<V> {}

/// The bound of a product that is always zero. No type implements it.
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "this product of `{V}` and `{Self}` is zero for all operands, so it is not declared",
    label = "always zero"
)]
pub trait VanishingFactor<V> {}
