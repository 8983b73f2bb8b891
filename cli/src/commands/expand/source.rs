//! Source text: where it comes from, and the macro calls in it.

use std::io::Read;
use std::path::Path;

use anyhow::{Context, Result};
use ga_compiler::define::Definition;
use ga_compiler::function::CompiledFunction;
use ga_compiler::parse::check_brackets;
use proc_macro2::{Span, TokenStream, TokenTree};

use super::blocks;
use super::diagnostic::SourceError;

/// A text with its tokens.
pub(super) struct Source {
    name: String,
    text: String,
    tokens: TokenStream,
}

/// A call of a macro, `name! { … }`.
pub(super) struct Call {
    /// The tokens between the brackets.
    pub(super) contents: TokenStream,
    /// The brackets.
    place: Span,
    /// The modules around it, outermost first.
    modules: Vec<String>,
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
        let text = ga_files::read(path, |bytes| str::from_utf8(bytes).map(str::to_owned))?;
        Self::of_text(&path.display().to_string(), &text)
    }

    /// Takes a text as it is.
    pub(super) fn of_text(name: &str, text: &str) -> Result<Self> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let tokens: TokenStream = text.parse().map_err(|error: proc_macro2::LexError| {
            let message = "these are not tokens of Rust: \
                           a bracket or quote is not closed, or a character has no meaning";
            SourceError::new(name, text, &syn::Error::new(error.span(), message))
        })?;
        check_brackets(&tokens).map_err(|error| SourceError::new(name, text, &error))?;
        Ok(Self {
            name: name.to_owned(),
            text: text.to_owned(),
            tokens,
        })
    }

    pub(super) fn name(&self) -> &str {
        &self.name
    }

    /// Compiles all functions, those of each `ga! { … }` as a block of their own.
    pub(super) fn compile(
        &self,
        definition: &Definition,
    ) -> Result<Vec<CompiledFunction>, SourceError> {
        let blocks = self.blocks().and_then(blocks::link);
        let blocks = blocks.map_err(|error| self.error(&error))?;
        let (mut functions, mut errors) = (Vec::new(), None::<syn::Error>);
        for block in &blocks {
            match (ga_compiler::compile_block(definition, block), &mut errors) {
                (Ok(compiled), _) => functions.extend(compiled),
                (Err(error), Some(errors)) => errors.combine(error),
                (Err(error), none) => *none = Some(error),
            }
        }
        errors.map_or(Ok(functions), |error| Err(self.error(&error)))
    }

    /// An error in this text.
    pub(super) fn error(&self, error: &syn::Error) -> SourceError {
        SourceError::new(&self.name, &self.text, error)
    }

    /// All tokens.
    pub(super) fn tokens(&self) -> TokenStream {
        self.tokens.clone()
    }

    /// The blocks of functions, each with the modules around it: in every `ga! { … }` what follows
    /// the path of the algebra, or the whole text where there is no such call.
    fn blocks(&self) -> syn::Result<Vec<(Vec<String>, TokenStream)>> {
        let calls = calls(&self.tokens, "ga");
        if calls.is_empty() {
            return Ok(vec![(Vec::new(), self.tokens())]);
        }
        let block = |call: Call| match split_path(call.contents.clone()) {
            (Some(_), functions) => Ok((call.modules, functions)),
            (None, _) => {
                let message = "`ga!` starts with the path of an algebra and `;`";
                Err(match call.contents.into_iter().next() {
                    Some(first) => syn::Error::new(first.span(), message),
                    None => syn::Error::new(call.place, message),
                })
            }
        };
        calls.into_iter().map(block).collect()
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
