//! Names, and values that are stated beside them.

use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Expr, Ident, Result, Token};

use super::nesting::check_expression;

/// Reads `= value`, where it follows.
pub(super) fn value_after_equals(input: ParseStream<'_>) -> Result<Option<Expr>> {
    if !input.peek(Token![=]) {
        return Ok(None);
    }
    input.parse::<Token![=]>()?;
    check_expression(input)?;
    input.parse().map(Some)
}

/// Reads a name; `what` says what it is for, in case it is a keyword.
pub(super) fn name(input: ParseStream<'_>, what: &str) -> Result<Ident> {
    if !input.peek(Ident)
        && let Ok(keyword) = input.fork().call(Ident::parse_any)
    {
        let message = format!("`{keyword}` is a keyword of Rust and cannot be the name of {what}");
        return Err(input.error(message));
    }
    input.parse()
}
