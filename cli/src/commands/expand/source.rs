//! Source text: where it comes from, and the macro calls in it.

use std::io::Read;
use std::path::Path;

use anyhow::{Context, Result};
use proc_macro2::{TokenStream, TokenTree};

use super::diagnostic::SourceError;

/// A text with its tokens.
pub(super) struct Source {
    name: String,
    text: String,
    tokens: TokenStream,
}

/// A call of a macro, `name! { … }`.
pub(super) struct Call {
    /// What stands between the brackets.
    pub(super) contents: TokenStream,
}

impl Source {
    /// Reads a file, or standard input for `-`.
    pub(super) fn read(path: &Path) -> Result<Self> {
        if path == Path::new("-") {
            let mut text = String::new();
            let read = std::io::stdin().lock().read_to_string(&mut text);
            read.context("cannot read standard input")?;
            return Self::of_text("standard input", &text);
        }
        let name = path.display().to_string();
        let text = std::fs::read_to_string(path).with_context(|| format!("cannot read {name}"))?;
        Self::of_text(&name, &text)
    }

    /// Takes a text as it is.
    pub(super) fn of_text(name: &str, text: &str) -> Result<Self> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let tokens = text.parse().map_err(|error: proc_macro2::LexError| {
            let message = "no tokens of Rust: a bracket or a quote without its counterpart, or a strange character";
            SourceError::new(name, text, &syn::Error::new(error.span(), message))
        })?;
        Ok(Self {
            name: name.to_owned(),
            text: text.to_owned(),
            tokens,
        })
    }

    pub(super) fn name(&self) -> &str {
        &self.name
    }

    /// Does something with the functions; errors show where they are in the text.
    pub(super) fn explain<T>(
        &self,
        compile: impl FnOnce(TokenStream) -> syn::Result<T>,
    ) -> Result<T, SourceError> {
        compile(self.functions()).map_err(|error| self.error(&error))
    }

    /// An error in this text.
    pub(super) fn error(&self, error: &syn::Error) -> SourceError {
        SourceError::new(&self.name, &self.text, error)
    }

    /// All tokens.
    pub(super) fn tokens(&self) -> TokenStream {
        self.tokens.clone()
    }

    /// The functions: what stands in `ga! { … }` after the path of the algebra, or the whole text
    /// where there is no such call.
    fn functions(&self) -> TokenStream {
        let calls = calls(&self.tokens, "ga");
        if calls.is_empty() {
            return self.tokens();
        }
        calls
            .into_iter()
            .flat_map(|call| split_path(call.contents).1)
            .collect()
    }

    /// The name of the algebra that the first `ga! { … }` is in.
    pub(super) fn algebra(&self) -> Option<String> {
        let call = calls(&self.tokens, "ga").into_iter().next()?;
        let path = split_path(call.contents).0?;
        path.into_iter().last().map(|last| last.to_string())
    }
}

/// The path of the algebra, `path ;`, and what follows.
fn split_path(contents: TokenStream) -> (Option<TokenStream>, TokenStream) {
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
                });
                place += 3;
            }
            [TokenTree::Group(group), ..] => {
                found.extend(calls(&group.stream(), name));
                place += 1;
            }
            _ => place += 1,
        }
    }
    found
}
