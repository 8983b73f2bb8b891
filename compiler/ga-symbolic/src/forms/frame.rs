//! Formulas seen from one of their points.
//!
//! A formula of products, sums, quotients and actions is equivariant: for a unit versor T
//! `f(T a ~T, T b ~T, …) = T f(a, b, …) ~T`, since the action of T is an automorphism of the
//! algebra, keeps grades and leaves scalars alone. So `f(a, b, …) = T f(~T a T, ~T b T, …) ~T`.
//!
//! T is the translation `1 + ½ (p − O) ∧ N` of a conformal model that takes its origin O to the
//! point p, N being infinity with `P·N = 1` for all points P: then p becomes O, of which all
//! stored coefficients are zero, other points become differences, and what infinity does not
//! change, directions and scalars, stays. Differences are taken before anything is rounded.
//!
//! Where a coefficient is read that T does not keep, it is read of what is moved back. That the
//! values are those of the formula is looked up at the points of the witness.

use super::Source;
use crate::algebra::{Blade, Product, Ratio, Unary};
use crate::define::TypeDefinition;
use crate::member::numbers;
use crate::program::build::Builder;
use crate::program::conformal::Conformal;
use crate::program::{Program, Step, StepId, Witness};

/// How many points are tried.
const MOST: usize = 3;

/// A program in which everything is moved, after the steps of the original one.
pub(super) struct Moved<'a> {
    pub(super) program: Program<'a>,
    pub(super) witness: Witness,
    /// The wanted steps, moved back.
    pub(super) wanted: Vec<StepId>,
}

impl<'a> Moved<'a> {
    pub(super) fn source<'s>(&'s self, original: &Source<'s, 'a>) -> Source<'s, 'a> {
        Source {
            algebra: original.algebra,
            program: &self.program,
            witness: &self.witness,
            uniform: original.uniform,
            wanted: &self.wanted,
        }
    }
}

/// The program seen from each of its points.
pub(super) fn frames<'a>(source: &Source<'_, 'a>) -> Vec<Moved<'a>> {
    let operands = &source.program.operands;
    let is_figure = |kind: &&&TypeDefinition| kind.stored().any(|c| c.blade != Blade::SCALAR);
    if operands.iter().filter(is_figure).count() < 2 {
        return Vec::new();
    }
    let points = operands.iter().enumerate().filter_map(|(number, kind)| {
        let model = Conformal::of(source.algebra, kind)?;
        Some((number, model))
    });
    points
        .take(MOST)
        .filter_map(|(number, model)| Frame::new(source, number, model)?.moved(source))
        .collect()
}

/// A translation that takes the origin to a point.
struct Frame<'a> {
    builder: Builder<'a>,
    model: Conformal<'a>,
    /// The number of the point among the operands.
    number: usize,
    point: StepId,
    origin: StepId,
    infinity: StepId,
    translation: StepId,
    inverse: StepId,
    /// The moved steps.
    images: Vec<Option<StepId>>,
}

impl<'a> Frame<'a> {
    fn new(source: &Source<'_, 'a>, number: usize, model: Conformal<'a>) -> Option<Self> {
        let mut builder = Builder {
            algebra: source.algebra,
            program: source.program.clone(),
            witness: source.witness.clone(),
            operands: Vec::new(),
        };
        let is_point = |(_, step): &(StepId, &Step)| **step == Step::Operand(number);
        let (point, _) = source.program.steps().find(is_point)?;
        let origin = builder.vector(&model.origin).ok()?;
        let infinity = builder.vector(&model.infinity).ok()?;
        let way = difference(&mut builder, point, origin)?;
        let plane = builder
            .push(Step::Binary(Product::Wedge, way, infinity))
            .ok()?;
        let half = builder.scaled(plane, 1, 2).ok()?;
        let one = builder.number(Ratio::ONE).ok()?;
        let translation = builder.push(Step::Sum(one, half)).ok()?;
        let inverse = builder
            .push(Step::Unary(Unary::Reverse, translation))
            .ok()?;
        Some(Self {
            builder,
            model,
            number,
            point,
            origin,
            infinity,
            translation,
            inverse,
            images: vec![None; source.program.len()],
        })
    }

    /// The program whose wanted steps are computed in the frame, if that is possible.
    fn moved(mut self, source: &Source<'_, 'a>) -> Option<Moved<'a>> {
        let is_needed = super::import::needed(source.program, source.wanted);
        for (id, step) in source.program.steps() {
            if is_needed[id.index()] {
                self.images[id.index()] = Some(self.image(source, id, step)?);
            }
        }
        let mut wanted = Vec::new();
        for &id in source.wanted {
            let image = self.images[id.index()]?;
            wanted.push(self.moved_back(image, id)?);
        }
        Some(Moved {
            program: self.builder.program,
            witness: self.builder.witness,
            wanted,
        })
    }

    /// A step in the frame.
    fn image(&mut self, source: &Source<'_, 'a>, id: StepId, step: &Step) -> Option<StepId> {
        let of = |part: &StepId| self.images[part.index()];
        let next = match step {
            Step::Operand(number) if *number == self.number => return Some(self.origin),
            Step::Operand(number) => {
                let kind = source.program.operands[*number];
                return self.operand(id, kind);
            }
            Step::Constant(..) => return self.acted(self.inverse, id),
            Step::Coefficient(a, blade) => {
                let image = of(a)?;
                return self.coefficient(id, image, *a, *blade);
            }
            Step::Select(..) => return None,
            _ => step.mapped(|part| of(&part).unwrap_or(part)),
        };
        let image = self.builder.push(next).ok()?;
        if let Some(kind) = source.program.kind(id) {
            self.builder.program.state_kind(image, kind);
        }
        let facts = source.program.stated(id);
        self.builder.program.state(image, facts);
        Some(image)
    }

    fn operand(&mut self, id: StepId, kind: &TypeDefinition) -> Option<StepId> {
        if std::ptr::eq(kind, self.model.point) {
            let way = difference(&mut self.builder, id, self.point)?;
            return self.translated(self.origin, way);
        }
        let image = self.acted(self.inverse, id)?;
        // A versor is moved at greater cost than is saved.
        (image == id || !kind.facts.unit_versor).then_some(image)
    }

    /// What a versor makes of a step; the step itself, if that is the same.
    fn acted(&mut self, versor: StepId, id: StepId) -> Option<StepId> {
        let image = self.builder.push(Step::Sandwich(versor, id)).ok()?;
        Some(if self.is_same(image, id) { id } else { image })
    }

    /// The coefficient of a step whose image is known.
    fn coefficient(
        &mut self,
        id: StepId,
        image: StepId,
        original: StepId,
        blade: Blade,
    ) -> Option<StepId> {
        let here = self.builder.push(Step::Coefficient(image, blade)).ok()?;
        if self.is_same(here, id) {
            return Some(here);
        }
        let back = self.moved_back(image, original)?;
        self.builder.push(Step::Coefficient(back, blade)).ok()
    }

    /// The step with that image.
    fn moved_back(&mut self, image: StepId, original: StepId) -> Option<StepId> {
        if self.is_same(image, original) {
            return Some(image);
        }
        let (witness, algebra) = (&self.builder.witness, self.builder.algebra);
        let reasons = witness.reasons(algebra, original, Some(self.model.point));
        let back = if reasons.is_empty() {
            let way = difference(&mut self.builder, self.point, self.origin)?;
            self.translated(image, way)?
        } else {
            let step = Step::Sandwich(self.translation, image);
            self.builder.push(step).ok()?
        };
        if !self.is_same(back, original) {
            return None;
        }
        if let Some(kind) = self.builder.program.kind(original) {
            self.builder.program.state_kind(back, kind);
        }
        Some(back)
    }

    /// The point at a way from another: the point of weight 1 of the vector `u = p + d`, which is
    /// `u − ½ u² N`.
    fn translated(&mut self, point: StepId, way: StepId) -> Option<StepId> {
        let sum = self.builder.push(Step::Sum(point, way)).ok()?;
        self.builder
            .on_the_cone(&self.model, self.infinity, sum)
            .ok()
    }

    fn is_same(&self, a: StepId, b: StepId) -> bool {
        let witness = &self.builder.witness;
        let mut pairs = witness.values(a).zip(witness.values(b));
        a == b || pairs.all(|(a, b)| numbers::equal(a, b))
    }
}

fn difference(builder: &mut Builder<'_>, a: StepId, b: StepId) -> Option<StepId> {
    let negative = builder.push(Step::Negative(b)).ok()?;
    builder.push(Step::Sum(a, negative)).ok()
}
