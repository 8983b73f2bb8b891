//! The optimising compiler behind Nullcone.
//!
//! [`expand_algebra`] takes the declaration of a geometric algebra and gives Rust code; the stages between are public,
//! so that tools can parse, simplify, evaluate and count without any macro:
//!
//! ```text
//! tokens → parse → define → expression → lower → ir → passes → emit
//!                     └────────────── verify ──────────────┘
//! ```
//!
//! - [`parse`]: grammars; names are still names.
//! - [`define`]: a checked declaration; every error is found here, at its token.
//! - [`algebra`]: blades, metric, and the products of basis blades.
//! - [`expression`]: formulas over typed operands.
//! - [`lower`]: formulas to the graph, by named rules.
//! - [`ir`]: the graph, hash-consed, and multivectors over it.
//! - [`passes`]: dead code, order, cost.
//! - [`kernel`]: one compiled expression; [`function`]: one compiled function.
//! - [`verify`]: evaluation over a prime field, which decides what a result is and checks the compiler's work.
//! - [`emit`]: Rust code.
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

pub mod algebra;
pub mod define;
pub mod diag;
pub mod emit;
pub mod expression;
pub mod function;
pub mod ir;
pub mod kernel;
pub mod lower;
pub mod parse;
pub mod passes;
pub mod verify;

use proc_macro2::{Span, TokenStream};
use syn::{Error, Result};

use define::Definition;
use expression::Expression;
use kernel::Kernel;

/// A compiled function with the algebra it is written in.
pub struct Compiled {
    /// The algebra.
    pub definition: Definition,
    /// The graph.
    pub kernel: Kernel,
}

/// Expands the declaration of an algebra, preceded by the path of ga-runtime in brackets: `[runtime] declaration`.
///
/// On errors the result holds a `compile_error!` for each and stand-ins for what would have been declared, so that code
/// which uses it adds no errors of its own.
#[must_use]
pub fn expand_algebra(tokens: TokenStream) -> TokenStream {
    let (runtime, source) = match parse::parse_placed(tokens) {
        Ok(placed) => placed,
        Err(error) => return error.into_compile_error(),
    };
    let checked = parse::parse_declaration(source.clone())
        .and_then(|syntax| Definition::check(syntax, runtime));
    match checked {
        Ok(definition) => emit::rust::algebra(&definition, &source),
        Err(errors) => emit::rust::stand_ins(&source, &errors.into_compile_error()),
    }
}

/// Expands to tests of every declared product of an algebra against the dense reference.
///
/// The tokens are what the algebra's own macro hands over: `[runtime] { declaration } path`.
#[must_use]
pub fn expand_product_tests(tokens: TokenStream) -> TokenStream {
    let expanded = parse::parse_handover(tokens).and_then(|handover| {
        let syntax = parse::parse_declaration(handover.declaration)?;
        let definition = Definition::check(syntax, handover.runtime)?;
        Ok(emit::rust::product_tests(&definition, &handover.input))
    });
    expanded.unwrap_or_else(Error::into_compile_error)
}

/// Compiles one function in an algebra, both given as tokens, and checks it against its plain meaning.
///
/// # Errors
/// Every error of the declaration, or the first of the function.
pub fn compile_function(declaration: TokenStream, function: TokenStream) -> Result<Compiled> {
    let syntax = parse::parse_declaration(declaration)?;
    let definition = Definition::check(syntax, TokenStream::new())?;
    let function = parse::parse_function(function)?;
    let find = |name: &syn::Ident| {
        let found = definition.type_named(&name.to_string());
        found.ok_or_else(|| Error::new(name.span(), format!("unknown type `{name}`")))
    };
    let names: Vec<_> = function
        .operands
        .iter()
        .map(|(name, _)| name.clone())
        .collect();
    let operands = function
        .operands
        .iter()
        .map(|(_, kind)| find(kind))
        .collect::<Result<Vec<_>>>()?;
    let result = match function.result.to_string().as_str() {
        "Scalar" => None,
        _ => Some(find(&function.result)?),
    };
    let expression = Expression::resolve(&function.body, &names)?;
    let algebra = &definition.algebra;
    verify::result_fits(algebra, &operands, &expression, result).map_err(|reasons| {
        let message = format!(
            "the result is no `{}`: {}",
            function.result,
            reasons.join("; ")
        );
        Error::new(function.result.span(), message)
    })?;
    let kernel = Kernel::compile(algebra, &operands, &expression, result);
    if !kernel.agrees(algebra, &operands, &expression, result, 1) {
        let message = format!(
            "rule {:?} changed the meaning of the expression",
            kernel.rule
        );
        return Err(Error::new(Span::call_site(), message));
    }
    Ok(Compiled { definition, kernel })
}
