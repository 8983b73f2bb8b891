//! The operations of an algebra, and what each does to basis blades.

use super::{Algebra, Blade, BladeSum, Ratio};

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

    /// The product of two basis blades.
    #[must_use]
    pub fn of_blades(self, algebra: &Algebra, left: Blade, right: Blade) -> BladeSum {
        let make = || self.made(algebra, left, right).into();
        algebra.products.get(self, left, right, make)
    }

    fn made(self, algebra: &Algebra, left: Blade, right: Blade) -> Vec<(Blade, Ratio)> {
        let (r, s) = (left.grade(), right.grade());
        let of_grade = |grade: Option<u32>| -> Vec<(Blade, Ratio)> {
            let Some(grade) = grade else { return vec![] };
            let mut terms = algebra.geometric(left, right).to_vec();
            terms.retain(|(blade, _)| blade.grade() == grade);
            terms
        };
        match self {
            Self::Geometric => algebra.metric.geometric(left, right),
            Self::Wedge => {
                if left.0 & right.0 != 0 {
                    return vec![];
                }
                let sign = if left.wedge_is_negative(right) { -1 } else { 1 };
                vec![(Blade(left.0 | right.0), Ratio::integer(sign))]
            }
            Self::LeftContraction => of_grade(s.checked_sub(r)),
            Self::RightContraction => of_grade(r.checked_sub(s)),
            Self::ScalarProduct => of_grade(Some(0)),
            Self::Commutator => commutator(algebra, left, right),
            Self::Vee => vee(algebra, left, right),
        }
    }
}

impl Unary {
    /// The operation on a basis blade.
    #[must_use]
    pub fn of_blade(self, algebra: &Algebra, blade: Blade) -> Vec<(Blade, Ratio)> {
        let signed = |is_negative: bool| {
            let sign = if is_negative { -1 } else { 1 };
            vec![(blade, Ratio::integer(sign))]
        };
        match self {
            Self::Reverse => signed(blade.reverse_is_negative()),
            Self::Involute => signed(blade.involute_is_negative()),
            Self::Conjugate => signed(blade.conjugate_is_negative()),
            Self::Dual => algebra.dual(blade),
            Self::Undual => algebra.undual(blade),
            Self::Grade(grade) if blade.grade() == grade => signed(false),
            Self::Grade(_) => vec![],
        }
    }

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

fn commutator(algebra: &Algebra, left: Blade, right: Blade) -> Vec<(Blade, Ratio)> {
    let half = Ratio::ONE / Ratio::integer(2);
    let mut sums = Sums::default();
    for &(blade, value) in algebra.geometric(left, right).iter() {
        sums.add(blade, value * half);
    }
    for &(blade, value) in algebra.geometric(right, left).iter() {
        sums.add(blade, -(value * half));
    }
    sums.finish()
}

fn vee(algebra: &Algebra, left: Blade, right: Blade) -> Vec<(Blade, Ratio)> {
    let mut sums = Sums::default();
    for (a, first) in algebra.dual(left) {
        for (b, second) in algebra.dual(right) {
            for &(joined, third) in Product::Wedge.of_blades(algebra, a, b).iter() {
                for (blade, fourth) in algebra.undual(joined) {
                    sums.add(blade, first * second * third * fourth);
                }
            }
        }
    }
    sums.finish()
}

#[derive(Default)]
struct Sums(std::collections::BTreeMap<Blade, Ratio>);

impl Sums {
    fn add(&mut self, blade: Blade, value: Ratio) {
        let sum = self.0.entry(blade).or_insert(Ratio::ZERO);
        *sum = *sum + value;
    }

    fn finish(self) -> Vec<(Blade, Ratio)> {
        self.0
            .into_iter()
            .filter(|(_, value)| !value.is_zero())
            .collect()
    }
}
