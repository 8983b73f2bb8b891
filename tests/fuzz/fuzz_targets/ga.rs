//! `ga!`: functions of the repository with edits never panic, and expand within bounds.
#![no_main]

use std::cell::OnceCell;
use std::sync::LazyLock;

use ga_compiler::define::Definition;
use ga_compiler::{check_types, compile, emit};
use libfuzzer_sys::fuzz_target;
use nullcone_fuzz::edit::{Bytes, edited, text};
use nullcone_fuzz::limits::within_limits;
use nullcone_fuzz::programs::{Functions, Tokens, declarations, functions};
use proc_macro2::TokenStream;

static FUNCTIONS: LazyLock<Vec<Functions>> = LazyLock::new(functions);

thread_local! {
    static DEFINITIONS: OnceCell<Vec<Definition>> = const { OnceCell::new() };
}

/// The algebras in which the functions are written.
fn definitions() -> Vec<Definition> {
    let definition = |tokens: &Tokens| {
        let tokens: TokenStream = text(tokens).parse().ok()?;
        check_types(tokens, "ga_runtime".parse().ok()?).ok()
    };
    declarations().iter().filter_map(definition).collect()
}

fuzz_target!(|data: &[u8]| {
    let mut bytes = Bytes(data);
    let pool: Vec<&Tokens> = FUNCTIONS.iter().map(|block| &block.tokens).collect();
    let start = &FUNCTIONS[bytes.below(FUNCTIONS.len())];
    let text = text(&edited(start.tokens.clone(), &pool, &mut bytes));
    let Ok(tokens) = text.parse::<TokenStream>() else {
        return;
    };
    DEFINITIONS.with(|known| {
        let definitions = known.get_or_init(definitions);
        let named = definitions
            .iter()
            .find(|algebra| algebra.name == start.algebra);
        let Some(algebra) = named.or(definitions.first()) else {
            return;
        };
        within_limits(&text, || {
            let Ok(functions) = compile(algebra, tokens) else {
                return;
            };
            let path = "ga_runtime::algebra".parse().expect("a path");
            let _ = emit::rust::functions(algebra, &path, &functions);
        });
    });
});
