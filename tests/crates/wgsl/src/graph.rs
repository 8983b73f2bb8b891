//! A graph in double precision.

use ga_compiler::function::CompiledFunction;
use ga_compiler::ir::{Function, Node, Value};
use ga_runtime::scalar::{versor_exponential, versor_logarithm};

/// The outputs of a function's graph for the given inputs.
#[must_use]
pub fn evaluate(function: &CompiledFunction, inputs: &[f64]) -> Vec<f64> {
    let arena = &function.kernel.arena;
    let mut known: Vec<f64> = Vec::with_capacity(arena.len());
    for id in arena.ids() {
        let of = |value: &Value| known[value.node.index()] * value.factor.to_f64();
        let next = match arena.node(id) {
            Node::One => 1.0,
            Node::Input(number) => inputs[*number],
            Node::Sum(terms) => terms.iter().map(of).sum(),
            Node::Product(a, b) => known[a.index()] * known[b.index()],
            Node::Quotient(_, b) if is_guarded(arena.node(*b)) && known[b.index()] == 0.0 => 0.0,
            Node::Quotient(a, b) => known[a.index()] / known[b.index()],
            Node::Function(function, arguments) => {
                let arguments: Vec<f64> = arguments.iter().map(of).collect();
                let x = arguments[0];
                let pair = || versor_logarithm(x, arguments[1]);
                match function {
                    Function::SquareRoot => x.sqrt(),
                    Function::Absolute => x.abs(),
                    Function::Sine => x.sin(),
                    Function::Cosine => x.cos(),
                    Function::ArcTangent => x.atan2(arguments[1]),
                    Function::Exponential => x.exp(),
                    Function::NaturalLogarithm => x.ln(),
                    Function::StumpffCosine => versor_exponential(x).0,
                    Function::StumpffSine => versor_exponential(x).1,
                    Function::StumpffSineSlope => versor_exponential(x).2,
                    Function::VersorAngle => pair().0,
                    Function::VersorAngleSlope => pair().1,
                    Function::Minimum => x.min(arguments[1]),
                    Function::Maximum => x.max(arguments[1]),
                    Function::Less => f64::from(x < arguments[1]),
                    Function::LessOrEqual => f64::from(x <= arguments[1]),
                    Function::Equal => f64::from(x == arguments[1]),
                    Function::And => x * arguments[1],
                    Function::Or => x.max(arguments[1]),
                    Function::Not => 1.0 - x,
                    Function::Select if x == 0.0 => arguments[2],
                    Function::Select => arguments[1],
                    Function::HyperbolicSine => x.sinh(),
                    Function::HyperbolicCosine => x.cosh(),
                    Function::HyperbolicTangent => x.tanh(),
                    Function::Hypotenuse => x.hypot(arguments[1]),
                    Function::Reciprocal => {
                        if x == 0.0 {
                            0.0
                        } else {
                            x.recip()
                        }
                    }
                    Function::Divisor => x,
                }
            }
        };
        known.push(next);
    }
    let outputs = function.kernel.outputs.iter();
    outputs
        .map(|output| known[output.node.index()] * output.factor.to_f64())
        .collect()
}

/// Whether quotients by a node are 0 where it is.
fn is_guarded(divisor: &Node) -> bool {
    matches!(divisor, Node::Function(Function::Divisor, _))
}
