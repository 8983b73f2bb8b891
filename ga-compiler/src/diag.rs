//! Errors with their places in the source, collected so that one run reports all of them.

use proc_macro2::{Span, TokenStream};
use quote::ToTokens;
use syn::Error;

/// All errors found so far.
#[derive(Default)]
pub struct Diagnostics {
    errors: Option<Error>,
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

    /// Whether nothing went wrong.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.errors.is_none()
    }

    /// All errors as one, if there are any.
    ///
    /// # Errors
    /// Whatever was collected.
    pub fn into_result(self) -> syn::Result<()> {
        self.errors.map_or(Ok(()), Err)
    }

    /// One `compile_error!` for each error; nothing where there is none.
    #[must_use]
    pub fn to_compile_errors(&self) -> TokenStream {
        self.errors
            .as_ref()
            .map_or_else(TokenStream::new, Error::to_compile_error)
    }

    /// The messages in the order in which they were found.
    #[must_use]
    pub fn messages(&self) -> Vec<String> {
        let errors = self.errors.clone().into_iter().flatten();
        errors.map(|error| error.to_string()).collect()
    }
}
