//! A graph as statements of WGSL.

use std::collections::{BTreeSet, HashMap};

use super::names::Names;
use crate::algebra::Ratio;
use crate::ir::{Arena, Function, Node, NodeId, Value};
use crate::passes::Stage;

/// Writes one stage of a graph.
pub(super) struct Body<'a> {
    pub(super) arena: &'a Arena,
    pub(super) stage: &'a Stage,
    /// Expressions of the nodes that are not computed here, and variables of those that are.
    pub(super) known: HashMap<NodeId, String>,
    /// The names in scope.
    pub(super) names: Names,
    /// How many variables have been declared.
    pub(super) variables: usize,
    /// The functions that are called.
    pub(super) functions: BTreeSet<Function>,
    /// The names under which our own functions are declared.
    pub(super) function_names: &'a dyn Fn(Function) -> String,
}

impl Body<'_> {
    /// Declares every node that is read more than once.
    pub(super) fn statements(&mut self) -> String {
        let mut text = String::new();
        for &id in &self.stage.order {
            if self.stage.uses[id.index()] > 1 {
                let expression = self.expression(id);
                self.variables += 1;
                let name = self.names.give(&format!("t{}", self.variables));
                text.push_str(&format!("    let {name} = {expression};\n"));
                self.known.insert(id, name);
            }
        }
        text
    }

    /// A value with its factor.
    pub(super) fn value(&mut self, value: Value) -> String {
        if let Some(known) = value.as_constant() {
            return constant(known);
        }
        if value.factor == Ratio::ONE {
            return self.read(value.node);
        }
        if value.factor == Ratio::integer(-1) {
            return self.negative(value.node);
        }
        format!("{} * {}", constant(value.factor), self.operand(value.node))
    }

    /// The negative of a node; a difference that is read only here is reversed.
    fn negative(&mut self, id: NodeId) -> String {
        if let Node::Sum(terms) = self.arena.node(id)
            && self.is_inlined(id)
            && let Some(first) = terms.iter().position(|term| term.factor.is_negative())
        {
            let mut reversed: Vec<_> = terms.iter().map(|&term| -term).collect();
            reversed[..=first].rotate_right(1);
            return self.sum(&reversed);
        }
        format!("-{}", self.operand(id))
    }

    /// A sum whose first term has a positive factor.
    fn sum(&mut self, terms: &[Value]) -> String {
        let mut text = String::new();
        for (place, term) in terms.iter().enumerate() {
            let size = Value {
                factor: term.factor.abs(),
                ..*term
            };
            match (place, term.factor.is_negative()) {
                (0, _) => {}
                (_, false) => text.push_str(" + "),
                (_, true) => text.push_str(" - "),
            }
            let term = if size.factor == Ratio::ONE && term.node != Arena::ONE {
                // The first term needs no parentheses.
                match place {
                    0 => self.read(term.node),
                    _ => self.operand(term.node),
                }
            } else {
                self.value(size)
            };
            text.push_str(&term);
        }
        text
    }

    fn is_inlined(&self, id: NodeId) -> bool {
        !self.known.contains_key(&id)
    }

    /// A node where it is read: its name, or its expression where this is the only place.
    pub(super) fn read(&mut self, id: NodeId) -> String {
        match self.known.get(&id) {
            Some(name) => name.clone(),
            None => self.expression(id),
        }
    }

    /// A node as the operand of a multiplication or negation.
    fn operand(&mut self, id: NodeId) -> String {
        let read = self.read(id);
        let is_loose = matches!(self.arena.node(id), Node::Sum(_) | Node::Quotient(..));
        if is_loose && self.is_inlined(id) {
            format!("({read})")
        } else {
            read
        }
    }

    fn expression(&mut self, id: NodeId) -> String {
        let arena = self.arena;
        match arena.node(id) {
            Node::One => constant(Ratio::ONE),
            // Every input that is read is known.
            Node::Input(_) => constant(Ratio::ZERO),
            Node::Product(a, b) => format!("{} * {}", self.operand(*a), self.operand(*b)),
            Node::Quotient(a, b)
                if matches!(arena.node(*b), Node::Function(Function::Divisor, _)) =>
            {
                self.functions.insert(Function::Divisor);
                let name = (self.function_names)(Function::Divisor);
                format!("{name}({}, {})", self.read(*a), self.read(*b))
            }
            // It is known where it divides.
            Node::Function(Function::Divisor, arguments) => self.value(arguments[0]),
            Node::Quotient(a, b) => {
                let (dividend, divisor) = (self.operand(*a), self.operand(*b));
                // A product in the divisor needs parentheses.
                if self.is_inlined(*b) && matches!(arena.node(*b), Node::Product(..)) {
                    format!("{dividend} / ({divisor})")
                } else {
                    format!("{dividend} / {divisor}")
                }
            }
            Node::Sum(terms) => match &**terms {
                [single] => self.value(*single),
                terms => self.sum(terms),
            },
            Node::Function(function, arguments) => {
                self.functions.insert(*function);
                let arguments: Vec<_> = arguments
                    .iter()
                    .map(|&argument| self.value(argument))
                    .collect();
                let name = (self.function_names)(*function);
                match (function, arguments.as_slice()) {
                    (Function::Not, [a]) => format!("{name}({a})"),
                    // The value for a condition that holds comes second.
                    (Function::Select, [condition, a, b]) => {
                        format!("{name}({b}, {a}, {condition})")
                    }
                    (_, [a, b]) if function.is_condition() => format!("({a} {name} {b})"),
                    _ => format!("{name}({})", arguments.join(", ")),
                }
            }
        }
    }
}

/// A number of type f32.
pub(super) fn constant(value: Ratio) -> String {
    #[allow(clippy::cast_possible_truncation, reason = "WGSL has single precision")]
    let single = value.to_f64() as f32;
    format!("{single:?}")
}
