//! The factors of the products in a program, however they are bracketed.

use super::piece::Pieces;
use crate::algebra::{Product, Unary};
use crate::program::{Program, Step, StepId};

/// How many steps deep the factors of an outer product are looked for. Those of a blade are few.
const DEEPEST: usize = 16;

/// Finds the factors of products. A product that several steps read, or that is computed on its
/// own, is one factor.
pub(super) struct Factors<'a> {
    program: &'a Program<'a>,
    pieces: &'a Pieces<'a>,
    /// How often each step is read.
    uses: Vec<usize>,
}

impl<'a> Factors<'a> {
    /// Of a program some steps of which are wanted.
    pub(super) fn new(program: &'a Program<'a>, pieces: &'a Pieces<'a>, wanted: &[StepId]) -> Self {
        let mut uses = vec![0; program.len()];
        // Only steps that the wanted ones need count as readers: checks have left others behind.
        let mut is_live = vec![false; program.len()];
        for id in wanted {
            is_live[id.index()] = true;
        }
        for (id, step) in program.steps().rev() {
            if is_live[id.index()] {
                for read in step.reads() {
                    is_live[read.index()] = true;
                    uses[read.index()] += 1;
                }
            }
        }
        Self {
            program,
            pieces,
            uses,
        }
    }

    /// The steps that are to be lowered for the wanted ones.
    pub(super) fn needed(&self, wanted: &[StepId]) -> Vec<bool> {
        let mut needed = vec![false; self.program.len()];
        for id in wanted {
            needed[id.index()] = true;
        }
        for (id, step) in self.program.steps().rev() {
            if !needed[id.index()] {
                continue;
            }
            let reads = match step {
                _ if self.pieces.contains_key(&id) => self.pieces[&id].reads(),
                Step::Binary(product @ (Product::Geometric | Product::Wedge), ..) => {
                    self.of_product(id, *product)
                }
                _ => step.reads(),
            };
            for read in reads {
                needed[read.index()] = true;
            }
        }
        needed
    }

    /// The factors of an associative product from left to right. A product that is read elsewhere
    /// too is one factor.
    pub(super) fn of_product(&self, id: StepId, product: Product) -> Vec<StepId> {
        let mut factors = Vec::new();
        let mut open = vec![id];
        while let Some(part) = open.pop() {
            match self.program.step(part) {
                Step::Binary(other, a, b)
                    if *other == product && (part == id || self.is_inside(part)) =>
                {
                    open.extend([*b, *a]);
                }
                _ => factors.push(part),
            }
        }
        factors
    }

    /// Whether nothing but one other step reads a step, and its product is not computed on its own.
    fn is_inside(&self, id: StepId) -> bool {
        self.uses[id.index()] == 1 && !self.pieces.contains_key(&id)
    }

    /// The factors of an outer product, or of its reverse or negative; and whether it is the
    /// negative of their product. A part deeper than some steps is one factor.
    pub(super) fn of_outer_product(&self, id: StepId) -> (Vec<StepId>, bool) {
        self.joined(id, DEEPEST)
    }

    fn joined(&self, id: StepId, deepest: usize) -> (Vec<StepId>, bool) {
        let next = deepest.saturating_sub(1);
        match self.program.step(id) {
            _ if deepest == 0 || self.pieces.contains_key(&id) => (vec![id], false),
            Step::Binary(Product::Wedge, a, b) => {
                let (mut factors, first) = self.joined(*a, next);
                let (others, second) = self.joined(*b, next);
                factors.extend(others);
                (factors, first != second)
            }
            Step::Unary(Unary::Reverse, a) if self.is_join(*a) => {
                let (factors, is_negative) = self.joined(*a, next);
                let is_reversed = factors.len() % 4 >= 2;
                (factors, is_negative != is_reversed)
            }
            Step::Negative(a) => {
                let (factors, is_negative) = self.joined(*a, next);
                (factors, !is_negative)
            }
            _ => (vec![id], false),
        }
    }

    /// Whether a step is an outer product, or its reverse or negative.
    fn is_join(&self, id: StepId) -> bool {
        let mut id = id;
        while let Step::Unary(Unary::Reverse, a) | Step::Negative(a) = self.program.step(id) {
            id = *a;
        }
        matches!(self.program.step(id), Step::Binary(Product::Wedge, ..))
    }
}
