//! What a program's steps are at random points: the ground on which types are checked while names are resolved.

use super::evaluate::evaluate_step;
use super::{Program, StepId, evaluate};
use crate::algebra::{Algebra, Blade, Product, Unary};
use crate::define::TypeDefinition;
use crate::ir::{Facts, Prime};
use crate::verify::{self, numeric, numeric::Numbers};

/// How many points are looked for before a program is given up.
const TRIES: u64 = 4096;

/// A program's values at two random points of the operands' types.
#[derive(Clone, Debug, Default)]
pub struct Witness {
    points: Vec<Point>,
    tried: u64,
}

#[derive(Clone, Debug)]
struct Point {
    members: Vec<Numbers>,
    values: Vec<Numbers>,
}

impl Witness {
    /// Evaluates the steps that were added since the last time. `false` where no point is found at which all of them
    /// exist: something is divided by zero everywhere.
    pub fn extend(&mut self, algebra: &Algebra, program: &Program<'_>) -> bool {
        for point in &mut self.points {
            if !point.extend(algebra, program) {
                point.values.clear();
            }
        }
        let length = program.steps.len();
        self.points.retain(|point| point.values.len() == length);
        while self.points.len() < 2 {
            let Some(point) = self.search(algebra, program) else {
                return false;
            };
            self.points.push(point);
        }
        true
    }

    fn search(&mut self, algebra: &Algebra, program: &Program<'_>) -> Option<Point> {
        while self.tried < TRIES {
            let mut sequence = verify::sequence(self.tried);
            self.tried += 1;
            let members: Option<Vec<_>> = program
                .operands
                .iter()
                .map(|kind| verify::sample(algebra, kind, &mut sequence))
                .collect();
            let members = members?;
            if let Some(values) = evaluate(algebra, program, &members) {
                return Some(Point { members, values });
            }
        }
        None
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

    /// The blades that a step really has.
    #[must_use]
    pub fn blades(&self, id: StepId) -> Vec<Blade> {
        let mut blades: Vec<Blade> = self
            .values(id)
            .flatten()
            .filter(|(_, number)| **number != Prime::ZERO)
            .map(|(blade, _)| *blade)
            .collect();
        blades.sort();
        blades.dedup();
        blades
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

    /// Why a step is no member of a type; nothing if it is one.
    #[must_use]
    pub fn reasons(
        &self,
        algebra: &Algebra,
        id: StepId,
        kind: Option<&TypeDefinition>,
    ) -> Vec<verify::Reason> {
        let mut reasons = Vec::new();
        for value in self.values(id) {
            for reason in verify::membership(algebra, kind, value) {
                if !reasons.contains(&reason) {
                    reasons.push(reason);
                }
            }
        }
        reasons
    }

    /// Whether `M ~M = 1`, every grade of M is even or every one odd, and M moves vectors to vectors. In five dimensions
    /// and fewer the last follows from the others.
    #[must_use]
    pub fn is_unit_versor(&self, algebra: &Algebra, id: StepId) -> bool {
        let keeps_vectors = |value: &Numbers| {
            algebra.dimension() <= 5
                || (0..algebra.dimension()).all(|index| {
                    let vector = Numbers::from([(Blade::vector(index), Prime::ONE)]);
                    let moved = numeric::sandwich(algebra, value, &vector);
                    moved
                        .iter()
                        .all(|(blade, &number)| blade.grade() == 1 || number == Prime::ZERO)
                })
        };
        let parity: Vec<_> = self
            .blades(id)
            .iter()
            .map(|blade| blade.grade() % 2)
            .collect();
        let one = Numbers::from([(Blade::SCALAR, Prime::ONE)]);
        parity.windows(2).all(|pair| pair[0] == pair[1])
            && self.values(id).all(|value| {
                let reverse = numeric::unary(algebra, Unary::Reverse, value);
                let norm = numeric::product(algebra, Product::Geometric, value, &reverse);
                numeric::equal(&norm, &one) && keeps_vectors(value)
            })
    }

    /// The facts of a step that rules ask for, found by evaluation.
    #[must_use]
    pub fn facts(&self, algebra: &Algebra, id: StepId) -> Facts {
        let is_vector = self.blades(id).iter().all(|blade| blade.grade() == 1);
        let null = is_vector
            && self.values(id).all(|value| {
                let square = numeric::product(algebra, Product::ScalarProduct, value, value);
                numeric::equal(&square, &Numbers::new())
            });
        Facts {
            unit_versor: self.is_unit_versor(algebra, id),
            null,
            ..Facts::default()
        }
    }
}

impl Point {
    fn extend(&mut self, algebra: &Algebra, program: &Program<'_>) -> bool {
        let done = self.values.len();
        let members = program.operands.len() == self.members.len();
        members
            && program.steps().skip(done).all(|(_, step)| {
                let value = evaluate_step(algebra, step, &self.members, &self.values);
                value.map(|value| self.values.push(value)).is_some()
            })
    }
}
