//! The grammar of `algebra!`.
//!
//! ```text
//! declaration  = docs visibility "mod" name "{" [ "crate" "=" path ";" ] basis metric item* "}"
//! basis        = "basis" vector ("," vector)* ";"
//! vector       = name [ "=" square ]
//! metric       = [ "metric" [ entry ("," entry)* ] ";" ] | "signature" p "," q "," r ";"
//! entry        = name "*" name "=" number
//! item         = type | products
//! type         = docs attribute* "struct" name "{" (coefficient* | parameters) "}"
//! attribute    = "#[hull(" type ")]" | "#[facts(" fact ("," fact)* ")]"
//! coefficient  = blade [ "=" (number | polynomial in the type's stored blades) ] ","
//! parameters   = parameter ("," parameter)* ";" "self" "=" formula ";" reading*
//! parameter    = name [ ":" type ]
//! reading      = ["let"] name "=" formula ";"
//! fact         = "unit_versor" | "null" | "blade" | "weight" "(" blade ")"
//! products     = "products" "{" product* "}"
//! product      = operation "(" operands ["," operands] ")" [ "->" type ] ";"
//! operands     = operand | "{" operand ("," operand)* "}"
//! operand      = ["blade"] type
//! ```

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use syn::parse::discouraged::Speculative;
use syn::parse::{Parse, ParseStream};
use syn::{Attribute, Ident, Path, Result, Token, Visibility, braced};

use super::basis::{BasisSyntax, MetricSyntax};
use super::nesting::check_brackets;
use super::product::ProductSyntax;
use super::type_declaration::TypeSyntax;
use crate::diag::Diagnostics;

mod keyword {
    syn::custom_keyword!(products);
}

/// A whole declaration.
pub struct DeclarationSyntax {
    /// Doc comments and other attributes of the module.
    pub attributes: Vec<Attribute>,
    /// The visibility of the module.
    pub visibility: Visibility,
    /// The name of the module and of the algebra.
    pub name: Ident,
    /// Where ga-runtime is found, if the declaration says so.
    pub runtime: Option<Path>,
    /// The basis vectors.
    pub basis: BasisSyntax,
    /// Their inner products.
    pub metric: MetricSyntax,
    /// The types.
    pub types: Vec<TypeSyntax>,
    /// The products to emit.
    pub products: Vec<ProductSyntax>,
}

/// Reads a declaration.
///
/// # Errors
/// The places where the tokens leave the grammar: the first in the head, and the first in each type
/// and product.
pub fn parse_declaration(tokens: TokenStream) -> Result<DeclarationSyntax> {
    check_brackets(&tokens)?;
    syn::parse2(tokens)
}

impl Parse for DeclarationSyntax {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let attributes = input.call(Attribute::parse_outer)?;
        let visibility = input.parse()?;
        input.parse::<Token![mod]>()?;
        let name = input.parse()?;
        let body;
        braced!(body in input);
        if !input.is_empty() {
            return Err(input.error("nothing may follow the module of the algebra"));
        }
        let runtime = if body.peek(Token![crate]) {
            body.parse::<Token![crate]>()?;
            body.parse::<Token![=]>()?;
            let path = Path::parse_mod_style(&body)?;
            body.parse::<Token![;]>()?;
            Some(path)
        } else {
            None
        };
        let basis: BasisSyntax = body.parse()?;
        let metric = if basis.squares.iter().any(Option::is_some) && !MetricSyntax::peek(&body) {
            MetricSyntax::Squares
        } else {
            body.parse()?
        };
        let (mut types, mut products) = (Vec::new(), Vec::new());
        let mut diagnostics = Diagnostics::default();
        while !body.is_empty() {
            if body.peek(keyword::products) && body.peek2(syn::token::Brace) {
                body.parse::<keyword::products>()?;
                let lines;
                braced!(lines in body);
                while !lines.is_empty() {
                    products.extend(parse_or_skip(&lines, &mut diagnostics));
                }
            } else {
                types.extend(parse_or_skip(&body, &mut diagnostics));
            }
        }
        diagnostics.into_result()?;
        Ok(Self {
            attributes,
            visibility,
            name,
            runtime,
            basis,
            metric,
            types,
            products,
        })
    }
}

/// Reads an item; where it leaves the grammar, the error is collected and the item is skipped.
fn parse_or_skip<T: Parse>(input: ParseStream<'_>, diagnostics: &mut Diagnostics) -> Option<T> {
    let attempt = input.fork();
    match attempt.parse() {
        Ok(item) => {
            input.advance_to(&attempt);
            Some(item)
        }
        Err(error) => {
            diagnostics.push(error);
            while let Ok(token) = input.parse::<TokenTree>() {
                let is_end = match token {
                    TokenTree::Group(group) => group.delimiter() == Delimiter::Brace,
                    TokenTree::Punct(punct) => punct.as_char() == ';',
                    _ => false,
                };
                if is_end {
                    break;
                }
            }
            None
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keywords_are_refused_as_names() {
        for (source, message) in [
            (
                "basis i, f; signature 2; struct B { if }",
                "`if` is a keyword of Rust and cannot be the name of a blade",
            ),
            (
                "basis fn, x; signature 2; struct V { x }",
                "`fn` is a keyword of Rust and cannot be the name of a basis vector",
            ),
            (
                "basis x; signature 1; struct dyn { x }",
                "`dyn` is a keyword of Rust and cannot be the name of a type",
            ),
        ] {
            let tokens = format!("mod v {{ {source} }}").parse().expect("tokens");
            let error = parse_declaration(tokens).err().expect("faulty").to_string();
            assert!(error.starts_with(message), "{error}");
        }
    }
}
