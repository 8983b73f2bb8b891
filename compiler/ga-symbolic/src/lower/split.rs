//! A versor as a rotation followed by a translation.
//!
//! Let v be a basis vector with v² = 0 that is orthogonal to every other vector that occurs in the
//! blades of M. The number of times that v occurs in a blade then adds up in products, and two
//! times give zero. So of `M ~M = 1` the part without v says `R ~R = 1` for the part R of M without
//! v, and with `T = M ~R = 1 + τ`, where every blade of τ has v, `T ~T = 1` says `~τ = −τ`. Hence
//!
//! - `M = T R`, and `M X ~M = T (R X ~R) ~T`;
//! - τ is even whatever the parity of M, and has grades 2 and 3 modulo 4 only;
//! - `τ² = 0`, so `T Y ~T = Y + [τ, Y] − τ Y τ = Y + 2 τ × (Y + τ × Y)` with
//!   `a × b = (a b − b a)/2`.

use super::linear_map::linear_map;
use crate::algebra::{Algebra, Blade, Product, Ratio, Unary};
use crate::ir::{Arena, Facts, Multivector, Value};

/// Lowers the action of a unit versor by its split; `None` where no vector splits it.
pub(super) fn lower(
    arena: &mut Arena,
    algebra: &Algebra,
    versor: &Multivector,
    operand: &Multivector,
) -> Option<Multivector> {
    let null = null_vector(algebra, versor)?;
    let unit = Facts {
        unit_versor: true,
        ..Facts::default()
    };
    let rotation = versor
        .filtered(|blade| !blade.contains(null))
        .with_facts(unit);
    let rest = versor.filtered(|blade| blade.contains(null));
    let reverse = rotation.unary(arena, algebra, Unary::Reverse);
    let translation = rest.product(arena, algebra, Product::Geometric, &reverse, |blade| {
        blade.reverse_is_negative()
    });
    let rotated = linear_map(arena, algebra, &rotation, operand);
    Some(translated(arena, algebra, &translation, &rotated))
}

/// `T Y ~T` for `T = 1 + τ` with `~τ = −τ` and `τ² = 0`.
pub(super) fn translated(
    arena: &mut Arena,
    algebra: &Algebra,
    translation: &Multivector,
    operand: &Multivector,
) -> Multivector {
    let step = translation.product(arena, algebra, Product::Commutator, operand, |_| true);
    let middle = operand.sum(arena, &step);
    let change = translation.product(arena, algebra, Product::Commutator, &middle, |_| true);
    operand.sum(arena, &change.scaled(Ratio::integer(2)))
}

/// The index of the vector that splits the versor.
fn null_vector(algebra: &Algebra, versor: &Multivector) -> Option<usize> {
    let occurring = versor
        .terms()
        .iter()
        .fold(0, |set, (blade, _)| set | blade.0);
    let has_rotation = |null: usize| {
        let mut blades = versor.terms().iter().map(|(blade, _)| *blade);
        blades.any(|blade| blade != Blade::SCALAR && !blade.contains(null))
    };
    Blade(occurring).vectors().find(|&null| {
        let orthogonal = Blade(occurring)
            .vectors()
            .all(|other| algebra.metric().get(null, other).is_zero());
        let scalar = versor.coefficient(Blade::SCALAR);
        orthogonal && has_rotation(null) && scalar != Value::ZERO
    })
}
