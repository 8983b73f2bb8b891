//! `nullcone expand`: what it prints in each form, and the errors that it reports.

use std::io::Write;
use std::path::Path;
use std::process::{Output, Stdio};

use serde_json::{Value, json};
use tempfile::tempdir;

use crate::common::{assert_failure, assert_success, nullcone, program, text};

const MOVED: &str = "fn moved(m: Motor, p: Point) -> Point { m * p * rev(m) }";

/// What is printed for functions given as text.
#[track_caller]
fn expanded(functions: &str, options: &[&str]) -> String {
    let mut arguments = vec!["expand", "--expr", functions];
    arguments.extend(options);
    let output = nullcone(Path::new("."), arguments);
    assert_success(&output);
    // Long functions have warnings that the search was cut short.
    let mut lines = text(&output.stderr).lines();
    assert!(lines.all(|line| line.starts_with("warning: `f`: ")));
    text(&output.stdout).to_owned()
}

#[test]
fn a_warning_says_where_the_search_was_cut_short() {
    let sums: String = (1..=400)
        .map(|place| format!("let x{place} = b * x{} + a;", place - 1))
        .collect();
    let long = format!("fn f(a: Scalar, b: Scalar) -> Scalar {{ let x0 = a; {sums} x400 }}");
    for (function, is_noted) in [
        (long.as_str(), true),
        ("fn f(a: Scalar) -> Scalar { a * a }", false),
    ] {
        let output = nullcone(
            Path::new("."),
            ["expand", "--expr", function, "--emit", "ops"],
        );
        assert_success(&output);
        let note = "warning: `f`: too many steps to look for other forms of the function";
        assert_eq!(text(&output.stderr).contains(note), is_noted);
    }
}

/// Fails unless the program ended with status 1 and exactly these lines on standard error.
#[track_caller]
fn assert_lines(output: &Output, lines: &[&str]) {
    assert_eq!(output.status.code(), Some(1));
    assert!(output.stdout.is_empty());
    let found: Vec<_> = text(&output.stderr).lines().collect();
    assert_eq!(found, lines);
}

fn operations(mul: usize, add: usize, others: [usize; 3]) -> Value {
    let [div, sqrt, other] = others;
    json!({"mul": mul, "add": add, "div": div, "sqrt": sqrt, "other": other})
}

#[test]
fn operations_as_json() {
    let whole = |call: Value, uniform: Value| {
        let mut call = call;
        call["uniform"] = uniform;
        call
    };
    let none = || operations(0, 0, [0; 3]);
    let of = |functions| -> Value {
        let printed = expanded(functions, &["--emit", "ops", "--json"]);
        let mut printed: Value = serde_json::from_str(&printed).unwrap();
        let warnings = printed.as_object_mut().unwrap().remove("warnings");
        // Beside names of functions the key is there only where it says something.
        assert_eq!(warnings, printed.get("mul").map(|_| json!([])));
        printed
    };
    assert_eq!(of(MOVED), whole(operations(21, 18, [0; 3]), none()));
    // Keys come in the order in which they are documented.
    let printed = expanded(
        "fn f(t: Scalar) -> Scalar { sqrt(t) / t }",
        &["--emit", "ops", "--json"],
    );
    assert_eq!(
        printed.split_whitespace().collect::<String>(),
        "{\"mul\":0,\"add\":0,\"div\":1,\"sqrt\":1,\"other\":0,\
         \"uniform\":{\"mul\":0,\"add\":0,\"div\":0,\"sqrt\":0,\"other\":0},\"warnings\":[]}"
    );
    // One motor over many points is a matrix, computed once.
    let staged = of("fn f(uniform m: Motor, p: Point) -> Point { m * p * rev(m) }");
    assert_eq!((&staged["mul"], &staged["add"]), (&json!(9), &json!(9)));
    assert!(staged["uniform"]["mul"].as_u64().unwrap() > 0);
    // Several functions come under their names, in their order.
    let two = "fn b(s: Scalar, t: Scalar) -> Scalar { s * t } fn a(s: Scalar, t: Scalar) -> Scalar { s + t }";
    let expected = json!({
        "b": whole(operations(1, 0, [0; 3]), none()),
        "a": whole(operations(0, 1, [0; 3]), none()),
    });
    assert_eq!(of(two), expected);
    assert!(expanded(two, &["--emit", "ops", "--json"]).starts_with("{\n  \"b\":"));
    // The key of warnings cannot be that of a function as well.
    let taken = "fn warnings(s: Scalar) -> Scalar { s } fn a(s: Scalar) -> Scalar { s }";
    let arguments = ["expand", "--expr", taken, "--emit", "ops", "--json"];
    assert_failure(&nullcone(Path::new("."), arguments), &["`warnings`"]);
}

#[test]
fn code_as_json() {
    let printed = expanded(MOVED, &["--emit", "formula", "--json"]);
    let printed: Value = serde_json::from_str(&printed).unwrap();
    assert_eq!(printed["emit"], "formula");
    assert_eq!(printed["text"], expanded(MOVED, &["--emit", "formula"]));
}

#[test]
fn operations_for_people() {
    assert_eq!(
        expanded(MOVED, &["--emit", "ops"]),
        "moved: 21 mul, 18 add\n"
    );
    let staged = expanded(
        "fn f(uniform m: Motor, p: Point) -> Point { m * p * rev(m) }",
        &["--emit", "ops"],
    );
    assert!(
        staged.starts_with("f: 9 mul, 9 add\nf, once for its uniform operands: "),
        "{staged}"
    );
}

#[test]
fn rust_is_formatted_code_of_that_name() {
    let printed = expanded(MOVED, &[]);
    let file: syn::File = syn::parse_str(&printed).unwrap();
    let [syn::Item::Fn(function)] = &file.items[..] else {
        panic!("{printed}")
    };
    assert_eq!(function.sig.ident, "moved");
    assert!(
        printed.contains("m: ga_runtime::cga3::Motor<S>,\n"),
        "{printed}"
    );
    let closure = expanded(
        "|p: Point, q: Point| -> Scalar { p | q }",
        &["--emit", "rust"],
    );
    assert!(closure.contains("fn closure"), "{closure}");
}

#[test]
fn shaders() {
    let printed = expanded(MOVED, &["--emit", "wgsl"]);
    assert!(printed.contains("struct Point {\n    e1: f32,\n    e2: f32,\n    e3: f32,\n}\n"));
    assert!(printed.contains("\nfn moved(m: Motor, p: Point) -> Point {\n"));
}

#[test]
fn formulas() {
    assert_eq!(
        expanded(
            "fn f(p: Point, q: Point) -> Scalar { p | q }",
            &["--emit", "formula"]
        ),
        "f(p: Point, q: Point) -> Scalar\n\
         scalar: (2 p.e1 q.e1 - p.e1² + 2 p.e2 q.e2 - p.e2² + 2 p.e3 q.e3 - p.e3² - q.e1² - q.e2² - q.e3²) / 2\n"
    );
    let printed = expanded(MOVED, &["--emit", "formula"]);
    let labels: Vec<_> = printed
        .lines()
        .skip(1)
        .map(|line| line.split(':').next().unwrap())
        .collect();
    assert_eq!(labels, ["e1", "e2", "e3", "eo", "ei"]);
}

#[test]
fn graphs() {
    let printed = expanded(MOVED, &["--emit", "dot"]);
    assert!(printed.starts_with("digraph \"moved\" {\n") && printed.ends_with("}\n"));
    assert_eq!(printed.matches("label=\"m.e12\"").count(), 1);
    assert_eq!(printed.matches("label=\"×\"").count(), 18);
}

#[test]
fn functions_from_files_and_standard_input() {
    let folder = tempdir().unwrap();
    let run = |arguments: &[&str]| {
        let output = nullcone(folder.path(), [&["expand"], arguments].concat());
        assert_success(&output);
        text(&output.stdout).to_owned()
    };
    std::fs::write(folder.path().join("bare"), MOVED).unwrap();
    assert_eq!(run(&["bare", "--emit", "ops"]), "moved: 21 mul, 18 add\n");

    // A Rust file as it is: it has an algebra of its own and two calls of the macro, one of them
    // nested.
    let source = "
        use ga_runtime::{algebra, ga};
        algebra! {
            pub mod plane {
                basis e1, e2;
                signature 2, 0;
                struct Vector { e1, e2 }
                struct Bivector { e12 }
            }
        }
        ga! { plane; pub fn area(a: Vector, b: Vector) -> Bivector { a ^ b } }
        mod inner {
            ga_runtime::ga! { super::plane; fn square(a: Vector) -> Scalar { a | a } }
        }
        fn other() {}
    ";
    std::fs::write(folder.path().join("plane.rs"), source).unwrap();
    let both = "area: 2 mul, 1 add\nsquare: 2 mul, 1 add\n";
    assert_eq!(run(&["plane.rs", "--emit", "ops"]), both);
    // The same algebra for functions from elsewhere.
    let elsewhere = run(&[
        "--algebra",
        "plane.rs",
        "--expr",
        "fn f(a: Vector, b: Vector) -> Bivector { a ^ b }",
        "--emit",
        "formula",
    ]);
    assert_eq!(
        elsewhere,
        "f(a: Vector, b: Vector) -> Bivector\ne12: a.e1 b.e2 - a.e2 b.e1\n"
    );

    let mut child = program(folder.path())
        .args(["expand", "-", "--emit", "ops"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    child
        .stdin
        .take()
        .unwrap()
        .write_all(MOVED.as_bytes())
        .unwrap();
    let output = child.wait_with_output().unwrap();
    assert_success(&output);
    assert_eq!(text(&output.stdout), "moved: 21 mul, 18 add\n");
}

/// A file with blocks in modules that use functions of each other.
const BLOCKS: &str = "
    mod products {
        ga_runtime::ga! { ga_runtime::cga3;
            pub fn inner(p: Point, q: Point) -> Scalar { p | q }
            pub fn join(p: Point, q: Point) -> Line { twice(p, p ^ q ^ ei) }
            fn twice(p: Point, l: Line) -> Line { 2 * l }
        }
        pub mod squares {
            ga_runtime::ga! { ga_runtime::cga3;
                use super::inner as half;
                pub fn square(p: Point, q: Point) -> Scalar { -2 * half(p, q) }
            }
        }
    }
    ga_runtime::ga! { ga_runtime::cga3;
        use crate::any::products::{inner, squares::{square}, join as line};
        fn both(p: Point, q: Point) -> (Scalar, Line) { (square(p, q) + inner(p, q), line(p, q)) }
    }
";

#[test]
fn blocks_use_functions_of_other_blocks() {
    let all = expanded(BLOCKS, &["--emit", "formula"]);
    let written_out =
        "fn both(p: Point, q: Point) -> (Scalar, Line) { (-(p | q), 2 * (p ^ q ^ ei)) }";
    let both = expanded(written_out, &["--emit", "formula"]);
    assert!(all.ends_with(&both), "{all}\nends otherwise than\n{both}");

    for (change, with, parts) in [
        // Names that are not known, not used, or known twice.
        (
            "join as line",
            "joined",
            vec!["`joined` is not in a `ga!` block of this file", "16:62"],
        ),
        (
            "any::products::{inner",
            "any::sums::{inner",
            vec!["`inner` is not in"],
        ),
        (
            "line(p, q)",
            "twice(p, p ^ q ^ ei)",
            vec!["unknown operation `twice`"],
        ),
        (
            "fn both",
            "fn square",
            vec!["an earlier `ga!` block has a function `square`"],
        ),
        (
            "pub fn inner",
            "use squares::square; pub fn inner",
            vec!["use functions of each other in a circle"],
        ),
    ] {
        assert!(BLOCKS.contains(change));
        let changed = BLOCKS.replacen(change, with, 1);
        let output = nullcone(Path::new("."), ["expand", "--expr", &changed]);
        assert_eq!(output.status.code(), Some(1), "{with}");
        for part in parts {
            let message = text(&output.stderr);
            assert!(message.contains(part), "{message}");
        }
    }
}

#[test]
fn text_that_nests_too_deep_is_an_error() {
    let folder = tempdir().unwrap();
    let within = |open: &str, close: &str, count: usize| {
        let (open, close) = (open.repeat(count), close.repeat(count));
        format!("fn f(a: Scalar) -> Scalar {{ {open}a{close} }}")
    };
    for (functions, part) in [
        (within("(", ")", 129), "at most 128 levels deep"),
        (within("(", ")", 5_000), "at most 128 levels deep"),
        (within("(", ")", 100_000), "at most 128 levels deep"),
        (within("-", "", 20_000), "at most 128 levels deep"),
        (within("sqrt(", ")", 5_000), "at most 128 levels deep"),
        (
            within("", " + a", 20_000),
            "at most 1024 operators in a row",
        ),
    ] {
        std::fs::write(folder.path().join("deep.rs"), functions).unwrap();
        let output = nullcone(folder.path(), ["expand", "deep.rs"]);
        assert_eq!(output.status.code(), Some(1));
        let message = text(&output.stderr);
        assert!(
            message.starts_with("error: ") && message.contains(part),
            "{part}"
        );
    }
    for (functions, operations) in [
        (within("(", ")", 128), "f: 0 mul, 0 add\n"),
        (within("-", "", 128), "f: 0 mul, 0 add\n"),
        (within("1 + a * (", ")", 128), "f: 128 mul, 128 add\n"),
        (within("", " + a", 1024), "f: 1 mul, 0 add\n"),
    ] {
        assert_eq!(expanded(&functions, &["--emit", "ops"]), operations);
    }
}

#[test]
fn long_functions_are_written_in_parts() {
    // Each sum is read by the next one only, so that all would be one expression.
    let statements: String = (1..=2000)
        .map(|place| format!("let x{place} = b * x{} + a;", place - 1))
        .collect();
    let function =
        format!("fn f(a: Scalar, b: Scalar) -> Scalar {{ let x0 = a; {statements} x2000 }}");
    assert_eq!(
        expanded(&function, &["--emit", "ops"]),
        "f: 2000 mul, 2000 add\n"
    );
    for form in ["rust", "wgsl"] {
        let printed = expanded(&function, &["--emit", form]);
        let (mut depth, mut deepest) = (0, 0);
        for character in printed.chars() {
            match character {
                '(' => depth += 1,
                ')' => depth -= 1,
                _ => {}
            }
            deepest = deepest.max(depth);
        }
        assert!((32..=65).contains(&deepest), "{form}: {deepest}");
    }
}

#[test]
fn the_algebra_is_the_one_that_is_named() {
    let projective = "fn f(m: Motor, p: Plane) -> Plane { m * p * rev(m) }";
    let printed = expanded(projective, &["--algebra", "pga3", "--emit", "formula"]);
    assert!(printed.contains("\ne0: "), "{printed}");
    let named = expanded(
        &format!("ga! {{ ga_runtime::pga3; {projective} }}"),
        &["--emit", "formula"],
    );
    assert_eq!(named, printed);
}

#[test]
fn every_algebra_that_ships_is_known_by_name() {
    for (algebra, function) in [
        (
            "cga2",
            "fn f(m: Motor, p: Point) -> Point { m * p * rev(m) }",
        ),
        (
            "cga3",
            "fn f(m: Motor, p: Point) -> Point { m * p * rev(m) }",
        ),
        ("pga2", "fn f(p: Point, q: Point) -> Line { p & q }"),
        ("pga3", "fn f(p: Point, q: Point) -> Line { p & q }"),
        (
            "sta",
            "fn f(r: Rotor, x: Vector) -> Vector { r * x * rev(r) }",
        ),
        ("vga2", "fn f(a: Vector, b: Vector) -> Complex { a * b }"),
        (
            "vga3",
            "fn f(r: Rotor, x: Vector) -> Vector { r * x * rev(r) }",
        ),
    ] {
        let printed = expanded(function, &["--algebra", algebra, "--emit", "ops"]);
        assert!(printed.starts_with("f: "), "{algebra}: {printed}");
        let named = expanded(
            &format!("ga! {{ ga_runtime::{algebra}; {function} }}"),
            &["--emit", "ops"],
        );
        assert_eq!(named, printed);
    }
}

#[test]
fn an_unknown_algebra_is_an_error_that_lists_the_known_ones() {
    let folder = tempdir().unwrap();
    let arguments = ["expand", "--expr", MOVED, "--algebra", "pga4"];
    assert_lines(
        &nullcone(folder.path(), arguments),
        &[
            "error: --algebra pga4: this is neither one of cga2, cga3, pga2, pga3, sta, vga2, vga3 nor a file",
        ],
    );
}

#[test]
fn errors_show_the_line() {
    let folder = tempdir().unwrap();
    let source = "fn f(m: Motor,\n\tp: Pont) -> Point {\n    m * p * rev(m)\n}\n";
    std::fs::write(folder.path().join("f.txt"), source).unwrap();
    assert_lines(
        &nullcone(folder.path(), ["expand", "f.txt"]),
        &[
            "error: unknown type `Pont`; did you mean `Point`?",
            "  --> f.txt:2:5",
            "  |",
            "2 |     p: Pont) -> Point {",
            "  |        ^^^^",
        ],
    );
    let text_of = |functions| {
        let output = nullcone(folder.path(), ["expand", "--expr", functions]);
        assert_eq!(output.status.code(), Some(1));
        assert!(output.stdout.is_empty());
        text(&output.stderr).to_owned()
    };
    for (functions, parts) in [
        ("fn f(p: Point) -> Point { q }", ["`q`", "--expr:1:27"]),
        ("fn f(p: Point) -> Sphere { p }", ["Sphere", "--expr:1:"]),
        ("fn f(p: Point", ["not tokens of Rust", "--expr:1:5"]),
        ("fn f(p: Point) -> Point { p # }", ["expected", "--expr:1:"]),
        ("", ["no function here", "in --expr"]),
        ("ga! {}", ["path of an algebra and `;`", "--expr:1:5"]),
        (
            "ga! { cga3 fn f(p: Point) -> Point { p } }",
            ["path of an algebra and `;`", "--expr:1:7"],
        ),
        ("ga! { cga3; }", ["no function here", "--expr"]),
        ("hello", ["expected", "--expr:1:1"]),
    ] {
        let message = text_of(functions);
        assert!(message.starts_with("error: "), "{message}");
        for part in parts {
            assert!(message.contains(part), "{functions}: {message}");
        }
    }
    // The errors of all functions are reported.
    let two = text_of("fn f(p: A) -> A { p } fn g(p: B) -> B { p }");
    assert_eq!(two.matches("error: ").count(), 2, "{two}");
}

#[test]
fn unreadable_input_is_an_error_of_one_line() {
    let folder = tempdir().unwrap();
    std::fs::write(folder.path().join("empty.rs"), "").unwrap();
    for (arguments, parts) in [
        (vec!["expand", "nowhere.rs"], vec!["nowhere.rs"]),
        (
            vec!["expand", "--expr", MOVED, "--algebra", "cga9"],
            vec!["cga9"],
        ),
        (
            vec![
                "expand",
                "--expr",
                "ga! { other; fn f(p: Point) -> Point { p } }",
            ],
            vec!["other", "--algebra"],
        ),
    ] {
        assert_failure(&nullcone(folder.path(), arguments), &parts);
    }
    let broken = nullcone(
        folder.path(),
        ["expand", "--expr", MOVED, "--algebra", "empty.rs"],
    );
    assert_eq!(broken.status.code(), Some(1));
    assert!(text(&broken.stderr).contains("empty.rs"));
}
