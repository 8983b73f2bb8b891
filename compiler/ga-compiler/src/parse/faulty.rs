//! What `ga!` asks of the macro of an algebra whose declaration is faulty: the names that its
//! functions would have.

use proc_macro2::{Delimiter, Ident, TokenStream, TokenTree};
use syn::Result;

use super::handover::parse_placed;

/// The names of functions in a faulty algebra.
pub struct FaultyFunctions {
    /// Where the module of the algebra is found.
    pub path: TokenStream,
    /// For each function its visibility, its name, and whether it has uniform operands. A closure
    /// is not among them.
    pub functions: Vec<(TokenStream, Ident, bool)>,
}

/// Reads `[macro] [path] functions` as far as it can be read. `None` where another macro asks than
/// that of functions.
///
/// # Errors
/// The tokens have another shape.
pub fn parse_faulty(tokens: TokenStream) -> Result<Option<FaultyFunctions>> {
    let (callback, rest) = parse_placed(tokens)?;
    let is_of_functions = matches!(
        callback.into_iter().last(),
        Some(TokenTree::Ident(name)) if name == "functions"
    );
    if !is_of_functions {
        return Ok(None);
    }
    let (path, source) = parse_placed(rest)?;
    let mut functions = Vec::new();
    let mut visibility = TokenStream::new();
    let mut tokens = source.into_iter().peekable();
    while let Some(token) = tokens.next() {
        match token {
            TokenTree::Ident(word) if word == "pub" => {
                visibility = TokenTree::from(word).into();
                if let Some(TokenTree::Group(limit)) = tokens.peek() {
                    visibility.extend([TokenTree::from(limit.clone())]);
                }
            }
            TokenTree::Ident(word) if word == "fn" => {
                if let Some(TokenTree::Ident(name)) = tokens.next() {
                    let is_staged = matches!(tokens.peek(), Some(TokenTree::Group(operands))
                        if has_uniform(operands.stream()));
                    functions.push((std::mem::take(&mut visibility), name, is_staged));
                }
            }
            // The body of a function, or an attribute.
            TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => {
                visibility = TokenStream::new();
            }
            _ => {}
        }
    }
    Ok(Some(FaultyFunctions { path, functions }))
}

/// Whether an operand is marked `uniform`.
fn has_uniform(operands: TokenStream) -> bool {
    let tokens: Vec<_> = operands.into_iter().collect();
    tokens.windows(2).any(
        |pair| matches!(pair, [TokenTree::Ident(mark), TokenTree::Ident(_)] if mark == "uniform"),
    )
}
