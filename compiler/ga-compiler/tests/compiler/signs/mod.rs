//! Roots, absolute values, norms and choices mean what they do among the real numbers.

mod algebras;
mod graph;
mod interpreter;
mod program;

use std::panic::{AssertUnwindSafe, catch_unwind};

use algebras::{ALGEBRAS, Space};
use ga_compiler::compile;
use ga_compiler::function::CompiledFunction;
use interpreter::{Interpreter, Value};
use program::{Program, number, random};

/// How many random programs the suite compiles; `NULLCONE_RANDOM_PROGRAMS` asks for more.
const PROGRAMS: u64 = 400;

/// At how many points each is compared.
const POINTS: u64 = 8;

/// At how many points a program that is refused is evaluated, to see whether it has values.
const POINTS_OF_REFUSED: u64 = 64;

fn compiled(space: &Space, text: &str) -> Result<CompiledFunction, String> {
    let tokens = text.parse().expect("tokens");
    let functions = catch_unwind(AssertUnwindSafe(|| compile(&space.definition, tokens)));
    match functions {
        Ok(Ok(mut functions)) => Ok(functions.remove(0)),
        Ok(Err(error)) => Err(error.to_string()),
        Err(_) => Err("the compiler panics".to_owned()),
    }
}

/// What is wrong with a program, if something is.
fn fault(space: &Space, program: &Program) -> Option<String> {
    let text = program.text();
    let numbers = |seed: u64| {
        let mut random = random(seed);
        let numbers = (0..program.inputs(space)).map(|_| number(&mut random));
        numbers.collect::<Vec<f64>>()
    };
    let value = |seed: u64| Interpreter::new(space, &numbers(seed)).value(program);
    let function = match compiled(space, &text) {
        Ok(function) => function,
        Err(error) => {
            let values = (0..POINTS_OF_REFUSED).filter_map(value).count();
            return (values > 0).then(|| format!("refused, though it has values: {error}"));
        }
    };
    (0..POINTS).find_map(|seed| {
        let Value {
            numbers: expected,
            error,
        } = value(seed)?;
        let found = graph::outputs(&function.kernel, &numbers(seed));
        let differs =
            |(found, expected): (&f64, &f64)| found.is_nan() || (found - expected).abs() > error;
        let is_wrong = found.len() != expected.len() || found.iter().zip(&expected).any(differs);
        is_wrong.then(|| format!("{found:?} instead of {expected:?} at {:?}", numbers(seed)))
    })
}

#[test]
fn random_programs_with_signs_have_their_values() {
    let count = std::env::var("NULLCONE_RANDOM_PROGRAMS").ok();
    let count = count
        .and_then(|count| count.parse().ok())
        .unwrap_or(PROGRAMS);
    let spaces: Vec<Space> = ALGEBRAS.iter().map(Space::new).collect();
    let mut faults = Vec::new();
    let mut with_values = 0;
    for seed in 0..count {
        let space = &spaces[usize::try_from(seed).expect("small") % spaces.len()];
        let program = Program::random(&mut random(seed));
        if let Some(fault) = fault(space, &program) {
            faults.push(format!(
                "{seed}, {}: {}\n    {fault}",
                space.name,
                program.text()
            ));
        }
        let numbers = vec![0.75; program.inputs(space)];
        with_values += u64::from(Interpreter::new(space, &numbers).value(&program).is_some());
    }
    assert!(
        faults.is_empty(),
        "{} of {count}:\n{}",
        faults.len(),
        faults.join("\n")
    );
    assert!(
        with_values > count / 4,
        "{with_values} of {count} have values at one point"
    );
}

/// The values of functions of no operand.
#[test]
fn constants_have_their_signs() {
    let space = Space::new(&ALGEBRAS[1]);
    for (text, expected) in [
        ("abs(7) - 7", 0.0),
        ("abs(-7)", 7.0),
        ("sqrt(9)", 3.0),
        ("sqrt(4/9)", 2.0 / 3.0),
        ("sqrt(abs(-1))", 1.0),
        ("sqrt(sqrt(16)) + abs(3 - 5)", 4.0),
        ("2 * norm(2 * e1 + 2 * e2 + e3) - 6", 0.0),
        ("sqrt(2) * sqrt(8) - 4", 0.0),
        ("sqrt(89) * sqrt(89) - 89", 0.0),
        ("sqrt(7921) - 89", 0.0),
        ("sqrt(107 * 107) + 107", 214.0),
        ("max(2, 3) + min(-2, -3)", 0.0),
        ("select(2 < 3, 5, 7)", 5.0),
        ("sign(-107)", -1.0),
    ] {
        let function = format!("fn f() -> Scalar {{ {text} }}");
        let function =
            compiled(&space, &function).unwrap_or_else(|error| panic!("{text}: {error}"));
        let found = graph::outputs(&function.kernel, &[]);
        assert!((found[0] - expected).abs() < 1e-12, "{text}: {found:?}");
    }
}

/// Constant factors of what is under a root stand before it, and what is zero costs nothing.
#[test]
fn signs_that_are_certain_cost_nothing() {
    let space = Space::new(&ALGEBRAS[1]);
    for (text, most) in [
        ("fn f(v: Vector) -> Scalar { norm(3 * v) - 3 * norm(v) }", 0),
        ("fn f(v: Vector) -> Scalar { norm(-v) - norm(v) }", 0),
        ("fn f(x: Scalar) -> Scalar { abs(-3 * x) - 3 * abs(x) }", 0),
        (
            "fn f(x: Scalar, y: Scalar) -> Scalar { abs(x * y) - abs(y * x) }",
            0,
        ),
        // A root, its argument in three squares, and the division.
        (
            "fn f(v: Vector, w: Vector) -> Vector { w / (norm(3 * v) + 3 * norm(v)) }",
            11,
        ),
    ] {
        let function = compiled(&space, text).unwrap_or_else(|error| panic!("{text}: {error}"));
        let cost = function.kernel.cost();
        assert!(cost.total() <= most, "{text}: {cost:?}");
    }
}

/// Programs whose values exist though the roots of their arguments do not all exist modulo a prime.
#[test]
fn what_has_a_value_is_not_refused() {
    let space = Space::new(&ALGEBRAS[1]);
    let mut chain = String::from("v");
    for _ in 0..16 {
        chain = format!("normalize({chain} + e1)");
    }
    for text in [
        "fn f(x: Scalar) -> Scalar { sqrt(3 * x * x) }".to_owned(),
        "fn f(x: Scalar) -> Scalar { sqrt(7 * x * x) + sqrt(11 * x * x) }".to_owned(),
        "fn f(x: Scalar) -> Scalar { sqrt(137 * x * x) }".to_owned(),
        "fn f(x: Scalar) -> Scalar { norm(x * (e1 + e2 + e3)) }".to_owned(),
        "fn f(v: Vector, w: Vector) -> Vector { w / (norm(89 * v) + 89 * norm(v)) }".to_owned(),
        format!("fn f(v: Vector) -> Vector {{ {chain} }}"),
    ] {
        if let Err(error) = compiled(&space, &text) {
            panic!("{text}: {error}");
        }
    }
    for text in [
        "fn f(x: Scalar) -> Scalar { sqrt(-x * x) }",
        "fn f(x: Scalar) -> Scalar { 1 / (abs(x) - abs(-x)) }",
        "fn f(v: Vector) -> Scalar { 1 / (norm(3 * v) - 3 * norm(v)) }",
    ] {
        assert!(compiled(&space, text).is_err(), "{text} has no value");
    }
}
