//! The grammar of a function in an algebra: `(m: Motor, p: Point) -> Point { m * p * m.reverse() }`.
//!
//! Products are `*` geometric, `^` wedge, `|` left contraction and `&` vee; everything else is a method or a
//! function of the same name: `reverse(m)`, `m.sandwich(p)`, `commutator(a, b)`. Rust's precedence binds `^ & |` looser
//! than `+ - *`, which no textbook does, so a mix of both without parentheses is refused.

use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::{BinOp, Error, Expr, ExprBinary, Ident, Result, Token, braced};

/// A function: operands with their types, the type of the result, and the expression.
pub struct FunctionSyntax {
    /// Names and types of the operands.
    pub operands: Vec<(Ident, Ident)>,
    /// The type of the result.
    pub result: Ident,
    /// The body.
    pub body: Expr,
}

impl Parse for FunctionSyntax {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let list;
        syn::parenthesized!(list in input);
        let operands = Punctuated::<Operand, Token![,]>::parse_terminated(&list)?;
        input.parse::<Token![->]>()?;
        let result = input.parse()?;
        let block;
        braced!(block in input);
        let body = block.parse()?;
        if !block.is_empty() {
            return Err(block.error("expected the end of the expression"));
        }
        refuse_mixed_precedence(&body)?;
        Ok(Self {
            operands: operands.into_iter().map(|o| (o.name, o.kind)).collect(),
            result,
            body,
        })
    }
}

struct Operand {
    name: Ident,
    kind: Ident,
}

impl Parse for Operand {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let name = input.parse()?;
        input.parse::<Token![:]>()?;
        let kind = input.parse()?;
        Ok(Self { name, kind })
    }
}

/// Reads a function.
///
/// # Errors
/// The first place where the tokens leave the grammar, or a mix of operators without parentheses.
pub fn parse_function(tokens: proc_macro2::TokenStream) -> Result<FunctionSyntax> {
    syn::parse2(tokens)
}

fn refuse_mixed_precedence(expression: &Expr) -> Result<()> {
    match expression {
        Expr::Binary(binary) => {
            for side in [&*binary.left, &*binary.right] {
                if let Expr::Binary(inner) = side
                    && is_bitwise(binary) != is_bitwise(inner)
                {
                    return Err(Error::new_spanned(
                        side,
                        "`^ & |` bind looser than `+ - *` in Rust: put this part in parentheses, \
                         or the product that you mean",
                    ));
                }
                refuse_mixed_precedence(side)?;
            }
            Ok(())
        }
        Expr::Paren(inner) => refuse_mixed_precedence(&inner.expr),
        Expr::Unary(inner) => refuse_mixed_precedence(&inner.expr),
        Expr::MethodCall(call) => {
            refuse_mixed_precedence(&call.receiver)?;
            call.args.iter().try_for_each(refuse_mixed_precedence)
        }
        Expr::Call(call) => call.args.iter().try_for_each(refuse_mixed_precedence),
        _ => Ok(()),
    }
}

fn is_bitwise(binary: &ExprBinary) -> bool {
    matches!(
        binary.op,
        BinOp::BitXor(_) | BinOp::BitAnd(_) | BinOp::BitOr(_)
    )
}
