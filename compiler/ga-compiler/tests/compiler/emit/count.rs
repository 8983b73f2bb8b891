//! Counts of operations.

use ga_compiler::define::Definition;
use ga_compiler::emit::count::{self, Operations};
use ga_compiler::function::CompiledFunction;
use proc_macro2::TokenStream;
use proptest::prelude::*;

use super::{random, source};
use crate::algebras::cga3;

fn of(expression: &str) -> Operations {
    let tokens: TokenStream = expression.parse().expect("tokens");
    match count::expression(tokens) {
        Ok(found) => found,
        Err(error) => panic!("{expression}: {error}"),
    }
}

#[test]
fn each_construct_has_its_cost() {
    for (expression, expected) in [
        // Reads, names and constructors.
        ("x", [0, 0, 0, 0, 0]),
        ("self.e1", [0, 0, 0, 0, 0]),
        (
            "{ let t = a[0]; (t, [t, 1.5], Point { e1: t }) }",
            [0, 0, 0, 0, 0],
        ),
        ("<S as Ring>::from_integer(2i64)", [0, 0, 0, 0, 0]),
        ("<S as Field>::from_ratio(-1i64, 2i64)", [0, 0, 0, 0, 0]),
        ("S::zero()", [0, 0, 0, 0, 0]),
        // Arithmetic. A multiplication by a constant counts as one; a doubling by addition is an
        // addition.
        ("a * b + c", [1, 1, 0, 0, 0]),
        ("2.0 * (a - b)", [1, 1, 0, 0, 0]),
        ("a + a", [0, 1, 0, 0, 0]),
        ("<S as Field>::from_ratio(1, 2) * a", [1, 0, 0, 0, 0]),
        ("(a + b) / c", [0, 1, 1, 0, 0]),
        ("<S as Field>::recip(a * a)", [1, 0, 1, 0, 0]),
        // Fused, as a function and as a method.
        ("<S as Ring>::mul_add(a, b, c * d)", [2, 1, 0, 0, 0]),
        ("a.mul_add(b, -c)", [1, 1, 0, 0, 1]),
        // Negations, unless they are part of a number.
        ("-a", [0, 0, 0, 0, 1]),
        ("-(a - b) * -1.0", [1, 1, 0, 0, 1]),
        // Functions.
        ("<S as Real>::sqrt(a * a + b * b)", [2, 1, 0, 1, 0]),
        ("a.sqrt().sin_cos()", [0, 0, 0, 1, 1]),
        (
            "{ let (c, s, _) = versor_exponential(a * b); c * s }",
            [2, 0, 0, 0, 1],
        ),
        ("a.atan2(b) + a.abs()", [0, 1, 0, 0, 2]),
        // Conditions.
        ("S::select(S::less_than(a, b), a * b, c)", [1, 0, 0, 0, 2]),
        (
            "(S::less_or_equal(a, b) & !S::equals(a + c, b))",
            [0, 1, 0, 0, 4],
        ),
        ("S::min(a, b) * S::max(a, c)", [1, 0, 0, 0, 2]),
    ] {
        let found = of(expression);
        let found = [
            found.multiplications,
            found.additions,
            found.divisions,
            found.roots,
            found.others,
        ];
        assert_eq!(found, expected, "{expression}");
    }
}

#[test]
fn unknown_constructs_are_errors_that_name_them() {
    for (expression, part) in [
        ("if a < b { a } else { b }", "if a < b"),
        ("a % b", "`%`"),
        ("a << 1", "`<<`"),
        ("a ^ b", "`^`"),
        ("a.powi(2)", "`powi`"),
        ("f(a)", "`f`"),
        ("(|x| x)(a)", "| x | x"),
        ("vec![a]", "vec !"),
        ("{ a += b; a }", "`+=`"),
        ("loop { a }", "loop"),
        ("a[i]", "a [i]"),
        ("{ fn g() {} a }", "fn g"),
        ("{ let Some(x) = a else { return b }; x }", "let … else"),
        ("a.sqrt(b)", "`sqrt`"),
        ("Point { e1: a, ..b }", "Point"),
        ("a as f32", "as f32"),
    ] {
        let tokens: TokenStream = expression.parse().expect("tokens");
        let error = count::expression(tokens).expect_err(expression).to_string();
        assert!(error.contains("not counted: "), "{expression}: {error}");
        assert!(error.contains(part), "{expression}: {error}");
    }
}

#[test]
fn functions_and_methods_are_told_apart() {
    let code = "
        struct Prepared<S> { a: S }
        fn f<S>(x: S) -> S { x * x }
        impl<S: Ring> Prepared<S> { fn new(a: S) -> Self { Self { a: a + a } } }
    ";
    let found = count::functions(code.parse().expect("tokens")).expect("known constructs");
    let names: Vec<_> = found.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["f", "Prepared::new"]);
    assert_eq!((found[0].1.multiplications, found[1].1.additions), (1, 1));
    let hidden = "const X: f64 = 1.0 * 2.0;".parse().expect("tokens");
    assert!(count::functions(hidden).is_err());
}

/// Compares what is counted in the code of a function with the cost of its graph.
#[track_caller]
fn assert_counts_agree(definition: &Definition, function: &CompiledFunction) {
    let path = quote::quote! { ga_runtime::cga3 };
    let count = match count::function(definition, &path, function) {
        Ok(count) => count,
        Err(error) => panic!("{error}"),
    };
    let mut found = count.call;
    found += count.uniform;
    let cost = function.kernel.cost();
    assert_eq!(
        (
            found.multiplications,
            found.additions,
            found.divisions,
            found.roots
        ),
        (
            cost.multiplications,
            cost.additions,
            cost.divisions,
            cost.roots
        )
    );
    // The emitter reverses some differences that the cost counts as negated.
    assert!(found.others >= cost.functions);
    assert!(found.others <= cost.functions + cost.negations);
}

#[test]
fn counts_agree_with_the_cost() {
    let definition = cga3();
    proptest!(|(recipe in random::functions(false))| {
        assert_counts_agree(&definition, &recipe.build());
    });
}

#[test]
fn counts_agree_with_the_cost_of_kernels() {
    let definition = cga3();
    for function in source::kernels(&definition) {
        assert_counts_agree(&definition, &function);
    }
}
