//! `algebra!`: declarations of the repository with edits never panic, and expand within bounds.
#![no_main]

use std::sync::LazyLock;

use ga_compiler::expand_algebra;
use libfuzzer_sys::fuzz_target;
use nullcone_fuzz::edit::{Bytes, edited, text};
use nullcone_fuzz::limits::within_limits;
use nullcone_fuzz::programs::{Tokens, declarations};
use proc_macro2::TokenStream;

static DECLARATIONS: LazyLock<Vec<Tokens>> = LazyLock::new(declarations);

/// The longest declaration that is edited; of longer ones pieces are taken.
const LONGEST: usize = 1000;

fuzz_target!(|data: &[u8]| {
    let mut bytes = Bytes(data);
    let pool: Vec<&Tokens> = DECLARATIONS.iter().collect();
    let starts: Vec<&Tokens> = pool
        .iter()
        .copied()
        .filter(|all| all.len() < LONGEST)
        .collect();
    let start = starts[bytes.below(starts.len())].clone();
    let text = text(&edited(start, &pool, &mut bytes));
    let Ok(tokens) = format!("[ga_runtime] {text}").parse::<TokenStream>() else {
        return;
    };
    let expansion = within_limits(&text, || expand_algebra(tokens.clone()));
    // The same input gives the same output.
    if data.first().is_some_and(|first| first % 16 == 0) {
        assert_eq!(expansion.to_string(), expand_algebra(tokens).to_string());
    }
});
