//! WGSL: functions for shaders, in single precision.
//!
//! A type of the algebra becomes a structure with a member of type `f32` for each stored blade, so
//! that an array of them in a buffer has the layout of the same array in Rust. A plain number is
//! `f32`, arrays are arrays, and a tuple is a structure with the members `value0`, `value1`, ….
//! What stores nothing has one member, `nothing`, since structures of WGSL cannot be empty.
//!
//! A function `f` with uniform operands becomes two: `f_prepare` takes those operands and gives an
//! `FPrepared`, which `f` takes before its other operands.
//!
//! Names that have a meaning in WGSL end in an underscore.

mod body;

mod names;
mod scalar_functions;
mod shapes;

use std::collections::{BTreeSet, HashMap};
use std::fmt::Write;

use heck::ToUpperCamelCase;
use syn::ext::IdentExt;

use crate::define::Definition;
use crate::function::CompiledFunction;
use crate::ir::{Function, Node, NodeId, Value};
use crate::passes::Stage;
use crate::signature::Operand;
use body::{Body, constant};
use names::Names;
use shapes::{Shapes, call, comment};

/// The functions with everything that they need, as a part of a WGSL module.
///
/// ```
/// use ga_compiler::emit::wgsl;
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
/// let text = wgsl::module(&definition, &functions);
/// assert!(text.contains("fn area(a: Vector, b: Vector) -> Bivector {"));
/// assert!(text.contains("return Bivector(a.e1 * b.e2 - a.e2 * b.e1);"));
/// # Ok::<(), syn::Error>(())
/// ```
#[must_use]
pub fn module(definition: &Definition, functions: &[CompiledFunction]) -> String {
    let mut writer = Writer {
        names: Names::default(),
        shapes: Shapes::new(definition),
        called: BTreeSet::new(),
        own: HashMap::new(),
    };
    for function in functions {
        for operand in &function.operands {
            writer.shapes.name(&operand.shape, &mut writer.names);
        }
        writer.shapes.name(&function.result, &mut writer.names);
    }
    for &function in Function::ALL {
        if scalar_functions::is_own(function) {
            let name = writer.names.give(function.properties().wgsl);
            writer.own.insert(function, name);
        }
    }
    let texts: Vec<_> = functions
        .iter()
        .map(|function| writer.function(function))
        .collect();
    let mut parts = vec![writer.shapes.declarations(), writer.own_functions()];
    parts.extend(texts);
    parts.concat().trim_end().to_owned() + "\n"
}

struct Writer<'a> {
    /// The names of the module.
    names: Names,
    shapes: Shapes<'a>,
    /// The functions of scalars that are called.
    called: BTreeSet<Function>,
    /// The names of those of our own.
    own: HashMap<Function, String>,
}

/// A stage as text.
struct Written {
    statements: String,
    values: Vec<String>,
}

impl Writer<'_> {
    fn function(&mut self, function: &CompiledFunction) -> String {
        let wished = match &function.name {
            Some(name) => name.unraw().to_string(),
            None => "closure".to_owned(),
        };
        let name = self.names.give(&wished);
        let is_staged = function.operands.iter().any(|operand| operand.is_uniform);
        let prepare_names = is_staged.then(|| {
            let structure = self
                .names
                .give(&format!("{}Prepared", wished.to_upper_camel_case()));
            (self.names.give(&format!("{wished}_prepare")), structure)
        });
        let mut scope = self.names.clone();
        let prepared = prepare_names.is_some().then(|| scope.give("prepared"));
        let parameters: Vec<_> = function
            .operands
            .iter()
            .map(|operand| scope.give(&operand.name.unraw().to_string()))
            .collect();
        let mut inputs = self.inputs(&function.operands, &parameters);
        let literals = function.kernel.literals.iter();
        inputs.extend(literals.map(|&value| constant(value)));
        let stages = function.kernel.stages();

        let mut text = String::new();
        let mut known: HashMap<NodeId, String> = HashMap::new();
        let arena = &function.kernel.arena;
        for id in arena.ids() {
            if let Node::Input(number) = arena.node(id) {
                known.insert(id, inputs.get(*number).cloned().unwrap_or_default());
            }
        }
        let result = self.shapes.name(&function.result, &mut self.names);
        if let (Some((prepare, structure)), Some(prepared)) = (&prepare_names, &prepared) {
            let wanted: Vec<_> = stages.handed.iter().map(|&node| Value::of(node)).collect();
            let written = self.stage(function, &stages.prologue, &wanted, &known, &scope);
            let members = member_names(function, &stages.handed, &inputs);
            text.push_str(&prepared_structure(function, structure, &members));
            let operands = self.parameters(&function.operands, &parameters, true);
            let built = call(structure, &non_empty(written.values, "0.0"));
            let body = returning(&written.statements, &built);
            let _ = write!(
                text,
                "fn {prepare}({operands}) -> {structure} {{\n{body}}}\n\n"
            );
            for (id, member) in stages.handed.iter().zip(&members) {
                known.insert(*id, format!("{prepared}.{member}"));
            }
        }
        let outputs = &function.kernel.outputs;
        let written = self.stage(function, &stages.inner, outputs, &known, &scope);
        let mut operands = self.parameters(&function.operands, &parameters, false);
        if let (Some((_, structure)), Some(prepared)) = (prepare_names, prepared) {
            let comma = if operands.is_empty() { "" } else { ", " };
            operands = format!("{prepared}: {structure}{comma}{operands}");
        }
        let mut values = written.values.into_iter();
        let built = self
            .shapes
            .build(&function.result, &mut values, &mut self.names);
        text.push_str(&comment(&function.attributes));
        let body = returning(&written.statements, &built);
        text + &format!("fn {name}({operands}) -> {result} {{\n{body}}}\n\n")
    }

    /// The inputs of the graph as expressions.
    fn inputs(&mut self, operands: &[Operand], parameters: &[String]) -> Vec<String> {
        operands
            .iter()
            .zip(parameters)
            .flat_map(|(operand, name)| self.shapes.read(&operand.shape, name, &mut self.names))
            .collect()
    }

    /// The parameters that are uniform, or those that are not.
    fn parameters(&mut self, operands: &[Operand], names: &[String], uniform: bool) -> String {
        let parameters: Vec<_> = operands
            .iter()
            .zip(names)
            .filter(|(operand, _)| operand.is_uniform == uniform)
            .map(|(operand, name)| {
                let kind = self.shapes.name(&operand.shape, &mut self.names);
                format!("{name}: {kind}")
            })
            .collect();
        parameters.join(", ")
    }

    fn stage(
        &mut self,
        function: &CompiledFunction,
        stage: &Stage,
        wanted: &[Value],
        known: &HashMap<NodeId, String>,
        scope: &Names,
    ) -> Written {
        let own = &self.own;
        let name = |function: Function| match own.get(&function) {
            Some(name) => name.clone(),
            None => function.properties().wgsl.to_owned(),
        };
        let mut body = Body {
            arena: &function.kernel.arena,
            stage,
            known: known.clone(),
            names: scope.clone(),
            variables: 0,
            functions: BTreeSet::new(),
            function_names: &name,
        };
        let statements = body.statements();
        let values = wanted.iter().map(|&value| body.value(value)).collect();
        let called = body.functions;
        self.called.extend(called);
        Written { statements, values }
    }

    /// The declarations of our own functions that are called.
    fn own_functions(&self) -> String {
        let mut wanted = self.called.clone();
        for &function in &self.called {
            wanted.extend(scalar_functions::needs(function));
        }
        let name = |function: Function| self.own.get(&function).cloned().unwrap_or_default();
        let declarations: Vec<_> = wanted
            .into_iter()
            .filter_map(|function| scalar_functions::declaration(function, &name))
            .map(|text| text + "\n")
            .collect();
        declarations.concat()
    }
}

/// The structure of prepared values.
fn prepared_structure(function: &CompiledFunction, name: &str, members: &[String]) -> String {
    let what = match &function.name {
        Some(name) => format!("`{name}`"),
        None => "the function".to_owned(),
    };
    let declare = |member: &String| format!("    {member}: f32,\n");
    let members: String = non_empty(members.to_vec(), "nothing")
        .iter()
        .map(declare)
        .collect();
    format!("// What {what} needs of its uniform operands.\nstruct {name} {{\n{members}}}\n\n")
}

/// At least one text, since a structure must have a member.
fn non_empty(mut texts: Vec<String>, otherwise: &str) -> Vec<String> {
    if texts.is_empty() {
        texts.push(otherwise.to_owned());
    }
    texts
}

/// The members of prepared values: inputs by their names, others by their numbers.
fn member_names(function: &CompiledFunction, handed: &[NodeId], inputs: &[String]) -> Vec<String> {
    let mut names = Names::default();
    let mut next = 0;
    handed
        .iter()
        .map(|&id| match function.kernel.arena.node(id) {
            Node::Input(number) if number + function.kernel.literals.len() < inputs.len() => {
                let path = inputs.get(*number).map_or("", String::as_str);
                let word = |letter: char| match letter {
                    '.' | '[' => Some('_'),
                    ']' => None,
                    other => Some(other),
                };
                let name: String = path.chars().filter_map(word).collect();
                names.give(&name)
            }
            _ => {
                next += 1;
                names.give(&format!("value{}", next - 1))
            }
        })
        .collect()
}

/// Statements and what is returned, indented.
fn returning(statements: &str, value: &str) -> String {
    format!(
        "{statements}    return {};\n",
        value.replace('\n', "\n    ")
    )
}
