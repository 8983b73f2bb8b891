//! The names that a declaration would declare, which can be read even where it is faulty.

use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;
use syn::parse::{ParseStream, Parser};
use syn::{Attribute, Ident, Result, Token, Visibility, braced};

use super::nesting::check_brackets;

/// The parts of a declaration that can be read wherever it starts like a module.
pub struct Outline {
    /// Doc comments and other attributes of the module.
    pub attributes: Vec<Attribute>,
    /// The visibility of the module.
    pub visibility: Visibility,
    /// The name of the module.
    pub name: Ident,
    /// The names of the types, each once.
    pub types: Vec<Ident>,
}

/// Reads the outline of a declaration.
///
/// # Errors
/// The tokens do not start like a module.
pub fn parse_outline(tokens: TokenStream) -> Result<Outline> {
    check_brackets(&tokens)?;
    let parser = |input: ParseStream<'_>| {
        let attributes = input.call(Attribute::parse_outer)?;
        let visibility = input.parse()?;
        input.parse::<Token![mod]>()?;
        let name = input.parse()?;
        let body;
        braced!(body in input);
        let body: TokenStream = body.parse()?;
        input.parse::<TokenStream>()?;
        Ok(Outline {
            attributes,
            visibility,
            name,
            types: types(body),
        })
    };
    parser.parse2(tokens)
}

fn types(body: TokenStream) -> Vec<Ident> {
    let tokens: Vec<TokenTree> = body.into_iter().collect();
    let mut names = Vec::new();
    for pair in tokens.windows(2) {
        if let [TokenTree::Ident(keyword), name] = pair
            && keyword == "struct"
            // A keyword cannot be the name of an item.
            && let Ok(name) = syn::parse2::<Ident>(name.to_token_stream())
            && !names.contains(&name)
        {
            names.push(name);
        }
    }
    names
}
