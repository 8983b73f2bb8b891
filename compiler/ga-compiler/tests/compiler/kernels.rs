//! Expressions through the whole compiler, with no macro involved.

use crate::algebras::cga3_tokens as cga3;
use ga_compiler::algebra::{Blade, Product};
use ga_compiler::lower::SandwichRule;
use ga_compiler::{Compiled, compile_function};
use proc_macro2::TokenStream;

fn compile(declaration: &TokenStream, function: &str) -> Compiled {
    let function = function.parse().expect("tokens");
    match compile_function(declaration.clone(), function) {
        Ok(compiled) => compiled,
        Err(error) => panic!("{error}"),
    }
}

#[test]
fn constants_and_derived_blades_are_folded() {
    // Of the difference of two points only e1, e2, e3 and ei are left.
    let difference = compile(&cga3(), "(p: Point, q: Point) -> RoundVector { p - q }").kernel;
    assert_eq!(
        difference
            .outputs
            .iter()
            .filter(|value| value.is_zero())
            .count(),
        1
    );
}

#[test]
fn unit_facts_are_needed_for_the_unit_rules() {
    // Without the fact, M X ~M scales, and the rules that use it must not apply.
    let scaled = compile(
        &cga3(),
        "(m: DualQuaternion, p: RoundVector) -> Multivector { sandwich(m, p) }",
    );
    assert!(
        [SandwichRule::LeftFirst, SandwichRule::RightFirst]
            .contains(&scaled.kernel.choices.all.sandwich)
    );
}

#[test]
fn errors_say_what_is_wrong() {
    let message = |function: &str| {
        let tokens = function.parse().expect("tokens");
        match compile_function(cga3(), tokens) {
            Ok(_) => panic!("{function} compiles"),
            Err(error) => error.to_string(),
        }
    };
    for (function, expected) in [
        ("(p: Point) -> Scalar { p | q }", "unknown name `q`"),
        (
            "(p: Point) -> Scalar { p.cross(p) }",
            "unknown operation `cross`",
        ),
        (
            "(p: Point) -> Scalar { p.wedge() }",
            "takes 2 operands, not 1",
        ),
        ("(p: Pont) -> Scalar { p | p }", "unknown type `Pont`"),
        (
            "(b: Bivector) -> EvenVersor { exp(b) }",
            "needs B² to be the sum of a scalar and a part that commutes and has square zero",
        ),
        (
            "(p: Point, q: Point) -> Line { p ^ q }",
            "left over: e12, e13, e23",
        ),
        ("(p: Point, q: Point) -> Point { p + q }", "eo is not 1"),
        (
            "(p: Point, q: Point) -> RoundVector { p + q ^ p }",
            "add parentheses",
        ),
        ("(p: Point) -> Point { p } extra", "unexpected token"),
    ] {
        let found = message(function);
        assert!(found.contains(expected), "{function}: {found}");
    }
}

#[test]
fn products_of_blades_are_those_of_the_textbook() {
    let Compiled { definition, .. } = compile(&cga3(), "(m: Motor) -> Motor { m }");
    let blade = |name: &str| {
        definition
            .algebra
            .names()
            .resolve(name)
            .expect("a blade")
            .blade
    };
    let product = |product: Product, a: &str, b: &str| -> String {
        let terms = product.of_blades(&definition.algebra, blade(a), blade(b));
        let name = |blade: Blade| definition.algebra.names().name(blade);
        terms
            .iter()
            .map(|(blade, factor)| format!("{factor} {} ", name(*blade)))
            .collect()
    };
    assert_eq!(product(Product::Geometric, "eo", "ei"), "-1 scalar 1 eoi ");
    assert_eq!(product(Product::Wedge, "e2", "e1"), "-1 e12 ");
    assert_eq!(product(Product::LeftContraction, "ei", "e1oi"), "1 e1i ");
    assert_eq!(product(Product::Vee, "e12oi", "e13oi"), "-1 e1oi ");
}
