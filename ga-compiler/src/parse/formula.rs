//! Formulas as they are written: names, numbers, operators, calls.

use std::fmt;

use proc_macro2::{Span, TokenStream, TokenTree};
use quote::ToTokens;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::punctuated::Punctuated;
use syn::{Error, Ident, Lit, Result, Token, bracketed, parenthesized, token};

use crate::algebra::Ratio;

/// A formula with the place where it stands.
#[derive(Clone, Debug)]
pub struct Formula {
    /// What it is.
    pub kind: FormulaKind,
    start: Span,
    end: Span,
}

/// The forms of formulas.
#[derive(Clone, Debug)]
pub enum FormulaKind {
    /// An operand, a name bound by `let`, a blade or a constant type.
    Name(Ident),
    /// A number, exact as it is written.
    Number(Ratio),
    /// `-a`.
    Negative(Box<Formula>),
    /// `a * b` and the like.
    Binary(Operator, Box<Formula>, Box<Formula>),
    /// `f(a, b)` or `a.f(b)`.
    Call(Ident, Vec<Formula>),
    /// `a.e12`.
    Coefficient(Box<Formula>, Ident),
    /// `a[0]` or `a.0`.
    Element(Box<Formula>, usize),
    /// `(a)`.
    Parenthesised(Box<Formula>),
    /// `(a, b)`.
    Tuple(Vec<Formula>),
    /// `[a, b]`.
    Array(Vec<Formula>),
}

/// The operators, with the precedence that they have in Rust.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operator {
    /// `*`
    Multiply,
    /// `/`
    Divide,
    /// `+`
    Add,
    /// `-`
    Subtract,
    /// `&`
    And,
    /// `^`
    Xor,
    /// `|`
    Or,
}

impl Operator {
    const fn precedence(self) -> u8 {
        match self {
            Self::Multiply | Self::Divide => 5,
            Self::Add | Self::Subtract => 4,
            Self::And => 3,
            Self::Xor => 2,
            Self::Or => 1,
        }
    }

    const fn symbol(self) -> &'static str {
        match self {
            Self::Multiply => "*",
            Self::Divide => "/",
            Self::Add => "+",
            Self::Subtract => "-",
            Self::And => "&",
            Self::Xor => "^",
            Self::Or => "|",
        }
    }

    const fn is_bitwise(self) -> bool {
        matches!(self, Self::And | Self::Xor | Self::Or)
    }

    fn peek(input: ParseStream<'_>) -> Option<Self> {
        // Compound operators such as `||` or `&&` are no operators here.
        let doubled = input.peek(Token![||]) || input.peek(Token![&&]) || input.peek(Token![->]);
        if doubled {
            return None;
        }
        let operators = [
            (input.peek(Token![*]), Self::Multiply),
            (input.peek(Token![/]), Self::Divide),
            (input.peek(Token![+]), Self::Add),
            (input.peek(Token![-]), Self::Subtract),
            (input.peek(Token![&]), Self::And),
            (input.peek(Token![^]), Self::Xor),
            (input.peek(Token![|]), Self::Or),
        ];
        operators
            .into_iter()
            .find_map(|(is_next, operator)| is_next.then_some(operator))
    }

    fn parse(input: ParseStream<'_>) -> Result<()> {
        // One punctuation mark, whichever it is.
        let next: TokenTree = input.parse()?;
        drop(next);
        if input.peek(Token![=]) {
            return Err(input.error("assignments have no meaning here; bind a name with `let`"));
        }
        Ok(())
    }
}

impl Formula {
    /// Reads a formula.
    ///
    /// # Errors
    /// The tokens leave the grammar, or `^ & |` and `+ - * /` are mixed without parentheses.
    pub fn parse(input: ParseStream<'_>) -> Result<Self> {
        Self::parse_above(input, 0)
    }

    /// An error that points at the whole formula.
    #[must_use]
    pub fn error(&self, message: impl fmt::Display) -> Error {
        let ends = [self.start, self.end].map(|span| Ident::new("place", span));
        let mut tokens = TokenStream::new();
        ends[0].to_tokens(&mut tokens);
        ends[1].to_tokens(&mut tokens);
        Error::new_spanned(tokens, message)
    }

    fn parse_above(input: ParseStream<'_>, least: u8) -> Result<Self> {
        let mut left = Self::parse_prefix(input)?;
        while let Some(operator) = Operator::peek(input) {
            if operator.precedence() < least.max(1) {
                break;
            }
            Operator::parse(input)?;
            let right = Self::parse_above(input, operator.precedence() + 1)?;
            left = Self::combined(operator, left, right)?;
        }
        Ok(left)
    }

    fn combined(operator: Operator, left: Self, right: Self) -> Result<Self> {
        let mixed = |side: &Self| match &side.kind {
            FormulaKind::Binary(inner, a, b) if inner.is_bitwise() != operator.is_bitwise() => {
                Some((*inner, a.clone(), b.clone()))
            }
            _ => None,
        };
        let symbol = operator.symbol();
        let choices = if let Some((inner, a, b)) = mixed(&left) {
            let first = format!("({left}) {symbol} {right}");
            Some((
                first,
                format!("{a} {} ({b} {symbol} {right})", inner.symbol()),
            ))
        } else if let Some((inner, a, b)) = mixed(&right) {
            let first = format!("{left} {symbol} ({right})");
            Some((
                first,
                format!("({left} {symbol} {a}) {} {b}", inner.symbol()),
            ))
        } else {
            None
        };
        let (start, end) = (left.start, right.end);
        let kind = FormulaKind::Binary(operator, Box::new(left), Box::new(right));
        let whole = Self { kind, start, end };
        let Some((first, second)) = choices else {
            return Ok(whole);
        };
        Err(whole.error(format!(
            "`^ & |` bind looser than `+ - * /` in Rust: put in parentheses what you mean, \
             `{first}` (as Rust reads it) or `{second}`"
        )))
    }

    fn parse_prefix(input: ParseStream<'_>) -> Result<Self> {
        if input.peek(Token![-]) {
            let start = input.span();
            input.parse::<Token![-]>()?;
            let operand = Self::parse_prefix(input)?;
            let end = operand.end;
            return Ok(Self {
                kind: FormulaKind::Negative(Box::new(operand)),
                start,
                end,
            });
        }
        let mut formula = Self::parse_atom(input)?;
        loop {
            if input.peek(Token![.]) {
                formula = Self::parse_after_dot(formula, input)?;
            } else if input.peek(token::Bracket) {
                let index;
                let brackets = bracketed!(index in input);
                let place: syn::LitInt = index.parse()?;
                formula = Self {
                    start: formula.start,
                    end: brackets.span.close(),
                    kind: FormulaKind::Element(Box::new(formula), place.base10_parse()?),
                };
            } else {
                return Ok(formula);
            }
        }
    }

    fn parse_after_dot(receiver: Self, input: ParseStream<'_>) -> Result<Self> {
        input.parse::<Token![.]>()?;
        let start = receiver.start;
        if input.peek(syn::LitInt) {
            let place: syn::LitInt = input.parse()?;
            return Ok(Self {
                start,
                end: place.span(),
                kind: FormulaKind::Element(Box::new(receiver), place.base10_parse()?),
            });
        }
        let name = input.call(Ident::parse_any)?;
        if !input.peek(token::Paren) {
            return Ok(Self {
                start,
                end: name.span(),
                kind: FormulaKind::Coefficient(Box::new(receiver), name),
            });
        }
        let (mut arguments, end) = Self::parse_list(input)?;
        arguments.insert(0, receiver);
        Ok(Self {
            start,
            end,
            kind: FormulaKind::Call(name, arguments),
        })
    }

    fn parse_list(input: ParseStream<'_>) -> Result<(Vec<Self>, Span)> {
        let list;
        let parentheses = parenthesized!(list in input);
        let arguments = Punctuated::<_, Token![,]>::parse_terminated_with(&list, Self::parse)?;
        Ok((arguments.into_iter().collect(), parentheses.span.close()))
    }

    fn parse_atom(input: ParseStream<'_>) -> Result<Self> {
        let start = input.span();
        let one = |kind| Self {
            kind,
            start,
            end: start,
        };
        if input.peek(Lit) {
            let literal: Lit = input.parse()?;
            return number(&literal).map(|value| one(FormulaKind::Number(value)));
        }
        if input.peek(token::Paren) {
            let list;
            let parentheses = parenthesized!(list in input);
            let end = parentheses.span.close();
            let parts = Punctuated::<Self, Token![,]>::parse_terminated_with(&list, Self::parse)?;
            let is_tuple = parts.len() != 1 || parts.trailing_punct();
            let mut parts: Vec<_> = parts.into_iter().collect();
            let kind = match parts.pop() {
                Some(inner) if !is_tuple => FormulaKind::Parenthesised(Box::new(inner)),
                last => FormulaKind::Tuple(parts.into_iter().chain(last).collect()),
            };
            return Ok(Self { kind, start, end });
        }
        if input.peek(token::Bracket) {
            let list;
            let brackets = bracketed!(list in input);
            let parts = Punctuated::<Self, Token![,]>::parse_terminated_with(&list, Self::parse)?;
            return Ok(Self {
                kind: FormulaKind::Array(parts.into_iter().collect()),
                start,
                end: brackets.span.close(),
            });
        }
        if !input.peek(Ident) {
            return Err(input.error("expected a formula: a name, a number, a call or parentheses"));
        }
        let name: Ident = input.parse()?;
        if !input.peek(token::Paren) {
            return Ok(one(FormulaKind::Name(name)));
        }
        let (arguments, end) = Self::parse_list(input)?;
        Ok(Self {
            kind: FormulaKind::Call(name, arguments),
            start,
            end,
        })
    }
}

/// The fraction that a literal writes.
fn number(literal: &Lit) -> Result<Ratio> {
    let (digits, suffix) = match literal {
        Lit::Int(number) => (
            number.base10_digits().to_owned(),
            number.suffix().to_owned(),
        ),
        Lit::Float(number) => (
            number.base10_digits().to_owned(),
            number.suffix().to_owned(),
        ),
        other => return Err(Error::new_spanned(other, "expected a number")),
    };
    if !suffix.is_empty() {
        let message = "a number takes the scalar type of the function; leave out the suffix";
        return Err(Error::new_spanned(literal, message));
    }
    decimal(&digits)
        .ok_or_else(|| Error::new_spanned(literal, "the number has too many digits for 64 bits"))
}

fn decimal(text: &str) -> Option<Ratio> {
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().ok()?),
        None => (text, 0),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let fraction = fraction.trim_end_matches('0');
    let numerator: i64 = format!("{whole}{fraction}").parse().ok()?;
    let shift = exponent.checked_sub(i32::try_from(fraction.len()).ok()?)?;
    let power = 10_i64.checked_pow(shift.unsigned_abs())?;
    if shift < 0 {
        return Ratio::new(i128::from(numerator), i128::from(power));
    }
    numerator
        .checked_mul(power)
        .map(|value| Ratio::integer(i128::from(value)))
}

impl fmt::Display for Formula {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let list = |parts: &[Self]| {
            let parts: Vec<_> = parts.iter().map(ToString::to_string).collect();
            parts.join(", ")
        };
        match &self.kind {
            FormulaKind::Name(name) => write!(f, "{name}"),
            FormulaKind::Number(value) => write!(f, "{value}"),
            FormulaKind::Negative(operand) => write!(f, "-{operand}"),
            FormulaKind::Binary(operator, a, b) => write!(f, "{a} {} {b}", operator.symbol()),
            FormulaKind::Call(name, arguments) => write!(f, "{name}({})", list(arguments)),
            FormulaKind::Coefficient(operand, name) => write!(f, "{operand}.{name}"),
            FormulaKind::Element(operand, place) => write!(f, "{operand}[{place}]"),
            FormulaKind::Parenthesised(inner) => write!(f, "({inner})"),
            FormulaKind::Tuple(parts) => write!(f, "({})", list(parts)),
            FormulaKind::Array(parts) => write!(f, "[{}]", list(parts)),
        }
    }
}

#[cfg(test)]
mod tests {
    use syn::parse::Parser;

    use super::*;

    fn read(text: &str) -> Result<Formula> {
        Formula::parse.parse_str(text)
    }

    #[test]
    fn precedence_is_that_of_rust() {
        let shape = |text: &str| match read(text).map(|formula| formula.kind) {
            Ok(FormulaKind::Binary(operator, ..)) => operator,
            other => panic!("{other:?}"),
        };
        assert_eq!(shape("a - b * c"), Operator::Subtract);
        assert_eq!(shape("a ^ b & c"), Operator::Xor);
        assert_eq!(shape("a | b ^ c"), Operator::Or);
        assert_eq!(shape("-a * b.f(c)"), Operator::Multiply);
        let nested = read("a - b - c").map(|formula| formula.kind);
        let Ok(FormulaKind::Binary(_, left, _)) = nested else {
            panic!("a difference")
        };
        assert_eq!(left.to_string(), "a - b");
    }

    #[test]
    fn mixes_are_refused_with_both_readings() {
        for (text, first, second) in [
            ("a + b ^ c", "`(a + b) ^ c`", "`a + (b ^ c)`"),
            ("a | b * c", "`a | (b * c)`", "`(a | b) * c`"),
        ] {
            let message = read(text).expect_err("a mix").to_string();
            assert!(
                message.contains(first) && message.contains(second),
                "{message}"
            );
        }
        for text in ["(a + b) ^ c", "a ^ b & c", "a * (b | c)", "-a ^ b"] {
            assert!(read(text).is_ok(), "{text}");
        }
    }

    #[test]
    fn numbers_are_exact() {
        for (text, numerator, denominator) in [
            ("0.5", 1, 2),
            ("2", 2, 1),
            ("1.25e2", 125, 1),
            ("3e-1", 3, 10),
            ("10.0", 10, 1),
        ] {
            let Ok(FormulaKind::Number(value)) = read(text).map(|formula| formula.kind) else {
                panic!("{text} is a number")
            };
            assert_eq!(Some(value), Ratio::new(numerator, denominator), "{text}");
        }
        assert!(read("1.0f32").is_err() && read("123456789012345678901").is_err());
    }
}
