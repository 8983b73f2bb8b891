//! Bounds on how deep source text nests.
//!
//! Reading a formula, working it out and dropping it recurse over its tree. The bounds keep all of
//! that within the smallest stack that a thread usually has, so that text which nests too deep is
//! an error instead of a stack overflow.

use proc_macro2::{Span, TokenStream, TokenTree};
use syn::parse::ParseStream;
use syn::{Error, Result, Token};

/// How deep a formula may nest. Parentheses, brackets, calls, methods and minus signs count.
pub const MAX_NESTING: usize = 128;

/// How many operators may follow each other in one formula, as in `a + b + c`.
pub const MAX_OPERATORS: usize = 1024;

/// How deep brackets may nest in anything that is read, imported functions included.
const MAX_BRACKETS: usize = 512;

/// The error of a formula that nests too deep.
pub(super) fn too_deep() -> String {
    format!(
        "a formula nests at most {MAX_NESTING} levels deep; bind the inner parts to names with `let`"
    )
}

/// The error of a formula with too many operators.
pub(super) fn too_long() -> String {
    format!(
        "a formula has at most {MAX_OPERATORS} operators in a row; bind parts of it to names with `let`"
    )
}

/// Checks that the brackets of a text do not nest too deep for the parser.
///
/// # Errors
/// They do, at the first bracket that is too deep.
pub fn check_brackets(tokens: &TokenStream) -> Result<()> {
    let mut open = vec![tokens.clone().into_iter()];
    while let Some(innermost) = open.last_mut() {
        match innermost.next() {
            Some(TokenTree::Group(group)) => {
                if open.len() > MAX_BRACKETS {
                    let message = format!(
                        "brackets nest more than {MAX_BRACKETS} levels deep here; {}",
                        too_deep()
                    );
                    return Err(Error::new(group.span_open(), message));
                }
                open.push(group.stream().into_iter());
            }
            Some(_) => {}
            None => {
                open.pop();
            }
        }
    }
    Ok(())
}

/// Checks an expression of `algebra!`, up to the `,` or `;` after it, before it is read.
///
/// # Errors
/// Its brackets and signs nest too deep, or it has too many operators.
pub(super) fn check_expression(input: ParseStream<'_>) -> Result<()> {
    let ahead = input.fork();
    let mut tokens = Vec::new();
    while !(ahead.is_empty() || ahead.peek(Token![,]) || ahead.peek(Token![;])) {
        tokens.push(ahead.parse::<TokenTree>()?);
    }
    let error = |place: Span, what: &str| {
        Err(Error::new(
            place,
            format!("the coefficient of a blade {what}"),
        ))
    };
    let too_deep = format!("nests at most {MAX_NESTING} levels deep");
    let too_long = format!("has at most {MAX_OPERATORS} operators");
    let mut operators = 0;
    // The brackets that are open, each with its level and the marks in a row before the next token:
    // all but the first of these are signs, which nest.
    let mut open = vec![(
        tokens.into_iter().collect::<TokenStream>().into_iter(),
        0,
        0,
    )];
    while let Some((innermost, level, marks)) = open.last_mut() {
        match innermost.next() {
            Some(TokenTree::Group(group)) => {
                let inner = *level + *marks + 1;
                if inner > MAX_NESTING {
                    return error(group.span_open(), &too_deep);
                }
                *marks = 0;
                open.push((group.stream().into_iter(), inner, 0));
            }
            Some(TokenTree::Punct(mark)) => {
                *marks += 1;
                operators += 1;
                if *level + *marks > MAX_NESTING {
                    return error(mark.span(), &too_deep);
                }
                if operators > MAX_OPERATORS {
                    return error(mark.span(), &too_long);
                }
            }
            Some(_) => *marks = 0,
            None => {
                open.pop();
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse::{parse_declaration, parse_functions};

    /// A text with brackets or signs around a name, in the body of a function.
    fn function(open: &str, close: &str, levels: usize) -> String {
        let (open, close) = (open.repeat(levels), close.repeat(levels));
        format!("fn f(a: Scalar) -> Scalar {{ {open}a{close} }}")
    }

    /// The message about the text of functions.
    fn refusal(functions: &str) -> String {
        let tokens: TokenStream = functions.parse().expect("tokens");
        let error = parse_functions(tokens).err().expect("too deep");
        error.to_string()
    }

    #[test]
    fn brackets_that_nest_too_deep_are_an_error() {
        for levels in [129, 511, 5_000, 100_000] {
            for (open, close) in [("(", ")"), ("[", "]"), ("f(", ")")] {
                let message = refusal(&function(open, close, levels));
                assert!(message.contains("at most 128 levels deep"), "{message}");
            }
        }
        let types = "(".repeat(5_000) + &")".repeat(5_000);
        let message = refusal(&format!("fn f(a: {types}) -> Scalar {{ 1 }}"));
        assert!(message.contains("more than 512 levels deep"), "{message}");
    }

    #[test]
    fn too_many_signs_or_terms_are_an_error() {
        let message = refusal(&function("-", "", 20_000));
        assert!(message.contains("at most 128 levels deep"), "{message}");
        let message = refusal(&function("", " + a", 20_000));
        assert!(message.contains("at most 1024 operators"), "{message}");
    }

    #[test]
    fn coefficients_of_declarations_are_bounded() {
        let check = |value: &str| {
            let text = format!(
                "mod v {{ basis e1, e2; metric e1*e1 = {value}; struct V {{ e1, e2 = {value} }} }}"
            );
            let tokens: TokenStream = text.parse().expect("tokens");
            let checked = parse_declaration(tokens).map(drop);
            checked.map_err(|error| error.to_string())
        };
        for within in [
            format!("{}1{}", "(".repeat(100), ")".repeat(100)),
            format!("{}1", "-".repeat(100)),
            format!("{}1{}", "-(".repeat(60), ")".repeat(60)),
            format!("1{}", " + 1".repeat(1000)),
        ] {
            assert_eq!(check(&within), Ok(()));
        }
        for (value, part) in [
            (format!("{}1", "-".repeat(20_000)), "at most 128 levels"),
            (
                format!("1{}", " + 1".repeat(20_000)),
                "at most 1024 operators",
            ),
            (
                format!("{}1{}", "(".repeat(200), ")".repeat(200)),
                "at most 128 levels",
            ),
            (
                format!("{}1{}", "(".repeat(5_000), ")".repeat(5_000)),
                "at most 128 levels",
            ),
        ] {
            let message = check(&value).expect_err("too deep");
            assert!(message.contains(part), "{message}");
        }
    }
}
