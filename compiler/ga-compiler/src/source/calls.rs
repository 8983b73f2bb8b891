//! The macro calls in a text.

use proc_macro2::{Span, TokenStream, TokenTree};

/// A call of a macro, `name! { … }`.
pub(super) struct Call {
    /// The tokens between the brackets.
    pub(super) contents: TokenStream,
    /// The brackets.
    pub(super) place: Span,
    /// The modules around it, outermost first.
    pub(super) modules: Vec<String>,
}

/// The path of the algebra, `path ;`, and what follows.
pub(super) fn split_path(contents: TokenStream) -> (Option<TokenStream>, TokenStream) {
    let is_end =
        |token: &TokenTree| matches!(token, TokenTree::Punct(mark) if mark.as_char() == ';');
    let tokens: Vec<TokenTree> = contents.into_iter().collect();
    match tokens.iter().position(is_end) {
        Some(end) => (
            Some(tokens[..end].iter().cloned().collect()),
            tokens[end + 1..].iter().cloned().collect(),
        ),
        None => (None, tokens.into_iter().collect()),
    }
}

/// The calls of a macro, by its last name, wherever they stand.
pub(super) fn calls(tokens: &TokenStream, name: &str) -> Vec<Call> {
    let mut found = Vec::new();
    find_calls(tokens, name, &[], &mut found);
    found
}

fn find_calls(tokens: &TokenStream, name: &str, modules: &[String], found: &mut Vec<Call>) {
    let tokens: Vec<TokenTree> = tokens.clone().into_iter().collect();
    let mut place = 0;
    while place < tokens.len() {
        match &tokens[place..] {
            [
                TokenTree::Ident(called),
                TokenTree::Punct(mark),
                TokenTree::Group(group),
                ..,
            ] if called == name && mark.as_char() == '!' => {
                found.push(Call {
                    contents: group.stream(),
                    place: group.span(),
                    modules: modules.to_vec(),
                });
                place += 3;
            }
            [
                TokenTree::Ident(keyword),
                TokenTree::Ident(module),
                TokenTree::Group(group),
                ..,
            ] if keyword == "mod" => {
                let inner = [modules, &[module.to_string()]].concat();
                find_calls(&group.stream(), name, &inner, found);
                place += 3;
            }
            [TokenTree::Group(group), ..] => {
                find_calls(&group.stream(), name, modules, found);
                place += 1;
            }
            _ => place += 1,
        }
    }
}
