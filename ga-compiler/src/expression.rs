//! Expressions over typed operands, resolved: what the compiler means by a formula.

use syn::{BinOp, Error, Expr, Ident, Lit, Result, UnOp};

use crate::algebra::{Product, Ratio, Unary};

/// An expression in multivectors.
#[derive(Clone, Debug, PartialEq)]
pub enum Expression {
    /// An operand, by its number.
    Operand(usize),
    /// A constant scalar.
    Constant(Ratio),
    /// A linear operation on one operand.
    Unary(Unary, Box<Expression>),
    /// A bilinear product.
    Binary(Product, Box<Expression>, Box<Expression>),
    /// `M X ~M` for an even M, `M X̂ ~M` for an odd one.
    Sandwich(Box<Expression>, Box<Expression>),
    /// A sum.
    Sum(Box<Expression>, Box<Expression>),
    /// The quotient by a scalar.
    Quotient(Box<Expression>, Box<Expression>),
    /// The negative.
    Negative(Box<Expression>),
}

impl Expression {
    /// A product of two expressions.
    #[must_use]
    pub fn binary(product: Product, left: Self, right: Self) -> Self {
        Self::Binary(product, Box::new(left), Box::new(right))
    }

    /// A linear operation on an expression.
    #[must_use]
    pub fn unary(operation: Unary, operand: Self) -> Self {
        Self::Unary(operation, Box::new(operand))
    }

    /// The action of a versor on an expression.
    #[must_use]
    pub fn sandwich(versor: Self, operand: Self) -> Self {
        Self::Sandwich(Box::new(versor), Box::new(operand))
    }

    /// The quotient of an expression by a scalar one.
    #[must_use]
    pub fn quotient(dividend: Self, divisor: Self) -> Self {
        Self::Quotient(Box::new(dividend), Box::new(divisor))
    }

    /// The sum of two expressions.
    #[must_use]
    pub fn sum(left: Self, right: Self) -> Self {
        Self::Sum(Box::new(left), Box::new(right))
    }

    /// The difference of two expressions.
    #[must_use]
    pub fn difference(left: Self, right: Self) -> Self {
        Self::sum(left, Self::Negative(Box::new(right)))
    }

    /// Resolves a parsed expression; `operands` are the names in scope.
    ///
    /// # Errors
    /// A name, method or operator that no geometric algebra has.
    pub fn resolve(syntax: &Expr, operands: &[Ident]) -> Result<Self> {
        match syntax {
            Expr::Paren(inner) => Self::resolve(&inner.expr, operands),
            Expr::Group(inner) => Self::resolve(&inner.expr, operands),
            Expr::Path(path) => {
                let name = path.path.get_ident();
                let number = operands.iter().position(|operand| Some(operand) == name);
                number
                    .map(Self::Operand)
                    .ok_or_else(|| Error::new_spanned(path, "unknown operand"))
            }
            Expr::Lit(literal) => match &literal.lit {
                Lit::Int(number) => Ok(Self::Constant(Ratio::integer(number.base10_parse()?))),
                other => Err(Error::new_spanned(other, "expected a whole number")),
            },
            Expr::Unary(unary) if matches!(unary.op, UnOp::Neg(_)) => {
                let operand = Self::resolve(&unary.expr, operands)?;
                Ok(Self::Negative(Box::new(operand)))
            }
            Expr::Binary(binary) => {
                let left = Self::resolve(&binary.left, operands)?;
                let right = Self::resolve(&binary.right, operands)?;
                Ok(match binary.op {
                    BinOp::Mul(_) => Self::binary(Product::Geometric, left, right),
                    BinOp::BitXor(_) => Self::binary(Product::Wedge, left, right),
                    BinOp::BitOr(_) => Self::binary(Product::LeftContraction, left, right),
                    BinOp::BitAnd(_) => Self::binary(Product::Vee, left, right),
                    BinOp::Add(_) => Self::sum(left, right),
                    BinOp::Sub(_) => Self::difference(left, right),
                    BinOp::Div(_) => Self::quotient(left, right),
                    other => return Err(Error::new_spanned(other, "no operation of the algebra")),
                })
            }
            Expr::MethodCall(call) => {
                let arguments = std::iter::once(&*call.receiver).chain(&call.args);
                Self::call(&call.method, arguments.collect(), operands)
            }
            Expr::Call(call) => match &*call.func {
                Expr::Path(path) if path.path.get_ident().is_some() => {
                    let arguments = call.args.iter().collect();
                    let name = &path.path.segments[0].ident;
                    Self::call(name, arguments, operands)
                }
                other => Err(Error::new_spanned(
                    other,
                    "expected the name of an operation",
                )),
            },
            other => Err(Error::new_spanned(other, "no expression of the algebra")),
        }
    }

    fn call(name: &Ident, arguments: Vec<&Expr>, operands: &[Ident]) -> Result<Self> {
        let text = name.to_string();
        let count = arguments.len();
        let mut resolved = arguments
            .iter()
            .map(|argument| Self::resolve(argument, operands));
        let mut next = || {
            resolved
                .next()
                .unwrap_or_else(|| Err(Error::new(name.span(), "an operand is missing")))
        };
        let expect = |wanted: usize| {
            if count == wanted {
                return Ok(());
            }
            let message = format!("`{text}` takes {wanted} operands, not {count}");
            Err(Error::new(name.span(), message))
        };
        let unary = match text.as_str() {
            "reverse" | "rev" => Some(Unary::Reverse),
            "involute" => Some(Unary::Involute),
            "conjugate" => Some(Unary::Conjugate),
            "dual" => Some(Unary::Dual),
            "undual" => Some(Unary::Undual),
            _ => None,
        };
        if let Some(operation) = unary {
            expect(1)?;
            return Ok(Self::unary(operation, next()?));
        }
        if text == "grade" {
            expect(2)?;
            return match (next()?, next()?) {
                (operand, Self::Constant(grade)) if grade.is_integer() && !grade.is_negative() => {
                    let grade = u32::try_from(grade.numerator()).unwrap_or(u32::MAX);
                    Ok(Self::unary(Unary::Grade(grade), operand))
                }
                _ => Err(Error::new(name.span(), "the grade must be a whole number")),
            };
        }
        if text == "sandwich" {
            expect(2)?;
            return Ok(Self::sandwich(next()?, next()?));
        }
        if let Some(product) = Product::from_name(&text) {
            expect(2)?;
            return Ok(Self::binary(product, next()?, next()?));
        }
        Err(Error::new(
            name.span(),
            format!("the algebra has no operation `{text}`"),
        ))
    }
}
