//! The declaration of a type: its blades or parameters, its hull and its facts.

use proc_macro2::TokenTree;
use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::{Attribute, Error, Expr, Ident, Result, Token, braced};

use super::formula::Formula;
use super::name::{name, value_after_equals};

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
