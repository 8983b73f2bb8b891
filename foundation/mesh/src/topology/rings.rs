//! The faces around each vertex.

use super::{Edges, VertexCorners};
use crate::Faces;

/// The faces and edges around each vertex of a mesh, in order.
///
/// The faces at a vertex form *fans*: sequences in which each face has an edge at the vertex in
/// common with the next one, and no other face has that edge. At a vertex of a manifold there is
/// one fan: a closed one inside, an open one at the boundary. A vertex with several fans, as where
/// two cones touch with their tips, is not manifold. A fan ends at edges of one face and at edges
/// of more than two.
///
/// # Examples
///
/// ```
/// use ga_mesh::{Faces, topology::{Edges, VertexRings}};
///
/// // A pyramid without its base.
/// let faces = Faces::from_polygons([[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]])?;
/// let edges = Edges::new(&faces, 5)?;
/// let rings = VertexRings::new(&faces, &edges);
///
/// let apex = rings.fans(4).next().expect("a vertex with faces has a fan");
/// assert!(apex.closed);
/// assert!(apex.edges.iter().map(|&edge| edges.other_end(edge, 4)).eq([0, 1, 2, 3]));
///
/// let foot = rings.fans(0).next().expect("a vertex with faces has a fan");
/// assert!(!foot.closed);
/// assert!(foot.edges.iter().map(|&edge| edges.other_end(edge, 0)).eq([1, 4, 3]));
/// # Ok::<(), ga_mesh::MeshError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct VertexRings {
    /// Where in `spans` the fans of each vertex begin, and the end of the last.
    offsets: Vec<u32>,
    spans: Vec<Span>,
    corners: Vec<u32>,
    edges: Vec<u32>,
}

/// Where a fan's corners and edges begin, and how many faces it has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Span {
    corners: u32,
    edges: u32,
    faces: u32,
    closed: bool,
}

/// Faces around a vertex, each of which has an edge in common with the next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fan<'a> {
    /// The corners at the vertex, a face each; counter-clockwise seen from outside where the
    /// faces are oriented alike, otherwise as the first face has it.
    pub corners: &'a [u32],
    /// The edges at the vertex in the same order, beginning with the one before the first face: as
    /// many as faces in a closed fan, one more in an open fan.
    pub edges: &'a [u32],
    /// Whether the last face has an edge in common with the first.
    pub closed: bool,
}

impl VertexRings {
    /// The rings of the vertices of faces with these edges.
    ///
    /// # Panics
    ///
    /// When `edges` are the edges of other faces.
    #[must_use]
    pub fn new(faces: &Faces, edges: &Edges) -> Self {
        let count = faces.corners().len();
        assert_eq!(edges.of_corners().len(), count, "edges of other faces");
        let corners = VertexCorners::new(faces, edges.vertex_count());
        let mut visited = vec![false; count];
        let walk = Walk { faces, edges };
        let mut rings = Self {
            offsets: Vec::with_capacity(edges.vertex_count() + 1),
            spans: Vec::with_capacity(edges.vertex_count()),
            corners: Vec::with_capacity(count),
            edges: Vec::with_capacity(count + edges.len() / 8),
        };
        for vertex in 0..edges.vertex_count() as u32 {
            rings.offsets.push(rings.spans.len() as u32);
            let corners = corners.of(vertex);
            // Open fans first, from the end at which they begin.
            for &corner in corners {
                let [before, _] = walk.edges_at(corner);
                if !visited[corner as usize] && edges.sides(before).len() != 2 {
                    rings.push_fan(walk, &mut visited, corner);
                }
            }
            // An open fan whose faces are not oriented alike may have no such beginning.
            for &corner in corners {
                let [_, after] = walk.edges_at(corner);
                if !visited[corner as usize] && edges.sides(after).len() != 2 {
                    rings.push_fan(walk, &mut visited, corner);
                }
            }
            for &corner in corners {
                if !visited[corner as usize] {
                    rings.push_fan(walk, &mut visited, corner);
                }
            }
        }
        rings.offsets.push(rings.spans.len() as u32);
        rings
    }

    /// The fans of faces around a vertex, open fans first; none when no face uses the vertex.
    ///
    /// # Panics
    ///
    /// When there is no such vertex.
    pub fn fans(&self, vertex: u32) -> impl ExactSizeIterator<Item = Fan<'_>> {
        let vertex = vertex as usize;
        let spans = &self.spans[self.offsets[vertex] as usize..self.offsets[vertex + 1] as usize];
        spans.iter().map(|span| {
            let edges = (span.faces + u32::from(!span.closed)) as usize;
            Fan {
                corners: &self.corners[span.corners as usize..][..span.faces as usize],
                edges: &self.edges[span.edges as usize..][..edges],
                closed: span.closed,
            }
        })
    }

    /// Whether the faces around a vertex form at most one fan.
    #[must_use]
    pub fn is_manifold(&self, vertex: u32) -> bool {
        self.fans(vertex).len() <= 1
    }

    /// Adds the fan that begins at this corner, whose first edge is the one that the walk does not
    /// cross.
    fn push_fan(&mut self, walk: Walk<'_>, visited: &mut [bool], start: u32) {
        let (first_corner, first_edge) = (self.corners.len(), self.edges.len());
        let [before, after] = walk.edges_at(start);
        let backwards = walk.edges.sides(before).len() == 2 && walk.edges.sides(after).len() != 2;
        let mut entered = if backwards { after } else { before };
        let mut corner = start;
        let closed = loop {
            visited[corner as usize] = true;
            self.corners.push(corner);
            self.edges.push(entered);
            let [before, after] = walk.edges_at(corner);
            let left = if entered == before { after } else { before };
            match walk.across(corner, left) {
                Some(next) if !visited[next as usize] => (corner, entered) = (next, left),
                Some(next) if next == start => break true,
                _ => {
                    self.edges.push(left);
                    break false;
                }
            }
        };
        self.spans.push(Span {
            corners: first_corner as u32,
            edges: first_edge as u32,
            faces: (self.corners.len() - first_corner) as u32,
            closed,
        });
    }
}

/// The vertices whose faces form more than one fan, in rising order, of a mesh without edges of
/// three faces.
pub(crate) fn non_manifold_vertices(faces: &Faces, edges: &Edges) -> Vec<u32> {
    let corners = faces.corners();
    let mut faces_at = vec![0_u32; edges.vertex_count()];
    let mut corner_at = vec![0; edges.vertex_count()];
    for (corner, &vertex) in (0..).zip(corners) {
        faces_at[vertex as usize] += 1;
        corner_at[vertex as usize] = corner;
    }
    let walk = Walk { faces, edges };
    let mut vertices = Vec::new();
    for (vertex, (&faces, &start)) in (0..).zip(faces_at.iter().zip(&corner_at)) {
        if faces > 1 && walk.fan_size(start) != faces {
            vertices.push(vertex);
        }
    }
    vertices
}

/// Steps from face to face around a vertex.
#[derive(Clone, Copy)]
struct Walk<'a> {
    faces: &'a Faces,
    edges: &'a Edges,
}

impl Walk<'_> {
    /// The edge of the side that begins at a corner, and of the side that ends there: the edges
    /// before and after the face, counter-clockwise around the vertex.
    fn edges_at(self, corner: u32) -> [u32; 2] {
        let of_corners = self.edges.of_corners();
        [
            of_corners[corner as usize],
            of_corners[self.previous(corner) as usize],
        ]
    }

    /// How many faces the fan of a corner has, in a mesh without edges of three faces.
    #[inline]
    fn fan_size(self, start: u32) -> u32 {
        let [before, after] = self.edges_at(start);
        let mut size = 1;
        for mut left in [after, before] {
            let mut corner = start;
            while let Some(next) = self.across(corner, left) {
                if next == start {
                    return size;
                }
                size += 1;
                corner = next;
                let [before, after] = self.edges_at(corner);
                left = if left == before { after } else { before };
            }
        }
        size
    }

    fn previous(self, corner: u32) -> u32 {
        let range = self.range(corner);
        if corner == range.start {
            range.end - 1
        } else {
            corner - 1
        }
    }

    fn next(self, corner: u32) -> u32 {
        let range = self.range(corner);
        if corner + 1 == range.end {
            range.start
        } else {
            corner + 1
        }
    }

    /// The corners of the face of a corner.
    #[inline]
    fn range(self, corner: u32) -> std::ops::Range<u32> {
        if self.edges.all_triangles() {
            let first = corner - corner % 3;
            return first..first + 3;
        }
        let range = self
            .faces
            .corner_range(self.edges.face_of_corner(corner) as usize);
        range.start as u32..range.end as u32
    }

    /// The corner at the same vertex in the other face at an edge, if there is one other.
    fn across(self, corner: u32, edge: u32) -> Option<u32> {
        let &[one, other] = self.edges.sides(edge) else {
            return None;
        };
        let face = self.edges.face_of_corner(corner);
        let [of_one, of_other] = [one, other].map(|side| self.edges.face_of_corner(side));
        // A face that runs along the edge there and back has both sides.
        let is_one = match of_one == of_other {
            true => one == corner || (other != corner && one == self.previous(corner)),
            false => of_one == face,
        };
        let side = if is_one { other } else { one };
        let vertex = self.faces.corners()[corner as usize];
        let at_vertex = self.faces.corners()[side as usize] == vertex;
        Some(if at_vertex { side } else { self.next(side) })
    }
}
