//! A versor as a rotation with a scaling, followed by a translation.
//!
//! Let i, o be a null pair of the basis with `o² = 0` too. How often i occurs in a blade, less how
//! often o occurs, is its degree; degrees add up in products, and no blade has a degree beyond ±1.
//! Let a unit versor M have blades of degrees 0 and 1 only. Of `M ~M = 1` the part of degree 0 says
//! `P ~P = 1` for the part P of degree 0, and with `T = M ~P = 1 + τ`, where τ has degree 1,
//! `T ~T = 1` says `~τ = −τ`. So `M = T P`, and T acts as the translation of
//! [`split`](super::split) does.
//!
//! With `E = o∧i/(o·i)`, `E² = 1`, the idempotents `(1 ± E)/2` split P: it is
//! `p₊ (1 + E)/2 + p₋ (1 − E)/2`, where p₊ and p₋ have neither o nor i. Since `~E = −E`,
//! `P ~P = 1` says `p₊ ~p₋ = 1`. From `E i = −i = −i E` and `E o = o = −o E` follows
//!
//! - `P i ~P = p₋ i ~p₋ = λ i` with `λ = p₋ ~p₋`, `P o ~P = o/λ` with `1/λ = p₊ ~p₊`, and
//!   `P E ~P = E`; for an odd P each with the involution;
//! - `p₋ = λ p₊`, and a blade B of the other vectors goes to `p₊ B ~p₋ = r B ~r` with
//!   `r = p₊ √λ`, a unit versor. Its coefficients occur in `B + [r, B] ~r` in products of two, and
//!   `rⱼ rₖ = p₊ⱼ p₋ₖ = p₋ⱼ p₊ₖ`: the map is that of a rotation, by products of p₊ and p₋;
//! - `τ = N ~P = N ~p₋` for the part N of degree 1, since `i P = i (1 + E)/2 P`, which leaves p₋.

use super::linear_map::{acted, commutator, grades};
use super::null_pair::NullPair;
use super::split::translated;
use crate::algebra::{Algebra, Blade, Product, Ratio, Unary};
use crate::ir::{Arena, Facts, Multivector, Node, Value};
use crate::order::Order as _;

/// How the rotation r acts.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    /// On the whole operand.
    Commutator,
    /// By its map, blade by blade: for operands of many blades.
    LinearMap,
}

/// Lowers the action of a unit versor with a scaling by its split; `None` where no pair splits it.
pub(super) fn lower(
    form: Form,
    arena: &mut Arena,
    algebra: &Algebra,
    versor: &Multivector,
    operand: &Multivector,
) -> Option<Multivector> {
    let pair = NullPair::all(algebra).find(|pair| splits(algebra, *pair, versor))?;
    let [plus, minus] = [-1, 1].map(|sign| {
        let terms = versor.terms().iter().filter_map(|&(blade, value)| {
            let rest = pair.rest(blade);
            match (blade.contains(pair.null), blade.contains(pair.partner)) {
                (false, false) => Some((rest, value)),
                (true, true) => {
                    let factor = pair.sign(blade) * pair.inner * Ratio::integer(-sign);
                    Some((rest, value.scaled(factor)))
                }
                _ => None,
            }
        });
        let terms: Vec<_> = terms.collect();
        Multivector::new(arena, terms)
    });
    let rotated = match form {
        Form::Commutator => rotated(arena, algebra, [&plus, &minus], operand),
        Form::LinearMap => mapped(arena, algebra, pair, [&plus, &minus], operand),
    };
    let scaled = scaled(arena, algebra, pair, [&plus, &minus], &rotated);
    let rest = versor.filtered(|blade| blade.contains(pair.null) && !blade.contains(pair.partner));
    if rest.terms().is_empty() {
        return Some(scaled);
    }
    let reverse = minus.unary(arena, algebra, Unary::Reverse);
    let translation = rest.product(arena, algebra, Product::Geometric, &reverse, |blade| {
        blade.reverse_is_negative()
    });
    Some(translated(arena, algebra, &translation, &scaled))
}

fn splits(algebra: &Algebra, pair: NullPair, versor: &Multivector) -> bool {
    let has_partner = |blade: Blade| blade.contains(pair.partner);
    let mut blades = versor.terms().iter().map(|(blade, _)| *blade);
    let is_upper = blades
        .clone()
        .all(|blade| blade.contains(pair.null) || !has_partner(blade));
    is_upper
        && blades.any(has_partner)
        && algebra.metric().get(pair.partner, pair.partner).is_zero()
}

/// `r X ~r` as `X + [r, X] ~r`.
fn rotated(
    arena: &mut Arena,
    algebra: &Algebra,
    [plus, minus]: [&Multivector; 2],
    operand: &Multivector,
) -> Multivector {
    let reverse = minus.unary(arena, algebra, Unary::Reverse);
    let change = commutator(arena, algebra, plus, operand).product(
        arena,
        algebra,
        Product::Geometric,
        &reverse,
        grades(operand),
    );
    operand.sum(arena, &change)
}

/// `r X ~r` as `Σ x (r b ~r)` over the blades b of X.
fn mapped(
    arena: &mut Arena,
    algebra: &Algebra,
    pair: NullPair,
    halves: [&Multivector; 2],
    operand: &Multivector,
) -> Multivector {
    let rotation = Rotation::new(halves);
    let mut terms = Vec::new();
    for &(blade, value) in operand.terms() {
        let rest = pair.rest(blade);
        for (row, entry) in rotation.column(arena, algebra, rest) {
            let row = Blade(row.0 | blade.0 & !rest.0);
            let value = arena.product(entry, value);
            terms.push((row, value.scaled(pair.sign(row) * pair.sign(blade))));
        }
    }
    Multivector::new(arena, terms)
}

/// `P X ~P` from `r X ~r`.
fn scaled(
    arena: &mut Arena,
    algebra: &Algebra,
    pair: NullPair,
    [plus, minus]: [&Multivector; 2],
    rotated: &Multivector,
) -> Multivector {
    let part = |has_null: bool, has_partner: bool| {
        rotated.filtered(|blade| {
            [pair.null, pair.partner].map(|index| blade.contains(index)) == [has_null, has_partner]
        })
    };
    let mut sum = part(false, false).sum(arena, &part(true, true));
    for (part, half) in [(part(true, false), minus), (part(false, true), plus)] {
        if part.terms().is_empty() {
            continue;
        }
        let reverse = half.unary(arena, algebra, Unary::Reverse);
        let factor = half.product(arena, algebra, Product::ScalarProduct, &reverse, |_| true);
        let part = factor.product(arena, algebra, Product::Geometric, &part, |_| true);
        sum = sum.sum(arena, &part);
    }
    sum
}

/// The rotation r, whose coefficients are known in products of two.
struct Rotation {
    arena: Arena,
    /// A versor whose coefficients are inputs of its own arena.
    versor: Multivector,
    /// The coefficients of p₊ and p₋ for each input.
    halves: Vec<[Value; 2]>,
}

impl Rotation {
    fn new(halves: [&Multivector; 2]) -> Self {
        let mut blades: Vec<Blade> = halves
            .map(Multivector::terms)
            .concat()
            .iter()
            .map(|t| t.0)
            .collect();
        blades.order();
        blades.dedup();
        let mut arena = Arena::default();
        let terms: Vec<_> = blades.iter().map(|&blade| (blade, arena.input())).collect();
        let unit = Facts {
            unit_versor: true,
            ..Facts::default()
        };
        Self {
            versor: Multivector::new(&mut arena, terms).with_facts(unit),
            arena,
            halves: blades
                .iter()
                .map(|&blade| halves.map(|half| half.coefficient(blade)))
                .collect(),
        }
    }

    /// The image of a basis blade.
    fn column(&self, arena: &mut Arena, algebra: &Algebra, blade: Blade) -> Vec<(Blade, Value)> {
        let mut own = self.arena.clone();
        let basis = Multivector::new(&mut own, [(blade, Value::ONE)]);
        let image = acted(&mut own, algebra, &self.versor, &basis);
        let entries = image.terms().iter();
        entries
            .map(|&(row, entry)| (row, self.entry(arena, &own, entry)))
            .collect()
    }

    fn entry(&self, arena: &mut Arena, own: &Arena, value: Value) -> Value {
        let found = match own.node(value.node) {
            Node::Product(a, b) => match (own.node(*a), own.node(*b)) {
                (Node::Input(a), Node::Input(b)) => {
                    arena.product(self.halves[*a][1], self.halves[*b][0])
                }
                _ => Value::ZERO,
            },
            Node::Sum(terms) => {
                let terms: Vec<_> = terms
                    .iter()
                    .map(|&term| self.entry(arena, own, term))
                    .collect();
                arena.sum(terms)
            }
            _ => Value::ONE,
        };
        found.scaled(value.factor)
    }
}
