//! Refined values as weighted sums of coarse ones.

mod apply;
mod build;
mod compose;
mod value;

pub(super) use build::{Builder, Weights};
pub(super) use compose::SparseSum;
pub use value::Value;

/// A sparse matrix whose row i tells how value i of the fine mesh is a weighted sum of values of
/// the coarse one.
///
/// The weights depend on the faces and their creases alone, not on positions: computed once, they
/// give the fine vertices of a moving mesh in every frame, and carry colours, weights of a skin or
/// any other numbers along. The weights of a row have the sum 1, so that positions move with
/// rotations, translations and all other affine maps of the coarse mesh. (The rows of tangents have
/// the sum 0.)
///
/// A row may name a vertex more than once.
///
/// # Examples
///
/// ```
/// use ga_mesh::Faces;
/// use ga_mesh::subdivision::{Cage, Rules};
///
/// let triangle = Faces::from_polygons([[0, 1, 2]])?;
/// let stencils = Cage::new(triangle, 3, Rules::LOOP)?.refine()?.stencils;
///
/// let mut fine = [[0.0; 2]; 6];
/// stencils.apply(&[[0.0, 0.0], [8.0, 0.0], [0.0, 8.0]], &mut fine)?;
/// assert_eq!(fine, [[1.0, 1.0], [6.0, 1.0], [1.0, 6.0], [4.0, 0.0], [0.0, 4.0], [4.0, 4.0]]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Stencils {
    /// The number of coarse values.
    sources: usize,
    /// The number of fine values.
    rows: usize,
    runs: Vec<Run>,
    indices: Vec<u32>,
    weights: Vec<f64>,
}

/// Consecutive rows of equal length.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Run {
    /// The first row and the number of rows.
    first: u32,
    rows: u32,
    /// How many values each row adds.
    length: u32,
    /// Where in `indices` and `weights` those of the first row begin; those of the other rows
    /// follow.
    indices: usize,
    weights: usize,
    /// Whether all rows of the run have the weights of the first.
    shared: bool,
}

/// Slices that do not fit a matrix of stencils.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the stencils have {expected} {what}, but there are {found}")]
pub struct StencilLength {
    /// Which of the slices.
    pub what: &'static str,
    /// How long it must be.
    pub expected: usize,
    /// How long it is.
    pub found: usize,
}

impl Stencils {
    /// The number of coarse values.
    #[must_use]
    pub fn source_count(&self) -> usize {
        self.sources
    }

    /// The number of fine values.
    #[must_use]
    pub fn row_count(&self) -> usize {
        self.rows
    }

    /// The coarse values that fine value `row` is a sum of, and their weights.
    #[must_use]
    pub fn row(&self, row: usize) -> Option<(&[u32], &[f64])> {
        if row >= self.rows {
            return None;
        }
        let run = self.runs.partition_point(|run| run.first as usize <= row) - 1;
        let run = self.runs[run];
        Some(self.row_of(run, row - run.first as usize))
    }

    /// All rows, in order.
    pub fn iter(&self) -> impl Iterator<Item = (&[u32], &[f64])> {
        self.runs.iter().flat_map(move |&run| {
            let rows = 0..run.rows as usize;
            rows.map(move |row| self.row_of(run, row))
        })
    }

    /// Row `row` of a run.
    fn row_of(&self, run: Run, row: usize) -> (&[u32], &[f64]) {
        let length = run.length as usize;
        let indices = &self.indices[run.indices + row * length..][..length];
        let row_weights = if run.shared { 0 } else { row * length };
        let weights = &self.weights[run.weights + row_weights..][..length];
        (indices, weights)
    }
}
