//! Reads polynomials and constants of a declaration.

use syn::{BinOp, Error, Expr, Lit, Result, UnOp};

use crate::algebra::Ratio;
use crate::define::Polynomial;

/// The largest absolute value of a number in a declaration; it keeps all exact arithmetic within
/// range.
const LARGEST: i128 = 1_000_000;

/// Reads a polynomial; `lookup` resolves the names of blades.
///
/// # Errors
/// Anything but sums, differences, products, quotients by constants, and blades that `lookup`
/// accepts.
pub(super) fn resolve(
    syntax: &Expr,
    lookup: &mut dyn FnMut(&syn::Ident) -> Result<usize>,
) -> Result<Polynomial> {
    match syntax {
        Expr::Paren(inner) => resolve(&inner.expr, lookup),
        Expr::Group(inner) => resolve(&inner.expr, lookup),
        Expr::Lit(literal) => match &literal.lit {
            Lit::Int(number) => {
                // A number that does not even fit is too large as well.
                let value = number.base10_parse().unwrap_or(i128::MAX);
                within_bounds(Polynomial::Constant(Ratio::integer(value)), syntax)
            }
            other => Err(Error::new_spanned(
                other,
                "expected a whole number; write fractions as `1/2`",
            )),
        },
        Expr::Path(path) => match path.path.get_ident() {
            Some(name) => Ok(Polynomial::Coefficient(lookup(name)?)),
            None => Err(Error::new_spanned(path, "expected the name of a blade")),
        },
        Expr::Unary(unary) if matches!(unary.op, UnOp::Neg(_)) => {
            Ok(resolve(&unary.expr, lookup)?.negative())
        }
        Expr::Binary(binary) => {
            let left = resolve(&binary.left, lookup)?;
            let right = resolve(&binary.right, lookup)?;
            let joined = match binary.op {
                BinOp::Add(_) => Polynomial::Sum(Box::new(left), Box::new(right)),
                BinOp::Sub(_) => Polynomial::Sum(Box::new(left), Box::new(right.negative())),
                BinOp::Mul(_) => Polynomial::Product(Box::new(left), Box::new(right)),
                BinOp::Div(_) => match right.as_constant().and_then(Ratio::recip) {
                    Some(inverse) => {
                        Polynomial::Product(Box::new(left), Box::new(Polynomial::Constant(inverse)))
                    }
                    None => {
                        return Err(Error::new_spanned(
                            &binary.right,
                            "only a constant other than zero may be a divisor",
                        ));
                    }
                },
                operator => {
                    return Err(Error::new_spanned(
                        operator,
                        "expected `+`, `-`, `*` or `/`",
                    ));
                }
            };
            within_bounds(joined, syntax)
        }
        other => Err(Error::new_spanned(
            other,
            "expected a polynomial in the stored blades of the type",
        )),
    }
}

/// The polynomial, with a constant folded to one number. An error if its numbers are too large,
/// where those of its parts are not.
fn within_bounds(polynomial: Polynomial, syntax: &Expr) -> Result<Polynomial> {
    let folded = polynomial
        .as_constant()
        .map_or(polynomial, Polynomial::Constant);
    let (numerator, denominator) = folded.size();
    if numerator > LARGEST || denominator > LARGEST {
        let message = if folded.as_constant().is_some() {
            format!("numbers above {LARGEST} are not supported, nor are fractions of them")
        } else {
            format!(
                "the factors of this polynomial multiply to numbers above {LARGEST}, or to fractions of them"
            )
        };
        return Err(Error::new_spanned(syntax, message));
    }
    Ok(folded)
}

/// Reads a constant.
pub(super) fn constant(syntax: &Expr) -> Result<Ratio> {
    let refuse =
        |name: &syn::Ident| Err(Error::new(name.span(), "expected a constant, not a name"));
    let value = resolve(syntax, &mut { refuse })?.as_constant();
    value.ok_or_else(|| Error::new_spanned(syntax, "expected a constant"))
}
