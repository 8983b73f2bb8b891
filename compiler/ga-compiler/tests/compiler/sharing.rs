//! Values that are bound to names are computed once: no program costs more than its text read step
//! by step, with each operation as the declared product that it is.

use std::collections::HashMap;

use ga_compiler::define::{Definition, SCALAR_TYPE};
use ga_compiler::limit::SearchLimit;
use ga_compiler::{check, compile, parse};
use proc_macro2::TokenStream;
use quote::quote;

use crate::algebras;
use crate::random::Random;

/// An algebra with its products, from its declaration in ga-runtime.
fn declared(source: &str) -> Definition {
    let start = source.find("algebra! {").expect("the macro") + "algebra! {".len();
    let end = source.rfind('}').expect("the macro");
    let tokens: TokenStream = source[start..end].parse().expect("tokens");
    let syntax = parse::parse_declaration(tokens).expect("a declaration");
    check::check(syntax, quote! { ga_runtime }).expect("a definition")
}

/// A product of a definition, by the names of its types.
struct Product {
    name: &'static str,
    operands: Vec<String>,
    result: String,
}

fn products(definition: &Definition) -> Vec<Product> {
    let name = |index: usize| definition.types[index].name.to_string();
    let is_constant = |index: &usize| definition.types[*index].is_constant();
    let products = definition.products.iter();
    products
        .filter(|product| {
            !product
                .operands
                .iter()
                .chain(&product.result)
                .any(is_constant)
        })
        .map(|product| Product {
            name: product.operation.name(),
            operands: product.operands.iter().map(|&index| name(index)).collect(),
            result: product.result.map_or(SCALAR_TYPE.to_owned(), name),
        })
        .collect()
}

/// A step: the product, and the values that it reads.
struct Step<'p> {
    product: &'p Product,
    reads: Vec<usize>,
}

/// A program: the types of its operands, then its steps, the last of which is the result.
struct Program<'p> {
    operands: Vec<&'p str>,
    steps: Vec<Step<'p>>,
}

impl<'p> Program<'p> {
    /// A program in which most values are read more than once.
    fn random(products: &'p [Product], random: &mut Random, length: usize) -> Self {
        let first = &products[random.below(products.len())];
        let operands: Vec<&str> = first.operands.iter().map(String::as_str).collect();
        let mut types = operands.clone();
        let mut steps: Vec<Step<'p>> = Vec::new();
        while steps.len() < length {
            let last = types.len() - 1;
            let fits = |product: &&Product| {
                let mut read = product.operands.iter();
                read.all(|kind| types.contains(&kind.as_str()))
                    && (steps.is_empty() || product.operands.iter().any(|kind| kind == types[last]))
            };
            let fitting: Vec<&Product> = products.iter().filter(fits).collect();
            if fitting.is_empty() {
                break;
            }
            let product = fitting[random.below(fitting.len())];
            let mut is_used = steps.is_empty();
            let mut reads = Vec::new();
            for kind in &product.operands {
                let places: Vec<usize> = (0..types.len())
                    .filter(|&place| types[place] == kind)
                    .collect();
                let place = match types[last] == kind && !is_used {
                    true => last,
                    false => places[random.below(places.len())],
                };
                is_used |= place == last;
                reads.push(place);
            }
            types.push(&product.result);
            steps.push(Step { product, reads });
        }
        Self { operands, steps }
    }

    fn text(&self) -> String {
        let operands = self.operands.iter().enumerate();
        let operands: Vec<String> = operands
            .map(|(place, kind)| format!("v{place}: {kind}"))
            .collect();
        let mut text = String::new();
        let mut last = (0, "");
        for (number, step) in self.steps.iter().enumerate() {
            let place = self.operands.len() + number;
            last = (place, &step.product.result);
            text += &format!(
                "let v{place}: {} = {}({}); ",
                step.product.result,
                step.product.name,
                list(&step.reads)
            );
        }
        let operands = operands.join(", ");
        format!("fn f({operands}) -> {} {{ {text}v{} }}", last.1, last.0)
    }

    /// Each step as a function of its own; the same value twice is one operand.
    fn functions(&self) -> Vec<String> {
        let function = |step: &Step<'_>| {
            let mut operands: Vec<(usize, &str)> = Vec::new();
            for (place, kind) in step.reads.iter().zip(&step.product.operands) {
                if operands.iter().all(|(other, _)| other != place) {
                    operands.push((*place, kind));
                }
            }
            let position = |place: &usize| {
                let position = operands.iter().position(|(other, _)| other == place);
                position.expect("an operand")
            };
            let reads: Vec<usize> = step.reads.iter().map(position).collect();
            let operands = operands.iter().enumerate();
            let operands: Vec<String> = operands
                .map(|(place, (_, kind))| format!("v{place}: {kind}"))
                .collect();
            let (operands, reads) = (operands.join(", "), list(&reads));
            let Product { name, result, .. } = step.product;
            format!("fn f({operands}) -> {result} {{ {name}({reads}) }}")
        };
        self.steps.iter().map(function).collect()
    }
}

fn list(places: &[usize]) -> String {
    let names: Vec<String> = places.iter().map(|place| format!("v{place}")).collect();
    names.join(", ")
}

/// The operations of a function; none if it is refused.
fn cost(definition: &Definition, text: &str) -> Option<usize> {
    let functions = compile(definition, text.parse().expect("tokens")).ok()?;
    Some(functions[0].kernel.cost().total())
}

#[test]
fn no_program_costs_more_than_its_steps() {
    const ALGEBRAS: [&str; 6] = [
        include_str!("../../../../ga-runtime/src/algebras/cga3.rs"),
        include_str!("../../../../ga-runtime/src/algebras/cga2.rs"),
        include_str!("../../../../ga-runtime/src/algebras/pga3.rs"),
        include_str!("../../../../ga-runtime/src/algebras/pga2.rs"),
        include_str!("../../../../ga-runtime/src/algebras/vga3.rs"),
        include_str!("../../../../ga-runtime/src/algebras/sta.rs"),
    ];
    const PROGRAMS: usize = 60;
    let mut random = Random(7);
    let mut missed = String::new();
    for source in ALGEBRAS {
        let definition = declared(source);
        let products = products(&definition);
        let mut known: HashMap<String, Option<usize>> = HashMap::new();
        let mut compared = 0;
        for _ in 0..PROGRAMS {
            let length = 2 + random.below(7);
            let program = Program::random(&products, &mut random, length);
            let text = program.text();
            let Some(found) = cost(&definition, &text) else {
                continue;
            };
            let bound: Option<usize> = program
                .functions()
                .into_iter()
                .map(|function| {
                    let new = || cost(&definition, &function);
                    *known.entry(function.clone()).or_insert_with(new)
                })
                .sum();
            let Some(bound) = bound else { continue };
            compared += 1;
            if found > bound {
                missed += &format!("{}: {found} > {bound}: {text}\n", definition.name);
            }
        }
        assert!(compared > PROGRAMS / 2, "{}: {compared}", definition.name);
    }
    assert!(missed.is_empty(), "{missed}");
}

/// What is bound twice as often each time is computed once each time.
#[test]
fn squares_of_squares_are_computed_once() {
    let squares = |kind: &str, count: usize| {
        let lets: String = (1..=count)
            .map(|place| format!("let v{place} = v{} * v{}; ", place - 1, place - 1))
            .collect();
        format!("fn f(v0: {kind}) -> {kind} {{ {lets} v{count} }}")
    };
    let cga3 = algebras::cga3();
    for kind in ["Scalar", "Quaternion", "Rotor", "Motor"] {
        let once = cost(&cga3, &squares(kind, 1)).expect("a square");
        for count in [2, 8, 16, 64, 512] {
            let all = cost(&cga3, &squares(kind, count)).expect("squares");
            assert!(
                all <= count * once,
                "{kind}, {count}: {all} > {count} * {once}"
            );
        }
    }
}

/// Where a limit of the search leaves something out, the cost does not jump.
#[test]
fn long_functions_cost_in_proportion() {
    let cga3 = algebras::cga3();
    let all = |count: usize, term: &dyn Fn(usize) -> String, by: &str| {
        let terms: Vec<String> = (0..count).map(term).collect();
        terms.join(by)
    };
    let images = |n: usize| {
        let images = all(n, &|i| format!("sandwich(m, x[{i}])"), ", ");
        format!("fn f(m: Motor, x: [Point; {n}]) -> [Point; {n}] {{ [{images}] }}")
    };
    let wedges = |n: usize| {
        let wedges = all(n - 1, &|i| format!("(x[{i}] ^ x[{}])", i + 1), " + ");
        format!("fn f(x: [Point; {n}]) -> Bivector {{ {wedges} }}")
    };
    let inner = |n: usize| {
        let row = |i: usize| {
            all(
                n - 1 - i,
                &|j| format!("(x[{i}] | x[{}])", i + 1 + j),
                " + ",
            )
        };
        let rows = all(n - 1, &|i| format!("let s{i} = {};", row(i)), " ");
        let sum = all(n - 1, &|i| format!("s{i}"), " + ");
        format!("fn f(x: [Point; {n}]) -> Scalar {{ {rows} {sum} }}")
    };
    let kinds: [&dyn Fn(usize) -> String; 3] = [&images, &wedges, &inner];
    for write in kinds {
        let mut half = cost(&cga3, &write(8)).expect("eight");
        for n in [16, 32, 64] {
            let text = write(n);
            let found = cost(&cga3, &text).expect("twice as many");
            assert!(found <= 2 * half + 12, "{found}, {half} for half: {text}");
            half = found;
        }
    }
    let motors = all(8, &|i| format!("m[{i}]"), " * ");
    let nested = (0..8)
        .rev()
        .fold("x".to_owned(), |x, i| format!("sandwich(m[{i}], {x})"));
    for body in [format!("sandwich({motors}, x)"), nested] {
        let text = format!("fn f(m: [Motor; 8], x: Point) -> Point {{ {body} }}");
        assert_eq!(cost(&cga3, &text), Some(168 + 144), "{text}");
    }
    for (exponent, stated) in [(8, 41 + 12), (16, 55 + 16), (32, 68 + 20), (64, 81 + 24)] {
        let power = all(exponent, &|_| "m".to_owned(), " * ");
        let text = format!("fn f(m: Motor) -> Motor {{ {power} }}");
        assert_eq!(cost(&cga3, &text), Some(stated), "{text}");
    }
}

#[test]
fn limits_are_noted() {
    let cga3 = algebras::cga3();
    let long: String = (0..400)
        .map(|place| format!("let v{} = v{place} * w; ", place + 1))
        .collect();
    let long = format!("fn f(v0: Motor, w: Motor) -> Motor {{ {long} v400 }}");
    assert!(
        algebras::compile(&cga3, &long)
            .kernel
            .limits
            .contains(&SearchLimit::Steps)
    );
    let short = "fn f(v: Motor, w: Motor) -> Motor { v * w }";
    assert_eq!(algebras::compile(&cga3, short).kernel.limits, []);
}

#[test]
fn shared_products_cost_what_is_stated() {
    let cga3 = algebras::cga3();
    let chain: String = (2..22)
        .map(|place| format!("let v{place} = v{} * v{}; ", place - 1, place - 2))
        .collect();
    let stated = [
        (
            "(v0: Motor, v1: Motor) -> Motor { let c = v0 * v1; c * c * v0 }",
            110 + 84,
        ),
        (
            "(v0: Quaternion) -> Quaternion { let c = v0 * v0; let d = c * c; d * d }",
            24 + 9,
        ),
        (
            &format!("(v0: Motor, v1: Motor) -> Motor {{ {chain} v21 }}"),
            20 * (48 + 40),
        ),
    ];
    for (text, stated) in stated {
        let found = cost(&cga3, &format!("fn f{text}"));
        assert_eq!(found, Some(stated), "{text}");
    }
}
