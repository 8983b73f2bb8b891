//! Meets with an outer product of vectors, by its factors.
//!
//! For A of grade r in n dimensions and `m = n − r`,
//!
//! `A ∨ (f₁∧…∧fₖ) = Σ ± [A∧f_S] f_R`,
//!
//! summed over the divisions of the factors into m factors S and the others R, with the sign of the
//! permutation that puts S before R, and [·] the coefficient of the pseudoscalar; up to a sign that
//! depends on n, r and k alone. For a metric with an inverse this follows from `A ∨ B = (A I⁻¹)⌋B`
//! by the expansion of a contraction. Both sides change alike under linear maps, so that one
//! example of basis blades tells the sign.
//!
//! The factors after the first are taken less multiples of the first, as in
//! [`JoinRule::Difference`], and so are those of the brackets: of a plane through three points
//! and a line through two, only differences of points are multiplied.

use super::JoinRule;
use super::join::{differences, left_first};
use crate::algebra::{Algebra, Blade, Product, Ratio};
use crate::ir::{Arena, Multivector};

/// How `a ∨ b` is computed where factors are known.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MeetRule {
    /// By the table of products.
    #[default]
    Plain,
    /// By the factors of one side.
    Factors,
}

/// The greatest number of terms of the sum.
const MOST: usize = 6;

/// The greatest number of factors that are examined.
const LONGEST: usize = 6;

impl MeetRule {
    /// Every rule, in the order in which they are tried.
    pub const ALL: [Self; 2] = [Self::Plain, Self::Factors];
}

/// Lowers the meet of two outer products, given by their factors, by those of the side that gives
/// fewer terms; `None` where there are too many. One side may be a single multivector of any grade.
pub(super) fn lower(
    arena: &mut Arena,
    algebra: &Algebra,
    left: &[Multivector],
    right: &[Multivector],
) -> Option<Multivector> {
    let (by_right, by_left) = (
        Expansion::new(algebra, left, right),
        Expansion::new(algebra, right, left),
    );
    let is_right = match (&by_right, &by_left) {
        (Some(a), Some(b)) => a.divisions.len() <= b.divisions.len(),
        (a, _) => a.is_some(),
    };
    let (whole, parts, found) = if is_right {
        (left, right, by_right?)
    } else {
        (right, left, by_left?)
    };
    let sign = sign(algebra, found.grade, parts.len(), is_right)?;
    let parts = differences(arena, parts).unwrap_or_else(|| parts.to_vec());
    let mut sum = Multivector::default();
    for (taken, others, is_odd) in found.divisions {
        let pick = |places: &[usize]| -> Vec<Multivector> {
            places.iter().map(|&at| parts[at].clone()).collect()
        };
        let all = [whole.to_vec(), pick(&taken)].concat();
        let bracket = JoinRule::Difference
            .lower(arena, algebra, &all)
            .unwrap_or_else(|| left_first(arena, algebra, &all));
        let bracket = bracket.coefficient(algebra.pseudoscalar());
        let others = pick(&others);
        let scalar = Multivector::new(arena, [(Blade::SCALAR, bracket)]);
        let rest = left_first(arena, algebra, &others);
        let rest = if others.is_empty() {
            scalar
        } else {
            scalar.product(arena, algebra, Product::Wedge, &rest, |_| true)
        };
        let factor = if is_odd { -sign } else { sign };
        sum = sum.sum(arena, &rest.scaled(factor));
    }
    Some(sum)
}

/// How a meet is expanded.
struct Expansion {
    /// The grade of the side that is kept whole.
    grade: usize,
    divisions: Vec<Division>,
}

impl Expansion {
    fn new(algebra: &Algebra, whole: &[Multivector], parts: &[Multivector]) -> Option<Self> {
        let grade_of = |value: &Multivector| {
            let mut grades = value
                .terms()
                .iter()
                .map(|(blade, _)| blade.grade() as usize);
            let first = grades.next()?;
            grades.all(|grade| grade == first).then_some(first)
        };
        let is_vector = |value: &Multivector| grade_of(value) == Some(1);
        let grade = match whole {
            [single] => grade_of(single)?,
            _ if whole.iter().all(is_vector) => whole.len(),
            _ => return None,
        };
        let taken = algebra.dimension().checked_sub(grade)?;
        if parts.len() < 2 || parts.len() > LONGEST || !parts.iter().all(is_vector) {
            return None;
        }
        let divisions = divisions(parts.len(), taken);
        (1..=MOST)
            .contains(&divisions.len())
            .then_some(Self { grade, divisions })
    }
}

/// Some numbers, the others, and whether the permutation that puts them one after the other is odd.
type Division = (Vec<usize>, Vec<usize>, bool);

/// The divisions of the numbers below `count`, both parts in rising order.
fn divisions(count: usize, taken: usize) -> Vec<Division> {
    (0_u32..1 << count)
        .map(Blade)
        .filter(|set| set.grade() as usize == taken)
        .map(|set| {
            let rest = Blade(!set.0 & ((1 << count) - 1));
            let is_odd = set.wedge_is_negative(rest);
            (set.vectors().collect(), rest.vectors().collect(), is_odd)
        })
        .collect()
}

/// The sign of the sum, from the meet of two basis blades of these grades.
fn sign(algebra: &Algebra, whole: usize, parts: usize, is_right: bool) -> Option<Ratio> {
    let pseudoscalar = algebra.pseudoscalar();
    let a = Blade::pseudoscalar(whole);
    let taken = Blade(pseudoscalar.0 & !a.0);
    let rest = Blade::pseudoscalar(parts.checked_sub(taken.grade() as usize)?);
    if rest.0 & !a.0 != 0 {
        return None;
    }
    let b = Blade(taken.0 | rest.0);
    let (first, second) = if is_right { (a, b) } else { (b, a) };
    let [(blade, found)] = Product::Vee.of_blades(algebra, first, second)[..] else {
        return None;
    };
    // The only division with a bracket other than zero.
    let is_negative = a.wedge_is_negative(taken) != taken.wedge_is_negative(rest);
    let is_unit = blade == rest && found.abs() == Ratio::ONE;
    is_unit.then_some(if is_negative { -found } else { found })
}
