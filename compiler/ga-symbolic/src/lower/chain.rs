//! Chains of geometric products, in which a versor and its reverse may stand.

use std::ops::Range;

use rustc_hash::FxHashMap;

use crate::algebra::Unary;
use crate::program::{Program, Step, StepId};

/// What is open of a product of factors.
pub(super) enum Part {
    /// The product of some factors.
    Factors(Range<usize>),
    /// The product of the last two values.
    Product,
    /// The action of a versor on the last value.
    Action(StepId),
}

/// Where factors stand whose reverse is a factor too.
pub(super) struct Places {
    /// For each factor its reverses in the program: what it is the reverse of, and its reverse.
    reverses: Vec<[Option<StepId>; 2]>,
    /// The places of each factor, in rising order.
    places: FxHashMap<StepId, Vec<usize>>,
}

impl Places {
    pub(super) fn new(program: &Program<'_>, factors: &[StepId]) -> Self {
        let mut places: FxHashMap<StepId, Vec<usize>> = FxHashMap::default();
        for (place, factor) in factors.iter().enumerate() {
            places.entry(*factor).or_default().push(place);
        }
        let reverses = factors.iter().map(|&factor| {
            let inner = match program.step(factor) {
                Step::Unary(Unary::Reverse, inner) => Some(*inner),
                _ => None,
            };
            [inner, program.find(&Step::Unary(Unary::Reverse, factor))]
        });
        Self {
            reverses: reverses.collect(),
            places,
        }
    }

    /// The first of some factors that the last of them is the reverse of, with others between.
    pub(super) fn action(&self, range: &Range<usize>) -> Option<usize> {
        let last = range.end - 1;
        let first = |reverse: StepId| {
            let places = self.places.get(&reverse)?;
            let next = places.partition_point(|place| *place < range.start);
            places.get(next).copied()
        };
        let found = self.reverses[last].into_iter().flatten().filter_map(first);
        found.min().filter(|place| place + 1 < last)
    }
}
