//! The lines of a text.

/// Where the lines of a text begin.
pub(super) struct Lines(Vec<usize>);

impl Lines {
    pub(super) fn new(text: &str) -> Self {
        let ends = text.match_indices('\n').map(|(place, _)| place + 1);
        Self([0].into_iter().chain(ends).collect())
    }

    /// The number of the line, from 1, in which the byte at a place is.
    pub(super) fn of(&self, place: usize) -> usize {
        self.0.partition_point(|start| *start <= place)
    }
}
