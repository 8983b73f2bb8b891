//! Multivectors of numbers, and the plain meaning of expressions.

use std::collections::BTreeMap;

use crate::algebra::{Algebra, Blade, Product, Unary};
use crate::ir::{Number, Parts};

/// A multivector at a random point. Blades that are absent are zero.
pub type Numbers = BTreeMap<Blade, Number>;

/// The coefficient of a blade.
pub fn coefficient(value: &Numbers, blade: Blade) -> Number {
    value.get(&blade).copied().unwrap_or(Number::ZERO)
}

/// The value, or its negative.
pub(super) fn signed(value: Number, is_negative: bool) -> Number {
    if is_negative { -value } else { value }
}

/// The multiple of a multivector.
pub fn scaled(value: &Numbers, factor: Number) -> Numbers {
    value
        .iter()
        .map(|(&blade, &number)| (blade, number * factor))
        .collect()
}

/// Whether two multivectors are the same; absent blades are zero.
pub fn equal(a: &Numbers, b: &Numbers) -> bool {
    let within = |one: &Numbers, other: &Numbers| {
        one.iter()
            .all(|(&blade, &number)| number == coefficient(other, blade))
    };
    within(a, b) && within(b, a)
}

/// A product of two multivectors.
#[must_use]
pub fn product(algebra: &Algebra, operation: Product, left: &Numbers, right: &Numbers) -> Numbers {
    let mut result = Numbers::new();
    for (&a, &first) in left {
        for (&b, &second) in right {
            let both = first * second;
            for &(blade, factor) in operation.of_blades(algebra, a, b).iter() {
                add(&mut result, blade, both * Number::from_ratio(factor));
            }
        }
    }
    result
}

/// A linear operation on a multivector.
#[must_use]
pub fn unary(algebra: &Algebra, operation: Unary, operand: &Numbers) -> Numbers {
    let mut result = Numbers::new();
    for (&blade, &value) in operand {
        for (image, factor) in operation.of_blade(algebra, blade) {
            add(&mut result, image, value * Number::from_ratio(factor));
        }
    }
    result
}

/// Whether every blade is odd. Zero is even.
pub fn is_odd(value: &Numbers) -> bool {
    let mut blades = value
        .iter()
        .filter(|(_, value)| !value.is_zero())
        .peekable();
    blades.peek().is_some() && blades.all(|(blade, _)| blade.involute_is_negative())
}

/// `M X ~M`, with the grade involution of X for an odd M.
pub fn sandwich(algebra: &Algebra, versor: &Numbers, is_odd: bool, operand: &Numbers) -> Numbers {
    let operand = if is_odd {
        unary(algebra, Unary::Involute, operand)
    } else {
        operand.clone()
    };
    let half = product(algebra, Product::Geometric, versor, &operand);
    let reverse = unary(algebra, Unary::Reverse, versor);
    product(algebra, Product::Geometric, &half, &reverse)
}

/// Whether `M ~M = 1` and M moves vectors to vectors. In five dimensions and fewer the second
/// follows from the first for an M whose grades are all even or all odd.
pub fn is_unit_versor(algebra: &Algebra, value: &Numbers) -> bool {
    let one = Numbers::from([(Blade::SCALAR, Number::ONE)]);
    let reverse = unary(algebra, Unary::Reverse, value);
    let keeps_vectors = || {
        (0..algebra.dimension()).all(|index| {
            let vector = Numbers::from([(Blade::vector(index), Number::ONE)]);
            let moved = sandwich(algebra, value, false, &vector);
            moved
                .iter()
                .all(|(blade, number)| blade.grade() == 1 || number.is_zero())
        })
    };
    equal(&product(algebra, Product::Geometric, value, &reverse), &one)
        && (algebra.dimension() <= 5 || keeps_vectors())
}

/// Whether a multivector is an outer product of vectors: it has one grade, and every contraction of
/// it by a basis (grade − 1)-blade wedges with it to zero (the Plücker relations).
pub fn is_blade(algebra: &Algebra, value: &Numbers) -> bool {
    let mut grades = value
        .iter()
        .filter(|(_, v)| **v != Number::ZERO)
        .map(|(blade, _)| blade.grade());
    let Some(grade) = grades.next() else {
        return true;
    };
    if grades.any(|other| other != grade) {
        return false;
    }
    if grade == 0 {
        return true;
    }
    // The dual vectors are taken by coefficient, so that a degenerate metric does not matter.
    (0..=algebra.pseudoscalar().0)
        .map(Blade)
        .filter(|blade| blade.grade() == grade - 1)
        .all(|probe| {
            let mut vector = Numbers::new();
            for (&blade, &v) in value {
                if blade.0 & probe.0 == probe.0 {
                    let rest = Blade(blade.0 & !probe.0);
                    add(&mut vector, rest, signed(v, probe.wedge_is_negative(rest)));
                }
            }
            product(algebra, Product::Wedge, &vector, value)
                .values()
                .all(|v| v.is_zero())
        })
}

/// The multivector with some parts of another, blade by blade.
pub(crate) fn with_parts_of(value: &Numbers, other: &Numbers, parts: Parts) -> Numbers {
    let blades = value.keys().chain(other.keys());
    blades
        .map(|&blade| {
            let (one, next) = (coefficient(value, blade), coefficient(other, blade));
            (blade, one.with_parts_of(next, parts))
        })
        .collect()
}

/// The multivector without those parts that are not kept.
pub(crate) fn only(value: &Numbers, parts: Parts) -> Numbers {
    let each = value.iter();
    each.map(|(&blade, number)| (blade, number.only(parts)))
        .collect()
}

/// Adds to the coefficient of a blade.
pub fn add(sums: &mut Numbers, blade: Blade, value: Number) {
    let sum = sums.entry(blade).or_insert(Number::ZERO);
    *sum = *sum + value;
}
