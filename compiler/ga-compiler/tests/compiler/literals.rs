//! Numbers of any length in functions.

use ga_compiler::algebra::Ratio;
use ga_compiler::emit::{dot, formula, rust, wgsl};
use ga_compiler::ir::{Node, Value};
use ga_compiler::kernel::Kernel;
use quote::quote;

use crate::algebras::{cga3, compile};

/// Functions whose constants need more than 64 or 128 bits together.
const LONG: [&str; 6] = [
    "fn f(t: Scalar) -> Rotor { exp(0.12345678901234567 * t * e12) }",
    "fn f(t: Scalar, p: Point) -> Point { sandwich(exp(0.12345678901234567 * t * e1 * ei), p) }",
    "fn f(x: Scalar) -> Scalar {
        x * 1000000007 * 1000000009 * 1000000021 * 1000000033 * 1000000087
    }",
    "fn f(x: Scalar) -> Scalar { x * 3.14159265358979323846264338327950288419716939937510 }",
    "fn f(uniform m: Motor, p: Point) -> Point {
        sandwich(exp(0.7853981633974483096 * e12) * exp(0.12345678901234567 * e1 * ei) * m, p)
    }",
    "fn f(x: Scalar) -> Scalar { sin(2.718281828459045235360287 * x) + 1.0000000000000000001e-20 }",
];

#[test]
fn long_numbers_are_emitted_everywhere() {
    let cga3 = cga3();
    for text in LONG {
        let function = compile(&cga3, text);
        let code = rust::functions(&cga3, &quote!(algebra), std::slice::from_ref(&function));
        assert!(
            !code.to_string().contains("compile_error"),
            "{text}: {code}"
        );
        let shader = wgsl::module(&cga3, std::slice::from_ref(&function));
        assert!(shader.contains("fn f"), "{shader}");
        assert!(!formula::function(&cga3, &function).contains('?'), "{text}");
        assert!(!dot::function(&cga3, &function).contains("\"?\""), "{text}");
    }
}

/// Scalars of more than double precision get the number as it is written.
#[test]
fn fractions_of_64_bits_are_emitted_exactly() {
    let cga3 = cga3();
    let function = compile(
        &cga3,
        "fn f(x: Scalar) -> Scalar { 0.12345678901234567 * x }",
    );
    let code = rust::functions(&cga3, &quote!(algebra), std::slice::from_ref(&function));
    let code = code.to_string();
    let number = "from_ratio (12345678901234567i64 , 100000000000000000i64)";
    assert!(code.contains(number), "{code}");
}

#[test]
fn products_of_long_numbers_are_right() {
    let cga3 = cga3();
    let product = compile(&cga3, LONG[2]);
    let expected = 2.0
        * 1_000_000_007.0
        * 1_000_000_009.0
        * 1_000_000_021.0
        * 1_000_000_033.0
        * 1_000_000_087.0;
    let found = value(&product.kernel, 2.0);
    assert!((found / expected - 1.0).abs() < 1e-14, "{found}");
    let pi = compile(&cga3, LONG[3]);
    assert_eq!(value(&pi.kernel, 1.0), std::f64::consts::PI);
}

#[allow(clippy::cast_precision_loss)]
fn number(ratio: Ratio) -> f64 {
    let (mantissa, exponent) = ratio.nearest_double();
    mantissa as f64 * 2_f64.powi(exponent)
}

/// The output of a kernel of one input and one output, without functions.
fn value(kernel: &Kernel, input: f64) -> f64 {
    let mut inputs = vec![input];
    inputs.extend(kernel.literals.iter().copied().map(number));
    let mut values: Vec<f64> = Vec::new();
    let scaled = |values: &[f64], value: &Value| number(value.factor) * values[value.node.index()];
    for id in kernel.arena.ids() {
        values.push(match kernel.arena.node(id) {
            Node::One => 1.0,
            Node::Input(number) => inputs[*number],
            Node::Sum(terms) => terms.iter().map(|term| scaled(&values, term)).sum(),
            Node::Product(a, b) => values[a.index()] * values[b.index()],
            node => unreachable!("{node:?}"),
        });
    }
    scaled(&values, &kernel.outputs[0])
}
