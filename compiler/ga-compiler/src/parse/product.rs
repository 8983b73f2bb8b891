//! One line of the products: an operation, the types of its operands, and that of its result.

use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::{Ident, Result, Token, braced};

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
