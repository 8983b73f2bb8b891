//! The value of a graph in double precision: what the emitted code computes.

use ga_compiler::ir::{Function, Node, Value};
use ga_compiler::kernel::Kernel;

pub(super) fn outputs(kernel: &Kernel, inputs: &[f64]) -> Vec<f64> {
    let mut values: Vec<f64> = Vec::new();
    for id in kernel.arena.ids() {
        let of = |value: &Value| value.factor.to_f64() * values[value.node.index()];
        let value = match kernel.arena.node(id) {
            Node::One => 1.0,
            Node::Input(number) => match number.checked_sub(inputs.len()) {
                Some(literal) => kernel.literals[literal].to_f64(),
                None => inputs[*number],
            },
            Node::Sum(terms) => terms.iter().map(of).sum(),
            Node::Product(a, b) => values[a.index()] * values[b.index()],
            Node::Quotient(a, b) => values[a.index()] / values[b.index()],
            Node::Function(function, arguments) => {
                let arguments: Vec<f64> = arguments.iter().map(of).collect();
                of_function(*function, &arguments)
            }
        };
        values.push(value);
    }
    let outputs = kernel.outputs.iter();
    outputs
        .map(|value| value.factor.to_f64() * values[value.node.index()])
        .collect()
}

fn of_function(function: Function, arguments: &[f64]) -> f64 {
    let x = arguments[0];
    let condition = |holds: bool| f64::from(u8::from(holds));
    match function {
        Function::SquareRoot => x.sqrt(),
        Function::Absolute => x.abs(),
        Function::Minimum => x.min(arguments[1]),
        Function::Maximum => x.max(arguments[1]),
        Function::Less => condition(x < arguments[1]),
        Function::LessOrEqual => condition(x <= arguments[1]),
        Function::Equal => condition(x == arguments[1]),
        Function::And => condition(x != 0.0 && arguments[1] != 0.0),
        Function::Or => condition(x != 0.0 || arguments[1] != 0.0),
        Function::Not => condition(x == 0.0),
        Function::Select => arguments[if x == 0.0 { 2 } else { 1 }],
        other => panic!("{other:?} is not in these programs"),
    }
}
