//! Runs shaders that Nullcone writes: on whatever adapter there is, and number by number on the
//! processor for comparison.

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

/// cga3 as it ships.
///
/// # Panics
/// The declaration does not compile.
#[must_use]
pub fn cga3() -> Definition {
    let text = ga_runtime::cga3! { [declaration] };
    let parsed = text.parse().expect("a declaration is made of tokens");
    ga_compiler::check_types(parsed, quote::quote! { ga_runtime }).expect("it is sound")
}

/// Compiles one function.
///
/// # Panics
/// It does not compile.
#[must_use]
pub fn compile(definition: &Definition, text: &str) -> CompiledFunction {
    let tokens = text.parse().expect("a function is made of tokens");
    match ga_compiler::compile(definition, tokens) {
        Ok(mut functions) => functions.remove(0),
        Err(error) => panic!("{text}: {error}"),
    }
}
