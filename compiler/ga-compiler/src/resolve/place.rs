//! Places in a conformal model: the point of a vector, a flat point or a round, and the two ends of
//! a point pair.
//!
//! N is the null vector of infinity with `P·N = 1` for all points P, and O the origin.

use super::error::{ResolveError, ResolveErrorKind};
use super::{Bound, Resolver, Result};
use crate::parse::Formula;

use crate::program::OperationError;
use crate::program::conformal::Conformal;

/// The operation that gives the place of something.
pub(super) const POINT: &str = "point";

/// The operation that gives the two points of a pair.
pub(super) const ENDPOINTS: &str = "endpoints";

impl<'a, 's> Resolver<'a, 's> {
    /// `point(x)`.
    pub(super) fn point(&mut self, formula: &Formula, operand: &'s Formula) -> Result<Bound> {
        let x = self.single(operand)?;
        let model = self.conformal(POINT, formula)?;
        let step = self
            .builder
            .place(&model, x)
            .map_err(|error| operation_error(POINT, error, formula))?;
        if step != x {
            self.builder.program.state_operation(step, vec![x]);
        }
        Ok(Bound::One(step))
    }

    /// `endpoints(x)`.
    pub(super) fn endpoints(&mut self, formula: &Formula, operand: &'s Formula) -> Result<Bound> {
        let x = self.single(operand)?;
        let model = self.conformal(ENDPOINTS, formula)?;
        let [a, b] = self
            .builder
            .ends(&model, x)
            .map_err(|error| operation_error(ENDPOINTS, error, formula))?;
        Ok(Bound::Parts([Bound::One(a), Bound::One(b)].into()))
    }

    /// The conformal model of the algebra.
    fn conformal(&self, name: &'static str, formula: &Formula) -> Result<Conformal<'a>> {
        let mut models = Conformal::all(self.definition);
        if models.len() == 1
            && let Some(model) = models.pop()
        {
            return Ok(model);
        }
        let names = models.iter().map(|model| model.point.name.to_string());
        let metric = self.definition.algebra.metric_text();
        let error = OperationError::NoPoints(names.collect(), metric);
        Err(operation_error(name, error, formula))
    }
}

fn operation_error(name: &'static str, error: OperationError, formula: &Formula) -> ResolveError {
    ResolveError::new(ResolveErrorKind::Operation(name, error), formula.place())
}
