//! How macros pass things on: paths in brackets, declarations in braces.

use proc_macro2::TokenStream;
use syn::parse::{ParseStream, Parser};
use syn::{Result, braced, bracketed};

/// What the macro of an algebra hands to another macro: `[runtime] { declaration } input`.
pub struct Handover {
    /// The path of ga-runtime.
    pub runtime: TokenStream,
    /// The tokens of the declaration.
    pub declaration: TokenStream,
    /// Whatever the caller added.
    pub input: TokenStream,
}

/// Reads a handover.
///
/// # Errors
/// The tokens have another shape.
pub fn parse_handover(tokens: TokenStream) -> Result<Handover> {
    let parser = |input: ParseStream<'_>| {
        let runtime = runtime(input)?;
        let declaration;
        braced!(declaration in input);
        Ok(Handover {
            runtime,
            declaration: declaration.parse()?,
            input: input.parse()?,
        })
    };
    parser.parse2(tokens)
}

/// Reads `[runtime] rest`.
///
/// # Errors
/// The tokens have another shape.
pub fn parse_placed(tokens: TokenStream) -> Result<(TokenStream, TokenStream)> {
    let parser = |input: ParseStream<'_>| Ok((runtime(input)?, input.parse()?));
    parser.parse2(tokens)
}

fn runtime(input: ParseStream<'_>) -> Result<TokenStream> {
    let path;
    bracketed!(path in input);
    path.parse()
}
