//! The action of a normalised versor without its root.
//!
//! Let N be even, `N ~N = n + p` with a scalar n and a part p of grade 4 that commutes with N and
//! has square zero, and M the unit versor `N (n + p)^(−1/2)`, as the sum of several motors is
//! normalised. Then `(n + p)^(−1/2) = n^(−1/2) (1 − p/2n)`, so that for an X of grade 1
//!
//! `M X ~M = (N X ~N + N q ~N)/n` with `q = −(p X + X p)/2n + p X p/4n²`.
//!
//! Of the first part of q, of grades 3 and 5, N makes nothing of grade 1, and the last is a
//! multiple of the null vector that p contains, and stays one. So the coefficients of `M X ~M`
//! but that of infinity are those of `⟨N X ~N⟩₁/n`, and a point has its last coefficient from its
//! others. With `N X = X N + [N, X]` it is `X + ⟨[N, X] ~N⟩₁/n`, since `X p` has no grade 1 either.
//!
//! Without p the same holds for every grade. What holds is looked up at the points of the witness.

use super::Source;
use super::frame::Moved;
use crate::algebra::{Product, Unary};
use crate::ir::Function;
use crate::member::numbers;
use crate::program::build::Builder;
use crate::program::conformal::Conformal;
use crate::program::{Program, Step, StepId};

/// The program in which versors act without being normalised, if there are some.
pub(super) fn unnormalised<'a>(source: &Source<'_, 'a>) -> Option<Moved<'a>> {
    let is_needed = super::import::needed(source.program, source.wanted);
    let is_action =
        |(id, _): (StepId, &Step)| is_needed[id.index()] && action(source.program, id).is_some();
    if !source.program.steps().any(is_action) {
        return None;
    }
    let mut builder = Builder {
        algebra: source.algebra,
        program: source.program.clone(),
        witness: source.witness.clone(),
        operands: Vec::new(),
    };
    let mut images: Vec<Option<StepId>> = vec![None; source.program.len()];
    let mut has_changed = false;
    for (id, step) in source.program.steps() {
        if !is_needed[id.index()] {
            continue;
        }
        let mut image = id;
        if step
            .reads()
            .iter()
            .any(|read| images[read.index()] != Some(*read))
        {
            let next = step.mapped(|read| images[read.index()].unwrap_or(read));
            image = builder.push(next).ok()?;
        }
        if let Some((versor, operand)) = action(source.program, id)
            && let Some(found) = acted(source, &mut builder, versor, operand, id)
        {
            image = found;
            has_changed = true;
        }
        images[id.index()] = Some(image);
    }
    let wanted: Option<Vec<StepId>> = source.wanted.iter().map(|id| images[id.index()]).collect();
    has_changed.then_some(Moved {
        program: builder.program,
        witness: builder.witness,
        wanted: wanted?,
    })
}

/// The versor N and the operand of a step that is the action of N normalised.
fn action(program: &Program<'_>, id: StepId) -> Option<(StepId, StepId)> {
    let parts = |id: StepId| match *program.step(id) {
        Step::Binary(Product::Geometric, a, b) => Some((a, b)),
        _ => None,
    };
    let is_reverse = |id: StepId, of: StepId| *program.step(id) == Step::Unary(Unary::Reverse, of);
    let (versor, operand) = match *program.step(id) {
        Step::Sandwich(versor, operand) => (versor, operand),
        _ => {
            let (left, right) = parts(id)?;
            let first = parts(left).filter(|(versor, _)| is_reverse(right, *versor));
            let last = parts(right).filter(|(_, reverse)| is_reverse(*reverse, left));
            first.or(last.map(|(operand, _)| (left, operand)))?
        }
    };
    Some((sum(program, versor)?, operand))
}

/// What a versor is the multiple of that has norm 1.
fn sum(program: &Program<'_>, versor: StepId) -> Option<StepId> {
    match *program.step(versor) {
        Step::Sum(first, _) => match program.step(first) {
            Step::Quotient(..) => sum(program, first),
            _ => None,
        },
        Step::Quotient(sum, divisor) => {
            let is_root = matches!(
                program.step(divisor),
                Step::Function(Function::SquareRoot, _)
            );
            is_root.then_some(sum)
        }
        _ => None,
    }
}

/// `X + ⟨[N, X] ~N⟩/n`, or the point of it, if that is the given image.
fn acted<'a>(
    source: &Source<'_, 'a>,
    builder: &mut Builder<'a>,
    versor: StepId,
    operand: StepId,
    image: StepId,
) -> Option<StepId> {
    let grade = builder.witness.blades(image).first()?.grade();
    let half = Step::Binary(Product::Commutator, versor, operand);
    let half = builder.push(half).ok()?;
    let double = builder.push(Step::Sum(half, half)).ok()?;
    let reverse = builder.push(Step::Unary(Unary::Reverse, versor)).ok()?;
    let change = builder.geometric(double, reverse).ok()?;
    let change = builder
        .push(Step::Unary(Unary::Grade(grade), change))
        .ok()?;
    let norm = builder.norm_squared(versor).ok()?;
    let change = builder.push(Step::Quotient(change, norm)).ok()?;
    let found = builder.push(Step::Sum(operand, change)).ok()?;
    if is_same(builder, found, image) {
        return Some(found);
    }
    let kinds = source.program.operands.iter();
    let mut models = kinds.filter_map(|kind| Conformal::of(source.algebra, kind));
    let model = models.next()?;
    let infinity = builder.vector(&model.infinity).ok()?;
    let point = builder.on_the_cone(&model, infinity, found).ok()?;
    is_same(builder, point, image).then_some(point)
}

fn is_same(builder: &Builder<'_>, a: StepId, b: StepId) -> bool {
    let witness = &builder.witness;
    let mut pairs = witness.values(a).zip(witness.values(b));
    pairs.all(|(a, b)| numbers::equal(a, b))
}
