//! The operations of an algebra.

/// A bilinear product.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Product {
    /// `a b`.
    Geometric,
    /// `a ∧ b`: the part of grade r + s.
    Wedge,
    /// `a ⌋ b`: the part of grade s − r.
    LeftContraction,
    /// `a ⌊ b`: the part of grade r − s.
    RightContraction,
    /// `⟨a b⟩₀`, without a reversal.
    ScalarProduct,
    /// `(a b − b a)/2`.
    Commutator,
    /// `a ∨ b = undual(dual a ∧ dual b)`.
    Vee,
}

/// A linear operation on one operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Unary {
    /// The order of all vectors reversed.
    Reverse,
    /// Odd grades negated.
    Involute,
    /// Reverse and involute together.
    Conjugate,
    /// `a I⁻¹`, or the right complement where I is singular.
    Dual,
    /// The inverse of the dual.
    Undual,
    /// The part of one grade.
    Grade(u32),
}

impl Product {
    /// Every product, in the order of the documentation.
    pub const ALL: [Self; 7] = [
        Self::Geometric,
        Self::Wedge,
        Self::LeftContraction,
        Self::RightContraction,
        Self::ScalarProduct,
        Self::Commutator,
        Self::Vee,
    ];

    /// The name of the product as a function.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Geometric => "geometric",
            Self::Wedge => "wedge",
            Self::LeftContraction => "left_contraction",
            Self::RightContraction => "right_contraction",
            Self::ScalarProduct => "scalar_product",
            Self::Commutator => "commutator",
            Self::Vee => "vee",
        }
    }

    /// The product of that name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|product| product.name() == name)
    }
}

impl Unary {
    /// The name of the operation as a method.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Reverse => "reverse",
            Self::Involute => "involute",
            Self::Conjugate => "conjugate",
            Self::Dual => "dual",
            Self::Undual => "undual",
            Self::Grade(_) => "grade",
        }
    }
}
