//! Lists of polylines.

use crate::MeshError;
use crate::lists::{Lists, TooMany};

/// Open chains of straight edges, each a list of at least two vertex indices, in one block of
/// memory. A closed chain ends with the vertex that it begins with.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Polylines {
    lines: Lists,
}

impl Polylines {
    /// Polylines from the lists of their vertices.
    ///
    /// # Errors
    ///
    /// [`MeshError::PolylineTooShort`] for fewer than two vertices; [`MeshError::TooLarge`] past
    /// 2³² − 1 vertices in total.
    pub fn from_lines<P: AsRef<[u32]>>(
        lines: impl IntoIterator<Item = P>,
    ) -> Result<Self, MeshError> {
        let mut polylines = Self::default();
        for line in lines {
            polylines.push(line.as_ref())?;
        }
        Ok(polylines)
    }

    /// Adds a polyline at the end.
    ///
    /// # Errors
    ///
    /// As [`Polylines::from_lines`]; the polyline is then not added.
    pub fn push(&mut self, line: &[u32]) -> Result<(), MeshError> {
        if line.len() < 2 {
            let (polyline, vertices) = (self.len(), line.len());
            return Err(MeshError::PolylineTooShort { polyline, vertices });
        }
        let what = "vertices of polylines";
        let too_many = |TooMany(count)| MeshError::TooLarge { what, count };
        self.lines.push(line).map_err(too_many)
    }

    /// How many polylines there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.lines.len()
    }

    /// Whether there is no polyline.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The vertices of polyline `index`.
    #[must_use]
    pub fn get(&self, index: usize) -> Option<&[u32]> {
        self.lines.get(index)
    }

    /// The polylines, one after the other.
    pub fn iter(&self) -> impl Iterator<Item = &[u32]> + '_ {
        (0..self.len()).filter_map(|index| self.lines.get(index))
    }
}
