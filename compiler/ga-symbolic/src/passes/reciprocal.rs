//! Several quotients by one divisor become products with its reciprocal.
//!
//! `a/d, b/d, c/d → r = 1/d; a r, b r, c r`: a division takes as long as several multiplications,
//! and cannot be pipelined as well. Two quotients stay, each with one rounding. A number by which
//! all of them are multiplied is multiplied with r.

use std::collections::BTreeMap;

use super::rewrite::{Graph, reads, rewrite};
use crate::algebra::Ratio;
use crate::ir::{Arena, Node, NodeId, Value};

/// The smallest number of quotients for which this pays.
const LEAST: usize = 3;

/// Rewrites the quotients of a graph; `None` where no divisor occurs often enough.
#[must_use]
pub fn reciprocal(arena: &Arena, outputs: &[Value]) -> Option<Graph> {
    let reads = reads(arena, outputs);
    let mut counts = vec![0; arena.len()];
    for id in arena.ids().filter(|id| reads[id.index()] > 0) {
        if let Node::Quotient(_, divisor) = arena.node(id) {
            counts[divisor.index()] += 1;
        }
    }
    if counts.iter().all(|&count| count < LEAST) {
        return None;
    }
    let multiples = multiples(arena, outputs, &reads);
    rewrite(arena, outputs, &reads, |copy, id, images| {
        match arena.node(id) {
            Node::Quotient(dividend, divisor) if counts[divisor.index()] >= LEAST => {
                let inverse = copy.quotient(Value::ONE, images[divisor.index()])?;
                let multiple = multiples.get(divisor).copied().flatten();
                let multiple = multiple.unwrap_or(Ratio::ONE);
                let inverse = copy.held(inverse.scaled(multiple));
                let whole = copy.product(images[dividend.index()], inverse);
                Some(whole.scaled(multiple.recip()?))
            }
            _ => None,
        }
    })
}

/// For each divisor the number by which all quotients are multiplied where they are read; none
/// where there are several.
fn multiples(arena: &Arena, outputs: &[Value], reads: &[usize]) -> BTreeMap<NodeId, Option<Ratio>> {
    let mut found: BTreeMap<NodeId, Option<Ratio>> = BTreeMap::new();
    let mut read = |value: Value| {
        if let Node::Quotient(_, divisor) = arena.node(value.node) {
            let size = value.factor.abs();
            let known = found.entry(*divisor).or_insert(Some(size));
            *known = known.filter(|other| *other == size);
        }
    };
    for id in arena.ids().filter(|id| reads[id.index()] > 0) {
        match arena.node(id) {
            Node::Sum(values) | Node::Function(_, values) => {
                values.iter().copied().for_each(&mut read)
            }
            node => node.for_each_operand(|operand| read(Value::of(operand))),
        }
    }
    outputs.iter().copied().for_each(read);
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::Residue;
    use crate::passes::cost;

    #[test]
    fn three_quotients_share_one_division() {
        let mut arena = Arena::default();
        let [a, b, c, d] = [(); 4].map(|()| arena.input());
        let outputs: Vec<Value> = [a, b, c]
            .iter()
            .filter_map(|&x| arena.quotient(x, d))
            .collect();
        let Some((new, found)) = reciprocal(&arena, &outputs) else {
            panic!("it pays")
        };
        assert_eq!(
            (
                cost(&new, &found).divisions,
                cost(&new, &found).multiplications
            ),
            (1, 3)
        );
        let inputs = [5, 7, 11, 13].map(Residue::new);
        let (before, after) = (arena.evaluate(&inputs), new.evaluate(&inputs));
        for (old, new) in outputs.iter().zip(&found) {
            assert_eq!(before[old.node.index()], after[new.node.index()]);
        }
        assert!(reciprocal(&arena, &outputs[..2]).is_none());
        let doubled: Vec<Value> = outputs
            .iter()
            .map(|quotient| arena.sum([a, quotient.scaled(Ratio::integer(2))]))
            .collect();
        let Some((new, found)) = reciprocal(&arena, &doubled) else {
            panic!("it pays")
        };
        assert_eq!(cost(&new, &found).multiplications, 4, "the doubling once");
        let (before, after) = (arena.evaluate(&inputs), new.evaluate(&inputs));
        for (old, new) in doubled.iter().zip(&found) {
            assert_eq!(before[old.node.index()], after[new.node.index()]);
        }
    }
}
