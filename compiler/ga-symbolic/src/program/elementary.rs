//! Elementary functions of scalars that are made of others, and powers.

use super::build::{Builder, Outcome};
use super::limits::MAX_EXPONENT;
use super::{OperationError, Step, StepId};
use crate::algebra::Ratio;
use crate::ir::Function;

/// The largest denominator of an exponent for which square roots of square roots are taken.
const MOST_ROOTS: i128 = 16;

impl Builder<'_> {
    /// `tan x = sin x/cos x`.
    pub fn tangent(&mut self, x: StepId) -> Outcome {
        let sine = self.function(Function::Sine, &[x])?;
        let cosine = self.function(Function::Cosine, &[x])?;
        self.push(Step::Quotient(sine, cosine))
    }

    /// `asin x`, the angle of the point `(√(1 − x²), x)`.
    pub fn arc_sine(&mut self, x: StepId) -> Outcome {
        let other = self.other_leg(x)?;
        self.function(Function::ArcTangent, &[x, other])
    }

    /// `acos x`, the angle of the point `(x, √(1 − x²))`.
    pub fn arc_cosine(&mut self, x: StepId) -> Outcome {
        let other = self.other_leg(x)?;
        self.function(Function::ArcTangent, &[other, x])
    }

    /// `√((1 − x)(1 + x))`, where no digits are lost near x = ±1, unlike in `1 − x²`.
    fn other_leg(&mut self, x: StepId) -> Outcome {
        let one = self.number(Ratio::ONE)?;
        let less = self.difference(one, x)?;
        let more = self.push(Step::Sum(one, x))?;
        let square = self.geometric(less, more)?;
        self.function(Function::SquareRoot, &[square])
    }

    /// A power: of any multivector by a natural number, of a blade or a versor by an integer, of a
    /// scalar by a fraction.
    ///
    /// Fractions whose denominator is a power of two, up to 16, are products of roots. Others are
    /// `exp(y ln x)`, whose relative error grows with `|y ln x|`.
    pub fn power(&mut self, base: StepId, exponent: Ratio) -> Outcome {
        let size = exponent.abs().numerator() / exponent.denominator();
        if exponent.is_out_of_range() || size > MAX_EXPONENT {
            return Err(OperationError::ExponentTooLarge);
        }
        let is_scalar = self.witness.is_scalar(base);
        if !exponent.is_integer() && !is_scalar {
            return Err(OperationError::RootNotOfScalar(self.blade_names(base)));
        }
        let denominator = exponent.denominator();
        if denominator > MOST_ROOTS || denominator & (denominator - 1) != 0 {
            let exponent = self.number(exponent)?;
            let logarithm = self.function(Function::NaturalLogarithm, &[base])?;
            let product = self.geometric(exponent, logarithm)?;
            return self.function(Function::Exponential, &[product]);
        }
        if !exponent.is_negative() {
            return self.product_of_roots(base, exponent);
        }
        if !is_scalar {
            let inverse = self.inverse(base)?;
            return self.product_of_roots(inverse, -exponent);
        }
        let power = self.product_of_roots(base, -exponent)?;
        let one = self.number(Ratio::ONE)?;
        self.push(Step::Quotient(one, power))
    }

    /// A positive power whose denominator is a power of two.
    fn product_of_roots(&mut self, base: StepId, exponent: Ratio) -> Outcome {
        let (numerator, mut bit) = (exponent.numerator(), exponent.denominator());
        let mut product = match numerator / bit {
            0 => None,
            whole => Some(self.natural_power(base, whole)?),
        };
        let mut root = base;
        while bit > 1 {
            bit /= 2;
            root = self.function(Function::SquareRoot, &[root])?;
            if numerator & bit != 0 {
                product = Some(match product {
                    Some(product) => self.geometric(product, root)?,
                    None => root,
                });
            }
        }
        product.map_or_else(|| self.number(Ratio::ONE), Ok)
    }

    /// A power by squaring, for an exponent of at least one.
    fn natural_power(&mut self, base: StepId, exponent: i128) -> Outcome {
        let mut power = base;
        for place in (0..exponent.ilog2()).rev() {
            power = self.geometric(power, power)?;
            if exponent >> place & 1 == 1 {
                power = self.geometric(power, base)?;
            }
        }
        Ok(power)
    }
}
