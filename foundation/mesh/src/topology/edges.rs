//! The edges of a mesh.

use super::sides::{self, Polygons, Sides, Triangles};
use crate::{Faces, Mesh, MeshError};

/// The edges of a mesh: each pair of vertices that some face joins, once.
///
/// Edges are sorted by their lower vertex, then by their higher one, so that their numbers do not
/// depend on the order of the faces. A side that joins a vertex to itself is an edge too, with
/// both ends equal.
///
/// Building takes time proportional to the sides, apart from a sort of the edges at each vertex.
///
/// # Examples
///
/// ```
/// use ga_mesh::{Faces, topology::Edges};
///
/// // Two triangles with a common edge.
/// let faces = Faces::from_polygons([[0, 1, 2], [2, 1, 3]])?;
/// let edges = Edges::new(&faces, 4)?;
/// assert_eq!(edges.all(), [[0, 1], [0, 2], [1, 2], [1, 3], [2, 3]]);
/// let shared = edges.between(2, 1).expect("it is a side of both");
/// assert_eq!(edges.sides(shared), [1, 3]);
/// assert!(edges.faces(shared).eq([0, 1]));
/// assert_eq!(edges.of_corners()[3], shared);
/// # Ok::<(), ga_mesh::MeshError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edges {
    /// The ends of each edge, the lower one first.
    ends: Vec<[u32; 2]>,
    /// For each vertex, the first edge of which it is the lower end; and the number of edges.
    first: Vec<u32>,
    /// For each corner, the edge of the side that begins there.
    of_corner: Vec<u32>,
    /// The sides of each edge, in rising order.
    sides: Vec<u32>,
    /// Where in `sides` those of each edge begin, and the end of the last.
    offsets: Vec<u32>,
    /// For each corner its face, unless all faces are triangles.
    face_of_corner: Option<Vec<u32>>,
}

impl Edges {
    /// The edges of faces with this number of vertices.
    ///
    /// # Errors
    ///
    /// [`MeshError::IndexOutOfRange`]; [`MeshError::TooLarge`] past 2³² − 1 vertices or corners.
    pub fn new(faces: &Faces, vertices: usize) -> Result<Self, MeshError> {
        match sides::as_triangles(faces) {
            Some(triangles) => Self::of_triangles(triangles, vertices),
            None => {
                sides::check(Polygons(faces), vertices)?;
                Ok(Self::of_sides(Polygons(faces), vertices))
            }
        }
    }

    /// The edges of triangles with this number of vertices; the corners of triangle t are 3t,
    /// 3t + 1 and 3t + 2.
    ///
    /// # Errors
    ///
    /// As [`Edges::new`].
    pub fn of_triangles(triangles: &[[u32; 3]], vertices: usize) -> Result<Self, MeshError> {
        sides::check(Triangles(triangles), vertices)?;
        Ok(Self::of_sides(Triangles(triangles), vertices))
    }

    /// The edges of a mesh.
    #[must_use]
    pub fn of_mesh(mesh: &Mesh) -> Self {
        Self::new(mesh.faces(), mesh.vertex_count()).expect("the indices of a mesh are in range")
    }

    /// The number of edges.
    #[must_use]
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Whether there is no edge.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// The number of vertices, including those without an edge.
    #[must_use]
    pub fn vertex_count(&self) -> usize {
        self.first.len() - 1
    }

    /// The ends of all edges, the lower one first.
    #[must_use]
    pub fn all(&self) -> &[[u32; 2]] {
        &self.ends
    }

    /// The ends of one edge, the lower one first.
    ///
    /// # Panics
    ///
    /// When there is no such edge, as in all methods that take the number of an edge.
    #[must_use]
    pub fn ends(&self, edge: u32) -> [u32; 2] {
        self.ends[edge as usize]
    }

    /// The end of an edge that is not `vertex`, which must be one of its ends.
    #[must_use]
    pub fn other_end(&self, edge: u32, vertex: u32) -> u32 {
        let [a, b] = self.ends(edge);
        a ^ b ^ vertex
    }

    /// The edge between two vertices, if a face joins them.
    #[must_use]
    pub fn between(&self, a: u32, b: u32) -> Option<u32> {
        let (low, high) = (a.min(b), a.max(b));
        let end = *self.first.get(low as usize + 1)? as usize;
        let begin = self.first[low as usize] as usize;
        let place = self.ends[begin..end].binary_search(&[low, high]).ok()?;
        Some((begin + place) as u32)
    }

    /// For each corner, the edge of the side that begins there.
    #[must_use]
    pub fn of_corners(&self) -> &[u32] {
        &self.of_corner
    }

    /// The sides that lie on an edge, by the corners where they begin, in rising order. A side runs
    /// from the lower end to the higher one when the vertex at its corner is the lower one.
    #[must_use]
    pub fn sides(&self, edge: u32) -> &[u32] {
        let edge = edge as usize;
        &self.sides[self.offsets[edge] as usize..self.offsets[edge + 1] as usize]
    }

    /// The faces at an edge, in rising order; a face appears once for each of its sides there.
    pub fn faces(&self, edge: u32) -> impl ExactSizeIterator<Item = u32> + '_ {
        self.sides(edge)
            .iter()
            .map(|&side| self.face_of_corner(side))
    }

    /// The face of a corner.
    ///
    /// # Panics
    ///
    /// When there is no such corner.
    #[must_use]
    pub fn face_of_corner(&self, corner: u32) -> u32 {
        match &self.face_of_corner {
            Some(faces) => faces[corner as usize],
            None => corner / 3,
        }
    }

    /// Whether every face has three corners.
    pub(super) fn all_triangles(&self) -> bool {
        self.face_of_corner.is_none()
    }

    /// Whether exactly one side lies on an edge.
    #[must_use]
    pub fn is_boundary(&self, edge: u32) -> bool {
        self.sides(edge).len() == 1
    }

    /// The edges with more than two sides, in rising order.
    pub fn non_manifold(&self) -> impl Iterator<Item = u32> + '_ {
        let pairs = self.offsets.windows(2).enumerate();
        pairs.filter_map(|(edge, ends)| (ends[1] - ends[0] > 2).then_some(edge as u32))
    }

    /// `sides` are checked.
    fn of_sides<S: Sides>(sides: S, vertices: usize) -> Self {
        // Sides are put in buckets by their lower vertex, as 64-bit numbers that sort by the
        // higher vertex and then by the corner.
        let mut ends_of_bucket = vec![0_u32; vertices + 1];
        sides.each(|_, a, b| ends_of_bucket[a.min(b) as usize + 1] += 1);
        let mut total = 0;
        for end in &mut ends_of_bucket {
            total += *end;
            *end = total;
        }
        // The end of bucket v − 1 is where bucket v begins; filling moves it to the end of v.
        let mut keys = vec![0_u64; sides.count()];
        sides.each(|corner, a, b| {
            let place = &mut ends_of_bucket[a.min(b) as usize];
            keys[*place as usize] = u64::from(a.max(b)) << 32 | u64::from(corner);
            *place += 1;
        });

        let mut edges = Self {
            ends: Vec::with_capacity(keys.len() / 2 + 1),
            first: Vec::with_capacity(vertices + 1),
            of_corner: vec![0; keys.len()],
            sides: Vec::with_capacity(keys.len()),
            offsets: Vec::with_capacity(keys.len() / 2 + 2),
            face_of_corner: sides.faces(),
        };
        let mut begin = 0;
        for (low, &end) in ends_of_bucket[..vertices].iter().enumerate() {
            edges.first.push(edges.ends.len() as u32);
            let bucket = &mut keys[begin..end as usize];
            begin = end as usize;
            sort(bucket);
            let mut last = None;
            for &key in &*bucket {
                let (high, corner) = ((key >> 32) as u32, key as u32);
                if last != Some(high) {
                    last = Some(high);
                    edges.offsets.push(edges.sides.len() as u32);
                    edges.ends.push([low as u32, high]);
                }
                edges.of_corner[corner as usize] = edges.ends.len() as u32 - 1;
                edges.sides.push(corner);
            }
        }
        edges.first.push(edges.ends.len() as u32);
        edges.offsets.push(edges.sides.len() as u32);
        edges
    }
}

/// Sorts numbers of which there are usually a handful.
#[inline]
fn sort(keys: &mut [u64]) {
    if keys.len() > 24 {
        keys.sort_unstable();
        return;
    }
    for sorted in 1..keys.len() {
        let key = keys[sorted];
        let mut place = sorted;
        while place > 0 && keys[place - 1] > key {
            keys[place] = keys[place - 1];
            place -= 1;
        }
        keys[place] = key;
    }
}
