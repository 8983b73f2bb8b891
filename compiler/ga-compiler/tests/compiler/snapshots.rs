//! The emitted Rust, WGSL and formulas of the kernels that `docs/engine.md` lists.
//!
//! Other tests check that emitted code is right; these files show in review how it changes.
//! `INSTA_UPDATE=always cargo test -p ga-compiler --test compiler snapshots` rewrites them.

use ga_compiler::emit::{formula, rust, wgsl};
use insta::Settings;
use quote::quote;

use crate::algebras::{cga3, compile};

/// Compares the emitted code of a function with the file of this name in `snapshots`.
fn check(name: &str, text: &str) {
    let cga3 = cga3();
    let function = [compile(&cga3, text)];
    let items = rust::functions(&cga3, &quote! { cga3 }, &function);
    let rust = without_comments(&prettyplease::unparse(&syn::parse2(items).expect("items")));
    let wgsl = without_comments(&wgsl::module(&cga3, &function));
    let formula = formula::function(&cga3, &function[0]);
    let mut settings = Settings::clone_current();
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, format!("{rust}\n{wgsl}\n{formula}")));
}

/// Doc comments may change although the code does not.
fn without_comments(code: &str) -> String {
    let lines = code.split_inclusive('\n');
    lines
        .filter(|line| !line.trim_start().starts_with("//"))
        .collect()
}

macro_rules! snapshots {
    ($($name:ident: $text:literal;)*) => {
        $(
            #[test]
            fn $name() {
                check(stringify!($name), $text);
            }
        )*
    };
}

snapshots! {
    motor_moves_point: "fn moved(m: Motor, p: Point) -> Point { m * p * rev(m) }";
    motor_moves_point_to_round_vector: "fn moved(m: Motor, p: Point) -> RoundVector { m * p * rev(m) }";
    motor_moves_sphere: "fn moved(m: Motor, s: Sphere) -> Sphere { sandwich(m, s) }";
    motor_moves_plane: "fn moved(m: Motor, e: Plane) -> Plane { sandwich(m, e) }";
    motor_moves_line: "fn moved(m: Motor, l: Line) -> Line { sandwich(m, l) }";
    motor_moves_circle: "fn moved(m: Motor, c: Circle) -> Circle { sandwich(m, c) }";
    motor_moves_point_pair: "fn moved(m: Motor, x: PointPair) -> PointPair { sandwich(m, x) }";
    circle_through_points: "fn circle(p: Point, q: Point, r: Point) -> Circle { p ^ q ^ r }";
    product_of_motors: "fn product(m: Motor, n: Motor) -> Motor { m * n }";
    inner_product_of_points: "fn inner(p: Point, q: Point) -> Scalar { p | q }";
    point_pair: "fn pair(p: Point, q: Point) -> PointPair { p ^ q }";
    sphere_through_points: "fn sphere(p: Point, q: Point, r: Point, s: Point) -> Sphere { p ^ q ^ r ^ s }";
    line_through_points: "fn line(p: Point, q: Point) -> Line { p ^ q ^ ei }";
    plane_through_points: "fn plane(p: Point, q: Point, r: Point) -> Plane { p ^ q ^ r ^ ei }";
    uniform_factor_read_in_each_call: "fn scaled(uniform s: Scalar, x: RoundVector) -> RoundVector { s * x }";
    uniform_motor_moves_point: "fn moving(uniform m: Motor, p: Point) -> Point { m * p * rev(m) }";
}
