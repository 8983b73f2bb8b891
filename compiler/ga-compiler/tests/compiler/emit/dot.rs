//! Graphs for Graphviz, read back from their text and evaluated over the prime field.

use std::collections::HashMap;

use ga_compiler::algebra::Ratio;
use ga_compiler::define::Definition;
use ga_compiler::emit::{dot, formula};
use ga_compiler::function::CompiledFunction;
use ga_compiler::ir::{Function, Residue};
use proptest::prelude::*;

use super::{random, source};
use crate::algebras::{cga3, compile};

/// A graph as read from its text.
#[derive(Default)]
struct Picture {
    labels: HashMap<String, String>,
    /// The source and label of each edge, by its target.
    edges: HashMap<String, Vec<(String, String)>>,
    /// The outputs in order.
    outputs: Vec<String>,
    /// The nodes in the cluster of uniform work.
    uniform: Vec<String>,
}

fn read(text: &str) -> Picture {
    let mut picture = Picture::default();
    let mut is_uniform = false;
    for line in text.lines().map(str::trim) {
        if line.starts_with("subgraph cluster_uniform") {
            is_uniform = true;
        }
        if line == "}" {
            is_uniform = false;
        }
        let label = line
            .split_once("label=\"")
            .and_then(|(_, rest)| rest.split_once('"'))
            .map_or(String::new(), |(label, _)| label.to_owned());
        let (name, rest) = line.split_once(' ').unwrap_or((line, ""));
        if let Some(to) = rest.strip_prefix("-> ") {
            let end = to.find([' ', ';']).expect("an end");
            let edges = picture.edges.entry(to[..end].to_owned()).or_default();
            edges.push((name.to_owned(), label));
        } else if rest.starts_with("[label=") {
            if name.starts_with("out") {
                picture.outputs.push(name.to_owned());
            }
            if is_uniform {
                picture.uniform.push(name.to_owned());
            }
            picture.labels.insert(name.to_owned(), label);
        }
    }
    picture
}

fn factor(label: &str) -> Residue {
    let mut words = label.split(' ');
    let last = words.next_back().unwrap_or_default();
    let number = last.replace('−', "-");
    match number.trim_start_matches('×') {
        "" | "divisor" | "if" | "then" | "else" | "right" => Residue::ONE,
        "-" => -Residue::ONE,
        number => {
            let (numerator, denominator) = number.split_once('/').unwrap_or((number, "1"));
            let part = |text: &str| text.parse().expect("a number");
            let ratio = Ratio::new(part(numerator), part(denominator));
            Residue::from_ratio(ratio.expect("a fraction"))
        }
    }
}

impl Picture {
    fn value(&self, node: &str, known: &mut HashMap<String, Residue>) -> Residue {
        if let Some(&value) = known.get(node) {
            return value;
        }
        let mut operands = Vec::new();
        for (from, label) in self.edges.get(node).into_iter().flatten() {
            operands.push(self.value(from, known) * factor(label));
        }
        let sum = |operands: &[Residue]| operands.iter().fold(Residue::ZERO, |sum, &x| sum + x);
        let value = match self.labels[node].as_str() {
            "=" if self.edges[node].len() > 1 => {
                Function::Equal.evaluate(&operands).expect("total")
            }
            "+" | "=" => sum(&operands),
            "×" => operands[0] * operands[1],
            "÷" => {
                let edges = &self.edges[node];
                assert_eq!(edges[1].1, "divisor");
                operands[0] * operands[1].recip()
            }
            "nonzero" => operands[0],
            "recip_or_zero" => operands[0].recip(),
            "√" => Function::SquareRoot
                .evaluate(&operands)
                .unwrap_or(Residue::ZERO),
            "<" => Function::Less.evaluate(&operands).expect("total"),
            "≤" => Function::LessOrEqual.evaluate(&operands).expect("total"),
            "and" => operands[0] * operands[1],
            "or" => Function::Or.evaluate(&operands).expect("total"),
            "not" => Residue::ONE - operands[0],
            "min" => Function::Minimum.evaluate(&operands).expect("total"),
            "max" => Function::Maximum.evaluate(&operands).expect("total"),
            "select" => {
                let roles = self.edges[node].iter().map(|(_, label)| label.as_str());
                for (role, expected) in roles.zip(["if", "then", "else"]) {
                    assert!(role.starts_with(expected), "{role}");
                }
                Function::Select.evaluate(&operands).expect("total")
            }
            "atan2" => Function::ArcTangent.evaluate(&operands).expect("total"),
            _ if node.starts_with("out") => sum(&operands),
            constant => factor(constant),
        };
        known.insert(node.to_owned(), value);
        value
    }
}

#[track_caller]
fn assert_picture_agrees(definition: &Definition, function: &CompiledFunction) {
    let text = dot::function(definition, function);
    let picture = read(&text);
    let Some(inputs) = random::inputs(function, 4) else {
        return;
    };
    let names = formula::inputs(definition, &function.operands);
    let values: HashMap<_, _> = names.iter().map(|(name, _)| name).zip(&inputs).collect();
    let mut known = HashMap::new();
    for (node, label) in &picture.labels {
        if let Some(&&value) = values.get(label).filter(|_| node.starts_with('n')) {
            known.insert(node.clone(), value);
        }
    }
    // The cluster holds the nodes that depend on uniform operands alone.
    for node in &picture.uniform {
        for (from, _) in picture.edges.get(node).into_iter().flatten() {
            assert!(
                picture.uniform.contains(from) || from.starts_with('c'),
                "{text}"
            );
        }
    }
    let found: Vec<_> = picture
        .outputs
        .iter()
        .map(|output| picture.value(output, &mut known))
        .collect();
    assert_eq!(found, function.kernel.evaluate(&inputs), "{text}");
}

#[test]
fn pictures_mean_what_the_graph_does() {
    let definition = cga3();
    proptest!(|(recipe in random::functions(false))| {
        assert_picture_agrees(&definition, &recipe.build());
    });
}

#[test]
fn pictures_of_two_stages_mean_what_the_graph_does() {
    let definition = cga3();
    proptest!(|(recipe in random::functions(true))| {
        assert_picture_agrees(&definition, &recipe.build());
    });
}

#[test]
fn pictures_of_kernels_mean_what_the_graph_does() {
    let definition = cga3();
    for function in source::kernels(&definition) {
        assert_picture_agrees(&definition, &function);
    }
    // A condition that both stages compute is drawn once.
    let both = "fn both(uniform a: Scalar, uniform b: Scalar, x: Scalar) -> Scalar {
        select(a < b, x, select(a < b, a, b) * x)
    }";
    let both = compile(&definition, both);
    assert_picture_agrees(&definition, &both);
    let picture = dot::function(&definition, &both);
    assert_eq!(picture.matches("label=\"<\"").count(), 1, "{picture}");
    let once = compile(
        &definition,
        "fn once(uniform m: Motor, p: Point) -> Point { sandwich(m, p) }",
    );
    assert!(!read(&dot::function(&definition, &once)).uniform.is_empty());
}
