//! Stencils of stencils.

use super::{Builder, StencilLength, Stencils};

impl Stencils {
    /// The stencils that give what `finer` gives of the values that these stencils give: the
    /// product of the two matrices. Over several levels of refinement this gives the finest values
    /// directly from the coarsest ones.
    ///
    /// No row of the result names a vertex twice.
    ///
    /// # Errors
    ///
    /// [`StencilLength`] when `finer` does not take as many values as these stencils give.
    pub fn then(&self, finer: &Self) -> Result<Self, StencilLength> {
        if finer.sources != self.rows {
            return Err(StencilLength {
                what: "fine values",
                expected: self.rows,
                found: finer.sources,
            });
        }
        let rows: Vec<_> = self.iter().collect();
        let mut product = Builder::new(self.sources, finer.indices.len() * 4);
        let mut sum = SparseSum::new(self.sources);
        for (indices, weights) in finer.iter() {
            for (&index, &weight) in indices.iter().zip(weights) {
                let (sources, shares) = rows[index as usize];
                for (&source, &share) in sources.iter().zip(shares) {
                    sum.add(source, weight * share);
                }
            }
            sum.take(|row| product.own(row));
        }
        Ok(product.finish())
    }

    /// The first rows alone.
    pub(in super::super) fn truncated(mut self, rows: usize) -> Self {
        while let Some(run) = self.runs.last_mut() {
            let first = run.first as usize;
            if first < rows {
                run.rows = run.rows.min((rows - first) as u32);
                break;
            }
            self.runs.pop();
        }
        self.rows = self.rows.min(rows);
        self
    }
}

/// A sum of few weights out of many.
pub(in super::super) struct SparseSum {
    /// For each source, its place in `terms`, if it has one.
    places: Vec<u32>,
    terms: Vec<(u32, f64)>,
}

impl SparseSum {
    const NONE: u32 = u32::MAX;

    pub(in super::super) fn new(sources: usize) -> Self {
        Self {
            places: vec![Self::NONE; sources],
            terms: Vec::new(),
        }
    }

    #[inline]
    pub(in super::super) fn add(&mut self, source: u32, weight: f64) {
        let place = &mut self.places[source as usize];
        if *place == Self::NONE {
            *place = self.terms.len() as u32;
            self.terms.push((source, weight));
        } else {
            self.terms[*place as usize].1 += weight;
        }
    }

    /// Hands over the terms, by rising source, and begins a new sum.
    pub(in super::super) fn take(&mut self, with: impl FnOnce(&[(u32, f64)])) {
        self.terms.sort_unstable_by_key(|&(source, _)| source);
        for &(source, _) in &self.terms {
            self.places[source as usize] = Self::NONE;
        }
        with(&self.terms);
        self.terms.clear();
    }
}
