//! The values of graphs.

use super::{Arena, Node, Number, Outcomes, Residue, Value};

impl Arena {
    /// The values of all nodes for the given inputs, over the prime field. A root that does not
    /// exist, and the inverse of zero, is an arbitrary residue.
    #[must_use]
    pub fn evaluate(&self, inputs: &[Residue]) -> Vec<Residue> {
        let inputs: Vec<Number> = inputs.iter().copied().map(Number::from).collect();
        let values = self.evaluate_with(&inputs, &Outcomes::default());
        let residues = values.into_iter().map(Number::residue);
        residues
            .map(|value| value.unwrap_or(Residue::ZERO))
            .collect()
    }

    /// The values of all nodes for the given inputs, where outcomes are taken for some comparisons.
    pub(crate) fn evaluate_with(&self, inputs: &[Number], outcomes: &Outcomes) -> Vec<Number> {
        let mut results: Vec<Number> = Vec::with_capacity(self.len());
        for id in self.ids() {
            let of = |value: &Value| results[value.node.index()] * Number::from_ratio(value.factor);
            let result = match self.node(id) {
                Node::One => Number::ONE,
                Node::Input(number) => inputs[*number],
                Node::Sum(terms) => terms
                    .iter()
                    .map(of)
                    .fold(Number::ZERO, |sum, term| sum + term),
                Node::Product(a, b) => results[a.index()] * results[b.index()],
                Node::Quotient(a, b) => results[a.index()] * results[b.index()].recip(),
                Node::Function(function, arguments) => {
                    let arguments: Vec<_> = arguments.iter().map(of).collect();
                    Number::function(*function, &arguments, outcomes)
                }
            };
            results.push(result);
        }
        results
    }
}
