//! The procedural macros of Nullcone. Each passes its tokens to [`ga_compiler`].
//!
//! Crates use them through ga-runtime, whose macros add the path at which the emitted code finds
//! ga-runtime.

use proc_macro::TokenStream;

/// Declares an algebra; `ga_runtime::algebra!` describes the grammar.
#[proc_macro]
pub fn algebra(tokens: TokenStream) -> TokenStream {
    ga_compiler::expand_algebra(tokens.into()).into()
}

/// Compiles functions of an algebra; `ga_runtime::ga!` describes the grammar.
#[proc_macro]
pub fn functions(tokens: TokenStream) -> TokenStream {
    ga_compiler::expand_functions(tokens.into()).into()
}

/// Stand-ins for what another macro would make of an algebra whose declaration is faulty.
#[proc_macro]
pub fn stand_ins(tokens: TokenStream) -> TokenStream {
    ga_compiler::expand_stand_ins(tokens.into()).into()
}

/// Imports the block of a function that is used, and continues with the functions that use it.
#[proc_macro]
pub fn import(tokens: TokenStream) -> TokenStream {
    ga_compiler::expand_import(tokens.into()).into()
}

/// Tests every declared product of an algebra; see `ga_runtime::testing::product_tests!`.
#[proc_macro]
pub fn product_tests(tokens: TokenStream) -> TokenStream {
    ga_compiler::expand_product_tests(tokens.into()).into()
}
