//! Stencils times values.

use super::{Run, StencilLength, Stencils, Value};

impl Stencils {
    /// Fills `fine` with the weighted sums of `coarse`, without allocating memory. Each sum is
    /// formed in the order of its row, in the precision of the values.
    ///
    /// # Errors
    ///
    /// [`StencilLength`] when `coarse` does not have [`Stencils::source_count`] values or `fine`
    /// does not have [`Stencils::row_count`]; `fine` is then left as it was.
    pub fn apply<V: Value>(&self, coarse: &[V], fine: &mut [V]) -> Result<(), StencilLength> {
        self.check(coarse.len(), fine.len(), 1)?;
        let mut rest = fine;
        for &run in &self.runs {
            let (fine, after) = rest.split_at_mut(run.rows as usize);
            rest = after;
            self.apply_run(run, coarse, fine);
        }
        Ok(())
    }

    /// As [`Stencils::apply`] for values of any number of `channels` each, one value after the
    /// other: the weights of a skin, for instance.
    ///
    /// # Errors
    ///
    /// As [`Stencils::apply`], with `channels` numbers for each value.
    pub fn apply_channels<V: Value<Sum = V>>(
        &self,
        channels: usize,
        coarse: &[V],
        fine: &mut [V],
    ) -> Result<(), StencilLength> {
        self.check(coarse.len(), fine.len(), channels)?;
        if channels == 0 {
            return Ok(());
        }
        for ((indices, weights), fine) in self.iter().zip(fine.chunks_exact_mut(channels)) {
            let mut terms = indices.iter().zip(weights).map(|(&index, &weight)| {
                (
                    &coarse[index as usize * channels..][..channels],
                    V::weight(weight),
                )
            });
            let Some((values, weight)) = terms.next() else {
                continue;
            };
            for (fine, &value) in fine.iter_mut().zip(values) {
                *fine = value.times(weight);
            }
            for (values, weight) in terms {
                for (fine, &value) in fine.iter_mut().zip(values) {
                    *fine = value.add_to(*fine, weight);
                }
            }
        }
        Ok(())
    }

    /// The weighted sums of `coarse`, as a new list.
    ///
    /// # Errors
    ///
    /// As [`Stencils::apply`].
    pub fn applied<V: Value>(&self, coarse: &[V]) -> Result<Vec<V>, StencilLength> {
        let Some(&any) = coarse.first() else {
            self.check(0, self.rows, 1)?;
            return Ok(Vec::new());
        };
        let mut fine = vec![any; self.rows];
        self.apply(coarse, &mut fine)?;
        Ok(fine)
    }

    fn check(&self, coarse: usize, fine: usize, channels: usize) -> Result<(), StencilLength> {
        let lengths = [
            ("coarse values", self.sources, coarse),
            ("fine values", self.rows, fine),
        ];
        for (what, expected, found) in lengths {
            let expected = expected.saturating_mul(channels);
            if expected != found {
                return Err(StencilLength {
                    what,
                    expected,
                    found,
                });
            }
        }
        Ok(())
    }

    #[inline]
    fn apply_run<V: Value>(&self, run: Run, coarse: &[V], fine: &mut [V]) {
        // With a length known to the compiler the weights stay in registers and the sum is
        // unrolled. These are the lengths of corners (1), creases (3), the smooth rules of Loop (4
        // for edges, n + 1 for vertices) and those of Catmull and Clark (4, 6 and 2n + 1).
        match run.length {
            1 => self.fixed::<1, V>(run, coarse, fine),
            2 => self.fixed::<2, V>(run, coarse, fine),
            3 => self.fixed::<3, V>(run, coarse, fine),
            4 => self.fixed::<4, V>(run, coarse, fine),
            5 => self.fixed::<5, V>(run, coarse, fine),
            6 => self.fixed::<6, V>(run, coarse, fine),
            7 => self.fixed::<7, V>(run, coarse, fine),
            8 => self.fixed::<8, V>(run, coarse, fine),
            9 => self.fixed::<9, V>(run, coarse, fine),
            _ => {
                for (row, fine) in fine.iter_mut().enumerate() {
                    let (indices, weights) = self.row_of(run, row);
                    *fine = sum(coarse, indices, weights);
                }
            }
        }
    }

    #[inline]
    fn fixed<const LENGTH: usize, V: Value>(&self, run: Run, coarse: &[V], fine: &mut [V]) {
        let (indices, _) = self.indices[run.indices..].as_chunks::<LENGTH>();
        let (weights, _) = self.weights[run.weights..].as_chunks::<LENGTH>();
        if run.shared {
            let weights = weights[0].map(V::weight);
            for (fine, indices) in fine.iter_mut().zip(indices) {
                *fine = fixed_sum(coarse, indices, &weights);
            }
        } else {
            for ((fine, indices), weights) in fine.iter_mut().zip(indices).zip(weights) {
                *fine = fixed_sum(coarse, indices, &weights.map(V::weight));
            }
        }
    }
}

#[inline]
fn fixed_sum<const LENGTH: usize, V: Value>(
    coarse: &[V],
    indices: &[u32; LENGTH],
    weights: &[V::Weight; LENGTH],
) -> V {
    let mut sum = coarse[indices[0] as usize].times(weights[0]);
    for (&index, &weight) in indices[1..].iter().zip(&weights[1..]) {
        sum = coarse[index as usize].add_to(sum, weight);
    }
    V::of_sum(sum)
}

/// A row is never empty.
fn sum<V: Value>(coarse: &[V], indices: &[u32], weights: &[f64]) -> V {
    let mut sum = coarse[indices[0] as usize].times(V::weight(weights[0]));
    for (&index, &weight) in indices[1..].iter().zip(&weights[1..]) {
        sum = coarse[index as usize].add_to(sum, V::weight(weight));
    }
    V::of_sum(sum)
}
