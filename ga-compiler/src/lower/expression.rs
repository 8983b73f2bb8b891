//! Expressions, one operation at a time.

use super::SandwichRule;
use crate::algebra::{Algebra, Blade, Product, Ratio, Unary};
use crate::expression::Expression;
use crate::ir::{Arena, Facts, Multivector, Value};

/// Lowers an expression over operands that are already in the arena.
#[must_use]
pub fn lower(
    arena: &mut Arena,
    algebra: &Algebra,
    expression: &Expression,
    operands: &[Multivector],
    rule: SandwichRule,
) -> Multivector {
    let descend =
        |arena: &mut Arena, part: &Expression| lower(arena, algebra, part, operands, rule);
    match expression {
        Expression::Operand(number) => operands[*number].clone(),
        Expression::Constant(value) => {
            Multivector::new(arena, [(Blade::SCALAR, Value::constant(*value))])
        }
        Expression::Unary(operation, operand) => {
            let operand = descend(arena, operand);
            let facts = match operation {
                Unary::Reverse => operand.facts.of_reverse(),
                _ => Facts::default(),
            };
            operand.unary(arena, algebra, *operation).with_facts(facts)
        }
        Expression::Binary(product, left, right) => {
            let left = descend(arena, left);
            let right = descend(arena, right);
            let facts = match product {
                Product::Geometric => left.facts.of_product(right.facts),
                _ => Facts::default(),
            };
            left.product(arena, algebra, *product, &right, |_| true)
                .with_facts(facts)
        }
        Expression::Sandwich(versor, operand) => {
            let versor = descend(arena, versor);
            let operand = descend(arena, operand);
            let plain = SandwichRule::LeftFirst;
            rule.lower(arena, algebra, &versor, &operand)
                .or_else(|| plain.lower(arena, algebra, &versor, &operand))
                .unwrap_or_default()
        }
        Expression::Sum(left, right) => {
            let left = descend(arena, left);
            let right = descend(arena, right);
            left.sum(arena, &right)
        }
        Expression::Quotient(dividend, divisor) => {
            let dividend = descend(arena, dividend);
            let divisor = descend(arena, divisor).coefficient(Blade::SCALAR);
            let quotients: Vec<_> = dividend
                .terms()
                .iter()
                .filter_map(|&(blade, value)| Some((blade, arena.quotient(value, divisor)?)))
                .collect();
            Multivector::new(arena, quotients)
        }
        Expression::Negative(operand) => descend(arena, operand).scaled(Ratio::integer(-1)),
    }
}
