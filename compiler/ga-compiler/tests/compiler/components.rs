//! Unit versors whose variety has several components, or whose blades are tied to each other.

use ga_compiler::define::Definition;
use ga_compiler::{check, compile, parse};
use proc_macro2::TokenStream;
use quote::quote;

fn check(declaration: TokenStream) -> syn::Result<Definition> {
    check::check(parse::parse_declaration(declaration)?, quote!(::ga_runtime))
}

fn sound(declaration: TokenStream) -> Definition {
    match check(declaration) {
        Ok(definition) => definition,
        Err(error) => panic!("{error}"),
    }
}

#[track_caller]
fn accepted(definition: &Definition, text: &str) {
    if let Err(error) = compile(definition, text.parse().expect("tokens")) {
        panic!("{text}: {error}");
    }
}

#[track_caller]
fn refused(definition: &Definition, text: &str, reason: &str) {
    let Err(error) = compile(definition, text.parse().expect("tokens")) else {
        panic!("{text} is accepted");
    };
    assert!(error.to_string().contains(reason), "{text}: {error}");
}

#[test]
fn translations_and_mirrors_have_either_sign() {
    let plane = sound(quote! {
        mod plane {
            basis e1, e2, e0;
            signature 2, 0, 1;
            /// 1 or −1, and any part beside it.
            #[hull(Even)] #[facts(unit_versor)] struct Translation { scalar, e10, e20 }
            #[hull(Even)] struct Normed { scalar = 1, e10, e20 }
            struct Even { scalar, e10, e20 }
            /// A mirror at right angles to the axis e1, which looks to either side.
            #[hull(Line)] #[facts(unit_versor)] struct Upright { e1, e0 }
            #[hull(Line)] struct Forward { e1 = 1, e0 }
            struct Line { e1, e0 }
        }
    });
    accepted(&plane, "fn f(t: Translation) -> Translation { t * t * t }");
    accepted(&plane, "fn f(t: Translation) -> Normed { t * t }");
    accepted(
        &plane,
        "fn f(t: Translation, u: Translation) -> Normed { t * u * u * t }",
    );
    refused(
        &plane,
        "fn f(t: Translation) -> Normed { t }",
        "scalar is not 1",
    );
    refused(
        &plane,
        "fn f(t: Translation, u: Translation) -> Normed { t * u }",
        "scalar is not 1",
    );
    accepted(
        &plane,
        "fn f(m: Upright, n: Upright) -> Upright { sandwich(m, n) }",
    );
    refused(&plane, "fn f(m: Upright) -> Forward { m }", "e1 is not 1");
}

#[test]
fn components_of_different_blades() {
    let space = sound(quote! {
        mod space {
            basis e1, e2, e3, e4;
            signature 4;
            /// `±1` and `±e1234`.
            #[hull(Sum)] #[facts(unit_versor)] struct Central { scalar, e1234 }
            struct Sum { scalar, e1234 }
            struct One { scalar = 1 }
            struct Volume { e1234 }
            /// Rotations by 180°.
            #[hull(Planes)] #[facts(unit_versor)] struct HalfTurn { e12, e13, e23 }
            struct Planes { e12, e13, e23 }
            struct Vector { e1, e2, e3, e4 }
        }
    });
    accepted(&space, "fn f(x: Central) -> One { x * x }");
    // Each holds on two of the four components.
    refused(
        &space,
        "fn f(x: Central) -> Scalar { x }",
        "left over: e1234",
    );
    refused(
        &space,
        "fn f(x: Central) -> Volume { x }",
        "left over: scalar",
    );
    accepted(&space, "fn f(h: HalfTurn) -> One { -h * h }");
    accepted(
        &space,
        "fn f(h: HalfTurn, v: Vector) -> Vector { h * v * rev(h) }",
    );
}

#[test]
fn a_component_that_is_not_known_is_refused() {
    // Besides the rotations there are the half-turns with a part e1234, which no product of
    // bivectors of the type reaches.
    let found = check(quote! {
        mod space {
            basis e1, e2, e3, e4;
            signature 4;
            #[hull(Sum)] #[facts(unit_versor)] struct Turn { scalar, e12, e13, e23, e1234 }
            struct Sum { scalar, e12, e13, e23, e1234 }
        }
    });
    let error = found.err().expect("two components").to_string();
    assert!(error.contains("do not form a family"), "{error}");
}

#[test]
fn motors_with_tied_blades() {
    let conformal = sound(quote! {
        mod conformal {
            basis e1, e2, e3, ep, em;
            signature 4, 1;
            #[hull(Round)] #[facts(null)]
            struct Point {
                e1, e2, e3,
                ep = (e1*e1 + e2*e2 + e3*e3 - 1)/2,
                em = (e1*e1 + e2*e2 + e3*e3 + 1)/2
            }
            struct Round { e1, e2, e3, ep, em }
            #[hull(Even)] #[facts(unit_versor)]
            struct Motor {
                scalar, e12, e13, e23, e1p, e2p, e3p, e123p,
                e1m = e1p, e2m = e2p, e3m = e3p, e123m = e123p
            }
            struct Even {
                scalar, e12, e13, e23, e1p, e2p, e3p, e123p, e1m, e2m, e3m, e123m
            }
            /// The mirror of a plane, of which ep and em are tied.
            #[hull(Round)] #[facts(unit_versor)] struct Mirror { e1, e2, e3, ep, em = ep }
        }
    });
    accepted(
        &conformal,
        "fn f(m: Motor, p: Point) -> Point { sandwich(m, p) }",
    );
    accepted(&conformal, "fn f(m: Motor, n: Motor) -> Motor { m * n }");
    accepted(&conformal, "fn f(m: Mirror, n: Mirror) -> Motor { m * n }");
    accepted(
        &conformal,
        "fn f(m: Mirror, p: Point) -> Point { sandwich(m, p) }",
    );
    refused(
        &conformal,
        "fn f(m: Even, p: Point) -> Point { sandwich(m, p) }",
        "not as derived",
    );
}

/// The parity of a versor is that of its value, whatever terms the graph has that cancel.
#[test]
fn parity_is_that_of_the_value() {
    let space = sound(quote! {
        mod space {
            basis e1, e2, e3;
            signature 3;
            struct Vector { e1, e2, e3 }
            #[hull(Vector)] #[facts(unit_versor)] struct Mirror { e1, e2, e3 }
            #[hull(Even)] #[facts(unit_versor)] struct Rotor { scalar, e12, e13, e23 }
            struct Even { scalar, e12, e13, e23 }
            struct One { scalar = 1 }
        }
    });
    // An odd versor with an even part that is zero by the facts of r, and the other way about. Each
    // difference from the plain meaning is zero.
    for difference in [
        "sandwich(n + (r * rev(r) - 1) * e12, v) + n * v * n",
        "sandwich(n + (n * n - 1) * r, r) - n * r * n",
        "sandwich(r + (r * rev(r) - 1) * n, v) - r * v * rev(r)",
        "(r + (r * rev(r) - 1) * n) * v * rev(r + (r * rev(r) - 1) * n) - sandwich(r, v)",
        // Of both parities: M X ~M. Zero is even.
        "sandwich(1 + v, 1) - (1 + v) * rev(1 + v)",
        "sandwich(1 + v, n) - (1 + v) * n * rev(1 + v)",
        "sandwich(n - n, v)",
        // Odd for some operands only: M X ~M for all.
        "sandwich(select(a < 0, n, r), v) - select(a < 0, n, r) * v * rev(select(a < 0, n, r))",
    ] {
        let operands = "a: Scalar, n: Mirror, r: Rotor, v: Vector";
        accepted(
            &space,
            &format!("fn f({operands}) -> One {{ 1 + ({difference}) }}"),
        );
        let other = format!("fn f({operands}) -> One {{ 1 + 2 * v * v + ({difference}) }}");
        refused(&space, &other, "scalar is not 1");
    }
    // The graph, whose terms show another parity, agrees.
    for versor in [
        "n + (r * rev(r) - 1) * e12",
        "n + (n * n - 1) * r",
        "r + (r * rev(r) - 1) * n",
        "select(a < 0, n, r)",
    ] {
        let function = format!(
            "fn f(a: Scalar, n: Mirror, r: Rotor, v: Vector) -> Vector {{ sandwich({versor}, v) }}"
        );
        accepted(&space, &function);
    }
}
