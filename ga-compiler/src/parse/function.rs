//! The grammar of functions in an algebra: `fn name(m: Motor, p: Point) -> Point { m * p *
//! m.reverse() }`.
//!
//! Products are `*` geometric, `^` wedge, `|` left contraction and `&` vee; everything else is a
//! method or a function of the same name: `reverse(m)`, `m.sandwich(p)`, `commutator(a, b)`. A
//! closure, `|m: Motor, p: Point| -> Point { … }`, is a function without a name.

use syn::ext::IdentExt;
use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::{
    Attribute, Ident, LitInt, Result, Token, Visibility, braced, bracketed, parenthesized, token,
};

use super::formula::Formula;

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
    /// What comes out.
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
    /// What is bound.
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
    syn::parse2(tokens)
}

/// Functions that may call each other, and others that they use.
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

/// `use path::of::function as name;`
pub struct UseSyntax {
    /// The path, whose macro hands the function over.
    pub path: syn::Path,
    /// The name of the function there.
    pub original: Ident,
    /// Its name here.
    pub name: Ident,
}

impl Parse for UseSyntax {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        input.parse::<Token![use]>()?;
        let path = input.call(syn::Path::parse_mod_style)?;
        let Some(last) = path.segments.last() else {
            return Err(input.error("expected the path of a function"));
        };
        let original = last.ident.clone();
        let name = if input.peek(Token![as]) {
            input.parse::<Token![as]>()?;
            input.parse()?
        } else {
            original.clone()
        };
        input.parse::<Token![;]>()?;
        Ok(Self {
            path,
            original,
            name,
        })
    }
}

/// Reads a leading `use`, if there is one, and gives what follows it.
///
/// # Errors
/// The tokens start with `use` and go on in another way.
pub fn parse_use(
    tokens: proc_macro2::TokenStream,
) -> Result<(Option<UseSyntax>, proc_macro2::TokenStream)> {
    let parser = |input: ParseStream<'_>| {
        let first = input.peek(Token![use]).then(|| input.parse());
        Ok((first.transpose()?, input.parse()?))
    };
    syn::parse::Parser::parse2(parser, tokens)
}

/// Reads any number of functions.
///
/// # Errors
/// As for one; none at all is an error too.
pub fn parse_functions(tokens: proc_macro2::TokenStream) -> Result<Vec<FunctionSyntax>> {
    let parser = |input: ParseStream<'_>| {
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
                let message = format!("`{name}` is a function of this block already");
                return Err(syn::Error::new(name.span(), message));
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
            let list;
            parenthesized!(list in input);
            (name, Punctuated::<_, Token![,]>::parse_terminated(&list)?)
        };
        input.parse::<Token![->]>()?;
        let result = input.parse()?;
        let block;
        braced!(block in input);
        let mut statements = Vec::new();
        while block.peek(Token![let]) {
            statements.push(block.parse()?);
        }
        if block.is_empty() {
            return Err(block.error("the body ends with the formula of its result"));
        }
        let value = Formula::parse(&block)?;
        if block.peek(Token![;]) {
            return Err(block.error("the formula of the result comes last, without `;`; what comes before are `let` statements"));
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
        let first = input.call(Ident::parse_any)?;
        let is_uniform = first == "uniform" && !input.peek(Token![:]);
        let name = if is_uniform { input.parse()? } else { first };
        input.parse::<Token![:]>()?;
        Ok(Self {
            name,
            shape: input.parse()?,
            is_uniform,
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
                    "every element is compiled by itself; arrays have at most {MAX_LENGTH}"
                );
                return Err(syn::Error::new(count.span(), message));
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
        input.parse().map(Self::Name)
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
            return Err(input.error("names are bound once here; leave out `mut`"));
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
