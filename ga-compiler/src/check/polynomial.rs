//! Reads polynomials and constants of a declaration.

use syn::{BinOp, Error, Expr, Lit, Result, UnOp};

use crate::algebra::Ratio;
use crate::define::{Polynomial, PolynomialStep};

/// The largest absolute value of a number in a declaration; it keeps all exact arithmetic within
/// range.
const LARGEST: i128 = 1_000_000;

impl Polynomial {
    /// Reads a polynomial; `lookup` resolves the names of blades.
    ///
    /// # Errors
    /// Anything but sums, differences, products, quotients by constants, and blades that `lookup`
    /// accepts.
    pub fn resolve(
        syntax: &Expr,
        lookup: &mut dyn FnMut(&syn::Ident) -> Result<usize>,
    ) -> Result<Self> {
        match syntax {
            Expr::Paren(inner) => Self::resolve(&inner.expr, lookup),
            Expr::Group(inner) => Self::resolve(&inner.expr, lookup),
            Expr::Lit(literal) => match &literal.lit {
                Lit::Int(number) => {
                    // A number that does not even fit is too large as well.
                    let value = number.base10_parse().unwrap_or(i128::MAX);
                    Self::Constant(Ratio::integer(value)).within_bounds(syntax)
                }
                other => Err(Error::new_spanned(
                    other,
                    "expected a whole number; write fractions as `1/2`",
                )),
            },
            Expr::Path(path) => match path.path.get_ident() {
                Some(name) => Ok(Self::Coefficient(lookup(name)?)),
                None => Err(Error::new_spanned(path, "expected the name of a blade")),
            },
            Expr::Unary(unary) if matches!(unary.op, UnOp::Neg(_)) => {
                Ok(Self::resolve(&unary.expr, lookup)?.negative())
            }
            Expr::Binary(binary) => {
                let left = Self::resolve(&binary.left, lookup)?;
                let right = Self::resolve(&binary.right, lookup)?;
                let joined = match binary.op {
                    BinOp::Add(_) => Self::Sum(Box::new(left), Box::new(right)),
                    BinOp::Sub(_) => Self::Sum(Box::new(left), Box::new(right.negative())),
                    BinOp::Mul(_) => Self::Product(Box::new(left), Box::new(right)),
                    BinOp::Div(_) => match right.as_constant().and_then(Ratio::recip) {
                        Some(inverse) => {
                            Self::Product(Box::new(left), Box::new(Self::Constant(inverse)))
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
                joined.within_bounds(syntax)
            }
            other => Err(Error::new_spanned(
                other,
                "expected a polynomial in the stored blades of the type",
            )),
        }
    }

    /// The polynomial, with a constant folded to one number. An error if its numbers are too large,
    /// where those of its parts are not.
    fn within_bounds(self, syntax: &Expr) -> Result<Self> {
        let folded = self.as_constant().map_or(self, Self::Constant);
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

    /// A bound on the sum of the absolute values of all factors after expansion, over their common
    /// denominator. It bounds every constant that arises when the polynomial is inserted for a
    /// coefficient.
    fn size(&self) -> (i128, i128) {
        self.evaluate(
            &mut |value| (value.abs().numerator(), value.denominator()),
            &mut |_| (1, 1),
            &mut |step, (a, below_a), (b, below_b)| match step {
                PolynomialStep::Sum => {
                    // In lowest terms, the denominator of `below_a / below_b` is the factor from
                    // `below_a` to their least common multiple.
                    let lacking = Ratio::new(below_a, below_b).map_or(1, Ratio::denominator);
                    let common = below_a.saturating_mul(lacking);
                    let (a, b) = (
                        a.saturating_mul(lacking),
                        b.saturating_mul(common / below_b),
                    );
                    (a.saturating_add(b), common)
                }
                PolynomialStep::Product => (a.saturating_mul(b), below_a.saturating_mul(below_b)),
            },
        )
    }

    fn negative(self) -> Self {
        Self::Product(Box::new(Self::Constant(Ratio::integer(-1))), Box::new(self))
    }
}

/// Reads a constant.
pub(super) fn constant(syntax: &Expr) -> Result<Ratio> {
    let refuse =
        |name: &syn::Ident| Err(Error::new(name.span(), "expected a constant, not a name"));
    let value = Polynomial::resolve(syntax, &mut { refuse })?.as_constant();
    value.ok_or_else(|| Error::new_spanned(syntax, "expected a constant"))
}
