//! What is regular about a mesh, and what is not.

use std::collections::HashMap;

use ga_runtime::vga3::Vector;

use super::outline::Outline;
use super::union::DisjointSets;
use super::{Components, Edges, VertexRings};
use crate::places::first_of_equal;
use crate::polygon::Plane;
use crate::{Faces, Mesh};

/// The shape of a mesh as a surface without regard to lengths, and every element at which it is not
/// a regular surface.
///
/// A *manifold* is a surface that looks like a plane at every inner point and like a half plane at
/// its boundary. A mesh is one when every edge has one or two sides of faces on it and the faces
/// around every vertex form one fan.
///
/// # Examples
///
/// ```
/// use ga_mesh::{Faces, Mesh, topology::Report};
///
/// // A tetrahedron without one of its faces.
/// let corners = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// let faces = Faces::from_polygons([[0, 2, 1], [0, 1, 3], [1, 2, 3]])?;
/// let report = Report::of_mesh(&Mesh::new(corners, faces)?);
/// assert_eq!((report.edges, report.euler_characteristic), (6, 1));
/// assert_eq!(report.boundary_loops.len(), 1);
/// assert!(report.is_manifold() && report.is_oriented());
/// assert_eq!(report.genus, Some(0));
/// # Ok::<(), ga_mesh::MeshError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Report {
    /// The number of vertices, those without a face included.
    pub vertices: usize,
    /// The number of faces.
    pub faces: usize,
    /// The number of edges, each pair of vertices that a face joins.
    pub edges: usize,
    /// The number of connected components; see [`Components`].
    pub components: usize,
    /// χ = V − E + F, with the vertices that faces use: 2 for a sphere, 1 for a disc, 0 for a
    /// torus.
    pub euler_characteristic: i64,
    /// The number of handles of all components together, g = (2C − B − χ) / 2 with C components
    /// and B boundary loops; `None` where the mesh is not an orientable manifold.
    pub genus: Option<u64>,
    /// The number of edges with one side.
    pub boundary_edges: usize,
    /// The vertices along each boundary, in order.
    pub boundary_loops: Vec<Vec<u32>>,
    /// The edges with more than two sides, by their ends.
    pub non_manifold_edges: Vec<[u32; 2]>,
    /// The vertices around which the faces form more than one fan.
    pub non_manifold_vertices: Vec<u32>,
    /// The edges whose two faces run along them in the same direction, so that one of the faces
    /// shows its back where the other shows its front.
    pub inconsistent_edges: Vec<[u32; 2]>,
    /// Whether the faces can be oriented alike, some perhaps reversed. A Möbius strip cannot.
    pub orientable: bool,
    /// The vertices that no face uses.
    pub unreferenced_vertices: Vec<u32>,
    /// The vertices at the very place of an earlier one.
    pub duplicate_vertices: Vec<u32>,
    /// The faces that name a vertex twice, but for those with a keyhole, or have the area vector 0,
    /// as faces whose corners lie on one line. A quadrilateral that crosses itself in its middle, a
    /// bow tie, is among them: the areas of its two halves have opposite signs.
    pub degenerate_faces: Vec<u32>,
    /// The faces with a hole to which a bridge leads: an edge along which the face runs to the ring
    /// of vertices around the hole, and back after it, so that the list of its corners names both
    /// ends twice. Apart from bridges every vertex is named once. They are regular: a bridge is an
    /// edge with two sides, and each ring is a boundary of its own unless other faces are there.
    pub keyhole_faces: Vec<u32>,
    /// The faces that have, seen along their area vector, an angle of more than 180° inside at a
    /// corner, which lies by more than 10⁻⁵ of the face's size on the inner side of the line
    /// through its neighbours.
    pub concave_faces: Vec<u32>,
    /// The faces with a corner that is farther than 10⁻⁵ of the face's size from the plane across
    /// the area vector through the mean of the corners.
    pub non_planar_faces: Vec<u32>,
    /// The faces with the vertices of an earlier one.
    pub duplicate_faces: Vec<u32>,
}

impl Report {
    /// Examines a mesh.
    #[must_use]
    pub fn of_mesh(mesh: &Mesh) -> Self {
        let faces = mesh.faces();
        let edges = Edges::of_mesh(mesh);
        let rings = VertexRings::new(faces, &edges);
        let components = Components::of_mesh(mesh).count;
        let unreferenced_vertices = unreferenced(mesh);
        let used = mesh.vertex_count() - unreferenced_vertices.len();
        let euler_characteristic = used as i64 - edges.len() as i64 + faces.len() as i64;
        let ends = |edge: u32| edges.ends(edge);
        let mut report = Self {
            vertices: mesh.vertex_count(),
            faces: faces.len(),
            edges: edges.len(),
            components,
            euler_characteristic,
            genus: None,
            boundary_edges: all(&edges).filter(|&edge| edges.is_boundary(edge)).count(),
            boundary_loops: boundary_loops(&edges, &rings),
            non_manifold_edges: edges.non_manifold().map(ends).collect(),
            non_manifold_vertices: (0..mesh.vertex_count() as u32)
                .filter(|&vertex| !rings.is_manifold(vertex))
                .collect(),
            inconsistent_edges: all(&edges)
                .filter(|&edge| same_direction(faces, &edges, edge) == Some(true))
                .map(ends)
                .collect(),
            orientable: is_orientable(faces, &edges),
            unreferenced_vertices,
            duplicate_vertices: duplicate_vertices(mesh),
            degenerate_faces: Vec::new(),
            keyhole_faces: Vec::new(),
            concave_faces: Vec::new(),
            non_planar_faces: Vec::new(),
            duplicate_faces: duplicate_faces(faces),
        };
        report.examine_faces(mesh);
        if report.is_manifold() && report.orientable {
            let loops = report.boundary_loops.len() as i64;
            let twice = 2 * components as i64 - loops - euler_characteristic;
            report.genus = u64::try_from(twice / 2).ok();
        }
        report
    }

    /// Fills the lists of faces of a certain shape.
    fn examine_faces(&mut self, mesh: &Mesh) {
        let mut plane = Plane::default();
        for (number, face) in (0..).zip(mesh.faces()) {
            let position = |&vertex: &u32| Vector::from(mesh.positions()[vertex as usize]);
            plane.set(face.iter().map(position));
            match Outline::of(face) {
                _ if plane.is_degenerate() => self.degenerate_faces.push(number),
                Outline::Repeated => self.degenerate_faces.push(number),
                Outline::Keyhole => self.keyhole_faces.push(number),
                Outline::Simple => {}
            }
            if face.len() > 3 && !plane.is_degenerate() {
                if plane.is_concave() {
                    self.concave_faces.push(number);
                }
                if plane.is_bent() {
                    self.non_planar_faces.push(number);
                }
            }
        }
    }

    /// Whether the mesh is a manifold, perhaps with a boundary.
    #[must_use]
    pub fn is_manifold(&self) -> bool {
        self.non_manifold_edges.is_empty() && self.non_manifold_vertices.is_empty()
    }

    /// Whether all neighbouring faces are oriented alike.
    #[must_use]
    pub fn is_oriented(&self) -> bool {
        self.inconsistent_edges.is_empty()
    }

    /// Whether the mesh is a manifold without boundary that encloses a volume.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.is_manifold() && self.boundary_edges == 0 && self.is_oriented() && self.faces > 0
    }
}

fn all(edges: &Edges) -> impl Iterator<Item = u32> + '_ {
    0..edges.len() as u32
}

fn unreferenced(mesh: &Mesh) -> Vec<u32> {
    let mut used = vec![false; mesh.vertex_count()];
    for &vertex in mesh.faces().corners() {
        used[vertex as usize] = true;
    }
    let unused = used.iter().enumerate().filter(|(_, used)| !**used);
    unused.map(|(vertex, _)| vertex as u32).collect()
}

/// Whether the two sides on an edge run in the same direction; `None` where there are not two.
fn same_direction(faces: &Faces, edges: &Edges, edge: u32) -> Option<bool> {
    let &[one, other] = edges.sides(edge) else {
        return None;
    };
    let [low, high] = edges.ends(edge);
    let start = |side: u32| faces.corners()[side as usize];
    Some(low != high && start(one) == start(other))
}

/// Whether the faces can be reversed such that the sides on every edge of two are opposite.
fn is_orientable(faces: &Faces, edges: &Edges) -> bool {
    // Element f is "face f stays as it is", element n + f is "face f is reversed". What must hold
    // together is united.
    let count = faces.len() as u32;
    let mut sets = DisjointSets::new(2 * faces.len());
    for edge in all(edges) {
        let Some(same) = same_direction(faces, edges, edge) else {
            continue;
        };
        let mut at_edge = edges.faces(edge);
        let (Some(a), Some(b)) = (at_edge.next(), at_edge.next()) else {
            continue;
        };
        let (b_if_a_stays, b_if_a_is_reversed) = if same { (b + count, b) } else { (b, b + count) };
        sets.unite(a, b_if_a_stays);
        sets.unite(a + count, b_if_a_is_reversed);
    }
    (0..count).all(|face| sets.find(face) != sets.find(face + count))
}

/// The vertices along each chain of boundary edges.
fn boundary_loops(edges: &Edges, rings: &VertexRings) -> Vec<Vec<u32>> {
    // At a vertex each open fan joins the two edges at its ends.
    let mut next: HashMap<(u32, u32), u32> = HashMap::new();
    for vertex in 0..edges.vertex_count() as u32 {
        for fan in rings.fans(vertex).filter(|fan| !fan.closed) {
            if let (Some(&first), Some(&last)) = (fan.edges.first(), fan.edges.last())
                && edges.is_boundary(first)
                && edges.is_boundary(last)
            {
                next.insert((vertex, first), last);
                next.insert((vertex, last), first);
            }
        }
    }
    let mut visited = vec![false; edges.len()];
    let mut loops = Vec::new();
    for start in all(edges).filter(|&edge| edges.is_boundary(edge)) {
        if visited[start as usize] {
            continue;
        }
        let [mut vertex, _] = edges.ends(start);
        let mut edge = start;
        let mut vertices = Vec::new();
        while !std::mem::replace(&mut visited[edge as usize], true) {
            vertices.push(vertex);
            vertex = edges.other_end(edge, vertex);
            match next.get(&(vertex, edge)) {
                Some(&following) => edge = following,
                None => break,
            }
        }
        loops.push(vertices);
    }
    loops
}

fn duplicate_vertices(mesh: &Mesh) -> Vec<u32> {
    let first = (0..).zip(first_of_equal(mesh.coordinates()));
    first
        .filter(|(vertex, first)| vertex != first)
        .map(|(vertex, _)| vertex)
        .collect()
}

fn duplicate_faces(faces: &Faces) -> Vec<u32> {
    let mut seen = HashMap::with_capacity(faces.len());
    let mut duplicates = Vec::new();
    for (index, face) in faces.iter().enumerate() {
        let mut sorted = face.to_vec();
        sorted.sort_unstable();
        if *seen.entry(sorted).or_insert(index) != index {
            duplicates.push(index as u32);
        }
    }
    duplicates
}
