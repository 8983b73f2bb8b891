//! The declaration of cga3 as tokens, for timing the compiler itself.

use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// The tokens within `algebra! { … }` of ga-runtime's conformal algebra; `None` if the file cannot
/// be read as tokens.
#[must_use]
pub fn cga3() -> Option<TokenStream> {
    let source = include_str!("../../ga-runtime/src/algebras/cga3.rs");
    let tokens: TokenStream = source.parse().ok()?;
    tokens.into_iter().find_map(|token| match token {
        TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => Some(group.stream()),
        _ => None,
    })
}
