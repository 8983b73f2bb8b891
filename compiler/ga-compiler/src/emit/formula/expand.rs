//! The nodes of a graph as polynomials of readable size.

use std::collections::{BTreeMap, BTreeSet};

use super::polynomial::Polynomial;
use crate::algebra::Ratio;
use crate::ir::{Arena, Node, NodeId, Value};

/// A graph being expanded.
pub(super) struct Expander<'a> {
    arena: &'a Arena,
    /// The largest number of terms of a polynomial. Beyond that, its parts are not expanded.
    most_terms: usize,
    /// The nodes that are never expanded into those that read them.
    parts: BTreeSet<NodeId>,
    polynomials: BTreeMap<NodeId, Polynomial>,
}

impl<'a> Expander<'a> {
    pub(super) fn new(arena: &'a Arena, most_terms: usize) -> Self {
        Self {
            arena,
            most_terms,
            parts: BTreeSet::new(),
            polynomials: BTreeMap::new(),
        }
    }

    /// The same graph with some nodes that are never expanded into those that read them.
    pub(super) fn with_parts(&self, parts: BTreeSet<NodeId>) -> Self {
        Self {
            parts,
            ..Self::new(self.arena, self.most_terms)
        }
    }

    /// A value as a polynomial.
    pub(super) fn value(&mut self, value: Value) -> Polynomial {
        let mut result = Polynomial::default();
        if !value.is_zero() {
            self.node(value.node);
            result.add_scaled(&self.known(value.node), value.factor);
        }
        result
    }

    /// A node as a polynomial; of a function, the node itself.
    pub(super) fn node(&mut self, id: NodeId) -> &Polynomial {
        let (mut wanted, mut open) = (BTreeSet::new(), vec![id]);
        while let Some(next) = open.pop() {
            if self.polynomials.contains_key(&next) || !wanted.insert(next) {
                continue;
            }
            let node = self.arena.node(next);
            if !matches!(node, Node::Function(..)) {
                open.extend(node.operands());
            }
        }
        // In rising order, so that every node comes after what it reads.
        for next in wanted {
            let expanded = self.expand(next);
            self.polynomials.insert(next, expanded);
        }
        self.polynomials.entry(id).or_default()
    }

    /// A node whose operands are expanded.
    fn expand(&self, id: NodeId) -> Polynomial {
        match self.arena.node(id) {
            Node::One => Polynomial::constant(Ratio::ONE),
            Node::Input(_) | Node::Function(..) => Polynomial::variable(id),
            Node::Sum(terms) => self.sum(terms),
            Node::Product(a, b) => {
                let (mut left, mut right) = (self.known(*a), self.known(*b));
                if left.len() * right.len() > self.most_terms {
                    let (long, node) = if left.len() > right.len() {
                        (&mut left, *a)
                    } else {
                        (&mut right, *b)
                    };
                    *long = Polynomial::variable(node);
                }
                left.product(&right)
            }
            Node::Quotient(a, b) => {
                let inverse = self.known(*b).inverse();
                let inverse = inverse.or_else(|| Polynomial::variable(*b).inverse());
                self.known(*a).product(&inverse.unwrap_or_default())
            }
        }
    }

    fn sum(&self, terms: &[Value]) -> Polynomial {
        let mut parts: Vec<_> = terms
            .iter()
            .map(|term| (*term, self.known(term.node)))
            .collect();
        loop {
            let mut result = Polynomial::default();
            for (term, part) in &parts {
                result.add_scaled(part, term.factor);
            }
            let longest = parts.iter_mut().max_by_key(|(_, part)| part.len());
            match longest {
                Some((term, part)) if result.len() > self.most_terms && part.len() > 1 => {
                    *part = self.unexpanded(term.node);
                }
                _ => return result,
            }
        }
    }

    /// A node of several terms as a variable, or a product as that of its factors.
    fn unexpanded(&self, id: NodeId) -> Polynomial {
        let factor = |id| {
            let known = self.known(id);
            if known.len() == 1 {
                known
            } else {
                Polynomial::variable(id)
            }
        };
        match self.arena.node(id) {
            Node::Product(a, b) => factor(*a).product(&factor(*b)),
            Node::One | Node::Input(_) | Node::Sum(_) | Node::Quotient(..) | Node::Function(..) => {
                Polynomial::variable(id)
            }
        }
    }

    /// An expanded node as others read it.
    fn known(&self, id: NodeId) -> Polynomial {
        if self.parts.contains(&id) {
            return Polynomial::variable(id);
        }
        self.polynomials.get(&id).cloned().unwrap_or_default()
    }
}
