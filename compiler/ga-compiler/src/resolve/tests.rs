//! What is said of functions that have no meaning, and how far calls may go.

use quote::quote;

use super::ResolveErrorKind;
use super::limits::{MAX_CALL_DEPTH, MAX_LEVELS};
use super::resolve;
use crate::parse::{Block, MAX_NESTING, parse_functions};
use crate::program::OperationError;

/// The messages about a block of functions of the plane.
fn messages(functions: &str) -> Vec<String> {
    let definition = crate::check_types(
        quote! { mod vga2 { basis e1, e2; signature 2; struct Vector { e1, e2 } } },
        quote! { ga_runtime },
    );
    let tokens = functions.parse().expect("tokens");
    match crate::compile(&definition.expect("sound"), tokens) {
        Ok(_) => Vec::new(),
        Err(errors) => errors.into_iter().map(|error| error.to_string()).collect(),
    }
}

/// The only message about a block.
#[track_caller]
fn message(functions: &str) -> String {
    match &messages(functions)[..] {
        [single] => single.clone(),
        several => panic!("not one message: {several:?}"),
    }
}

/// Functions that call each other one after the other, each inside the same formula.
fn chain(count: usize, open: &str, close: &str) -> String {
    let calling = (1..count).map(|number| {
        let (name, next) = (number - 1, number);
        format!("fn f{name}(a: Scalar) -> Scalar {{ {open}f{next}(a){close} }}\n")
    });
    let last = format!("fn f{}(a: Scalar) -> Scalar {{ a }}", count - 1);
    calling.chain([last]).collect()
}

/// Branches behind many comparisons count, although comparisons at random points hold only by
/// chance.
#[test]
fn every_branch_of_long_conditions_is_checked() {
    let numbers = "a: Scalar, b: Scalar, c: Scalar, d: Scalar, e: Scalar, v: Vector";
    let conjunction = "a < b && b < c && c < d && d < e && e < a && a < c && b < d && c < e";
    for body in [
        format!("select({conjunction}, 1 + v, v)"),
        format!("select(!({conjunction}), v, 1 + v)"),
        "select(a < b, select(b < c, select(c < d, select(d < e, select(e < a, \
         select(a < c, select(b < d, 1 + v, v), v), v), v), v), v), v)"
            .to_owned(),
    ] {
        let function = format!("fn f({numbers}) -> Vector {{ {body} }}");
        let found = message(&function);
        assert!(found.contains("Vector"), "{found}");
        let function = function.replace("1 + v", "2 * v");
        assert_eq!(messages(&function), Vec::<String>::new(), "{function}");
    }
    // What is never zero where it is used has a quotient.
    let function = "fn f(a: Scalar, b: Scalar, c: Scalar, d: Scalar) -> Scalar {
        1 / select(a < b && b < c && c < d, 0, 1 + a * a)
    }";
    assert_eq!(messages(function), Vec::<String>::new());
}

#[test]
fn a_recursion_is_one_error() {
    let never_ends =
        "; the body of a function takes the place of each call, which would never end here";
    for (functions, circle) in [
        ("fn f(a: Scalar) -> Scalar { f(a) }", "`f` calls itself"),
        (
            "fn f(a: Scalar) -> Scalar { g(a) } fn g(a: Scalar) -> Scalar { f(a) }",
            "`f` calls itself through `g`",
        ),
        (
            "fn k(a: Scalar) -> Scalar { g(a) } fn f(a: Scalar) -> Scalar { g(a) + 1 }
             fn g(a: Scalar) -> Scalar { 2 * h(a) } fn h(a: Scalar) -> Scalar { f(a) }",
            "`g` calls itself through `h` and `f`",
        ),
    ] {
        assert_eq!(message(functions), format!("{circle}{never_ends}"));
    }
    // Two circles are two errors.
    let two = "fn f(a: Scalar) -> Scalar { f(a) } fn g(a: Scalar) -> Scalar { g(a) }";
    assert_eq!(messages(two).len(), 2);
    // The same function may be called several times, one call in the operand of another.
    let twice = "fn f(a: Scalar) -> Scalar { g(g(a)) + g(a) } fn g(a: Scalar) -> Scalar { a * a }";
    assert_eq!(messages(twice), [""; 0]);
}

#[test]
fn a_long_chain_of_calls_is_not_a_recursion() {
    assert_eq!(messages(&chain(MAX_CALL_DEPTH + 1, "", "")), [""; 0]);
    // The first functions of a longer chain are all too deep, for one reason.
    let message = message(&chain(MAX_CALL_DEPTH + 9, "", ""));
    assert!(
        message.starts_with("the call of `f65` is more than 64 calls deep"),
        "{message}"
    );
}

#[test]
fn calls_and_formulas_are_bounded_together() {
    // Each formula is within the bound of formulas, and the calls within that of calls.
    let (open, close) = ("(a + (".repeat(50), "))".repeat(50));
    const { assert!(100 < MAX_NESTING && 100 * MAX_CALL_DEPTH > MAX_LEVELS) };
    let messages = messages(&chain(MAX_CALL_DEPTH, &open, &close));
    assert!(!messages.is_empty());
    for message in messages {
        assert!(message.contains("more than 512 levels"), "{message}");
    }
}

#[test]
fn many_formulas_one_after_the_other_are_not_deep() {
    let count = 2 * MAX_LEVELS;
    let lets: String = (1..=count)
        .map(|number| format!("let b{number} = b{} + a;\n", number - 1))
        .collect();
    let function = format!("fn f(a: Scalar) -> Scalar {{ let b0 = a; {lets} b{count} }}");
    assert_eq!(messages(&function), [""; 0]);
}

#[test]
fn both_values_of_a_choice_count() {
    for (function, text) in [
        (
            "fn f(x: Scalar, a: Vector) -> Vector { select(x < 1, a, a * a) }",
            "the result is not of type `Vector`: left over: scalar",
        ),
        (
            "fn f(x: Scalar, a: Vector) -> Vector { select(x < 1, a + 1, a) }",
            "the result is not of type `Vector`: left over: scalar",
        ),
        (
            "fn f(x: Scalar, y: Scalar, a: Vector) -> Vector {
                select(x < 1 && y < 1, a, select(x < 1 || y < 1, select(x == y, a, -a), 1 + a))
            }",
            "the result is not of type `Vector`: left over: scalar",
        ),
        (
            "fn f(x: Scalar, y: Scalar) -> Scalar {
                let z = min(x, y) - x;
                1 / select(x < y, z, z)
            }",
            "",
        ),
    ] {
        let found = messages(function).pop().unwrap_or_default();
        assert!(
            found.starts_with(text) && found.is_empty() == text.is_empty(),
            "{found}"
        );
    }
    let fits =
        "fn f(x: Scalar, a: Vector) -> Vector { select(x < 1 && x > 0 || !(x != 2), a, 2 * a) }";
    assert_eq!(messages(fits), [""; 0]);
}

#[test]
fn errors_say_what_was_found() {
    for (function, text) in [
        (
            "fn f(a: Vector, b: Vector) -> Scalar { select(a < b, 1, 0) }",
            "`<` compares scalars, but one of its sides has e1, e2; compare coefficients or norms",
        ),
        (
            "fn f(a: Scalar) -> Scalar { a > 0 }",
            "the result is a condition, but its type is `Scalar`",
        ),
        (
            "fn f(a: Scalar) -> Scalar { 2 * (a > 0) }",
            "this is a condition, where a multivector is needed; \
             `select(condition, 1, 0)` makes a number of it",
        ),
        (
            "fn f(a: Scalar) -> Scalar { select(a, 1, 0) }",
            "`select` takes a condition, such as `x < y`, but this is a value",
        ),
        (
            "fn f(a: Scalar) -> Scalar { select(a < 1 || 1, 1, 0) }",
            "`||` takes a condition, such as `x < y`, but this is a value",
        ),
        (
            "fn f(a: Scalar) -> Scalar { select(!a, 1, 0) }",
            "`!` takes a condition, such as `x < y`, but this is a value",
        ),
        (
            "fn f(a: Scalar) -> Scalar { select(a < 1, 1) }",
            "`select` takes 3 operands, not 2",
        ),
        (
            "fn f(a: Scalar) -> Scalar { let (b, c) = select(a < 1, (1, 2), 3); b + c }",
            "`select` chooses between two values of the same shape, \
             but these are 2 values and one value",
        ),
        (
            "fn f(a: Vector) -> Scalar { a }",
            "the result is not of type `Scalar`: left over: e1 = a.e1, e2 = a.e2; it fits `Vector`",
        ),
        (
            "fn f(a: Scalar) -> Vecto { a }",
            "unknown type `Vecto`; did you mean `Vector`?",
        ),
        (
            "fn f(angle: Scalar) -> Scalar { angl }",
            "unknown name `angl`: it is neither an operand, nor bound by `let`, nor a blade; did you mean `angle`?",
        ),
        (
            "fn f(a: Scalar) -> Scalar { sqr(a) }",
            "unknown operation `sqr`: neither the algebra nor this block has it; did you mean `sqrt`?",
        ),
        (
            "fn f(a: Vector) -> Scalar { a.x }",
            "`x` is not a blade of the algebra",
        ),
        (
            "fn f(a: Vector) -> Scalar { a.e12 }",
            "`a` does not have the blade e12; it has e1, e2",
        ),
        (
            "fn f(a: Vector) -> Vector { Vector }",
            "`Vector` is a type, not a value",
        ),
        (
            "fn f(a: (Scalar, Scalar)) -> Scalar { a + 1 }",
            "these are several values, where one is needed",
        ),
        (
            "fn f(a: Scalar) -> Scalar { a[0] }",
            "this is one value, which does not have elements",
        ),
        (
            "fn f(a: [Scalar; 3]) -> Scalar { a[3] }",
            "there are 3 elements, numbered from 0 to 2",
        ),
        (
            "fn f(a: [Scalar; 1]) -> Scalar { a[1] }",
            "there is 1 element, number 0",
        ),
        (
            "fn f(a: [Scalar; 2]) -> Scalar { let [b] = a; b }",
            "the pattern has 1 part, but this is 2 values",
        ),
        (
            "fn f(a: Scalar) -> [Scalar; 2] { a }",
            "the result is one value, but its type is `[Scalar; 2]`",
        ),
        (
            "fn f(a: Scalar, b: Vector) -> Vector { a / b }",
            "the divisor is not a scalar, it has e1, e2; `a * inverse(b)` divides by a blade or a versor",
        ),
        (
            "fn f(a: Vector) -> Vector { grade(a, 0.5) }",
            "the grade must be a whole number",
        ),
        (
            "fn f(a: Vector) -> Vector { grade(a) }",
            "`grade` takes 2 operands, not 1",
        ),
        (
            "fn f(a: Scalar) -> Scalar { a / (a - a) }",
            "the divisor is always zero",
        ),
        (
            "fn f(a: Scalar) -> Scalar { recip(a - a) }",
            "`recip`: the divisor is always zero",
        ),
        (
            "fn f(a: Vector) -> Scalar { sin(a) }",
            "`sin` takes a scalar, but this has e1, e2",
        ),
        (
            "fn f(a: Vector) -> Vector { exp(a) }",
            "`exp` takes a scalar or a bivector, but this has e1, e2",
        ),
        (
            "fn f(x: Scalar) -> Scalar { x^2 }",
            "`x ^ 2` is the outer product of two scalars, `x * 2`; \
             a power is written `pow(x, 2)` or `x * x`",
        ),
        (
            "fn f(a: Scalar, b: Scalar) -> Scalar { sqrt((a^2) + ((a + b)^-0.5)) }",
            "`a ^ 2` is the outer product of two scalars, `a * 2`; \
             a power is written `pow(a, 2)` or `a * a`",
        ),
        (
            "fn f(a: Scalar, b: Scalar) -> Scalar { (a + b)^(1/2) }",
            "`(a + b) ^ (1 / 2)` is the outer product of two scalars, `(a + b) * (1 / 2)`; \
             a power is written `pow(a + b, 1 / 2)`",
        ),
        (
            "fn f(a: Scalar, v: Vector) -> Scalar { a | (v | v) }",
            "`a | (v | v)` is the left contraction of two scalars, `a * (v | v)`; \
             write that if it is meant",
        ),
        (
            "fn f(a: Scalar, v: Vector) -> Scalar { right_contraction(a + 1, v | v) }",
            "`right_contraction(a + 1, v | v)` is the right contraction of two scalars, \
             `(a + 1) * (v | v)`; write that if it is meant",
        ),
        (
            "fn f(a: Scalar, b: Scalar) -> Scalar { a & b }",
            "`a & b` is the regressive product of two scalars, which is zero; \
             `a * b` multiplies them, and `a > 0 && b > 0` joins conditions",
        ),
        (
            "fn f(a: Scalar, b: Scalar) -> Scalar { pow(a, b) }",
            "the exponent must be a number as it is written, such as 3, -2, 1/2 or 0.5; \
             x to the power of a variable y is `exp(y * ln(x))`",
        ),
        (
            "fn f(a: Scalar) -> Scalar { pow(a, 1025) }",
            "`pow`: exponents lie between -1024 and 1024",
        ),
        (
            "fn f(v: Vector) -> Vector { pow(v, 1/2) }",
            "`pow` takes a scalar where its exponent is a fraction, but this has e1, e2; \
             a fraction t of a motion m is `exp(t * log(m))`",
        ),
        (
            "fn f(v: Vector) -> Vector { pow(1 + v, -2) }",
            "`pow` takes a blade or a versor, for which a ~a is a scalar; here it has \
             scalar, e1, e2; an operand that is always a blade can be marked with `blade` before \
             its name",
        ),
        (
            "fn f(a: [[Scalar; 1024]; 1024], b: Scalar) -> Scalar { b }",
            "the operands hold more than 16384 values together",
        ),
        (
            "fn f(a: [[[[Scalar; 1024]; 1024]; 1024]; 1024]) -> Scalar { 1 }",
            "the operands hold more than 16384 values together",
        ),
    ] {
        assert_eq!(message(function), text);
    }
}

#[test]
fn products_of_scalars_in_other_functions_are_theirs() {
    // The outer product has a meaning for the types of `outer`, whatever it is called with.
    let functions = "fn outer(m: (Scalar, Vector), n: (Scalar, Vector)) -> Scalar {
            grade((m.0 + m.1) ^ (n.0 + n.1), 0)
        }
        fn f(x: Scalar) -> Scalar { outer((x, 0 * e1), (2, 0 * e1)) }";
    assert_eq!(messages(functions), [""; 0]);
}

#[test]
fn values_that_are_copied_are_shared() {
    // Written out, the last name would hold 2⁶⁰ values.
    let pairs: String = (1..=60)
        .map(|number| format!("let p{number} = (p{}, p{});", number - 1, number - 1))
        .collect();
    let part = "[0]".repeat(60);
    let function = format!("fn f(p0: Scalar) -> Scalar {{ {pairs} p60{part} }}");
    assert_eq!(messages(&function), [""; 0]);
}

#[test]
fn errors_are_told_apart_by_kind() {
    let definition = crate::check_types(
        quote! { mod vga2 { basis e1, e2; signature 2; struct Vector { e1, e2 } } },
        quote! { ga_runtime },
    )
    .expect("sound");
    let function = quote! { fn f(a: Vector) -> Vector { recip(a) } };
    let function = &parse_functions(function).expect("a function")[0];
    let error = resolve(&definition, function, &Block::default()).err();
    let found = OperationError::NotScalar("e1, e2".to_owned());
    let expected = ResolveErrorKind::Operation("recip", found);
    assert_eq!(error.expect("faulty").kind(), &expected);
}
