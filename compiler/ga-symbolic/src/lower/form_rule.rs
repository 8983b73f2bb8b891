//! The names of the rules by which formulas are rewritten.

/// An identity of geometric algebra by which a formula has another form. Each is stated and proved
/// in the file of its name in `forms/rules`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum FormRule {
    /// `~(a b) = ~b ~a`.
    Reversal,
    /// `(a b) c = a (b c)`.
    Associativity,
    /// `M X ~M` is the action of a versor, and `M ~M = 1`.
    Conjugation,
    /// `(a b) X ~(a b) = a (b X ~b) ~a`.
    Composition,
    /// `M (a ∘ b) ~M = (M a ~M) ∘ (M b ~M)`.
    Outermorphism,
    /// `M (a + b) ~M = M a ~M + M b ~M`.
    Linearity,
    /// `M ⟨X⟩₀ ~M = ⟨X⟩₀`.
    InvariantPart,
    /// `M² = M (M + ~M) − 1`.
    Power,
    /// `(a b − b a)/2 = a × b`, `⟨a b⟩₀ = a · b`, and so on.
    Definition,
    /// `undual(dual a ∧ dual b) = a ∨ b`.
    Duality,
    /// `(a/s) b = (a b)/s`.
    Quotient,
    /// `a (b + c) = a b + a c`, and `s (a b) = (s a) b` for a scalar s.
    Distribution,
    /// `a ∧ b = a ∧ (b − λ a)`.
    Difference,
    /// `v X v = 2 v ∧ (v ⌋ X) ± v² X` and `(X ∧ v) v = v² X − (X ⌊ v) v` for a vector v.
    Vector,
    /// `a · (M b ~M) = (~M a M) · b`.
    Adjoint,
    /// `(s a) ∘ b = s (a ∘ b)` for a scalar s.
    ScalarFactor,
    /// `f(a, b) = T f(~T a T, ~T b T) ~T` for a translation T.
    Frame,
    /// `M X ~M = N X ~N / (N ~N)` for `M = N/√(N ~N)`.
    Unnormalised,
}

impl FormRule {
    /// Every rule.
    pub const ALL: [Self; 18] = [
        Self::Reversal,
        Self::Associativity,
        Self::Conjugation,
        Self::Composition,
        Self::Outermorphism,
        Self::Linearity,
        Self::InvariantPart,
        Self::Power,
        Self::Definition,
        Self::Duality,
        Self::Quotient,
        Self::Distribution,
        Self::Difference,
        Self::Vector,
        Self::Adjoint,
        Self::ScalarFactor,
        Self::Frame,
        Self::Unnormalised,
    ];

    /// The rule in words.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Reversal => "reversed product",
            Self::Associativity => "associativity",
            Self::Conjugation => "conjugation",
            Self::Composition => "composed actions",
            Self::Outermorphism => "outermorphism",
            Self::Linearity => "linear action",
            Self::InvariantPart => "invariant part",
            Self::Power => "power of a versor",
            Self::Definition => "product by its definition",
            Self::Duality => "duality",
            Self::Quotient => "quotient of a product",
            Self::Distribution => "distribution",
            Self::Difference => "join with a difference",
            Self::Vector => "product with a vector",
            Self::Adjoint => "adjoint action",
            Self::ScalarFactor => "scalar factor",
            Self::Frame => "seen from a point",
            Self::Unnormalised => "action without a root",
        }
    }
}
