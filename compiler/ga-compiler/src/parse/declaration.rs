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

use proc_macro2::{Delimiter, Span, TokenStream, TokenTree};
use syn::ext::IdentExt;
use syn::parse::discouraged::Speculative;
use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::{Attribute, Error, Expr, Ident, LitInt, Path, Result, Token, Visibility, braced};

use super::formula::Formula;
use super::nesting::{check_brackets, check_expression};
use crate::diag::Diagnostics;

mod keyword {
    syn::custom_keyword!(basis);
    syn::custom_keyword!(metric);
    syn::custom_keyword!(signature);
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

/// One type.
pub struct TypeSyntax {
    /// Doc comments.
    pub docs: Vec<Attribute>,
    /// The type that sums and multiples have.
    pub hull: Option<Ident>,
    /// What every member satisfies.
    pub facts: Vec<FactSyntax>,
    /// The name.
    pub name: Ident,
    /// The blades.
    pub coefficients: Vec<CoefficientSyntax>,
    /// What members are stored as, where that is not the coefficients of blades.
    pub parameters: Option<ParametersSyntax>,
}

/// The parameters of a type.
pub struct ParametersSyntax {
    /// Their names, with their types where they are not numbers.
    pub list: Vec<(Ident, Option<Ident>)>,
    /// The multivector.
    pub value: Formula,
    /// How parameters are read of it.
    pub readings: Vec<ReadingSyntax>,
}

/// A formula for a parameter, or for a value between.
pub struct ReadingSyntax {
    /// Whether `let` stands before it.
    pub is_let: bool,
    /// The name.
    pub name: Ident,
    /// The formula.
    pub value: Formula,
}

/// One fact.
pub struct FactSyntax {
    /// Its name.
    pub name: Ident,
    /// The blade that a weight refers to.
    pub blade: Option<Ident>,
}

/// One blade of a type.
pub struct CoefficientSyntax {
    /// The blade as written.
    pub blade: Ident,
    /// The constant or polynomial that its coefficient is; none for a stored one.
    pub value: Option<Expr>,
}

/// One line of the products.
pub struct ProductSyntax {
    /// The name of the operation.
    pub operation: Ident,
    /// The types of each operand.
    pub operands: Vec<Vec<OperandTypeSyntax>>,
    /// The type of the result; `Self` stands for the type of the last operand.
    pub result: Option<Ident>,
}

/// A type of an operand.
pub struct OperandTypeSyntax {
    /// Its name.
    pub name: Ident,
    /// Whether it is marked `blade`: the caller makes sure that the operand is one.
    pub is_blade: bool,
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
    fn peek(input: ParseStream<'_>) -> bool {
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

impl Parse for TypeSyntax {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let (mut docs, mut hull, mut facts) = (Vec::new(), None, Vec::new());
        for attribute in input.call(Attribute::parse_outer)? {
            let path = attribute.path();
            if path.is_ident("doc") {
                docs.push(attribute);
            } else if path.is_ident("hull") {
                if hull.is_some() {
                    return Err(Error::new_spanned(path, "a type has only one hull"));
                }
                hull = Some(attribute.parse_args()?);
            } else if path.is_ident("facts") {
                let list = attribute
                    .parse_args_with(Punctuated::<FactSyntax, Token![,]>::parse_terminated)?;
                facts.extend(list);
            } else {
                return Err(Error::new_spanned(
                    path,
                    "expected a doc comment, `hull` or `facts`",
                ));
            }
        }
        if input.peek(Token![pub]) {
            return Err(input.error("the types of an algebra are public; leave out `pub`"));
        }
        if !input.peek(Token![struct]) {
            return Err(input.error("expected a `struct` of blades, or `products`"));
        }
        input.parse::<Token![struct]>()?;
        let name = name(input, "a type")?;
        let body;
        braced!(body in input);
        let parameters = match has_parameters(&body) {
            true => Some(body.parse()?),
            false => None,
        };
        let coefficients = Punctuated::<CoefficientSyntax, Token![,]>::parse_terminated(&body)?;
        Ok(Self {
            parameters,
            docs,
            hull,
            facts,
            name,
            coefficients: coefficients.into_iter().collect(),
        })
    }
}

/// Whether a semicolon stands in the braces of a type.
fn has_parameters(body: ParseStream<'_>) -> bool {
    let ahead = body.fork();
    while let Ok(token) = ahead.parse::<TokenTree>() {
        if matches!(token, TokenTree::Punct(punct) if punct.as_char() == ';') {
            return true;
        }
    }
    false
}

impl Parse for ParametersSyntax {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let mut list = Vec::new();
        while !input.peek(Token![;]) {
            let name = name(input, "a parameter")?;
            let kind = if input.peek(Token![:]) {
                input.parse::<Token![:]>()?;
                Some(input.parse()?)
            } else {
                None
            };
            list.push((name, kind));
            if !input.peek(Token![;]) {
                input.parse::<Token![,]>()?;
            }
        }
        input.parse::<Token![;]>()?;
        if !input.peek(Token![self]) {
            return Err(input.error("expected `self = …;`, the multivector of the parameters"));
        }
        input.parse::<Token![self]>()?;
        input.parse::<Token![=]>()?;
        let value = Formula::parse(input)?;
        input.parse::<Token![;]>()?;
        let mut readings = Vec::new();
        while !input.is_empty() {
            let is_let = input.peek(Token![let]);
            if is_let {
                input.parse::<Token![let]>()?;
            }
            let name = name(input, "a parameter")?;
            input.parse::<Token![=]>()?;
            let value = Formula::parse(input)?;
            input.parse::<Token![;]>()?;
            readings.push(ReadingSyntax {
                is_let,
                name,
                value,
            });
        }
        Ok(Self {
            list,
            value,
            readings,
        })
    }
}

impl Parse for FactSyntax {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let name = input.parse()?;
        let blade = if input.peek(syn::token::Paren) {
            let body;
            syn::parenthesized!(body in input);
            Some(body.parse()?)
        } else {
            None
        };
        Ok(Self { name, blade })
    }
}

impl Parse for CoefficientSyntax {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let blade = name(
            input,
            "a blade; name it with its basis vectors in another order",
        )?;
        let value = value_after_equals(input)?;
        Ok(Self { blade, value })
    }
}

impl Parse for OperandTypeSyntax {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let name: Ident = input.parse()?;
        if name == "blade" && input.peek(Ident) {
            return Ok(Self {
                name: input.parse()?,
                is_blade: true,
            });
        }
        Ok(Self {
            name,
            is_blade: false,
        })
    }
}

impl Parse for ProductSyntax {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let operation = input.parse()?;
        let body;
        syn::parenthesized!(body in input);
        let mut operands = Vec::new();
        while !body.is_empty() {
            if body.peek(syn::token::Brace) {
                let list;
                braced!(list in body);
                let names = Punctuated::<OperandTypeSyntax, Token![,]>::parse_terminated(&list)?;
                if names.is_empty() {
                    return Err(list.error("expected a type"));
                }
                operands.push(names.into_iter().collect());
            } else {
                operands.push(vec![body.parse()?]);
            }
            if !body.is_empty() {
                body.parse::<Token![,]>()?;
            }
        }
        let result = if input.peek(Token![->]) {
            input.parse::<Token![->]>()?;
            Some(if input.peek(Token![Self]) {
                Ident::from(input.parse::<Token![Self]>()?)
            } else {
                input.parse()?
            })
        } else {
            None
        };
        input.parse::<Token![;]>()?;
        Ok(Self {
            operation,
            operands,
            result,
        })
    }
}

/// Reads `= value`, where it follows.
fn value_after_equals(input: ParseStream<'_>) -> Result<Option<Expr>> {
    if !input.peek(Token![=]) {
        return Ok(None);
    }
    input.parse::<Token![=]>()?;
    check_expression(input)?;
    input.parse().map(Some)
}

/// Reads a name; `what` says what it is for, in case it is a keyword.
fn name(input: ParseStream<'_>, what: &str) -> Result<Ident> {
    if !input.peek(Ident)
        && let Ok(keyword) = input.fork().call(Ident::parse_any)
    {
        let message = format!("`{keyword}` is a keyword of Rust and cannot be the name of {what}");
        return Err(input.error(message));
    }
    input.parse()
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

/// Reads a declaration.
///
/// # Errors
/// The places where the tokens leave the grammar: the first in the head, and the first in each type
/// and product.
pub fn parse_declaration(tokens: TokenStream) -> Result<DeclarationSyntax> {
    check_brackets(&tokens)?;
    syn::parse2(tokens)
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
