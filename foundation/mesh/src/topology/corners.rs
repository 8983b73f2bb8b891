//! The corners at each vertex.

use crate::Faces;

/// For each vertex the corners that lie at it, in rising order; there is one for each of its faces.
///
/// # Examples
///
/// ```
/// use ga_mesh::{Faces, topology::VertexCorners};
///
/// let faces = Faces::from_polygons([[0, 1, 2], [2, 1, 3]])?;
/// assert_eq!(VertexCorners::new(&faces, 4).of(1), [1, 4]);
/// # Ok::<(), ga_mesh::MeshError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct VertexCorners {
    /// Where in `corners` those of each vertex begin, and the end of the last.
    offsets: Vec<u32>,
    corners: Vec<u32>,
}

impl VertexCorners {
    /// The corners of faces with this number of vertices.
    ///
    /// # Panics
    ///
    /// When a face names a vertex that does not exist.
    #[must_use]
    pub fn new(faces: &Faces, vertices: usize) -> Self {
        let mut offsets = vec![0_u32; vertices + 1];
        for &vertex in faces.corners() {
            assert!(
                (vertex as usize) < vertices,
                "vertex {vertex} of {vertices}"
            );
            offsets[vertex as usize] += 1;
        }
        let mut total = 0;
        for offset in &mut offsets {
            total += *offset;
            *offset = total;
        }
        // Filling from the back moves the end of each vertex to its beginning.
        let mut corners = vec![0; faces.corners().len()];
        for (corner, &vertex) in faces.corners().iter().enumerate().rev() {
            let place = &mut offsets[vertex as usize];
            *place -= 1;
            corners[*place as usize] = corner as u32;
        }
        Self { offsets, corners }
    }

    /// The corners at one vertex.
    ///
    /// # Panics
    ///
    /// When there is no such vertex.
    #[inline]
    #[must_use]
    pub fn of(&self, vertex: u32) -> &[u32] {
        let vertex = vertex as usize;
        &self.corners[self.offsets[vertex] as usize..self.offsets[vertex + 1] as usize]
    }
}
