//! The action of a versor, by one of several rules that agree where they apply.

use super::linear_map::{acted, is_odd, kept, linear_map};
use super::reflection::Form;
use super::{null_image, reflection, scaled_split, split};
use crate::algebra::{Algebra, Product, Unary};
use crate::ir::{Arena, Multivector};

/// How `M X ~M` is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SandwichRule {
    /// `(M X) ~M`, the plain meaning, for any M.
    LeftFirst,
    /// `M (X ~M)`, equal by associativity, for any M.
    RightFirst,
    /// `X + [M, X] ~M` with `[M, X] = M X − X M`, for an even M with `M ~M = 1`: then
    /// `M X ~M = (X M + [M, X]) ~M = X + [M, X] ~M`. The scalar of M and every pair of commuting
    /// blades drop out before anything is multiplied. For an odd M the same with
    /// `[M, X] = M X̂ − X M`.
    UnitCommutator,
    /// `Σ x (M b ~M)` over the blades b of X with coefficients x, by linearity. What M does to the
    /// blades is computed once, and entries that agree up to sign are one node, so that it pays
    /// for an X of many blades.
    LinearMap,
    /// `T (R X ~R) ~T` with `M = T R`, R the part of M without some null vector; see [`split`].
    Split,
    /// `v² X − 2 v∧(v⌋X)` for a vector v, or the pseudoscalar times one; see [`reflection`].
    ReflectionInner,
    /// `2 v⌋(v∧X) − v² X` for the same; see [`reflection`].
    ReflectionOuter,
    /// `K i ~K / 2(x·i)` with `K = M x`, for a null vector x and a null basis vector i; see
    /// [`null_image`].
    NullImage,
    /// The same by `[M, x]`, for a versor that keeps i up to a factor; see [`null_image`].
    NullImageCommutator,
    /// `T (P X ~P) ~T` with `M = T P`, P a rotation with a scaling; see [`scaled_split`].
    ScaledSplit,
    /// The same, with the map of the rotation.
    ScaledSplitMap,
}

impl SandwichRule {
    /// Every rule, in the order in which they are tried.
    pub const ALL: [Self; 11] = [
        Self::LeftFirst,
        Self::RightFirst,
        Self::UnitCommutator,
        Self::LinearMap,
        Self::Split,
        Self::ReflectionInner,
        Self::ReflectionOuter,
        Self::NullImage,
        Self::NullImageCommutator,
        Self::ScaledSplit,
        Self::ScaledSplitMap,
    ];

    /// Lowers the action of `versor` on `operand`; `None` where the rule does not apply.
    ///
    /// A unit versor keeps the grades of what it acts on, so by every rule only blades of these
    /// grades are built. For an odd versor the operand is involuted first: `M X̂ ~M`.
    #[must_use]
    pub fn lower(
        self,
        arena: &mut Arena,
        algebra: &Algebra,
        versor: &Multivector,
        operand: &Multivector,
    ) -> Option<Multivector> {
        let is_odd = is_odd(versor);
        let is_unit = versor.facts.unit_versor;
        let image = if is_odd {
            operand.unary(arena, algebra, Unary::Involute)
        } else {
            operand.clone()
        };
        let result = match self {
            Self::LeftFirst => left_first(arena, algebra, versor, &image),
            Self::RightFirst => right_first(arena, algebra, versor, &image),
            Self::UnitCommutator if is_unit => acted(arena, algebra, versor, operand),
            Self::LinearMap if is_unit => linear_map(arena, algebra, versor, operand),
            Self::Split if is_unit => split::lower(arena, algebra, versor, operand)?,
            Self::ReflectionInner => {
                reflection::lower(Form::Inner, arena, algebra, versor, operand)?
            }
            Self::ReflectionOuter => {
                reflection::lower(Form::Outer, arena, algebra, versor, operand)?
            }
            Self::NullImage => null_image::lower(arena, algebra, versor, operand)?,
            Self::NullImageCommutator => {
                null_image::by_commutator(arena, algebra, versor, operand)?
            }
            Self::ScaledSplit if is_unit => {
                let form = scaled_split::Form::Commutator;
                scaled_split::lower(form, arena, algebra, versor, operand)?
            }
            Self::ScaledSplitMap if is_unit => {
                let form = scaled_split::Form::LinearMap;
                scaled_split::lower(form, arena, algebra, versor, operand)?
            }
            Self::UnitCommutator
            | Self::LinearMap
            | Self::Split
            | Self::ScaledSplit
            | Self::ScaledSplitMap => return None,
        };
        // For an odd unit versor M the map X → M X̂ ~M is an automorphism too.
        Some(result.with_facts(versor.facts.of_sandwich(operand.facts)))
    }
}

fn left_first(
    arena: &mut Arena,
    algebra: &Algebra,
    versor: &Multivector,
    image: &Multivector,
) -> Multivector {
    let half = versor.product(arena, algebra, Product::Geometric, image, |_| true);
    let reverse = versor.unary(arena, algebra, Unary::Reverse);
    half.product(
        arena,
        algebra,
        Product::Geometric,
        &reverse,
        kept(versor, image),
    )
}

fn right_first(
    arena: &mut Arena,
    algebra: &Algebra,
    versor: &Multivector,
    image: &Multivector,
) -> Multivector {
    let reverse = versor.unary(arena, algebra, Unary::Reverse);
    let half = image.product(arena, algebra, Product::Geometric, &reverse, |_| true);
    versor.product(
        arena,
        algebra,
        Product::Geometric,
        &half,
        kept(versor, image),
    )
}
