//! The basis vectors of an algebra and their inner products.

use proc_macro2::Span;
use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::{Error, Expr, Ident, LitInt, Result, Token};

use super::name::{name, value_after_equals};
use super::nesting::check_expression;

mod keyword {
    syn::custom_keyword!(basis);
    syn::custom_keyword!(metric);
    syn::custom_keyword!(signature);
}

/// The names of the basis vectors.
pub struct BasisSyntax {
    /// In the order of the bits of a blade.
    pub names: Vec<Ident>,
    /// For each the square that stands beside it.
    pub squares: Vec<Option<Expr>>,
}

/// The inner products of the basis vectors.
pub enum MetricSyntax {
    /// Nothing beyond the squares beside the names.
    Squares,
    /// Entry by entry; products that are not stated are zero.
    Entries(Vec<MetricEntrySyntax>),
    /// Squares of 1, −1 and 0.
    Signature([usize; 3], Span),
}

/// One inner product.
pub struct MetricEntrySyntax {
    /// One basis vector.
    pub left: Ident,
    /// The other basis vector, or the same.
    pub right: Ident,
    /// Their inner product.
    pub value: Expr,
}

impl Parse for BasisSyntax {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        input.parse::<keyword::basis>()?;
        let vector = |input: ParseStream<'_>| {
            let name = name(input, "a basis vector")?;
            Ok((name, value_after_equals(input)?))
        };
        let vectors = Punctuated::<_, Token![,]>::parse_separated_nonempty_with(input, vector)?;
        input.parse::<Token![;]>()?;
        let (names, squares) = vectors.into_iter().unzip();
        Ok(Self { names, squares })
    }
}

impl MetricSyntax {
    /// Whether the inner products follow.
    pub(super) fn peek(input: ParseStream<'_>) -> bool {
        input.peek(keyword::metric) || input.peek(keyword::signature)
    }
}

impl Parse for MetricSyntax {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        if input.peek(keyword::signature) {
            let keyword: keyword::signature = input.parse()?;
            let mut counts = [0; 3];
            for (place, count) in counts.iter_mut().enumerate() {
                if place > 0 && !input.peek(Token![;]) {
                    input.parse::<Token![,]>()?;
                } else if place > 0 {
                    break;
                }
                *count = input.parse::<LitInt>()?.base10_parse()?;
            }
            input.parse::<Token![;]>()?;
            return Ok(Self::Signature(counts, keyword.span));
        }
        input.parse::<keyword::metric>().map_err(|error| {
            Error::new(
                error.span(),
                "expected `metric` or `signature` after the basis, \
                 or the square beside each vector, as in `basis e0 = 0, e1 = 1;`",
            )
        })?;
        let mut entries = Vec::new();
        while !input.peek(Token![;]) {
            let left = input.parse()?;
            input.parse::<Token![*]>()?;
            let right = input.parse()?;
            input.parse::<Token![=]>()?;
            check_expression(input)?;
            let value = input.parse()?;
            entries.push(MetricEntrySyntax { left, right, value });
            if !input.peek(Token![;]) {
                input.parse::<Token![,]>()?;
            }
        }
        input.parse::<Token![;]>()?;
        Ok(Self::Entries(entries))
    }
}
