//! Stencils, row by row.

use super::{Run, Stencils};

/// Stencils to which rows are added at the end.
pub(in super::super) struct Builder {
    stencils: Stencils,
}

/// Weights that rows may share.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in super::super) struct Weights {
    start: usize,
    length: u32,
}

impl Builder {
    /// An empty matrix, with memory for this many rows of about this many values in all.
    pub(in super::super) fn new(sources: usize, values: usize) -> Self {
        Self {
            stencils: Stencils {
                sources,
                rows: 0,
                runs: Vec::new(),
                indices: Vec::with_capacity(values),
                weights: Vec::new(),
            },
        }
    }

    /// Stores weights for rows to share.
    pub(in super::super) fn weights(&mut self, weights: impl IntoIterator<Item = f64>) -> Weights {
        let start = self.stencils.weights.len();
        self.stencils.weights.extend(weights);
        Weights {
            start,
            length: (self.stencils.weights.len() - start) as u32,
        }
    }

    /// Adds a row of shared weights: value `first` and then `others`, as many as weights.
    #[inline]
    pub(in super::super) fn shared(&mut self, weights: Weights, first: u32, others: &[u32]) {
        debug_assert_eq!(others.len() + 1, weights.length as usize);
        self.begin(weights, true);
        self.stencils.indices.push(first);
        self.stencils.indices.extend_from_slice(others);
    }

    /// Adds a row of shared weights, as many as indices.
    #[inline]
    pub(in super::super) fn shared_array<const LENGTH: usize>(
        &mut self,
        weights: Weights,
        indices: [u32; LENGTH],
    ) {
        debug_assert_eq!(LENGTH, weights.length as usize);
        self.begin(weights, true);
        self.stencils.indices.extend_from_slice(&indices);
    }

    /// Adds a row with weights of its own; a row needs at least one value.
    pub(in super::super) fn own(&mut self, row: &[(u32, f64)]) {
        debug_assert!(!row.is_empty());
        let weights = self.weights(row.iter().map(|&(_, weight)| weight));
        self.begin(weights, false);
        let indices = row.iter().map(|&(index, _)| index);
        self.stencils.indices.extend(indices);
    }

    /// Counts a row whose indices are added next.
    #[inline]
    fn begin(&mut self, weights: Weights, shared: bool) {
        let stencils = &mut self.stencils;
        let row = stencils.rows as u32;
        stencils.rows += 1;
        if let Some(run) = stencils.runs.last_mut() {
            let next = if run.shared {
                run.weights
            } else {
                run.weights + run.rows as usize * run.length as usize
            };
            if run.shared == shared && run.length == weights.length && next == weights.start {
                run.rows += 1;
                return;
            }
        }
        stencils.runs.push(Run {
            first: row,
            rows: 1,
            length: weights.length,
            indices: stencils.indices.len(),
            weights: weights.start,
            shared,
        });
    }

    pub(in super::super) fn finish(self) -> Stencils {
        self.stencils
    }
}
