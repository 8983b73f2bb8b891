//! Root mean squares.

/// The sum of squares of which the root mean square is taken.
#[derive(Clone, Debug, Default)]
pub(crate) struct MeanSquare {
    sum: f64,
    pub(crate) count: usize,
}

impl MeanSquare {
    pub(crate) fn add(&mut self, value: f64) {
        self.sum += value * value;
        self.count += 1;
    }

    /// `None` of nothing.
    pub(crate) fn root(&self) -> Option<f64> {
        (self.count > 0).then(|| (self.sum / self.count as f64).sqrt())
    }
}

impl FromIterator<f64> for MeanSquare {
    fn from_iter<I: IntoIterator<Item = f64>>(values: I) -> Self {
        let mut all = Self::default();
        for value in values {
            all.add(value);
        }
        all
    }
}
