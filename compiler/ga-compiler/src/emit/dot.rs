//! The graph as a picture: text for Graphviz.
//!
//! Inputs are boxes named `operand.blade`, outputs boxes named by the blades of the result; between
//! them are the operations, each once. An edge is labelled with the factor by which its value is
//! multiplied. What depends on uniform operands alone is framed.

use std::fmt::Write;

use super::formula;
use crate::algebra::Ratio;
use crate::define::Definition;
use crate::function::CompiledFunction;
use crate::ir::{Function, Node, NodeId, Value};
use crate::passes::Stages;

/// A function as a directed graph in the language of Graphviz.
#[must_use]
pub fn function(definition: &Definition, function: &CompiledFunction) -> String {
    let stages = function.kernel.stages();
    let name = match &function.name {
        Some(name) => name.to_string(),
        None => "closure".to_owned(),
    };
    let mut text = format!("digraph {} {{\n", quoted(&name));
    text.push_str(&attributes(&formula::headline(definition, function)));
    text.push_str(&nodes(definition, function, &stages));
    text.push_str(&edges(definition, function, &stages));
    text.push_str("}\n");
    text
}

/// How the graph looks, with its title.
fn attributes(title: &str) -> String {
    format!(
        "    label={};\n    labelloc=t;\n    rankdir=LR;\n    ranksep=0.6;\n    nodesep=0.12;\n    \
         fontname=\"Helvetica\";\n    node [fontname=\"Helvetica\", fontsize=12, height=0.3, margin=\"0.08,0.03\"];\n    \
         edge [fontname=\"Helvetica\", fontsize=10, arrowsize=0.5, color=\"#555555\"];\n",
        quoted(title.trim_end())
    )
}

/// Inputs and operations, those of the prologue in a frame of their own.
fn nodes(definition: &Definition, function: &CompiledFunction, stages: &Stages) -> String {
    let kernel = &function.kernel;
    let arena = &kernel.arena;
    let inputs = formula::all_inputs(definition, function);
    let (mut once, mut always) = (String::new(), String::new());
    let is_read =
        |id: NodeId| stages.inner.uses[id.index()] > 0 || stages.prologue.uses[id.index()] > 0;
    for id in arena.ids().filter(|&id| is_read(id)) {
        if let Node::Input(number) = arena.node(id) {
            let label = inputs.get(*number).map_or("?", |(name, _)| name.as_str());
            let is_uniform = kernel.uniform.get(*number).copied().unwrap_or(false);
            let part = if is_uniform { &mut once } else { &mut always };
            let _ = writeln!(
                part,
                "n{} [label={}, shape=box, style=filled, fillcolor=\"#dbe9f6\"];",
                id.index(),
                quoted(label)
            );
        }
    }
    let later = second_alone(stages);
    for (part, order) in [(&mut once, &stages.prologue.order), (&mut always, &later)] {
        for &id in order {
            let shape = match arena.node(id) {
                Node::Function(..) => "shape=ellipse, style=filled, fillcolor=\"#fdf1d5\"",
                Node::One
                | Node::Input(_)
                | Node::Sum(_)
                | Node::Product(..)
                | Node::Quotient(..) => "shape=circle, width=0.3, fixedsize=true",
            };
            let label = quoted(&operation(arena.node(id)));
            let _ = writeln!(part, "n{} [label={label}, {shape}];", id.index());
        }
    }
    let frame = if once.is_empty() {
        String::new()
    } else {
        format!(
            "    subgraph cluster_uniform {{\n        label=\"uniform\";\n        style=\"rounded,dashed\";\n{}    }}\n",
            indented(&once, 8)
        )
    };
    frame + &indented(&always, 4)
}

/// The nodes of the second stage alone: a condition that both stages compute is drawn once.
fn second_alone(stages: &Stages) -> Vec<NodeId> {
    let order = stages.inner.order.iter().copied();
    order
        .filter(|id| !stages.prologue.order.contains(id))
        .collect()
}

/// What each operation reads, and the outputs.
fn edges(definition: &Definition, function: &CompiledFunction, stages: &Stages) -> String {
    let kernel = &function.kernel;
    let mut edges = Edges {
        text: String::new(),
        constants: 0,
    };
    for &id in stages.prologue.order.iter().chain(&second_alone(stages)) {
        match kernel.arena.node(id) {
            Node::One | Node::Input(_) => {}
            Node::Function(function, values) => {
                for (place, &value) in values.iter().enumerate() {
                    edges.edge(value, id, role(*function, place));
                }
            }
            Node::Sum(values) => {
                for &value in values {
                    edges.edge(value, id, "");
                }
            }
            Node::Product(a, b) => {
                edges.edge(Value::of(*a), id, "");
                edges.edge(Value::of(*b), id, "");
            }
            Node::Quotient(a, b) => {
                edges.edge(Value::of(*a), id, "");
                edges.edge(Value::of(*b), id, "divisor");
            }
        }
    }
    let labels = formula::paths(definition, &function.result);
    for (place, (output, label)) in kernel.outputs.iter().zip(labels).enumerate() {
        let label = if label.is_empty() { "scalar" } else { &label };
        let _ = writeln!(
            edges.text,
            "out{place} [label={}, shape=box, style=filled, fillcolor=\"#d9f0d8\"];",
            quoted(label)
        );
        edges.edge_to(*output, &format!("out{place}"), "");
    }
    indented(&edges.text, 4)
}

/// The edges drawn so far.
struct Edges {
    text: String,
    /// How many constants have been drawn; each has a node where it is read.
    constants: usize,
}

impl Edges {
    fn edge(&mut self, from: Value, to: NodeId, role: &str) {
        self.edge_to(from, &format!("n{}", to.index()), role);
    }

    fn edge_to(&mut self, from: Value, to: &str, role: &str) {
        if let Some(constant) = from.as_constant() {
            let name = format!("c{}", self.constants);
            self.constants += 1;
            let _ = writeln!(
                self.text,
                "{name} [label=\"{constant}\", shape=plaintext];\n{name} -> {to}{};",
                labelled(role)
            );
            return;
        }
        let factor = match from.factor {
            Ratio::ONE => String::new(),
            factor if factor == Ratio::integer(-1) => "−".to_owned(),
            factor => format!("×{factor}").replace('-', "−"),
        };
        let parts = [role, &factor].into_iter().filter(|part| !part.is_empty());
        let label = parts.collect::<Vec<_>>().join(" ");
        let attributes = labelled(&label);
        let _ = writeln!(self.text, "n{} -> {to}{attributes};", from.node.index());
    }
}

/// The attributes of an edge.
fn labelled(label: &str) -> String {
    if label.is_empty() {
        return String::new();
    }
    format!(" [label={}]", quoted(label))
}

/// What an argument of a function is for, where that is not the same for all of them.
fn role(function: Function, place: usize) -> &'static str {
    match (function, place) {
        (Function::Select, 0) => "if",
        (Function::Select, 1) => "then",
        (Function::Select, _) => "else",
        (Function::Less | Function::LessOrEqual, 1) => "right",
        _ => "",
    }
}

/// What a node does.
fn operation(node: &Node) -> String {
    match node {
        Node::One => "1".to_owned(),
        Node::Input(_) => String::new(),
        Node::Sum(terms) if terms.len() == 1 => "=".to_owned(),
        Node::Sum(_) => "+".to_owned(),
        Node::Product(..) => "×".to_owned(),
        Node::Quotient(..) => "÷".to_owned(),
        Node::Function(Function::Absolute, _) => "|x|".to_owned(),
        Node::Function(function, _) => function.properties().symbol.to_owned(),
    }
}

fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}

fn indented(text: &str, width: usize) -> String {
    let line = |line: &str| format!("{:width$}{line}\n", "");
    text.lines().map(line).collect()
}
