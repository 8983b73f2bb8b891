//! Formulas from tokens, by precedence climbing: operators bind as in Rust, and what readers of
//! Rust and of textbooks would group in different ways needs parentheses.

use proc_macro2::{Span, TokenTree};
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Error, Ident, Lit, Result, Token, bracketed, parenthesized, token};

use super::formula::{Formula, FormulaKind};
use super::nesting::{MAX_NESTING, MAX_OPERATORS, too_deep, too_long};
use super::number::number;
use super::operator::{Family, Operator};
use super::place::Place;

impl Formula {
    /// Reads a formula.
    ///
    /// # Errors
    /// The tokens leave the grammar, `^ & |` and `+ - * /` are mixed without parentheses, or the
    /// formula nests more than [`MAX_NESTING`] levels deep or has more than [`MAX_OPERATORS`]
    /// operators in a row.
    pub fn parse(input: ParseStream<'_>) -> Result<Self> {
        Self::parse_at(input, 0)
    }

    /// Reads a formula that stands `level` levels deep in another one.
    fn parse_at(input: ParseStream<'_>, level: usize) -> Result<Self> {
        if level > MAX_NESTING {
            return Err(Error::new(input.span(), too_deep()));
        }
        Self::parse_above(input, 0, level)
    }

    fn parse_above(input: ParseStream<'_>, least: u8, level: usize) -> Result<Self> {
        let mut left = Self::parse_prefix(input, level)?;
        let mut operators = 0;
        while let Some(operator) = Operator::peek(input) {
            if operator.precedence() < least.max(1) {
                break;
            }
            operators += 1;
            if operators > MAX_OPERATORS {
                return Err(input.error(too_long()));
            }
            operator.parse(input)?;
            let right = Self::parse_above(input, operator.precedence() + 1, level)?;
            left = Self::combined(operator, left, right)?;
        }
        Ok(left)
    }

    fn combined(operator: Operator, left: Self, right: Self) -> Result<Self> {
        let mixed = |side: &Self| match &side.kind {
            FormulaKind::Binary(inner, a, b) if inner.is_doubtful_with(operator) => {
                Some((*inner, a.clone(), b.clone()))
            }
            _ => None,
        };
        let symbol = operator.symbol();
        if operator.family() == Family::Comparison
            && let FormulaKind::Binary(inner, _, b) = &left.kind
            && inner.family() == Family::Comparison
        {
            return Err(left.place().to(right.place().end).error(format!(
                "comparisons do not form chains: write `{left} && {b} {symbol} {right}`"
            )));
        }
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
        let place = left.place().to(right.place().end);
        let Some((first, second)) = choices else {
            let kind = FormulaKind::Binary(operator, Box::new(left), Box::new(right));
            return Self::new(kind, place);
        };
        // What `^` stands between, for the power in a textbook's `a^2 + b^2`.
        let power = match (operator, last_operand(&left), first_operand(&right)) {
            (Operator::Xor, base, exponent) if matches!(exponent.kind, FormulaKind::Number(_)) => {
                format!("; a power is written `pow({base}, {exponent})`")
            }
            _ => String::new(),
        };
        Err(place.error(format!(
            "`^ & |` bind looser than `+ - * /` in Rust: add parentheses, either \
             `{first}` (as Rust reads it) or `{second}`{power}"
        )))
    }

    fn parse_prefix(input: ParseStream<'_>, level: usize) -> Result<Self> {
        let mut signs = Vec::new();
        while input.peek(Token![-]) || input.peek(Token![!]) {
            if level + signs.len() >= MAX_NESTING {
                return Err(input.error(too_deep()));
            }
            let is_not = input.peek(Token![!]);
            signs.push((is_not, input.parse::<TokenTree>()?.span()));
        }
        let mut formula = Self::parse_postfix(input, level + signs.len())?;
        for (is_not, span) in signs.into_iter().rev() {
            let place = Place::of(span).to(formula.place().end);
            let operand = Box::new(formula);
            let kind = if is_not {
                FormulaKind::Not(operand)
            } else {
                FormulaKind::Negative(operand)
            };
            formula = Self::new(kind, place)?;
        }
        Ok(formula)
    }

    fn parse_postfix(input: ParseStream<'_>, level: usize) -> Result<Self> {
        let mut formula = Self::parse_atom(input, level)?;
        loop {
            if input.peek(Token![.]) {
                formula = Self::parse_after_dot(formula, input, level)?;
            } else if input.peek(token::Bracket) {
                let index;
                let brackets = bracketed!(index in input);
                let number: syn::LitInt = index.parse()?;
                let place = formula.place().to(brackets.span.close());
                let kind = FormulaKind::Element(Box::new(formula), number.base10_parse()?);
                formula = Self::new(kind, place)?;
            } else {
                return Ok(formula);
            }
        }
    }

    fn parse_after_dot(receiver: Self, input: ParseStream<'_>, level: usize) -> Result<Self> {
        input.parse::<Token![.]>()?;
        let place = receiver.place();
        if input.peek(syn::LitInt) {
            let number: syn::LitInt = input.parse()?;
            let kind = FormulaKind::Element(Box::new(receiver), number.base10_parse()?);
            return Self::new(kind, place.to(number.span()));
        }
        if input.peek(syn::LitFloat) {
            return Self::parse_two_places(receiver, input);
        }
        let name = input.call(Ident::parse_any)?;
        if !input.peek(token::Paren) {
            let end = name.span();
            let kind = FormulaKind::Coefficient(Box::new(receiver), name);
            return Self::new(kind, place.to(end));
        }
        let (mut arguments, end) = Self::parse_arguments(input, level)?;
        arguments.insert(0, receiver);
        Self::new(FormulaKind::Call(name, arguments), place.to(end))
    }

    /// The places in `t.0.1`, where Rust reads `0.1` as one number.
    fn parse_two_places(receiver: Self, input: ParseStream<'_>) -> Result<Self> {
        let number: syn::LitFloat = input.parse()?;
        let text = number.to_string();
        let places: Option<Vec<usize>> = text.split('.').map(|part| part.parse().ok()).collect();
        let Some(places) = places else {
            return Err(Error::new(
                number.span(),
                "expected the places of elements, such as `t.0.1`",
            ));
        };
        let place = receiver.place().to(number.span());
        places.into_iter().try_fold(receiver, |inner, element| {
            Self::new(FormulaKind::Element(Box::new(inner), element), place)
        })
    }

    fn parse_arguments(input: ParseStream<'_>, level: usize) -> Result<(Vec<Self>, Span)> {
        let list;
        let parentheses = parenthesized!(list in input);
        let (arguments, _) = Self::parse_list(&list, level + 1)?;
        Ok((arguments, parentheses.span.close()))
    }

    /// Reads formulas with commas between them, and says whether one follows the last.
    fn parse_list(input: ParseStream<'_>, level: usize) -> Result<(Vec<Self>, bool)> {
        let mut parts = Vec::new();
        while !input.is_empty() {
            parts.push(Self::parse_at(input, level)?);
            if input.is_empty() {
                return Ok((parts, false));
            }
            input.parse::<Token![,]>()?;
        }
        let ends_with_comma = !parts.is_empty();
        Ok((parts, ends_with_comma))
    }

    fn parse_atom(input: ParseStream<'_>, level: usize) -> Result<Self> {
        let place = Place::of(input.span());
        if input.peek(Lit) {
            let literal: Lit = input.parse()?;
            return Self::new(FormulaKind::Number(number(&literal)?), place);
        }
        if input.peek(token::Paren) {
            let list;
            let parentheses = parenthesized!(list in input);
            let (mut parts, ends_with_comma) = Self::parse_list(&list, level + 1)?;
            let kind = match parts.pop() {
                Some(inner) if parts.is_empty() && !ends_with_comma => {
                    FormulaKind::Parenthesised(Box::new(inner))
                }
                last => FormulaKind::Tuple(parts.into_iter().chain(last).collect()),
            };
            return Self::new(kind, place.to(parentheses.span.close()));
        }
        if input.peek(token::Bracket) {
            let list;
            let brackets = bracketed!(list in input);
            let (parts, _) = Self::parse_list(&list, level + 1)?;
            return Self::new(FormulaKind::Array(parts), place.to(brackets.span.close()));
        }
        let is_self = input.peek(Token![self]);
        if !input.peek(Ident) && !is_self {
            return Err(not_a_formula(input));
        }
        let name = input.call(Ident::parse_any)?;
        if !input.peek(token::Paren) || is_self {
            return Self::new(FormulaKind::Name(name), place);
        }
        let (arguments, end) = Self::parse_arguments(input, level)?;
        Self::new(FormulaKind::Call(name, arguments), place.to(end))
    }
}

/// The operand at the left end of a row of operators.
fn first_operand(mut formula: &Formula) -> &Formula {
    while let FormulaKind::Binary(_, left, _) = &formula.kind {
        formula = left;
    }
    formula
}

/// The operand at the right end of a row of operators.
fn last_operand(mut formula: &Formula) -> &Formula {
    while let FormulaKind::Binary(_, _, right) = &formula.kind {
        formula = right;
    }
    formula
}

/// The error where a formula should start and none does.
fn not_a_formula(input: ParseStream<'_>) -> Error {
    if let Ok(keyword) = input.fork().call(Ident::parse_any) {
        if keyword == "if" || keyword == "match" {
            return input.error(
                "a formula does not branch, so that lanes of numbers can run it: \
                 `select(condition, a, b)` computes both a and b and chooses one of them",
            );
        }
        return input.error(format!(
            "`{keyword}` is a keyword of Rust, which a formula cannot contain; \
             if it is a blade, write its basis vectors in another order"
        ));
    }
    input.error("expected a formula: a name, a number, a call or parentheses")
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
        for text in ["a ^ 2 + b ^ 2", "b + a ^ 2", "3 * a ^ 2"] {
            let message = read(text).expect_err("a mix").to_string();
            assert!(
                message.ends_with("a power is written `pow(a, 2)`"),
                "{message}"
            );
        }
        let message = read("a + b ^ c").expect_err("a mix").to_string();
        assert!(!message.contains("power"), "{message}");
        for text in ["(a + b) ^ c", "a ^ b & c", "a * (b | c)", "-a ^ b"] {
            assert!(read(text).is_ok(), "{text}");
        }
    }

    #[test]
    fn conditions_bind_looser_than_formulas() {
        let grouped = |text: &str| match read(text).map(|formula| formula.kind) {
            Ok(FormulaKind::Binary(operator, a, b)) => {
                format!("({a}) {} ({b})", operator.symbol())
            }
            other => panic!("{other:?}"),
        };
        assert_eq!(grouped("a + b < c"), "(a + b) < (c)");
        assert_eq!(grouped("a | b >= c ^ d"), "(a | b) >= (c ^ d)");
        assert_eq!(grouped("a <-b"), "(a) < (-b)");
        assert_eq!(grouped("a < b && c != d"), "(a < b) && (c != d)");
        assert_eq!(grouped("a < b || c == d && e"), "(a < b) || (c == d && e)");
        assert_eq!(grouped("!a && !(b || c)"), "(!a) && (!(b || c))");
        let message = read("a < b <= c").expect_err("a chain").to_string();
        assert!(message.contains("`a < b && b <= c`"), "{message}");
        let message = read("if a { b } else { c }").expect_err("a branch");
        assert!(message.to_string().contains("`select(condition, a, b)`"));
    }

    #[test]
    fn places_may_follow_each_other() {
        let shown = |text: &str| read(text).map(|formula| formula.to_string());
        assert_eq!(shown("t.0.1").ok().as_deref(), Some("t[0][1]"));
        assert_eq!(shown("t.0.1.2.e12").ok().as_deref(), Some("t[0][1][2].e12"));
        assert_eq!(shown("t.10.20 + 1").ok().as_deref(), Some("t[10][20] + 1"));
        for text in ["t.0.1e3", "t.1e3", "t.0.1f32"] {
            let message = read(text).expect_err(text).to_string();
            assert!(message.contains("such as `t.0.1`"), "{message}");
        }
    }

    #[test]
    fn levels_and_operators_are_bounded() {
        // The deepest that is accepted is dropped again without harm; one more is refused.
        let nested = |open: &str, close: &str, levels: usize| {
            let text = format!("{}a{}", open.repeat(levels), close.repeat(levels));
            read(&text).map(drop).map_err(|error| error.to_string())
        };
        for (open, close) in [
            ("(", ")"),
            ("-", ""),
            ("f(b, ", ")"),
            ("1 + a * (", ")"),
            ("[b, ", "]"),
            ("", ".f()"),
            ("", ".e12"),
            ("", "[0]"),
        ] {
            assert_eq!(nested(open, close, MAX_NESTING), Ok(()), "{open}a{close}");
            for levels in [MAX_NESTING + 1, 300] {
                let message = nested(open, close, levels).expect_err("too deep");
                assert!(message.contains("at most 128 levels"), "{message}");
            }
        }
        assert_eq!(nested("-", "", MAX_NESTING), Ok(()));
        assert!(nested("-", "", 20_000).is_err());

        assert_eq!(nested("", " + b", MAX_OPERATORS), Ok(()));
        let message = nested("", " * b", MAX_OPERATORS + 1).expect_err("too long");
        assert!(message.contains("at most 1024 operators"), "{message}");
        // A long row at every level.
        let rows = nested("(", &format!("{})", " + b".repeat(1000)), 100);
        let message = rows.expect_err("too long");
        assert!(message.contains("at most 1024 operators"), "{message}");
    }

    #[test]
    fn keywords_are_named() {
        let message = read("a + as").expect_err("a keyword").to_string();
        assert!(message.starts_with("`as` is a keyword"), "{message}");
        let message = read("a + @").expect_err("a mark").to_string();
        assert!(message.starts_with("expected a formula"), "{message}");
    }
}
