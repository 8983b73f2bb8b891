//! Expressions through the whole compiler, with no macro involved.

use crate::algebras::cga3_tokens as cga3;
use ga_compiler::algebra::{Blade, Product};
use ga_compiler::expression::Expression;
use ga_compiler::kernel::{Kernel, wanted};
use ga_compiler::lower::{Choice, SandwichRule};
use ga_compiler::task::Task;
use ga_compiler::{Compiled, compile_function};
use proc_macro2::TokenStream;

/// The types of cga3 that are counted, under other names and in another order of the basis.
fn renamed() -> TokenStream {
    quote::quote! {
        pub mod conformal {
            basis infinity, x, y, z, origin;
            metric x*x = 1, y*y = 1, z*z = 1, infinity*origin = -1;
            #[hull(Weighted)] #[facts(null)]
            struct Place { x, y, z, origin = 1, infinity = (x*x + y*y + z*z)/2 }
            struct Weighted { infinity, z, origin, x, y }
            struct Flat { infinityxyz, infinityyxorigin, infinityxzorigin, infinityyzorigin }
            struct Ball { xyzorigin, infinityxyz, infinityxyorigin, infinityxzorigin, infinityyzorigin }
            struct Axis { infinityxy, infinityxz, infinityyz, infinityxorigin, infinityyorigin, infinityzorigin }
            struct Ring {
                xyz, xyorigin, xzorigin, yzorigin, infinityxy, infinityxz, infinityyz,
                infinityxorigin, infinityyorigin, infinityzorigin
            }
            struct Pair {
                xy, xz, yz, xorigin, yorigin, zorigin, infinityx, infinityy, infinityz, infinityorigin
            }
            struct Sum { zx, scalar, xy, yz, infinityxyz, infinityx, infinityy, infinityz }
            #[hull(Sum)] #[facts(unit_versor)]
            struct Motion { scalar, yx, xz, yz, infinityx, infinityy, infinityz, infinityxyz }
        }
    }
}

fn compile(declaration: &TokenStream, function: &str) -> Compiled {
    let function = function.parse().expect("tokens");
    match compile_function(declaration.clone(), function) {
        Ok(compiled) => compiled,
        Err(error) => panic!("{error}"),
    }
}

/// Most multiplications and additions of each kernel together: operands and result, the formula,
/// and the same types of the algebra under other names.
const COUNTS: [(&str, &str, &str, usize); 17] = [
    (
        "m: Motor, x: Point -> Point",
        "m: Motion, x: Place -> Place",
        "m * x * rev(m)",
        21 + 18,
    ),
    (
        "m: Motor, x: Point -> RoundVector",
        "m: Motion, x: Place -> Weighted",
        "m * x * rev(m)",
        25 + 20,
    ),
    (
        "m: Motor, x: RoundVector -> RoundVector",
        "m: Motion, x: Weighted -> Weighted",
        "sandwich(m, x)",
        37 + 28,
    ),
    (
        "m: Motor, x: Plane -> Plane",
        "m: Motion, x: Flat -> Flat",
        "sandwich(m, x)",
        29 + 21,
    ),
    (
        "m: Motor, x: Sphere -> Sphere",
        "m: Motion, x: Ball -> Ball",
        "sandwich(m, x)",
        37 + 28,
    ),
    (
        "m: Motor, x: Line -> Line",
        "m: Motion, x: Axis -> Axis",
        "sandwich(m, x)",
        49 + 38,
    ),
    (
        "m: Motor, x: Circle -> Circle",
        "m: Motion, x: Ring -> Ring",
        "sandwich(m, x)",
        72 + 60,
    ),
    (
        "m: Motor, x: PointPair -> PointPair",
        "m: Motion, x: Pair -> Pair",
        "sandwich(m, x)",
        72 + 60,
    ),
    (
        "m: Motor, x: Motor -> Motor",
        "m: Motion, x: Motion -> Motion",
        "m * x",
        48 + 40,
    ),
    (
        "m: Motor, n: Motor, x: Point -> Point",
        "m: Motion, n: Motion, x: Place -> Place",
        "m * n * x * rev(n) * rev(m)",
        42 + 36,
    ),
    (
        "p: Point, q: Point -> Scalar",
        "p: Place, q: Place -> Scalar",
        "p | q",
        4 + 5,
    ),
    (
        "p: Point, q: Point -> PointPair",
        "p: Place, q: Place -> Pair",
        "p ^ q",
        20 + 14,
    ),
    (
        "p: Point, q: Point, r: Point -> Circle",
        "p: Place, q: Place, r: Place -> Ring",
        "p ^ q ^ r",
        36 + 28,
    ),
    (
        "p: Point, q: Point, r: Point, s: Point -> Sphere",
        "p: Place, q: Place, r: Place, s: Place -> Ball",
        "p ^ q ^ r ^ s",
        44 + 37,
    ),
    (
        "p: Point, q: Point -> Line",
        "p: Place, q: Place -> Axis",
        "p ^ q ^ INFINITY",
        6 + 6,
    ),
    (
        "p: Point, q: Point, r: Point -> Plane",
        "p: Place, q: Place, r: Place -> Flat",
        "p ^ q ^ r ^ INFINITY",
        9 + 11,
    ),
    (
        "p: Point -> Scalar",
        "p: Place -> Scalar",
        "grade(p * p, 0)",
        0,
    ),
];

#[test]
fn kernels_cost_no_more_than_counted() {
    let (ours, theirs) = (cga3(), renamed());
    let mut missed = String::new();
    for (types, renamed, formula, most) in COUNTS {
        let cost = |declaration, types: &str, infinity| {
            let (operands, result) = types.split_once(" -> ").expect("a signature");
            let formula = formula.replace("INFINITY", infinity);
            let function = format!("({operands}) -> {result} {{ {formula} }}");
            compile(declaration, &function).kernel.cost()
        };
        let plain = cost(&ours, types, "ei");
        let found = plain.multiplications + plain.additions;
        // Rules look at facts and structure, never at names or at the order of the basis.
        let again = cost(&theirs, renamed, "infinity");
        let other = again.multiplications + again.additions;
        if found > most || other != found {
            missed.push_str(&format!(
                "{types} {{ {formula} }}: {found} and {other}, not {most}\n"
            ));
        }
    }
    assert!(missed.is_empty(), "{missed}");
}

#[test]
fn uniform_motors_are_linear_maps() {
    for (name, most) in [
        ("Point", 9 + 9),
        ("Direction", 9 + 6),
        ("Line", 24 + 18),
        ("Plane", 12 + 9),
    ] {
        let function = format!("(uniform m: Motor, x: {name}) -> {name} {{ m * x * rev(m) }}");
        let kernel = compile(&cga3(), &function).kernel;
        let each = kernel.cost().total() - kernel.prologue_cost().total();
        assert!(each <= most, "{name}: {each}");
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
    // Translators compose by adding: the products of their parts with ei vanish.
    let shift = compile(
        &cga3(),
        "(s: Translator, t: Translator) -> Translator { s * t }",
    )
    .kernel;
    assert_eq!(
        (shift.cost().multiplications, shift.cost().additions),
        (0, 3)
    );
}

#[test]
fn every_rule_keeps_the_meaning() {
    let Compiled { definition, .. } = compile(&cga3(), "(m: Motor) -> Motor { m }");
    let kind = |name| definition.type_named(name).expect("a type of cga3");
    let expression = Expression::sandwich(Expression::Operand(0), Expression::Operand(1));
    let operands = [
        "Point",
        "RoundVector",
        "PointPair",
        "Circle",
        "Line",
        "Sphere",
        "Plane",
        "Motor",
    ];
    for versor in ["Rotor", "Translator", "Motor", "Dilator", "Similarity"] {
        for operand in operands {
            if operand == "Motor" && ["Dilator", "Similarity"].contains(&versor) {
                continue;
            }
            // A scaling takes a point to a weighted one.
            let result = match (versor, operand) {
                ("Dilator" | "Similarity", "Point") => kind("RoundVector"),
                _ => kind(operand),
            };
            let types = [kind(versor), kind(operand)];
            for rule in SandwichRule::ALL {
                let blades = wanted(Some(result));
                let kernel = Task::of_expression(&definition.algebra, &types, &expression, blades)
                    .with_choices(Choice::from(rule))
                    .compile();
                for seed in 0..3 {
                    assert!(
                        kernel.agrees(&definition.algebra, &types, &expression, Some(result), seed),
                        "{rule:?} of {versor} on {operand}"
                    );
                }
            }
        }
    }
}

#[test]
fn a_wrong_graph_is_noticed() {
    let Compiled {
        definition,
        mut kernel,
    } = compile(&cga3(), "(m: Motor, p: Point) -> Point { sandwich(m, p) }");
    let types = ["Motor", "Point"].map(|name| definition.type_named(name).expect("declared"));
    let expression = Expression::sandwich(Expression::Operand(0), Expression::Operand(1));
    let agrees = |kernel: &Kernel| {
        kernel.agrees(&definition.algebra, &types, &expression, Some(types[1]), 0)
    };
    assert!(agrees(&kernel));
    kernel.outputs[2] = -kernel.outputs[2];
    assert!(!agrees(&kernel));
}

#[test]
fn unit_facts_are_needed_for_the_unit_rules() {
    // Without the fact, M X ~M scales, and the rules that use it must stand aside.
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
            "no operation `cross`",
        ),
        (
            "(p: Point) -> Scalar { p.wedge() }",
            "takes 2 operands, not 1",
        ),
        ("(p: Pont) -> Scalar { p | p }", "unknown type `Pont`"),
        (
            "(p: Point, q: Point) -> Line { p ^ q }",
            "left over: e12, e13, e23",
        ),
        ("(p: Point, q: Point) -> Point { p + q }", "eo is not 1"),
        (
            "(p: Point, q: Point) -> RoundVector { p + q ^ p }",
            "in parentheses",
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
