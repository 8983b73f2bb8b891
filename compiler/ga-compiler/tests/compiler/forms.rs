//! The rules of forms: each is used somewhere, keeps the meaning, and is refused when broken.

use ga_compiler::forms::FormRule;
use ga_compiler::kernel::wanted;
use ga_compiler::lower::{Choice, Choices, Rule};
use ga_compiler::parse::{Block, parse_functions};
use ga_compiler::resolve::resolve;
use ga_compiler::task::Task;

use crate::algebras::cga3;

/// For each rule a function in which it applies.
const CASES: [(FormRule, &str); 18] = [
    (
        FormRule::Reversal,
        "fn f(a: Motor, b: Motor) -> Motor { rev(a * b) }",
    ),
    (
        FormRule::Associativity,
        "fn f(a: Motor, b: Motor, c: Motor) -> Motor { a * b * c }",
    ),
    (
        FormRule::Conjugation,
        "fn f(a: Motor, b: Motor, p: Point) -> Motor { a * b * rev(a) * b }",
    ),
    (
        FormRule::Composition,
        "fn f(a: Motor, b: Motor, p: Point) -> Point { sandwich(a * b, p) }",
    ),
    (
        FormRule::Outermorphism,
        "fn f(m: Motor, p: Point, q: Point) -> Bivector { sandwich(m, p) ^ sandwich(m, q) }",
    ),
    (
        FormRule::Linearity,
        "fn f(m: Motor, p: Point, q: Point) -> RoundVector { sandwich(m, p) + sandwich(m, q) }",
    ),
    (
        FormRule::InvariantPart,
        "fn f(a: Rotor, b: Rotor) -> Rotor { a * b * rev(a) }",
    ),
    (FormRule::Power, "fn f(m: Motor) -> Motor { m * m }"),
    (
        FormRule::Definition,
        "fn f(a: Line, b: Line) -> MotorGenerator { (a * b - b * a) / 2 }",
    ),
    (
        FormRule::Duality,
        "fn f(a: Quadvector, b: Quadvector) -> Trivector { undual(dual(a) ^ dual(b)) }",
    ),
    (
        FormRule::Quotient,
        "fn f(s: Scalar, a: RoundVector, b: RoundVector) -> Bivector { (a / s) ^ b }",
    ),
    (
        FormRule::Difference,
        "fn f(m: Motor, p: Point, q: Point) -> Bivector { sandwich(m, p ^ q) }",
    ),
    (
        FormRule::Vector,
        "fn f(p: Point, a: DualPlane) -> RoundVector { (p ^ a) * inverse(a) }",
    ),
    (
        FormRule::Adjoint,
        "fn f(m: Motor, p: Point, a: DualPlane) -> Scalar { p | sandwich(m, a) }",
    ),
    (
        FormRule::Distribution,
        "fn f(a: RoundVector, b: RoundVector, c: RoundVector) -> Bivector { (a ^ b) + (a ^ c) }",
    ),
    (
        FormRule::Frame,
        "fn f(a: Point, b: Point, c: Point) -> Point { point(a ^ b ^ c) }",
    ),
    (
        FormRule::Unnormalised,
        "fn f(m: Motor, n: Motor, t: Scalar, p: Point) -> Point {
            sandwich(normalize(m + t * n), p)
        }",
    ),
    (
        FormRule::ScalarFactor,
        "fn f(s: Scalar, a: RoundVector, b: RoundVector) -> Bivector { (s * a) ^ b }",
    ),
];

#[test]
fn every_rule_has_a_case() {
    for rule in FormRule::ALL {
        assert!(CASES.iter().any(|(other, _)| *other == rule), "{rule:?}");
    }
}

#[test]
fn every_rule_keeps_the_meaning_and_is_refused_when_broken() {
    let cga3 = cga3();
    for (rule, source) in CASES {
        let functions = parse_functions(source.parse().expect("tokens")).expect("a function");
        let block = Block {
            functions,
            imports: Vec::new(),
        };
        let resolved = resolve(&cga3, &block.functions[0], &block).expect("names have a meaning");
        let outputs: Vec<_> = resolved
            .outputs
            .iter()
            .map(|(step, kind)| (*step, wanted(*kind)))
            .collect();
        let program = &resolved.program;
        let compiled = |broken| {
            let choices = Choices {
                all: Choice {
                    broken,
                    ..Choice::default()
                },
                forms: vec![rule],
                ..Choices::default()
            };
            Task::of_program(&cga3.algebra, program, outputs.clone())
                .with_witness(&resolved.witness)
                .with_choices(choices)
                .compile()
        };
        let agrees = |broken| compiled(broken).agrees_with(program, &resolved.witness, &outputs);
        assert!(agrees(None), "{rule:?} in {source}");
        assert!(
            !agrees(Some(Rule::Form(rule))),
            "{rule:?} broken in {source}"
        );
    }
}
