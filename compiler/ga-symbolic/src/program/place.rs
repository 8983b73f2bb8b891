//! Places of figures in a conformal model: points, centres and the ends of pairs.

use super::build::{Builder, Outcome};
use super::conformal::Conformal;
use super::{OperationError, Step, StepId};
use crate::algebra::{Blade, Product, Ratio, Unary};
use crate::ir::Function;

impl<'a> Builder<'a> {
    /// The point of a vector `w (P + α N)`, of a flat point, or the centre of a round.
    ///
    /// # Errors
    /// [`OperationError::NoPlace`] for anything else.
    pub fn place(&mut self, model: &Conformal<'a>, x: StepId) -> Outcome {
        let reasons = self.witness.reasons(self.algebra, x, Some(model.point));
        if reasons.is_empty() {
            return Ok(x);
        }
        let infinity = self.vector(&model.infinity)?;
        let no_place = |builder: &Self| OperationError::NoPlace(builder.blade_names(x));
        let last = u32::try_from(self.algebra.dimension()).unwrap_or(u32::MAX) - 1;
        let vector = match self.grade_of(x).ok_or_else(|| no_place(self))? {
            1 => x,
            2 if self.is_flat(infinity, x)? => {
                // O⌋(P∧N) = (O·P) N − P
                let origin = self.vector(&model.origin)?;
                self.push(Step::Binary(Product::LeftContraction, origin, x))?
            }
            grade if grade == last => self.push(Step::Unary(Unary::Dual, x))?,
            grade if grade == 0 || grade > last || self.is_flat(infinity, x)? => {
                return Err(no_place(self));
            }
            // The inversion in a round takes infinity to the centre.
            _ => {
                let half = self.geometric(x, infinity)?;
                let reverse = self.push(Step::Unary(Unary::Reverse, x))?;
                let whole = self.geometric(half, reverse)?;
                self.push(Step::Unary(Unary::Grade(1), whole))?
            }
        };
        let weight = self.push(Step::Binary(Product::ScalarProduct, vector, infinity))?;
        if self.witness.is_zero(weight) {
            return Err(no_place(self));
        }
        let unit = self.push(Step::Quotient(vector, weight))?;
        self.on_the_cone(model, infinity, unit)
    }

    /// The two points of `X = a∧b`, a with the minus: `(X⌊m ∓ √⟨X²⟩₀ m)/m²` with `m = N⌋X`.
    ///
    /// For points of weight 1 and `X = w a∧b` it is `m = w (b − a)`, `X⌊m = −w² (a·b) (a + b)`,
    /// `m² = −2 w² a·b` and, since `a·b` is negative, `√X² = −|w| a·b`. For a negative w the ends
    /// change places.
    ///
    /// # Errors
    /// [`OperationError::NotPointPair`] for anything else.
    pub fn ends(
        &mut self,
        model: &Conformal<'a>,
        x: StepId,
    ) -> Result<[StepId; 2], OperationError> {
        let infinity = self.vector(&model.infinity)?;
        if self.grade_of(x) != Some(2) || self.is_flat(infinity, x)? {
            return Err(OperationError::NotPointPair(self.blade_names(x)));
        }
        let axis = self.push(Step::Binary(Product::LeftContraction, infinity, x))?;
        let middle = self.push(Step::Binary(Product::RightContraction, x, axis))?;
        let square = self.push(Step::Binary(Product::ScalarProduct, x, x))?;
        let root = self.function(Function::SquareRoot, &[square])?;
        let reach = self.geometric(root, axis)?;
        let weight = self.push(Step::Binary(Product::ScalarProduct, axis, axis))?;
        let back = self.push(Step::Negative(reach))?;
        let mut end = |reach: StepId| {
            let sum = self.push(Step::Sum(middle, reach))?;
            let unit = self.push(Step::Quotient(sum, weight))?;
            self.on_the_cone(model, infinity, unit)
        };
        Ok([end(back)?, end(reach)?])
    }

    /// The point `u − ½ u² N` of a vector u with `u·N = 1`.
    pub(crate) fn on_the_cone(
        &mut self,
        model: &Conformal<'a>,
        infinity: StepId,
        u: StepId,
    ) -> Outcome {
        let square = self.push(Step::Binary(Product::ScalarProduct, u, u))?;
        let half = self.scaled(square, -1, 2)?;
        let change = self.geometric(half, infinity)?;
        let point = self.push(Step::Sum(u, change))?;
        self.program.state(point, model.point.facts);
        self.program.state_kind(point, model.point);
        Ok(point)
    }

    /// Whether a multivector contains infinity: `N∧X = 0`.
    fn is_flat(&mut self, infinity: StepId, x: StepId) -> Result<bool, OperationError> {
        let outer = self.push(Step::Binary(Product::Wedge, infinity, x))?;
        Ok(self.witness.is_zero(outer))
    }

    /// The only grade of a multivector.
    fn grade_of(&self, x: StepId) -> Option<u32> {
        let blades = self.witness.blades(x);
        let grade = blades.first()?.grade();
        let is_same = |blade: &Blade| blade.grade() == grade;
        blades.iter().all(is_same).then_some(grade)
    }

    /// A constant vector.
    pub(crate) fn vector(&mut self, terms: &[(Blade, Ratio)]) -> Outcome {
        let mut sum = None;
        for (blade, value) in terms {
            let term = self.push(Step::Constant(*blade, *value))?;
            sum = Some(match sum {
                Some(sum) => self.push(Step::Sum(sum, term))?,
                None => term,
            });
        }
        match sum {
            Some(sum) => Ok(sum),
            None => self.number(Ratio::ZERO),
        }
    }
}
