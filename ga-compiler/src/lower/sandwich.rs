//! The action of a versor, by one of several rules that agree wherever they apply.

use crate::algebra::{Algebra, Blade, Product, Ratio, Unary};
use crate::ir::{Arena, Facts, Multivector};

/// How `M X ~M` is worked out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SandwichRule {
    /// `(M X) ~M`, the plain meaning, for any M.
    LeftFirst,
    /// `M (X ~M)`, equal by associativity, for any M.
    RightFirst,
    /// `X + [M, X] ~M` with `[M, X] = M X − X M`, for an even M with `M ~M = 1`: then
    /// `M X ~M = (X M + [M, X]) ~M = X + [M, X] ~M`. The scalar of M and every pair of commuting blades drop out
    /// before anything is multiplied.
    UnitCommutator,
}

impl SandwichRule {
    /// Every rule.
    pub const ALL: [Self; 3] = [Self::LeftFirst, Self::RightFirst, Self::UnitCommutator];

    /// Lowers the action of `versor` on `operand`.
    ///
    /// Whichever rule, a versor keeps the grades of what it acts on, so no other blade is built. For an odd versor the
    /// operand is involuted first: `M X̂ ~M`.
    #[must_use]
    pub fn lower(
        self,
        arena: &mut Arena,
        algebra: &Algebra,
        versor: &Multivector,
        operand: &Multivector,
    ) -> Multivector {
        let is_odd = is_odd(versor);
        let image = if is_odd {
            operand.unary(arena, algebra, Unary::Involute)
        } else {
            operand.clone()
        };
        let grades = grades(operand);
        let keeps_grades = versor.facts.unit_versor;
        let wanted = |blade: Blade| !keeps_grades || grades & 1 << blade.grade() != 0;
        let reverse = versor.unary(arena, algebra, Unary::Reverse);
        let any = |_: Blade| true;
        let product = Product::Geometric;
        let result = match self {
            Self::UnitCommutator if versor.facts.unit_versor && !is_odd => {
                let commutator = versor.product(arena, algebra, Product::Commutator, &image, any);
                let change = commutator
                    .scaled(Ratio::integer(2))
                    .product(arena, algebra, product, &reverse, wanted);
                image.sum(arena, &change)
            }
            Self::RightFirst => {
                let half = image.product(arena, algebra, product, &reverse, any);
                versor.product(arena, algebra, product, &half, wanted)
            }
            Self::LeftFirst | Self::UnitCommutator => {
                let half = versor.product(arena, algebra, product, &image, any);
                half.product(arena, algebra, product, &reverse, wanted)
            }
        };
        let facts = if is_odd {
            Facts::default()
        } else {
            versor.facts.of_sandwich(operand.facts)
        };
        result.with_facts(facts)
    }
}

fn is_odd(versor: &Multivector) -> bool {
    let mut blades = versor.terms().iter().map(|(blade, _)| blade);
    blades.len() > 0 && blades.all(|blade| blade.involute_is_negative())
}

fn grades(operand: &Multivector) -> u32 {
    operand
        .terms()
        .iter()
        .fold(0, |set, (blade, _)| set | 1 << blade.grade())
}
