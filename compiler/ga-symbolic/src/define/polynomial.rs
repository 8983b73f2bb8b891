//! Polynomials in the stored coefficients of a type: what a derived blade is.

use crate::algebra::Ratio;

/// A polynomial; `Coefficient` holds the index of a blade in the type's list.
#[derive(Clone, Debug, PartialEq)]
pub enum Polynomial {
    /// A number.
    Constant(Ratio),
    /// The coefficient of a blade of the type, as it is written in the declaration.
    Coefficient(usize),
    /// A sum.
    Sum(Box<Polynomial>, Box<Polynomial>),
    /// A product.
    Product(Box<Polynomial>, Box<Polynomial>),
}

impl Polynomial {
    /// The number that the polynomial is, if no blade occurs in it.
    #[must_use]
    pub fn as_constant(&self) -> Option<Ratio> {
        match self {
            Self::Constant(value) => Some(*value),
            Self::Coefficient(_) => None,
            Self::Sum(a, b) => Some(a.as_constant()? + b.as_constant()?),
            Self::Product(a, b) => Some(a.as_constant()? * b.as_constant()?),
        }
    }

    /// Folds the polynomial over any ring.
    pub fn evaluate<T>(
        &self,
        constant: &mut dyn FnMut(Ratio) -> T,
        coefficient: &mut dyn FnMut(usize) -> T,
        combine: &mut dyn FnMut(PolynomialStep, T, T) -> T,
    ) -> T {
        match self {
            Self::Constant(value) => constant(*value),
            Self::Coefficient(index) => coefficient(*index),
            Self::Sum(a, b) | Self::Product(a, b) => {
                let step = if matches!(self, Self::Sum(..)) {
                    PolynomialStep::Sum
                } else {
                    PolynomialStep::Product
                };
                let left = a.evaluate(constant, coefficient, combine);
                let right = b.evaluate(constant, coefficient, combine);
                combine(step, left, right)
            }
        }
    }

    /// The polynomial as text, with the given names of coefficients.
    #[must_use]
    pub fn to_text(&self, name: &dyn Fn(usize) -> String) -> String {
        let inner = |part: &Self| match part {
            Self::Sum(..) => format!("({})", part.to_text(name)),
            _ => part.to_text(name),
        };
        match self {
            Self::Constant(value) if value.is_integer() => value.to_string(),
            Self::Constant(value) => format!("({value})"),
            Self::Coefficient(index) => name(*index),
            Self::Sum(a, b) => format!("{} + {}", a.to_text(name), b.to_text(name)),
            Self::Product(a, b) => format!("{} {}", inner(a), inner(b)),
        }
    }

    /// A bound on the sum of the absolute values of all factors after expansion, over their common
    /// denominator. It bounds every constant that arises when the polynomial is inserted for a
    /// coefficient.
    #[must_use]
    pub fn size(&self) -> (i128, i128) {
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

    /// The polynomial times −1.
    #[must_use]
    pub fn negative(self) -> Self {
        Self::Product(Box::new(Self::Constant(Ratio::integer(-1))), Box::new(self))
    }
}

/// How two parts of a polynomial are joined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PolynomialStep {
    /// Added.
    Sum,
    /// Multiplied.
    Product,
}
