//! Formulas to read: one expression for each blade of the result.
//!
//! Products stand side by side, powers are raised, coefficients of operands are written
//! `operand.blade`. The graph is multiplied out and its terms are collected, as far as the result
//! stays readable. What would grow too large and what is needed more than once get a name and a
//! line of their own before the blades.

mod expand;
mod polynomial;
mod print;

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use syn::ext::IdentExt;

use crate::define::{Definition, Parameter, Role, TypeDefinition};
use crate::function::CompiledFunction;
use crate::ir::{Arena, Node, NodeId, Value};
use crate::signature::{Operand, Shape};
use expand::Expander;
use polynomial::Polynomial;
use print::{Printer, bare};

/// A function as text: a line for the function, then one for each blade of its result, `e1: …`. The
/// blades of an array's elements are `[0].e1`, those of a tuple's `.0.e1`; a plain number is
/// `scalar`.
///
/// ```
/// use ga_compiler::emit::formula;
///
/// let declaration = quote::quote! {
///     pub mod vga2 {
///         basis e1, e2;
///         signature 2, 0;
///         struct Vector { e1, e2 }
///         struct Bivector { e12 }
///     }
/// };
/// let definition = ga_compiler::check_types(declaration, quote::quote! { ga_runtime })?;
/// let source = quote::quote! { fn area(a: Vector, b: Vector) -> Bivector { a ^ b } };
/// let functions = ga_compiler::compile(&definition, source)?;
/// assert_eq!(
///     formula::function(&definition, &functions[0]),
///     "area(a: Vector, b: Vector) -> Bivector\ne12: a.e1 b.e2 - a.e2 b.e1\n"
/// );
/// # Ok::<(), syn::Error>(())
/// ```
#[must_use]
pub fn function(definition: &Definition, function: &CompiledFunction) -> String {
    let inputs = all_inputs(definition, function);
    // Multiplied out if the lines stay short, otherwise with smaller and smaller parts.
    let mut best: Option<String> = None;
    for most_terms in MOST_TERMS {
        let text = with_terms(definition, function, &inputs, most_terms);
        if text
            .lines()
            .all(|line| line.chars().count() <= LONGEST_LINE)
        {
            return text;
        }
        if best.as_ref().is_none_or(|best| text.len() < best.len()) {
            best = Some(text);
        }
    }
    best.unwrap_or_default()
}

/// The greatest number of terms of an expression that is multiplied out, in the order of
/// preference.
const MOST_TERMS: [usize; 5] = [40, 24, 12, 6, 3];

/// The length in characters that a line should not exceed.
const LONGEST_LINE: usize = 300;

/// The text with a bounded number of terms where something was multiplied out.
fn with_terms(
    definition: &Definition,
    function: &CompiledFunction,
    inputs: &[(String, usize)],
    most_terms: usize,
) -> String {
    let kernel = &function.kernel;
    let mut printer = printer(&kernel.arena, inputs, most_terms);
    let outputs = bind(&mut printer, &kernel.outputs);

    let mut text = headline(definition, function);
    for (node, name) in printer.bound.clone() {
        let _ = writeln!(text, "{name} = {}", bare(&printer.definition(node)));
    }
    let mut outputs = outputs.iter();
    for (label, line) in lines(definition, &function.result) {
        let expression = match line {
            Line::Stored => outputs
                .next()
                .map_or_else(String::new, |output| printer.whole(output)),
            Line::Known(text) => text,
        };
        let _ = writeln!(text, "{label}: {expression}");
    }
    let explained = std::mem::take(&mut printer.explained);
    let explanations = explained.into_iter();
    for explanation in explanations.filter_map(|function| function.properties().explanation) {
        let _ = writeln!(text, "where {explanation}");
    }
    text
}

/// The text of one value of a graph whose inputs are the stored coefficients of the operands. It is
/// cut off where it is too long for a message.
#[must_use]
pub fn of_value(
    definition: &Definition,
    operands: &[Operand],
    arena: &Arena,
    value: Value,
) -> String {
    const LONGEST: usize = 240;
    let inputs = inputs(definition, operands);
    let mut printer = printer(arena, &inputs, MOST_TERMS[0]);
    // Parts that are read often are named: written out, they could become very long.
    let expanded = bind(&mut printer, &[value]);
    let mut text: String = expanded.iter().map(|one| printer.whole(one)).collect();
    for (node, name) in printer.bound.clone() {
        if text.len() < LONGEST {
            let _ = write!(text, ", where {name} = {}", bare(&printer.definition(node)));
        }
    }
    if text.chars().count() > LONGEST {
        text = text.chars().take(LONGEST).chain(" …".chars()).collect();
    }
    text
}

/// The names of the inputs of a graph, `operand.blade`, and for each the number of its operand.
#[must_use]
pub fn inputs(definition: &Definition, operands: &[Operand]) -> Vec<(String, usize)> {
    let mut names = Vec::new();
    for (number, operand) in operands.iter().enumerate() {
        let name = operand.name.unraw().to_string();
        for path in paths(definition, &operand.shape) {
            let separator = if path.is_empty() || path.starts_with(['.', '[']) {
                ""
            } else {
                "."
            };
            names.push((format!("{name}{separator}{path}"), number));
        }
    }
    names
}

/// The names of the inputs of a function's graph, numbers of the source among them.
pub(super) fn all_inputs(
    definition: &Definition,
    function: &CompiledFunction,
) -> Vec<(String, usize)> {
    let mut names = inputs(definition, &function.operands);
    let count = function.operands.len();
    let literals = function.kernel.literals.iter().enumerate();
    names.extend(literals.map(|(place, value)| (value.to_f64().to_string(), count + place)));
    names
}

/// The stored blades of a shape, with the path to each.
pub(super) fn paths(definition: &Definition, shape: &Shape) -> Vec<String> {
    match shape {
        Shape::Scalar => vec![String::new()],
        Shape::Type(index) => match &definition.types[*index].parameters {
            Some(parameters) => {
                let of = |parameter: &Parameter| {
                    let name = parameter.name.unraw().to_string();
                    let inner = paths(definition, &parameter.shape()).into_iter();
                    inner.map(move |path| behind(name.clone(), &path))
                };
                parameters.list.iter().flat_map(of).collect()
            }
            None => definition.types[*index]
                .stored()
                .map(|c| c.name.unraw().to_string())
                .collect(),
        },
        Shape::Array(element, count) => {
            let inner = paths(definition, element);
            let of_place = |place| {
                inner
                    .iter()
                    .map(move |path| behind(format!("[{place}]"), path))
            };
            (0..*count).flat_map(of_place).collect()
        }
        Shape::Tuple(parts) => parts
            .iter()
            .enumerate()
            .flat_map(|(place, part)| {
                let inner = paths(definition, part);
                inner
                    .into_iter()
                    .map(move |path| behind(format!(".{place}"), &path))
            })
            .collect(),
    }
}

/// The first line: `f(m: Motor, p: Point) -> Point`.
pub(super) fn headline(definition: &Definition, function: &CompiledFunction) -> String {
    let operands: Vec<_> = function
        .operands
        .iter()
        .map(|operand| {
            let uniform = if operand.is_uniform { "uniform " } else { "" };
            let kind = operand.shape.to_text(definition);
            format!("{uniform}{}: {kind}", operand.name)
        })
        .collect();
    let name = function.name.as_ref().map(ToString::to_string);
    format!(
        "{}({}) -> {}\n",
        name.unwrap_or_default(),
        operands.join(", "),
        function.result.to_text(definition)
    )
}

/// Where the text of a blade of the result comes from.
enum Line {
    /// The next output.
    Stored,
    /// The type.
    Known(String),
}

/// All blades of a result in order, stored or not.
fn lines(definition: &Definition, shape: &Shape) -> Vec<(String, Line)> {
    match shape {
        Shape::Scalar => vec![("scalar".to_owned(), Line::Stored)],
        Shape::Type(index) if definition.types[*index].parameters.is_some() => {
            let parameters = definition.types[*index].parameters.iter();
            let of = |parameter: &Parameter| match parameter.index {
                None => vec![(parameter.name.unraw().to_string(), Line::Stored)],
                Some(_) => {
                    let inner = lines(definition, &parameter.shape());
                    under(parameter.name.unraw().to_string(), inner).collect()
                }
            };
            parameters
                .flat_map(|p| p.list.iter().flat_map(of))
                .collect()
        }
        Shape::Type(index) => {
            let kind = &definition.types[*index];
            let blade = |place: usize| {
                let coefficient = &kind.coefficients[place];
                let line = match &coefficient.role {
                    Role::Stored => Line::Stored,
                    Role::Constant(value) => Line::Known(value.to_string()),
                    Role::Derived(polynomial) => Line::Known(derived(kind, polynomial)),
                };
                (coefficient.name.unraw().to_string(), line)
            };
            (0..kind.coefficients.len()).map(blade).collect()
        }
        Shape::Array(element, count) => (0..*count)
            .flat_map(|place| under(format!("[{place}]"), lines(definition, element)))
            .collect(),
        Shape::Tuple(parts) => parts
            .iter()
            .enumerate()
            .flat_map(|(place, part)| under(format!(".{place}"), lines(definition, part)))
            .collect(),
    }
}

fn under(path: String, lines: Vec<(String, Line)>) -> impl Iterator<Item = (String, Line)> {
    lines
        .into_iter()
        .map(move |(label, line)| (behind(path.clone(), &label), line))
}

fn behind(mut start: String, path: &str) -> String {
    if !path.is_empty() && !path.starts_with(['.', '[']) {
        start.push('.');
    }
    start.push_str(path);
    start
}

/// A derived blade in the blades of its own type.
fn derived(kind: &TypeDefinition, polynomial: &crate::define::Polynomial) -> String {
    let mut arena = Arena::default();
    let names: Vec<_> = kind
        .coefficients
        .iter()
        .map(|c| (c.name.unraw().to_string(), 0))
        .collect();
    let nodes: Vec<_> = names.iter().map(|_| arena.input()).collect();
    let value = polynomial.evaluate(
        &mut Polynomial::constant,
        &mut |index| Polynomial::variable(nodes[index].node),
        &mut |step, left, right| match step {
            crate::define::PolynomialStep::Sum => {
                let mut sum = left;
                sum.add_scaled(&right, crate::algebra::Ratio::ONE);
                sum
            }
            crate::define::PolynomialStep::Product => left.product(&right),
        },
    );
    printer(&arena, &names, MOST_TERMS[0]).whole(&value)
}

fn printer<'a>(arena: &'a Arena, inputs: &'a [(String, usize)], most_terms: usize) -> Printer<'a> {
    Printer {
        arena,
        expander: Expander::new(arena, most_terms),
        inputs,
        bound: BTreeMap::new(),
        explained: BTreeSet::new(),
    }
}

/// The values as polynomials in which parts that are read more than once have names.
fn bind(printer: &mut Printer<'_>, values: &[Value]) -> Vec<Polynomial> {
    let shared = |printer: &mut Printer<'_>, expanded: &[Polynomial]| -> BTreeSet<NodeId> {
        reads(printer, expanded)
            .into_iter()
            .filter(|&(_, count)| count > 1)
            .map(|(node, _)| node)
            .collect()
    };
    let expand = |printer: &mut Printer<'_>| -> Vec<Polynomial> {
        let values = values.iter();
        values.map(|&value| printer.expander.value(value)).collect()
    };
    let expanded = expand(printer);
    // A named part is written by its name everywhere, even where it is short enough to be
    // multiplied out.
    let parts = shared(printer, &expanded);
    printer.expander = printer.expander.with_parts(parts);
    let expanded = expand(printer);
    let shared = shared(printer, &expanded);
    let taken: Vec<_> = printer.inputs.iter().map(|(name, _)| name).collect();
    let names = (1..).map(|number| format!("t{number}"));
    let mut free = names.filter(|name| !taken.contains(&name));
    printer.bound = shared
        .into_iter()
        .filter_map(|node| Some((node, free.next()?)))
        .collect();
    expanded
}

/// How often each node but the inputs is read by some polynomials and by what they read.
fn reads(printer: &mut Printer<'_>, outputs: &[Polynomial]) -> BTreeMap<NodeId, usize> {
    let mut reads: BTreeMap<NodeId, usize> = BTreeMap::new();
    let mut open: Vec<NodeId> = outputs.iter().flat_map(Polynomial::variables).collect();
    while let Some(node) = open.pop() {
        if matches!(printer.arena.node(node), Node::Input(_)) {
            continue;
        }
        let count = reads.entry(node).or_insert(0);
        *count += 1;
        if *count > 1 {
            continue;
        }
        match printer.arena.node(node) {
            Node::Function(_, arguments) => {
                for &argument in arguments {
                    open.extend(printer.expander.value(argument).variables());
                }
            }
            Node::One | Node::Input(_) | Node::Sum(_) | Node::Product(..) | Node::Quotient(..) => {
                open.extend(printer.expander.node(node).variables())
            }
        }
    }
    reads
}
