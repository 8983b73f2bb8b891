//! Graphs of hash-consed scalar nodes.

use std::collections::hash_map::Entry;

use rustc_hash::FxHashMap;

use super::{Function, Node, NodeId, Value};
use crate::algebra::Ratio;
use crate::order::Order as _;

/// The nodes of a graph, each stored once.
#[derive(Clone, Debug)]
pub struct Arena {
    nodes: Vec<Node>,
    known: FxHashMap<Node, NodeId>,
    inputs: usize,
    has_reciprocals: bool,
}

impl Default for Arena {
    fn default() -> Self {
        Self {
            nodes: vec![Node::One],
            known: [(Node::One, Self::ONE)].into_iter().collect(),
            inputs: 0,
            has_reciprocals: false,
        }
    }
}

impl Arena {
    /// The node of the number 1, present in every arena.
    pub const ONE: NodeId = NodeId::ONE;

    /// The node at a place.
    #[must_use]
    pub fn node(&self, id: NodeId) -> &Node {
        &self.nodes[id.index()]
    }

    /// The number of nodes.
    #[must_use]
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Always false, since the node of the number 1 is in every arena.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// The nodes, each after everything that it refers to.
    pub fn ids(&self) -> impl DoubleEndedIterator<Item = NodeId> + use<> {
        self.ids_from(0)
    }

    /// The nodes from a place on.
    pub fn ids_from(&self, place: usize) -> impl DoubleEndedIterator<Item = NodeId> + use<> {
        (place..self.nodes.len()).map(NodeId)
    }

    /// The number of inputs so far.
    #[must_use]
    pub fn inputs(&self) -> usize {
        self.inputs
    }

    /// A new input, numbered in order from zero.
    pub fn input(&mut self) -> Value {
        let node = self.intern(Node::Input(self.inputs));
        self.inputs += 1;
        Value::of(node)
    }

    /// The product of two values. A number and its [`Function::Reciprocal`] cancel.
    pub fn product(&mut self, left: Value, right: Value) -> Value {
        let factor = left.factor * right.factor;
        if factor.is_zero() {
            return Value::ZERO;
        }
        if self.has_reciprocals
            && let Some(product) = self
                .cancelled(left.node, right.node)
                .or_else(|| self.distributed_product(left.node, right.node))
                .or_else(|| self.distributed_product(right.node, left.node))
        {
            return product.scaled(factor);
        }
        let (first, second) = (left.node.min(right.node), left.node.max(right.node));
        let node = if first == Self::ONE {
            second
        } else {
            self.intern(Node::Product(first, second))
        };
        Value { factor, node }
    }

    /// The product of two nodes, where a factor of one is the reciprocal of a factor of the other.
    fn cancelled(&mut self, left: NodeId, right: NodeId) -> Option<Value> {
        let (mut left, mut right) = (self.factors(left)?, self.factors(right)?);
        let mut has_cancelled = false;
        let mut place = 0;
        while place < left.len() {
            let cancels = |other: &NodeId| {
                let pair = [left[place], *other];
                self.inverse_of(pair[0]) == Some(pair[1])
                    || self.inverse_of(pair[1]) == Some(pair[0])
            };
            match right.iter().position(cancels) {
                Some(other) => {
                    left.remove(place);
                    right.remove(other);
                    has_cancelled = true;
                }
                None => place += 1,
            }
        }
        has_cancelled.then(|| self.product_of(left.into_iter().chain(right)))
    }

    /// `(a d + b)/d = a + b/d`: the quotient of a sum all terms of which but one have the divisor
    /// as a factor; `quotient` gives that of a term, and whether the divisor cancels in it.
    fn distributed(
        &mut self,
        sum: NodeId,
        mut quotient: impl FnMut(&mut Self, NodeId) -> (Value, bool),
    ) -> Option<Value> {
        let Node::Sum(terms) = self.node(sum) else {
            return None;
        };
        let terms = terms.clone();
        let (mut quotients, mut others) = (Vec::with_capacity(terms.len()), 0);
        for term in &terms {
            let (value, cancels) = quotient(self, term.node);
            others += usize::from(!cancels);
            if others > 1 {
                return None;
            }
            quotients.push(value.scaled(term.factor));
        }
        (others < terms.len()).then(|| self.sum(quotients))
    }

    /// The product of a sum and a reciprocal that cancels in it.
    fn distributed_product(&mut self, sum: NodeId, reciprocal: NodeId) -> Option<Value> {
        let Node::Function(Function::Reciprocal, _) = self.node(reciprocal) else {
            return None;
        };
        self.distributed(sum, |arena, term| match arena.cancelled(term, reciprocal) {
            Some(value) => (value, true),
            None => (arena.product(Value::of(term), Value::of(reciprocal)), false),
        })
    }

    /// What a node is the reciprocal of, or a divisor by.
    fn inverse_of(&self, node: NodeId) -> Option<NodeId> {
        match self.node(node) {
            Node::Function(Function::Reciprocal | Function::Divisor, argument) => {
                Some(argument[0].node)
            }
            _ => None,
        }
    }

    /// The dividend without the divisor among its factors, where quotients by it are 0 for 0.
    fn without_factor(&mut self, dividend: NodeId, divisor: NodeId) -> Option<Value> {
        let inverse = self.inverse_of(divisor)?;
        let mut factors = self.factors(dividend)?;
        let place = factors.iter().position(|factor| *factor == inverse)?;
        factors.remove(place);
        Some(self.product_of(factors.into_iter()))
    }

    fn product_of(&mut self, factors: impl Iterator<Item = NodeId>) -> Value {
        factors.fold(Value::ONE, |whole, factor| {
            self.product(whole, Value::of(factor))
        })
    }

    /// The factors of a product; none where there are many.
    fn factors(&self, node: NodeId) -> Option<Vec<NodeId>> {
        const MOST: usize = 8;
        let mut factors = Vec::with_capacity(MOST);
        factors.push(node);
        let mut place = 0;
        while let Some(next) = factors.get(place) {
            match *self.node(*next) {
                Node::Product(..) if factors.len() == MOST => return None,
                Node::Product(a, b) => {
                    factors[place] = a;
                    factors.insert(place + 1, b);
                }
                _ => place += 1,
            }
        }
        Some(factors)
    }

    /// The quotient of two values; a constant divisor becomes a factor. `None` where the divisor is
    /// known to be zero.
    pub fn quotient(&mut self, dividend: Value, divisor: Value) -> Option<Value> {
        let inverse = divisor.factor.recip()?;
        if dividend.is_zero() || divisor.node == Self::ONE {
            return Some(dividend.scaled(inverse));
        }
        let factor = dividend.factor * inverse;
        if self.inverse_of(divisor.node).is_some() {
            let divisor = divisor.node;
            let whole = self.without_factor(dividend.node, divisor).or_else(|| {
                self.distributed(dividend.node, |arena, term| {
                    match arena.without_factor(term, divisor) {
                        Some(value) => (value, true),
                        None => (
                            Value::of(arena.intern(Node::Quotient(term, divisor))),
                            false,
                        ),
                    }
                })
            });
            if let Some(whole) = whole {
                return Some(whole.scaled(factor));
            }
        }
        let node = self.intern(Node::Quotient(dividend.node, divisor.node));
        Some(Value { factor, node })
    }

    /// The sum of any number of values: equal nodes are collected, and the common factor moves
    /// outwards.
    pub fn sum(&mut self, values: impl IntoIterator<Item = Value>) -> Value {
        match normal_sum(values) {
            Ok(value) => value,
            Err((factor, terms)) => {
                let node = self.intern(Node::Sum(terms));
                Value { factor, node }
            }
        }
    }

    /// The sum of some values, if the arena has it already.
    #[must_use]
    pub fn known_sum(&self, values: impl IntoIterator<Item = Value>) -> Option<Value> {
        match normal_sum(values) {
            Ok(value) => Some(value),
            Err((factor, terms)) => {
                let node = *self.known.get(&Node::Sum(terms))?;
                Some(Value { factor, node })
            }
        }
    }

    /// A function of values.
    pub fn function(&mut self, function: Function, arguments: &[Value]) -> Value {
        if let Some(known) = constant_value(function, arguments) {
            return Value::constant(known);
        }
        if let [argument] = arguments {
            let (outer, inner) = function.outer_factor(argument.factor);
            if inner != argument.factor {
                let argument = Value {
                    factor: inner,
                    ..*argument
                };
                return self.function(function, &[argument]).scaled(outer);
            }
        }
        match (function, arguments) {
            // `1/x² = (1/x)²`, so that powers of x cancel.
            (Function::Reciprocal, [square]) if matches!(self.node(square.node), Node::Product(a, b) if a == b) =>
            {
                let Node::Product(root, _) = *self.node(square.node) else {
                    return Value::ZERO;
                };
                let inverse = self.function(function, &[Value::of(root)]);
                return self.product(inverse, inverse);
            }
            (Function::Reciprocal, _) => self.has_reciprocals = true,
            (Function::Select, [_, first, second]) if first == second => return *first,
            (Function::Select, [condition, first, second])
                if let Some(holds) = condition.as_constant() =>
            {
                return if holds.is_zero() { *second } else { *first };
            }
            // A common factor moves outwards.
            (Function::Select, [condition, first, second])
                if first.factor == second.factor && first.factor != Ratio::ONE =>
            {
                let arguments = [*condition, Value::of(first.node), Value::of(second.node)];
                return self.function(function, &arguments).scaled(first.factor);
            }
            // Of two multiples of a number the factor is chosen.
            (Function::Select, [condition, first, second])
                if first.node == second.node && first.node != Self::ONE =>
            {
                let factors = [first.factor, second.factor].map(Value::constant);
                let factor = self.function(function, &[*condition, factors[0], factors[1]]);
                return self.product(factor, Value::of(first.node));
            }
            (Function::Equal, [first, second]) if second.node < first.node => {
                return self.function(function, &[*second, *first]);
            }
            (Function::Not, [condition]) => {
                if let Node::Function(Function::Not, inner) = self.node(condition.node) {
                    return inner[0];
                }
            }
            _ => {}
        }
        let node = self.intern(Node::Function(function, arguments.into()));
        Value::of(node)
    }

    /// A multiple as a node of its own, so that it is multiplied once for several operations.
    /// Otherwise factors move outwards, and `2 x` times `y` becomes 2 times `x y`. The sign stays
    /// outside.
    pub fn held(&mut self, value: Value) -> Value {
        let size = value.factor.abs();
        if size == Ratio::ONE || value.as_constant().is_some() {
            return value;
        }
        let term = Value {
            factor: size,
            ..value
        };
        Value {
            factor: value.factor / size,
            node: self.intern(Node::Sum(Box::new([term]))),
        }
    }

    /// A sum with its terms as they are, the first of them positive: for the last pass, after which
    /// no equal sums are looked for.
    pub(crate) fn ordered_sum(&mut self, terms: Vec<Value>) -> Value {
        let node = self.intern(Node::Sum(terms.into()));
        Value::of(node)
    }

    /// The difference of two values.
    pub fn difference(&mut self, left: Value, right: Value) -> Value {
        self.sum([left, -right])
    }

    fn intern(&mut self, node: Node) -> NodeId {
        match self.known.entry(node) {
            Entry::Occupied(known) => *known.get(),
            Entry::Vacant(new) => {
                let id = NodeId(self.nodes.len());
                self.nodes.push(new.key().clone());
                *new.insert(id)
            }
        }
    }
}

/// What a function is at constants, where that is a fraction.
fn constant_value(function: Function, arguments: &[Value]) -> Option<Ratio> {
    let constants: Option<Vec<Ratio>> = arguments.iter().map(|x| x.as_constant()).collect();
    function.folded(&constants?)
}

/// The value that a sum is without a node of its own, or else its factor and the terms of its node.
fn normal_sum(values: impl IntoIterator<Item = Value>) -> Result<Value, (Ratio, Box<[Value]>)> {
    let mut terms: Vec<Value> = values.into_iter().filter(|v| !v.is_zero()).collect();
    terms.order_by_key(|value| value.node);
    terms.dedup_by(|next, kept| {
        let same = next.node == kept.node;
        if same {
            kept.factor = kept.factor + next.factor;
        }
        same
    });
    terms.retain(|value| !value.is_zero());
    match terms.as_slice() {
        [] => return Ok(Value::ZERO),
        [single] => return Ok(*single),
        _ => {}
    }
    let factor = common_factor(&terms);
    for term in &mut terms {
        term.factor = term.factor / factor;
    }
    Err((factor, terms.into()))
}

/// The factor that leaves coprime integers, the first of them positive.
fn common_factor(terms: &[Value]) -> Ratio {
    let is_whole = |term: &Value| term.factor.is_integer();
    let is_unit = |term: &Value| term.factor.abs() == Ratio::ONE;
    if terms.iter().all(is_whole) && terms.iter().any(is_unit) {
        let is_negative = terms[0].factor.is_negative();
        return Ratio::integer(if is_negative { -1 } else { 1 });
    }
    // Terms without a common denominator in range keep their factors.
    let size = Ratio::content(terms.iter().map(|term| term.factor)).unwrap_or(Ratio::ONE);
    match terms.first() {
        Some(first) if first.factor.is_negative() => -size,
        _ => size,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_expressions_are_one_node() {
        let mut arena = Arena::default();
        let (a, b) = (arena.input(), arena.input());
        let first = arena.difference(a, b);
        let second = arena.difference(b, a);
        assert_eq!(first, -second);
        assert_eq!(arena.product(a, b), arena.product(b, a));
        let doubled = arena.sum([a, a, b, b]);
        let plain = arena.sum([b, a]);
        assert_eq!(doubled, plain.scaled(Ratio::integer(2)));
    }

    #[test]
    fn what_cancels_is_zero() {
        let mut arena = Arena::default();
        let (a, b) = (arena.input(), arena.input());
        let (ab, ba) = (arena.product(a, b), arena.product(b, a));
        assert_eq!(arena.difference(ab, ba), Value::ZERO);
        assert_eq!(arena.product(a, Value::ZERO), Value::ZERO);
        assert_eq!(arena.product(a, Value::ONE), a);
    }
}
