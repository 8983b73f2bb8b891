//! Staging by linearity: uniform coefficients of what varies.
//!
//! A function that is linear in what varies, whatever chain of actions, duals and projections it is
//! made of, is a matrix: its entries depend on uniform inputs alone and are computed once. This
//! pass writes every value as `Σ u m` with uniform coefficients u and *monomials* m, which are
//! products of varying *atoms*: inputs, functions, quotients, and sums that are left as they are. A
//! uniform expression stays as it is; only what varies is expanded.
//!
//! It is right by the distributive law. What it may not do is lose accuracy:
//!
//! - a product of two sums that vary is not expanded. The square of a small difference of large
//!   numbers is accurate as a product, but not as a sum of products;
//! - a sum of inputs as they are is an atom. In `n · (x − p)` the difference of near points is
//!   exact, and `n · x − n · p` is not.
//!
//! What remains are sums whose terms are rounded anyway, so that the error stays within the same
//! bound.

use crate::order::Order as _;
use std::collections::BTreeMap;

use super::cost;
use super::optimise::varying_cost;
use super::rewrite::{Graph, reads};
use super::uniformity::Uniformity;
use crate::algebra::Ratio;
use crate::ir::{Arena, Node, NodeId, Value};

/// The largest number of terms that a value may have; beyond it the value becomes an atom.
const MOST_TERMS: usize = 20;

/// What is expanded and what is an atom.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Policy {
    /// Whether sums without uniform parts are expanded, too.
    expands_varying: bool,
    /// Whether a varying factor is multiplied into a sum.
    distributes: bool,
    /// Whether a value that is read more than once is an atom.
    keeps_shared: bool,
}

impl Policy {
    fn all() -> impl Iterator<Item = Self> {
        (0..8).map(|bits| Self {
            expands_varying: bits & 1 != 0,
            distributes: bits & 2 != 0,
            keeps_shared: bits & 4 != 0,
        })
    }
}

/// A graph with its uniform coefficients collected.
pub(crate) struct Collected {
    pub(crate) graph: Graph,
    /// Values that are known to be zero.
    pub(crate) relations: Vec<Value>,
    /// The operations of each call, then all operations, before other passes.
    pub(crate) price: (usize, usize),
}

/// A graph with its uniform coefficients collected, in several ways, the cheapest first; none where
/// no input is uniform. `relations` are values of the arena that are known to be zero, each of
/// uniform inputs alone or of others alone.
#[must_use]
pub(crate) fn uniform_coefficients(
    arena: &Arena,
    outputs: &[Value],
    relations: &[Value],
    uniform: &[bool],
) -> Vec<Collected> {
    if !uniform.contains(&true) {
        return Vec::new();
    }
    let mut found = Vec::new();
    for policy in Policy::all() {
        let expansion = Expansion::new(arena, outputs, relations, uniform, policy);
        let Some((copy, mut values)) = expansion.graph(outputs, relations) else {
            continue;
        };
        let relations = values.split_off(outputs.len());
        let price = (
            varying_cost(&copy, &values, uniform),
            cost(&copy, &values).total(),
        );
        found.push(Collected {
            graph: (copy, values),
            relations,
            price,
        });
    }
    found.order_by_key(|collected| collected.price);
    found
}

/// A product of atoms, which are nodes of the copy in rising order.
type Monomial = Vec<NodeId>;

/// Uniform coefficients of monomials.
type Polynomial = BTreeMap<Monomial, Value>;

/// What the inputs do that a node depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Dependence {
    Uniform,
    Varying,
    Mixed,
}

struct Expansion<'a> {
    arena: &'a Arena,
    reads: Vec<usize>,
    dependence: Vec<Dependence>,
    policy: Policy,
    copy: Arena,
    /// The nodes that are uniform or have no uniform part, in the copy.
    images: Vec<Value>,
    polynomials: Vec<Polynomial>,
    /// The monomials that are built, in the copy.
    monomials: BTreeMap<Monomial, Value>,
}

impl<'a> Expansion<'a> {
    fn new(
        arena: &'a Arena,
        outputs: &[Value],
        relations: &[Value],
        uniform: &[bool],
        policy: Policy,
    ) -> Self {
        let all: Vec<Value> = outputs.iter().chain(relations).copied().collect();
        Self {
            arena,
            reads: reads(arena, &all),
            dependence: dependence(arena, uniform),
            policy,
            copy: Arena::default(),
            images: vec![Value::ZERO; arena.len()],
            polynomials: vec![Polynomial::new(); arena.len()],
            monomials: BTreeMap::new(),
        }
    }

    fn graph(mut self, outputs: &[Value], relations: &[Value]) -> Option<Graph> {
        let inputs: Vec<Value> = (0..self.arena.inputs())
            .map(|_| self.copy.input())
            .collect();
        for id in self.arena.ids() {
            if self.reads[id.index()] == 0 {
                continue;
            }
            if self.dependence[id.index()] != Dependence::Mixed {
                self.images[id.index()] = match self.arena.node(id) {
                    Node::Input(number) => inputs[*number],
                    node => self.copy.copied(node, &self.images)?,
                };
            }
            self.polynomials[id.index()] = self.polynomial(id)?;
        }
        let wanted: Vec<Polynomial> = outputs.iter().map(|&value| self.of(value)).collect();
        let mut monomials: Vec<&Monomial> = wanted.iter().flat_map(Polynomial::keys).collect();
        monomials.order_by_key(|monomial| monomial.len());
        for monomial in monomials {
            self.monomial(monomial);
        }
        let mut values: Vec<Value> = wanted.iter().map(|output| self.value(output)).collect();
        values.extend(
            relations
                .iter()
                .map(|value| self.images[value.node.index()].scaled(value.factor)),
        );
        Some((self.copy, values))
    }

    fn polynomial(&mut self, id: NodeId) -> Option<Polynomial> {
        let image = self.images[id.index()];
        match self.dependence[id.index()] {
            Dependence::Uniform => return Some(constant(image)),
            Dependence::Varying if !self.policy.expands_varying => {
                if !matches!(self.arena.node(id), Node::Product(..)) {
                    return Some(atom(image));
                }
            }
            Dependence::Varying | Dependence::Mixed => {}
        }
        let found = match self.arena.node(id) {
            Node::One | Node::Input(_) => return Some(atom(image)),
            Node::Sum(terms) => {
                let sum = self.sum(terms);
                if is_exact(self.arena, terms) {
                    return Some(self.as_atom(&sum));
                }
                sum
            }
            Node::Product(a, b) => {
                let [left, right] = [a, b].map(|part| self.polynomials[part.index()].clone());
                self.product(&left, &right)
            }
            Node::Quotient(a, b) => {
                let [dividend, divisor] = [a, b].map(|part| self.polynomials[part.index()].clone());
                self.quotient(&dividend, &divisor)?
            }
            Node::Function(function, arguments) => {
                let arguments: Vec<Value> = arguments
                    .iter()
                    .map(|&argument| self.of(argument))
                    .collect::<Vec<_>>()
                    .iter()
                    .map(|argument| self.value(argument))
                    .collect();
                atom(self.copy.function(*function, &arguments))
            }
        };
        let is_kept = self.policy.keeps_shared && self.reads[id.index()] > 1;
        Some(
            if found.len() > MOST_TERMS || (is_kept && found.len() > 1) {
                self.as_atom(&found)
            } else {
                found
            },
        )
    }

    /// The polynomial of a value.
    fn of(&mut self, value: Value) -> Polynomial {
        let polynomial = &self.polynomials[value.node.index()];
        let terms = polynomial.iter();
        terms
            .map(|(monomial, unit)| (monomial.clone(), unit.scaled(value.factor)))
            .collect()
    }

    fn sum(&mut self, terms: &[Value]) -> Polynomial {
        let mut parts: BTreeMap<Monomial, Vec<Value>> = BTreeMap::new();
        for term in terms {
            for (monomial, unit) in &self.polynomials[term.node.index()] {
                let unit = unit.scaled(term.factor);
                match parts.get_mut(monomial) {
                    Some(units) => units.push(unit),
                    None => {
                        parts.insert(monomial.clone(), vec![unit]);
                    }
                }
            }
        }
        let collected = parts
            .into_iter()
            .map(|(monomial, units)| (monomial, self.copy.sum(units)));
        collected.filter(|(_, unit)| !unit.is_zero()).collect()
    }

    fn product(&mut self, left: &Polynomial, right: &Polynomial) -> Polynomial {
        let is_single = |part: &Polynomial| part.len() < 2;
        let is_uniform = |part: &Polynomial| part.keys().all(Vec::is_empty);
        let is_expanded = match (is_single(left), is_single(right)) {
            (true, true) => true,
            (true, false) => is_uniform(left) || self.policy.distributes,
            (false, true) => is_uniform(right) || self.policy.distributes,
            (false, false) => false,
        };
        if !is_expanded {
            let (left, right) = (self.value(left), self.value(right));
            return atom(self.copy.product(left, right));
        }
        let mut terms = Polynomial::new();
        for (first, u) in left {
            for (second, v) in right {
                let mut monomial = first.clone();
                monomial.extend(second);
                monomial.order();
                // One of the sides is single, so that no two monomials are equal.
                terms.insert(monomial, self.copy.product(*u, *v));
            }
        }
        terms
    }

    fn quotient(&mut self, dividend: &Polynomial, divisor: &Polynomial) -> Option<Polynomial> {
        let below = self.value(divisor);
        if divisor.keys().all(Vec::is_empty) {
            let inverse = self.copy.quotient(Value::ONE, below)?;
            let terms = dividend
                .iter()
                .map(|(monomial, unit)| (monomial.clone(), self.copy.product(*unit, inverse)));
            return Some(terms.collect());
        }
        if dividend.len() == 1
            && let Some((monomial, unit)) = dividend.first_key_value()
            && !monomial.is_empty()
        {
            let above = self.monomial(monomial);
            let quotient = self.copy.quotient(above, below)?;
            return Some(scaled(&atom(quotient), *unit, &mut self.copy));
        }
        let above = self.value(dividend);
        Some(atom(self.copy.quotient(above, below)?))
    }

    fn as_atom(&mut self, polynomial: &Polynomial) -> Polynomial {
        atom(self.value(polynomial))
    }

    /// The value of a polynomial in the copy.
    fn value(&mut self, polynomial: &Polynomial) -> Value {
        let mut terms = Vec::with_capacity(polynomial.len());
        for (monomial, unit) in polynomial {
            let product = self.monomial(monomial);
            terms.push(self.copy.product(*unit, product));
        }
        self.copy.sum(terms)
    }

    /// A monomial in the copy: another one times an atom, where there is one.
    fn monomial(&mut self, monomial: &Monomial) -> Value {
        match monomial[..] {
            [] => return Value::ONE,
            [single] => return Value::of(single),
            _ => {}
        }
        if let Some(&known) = self.monomials.get(monomial) {
            return known;
        }
        let without = |place: usize| {
            let mut rest = monomial.clone();
            let atom = rest.remove(place);
            (rest, atom)
        };
        let known = (0..monomial.len())
            .map(without)
            .find(|(rest, _)| self.monomials.contains_key(rest));
        let (rest, atom) = known.unwrap_or_else(|| without(monomial.len() - 1));
        let rest = self.monomial(&rest);
        let product = self.copy.product(rest, Value::of(atom));
        self.monomials.insert(monomial.clone(), product);
        product
    }
}

fn constant(value: Value) -> Polynomial {
    if value.is_zero() {
        return Polynomial::new();
    }
    Polynomial::from([(Monomial::new(), value)])
}

/// A value as a node of the copy with a constant coefficient.
fn atom(value: Value) -> Polynomial {
    if value.as_constant().is_some() {
        return constant(value);
    }
    Polynomial::from([(vec![value.node], Value::constant(value.factor))])
}

fn scaled(polynomial: &Polynomial, unit: Value, copy: &mut Arena) -> Polynomial {
    let terms = polynomial.iter();
    terms
        .map(|(monomial, other)| (monomial.clone(), copy.product(*other, unit)))
        .collect()
}

/// Whether all terms of a sum are exact, so that their differences are: inputs and numbers, not
/// rounded yet.
fn is_exact(arena: &Arena, terms: &[Value]) -> bool {
    terms.len() > 1
        && terms.iter().all(|term| match arena.node(term.node) {
            Node::One => true,
            Node::Input(_) => term.factor.abs() == Ratio::ONE,
            _ => false,
        })
}

fn dependence(arena: &Arena, uniform: &[bool]) -> Vec<Dependence> {
    let mut uniformity = Uniformity::new(uniform);
    let mut found: Vec<Dependence> = Vec::with_capacity(arena.len());
    for id in arena.ids() {
        let next = if uniformity.is_uniform(arena, id) {
            Dependence::Uniform
        } else {
            let mut has_uniform = false;
            arena.node(id).for_each_operand(|operand| {
                let is_pure =
                    operand == Arena::ONE || found[operand.index()] == Dependence::Varying;
                has_uniform |= !is_pure;
            });
            if has_uniform {
                Dependence::Mixed
            } else {
                Dependence::Varying
            }
        };
        found.push(next);
    }
    found
}
