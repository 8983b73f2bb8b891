//! A text with its tokens, and what they make.

use proc_macro2::{LexError, TokenStream};
use quote::{ToTokens, format_ident, quote};

use super::algebra::Algebra;
use super::blocks;
use super::calls::{Call, calls, split_path};
use super::error::{Faults, SourceError};
use crate::define::Definition;
use crate::function::CompiledFunction;
use crate::parse::{check_brackets, parse_outline};

/// A text with its tokens.
#[derive(Clone, Debug)]
pub struct Source {
    name: String,
    text: String,
    tokens: TokenStream,
}

impl Source {
    /// The text of a file, or any other of that name.
    ///
    /// # Errors
    ///
    /// [`SourceError::Faulty`]: the text is not tokens of Rust, or its brackets are nested too
    /// deeply.
    pub fn new(name: &str, text: &str) -> Result<Self, SourceError> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let tokens: TokenStream = text.parse().map_err(|error: LexError| {
            let message = "these are not tokens of Rust: \
                           a bracket or quote is not closed, or a character has no meaning";
            Faults::new(name, text, &syn::Error::new(error.span(), message))
        })?;
        check_brackets(&tokens).map_err(|error| Faults::new(name, text, &error))?;
        Ok(Self {
            name: name.to_owned(),
            text: text.to_owned(),
            tokens,
        })
    }

    /// The name of the text.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Compiles all functions, those of each `ga! { … }` as a block of their own. A text without
    /// such a call has nothing but functions. A closure gets the name `closure`.
    ///
    /// # Errors
    ///
    /// [`SourceError::Faulty`] with the errors of all functions.
    pub fn compile(&self, definition: &Definition) -> Result<Vec<CompiledFunction>, SourceError> {
        let blocks = self.blocks().and_then(blocks::link);
        let blocks = blocks.map_err(|error| self.error(&error))?;
        let (mut functions, mut errors) = (Vec::new(), None::<syn::Error>);
        for block in &blocks {
            match (crate::compile_block(definition, block), &mut errors) {
                (Ok(compiled), _) => functions.extend(compiled),
                (Err(error), Some(errors)) => errors.combine(error),
                (Err(error), none) => *none = Some(error),
            }
        }
        if let Some(errors) = errors {
            return Err(self.error(&errors));
        }
        for function in &mut functions {
            let name = &mut function.name;
            name.get_or_insert_with(|| format_ident!("closure"));
        }
        Ok(functions)
    }

    /// The name of the algebra that the first `ga! { … }` is in.
    #[must_use]
    pub fn algebra_name(&self) -> Option<String> {
        let call = calls(&self.tokens, "ga").into_iter().next()?;
        let path = split_path(call.contents).0?;
        path.into_iter().last().map(|last| last.to_string())
    }

    /// Whether there is an `algebra! { … }` in the text.
    #[must_use]
    pub fn declares_algebra(&self) -> bool {
        !calls(&self.tokens, "algebra").is_empty()
    }

    /// The algebra that the text declares; of several, the one of that name. A text without
    /// `algebra! { … }` is a declaration as a whole. Emitted code finds the crate of the runtime as
    /// `ga_runtime`.
    ///
    /// # Errors
    ///
    /// [`SourceError`].
    pub fn algebra(&self, named: Option<&str>) -> Result<Algebra, SourceError> {
        let declarations = calls(&self.tokens, "algebra").into_iter();
        let mut declarations: Vec<TokenStream> = declarations.map(|call| call.contents).collect();
        if declarations.is_empty() {
            declarations.push(self.tokens.clone());
        }
        let name_of = |declaration: &TokenStream| {
            let outline = parse_outline(declaration.clone());
            outline.ok().map(|outline| outline.name)
        };
        let chosen = match &declarations[..] {
            [single] => Some(single),
            several => several.iter().find(|declaration| {
                name_of(declaration).is_some_and(|name| named.is_some_and(|named| name == named))
            }),
        };
        let chosen = chosen.ok_or_else(|| SourceError::SeveralAlgebras {
            name: self.name.clone(),
        })?;
        let path = name_of(chosen).map(|name| name.into_token_stream());
        let definition = crate::check_types(chosen.clone(), quote! { ga_runtime });
        Ok(Algebra {
            definition: definition.map_err(|error| self.error(&error))?,
            path: path.unwrap_or_default(),
        })
    }

    /// The blocks of functions, each with the modules around it: in every `ga! { … }` what follows
    /// the path of the algebra, or the whole text where there is no such call.
    fn blocks(&self) -> syn::Result<Vec<(Vec<String>, TokenStream)>> {
        let calls = calls(&self.tokens, "ga");
        if calls.is_empty() {
            return Ok(vec![(Vec::new(), self.tokens.clone())]);
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

    fn error(&self, error: &syn::Error) -> SourceError {
        Faults::new(&self.name, &self.text, error).into()
    }
}
