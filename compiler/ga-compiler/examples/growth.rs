//! How large a function of one kind and size is compiled to, and the peak of memory on Linux:
//! `cargo run --release -p ga-compiler --example growth -- KIND SIZE`. `benches/growth.sh` makes a
//! table of it.

use std::error::Error;
use std::fmt::Write as _;

use ga_compiler::{check_types, compile};

/// Writes a function of some size.
type Write = fn(usize) -> String;

const KINDS: [(&str, Write); 6] = [
    ("length", length),
    ("sharing", sharing),
    ("nesting", nesting),
    ("operands", operands),
    ("array", array),
    ("chain", chain),
];

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let (kind, size) = (arguments.next(), arguments.next());
    let found = KINDS.iter().find(|(name, _)| kind.as_deref() == Some(name));
    let (_, write) =
        found.ok_or("the kind is length, sharing, nesting, operands, array or chain")?;
    let size: usize = size.ok_or("a size is missing")?.parse()?;
    let source = include_str!("../../../ga-runtime/src/algebras/cga3.rs");
    let start = source.find("algebra! {").ok_or("no declaration")? + "algebra! {".len();
    let end = source.rfind('}').ok_or("no declaration")?;
    let definition = check_types(source[start..end].parse()?, quote::quote! { ga_runtime })?;
    let functions = compile(&definition, write(size).parse()?)?;
    let code = ga_compiler::emit::rust::functions(&definition, &quote::quote! { cga3 }, &functions);
    let kernel = &functions[0].kernel;
    println!("operations {}", kernel.cost().total());
    println!("characters {}", code.to_string().len());
    for limit in &kernel.limits {
        println!("note {}", limit.note());
    }
    if let Ok(status) = std::fs::read_to_string("/proc/self/status")
        && let Some(line) = status.lines().find(|line| line.starts_with("VmHWM"))
    {
        println!("{line}");
    }
    Ok(())
}

/// Each value is the product of the one before and an operand.
fn length(size: usize) -> String {
    let lets = lets(size, |text, place| {
        write!(text, "let x{} = x{place} * y;", place + 1)
    });
    format!("fn f(x0: Motor, y: Motor) -> Motor {{ {lets} x{size} }}")
}

/// Each value is the square of the one before.
fn sharing(size: usize) -> String {
    let lets = lets(size, |text, place| {
        write!(text, "let x{} = x{place} * x{place};", place + 1)
    });
    format!("fn f(x0: Motor) -> Motor {{ {lets} x{size} }}")
}

/// Motors that act one after the other.
fn nesting(size: usize) -> String {
    let lets = lets(size, |text, place| {
        write!(text, "let x{} = sandwich(m[{place}], x{place});", place + 1)
    });
    format!("fn f(m: [Motor; {size}], x0: Point) -> Point {{ {lets} x{size} }}")
}

/// A sum of as many operands.
fn operands(size: usize) -> String {
    let names: Vec<String> = (0..size).map(|place| format!("x{place}")).collect();
    let operands: Vec<String> = names.iter().map(|name| format!("{name}: Line")).collect();
    format!(
        "fn f({}) -> Line {{ {} }}",
        operands.join(", "),
        names.join(" + ")
    )
}

/// One motor on an array of points.
fn array(size: usize) -> String {
    let images: Vec<String> = (0..size)
        .map(|place| format!("sandwich(m, x[{place}])"))
        .collect();
    format!(
        "fn f(m: Motor, x: [Point; {size}]) -> [Point; {size}] {{ [{}] }}",
        images.join(", ")
    )
}

/// A product of motors, acting on a point.
fn chain(size: usize) -> String {
    let motors: Vec<String> = (0..size).map(|place| format!("m[{place}]")).collect();
    let motors = motors.join(" * ");
    format!("fn f(m: [Motor; {size}], x: Point) -> Point {{ sandwich({motors}, x) }}")
}

fn lets(size: usize, mut add: impl FnMut(&mut String, usize) -> std::fmt::Result) -> String {
    let mut text = String::new();
    for place in 0..size {
        // Writing to a string cannot fail.
        let _ = add(&mut text, place);
    }
    text
}
