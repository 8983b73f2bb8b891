//! `use path::of::function;` at the start of a block: functions of other blocks.

use proc_macro2::TokenStream;
use quote::quote;
use syn::ext::IdentExt;
use syn::parse::{Parse, ParseStream, Parser};
use syn::punctuated::Punctuated;
use syn::{Ident, Path, PathSegment, Result, Token, braced, token};

use super::nesting::check_brackets;

/// A function of another block that is used: `use path::of::function as name;`.
pub struct UseSyntax {
    /// The path, whose macro hands the function over.
    pub path: Path,
    /// The name of the function there.
    pub original: Ident,
    /// Its name here.
    pub name: Ident,
}

/// Reads the first function of a leading `use`, if there is one, and gives what follows it. The
/// other functions of a `use path::{first, second};` are given back as a `use` of their own.
///
/// # Errors
/// The tokens start with `use` and go on in another way.
pub fn parse_use(tokens: TokenStream) -> Result<(Option<UseSyntax>, TokenStream)> {
    check_brackets(&tokens)?;
    let parser = |input: ParseStream<'_>| {
        let mut used = Vec::new();
        // An empty `use path::{};` uses nothing.
        while used.is_empty() && input.peek(Token![use]) {
            used = input.parse::<Uses>()?.0;
        }
        let rest: TokenStream = input.parse()?;
        let mut used = used.into_iter();
        let first = used.next();
        let others = used.map(|UseSyntax { path, name, .. }| quote! { use #path as #name; });
        Ok((first, quote! { #(#others)* #rest }))
    };
    parser.parse2(tokens)
}

/// All functions of one `use`.
struct Uses(Vec<UseSyntax>);

impl Parse for Uses {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        input.parse::<Token![use]>()?;
        let path = Path {
            leading_colon: input.parse()?,
            segments: Punctuated::new(),
        };
        let mut used = Vec::new();
        parse_tree(input, path, &mut used)?;
        if !input.peek(Token![;]) {
            return Err(input.error("expected the `;` that ends a `use`"));
        }
        input.parse::<Token![;]>()?;
        Ok(Self(used))
    }
}

/// Reads what follows a path: names up to a function, or a list in braces of such.
fn parse_tree(input: ParseStream<'_>, mut path: Path, used: &mut Vec<UseSyntax>) -> Result<()> {
    loop {
        if input.peek(token::Brace) {
            let list;
            braced!(list in input);
            while !list.is_empty() {
                parse_tree(&list, path.clone(), used)?;
                if !list.is_empty() {
                    list.parse::<Token![,]>()?;
                }
            }
            return Ok(());
        }
        if input.peek(Token![*]) {
            return Err(input.error("a `use` in `ga!` names each function; `*` is not possible"));
        }
        let name = input.call(Ident::parse_any)?;
        path.segments.push(PathSegment::from(name.clone()));
        if input.peek(Token![::]) {
            path.segments.push_punct(input.parse()?);
            continue;
        }
        let here = if input.peek(Token![as]) {
            input.parse::<Token![as]>()?;
            input.parse()?
        } else {
            name.clone()
        };
        used.push(UseSyntax {
            path,
            original: name,
            name: here,
        });
        return Ok(());
    }
}

#[cfg(test)]
mod tests {
    use quote::ToTokens;

    use super::*;

    /// The paths that are used, with their names here, and what follows.
    fn read(tokens: TokenStream) -> Result<(Vec<[String; 2]>, String)> {
        let (mut found, mut rest) = (Vec::new(), tokens);
        loop {
            let (first, follows) = parse_use(rest)?;
            rest = follows;
            let Some(first) = first else {
                return Ok((found, rest.to_string()));
            };
            let path = first.path.to_token_stream().to_string().replace(' ', "");
            assert!(path.ends_with(&first.original.to_string()));
            found.push([path, first.name.to_string()]);
        }
    }

    #[test]
    fn a_use_may_name_several_functions() {
        let source = quote! {
            use a::{f, g as h, b::{i, c::j},};
            use ::k::l;
            use n::{};
            use crate::m as o;
            fn p() -> Scalar { 1 }
        };
        let (used, rest) = read(source).expect("sound");
        let expected = [
            ["a::f", "f"],
            ["a::g", "h"],
            ["a::b::i", "i"],
            ["a::b::c::j", "j"],
            ["::k::l", "l"],
            ["crate::m", "o"],
        ];
        assert_eq!(used, expected);
        assert_eq!(rest, quote! { fn p() -> Scalar { 1 } }.to_string());
    }

    #[test]
    fn faulty_uses_are_refused() {
        for (source, message) in [
            (quote! { use a::*; }, "`*` is not possible"),
            (
                quote! { use a::f fn g() -> Scalar { 1 } },
                "expected the `;`",
            ),
            (quote! { use a::{f g}; }, "expected `,`"),
            (quote! { use a::; }, "expected ident"),
        ] {
            let error = read(source).expect_err("faulty").to_string();
            assert!(error.contains(message), "{error}");
        }
    }
}
