//! The image of a point divided by its weight, without a division.
//!
//! Let V be a unit versor, i and o a null pair of the basis, and A of blades without i and o with
//! `V i = A i`: V keeps infinity, as similarities do. Then `V i ~V = A i ~A = λ i` with
//! `λ = A ~A`, for an odd V with the involution, and hence `~V i V = i/λ`. For the image
//! `y = V x ~V` of a null vector x that has a constant coefficient of o
//!
//! - `y·i = x·(~V i V) = (x·i)/λ`: the reciprocal of the weight of y is λ divided by the weight of
//!   x. Where V has no o at all, `V ~V = 1` says `A ~A = 1`, and the weight stays.
//! - `λ y i = λ V x ~V i = V x i ~V = K i ~A` with `K = V x`, since
//!   `i ~V = ~(V i) = ~(A i) = i ~A`. The part of grade 2 gives the coefficients of λ y but that of
//!   i, and `y² = 0` gives that.
//! - For a further versor U that keeps the weight, `U y ~U` divided by its weight is
//!   `U (y divided by its weight) ~U`. For any other U that is divided by its weight once more,
//!   since a multiple of y has the same multiple as image.

use super::null_image::{half_image, pair_of, vector};
use super::null_pair::NullPair;
use super::sandwich::SandwichRule;
use crate::algebra::{Algebra, Blade, Product, Ratio, Unary};
use crate::ir::{Arena, Facts, Multivector};

/// How the image of a point is divided by its weight.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ProjectionRule {
    /// By a division.
    #[default]
    Division,
    /// By multiplication with λ.
    Reciprocal,
    /// As `K i ~A`.
    Image,
}

/// What a versor makes of an operand.
pub(super) struct Image {
    pub(super) rule: SandwichRule,
    pub(super) versor: Multivector,
    pub(super) operand: Multivector,
    pub(super) value: Multivector,
}

impl ProjectionRule {
    /// Every rule, in the order in which they are tried.
    pub const ALL: [Self; 3] = [Self::Division, Self::Reciprocal, Self::Image];

    /// Lowers an image divided by its weight; `None` where the rule does not apply.
    pub(super) fn lower(
        self,
        arena: &mut Arena,
        algebra: &Algebra,
        image: &Image,
        partner: Blade,
    ) -> Option<Multivector> {
        let (pair, weight) = pair_of(algebra, &image.operand)?;
        let is_unit = image.versor.facts.unit_versor;
        if self == Self::Division || !is_unit || Blade::vector(pair.partner) != partner {
            return None;
        }
        let matrix = pair.folded(arena, &image.versor);
        if has_partner(&matrix, pair) {
            return None;
        }
        let reverse = matrix.unary(arena, algebra, Unary::Reverse);
        let by_weight = weight.recip()?;
        let place = if self == Self::Reciprocal {
            let factor = matrix.product(arena, algebra, Product::ScalarProduct, &reverse, |_| true);
            let place = image.value.filtered(|blade| pair.rest(blade) == blade);
            factor
                .product(arena, algebra, Product::Geometric, &place, |_| true)
                .scaled(by_weight)
        } else {
            let null = vector(arena, pair.null);
            let product = half_image(arena, algebra, pair, &image.versor, &image.operand)
                .product(arena, algebra, Product::Geometric, &null, |_| true)
                .product(arena, algebra, Product::Geometric, &reverse, |blade| {
                    blade.grade() == 2 && pair.is_upper(blade)
                });
            pair.without_null(arena, &product).scaled(by_weight)
        };
        let facts = Facts {
            null: true,
            blade: image.operand.facts.blade,
            ..Facts::default()
        };
        Some(completed(arena, algebra, pair, &place)?.with_facts(facts))
    }
}

/// Whether a versor keeps the weight, the coefficient of a basis vector, since it has no blade with
/// that vector.
pub(super) fn keeps_weight(algebra: &Algebra, versor: &Multivector, partner: Blade) -> bool {
    let is_partner = |pair: &NullPair| Blade::vector(pair.partner) == partner;
    versor.facts.unit_versor
        && NullPair::all(algebra)
            .find(is_partner)
            .is_some_and(|pair| !has_partner(versor, pair))
}

fn has_partner(value: &Multivector, pair: NullPair) -> bool {
    let mut blades = value.terms().iter();
    blades.any(|(blade, _)| blade.contains(pair.partner))
}

/// The null vector of weight 1 with the given other coefficients.
fn completed(
    arena: &mut Arena,
    algebra: &Algebra,
    pair: NullPair,
    place: &Multivector,
) -> Option<Multivector> {
    let partner = vector(arena, pair.partner);
    let place = place.sum(arena, &partner);
    let square = place.product(arena, algebra, Product::ScalarProduct, &place, |_| true);
    let rest = square
        .coefficient(Blade::SCALAR)
        .scaled((Ratio::integer(-2) * pair.inner).recip()?);
    let rest = Multivector::new(arena, [(Blade::vector(pair.null), rest)]);
    Some(place.sum(arena, &rest))
}
