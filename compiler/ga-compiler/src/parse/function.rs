//! The grammar of functions in an algebra:
//! `fn name(m: Motor, p: Point) -> Point { m * p * m.reverse() }`.
//!
//! Products are `*` geometric, `^` wedge, `|` left contraction and `&` vee; every other operation
//! is a method and a function of the same name: `reverse(m)`, `m.sandwich(p)`, `commutator(a, b)`.
//! A closure, `|m: Motor, p: Point| -> Point { … }`, is a function without a name.

use syn::ext::IdentExt;
use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::{
    Attribute, Error, Ident, LitInt, Result, Token, Visibility, braced, bracketed, parenthesized,
    token,
};

use super::formula::Formula;
use super::nesting::check_brackets;

/// The longest array.
const MAX_LENGTH: usize = 1024;

/// A function: operands with their types, the type of the result, and the body.
#[derive(Clone)]
pub struct FunctionSyntax {
    /// Doc comments and other attributes.
    pub attributes: Vec<Attribute>,
    /// The visibility.
    pub visibility: Visibility,
    /// The name; a closure has none.
    pub name: Option<Ident>,
    /// The operands.
    pub operands: Vec<OperandSyntax>,
    /// The type of the result.
    pub result: ShapeSyntax,
    /// The `let` statements.
    pub statements: Vec<LetSyntax>,
    /// The formula of the result.
    pub value: Formula,
}

/// An operand.
#[derive(Clone)]
pub struct OperandSyntax {
    /// Its name.
    pub name: Ident,
    /// Its type.
    pub shape: ShapeSyntax,
    /// Whether it is marked `uniform`.
    pub is_uniform: bool,
    /// Whether it is marked `blade`: the caller makes sure that it is one.
    pub is_blade: bool,
}

/// A type: one of the algebra or `Scalar`, an array or a tuple.
#[derive(Clone)]
pub enum ShapeSyntax {
    /// A name.
    Name(Ident),
    /// `[T; 3]`.
    Array(Box<ShapeSyntax>, usize),
    /// `(T, U)`.
    Tuple(Vec<ShapeSyntax>),
}

/// `let pattern: Type = formula;`
#[derive(Clone)]
pub struct LetSyntax {
    /// The names that are bound.
    pub pattern: PatternSyntax,
    /// The type that the value must have.
    pub shape: Option<ShapeSyntax>,
    /// The value.
    pub value: Formula,
}

/// The left side of a `let`.
#[derive(Clone)]
pub enum PatternSyntax {
    /// A name.
    Name(Ident),
    /// `_`.
    Wildcard,
    /// `(a, b)` or `[a, b]`.
    Parts(proc_macro2::Span, Vec<PatternSyntax>),
}

/// Reads one function.
///
/// # Errors
/// The first place where the tokens leave the grammar, or a mix of operators without parentheses.
pub fn parse_function(tokens: proc_macro2::TokenStream) -> Result<FunctionSyntax> {
    check_brackets(&tokens)?;
    syn::parse2(tokens)
}

/// Functions that may call each other, and functions of other blocks that they may call.
#[derive(Clone, Default)]
pub struct Block {
    /// The functions.
    pub functions: Vec<FunctionSyntax>,
    /// Functions of other blocks.
    pub imports: Vec<Import>,
}

/// A function of another block.
#[derive(Clone)]
pub struct Import {
    /// Its name here.
    pub name: Ident,
    /// Its name there.
    pub original: Ident,
    /// The block that it stands in.
    pub block: Block,
}

impl Block {
    /// The function of that name, here or imported, and the block in which its own names have their
    /// meaning.
    #[must_use]
    pub fn function(&self, name: &str) -> Option<(&FunctionSyntax, &Self)> {
        let named = |block: &'_ Self, name: &str| {
            let is_named =
                |function: &FunctionSyntax| function.name.as_ref().is_some_and(|n| n == name);
            block.functions.iter().position(is_named)
        };
        if let Some(place) = named(self, name) {
            return Some((&self.functions[place], self));
        }
        let import = self.imports.iter().find(|import| import.name == name)?;
        let place = named(&import.block, &import.original.to_string())?;
        Some((&import.block.functions[place], &import.block))
    }

    /// The names of all functions that may be called here.
    pub fn names(&self) -> impl Iterator<Item = String> {
        let own = self
            .functions
            .iter()
            .filter_map(|function| function.name.as_ref());
        let imported = self.imports.iter().map(|import| &import.name);
        own.chain(imported).map(ToString::to_string)
    }
}

/// Reads a block as its macro hands it over: imports in brackets, `(name original { block })` each,
/// then the functions.
impl Parse for Block {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let mut imports = Vec::new();
        if input.peek(token::Bracket) {
            let list;
            bracketed!(list in input);
            while !list.is_empty() {
                let (import, block);
                parenthesized!(import in list);
                let (name, original) = (import.parse()?, import.parse()?);
                braced!(block in import);
                imports.push(Import {
                    name,
                    original,
                    block: block.parse()?,
                });
            }
        }
        Ok(Self {
            imports,
            functions: parse_functions(input.parse()?)?,
        })
    }
}

/// Reads one or more functions.
///
/// # Errors
/// As for one; also where there is no function, or two of the same name.
pub fn parse_functions(tokens: proc_macro2::TokenStream) -> Result<Vec<FunctionSyntax>> {
    check_brackets(&tokens)?;
    let parser = |input: ParseStream<'_>| {
        if input.is_empty() {
            let message = "there is no function here; write one as \
                           `fn name(p: Point, q: Point) -> Scalar { p | q }`";
            return Err(Error::new(input.span(), message));
        }
        let mut functions = vec![input.parse()?];
        while !input.is_empty() {
            if input.peek(Token![use]) {
                return Err(input.error("`use` comes before the functions"));
            }
            let function: FunctionSyntax = input.parse()?;
            if let Some(name) = &function.name
                && functions
                    .iter()
                    .any(|other: &FunctionSyntax| other.name.as_ref() == Some(name))
            {
                let message = format!("this block already has a function `{name}`");
                return Err(Error::new(name.span(), message));
            }
            functions.push(function);
        }
        Ok(functions)
    };
    syn::parse::Parser::parse2(parser, tokens)
}

impl Parse for FunctionSyntax {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let attributes = input.call(Attribute::parse_outer)?;
        let visibility = input.parse()?;
        let (name, operands) = if input.peek(Token![||]) {
            input.parse::<Token![||]>()?;
            (None, Punctuated::new())
        } else if input.peek(Token![|]) {
            input.parse::<Token![|]>()?;
            let list = Punctuated::<_, Token![,]>::parse_separated_nonempty(input)?;
            input.parse::<Token![|]>()?;
            (None, list)
        } else {
            let name = if input.peek(token::Paren) {
                None
            } else {
                input.parse::<Token![fn]>()?;
                Some(input.parse()?)
            };
            if input.peek(Token![<]) {
                return Err(input.error(
                    "functions are generic over the scalar by themselves: \
                     leave out `<…>`, and write `Scalar` for the type of a plain number",
                ));
            }
            let list;
            parenthesized!(list in input);
            (name, Punctuated::<_, Token![,]>::parse_terminated(&list)?)
        };
        if !input.peek(Token![->]) {
            return Err(input.error("expected `->` and the type of the result"));
        }
        input.parse::<Token![->]>()?;
        let result = input.parse()?;
        let block;
        braced!(block in input);
        let mut statements = Vec::new();
        while block.peek(Token![let]) {
            statements.push(block.parse()?);
        }
        if block.is_empty() {
            return Err(block.error("the body must end with the formula of the result"));
        }
        let value = Formula::parse(&block)?;
        if block.peek(Token![;]) {
            return Err(block.error(
                "the formula of the result comes last, without `;`; \
                 only `let` statements may stand before it",
            ));
        }
        if !block.is_empty() {
            return Err(block.error("expected an operator or the end of the formula"));
        }
        Ok(Self {
            attributes,
            visibility,
            name,
            operands: operands.into_iter().collect(),
            result,
            statements,
            value,
        })
    }
}

impl Parse for OperandSyntax {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let (mut is_uniform, mut is_blade) = (false, false);
        // A mark is a name before another name.
        let name = loop {
            let name = input.call(Ident::parse_any)?;
            if input.peek(Token![:]) {
                break name;
            }
            match name.to_string().as_str() {
                "uniform" if !is_uniform => is_uniform = true,
                "blade" if !is_blade => is_blade = true,
                _ => {
                    let message = format!(
                        "expected `:` and the type of `{name}`; \
                         `uniform` and `blade` may stand before the name of an operand, once each"
                    );
                    return Err(Error::new(name.span(), message));
                }
            }
        };
        input.parse::<Token![:]>()?;
        Ok(Self {
            name,
            shape: input.parse()?,
            is_uniform,
            is_blade,
        })
    }
}

impl Parse for ShapeSyntax {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        if input.peek(token::Bracket) {
            let inner;
            bracketed!(inner in input);
            let element = inner.parse()?;
            inner.parse::<Token![;]>()?;
            let count: LitInt = inner.parse()?;
            let length: usize = count.base10_parse()?;
            if length > MAX_LENGTH {
                let message = format!(
                    "each element is compiled separately; an array has at most {MAX_LENGTH}"
                );
                return Err(Error::new(count.span(), message));
            }
            return Ok(Self::Array(Box::new(element), length));
        }
        if input.peek(token::Paren) {
            let inner;
            parenthesized!(inner in input);
            let parts = Punctuated::<_, Token![,]>::parse_terminated(&inner)?;
            let parts: Punctuated<Self, Token![,]> = parts;
            return Ok(Self::Tuple(parts.into_iter().collect()));
        }
        if input.peek(Token![&]) {
            return Err(input.error("values are passed without references here; leave out the `&`"));
        }
        let name: Ident = input.parse()?;
        if input.peek(Token![<]) {
            return Err(input.error(format!(
                "functions are generic over the scalar by themselves: write `{name}` without `<…>`"
            )));
        }
        if input.peek(Token![::]) {
            return Err(
                input.error("types of the algebra are written by their name alone, without a path")
            );
        }
        Ok(Self::Name(name))
    }
}

impl Parse for LetSyntax {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        input.parse::<Token![let]>()?;
        let pattern = input.parse()?;
        let shape = if input.peek(Token![:]) {
            input.parse::<Token![:]>()?;
            Some(input.parse()?)
        } else {
            None
        };
        input.parse::<Token![=]>()?;
        let value = Formula::parse(input)?;
        if !input.peek(Token![;]) {
            return Err(input.error("expected an operator, or the `;` that ends a `let` statement"));
        }
        input.parse::<Token![;]>()?;
        Ok(Self {
            pattern,
            shape,
            value,
        })
    }
}

impl Parse for PatternSyntax {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        if input.peek(Token![_]) {
            input.parse::<Token![_]>()?;
            return Ok(Self::Wildcard);
        }
        if input.peek(Token![mut]) {
            return Err(input.error("names are bound only once here; leave out `mut`"));
        }
        let parts;
        let span = if input.peek(token::Paren) {
            parenthesized!(parts in input).span.join()
        } else if input.peek(token::Bracket) {
            bracketed!(parts in input).span.join()
        } else {
            return input.parse().map(Self::Name);
        };
        let list = Punctuated::<Self, Token![,]>::parse_terminated(&parts)?;
        Ok(Self::Parts(span, list.into_iter().collect()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_say_what_to_write_instead() {
        for (source, message) in [
            ("", "there is no function here"),
            ("fn f<S>(a: Scalar) -> Scalar { a }", "leave out `<…>`"),
            ("fn f(a: &Point) -> Scalar { a }", "leave out the `&`"),
            ("fn f(a: Point) -> &Point { a }", "leave out the `&`"),
            (
                "fn f(a: Point<f64>) -> Scalar { a }",
                "write `Point` without `<…>`",
            ),
            ("fn f(a: cga3::Point) -> Scalar { a }", "without a path"),
            (
                "fn f(a: Scalar) -> Scalar { let b = a b }",
                "the `;` that ends a `let`",
            ),
            (
                "fn f(a: Scalar) -> Scalar { a; }",
                "comes last, without `;`",
            ),
            (
                "fn f(a: Scalar) -> Scalar { let b = a; }",
                "must end with the formula",
            ),
        ] {
            let tokens = source.parse().expect("tokens");
            let error = parse_functions(tokens).err().expect("faulty").to_string();
            assert!(error.contains(message), "{source}: {error}");
        }
    }
}
