//! The action of a vector, and of a vector times the pseudoscalar.
//!
//! For a vector v and any X, `v X = v⌋X + v∧X` and `X̂ v = v∧X − v⌋X`, where X̂ is the grade
//! involution. Hence `X̂ v = v X − 2 v⌋X = 2 v∧X − v X`, and by `v (v⌋X) = v∧(v⌋X)` and
//! `v (v∧X) = v⌋(v∧X)`, since `v∧v = 0`,
//!
//! - `v X̂ v = v² X − 2 v∧(v⌋X)`,
//! - `v X̂ v = 2 v⌋(v∧X) − v² X`,
//!
//! in every grade. A versor of n basis vectors acts with a number of products that grows with n
//! instead of n².
//!
//! A multivector V of grade n − 1 is `v I` with the vector `v = V I⁻¹`, if the pseudoscalar I has
//! an inverse. I commutes with vectors for odd n and anticommutes for even n, so
//! `I X ~I = (I ~I) X` for odd n, `I X̂ ~I = (I ~I) X` for even n. V is even for odd n and odd for
//! even n, and thus acts as `(I ~I) v X v` in both cases: up to sign the same as v.

use crate::algebra::{Algebra, Blade, Product, Ratio, Unary};
use crate::ir::{Arena, Multivector, Value};

/// Which of the two identities is used.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    /// `v² X − 2 v∧(v⌋X)`.
    Inner,
    /// `2 v⌋(v∧X) − v² X`.
    Outer,
}

/// Lowers the action of a versor that is a vector, or the pseudoscalar times one; `None` for
/// others.
pub(super) fn lower(
    form: Form,
    arena: &mut Arena,
    algebra: &Algebra,
    versor: &Multivector,
    operand: &Multivector,
) -> Option<Multivector> {
    let grade = common_grade(versor)?;
    let dimension = algebra.dimension();
    if grade == 1 {
        let square = square(arena, algebra, versor, Ratio::ONE);
        return Some(reflected(form, arena, algebra, versor, square, operand));
    }
    let pseudoscalar = algebra.pseudoscalar();
    if algebra.is_degenerate() || grade as usize + 1 != dimension {
        return None;
    }
    // I ~I, which for a unit versor V = v I is also 1/v².
    let square = pseudoscalar_norm(algebra, pseudoscalar)?;
    let vector = versor
        .unary(arena, algebra, Unary::Dual)
        .with_facts(versor.facts);
    let image = operand.unary(arena, algebra, Unary::Involute);
    let norm = self::square(arena, algebra, &vector, square.recip()?);
    let reflected = reflected(form, arena, algebra, &vector, norm, &image);
    Some(reflected.scaled(square))
}

fn reflected(
    form: Form,
    arena: &mut Arena,
    algebra: &Algebra,
    vector: &Multivector,
    square: Value,
    operand: &Multivector,
) -> Multivector {
    let square = Multivector::new(arena, [(Blade::SCALAR, square)]);
    let scaled = square.product(arena, algebra, Product::Geometric, operand, |_| true);
    let (first, second, sign) = match form {
        Form::Inner => (Product::LeftContraction, Product::Wedge, 1),
        Form::Outer => (Product::Wedge, Product::LeftContraction, -1),
    };
    let part = vector.product(arena, algebra, first, operand, |_| true);
    let part = vector.product(arena, algebra, second, &part, |_| true);
    scaled
        .scaled(Ratio::integer(sign))
        .sum(arena, &part.scaled(Ratio::integer(-2 * sign)))
}

/// The square of a vector; `unit` if the versor that it comes from is a unit versor.
fn square(arena: &mut Arena, algebra: &Algebra, vector: &Multivector, unit: Ratio) -> Value {
    if vector.facts.unit_versor {
        return Value::constant(unit);
    }
    vector
        .product(arena, algebra, Product::ScalarProduct, vector, |_| true)
        .coefficient(Blade::SCALAR)
}

/// `I ~I`.
fn pseudoscalar_norm(algebra: &Algebra, pseudoscalar: Blade) -> Option<Ratio> {
    let square = algebra.geometric(pseudoscalar, pseudoscalar);
    let (_, square) = square.iter().find(|(blade, _)| *blade == Blade::SCALAR)?;
    Some(if pseudoscalar.reverse_is_negative() {
        -*square
    } else {
        *square
    })
}

/// The grade of a multivector of one grade.
fn common_grade(value: &Multivector) -> Option<u32> {
    let mut grades = value.terms().iter().map(|(blade, _)| blade.grade());
    let first = grades.next()?;
    grades.all(|grade| grade == first).then_some(first)
}
