//! The values of a program's steps at random points, by which types are checked while names are
//! resolved.

use super::choices::{self, Goal};
use super::coverage::{has_real_roots, is_comparison, is_covered, is_true};
use super::point::{Patience, Point, is_root, start};
use super::{Parity, Program, Step, StepId};
use crate::algebra::{Algebra, Blade, Product};
use crate::define::TypeDefinition;
use crate::ir::{Facts, Outcomes, Parts};
use crate::member::{self, Numbers, numbers};
use crate::order::Order as _;

/// How many points are tried before points are taken at which roots are multiples of i, and how
/// many before residues are given up.
const TRIES_WITH_REAL_ROOTS: u64 = 4096;
const TRIES: u64 = 2 * TRIES_WITH_REAL_ROOTS;

/// How many points are tried in real numbers before those are given up.
const TRIES_OF_REALS: u64 = 1024;

/// How many points decide what holds everywhere at least where absolute values are taken: a wrong
/// sign agrees at half of the points by chance.
const POINTS_WITH_SIGNS: usize = 16;

/// How many points with chosen outcomes are taken at most, and how many are tried for one of them
/// and for all.
const POINTS_WITH_OUTCOMES: usize = 64;
const TRIES_OF_ONE: u64 = 64;
const TRIES_WITH_OUTCOMES: u64 = 4096;

/// How many comparisons there are at least where points are added at which all of them hold, and
/// none.
const MANY_COMPARISONS: usize = 3;

/// How many points are taken at most until every root has been a residue.
const POINTS_WITH_ROOTS: usize = 64;

/// A program's values at random points of the operands' types.
///
/// Half of all residues have roots among the residues. As long as such points are found, all roots
/// are residues, and the root of a product is the product of the roots, as with positive numbers.
/// Where too many roots depend on the same operands, they are multiples of i at some points. There
/// the square of a root is still its argument, but `√x √y` is `√(x y)` or its negative, so what
/// needs this identity is refused.
///
/// Where a step depends on a sign, as roots, absolute values and choices do, each point has a real
/// number beside each residue, and what holds must hold in both. A value exists if it does in
/// either: residues have no root where several roots of one number are needed, and real numbers
/// none where the domain is so small that no random point hits it.
#[derive(Clone, Debug, Default)]
pub struct Witness {
    points: Vec<Point>,
    /// Points at which comparisons have outcomes that show a branch.
    chosen: Vec<Point>,
    tried: u64,
    tried_reals: u64,
    tried_with_outcomes: u64,
    /// Whether a step depends on a sign.
    has_signs: bool,
    /// How many steps there were when the points showed all outcomes.
    covered: usize,
    /// How many points the types of that many operands take.
    wanted: Option<(usize, usize)>,
}

impl Witness {
    /// Evaluates the steps that were added since the last time. `false` where no point is found at
    /// which all of them exist: something is divided by zero everywhere.
    pub fn extend(&mut self, algebra: &Algebra, program: &Program<'_>) -> bool {
        self.look_for_signs(algebra, program);
        let signs = if self.has_signs { POINTS_WITH_SIGNS } else { 0 };
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
        if points.is_empty() {
            self.covered = 0;
            self.chosen.clear();
        }
        let mut known = points.into_iter();
        loop {
            let is_real =
                self.tried < TRIES_WITH_REAL_ROOTS || has_real_roots(program, &self.points);
            let is_covered = || is_covered(program, &self.points, self.covered);
            if self.points.len() >= wanted && is_real && is_covered() {
                self.choose(algebra, program);
                return self.all_exist(program);
            }
            if !is_real && self.points.len() >= POINTS_WITH_ROOTS {
                return false;
            }
            let start = known.next().or_else(|| {
                self.tried += 1;
                self.start(algebra, program, self.tried - 1)
            });
            let Some(point) = start.and_then(|start| self.settle(algebra, program, start)) else {
                return false;
            };
            self.points.push(point);
        }
    }

    /// Gives real numbers to the points once a step depends on a sign.
    fn look_for_signs(&mut self, algebra: &Algebra, program: &Program<'_>) {
        let had_signs = std::mem::replace(&mut self.has_signs, program.has_signs());
        if self.has_signs == had_signs {
            return;
        }
        let mut points = std::mem::take(&mut self.points);
        for (seed, point) in (0..).zip(&mut points) {
            if let Some(other) = self.start(algebra, program, seed) {
                let real = Parts {
                    residue: false,
                    real: true,
                };
                point.redraw(&[], other, real);
            }
        }
        self.points = points;
    }

    /// Whether every step exists at some point.
    fn all_exist(&self, program: &Program<'_>) -> bool {
        let Some(first) = self.points.first() else {
            return program.is_empty();
        };
        first.missing.iter().all(|id| {
            let mut others = self.points.iter();
            others.any(|point| !point.missing.contains(id))
        })
    }

    /// Adds points that show the branches of choices, as far as there are some.
    fn choose(&mut self, algebra: &Algebra, program: &Program<'_>) {
        for point in std::mem::take(&mut self.chosen) {
            self.settle_chosen(algebra, program, point);
        }
        for (id, step) in program.steps_from(self.covered) {
            for goal in choices::goals(program, id) {
                let is_shown = |point: &Point| {
                    let mut goal = goal.iter();
                    goal.all(|(id, holds)| is_true(point, *id) == *holds)
                };
                if self.all().any(is_shown) {
                    continue;
                }
                if let Some(wanted) = choices::outcomes(program, &goal) {
                    self.add_chosen(algebra, program, wanted);
                }
            }
            if matches!(step, Step::Function(function, _) if is_comparison(*function)) {
                let comparisons: Vec<StepId> = program
                    .steps()
                    .take(id.index() + 1)
                    .filter(|(_, step)| {
                        matches!(step, Step::Function(function, _) if is_comparison(*function))
                    })
                    .map(|(id, _)| id)
                    .collect();
                if comparisons.len() == MANY_COMPARISONS {
                    for holds in [true, false] {
                        let all = comparisons.iter().map(|id| (*id, holds));
                        self.add_chosen(algebra, program, all.collect());
                    }
                }
            }
        }
        self.covered = program.len();
    }

    fn add_chosen(&mut self, algebra: &Algebra, program: &Program<'_>, wanted: Goal) {
        if self.chosen.len() >= POINTS_WITH_OUTCOMES {
            return;
        }
        let mut wanted = wanted;
        wanted.retain(|(id, _)| !program.is_constant(*id));
        let point = self.start_chosen(algebra, program);
        if let Some(point) = point {
            self.settle_chosen(algebra, program, Point { wanted, ..point });
        }
    }

    fn start_chosen(&mut self, algebra: &Algebra, program: &Program<'_>) -> Option<Point> {
        self.tried_with_outcomes += 1;
        start(
            algebra,
            program,
            (1 << 32) + self.tried_with_outcomes,
            false,
        )
    }

    /// Evaluates the missing steps at a point with chosen outcomes. It is dropped where no point
    /// with them is found: there may be none, such as where a chosen divisor is zero.
    fn settle_chosen(&mut self, algebra: &Algebra, program: &Program<'_>, mut point: Point) {
        let patience = Patience {
            with_real_roots: self.tried < TRIES_WITH_REAL_ROOTS,
            parts: Parts::BOTH,
        };
        for _ in 0..TRIES_OF_ONE {
            let Err((failed, parts)) = point.extend(algebra, program, &patience) else {
                self.chosen.push(point);
                return;
            };
            if self.tried_with_outcomes >= TRIES_WITH_OUTCOMES {
                return;
            }
            let Some(other) = self.start_chosen(algebra, program) else {
                return;
            };
            point.redraw(&free_operands(program, failed), other, parts);
        }
    }

    fn all(&self) -> impl Iterator<Item = &Point> {
        self.points.iter().chain(&self.chosen)
    }

    /// Evaluates the missing steps at a point. Where a step does not exist, the operands that it
    /// reads are drawn again, except for those that earlier roots read, which are settled. After
    /// many tries the point goes without the part that does not exist.
    fn settle(
        &mut self,
        algebra: &Algebra,
        program: &Program<'_>,
        mut point: Point,
    ) -> Option<Point> {
        loop {
            let patience = Patience {
                with_real_roots: self.tried < TRIES_WITH_REAL_ROOTS,
                parts: Parts {
                    residue: self.tried < TRIES,
                    real: self.has_signs && self.tried_reals < TRIES_OF_REALS,
                },
            };
            let Err((failed, parts)) = point.extend(algebra, program, &patience) else {
                return Some(point);
            };
            let tried = if parts.residue {
                self.covered = 0;
                &mut self.tried
            } else {
                &mut self.tried_reals
            };
            *tried += 1;
            let seed = *tried - 1 + if parts.residue { 0 } else { 1 << 33 };
            let other = self.start(algebra, program, seed)?;
            point.redraw(&free_operands(program, failed), other, parts);
        }
    }

    /// A point at which nothing is evaluated yet.
    fn start(&self, algebra: &Algebra, program: &Program<'_>, seed: u64) -> Option<Point> {
        start(algebra, program, seed, self.has_signs)
    }

    /// The values of another program with the same operands, at the same points; none where it has
    /// no value at one of them.
    pub(crate) fn of_other(&self, algebra: &Algebra, program: &Program<'_>) -> Option<Self> {
        let other = |point: &Point| {
            let mut other = Point {
                members: point.members.clone(),
                outcomes: point.outcomes.clone(),
                ..Point::default()
            };
            // A form may be rounded so that a sign in it cannot be decided.
            let patience = Patience {
                with_real_roots: false,
                parts: Parts {
                    residue: true,
                    real: false,
                },
            };
            other.extend(algebra, program, &patience).ok()?;
            Some(other)
        };
        Some(Self {
            has_signs: self.has_signs,
            points: self.points.iter().map(other).collect::<Option<_>>()?,
            chosen: self.chosen.iter().map(other).collect::<Option<_>>()?,
            ..Self::default()
        })
    }

    /// The values of a step.
    pub fn values(&self, id: StepId) -> impl Iterator<Item = &Numbers> {
        self.all().map(move |point| &point.values[id.index()])
    }

    /// The members of the operands' types at each point, the values of all steps, and the outcomes
    /// that are taken for comparisons.
    pub fn points(&self) -> impl Iterator<Item = (&[Numbers], &[Numbers], &Outcomes)> {
        self.all().map(|point| {
            let (members, values) = (point.members.as_slice(), point.values.as_slice());
            (members, values, &point.outcomes)
        })
    }

    /// The blades whose coefficients are not always zero.
    #[must_use]
    pub fn blades(&self, id: StepId) -> Vec<Blade> {
        let mut blades: Vec<Blade> = self
            .values(id)
            .flatten()
            .filter(|(_, number)| !number.is_zero())
            .map(|(blade, _)| *blade)
            .collect();
        blades.order();
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

    /// Whether a step is a member of a type.
    #[must_use]
    pub fn is_member(&self, algebra: &Algebra, id: StepId, kind: &TypeDefinition) -> bool {
        let mut values = self.values(id);
        values.all(|value| member::membership(algebra, Some(kind), value).is_empty())
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
        operands.order();
        operands.dedup();
        if id == failed {
            operands.retain(|operand| !settled.contains(operand));
            return operands;
        }
        if is_root(step) {
            settled.extend(&operands);
        }
        read.push(operands);
    }
    Vec::new()
}
