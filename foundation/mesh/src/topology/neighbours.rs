//! The neighbours of each vertex.

use super::Edges;

/// For each vertex the vertices that an edge joins it to, in rising order.
///
/// # Examples
///
/// ```
/// use ga_mesh::{Faces, topology::{Edges, Neighbours}};
///
/// let faces = Faces::from_polygons([[0, 1, 2], [2, 1, 3]])?;
/// let neighbours = Neighbours::new(&Edges::new(&faces, 5)?);
/// assert_eq!(neighbours.of(1), [0, 2, 3]);
/// assert!(neighbours.of(4).is_empty());
/// # Ok::<(), ga_mesh::MeshError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Neighbours {
    /// Where in `vertices` the neighbours of each vertex begin, and the end of the last.
    offsets: Vec<u32>,
    vertices: Vec<u32>,
}

impl Neighbours {
    /// The neighbours of all vertices.
    #[must_use]
    pub fn new(edges: &Edges) -> Self {
        let mut offsets = vec![0_u32; edges.vertex_count() + 1];
        for &[a, b] in edges.all() {
            offsets[a as usize] += 1;
            offsets[b as usize] += 1;
        }
        let mut total = 0;
        for offset in &mut offsets {
            total += *offset;
            *offset = total;
        }
        // Filling from the back moves the end of each vertex to its beginning. The edges are
        // sorted by both ends, so that the neighbours of each vertex come in falling order.
        let mut vertices = vec![0; total as usize];
        for &[a, b] in edges.all().iter().rev() {
            for (vertex, neighbour) in [(a, b), (b, a)] {
                let place = &mut offsets[vertex as usize];
                *place -= 1;
                vertices[*place as usize] = neighbour;
            }
        }
        Self { offsets, vertices }
    }

    /// The neighbours of one vertex; itself among them when an edge joins it to itself.
    ///
    /// # Panics
    ///
    /// When there is no such vertex.
    #[inline]
    #[must_use]
    pub fn of(&self, vertex: u32) -> &[u32] {
        let vertex = vertex as usize;
        &self.vertices[self.offsets[vertex] as usize..self.offsets[vertex + 1] as usize]
    }
}
