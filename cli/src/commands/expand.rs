//! `nullcone expand`: the code that the compiler writes for functions in an algebra.

use std::fmt::Write as _;
use std::io::Read as _;
use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result, bail, ensure};
use clap::ValueEnum;
use ga_compiler::count::{self, FunctionCount, Operations};
use ga_compiler::emit::{dot, formula, rust, wgsl};
use ga_compiler::function::CompiledFunction;
use ga_compiler::source::{Algebra, Source};
use serde::{Serialize, Serializer};

use crate::frame::{self, Command, Context, Warning};

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
    Operations(Counts),
}

/// The name and the operations of each function. As JSON it is one object; of several functions an
/// object with one for each name.
struct Counts(Vec<(String, FunctionCount)>);

impl Serialize for Counts {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        match &self.0[..] {
            [(_, single)] => single.serialize(serializer),
            several => serializer.collect_map(several.iter().map(|(name, count)| (name, count))),
        }
    }
}

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        context.files(self.file.iter().filter(|path| path.as_os_str() != "-"))?;
        let source = match (&self.expr, &self.file) {
            (Some(text), _) => Source::new("--expr", text)?,
            (None, Some(file)) => read(file)?,
            (None, None) => bail!("there is nothing to expand: give --expr or a file"),
        };
        let algebra = algebra(self.algebra.as_deref(), &source)?;
        let functions = source.compile(&algebra.definition)?;
        let output = match self.emit {
            Form::Ops => Output::Operations(counts(&algebra, &functions)?),
            emit => Output::Text {
                emit,
                text: written(emit, &algebra, &functions)?,
            },
        };
        if let Output::Operations(Counts(counts)) = &output {
            let is_taken = counts.len() > 1 && counts.iter().any(|(name, _)| name == "warnings");
            ensure!(
                !(is_taken && context.is_json()),
                "a function has the name `warnings`, which --json needs for its own"
            );
        }
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
            Output::Operations(Counts(counts)) => table(counts),
        }
    }

    fn is_result(&self) -> bool {
        true
    }

    fn warnings(&self) -> Option<&[Warning]> {
        // Beside names of functions, the key is there only where it says something.
        let has_names = matches!(&self.output, Output::Operations(counts) if counts.0.len() > 1);
        let is_needed = !has_names || !self.warnings.is_empty();
        is_needed.then_some(self.warnings.as_slice())
    }
}

/// The text of a file, or of standard input for `-`.
fn read(path: &Path) -> Result<Source> {
    if path == Path::new("-") {
        let mut text = String::new();
        let read = std::io::stdin().lock().read_to_string(&mut text);
        read.context("cannot read standard input")?;
        return Ok(Source::new("standard input", &text)?);
    }
    let text = ga_files::read(path, |bytes| str::from_utf8(bytes).map(str::to_owned))?;
    Ok(Source::new(&path.display().to_string(), &text)?)
}

/// Receives the declaration of an algebra from its macro, as text.
macro_rules! declaration {
    ([$($runtime:tt)*] { $($declaration:tt)* }) => {
        stringify!($($declaration)*)
    };
}

/// The names of algebras with their declarations.
macro_rules! with_declarations {
    ($($name:ident),*) => {
        &[$((stringify!($name), ga_runtime::$name! { [declaration] })),*]
    };
}

/// The algebras that ship, with their declarations.
const SHIPPED: &[(&str, &str)] = ga_runtime::__algebras!(with_declarations);

/// The algebra of that name or in that file; without either, the one that the functions name.
fn algebra(wanted: Option<&str>, functions: &Source) -> Result<Algebra> {
    let named = functions.algebra_name();
    match (wanted, &named) {
        (Some(wanted), _) => match shipped(wanted)? {
            Some(found) => Ok(found),
            None if Path::new(wanted).exists() => {
                Ok(read(Path::new(wanted))?.algebra(named.as_deref())?)
            }
            None => {
                let names: Vec<&str> = SHIPPED.iter().map(|(name, _)| *name).collect();
                let names = names.join(", ");
                bail!("--algebra {wanted}: this is neither one of {names} nor a file")
            }
        },
        (None, None) => algebra(Some("cga3"), functions),
        (None, Some(_)) if functions.declares_algebra() => Ok(functions.algebra(named.as_deref())?),
        (None, Some(name)) => shipped(name)?.with_context(|| {
            format!(
                "{} is written in the algebra {name}: give its file with --algebra",
                functions.name()
            )
        }),
    }
}

fn shipped(name: &str) -> Result<Option<Algebra>> {
    let Some((_, text)) = SHIPPED.iter().find(|(shipped, _)| *shipped == name) else {
        return Ok(None);
    };
    let algebra = Source::new(name, text)?.algebra(None)?;
    let path = format!("ga_runtime::{name}").parse();
    let path = path.map_err(|error| anyhow::anyhow!("{name}: {error}"))?;
    Ok(Some(Algebra { path, ..algebra }))
}

/// Where the search for the cheapest code was cut short.
fn warnings(functions: &[CompiledFunction]) -> Vec<Warning> {
    let of = |function: &CompiledFunction| {
        let name = function.label();
        let limits = function.kernel.limits.clone().into_iter();
        limits.map(move |limit| {
            Warning::new("search_cut_short", format!("`{name}`: {}", limit.note()))
        })
    };
    functions.iter().flat_map(of).collect()
}

fn written(emit: Form, algebra: &Algebra, functions: &[CompiledFunction]) -> Result<String> {
    let definition = &algebra.definition;
    // The texts of all functions, with an empty line between them.
    let joined = |write: fn(&_, &_) -> String| {
        let texts = functions.iter().map(|function| write(definition, function));
        texts.collect::<Vec<_>>().join("\n")
    };
    Ok(match emit {
        Form::Rust => rust::text(definition, &algebra.path, functions)
            .context("the emitted code is not Rust")?,
        Form::Wgsl => wgsl::module(definition, functions),
        Form::Formula => joined(formula::function),
        Form::Dot => joined(dot::function),
        Form::Ops => table(&counts(algebra, functions)?.0),
    })
}

fn counts(algebra: &Algebra, functions: &[CompiledFunction]) -> Result<Counts> {
    let counted = |function: &CompiledFunction| {
        let name = function.label();
        let count = count::function(&algebra.definition, &algebra.path, function)
            .with_context(|| format!("the code of {name} cannot be counted"))?;
        Ok((name, count))
    };
    let counts = functions.iter().map(counted);
    counts.collect::<Result<_>>().map(Counts)
}

/// A line for each function, and one for the work on its uniform operands where it has any.
fn table(counts: &[(String, FunctionCount)]) -> String {
    let mut text = String::new();
    for (name, FunctionCount { call, uniform }) in counts {
        let _ = writeln!(text, "{name}: {call}");
        if *uniform != Operations::default() {
            let _ = writeln!(text, "{name}, once for its uniform operands: {uniform}");
        }
    }
    text
}
