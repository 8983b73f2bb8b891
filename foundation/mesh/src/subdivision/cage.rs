//! Meshes to be refined.

use std::sync::OnceLock;

use super::{Boundary, Corner, Crease, Rules, Scheme, Tags};
use crate::topology::{self, Edges};
use crate::{Faces, MeshError};

/// The faces of a control mesh, with their creases and the rules that refine them.
///
/// Positions are not part of it: [`Cage::refine`] gives the faces of the next level and the
/// [`Stencils`](super::Stencils) that compute its vertices from any positions.
///
/// The faces may be of any number of corners in Catmull and Clark's scheme, and are triangles in
/// Loop's. They need not be oriented alike. Where two faces meet, their edge must be the side of no
/// third one. A vertex whose faces form several fans, as where two cones touch, is an infinitely
/// sharp corner, as in OpenSubdiv; an edge of three faces, which OpenSubdiv makes infinitely sharp,
/// is an error here. Vertices without a face stay where they are.
#[derive(Clone, Debug)]
pub struct Cage {
    pub(super) faces: Faces,
    pub(super) vertices: usize,
    pub(super) rules: Rules,
    pub(super) smoothing: Smoothing,
    /// Sharp edges between two faces, by rising ends, the lower end first.
    pub(super) creases: Vec<Crease>,
    /// Sharp vertices, in rising order.
    pub(super) corners: Vec<Corner>,
    /// The vertices that the rules make infinitely sharp, in rising order.
    pub(super) fixed: Vec<u32>,
    pub(super) edges: OnceLock<Edges>,
}

/// How new values are computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Smoothing {
    /// By the rules of the scheme.
    Smooth,
    /// The same, but values at the boundary are kept, and linear along it.
    FixedBoundary,
    /// As means of the ends of edges and of the corners of faces.
    Linear,
}

impl Cage {
    /// A control mesh of faces with this number of vertices, without creases.
    ///
    /// # Errors
    ///
    /// [`MeshError::NoFaces`], [`MeshError::IndexOutOfRange`],
    /// [`MeshError::NotATriangle`] in Loop's scheme, [`MeshError::DegenerateFace`]
    /// and [`MeshError::NonManifoldEdge`].
    pub fn new(faces: Faces, vertices: usize, rules: Rules) -> Result<Self, MeshError> {
        Self::with_smoothing(faces, vertices, rules, Smoothing::Smooth)
    }

    pub(super) fn with_smoothing(
        faces: Faces,
        vertices: usize,
        rules: Rules,
        smoothing: Smoothing,
    ) -> Result<Self, MeshError> {
        if faces.is_empty() {
            return Err(MeshError::NoFaces);
        }
        if rules.scheme == Scheme::Loop
            && let Some((face, polygon)) = faces.iter().enumerate().find(|(_, f)| f.len() != 3)
        {
            let corners = polygon.len();
            return Err(MeshError::NotATriangle { face, corners });
        }
        let edges = Edges::new(&faces, vertices)?;
        check_faces(&faces)?;
        if let Some(edge) = edges.non_manifold().next() {
            let ([a, b], faces) = (edges.ends(edge), edges.sides(edge).len());
            return Err(MeshError::NonManifoldEdge { a, b, faces });
        }
        let mut fixed = topology::non_manifold_vertices(&faces, &edges);
        if rules.boundary == Boundary::EdgeAndCorner {
            fixed.extend(vertices_of_one_face(&faces, vertices));
            fixed.sort_unstable();
            fixed.dedup();
        }
        let corners = fixed.iter().map(|&vertex| Corner {
            vertex,
            sharpness: f64::INFINITY,
        });
        Ok(Self {
            faces,
            vertices,
            rules,
            smoothing,
            creases: Vec::new(),
            corners: corners.collect(),
            fixed,
            edges: OnceLock::from(edges),
        })
    }

    /// The same control mesh with these creases and corners in place of earlier ones. Vertices that
    /// the rules make infinitely sharp stay so. A crease at the boundary has no effect, since all
    /// edges there are infinitely sharp.
    ///
    /// # Errors
    ///
    /// [`MeshError::NoEdge`], [`MeshError::NoVertex`] and
    /// [`MeshError::Sharpness`].
    pub fn with_tags(mut self, tags: &Tags) -> Result<Self, MeshError> {
        let check = |kind, index, sharpness: f64| {
            if sharpness >= 0.0 {
                return Ok(());
            }
            Err(MeshError::Sharpness {
                kind,
                index,
                sharpness,
            })
        };
        let edges = self.edges();
        let mut creases = Vec::with_capacity(tags.creases.len());
        for (
            crease,
            &Crease {
                vertices,
                sharpness,
            },
        ) in tags.creases.iter().enumerate()
        {
            check("crease", crease, sharpness)?;
            let [a, b] = vertices;
            let no_edge = MeshError::NoEdge { crease, a, b };
            let edge = edges.between(a, b).ok_or(no_edge)?;
            if !edges.is_boundary(edge) {
                creases.push((edge, sharpness));
            }
        }
        let mut corners = Vec::with_capacity(tags.corners.len() + self.corners.len());
        for (corner, &Corner { vertex, sharpness }) in tags.corners.iter().enumerate() {
            check("corner", corner, sharpness)?;
            if vertex as usize >= self.vertices {
                let vertices = self.vertices;
                return Err(MeshError::NoVertex {
                    corner,
                    vertex,
                    vertices,
                });
            }
            corners.push((vertex, sharpness));
        }
        corners.extend(self.fixed.iter().map(|&vertex| (vertex, f64::INFINITY)));

        self.creases = last_of_each(creases)
            .map(|(edge, sharpness)| Crease {
                vertices: edges.ends(edge),
                sharpness,
            })
            .collect();
        self.corners = last_of_each(corners)
            .map(|(vertex, sharpness)| Corner { vertex, sharpness })
            .collect();
        Ok(self)
    }

    /// The faces.
    #[must_use]
    pub fn faces(&self) -> &Faces {
        &self.faces
    }

    /// The number of vertices.
    #[must_use]
    pub fn vertex_count(&self) -> usize {
        self.vertices
    }

    /// The rules.
    #[must_use]
    pub fn rules(&self) -> Rules {
        self.rules
    }

    /// The creases that are still sharp, apart from the boundary.
    #[must_use]
    pub fn creases(&self) -> &[Crease] {
        &self.creases
    }

    /// The corners that are still sharp, those that the rules make sharp included.
    #[must_use]
    pub fn corners(&self) -> &[Corner] {
        &self.corners
    }

    /// The edges of the faces, computed when first asked for.
    #[must_use]
    pub fn edges(&self) -> &Edges {
        self.edges.get_or_init(|| {
            Edges::new(&self.faces, self.vertices).expect("the indices of a cage are in range")
        })
    }

    pub(super) fn smoothing(&self) -> Smoothing {
        self.smoothing
    }
}

/// No face may have a vertex twice.
fn check_faces(faces: &Faces) -> Result<(), MeshError> {
    let mut sorted = Vec::new();
    for (face, polygon) in faces.iter().enumerate() {
        let twice = match *polygon {
            [a, b, c] => {
                if a != b && b != c && c != a {
                    continue;
                }
                Some(if a == b || a == c { a } else { b })
            }
            _ => {
                sorted.clear();
                sorted.extend_from_slice(polygon);
                sorted.sort_unstable();
                sorted
                    .windows(2)
                    .find(|pair| pair[0] == pair[1])
                    .map(|pair| pair[0])
            }
        };
        if let Some(vertex) = twice {
            return Err(MeshError::DegenerateFace { face, vertex });
        }
    }
    Ok(())
}

/// The vertices of exactly one face, in rising order.
fn vertices_of_one_face(faces: &Faces, vertices: usize) -> impl Iterator<Item = u32> {
    let mut count = vec![0_u32; vertices];
    for &vertex in faces.corners() {
        count[vertex as usize] += 1;
    }
    let counted = count.into_iter().enumerate();
    counted.filter_map(|(vertex, count)| (count == 1).then_some(vertex as u32))
}

/// For each key in rising order its last value, unless that is 0.
fn last_of_each(mut values: Vec<(u32, f64)>) -> impl Iterator<Item = (u32, f64)> {
    // The sort is stable, so that the last of the entries with one key is the last in the list.
    values.sort_by_key(|&(key, _)| key);
    values.reverse();
    values.dedup_by_key(|&mut (key, _)| key);
    values.reverse();
    values.into_iter().filter(|&(_, sharpness)| sharpness > 0.0)
}
