//! The optimising compiler behind Nullcone.
//!
//! [`expand_algebra`] takes the declaration of a geometric algebra and gives Rust code; the stages
//! between are public, so that tools can parse, simplify, evaluate and count without any macro:
//!
//! ```text
//! tokens ─ parse ─┬─ check → define ─┐
//!                 └─ resolve ────────┴→ ga-symbolic → emit
//! ```
//!
//! What lies between reading and writing Rust is the crate `ga-symbolic`, whose public modules are
//! found here too, from [`algebra`] to [`kernel`]. This crate has the rest. Each module uses only
//! those that stand before it in this list; `fingerprint`, `nearest` and `diag` are small helpers
//! of all:
//!
//! - [`diag`]: errors, collected; [`parse`]: grammars; names are not resolved yet.
//! - [`check`]: the checks of a declaration; every error is found here, at its token.
//! - [`resolve`]: names to the steps of a program.
//! - [`function`]: one compiled function.
//! - [`emit`]: Rust, WGSL, formulas and graphs; `count`: operations in emitted Rust.
//! - `source`: texts of Rust with `algebra!` and `ga!` blocks, and errors with their lines.
//! - `explain`: messages about values that are not of their declared type.
//!
//! # Example
//!
//! The outer product of two vectors of the plane, from tokens to a count of operations:
//!
//! ```
//! use ga_compiler::{Compiled, compile_function};
//!
//! let declaration = quote::quote! {
//!     pub mod vga2 {
//!         basis e1, e2;
//!         signature 2, 0;
//!         struct Vector { e1, e2 }
//!         struct Bivector { e12 }
//!     }
//! };
//! let function = quote::quote! { (a: Vector, b: Vector) -> Bivector { a ^ b } };
//! let Compiled { kernel, .. } = compile_function(declaration, function)?;
//! assert_eq!((kernel.cost().multiplications, kernel.cost().additions), (2, 1));
//! # Ok::<(), syn::Error>(())
//! ```

pub mod check;
#[cfg(feature = "count")]
pub mod count;
pub mod diag;
pub mod emit;
mod explain;
mod fingerprint;
pub mod function;
mod nearest;
pub mod parse;
pub mod resolve;
#[cfg(feature = "source")]
pub mod source;

pub use ga_symbolic::{
    algebra, define, expression, forms, ir, kernel, limit, lower, passes, program, signature, task,
    typed, verify,
};
use ga_symbolic::{literals, member};

use proc_macro2::TokenStream;
use syn::{Error, Result};

use algebra::{Algebra, NamedBlade};
use define::{Definition, TypeDefinition};
use fingerprint::fingerprint;
use function::CompiledFunction;
use kernel::Kernel;
use literals::Opaque;
use parse::{Block, FunctionSyntax};
use program::{Mismatch, StepId};
use resolve::{ResolveError, ResolveErrorKind, Resolved};
use task::Task;

/// A compiled function with the algebra it is written in.
pub struct Compiled {
    /// The algebra.
    pub definition: Definition,
    /// The graph.
    pub kernel: Kernel,
}

/// Expands the declaration of an algebra, preceded by the path of ga-runtime in brackets:
/// `[runtime] declaration`.
///
/// On errors the result holds a `compile_error!` for each and stand-ins for what would have been
/// declared, so that code which uses it adds no errors of its own.
#[must_use]
pub fn expand_algebra(tokens: TokenStream) -> TokenStream {
    let (runtime, source) = match parse::parse_placed(tokens) {
        Ok(placed) => placed,
        Err(error) => return error.into_compile_error(),
    };
    let checked = parse::parse_declaration(source.clone())
        .and_then(|syntax| check::check_with_warnings(syntax, runtime.clone()));
    match checked {
        Ok((definition, warnings)) => emit::rust::algebra(&definition, &source, &warnings),
        Err(errors) => emit::rust::stand_ins(&runtime, &source, &errors.into_compile_error()),
    }
}

/// Expands to stand-ins for functions of an algebra whose declaration is faulty, so that code which
/// calls them adds no errors of its own. The tokens are what `ga!` hands to the macro of that
/// algebra: `[macro] [path] functions`. For other macros there is nothing to stand in for.
#[must_use]
pub fn expand_stand_ins(tokens: TokenStream) -> TokenStream {
    match parse::parse_faulty(tokens) {
        Ok(Some(faulty)) => emit::rust::stand_ins_of_functions(&faulty),
        Ok(None) | Err(_) => TokenStream::new(),
    }
}

/// Expands to tests of every declared product of an algebra against the dense reference.
///
/// The tokens are what the algebra's own macro hands over: `[runtime] { declaration } path`.
#[must_use]
pub fn expand_product_tests(tokens: TokenStream) -> TokenStream {
    let expanded = parse::parse_handover(tokens).and_then(|handover| {
        let syntax = parse::parse_declaration(handover.declaration)?;
        let definition = check::check(syntax, handover.runtime)?;
        Ok(emit::rust::product_tests(&definition, &handover.input))
    });
    expanded.unwrap_or_else(Error::into_compile_error)
}

/// Expands functions of an algebra: what `ga!` stands for.
///
/// The tokens are what the algebra's own macro hands over:
/// `[runtime] { declaration } [path] functions`. A leading `use` of a function of another block
/// becomes a call of that block's macro, which calls back through [`expand_import`].
#[must_use]
pub fn expand_functions(tokens: TokenStream) -> TokenStream {
    let expanded = parse::parse_pending(tokens).and_then(|pending| {
        let (first, source) = parse::parse_use(pending.source.clone())?;
        if let Some(import) = first {
            return Ok(emit::rust::ask_for_import(&pending, &import, &source));
        }
        let (imports, path) = (&pending.imports, &pending.path);
        let whole = quote::quote! { [#imports] #source };
        let block: Block = syn::parse2(whole.clone())?;
        let algebra = fingerprint(&pending.declaration.to_string());
        let definition = check_types(pending.declaration, pending.runtime)?;
        Ok(match compile_block(&definition, &block) {
            Ok(compiled) => {
                let functions = emit::rust::functions(&definition, path, &compiled);
                let handover = emit::rust::block_handover(&block, algebra, &whole);
                quote::quote! { #functions #handover }
            }
            Err(error) => {
                let error = error.into_compile_error();
                match emit::rust::function_stand_ins(&definition, path, &block.functions) {
                    Some(stand_ins) => quote::quote! { #stand_ins #error },
                    None => error,
                }
            }
        })
    });
    expanded.unwrap_or_else(Error::into_compile_error)
}

/// Takes in a block that was asked for, and goes on: `{ algebra block } (name original) pending`.
#[must_use]
pub fn expand_import(tokens: TokenStream) -> TokenStream {
    let expanded = parse::parse_import(tokens).and_then(|import| {
        let parse::Imported {
            algebra,
            block,
            names,
            rest,
        } = import;
        let pending = parse::parse_pending(rest)?;
        if algebra != fingerprint(&pending.declaration.to_string()) {
            let message =
                "this function is written in another algebra, whose types have other meanings";
            return Err(Error::new_spanned(names, message));
        }
        let imports = &pending.imports;
        let imports = quote::quote! { #imports (#names { #block }) };
        Ok(expand_functions(emit::rust::pending(&parse::Pending {
            imports,
            ..pending
        })))
    });
    expanded.unwrap_or_else(Error::into_compile_error)
}

/// The types of a declaration without its products, which a function has no use for.
///
/// # Errors
/// Everything that is wrong with the declaration.
pub fn check_types(declaration: TokenStream, runtime: TokenStream) -> Result<Definition> {
    let mut syntax = parse::parse_declaration(declaration)?;
    syntax.products.clear();
    check::check(syntax, runtime)
}

/// Compiles functions of an algebra, written as in `ga!`, and checks each against its plain
/// meaning.
///
/// ```
/// use ga_compiler::{check_types, compile};
///
/// let declaration = quote::quote! {
///     pub mod vga2 {
///         basis e1, e2;
///         signature 2, 0;
///         struct Vector { e1, e2 }
///     }
/// };
/// let definition = check_types(declaration, quote::quote! { ga_runtime })?;
/// let functions = compile(&definition, quote::quote! {
///     fn reflect(v: Vector, n: Vector) -> Vector { -n * v * inverse(n) }
/// })?;
/// assert_eq!(functions[0].kernel.cost().divisions, 1);
/// # Ok::<(), syn::Error>(())
/// ```
///
/// # Errors
/// The first error of each function, at its token.
pub fn compile(definition: &Definition, source: TokenStream) -> Result<Vec<CompiledFunction>> {
    let functions = parse::parse_functions(source)?;
    let block = Block {
        functions,
        imports: Vec::new(),
    };
    compile_block(definition, &block)
}

/// Compiles the functions of a block, as [`compile`] does, with those that it uses.
///
/// # Errors
/// The first error of each function, at its token; functions that call each other in a circle have
/// one error together, and so have functions whose calls go too deep.
pub fn compile_block(definition: &Definition, block: &Block) -> Result<Vec<CompiledFunction>> {
    let mut diagnostics = diag::Diagnostics::default();
    let (mut compiled, mut reported) = (Vec::new(), Vec::new());
    for function in &block.functions {
        let resolved = match resolve(definition, function, block) {
            Ok(resolved) => resolved,
            Err(error) => {
                if !is_reported(error.kind(), &mut reported) {
                    diagnostics.push(error.into());
                }
                continue;
            }
        };
        match compile_resolved(definition, function, resolved) {
            Ok(done) => compiled.push(done),
            Err(error) => diagnostics.push(error),
        }
    }
    diagnostics.into_result()?;
    Ok(compiled)
}

/// Whether an error of several functions together is reported already; if not, it is remembered.
fn is_reported(error: &ResolveErrorKind, reported: &mut Vec<ResolveErrorKind>) -> bool {
    let error = match error {
        // The circle is the same wherever it is entered.
        ResolveErrorKind::Recursion(circle) => {
            let mut circle = circle.clone();
            circle.sort();
            ResolveErrorKind::Recursion(circle)
        }
        ResolveErrorKind::CallsTooDeep(_) => ResolveErrorKind::CallsTooDeep(String::new()),
        _ => return false,
    };
    if reported.contains(&error) {
        return true;
    }
    reported.push(error);
    false
}

fn resolve<'a>(
    definition: &'a Definition,
    function: &FunctionSyntax,
    block: &Block,
) -> std::result::Result<Resolved<'a>, ResolveError> {
    let explain = |mismatch: &Mismatch<'_, '_>| explain::explain(definition, mismatch);
    resolve::resolve_with(definition, function, block, &explain)
}

/// The kernel of a function with its long numbers as operands, which are given with the kernel.
fn with_opaque_literals(
    algebra: &Algebra,
    resolved: &Resolved<'_>,
    wanted: &[(StepId, Vec<NamedBlade>)],
) -> Kernel {
    let scalar = TypeDefinition::scalar();
    let opaque = Opaque::new(&resolved.program, &scalar);
    let wanted = wanted.iter();
    let wanted = wanted.map(|(step, blades)| (opaque.image(*step), blades.clone()));
    let mut uniform = resolved.uniform.clone();
    uniform.resize(resolved.program.operands.len(), false);
    let is_staged = uniform.contains(&true);
    uniform.resize(opaque.program.operands.len(), is_staged);
    let task = Task::of_program(algebra, &opaque.program, wanted.collect()).with_uniform(&uniform);
    let literals = opaque.literals.clone();
    Kernel {
        literals,
        ..task.compile()
    }
}

fn compile_resolved(
    definition: &Definition,
    function: &FunctionSyntax,
    resolved: Resolved<'_>,
) -> Result<CompiledFunction> {
    let wanted: Vec<_> = resolved
        .outputs
        .iter()
        .map(|(step, kind)| (*step, kernel::wanted(*kind)))
        .collect();
    let (algebra, program) = (&definition.algebra, &resolved.program);
    let task = Task::of_program(algebra, program, wanted.clone())
        .with_uniform(&resolved.uniform)
        .with_witness(&resolved.witness)
        .with_types(&definition.types);
    let mut kernel = task.compile();
    if kernel.is_out_of_range() {
        kernel = with_opaque_literals(algebra, &resolved, &wanted);
    }
    if kernel.is_out_of_range() {
        let message = "the constants of the types in this function have too many digits together: \
                       products of them need more than 128 bits";
        return Err(function.value.error(message));
    }
    if !kernel.agrees_with(program, &resolved.witness, &wanted) {
        let message = format!(
            "the rules {:?} changed the meaning of this function; this is a defect of the compiler",
            kernel.choices.names()
        );
        return Err(function.value.error(message));
    }
    Ok(CompiledFunction {
        attributes: function.attributes.clone(),
        visibility: function.visibility.clone(),
        name: function.name.clone(),
        operands: resolved.operands,
        result: resolved.result,
        kernel,
        warnings: resolved.warnings,
    })
}

/// Compiles one function in an algebra, both given as tokens, and checks it against its plain
/// meaning.
///
/// # Errors
/// Every error of the declaration, or the first of the function.
pub fn compile_function(declaration: TokenStream, function: TokenStream) -> Result<Compiled> {
    let definition = check_types(declaration, TokenStream::new())?;
    let function = parse::parse_function(function)?;
    let resolved = resolve(&definition, &function, &Block::default())?;
    let CompiledFunction { kernel, .. } = compile_resolved(&definition, &function, resolved)?;
    Ok(Compiled { definition, kernel })
}
