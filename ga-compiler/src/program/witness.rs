//! The values of a program's steps at random points, by which types are checked while names are
//! resolved.

use super::evaluate::evaluate_step;
use super::{Parity, Program, Step, StepId};
use crate::algebra::{Algebra, Blade, Product};
use crate::define::TypeDefinition;
use crate::ir::{Facts, Function, Residue};
use crate::member::{self, Numbers, numbers};

/// How many points are tried before points are taken at which roots are multiples of i, and how many
/// before the search is given up.
const TRIES_WITH_REAL_ROOTS: u64 = 4096;
const TRIES: u64 = 2 * TRIES_WITH_REAL_ROOTS;

/// How many points decide what holds everywhere at least where absolute values are taken: a wrong
/// sign agrees at half of the points by chance.
const POINTS_WITH_SIGNS: usize = 16;

/// How many points are taken at most until every comparison has held and failed, and every two of
/// them in each combination.
const POINTS_WITH_CHOICES: usize = 48;

/// How many points are taken at most until every root has been a residue.
const POINTS_WITH_ROOTS: usize = 64;

/// A program's values at random points of the operands' types.
///
/// Half of all residues have roots among the residues. As long as such points are found, all roots
/// are residues, and the root of a product is the product of the roots, as with positive numbers.
/// Where too many roots depend on the same operands, they are multiples of i at some points. There
/// the square of a root is still its argument, but `√x √y` is `√(x y)` or its negative, so what
/// needs this identity is refused.
#[derive(Clone, Debug, Default)]
pub struct Witness {
    points: Vec<Point>,
    tried: u64,
    /// How many points the types of that many operands take.
    wanted: Option<(usize, usize)>,
}

#[derive(Clone, Debug)]
struct Point {
    members: Vec<Numbers>,
    values: Vec<Numbers>,
}

impl Witness {
    /// Evaluates the steps that were added since the last time. `false` where no point is found at
    /// which all of them exist: something is divided by zero everywhere.
    pub fn extend(&mut self, algebra: &Algebra, program: &Program<'_>) -> bool {
        // The root of a square is its absolute value.
        let is_sign = |step: &Step| {
            matches!(
                step,
                Step::Function(Function::Absolute | Function::SquareRoot, _)
            )
        };
        let signs = if program.steps.iter().any(is_sign) {
            POINTS_WITH_SIGNS
        } else {
            0
        };
        let operands = program.operands.len();
        let known = self.wanted.filter(|known| known.0 == operands);
        let known = known.unwrap_or_else(|| {
            let points = member::points(algebra, &program.operands);
            (operands, usize::try_from(points).unwrap_or(0))
        });
        self.wanted = Some(known);
        let wanted = known.1.max(signs);
        let mut points = std::mem::take(&mut self.points);
        points.retain(|point| point.members.len() == program.operands.len());
        let mut known = points.into_iter();
        loop {
            let is_real =
                self.tried < TRIES_WITH_REAL_ROOTS || has_real_roots(program, &self.points);
            if self.points.len() >= wanted && is_covered(program, &self.points) && is_real {
                return true;
            }
            if !is_real && self.points.len() >= POINTS_WITH_ROOTS {
                return false;
            }
            let start = known.next().or_else(|| self.start(algebra, program));
            let Some(point) = start.and_then(|start| self.settle(algebra, program, start)) else {
                return false;
            };
            self.points.push(point);
        }
    }

    fn start(&mut self, algebra: &Algebra, program: &Program<'_>) -> Option<Point> {
        let mut sequence = member::sequence(self.tried);
        self.tried += 1;
        let members = program.operands.iter();
        let members: Option<Vec<_>> = members
            .map(|kind| member::sample(algebra, kind, &mut sequence))
            .collect();
        members.map(|members| Point {
            members,
            values: Vec::new(),
        })
    }

    /// Evaluates the missing steps at a point. Where a step does not exist, the operands that it
    /// reads are drawn again, except for those that earlier roots read, which are settled.
    fn settle(
        &mut self,
        algebra: &Algebra,
        program: &Program<'_>,
        mut point: Point,
    ) -> Option<Point> {
        while let Err(failed) = point.extend(algebra, program, self.tried < TRIES_WITH_REAL_ROOTS) {
            if self.tried >= TRIES {
                return None;
            }
            let other = self.start(algebra, program)?;
            let free = free_operands(program, failed);
            point.values.clear();
            for (operand, member) in other.members.into_iter().enumerate() {
                if free.is_empty() || free.contains(&operand) {
                    point.members[operand] = member;
                }
            }
        }
        Some(point)
    }

    /// The values of a step.
    pub fn values(&self, id: StepId) -> impl Iterator<Item = &Numbers> {
        self.points
            .iter()
            .map(move |point| &point.values[id.index()])
    }

    /// The members of the operands' types at each point, and the values of all steps.
    pub fn points(&self) -> impl Iterator<Item = (&[Numbers], &[Numbers])> {
        self.points
            .iter()
            .map(|point| (point.members.as_slice(), point.values.as_slice()))
    }

    /// The blades whose coefficients are not always zero.
    #[must_use]
    pub fn blades(&self, id: StepId) -> Vec<Blade> {
        let mut blades: Vec<Blade> = self
            .values(id)
            .flatten()
            .filter(|(_, number)| **number != Residue::ZERO)
            .map(|(blade, _)| *blade)
            .collect();
        blades.sort();
        blades.dedup();
        blades
    }

    /// Which grades a step has.
    #[must_use]
    pub fn parity(&self, id: StepId) -> Parity {
        let blades = self.blades(id);
        let parities = [Parity::Even, Parity::Odd];
        let mut parities = parities.into_iter();
        let found = parities.find(|parity| blades.iter().all(|&blade| parity.allows(blade)));
        found.unwrap_or(Parity::Mixed)
    }

    /// Whether a step is a scalar.
    #[must_use]
    pub fn is_scalar(&self, id: StepId) -> bool {
        self.blades(id).iter().all(|blade| *blade == Blade::SCALAR)
    }

    /// Whether a step is zero everywhere.
    #[must_use]
    pub fn is_zero(&self, id: StepId) -> bool {
        self.blades(id).is_empty()
    }

    /// The reasons why a step is not a member of a type; none if it is one.
    #[must_use]
    pub fn reasons(
        &self,
        algebra: &Algebra,
        id: StepId,
        kind: Option<&TypeDefinition>,
    ) -> Vec<member::Reason> {
        let mut reasons = Vec::new();
        for value in self.values(id) {
            for reason in member::membership(algebra, kind, value) {
                if !reasons.contains(&reason) {
                    reasons.push(reason);
                }
            }
        }
        reasons
    }

    /// Whether `M ~M = 1`, every grade of M is even or every one odd, and M moves vectors to
    /// vectors. In five dimensions and fewer the last follows from the others.
    #[must_use]
    pub fn is_unit_versor(&self, algebra: &Algebra, id: StepId) -> bool {
        self.parity(id) != Parity::Mixed
            && self
                .values(id)
                .all(|value| numbers::is_unit_versor(algebra, value))
    }

    /// The facts of a step that rules ask for, found by evaluation.
    #[must_use]
    pub fn facts(&self, algebra: &Algebra, id: StepId) -> Facts {
        let is_vector = self.blades(id).iter().all(|blade| blade.grade() == 1);
        let null = is_vector
            && self.values(id).all(|value| {
                let square = numbers::product(algebra, Product::ScalarProduct, value, value);
                numbers::equal(&square, &Numbers::new())
            });
        Facts {
            unit_versor: self.is_unit_versor(algebra, id),
            null,
            ..Facts::default()
        }
    }
}

impl Point {
    /// Evaluates the missing steps, up to the first that does not exist here, or that is not a
    /// residue although roots shall be.
    fn extend(
        &mut self,
        algebra: &Algebra,
        program: &Program<'_>,
        with_real_roots: bool,
    ) -> Result<(), StepId> {
        for (id, _) in program.steps().skip(self.values.len()) {
            let value = evaluate_step(algebra, program, id, &self.members, &self.values);
            let value = value.ok_or(id)?;
            if with_real_roots && is_variable_root(program, id) && !is_real(&value) {
                return Err(id);
            }
            self.values.push(value);
        }
        Ok(())
    }
}

/// Whether a step is a root of what depends on operands.
fn is_variable_root(program: &Program<'_>, id: StepId) -> bool {
    matches!(program.step(id), Step::Function(Function::SquareRoot, _)) && !program.is_constant(id)
}

fn is_real(value: &Numbers) -> bool {
    value.values().all(|number| number.is_real())
}

/// Whether every root is a residue at some point: the root of `−x²` never is.
fn has_real_roots(program: &Program<'_>, points: &[Point]) -> bool {
    let mut roots = program
        .steps()
        .map(|(id, _)| id)
        .filter(|&id| is_variable_root(program, id));
    roots.all(|id| {
        let mut values = points.iter().map(|point| &point.values[id.index()]);
        points.is_empty() || values.any(is_real)
    })
}

/// Whether the points show the outcomes of the program's comparisons, one by one and in pairs, so
/// that no branch of a choice goes unseen.
fn is_covered(program: &Program<'_>, points: &[Point]) -> bool {
    let choices = program.steps().filter_map(|(id, step)| match step {
        Step::Function(function, arguments) if function.is_random_choice() => {
            // A comparison gives 0 or 1; the smaller or the larger number is the first or not.
            let reference = (!function.is_condition()).then_some(arguments[0]);
            Some((id, reference))
        }
        _ => None,
    });
    let outcomes: Vec<Vec<bool>> = choices
        .map(|(id, reference)| {
            let scalar = |point: &Point, id: StepId| {
                numbers::coefficient(&point.values[id.index()], Blade::SCALAR)
            };
            let of_point = |point: &Point| match reference {
                Some(first) => scalar(point, id) == scalar(point, first),
                None => scalar(point, id) != Residue::ZERO,
            };
            points.iter().map(of_point).collect()
        })
        .collect();
    let shows_all = |first: &[bool], second: &[bool]| {
        [(false, false), (false, true), (true, false), (true, true)]
            .into_iter()
            .all(|wanted| {
                first
                    .iter()
                    .copied()
                    .zip(second.iter().copied())
                    .any(|found| found == wanted)
            })
    };
    points.len() >= POINTS_WITH_CHOICES
        || outcomes.iter().enumerate().all(|(place, first)| {
            first.contains(&true)
                && first.contains(&false)
                && outcomes[..place]
                    .iter()
                    .all(|second| shows_all(first, second))
        })
}

/// The operands that a step depends on and that no earlier root depends on.
fn free_operands(program: &Program<'_>, failed: StepId) -> Vec<usize> {
    let mut read: Vec<Vec<usize>> = Vec::new();
    let mut settled = Vec::new();
    for (id, step) in program.steps() {
        let mut operands: Vec<usize> = match step {
            Step::Operand(number) => vec![*number],
            _ => step
                .reads()
                .iter()
                .flat_map(|part| read[part.index()].clone())
                .collect(),
        };
        operands.sort_unstable();
        operands.dedup();
        if id == failed {
            operands.retain(|operand| !settled.contains(operand));
            return operands;
        }
        if matches!(step, Step::Function(Function::SquareRoot, _)) {
            settled.extend(&operands);
        }
        read.push(operands);
    }
    Vec::new()
}
