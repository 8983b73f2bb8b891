//! Runs shaders that Nullcone writes, on any adapter of the machine; for comparison, evaluates the
//! same functions number by number on the processor.

mod adapter;
mod graph;
mod shader;

pub use adapter::Gpu;
pub use graph::evaluate;
pub use shader::{Shader, validate};

use ga_compiler::define::Definition;
use ga_compiler::function::CompiledFunction;

macro_rules! declaration {
    ([$($runtime:tt)*] { $($declaration:tt)* }) => {
        stringify!($($declaration)*)
    };
}

/// The declaration of cga3 in ga-runtime.
///
/// # Panics
/// If the declaration does not compile.
#[must_use]
pub fn cga3() -> Definition {
    let text = ga_runtime::cga3! { [declaration] };
    let parsed = text.parse().expect("a declaration consists of tokens");
    ga_compiler::check_types(parsed, quote::quote! { ga_runtime })
        .expect("the declaration is valid")
}

/// Compiles one function.
///
/// # Panics
/// If it does not compile.
#[must_use]
pub fn compile(definition: &Definition, text: &str) -> CompiledFunction {
    let tokens = text.parse().expect("a function consists of tokens");
    match ga_compiler::compile(definition, tokens) {
        Ok(mut functions) => functions.remove(0),
        Err(error) => panic!("{text}: {error}"),
    }
}
