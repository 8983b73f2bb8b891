//! Places in the source, for errors.

use std::fmt;

use proc_macro2::{Span, TokenStream};
use quote::ToTokens;
use syn::{Error, Ident};

/// A place in the source: the tokens from one to another.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    start: Span,
    /// The last token.
    pub(super) end: Span,
}

impl Place {
    /// The place of one token.
    #[must_use]
    pub const fn of(token: Span) -> Self {
        Self {
            start: token,
            end: token,
        }
    }

    /// An error at this place.
    #[must_use]
    pub fn error(self, message: impl fmt::Display) -> Error {
        // Stable procedural macros cannot join spans; a row of two tokens is reported as a whole.
        let mut tokens = TokenStream::new();
        for span in [self.start, self.end] {
            Ident::new("place", span).to_tokens(&mut tokens);
        }
        Error::new_spanned(tokens, message)
    }

    /// The first token.
    #[must_use]
    pub const fn start(self) -> Span {
        self.start
    }

    /// The place from here to a later token.
    pub(super) const fn to(self, end: Span) -> Self {
        Self { end, ..self }
    }
}
