//! Quotients by one divisor whose dividends have factors in common.
//!
//! `a x/d, a y/d, a z/d → q = a/d; q x, q y, q z`: one division and three multiplications instead
//! of three of each. Where no single factor is in all terms, as in `(a x + b u)/d, (a y + b v)/d,
//! …`, a few are divided: `a/d` and `b/d`. A factor that all terms have, and that the divisor has
//! twice, cancels once: so the divisor is zero where it was before.
//!
//! A product with a quotient is the quotient of a product: `b (x/d) = (b x)/d`.
//!
//! It is right by the distributive law, where the divisor is not zero.

use std::collections::BTreeMap;

use rustc_hash::FxHashMap;

use super::rewrite::{Graph, collect_factors, reads, rewrite};
use crate::algebra::Ratio;
use crate::ir::{Arena, Node, NodeId, Value};

/// Rewrites the quotients of a graph; `None` where nothing is saved.
#[must_use]
pub fn fraction(arena: &Arena, outputs: &[Value]) -> Option<Graph> {
    let reads = reads(arena, outputs);
    let mut groups: BTreeMap<NodeId, Vec<Fraction>> = BTreeMap::new();
    for (divisor, fraction) in fractions(arena, &reads) {
        groups.entry(divisor).or_default().push(fraction);
    }
    let mut plans: FxHashMap<NodeId, Plan> = FxHashMap::default();
    for (divisor, fractions) in groups {
        plan(arena, &reads, divisor, fractions, &mut plans);
    }
    if plans.is_empty() {
        return None;
    }
    rewrite(arena, outputs, &reads, |copy, id, images| {
        let plan = plans.get(&id)?;
        let product = |copy: &mut Arena, factors: &[NodeId]| {
            factors.iter().fold(Value::ONE, |whole, factor| {
                copy.product(whole, images[factor.index()])
            })
        };
        let divisor = product(copy, &plan.divisor);
        let mut sum = Vec::with_capacity(plan.terms.len());
        for term in &plan.terms {
            let divided = copy.quotient(images[term.divided.index()], divisor)?;
            let rest = product(copy, &term.rest);
            sum.push(copy.product(divided, rest).scaled(term.scale));
        }
        Some(copy.sum(sum))
    })
}

/// A quotient, or a product with one.
struct Fraction {
    id: NodeId,
    /// The terms of the dividend.
    dividend: Vec<Product>,
}

/// How a quotient is computed.
struct Plan {
    /// The factors of the divisor.
    divisor: Vec<NodeId>,
    terms: Vec<Term>,
}

/// A product one factor of which is divided.
struct Term {
    scale: Ratio,
    divided: NodeId,
    rest: Vec<NodeId>,
}

/// The number in front of a product, and its factors.
type Product = (Ratio, Vec<NodeId>);

/// The quotients of a graph with their divisors. What only one product reads belongs to that.
fn fractions(arena: &Arena, reads: &[usize]) -> Vec<(NodeId, Fraction)> {
    let mut found: Vec<(NodeId, Fraction)> = Vec::new();
    let mut is_inner = vec![false; arena.len()];
    for id in arena.ids().rev().filter(|id| reads[id.index()] > 0) {
        let mut factors = Vec::new();
        match arena.node(id) {
            Node::Product(a, b) => {
                for part in [*a, *b] {
                    is_inner[part.index()] |= reads[part.index()] == 1;
                    collect_factors(arena, reads, part, &mut factors);
                }
            }
            Node::Quotient(..) => factors.push(id),
            _ => continue,
        }
        if is_inner[id.index()] {
            continue;
        }
        let is_part = |factor: &NodeId| {
            let is_own = *factor == id || reads[factor.index()] == 1;
            is_own && matches!(arena.node(*factor), Node::Quotient(..))
        };
        let (quotients, others): (Vec<NodeId>, Vec<NodeId>) =
            factors.into_iter().partition(is_part);
        let [quotient] = quotients.as_slice() else {
            continue;
        };
        if let Node::Quotient(dividend, divisor) = arena.node(*quotient) {
            let mut terms = terms(arena, reads, *dividend);
            // A sum is not multiplied out.
            if terms.len() > 1 && !others.is_empty() {
                terms = vec![(Ratio::ONE, vec![*dividend])];
            }
            for (_, factors) in &mut terms {
                factors.extend(&others);
            }
            found.push((
                *divisor,
                Fraction {
                    id,
                    dividend: terms,
                },
            ));
        }
    }
    found
}

fn plan(
    arena: &Arena,
    reads: &[usize],
    divisor: NodeId,
    fractions: Vec<Fraction>,
    plans: &mut FxHashMap<NodeId, Plan>,
) {
    let count = fractions.len();
    let (ids, mut dividends): (Vec<NodeId>, Vec<Vec<Product>>) = fractions
        .into_iter()
        .map(|fraction| (fraction.id, fraction.dividend))
        .unzip();
    let mut divisor_factors = vec![divisor];
    let mut has_cancelled = false;
    if let Node::Product(a, b) = arena.node(divisor)
        && reads[divisor.index()] == count
    {
        divisor_factors.clear();
        collect_factors(arena, reads, *a, &mut divisor_factors);
        collect_factors(arena, reads, *b, &mut divisor_factors);
        for place in (1..divisor_factors.len()).rev() {
            let factor = divisor_factors[place];
            if divisor_factors[..place].contains(&factor) && cancelled(&mut dividends, factor) {
                divisor_factors.remove(place);
                has_cancelled = true;
            }
        }
    }
    let Some(divided) = covering(&dividends) else {
        return;
    };
    if !has_cancelled && price(divided.len()) >= price(count) {
        return;
    }
    for (id, terms) in ids.into_iter().zip(dividends) {
        let terms = terms.into_iter().filter_map(|(scale, mut rest)| {
            let common = divided.iter().find(|factor| rest.contains(factor))?;
            let place = rest.iter().position(|factor| factor == common)?;
            rest.remove(place);
            Some(Term {
                scale,
                divided: *common,
                rest,
            })
        });
        let plan = Plan {
            divisor: divisor_factors.clone(),
            terms: terms.collect(),
        };
        plans.insert(id, plan);
    }
}

/// What some quotients by one divisor cost: three and more are products with its reciprocal.
fn price(quotients: usize) -> usize {
    if quotients > 2 {
        1 + quotients
    } else {
        quotients
    }
}

/// The terms of a dividend as products.
fn terms(arena: &Arena, reads: &[usize], dividend: NodeId) -> Vec<Product> {
    let product = |value: Value| {
        let mut factors = Vec::new();
        collect_factors(arena, reads, value.node, &mut factors);
        (value.factor, factors)
    };
    match arena.node(dividend) {
        Node::Sum(terms) if reads[dividend.index()] == 1 => {
            terms.iter().map(|term| product(*term)).collect()
        }
        _ => vec![product(Value::of(dividend))],
    }
}

/// Whether all terms have a factor, which is taken out of them then.
fn cancelled(dividends: &mut [Vec<Product>], factor: NodeId) -> bool {
    let mut terms = dividends.iter().flatten();
    if !terms.all(|(_, factors)| factors.contains(&factor)) {
        return false;
    }
    for (_, factors) in dividends.iter_mut().flatten() {
        if let Some(place) = factors.iter().position(|other| *other == factor) {
            factors.remove(place);
        }
        if factors.is_empty() {
            factors.push(Arena::ONE);
        }
    }
    true
}

/// Factors of which every term has one; those first that most terms have.
fn covering(dividends: &[Vec<Product>]) -> Option<Vec<NodeId>> {
    let mut open: Vec<&Product> = dividends.iter().flatten().collect();
    let mut found = Vec::new();
    while !open.is_empty() {
        let mut counts: BTreeMap<NodeId, usize> = BTreeMap::new();
        for (_, factors) in &open {
            let mut seen: Vec<NodeId> = Vec::with_capacity(factors.len());
            for factor in factors {
                if !seen.contains(factor) {
                    seen.push(*factor);
                    *counts.entry(*factor).or_default() += 1;
                }
            }
        }
        let most = counts.values().max().copied()?;
        let (&best, _) = counts.iter().find(|(_, count)| **count == most)?;
        open.retain(|(_, factors)| !factors.contains(&best));
        found.push(best);
    }
    Some(found)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::Residue;
    use crate::passes::cost;

    fn check(arena: &Arena, outputs: &[Value], divisions: usize, multiplications: usize) {
        let Some((new, found)) = fraction(arena, outputs) else {
            panic!("it pays")
        };
        let cost = cost(&new, &found);
        assert_eq!(
            (cost.divisions, cost.multiplications),
            (divisions, multiplications)
        );
        let inputs: Vec<Residue> = (0..arena.inputs() as u64)
            .map(|n| Residue::new(3 * n + 5))
            .collect();
        let (before, after) = (arena.evaluate(&inputs), new.evaluate(&inputs));
        for (old, new) in outputs.iter().zip(&found) {
            assert_eq!(
                before[old.node.index()] * Residue::from_ratio(old.factor),
                after[new.node.index()] * Residue::from_ratio(new.factor)
            );
        }
    }

    #[test]
    fn a_common_factor_is_divided_once() {
        let mut arena = Arena::default();
        let [a, x, y, z, d] = [(); 5].map(|()| arena.input());
        let outputs = [x, y, z].map(|part| {
            let product = arena.product(a, part);
            arena.quotient(product, d).expect("a divisor")
        });
        check(&arena, &outputs, 1, 3);
    }

    #[test]
    fn two_factors_of_sums_are_divided() {
        let mut arena = Arena::default();
        let [a, b, d] = [(); 3].map(|()| arena.input());
        let outputs = [(); 3].map(|()| {
            let [x, y] = [(); 2].map(|()| arena.input());
            let (left, right) = (arena.product(a, x), arena.product(b, y));
            let sum = arena.sum([left, -right]);
            arena.quotient(sum, d).expect("a divisor")
        });
        check(&arena, &outputs, 2, 6);
    }

    #[test]
    fn what_the_divisor_has_too_cancels() {
        let mut arena = Arena::default();
        let [a, x, d] = [(); 3].map(|()| arena.input());
        let (dividend, square) = (arena.product(a, x), arena.product(a, a));
        let divisor = arena.product(square, d);
        let quotient = arena.quotient(dividend, divisor).expect("a divisor");
        check(&arena, &[quotient], 1, 1);
    }

    #[test]
    fn one_is_left_where_all_factors_cancel() {
        let mut arena = Arena::default();
        let [a, d] = [(); 2].map(|()| arena.input());
        let square = arena.product(a, a);
        let divisor = arena.product(square, d);
        let quotient = arena.quotient(a, divisor).expect("a divisor");
        check(&arena, &[quotient], 1, 1);
    }

    #[test]
    fn different_dividends_stay() {
        let mut arena = Arena::default();
        let [x, y, z, d] = [(); 4].map(|()| arena.input());
        let outputs = [x, y, z].map(|part| arena.quotient(part, d).expect("a divisor"));
        assert!(fraction(&arena, &outputs).is_none());
    }
}
