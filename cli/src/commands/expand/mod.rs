//! `nullcone expand`: the code that the compiler writes for functions in an algebra.

mod algebra;
mod blocks;
mod diagnostic;
mod operations;
mod source;

use std::path::PathBuf;

use anyhow::{Context as _, Result, bail, ensure};
use clap::ValueEnum;
use ga_compiler::define::Definition;
use ga_compiler::emit::{dot, formula, rust, wgsl};
use ga_compiler::function::CompiledFunction;
use serde::Serialize;

use crate::frame::{self, Command, Context, Warning};
use algebra::Algebra;
pub(crate) use diagnostic::SourceError;
use source::Source;

/// Print what functions in an algebra are compiled to: Rust, a shader, formulas, a graph or the
/// number of operations.
///
/// The functions are written as in `ga! { … }`, for instance
/// `fn f(m: Motor, p: Point) -> Point { m * p * rev(m) }`. They come from --expr, from a file or,
/// where the file is `-`, from standard input. A Rust file may be given as it is: the functions of
/// every `ga! { … }` in it are compiled. A `use` in one of them finds functions of the others.
///
/// --json prints {"emit": …, "text": …, "warnings": […]}, and with --emit ops {"mul": …, "add": …,
/// "div": …, "sqrt": …, "other": …, "uniform": {…}, "warnings": […]}. `uniform` counts the
/// operations that are done once for the uniform operands, the other keys those of every call. For
/// several functions it is one object with their names as keys. Warnings say where the search for
/// the cheapest code was cut short.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct Arguments {
    /// A file with the functions; `-` for standard input.
    #[arg(
        value_name = "FILE",
        required_unless_present = "expr",
        conflicts_with = "expr"
    )]
    file: Option<PathBuf>,
    /// The functions themselves.
    #[arg(long, value_name = "TEXT")]
    expr: Option<String>,
    /// The algebra: one of ga-runtime by its name, such as cga3 or pga2, or a file with an
    /// `algebra! { … }` of your own.
    ///
    /// Without it, the one that `ga! { … }` names in the functions' file, where that ships with
    /// ga-runtime or is declared in the same file; otherwise cga3.
    #[arg(long, value_name = "NAME or FILE")]
    algebra: Option<String>,
    /// What to print.
    #[arg(long, value_name = "FORM", value_enum, default_value_t = Form::Rust)]
    emit: Form,
}

/// What is printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum, Serialize)]
#[serde(rename_all = "lowercase")]
enum Form {
    /// The Rust code that `ga!` expands to.
    Rust,
    /// The functions for shaders in WGSL, with their structures.
    Wgsl,
    /// One expression for each blade of the result.
    Formula,
    /// The graph of operations, for Graphviz.
    Dot,
    /// The number of operations in the Rust code.
    Ops,
}

/// What is printed.
#[derive(Serialize)]
pub(crate) struct Report {
    #[serde(flatten)]
    output: Output,
    #[serde(skip)]
    warnings: Vec<Warning>,
}

#[derive(Serialize)]
#[serde(untagged)]
enum Output {
    Text { emit: Form, text: String },
    Operations(operations::Counts),
}

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        let arguments = self;
        context.files(arguments.file.iter().filter(|path| path.as_os_str() != "-"))?;
        let source = match (&arguments.expr, &arguments.file) {
            (Some(text), _) => Source::of_text("--expr", text)?,
            (None, Some(file)) => Source::read(file)?,
            (None, None) => bail!("there is nothing to expand: give --expr or a file"),
        };
        let algebra = Algebra::find(arguments.algebra.as_deref(), &source)?;
        let mut functions = source.compile(&algebra.definition)?;
        for function in &mut functions {
            // A closure is printed as a function of this name.
            function
                .name
                .get_or_insert_with(|| quote::format_ident!("closure"));
        }
        let output = match arguments.emit {
            Form::Ops => {
                let is_taken = functions.len() > 1
                    && functions.iter().any(|function| {
                        function
                            .name
                            .as_ref()
                            .is_some_and(|name| name == "warnings")
                    });
                ensure!(
                    !(is_taken && context.is_json()),
                    "a function has the name `warnings`, which --json needs for its own"
                );
                Output::Operations(operations::Counts::new(&algebra, &functions)?)
            }
            emit => Output::Text {
                emit,
                text: written(emit, &algebra, &functions)?,
            },
        };
        Ok(Report {
            output,
            warnings: warnings(&functions),
        })
    }
}

impl frame::Report for Report {
    fn text(&self) -> String {
        match &self.output {
            Output::Text { text, .. } => text.clone(),
            Output::Operations(counts) => counts.table(),
        }
    }

    fn is_result(&self) -> bool {
        true
    }

    fn warnings(&self) -> Option<&[Warning]> {
        // Beside names of functions, the key is there only where it says something.
        let has_names = matches!(&self.output, Output::Operations(counts) if counts.has_names());
        let is_needed = !has_names || !self.warnings.is_empty();
        is_needed.then_some(self.warnings.as_slice())
    }
}

/// Where the search for the cheapest code was cut short.
fn warnings(functions: &[CompiledFunction]) -> Vec<Warning> {
    let of = |function: &CompiledFunction| {
        let name = function.name.as_ref().map(ToString::to_string);
        let name = name.unwrap_or_default();
        let limits = function.kernel.limits.clone().into_iter();
        limits.map(move |limit| {
            Warning::new("search_cut_short", format!("`{name}`: {}", limit.note()))
        })
    };
    functions.iter().flat_map(of).collect()
}

fn written(emit: Form, algebra: &Algebra, functions: &[CompiledFunction]) -> Result<String> {
    let definition = &algebra.definition;
    Ok(match emit {
        Form::Rust => {
            let tokens = rust::functions(definition, &algebra.path, functions);
            let file = syn::parse2(tokens).context("the emitted code is not Rust")?;
            prettyplease::unparse(&file)
        }
        Form::Wgsl => wgsl::module(definition, functions),
        Form::Formula => joined(definition, functions, formula::function),
        Form::Dot => joined(definition, functions, dot::function),
        Form::Ops => operations::Counts::new(algebra, functions)?.table(),
    })
}

/// The texts of all functions, with an empty line between them.
fn joined(
    definition: &Definition,
    functions: &[CompiledFunction],
    write: fn(&Definition, &CompiledFunction) -> String,
) -> String {
    let texts: Vec<_> = functions
        .iter()
        .map(|function| write(definition, function))
        .collect();
    texts.join("\n")
}
