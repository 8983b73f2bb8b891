//! Errors and warnings with their places in the source, collected so that one run reports all of
//! them.

use proc_macro2::Span;
use quote::ToTokens;
use syn::Error;

/// Something that is allowed but is probably a mistake, with its place in the source.
#[derive(Clone, Debug)]
pub struct Warning {
    /// The first token.
    pub span: Span,
    /// What is to be said.
    pub message: String,
}

/// All errors and warnings found so far.
#[derive(Default)]
pub struct Diagnostics {
    errors: Option<Error>,
    warnings: Vec<Warning>,
}

impl Diagnostics {
    /// Adds an error at the token at fault.
    pub fn error(&mut self, span: Span, message: impl std::fmt::Display) {
        self.push(Error::new(span, message));
    }

    /// Adds an error that spans all tokens of a piece of syntax.
    pub fn error_at(&mut self, tokens: impl ToTokens, message: impl std::fmt::Display) {
        self.push(Error::new_spanned(tokens, message));
    }

    /// Adds an error of the parser.
    pub fn push(&mut self, error: Error) {
        match &mut self.errors {
            Some(errors) => errors.combine(error),
            none => *none = Some(error),
        }
    }

    /// Adds a warning at a token.
    pub fn warning(&mut self, span: Span, message: String) {
        self.warnings.push(Warning { span, message });
    }

    /// The number of errors, to find out whether a check added any.
    #[must_use]
    pub fn count(&self) -> usize {
        self.errors
            .as_ref()
            .map_or(0, |errors| errors.into_iter().count())
    }

    /// The warnings, or all errors as one if there are any.
    ///
    /// # Errors
    /// The errors that were collected.
    pub fn into_result(self) -> syn::Result<Vec<Warning>> {
        self.errors.map_or(Ok(self.warnings), Err)
    }
}
