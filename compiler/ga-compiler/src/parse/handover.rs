//! What macros hand to each other: paths in brackets, declarations and blocks in braces.

use proc_macro2::TokenStream;
use syn::parse::{ParseStream, Parser};
use syn::{Result, braced, bracketed};

use super::nesting::check_brackets;

/// What the macro of an algebra hands to another macro: `[runtime] { declaration } input`.
pub struct Handover {
    /// The path of ga-runtime.
    pub runtime: TokenStream,
    /// The tokens of the declaration.
    pub declaration: TokenStream,
    /// The tokens that the caller added.
    pub input: TokenStream,
}

/// Reads a handover.
///
/// # Errors
/// The tokens have another shape.
pub fn parse_handover(tokens: TokenStream) -> Result<Handover> {
    check_brackets(&tokens)?;
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
    check_brackets(&tokens)?;
    let parser = |input: ParseStream<'_>| Ok((runtime(input)?, input.parse()?));
    parser.parse2(tokens)
}

fn runtime(input: ParseStream<'_>) -> Result<TokenStream> {
    let path;
    bracketed!(path in input);
    path.parse()
}

/// Functions that wait for the blocks that they use: the tokens handed over so far.
pub struct Pending {
    /// The path of ga-runtime.
    pub runtime: TokenStream,
    /// The tokens of the declaration.
    pub declaration: TokenStream,
    /// Where the module of the algebra is found.
    pub path: TokenStream,
    /// Functions of other blocks, as [`Block`](super::Block) reads them.
    pub imports: TokenStream,
    /// The functions, `use` included.
    pub source: TokenStream,
}

/// Reads `[runtime] { declaration } [path] [imports] source`; at first there are no imports.
///
/// # Errors
/// The tokens have another shape.
pub fn parse_pending(tokens: TokenStream) -> Result<Pending> {
    let Handover {
        runtime,
        declaration,
        input,
    } = parse_handover(tokens)?;
    let (path, rest) = parse_placed(input)?;
    let parser = |input: ParseStream<'_>| {
        let mut imports = TokenStream::new();
        if input.peek(syn::token::Bracket) {
            let list;
            bracketed!(list in input);
            imports = list.parse()?;
        }
        Ok((imports, input.parse()?))
    };
    let (imports, source) = parser.parse2(rest)?;
    Ok(Pending {
        runtime,
        declaration,
        path,
        imports,
        source,
    })
}

/// What the macro of a block hands over to those that use a function of it.
pub struct Imported {
    /// The number of the algebra that the block is written in.
    pub algebra: u64,
    /// The tokens of the block.
    pub block: TokenStream,
    /// The name of the function where it is used, and its name in its own block.
    pub names: TokenStream,
    /// The functions that use it, as [`parse_pending`] reads them.
    pub rest: TokenStream,
}

/// Reads `{ algebra block } (name original) rest`.
///
/// # Errors
/// The tokens have another shape.
pub fn parse_import(tokens: TokenStream) -> Result<Imported> {
    check_brackets(&tokens)?;
    let parser = |input: ParseStream<'_>| {
        let (block, names);
        braced!(block in input);
        syn::parenthesized!(names in input);
        let algebra: syn::LitInt = block.parse()?;
        Ok(Imported {
            algebra: algebra.base10_parse()?,
            block: block.parse()?,
            names: names.parse()?,
            rest: input.parse()?,
        })
    };
    parser.parse2(tokens)
}
