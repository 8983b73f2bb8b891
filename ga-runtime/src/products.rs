//! The products that no operator of Rust stands for, as traits for generic code.
//!
//! Where the pair of types is known the inherent method of the same name does, without any import.
//! The other products are `*` ([`Mul`](core::ops::Mul), geometric), `^`
//! ([`BitXor`](core::ops::BitXor), wedge), `|` ([`BitOr`](core::ops::BitOr), left contraction) and
//! `&` ([`BitAnd`](core::ops::BitAnd), vee).

/// The right contraction `a ⌊ b`: of grades r and s the part of grade r − s of `a b`.
pub trait RightContraction<B> {
    /// The type of the result.
    type Output;
    /// `self ⌊ other`.
    fn right_contraction(self, other: B) -> Self::Output;
}

/// The scalar product `⟨a b⟩₀`, nothing reversed.
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
/// For a unit versor it is a motion, and `M` and `−M` move alike.
pub trait Sandwich<B> {
    /// The type of the result.
    type Output;
    /// Moves `other` by `self`.
    fn sandwich(self, other: B) -> Self::Output;
}
