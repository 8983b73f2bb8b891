//! What a graph costs: multiplications and additions of the code that it becomes.

use super::rewrite::reads;
use crate::algebra::Ratio;
use crate::ir::{Arena, Function, Node, Value};

/// Numbers of operations. A multiplication by 2 or ½ is one multiplication, a subtraction one
/// addition.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Multiplications.
    pub multiplications: usize,
    /// Additions and subtractions.
    pub additions: usize,
    /// Divisions.
    pub divisions: usize,
    /// Square roots.
    pub roots: usize,
    /// Other functions.
    pub functions: usize,
    /// Negations that no other operation takes in.
    pub negations: usize,
}

impl Cost {
    /// Everything but negations together, which is what decides between rules.
    #[must_use]
    pub const fn total(self) -> usize {
        self.multiplications + self.additions + self.divisions + self.roots + self.functions
    }

    /// The total, then negations.
    #[must_use]
    pub const fn rank(self) -> (usize, usize) {
        (self.total(), self.negations)
    }

    fn scale(&mut self, factor: Ratio) {
        if factor.abs() != Ratio::ONE {
            self.multiplications += 1;
        } else if factor.is_negative() {
            self.negations += 1;
        }
    }
}

/// Counts the operations that some outputs need.
#[must_use]
pub fn cost(arena: &Arena, outputs: &[Value]) -> Cost {
    let mut cost = Cost::default();
    let reads = reads(arena, outputs);
    for id in arena.ids().filter(|id| reads[id.index()] > 0) {
        match arena.node(id) {
            Node::One | Node::Input(_) => {}
            Node::Product(..) => cost.multiplications += 1,
            Node::Quotient(..) => cost.divisions += 1,
            Node::Function(function, arguments) => {
                match function {
                    Function::SquareRoot => cost.roots += 1,
                    Function::Reciprocal => cost.divisions += 1,
                    // The quotient counts.
                    Function::Divisor => {}
                    Function::Absolute
                    | Function::Sine
                    | Function::Cosine
                    | Function::ArcTangent
                    | Function::Exponential
                    | Function::NaturalLogarithm
                    | Function::StumpffCosine
                    | Function::StumpffSine
                    | Function::StumpffSineSlope
                    | Function::VersorAngle
                    | Function::VersorAngleSlope
                    | Function::Minimum
                    | Function::Maximum
                    | Function::Less
                    | Function::LessOrEqual
                    | Function::Equal
                    | Function::And
                    | Function::Or
                    | Function::Not
                    | Function::Select
                    | Function::HyperbolicSine
                    | Function::HyperbolicCosine
                    | Function::HyperbolicTangent
                    | Function::Hypotenuse => cost.functions += 1,
                }
                for argument in arguments.iter().filter(|v| v.as_constant().is_none()) {
                    cost.scale(argument.factor);
                }
            }
            Node::Sum(terms) => {
                cost.additions += terms.len() - 1;
                let scaled = terms
                    .iter()
                    .filter(|term| term.node != Arena::ONE && term.factor.abs() != Ratio::ONE);
                cost.multiplications += scaled.count();
            }
        }
    }
    for output in outputs {
        if output.as_constant().is_none() {
            cost.scale(output.factor);
        }
    }
    cost
}
