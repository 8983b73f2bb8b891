//! Signed distances from closed surfaces.

use std::collections::HashMap;

use ga_runtime::cga3::Point;
use ga_runtime::vga3::Vector;

use super::{Bvh, Nearest, QueryError};
use crate::MeshError;

/// Why a surface has no inside.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NotClosed {
    /// An edge does not belong to exactly two triangles of opposite directions.
    #[error(
        "the edge from vertex {from} to vertex {to} has no triangle of its own on its other side"
    )]
    Edge {
        /// The vertex at which the edge begins.
        from: u32,
        /// The vertex at which it ends.
        to: u32,
    },
    /// The triangles are not those of a surface.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}

/// A closed surface, with the normals by which inside is told from outside: the angle-weighted
/// pseudo-normals of J. A. Bærentzen and H. Aanæs, Signed Distance Computation Using the Angle
/// Weighted Pseudonormal, 2005.
#[derive(Clone, Debug)]
pub struct ClosedSurface {
    bvh: Bvh,
    triangles: Vec<[u32; 3]>,
    faces: Vec<Vector<f64>>,
    /// Of the edges opposite to each corner.
    edges: Vec<[Vector<f64>; 3]>,
    vertices: Vec<Vector<f64>>,
}

impl ClosedSurface {
    /// The surface of these triangles, whose corners run counter-clockwise seen from outside.
    ///
    /// # Errors
    ///
    /// [`NotClosed::Edge`] for an edge without exactly one triangle on either side, in opposite
    /// directions; [`NotClosed::Mesh`] as [`Bvh::new`].
    ///
    /// ```
    /// use ga_mesh::query::ClosedSurface;
    /// use ga_runtime::cga3::Point;
    /// let corners = [[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 3.0]];
    /// let triangles = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
    /// let tetrahedron = ClosedSurface::new(&corners, &triangles)?;
    /// assert_eq!(tetrahedron.signed_distance(Point::new(0.5, 0.5, 0.25))?, -0.25);
    /// assert_eq!(tetrahedron.signed_distance(Point::new(-3.0, -4.0, 1.0))?, 5.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new<P: Copy + Into<Point<f64>>>(
        positions: &[P],
        triangles: &[[u32; 3]],
    ) -> Result<Self, NotClosed> {
        let bvh = Bvh::new(positions, triangles)?;
        let mut sides: HashMap<[u32; 2], usize> = HashMap::new();
        for (triangle, &[a, b, c]) in triangles.iter().enumerate() {
            for [from, to] in [[a, b], [b, c], [c, a]] {
                if from == to || sides.insert([from, to], triangle).is_some() {
                    return Err(NotClosed::Edge { from, to });
                }
            }
        }
        let position = |vertex: u32| Vector::from(positions[vertex as usize].into());
        let faces: Vec<Vector<f64>> = triangles
            .iter()
            .map(|triangle| crate::normals::area_vector(triangle.map(position)))
            .map(|normal| normal.normalized().unwrap_or_default())
            .collect();
        let mut vertices = vec![Vector::ZERO; positions.len()];
        let mut edges = Vec::with_capacity(triangles.len());
        for (&triangle, &face) in triangles.iter().zip(&faces) {
            let mut beside = [face; 3];
            for corner in 0..3 {
                let [a, b, c] = [0, 1, 2].map(|i| triangle[(corner + i) % 3]);
                let Some(&other) = sides.get(&[c, b]) else {
                    return Err(NotClosed::Edge { from: b, to: c });
                };
                beside[corner] += faces[other];
                let (u, v) = (position(b) - position(a), position(c) - position(a));
                vertices[a as usize] += face * u.cross(v).length().atan2(u.dot(v));
            }
            edges.push(beside);
        }
        Ok(Self {
            bvh,
            triangles: triangles.to_vec(),
            faces,
            edges,
            vertices,
        })
    }

    /// The hierarchy over the triangles.
    #[must_use]
    pub fn bvh(&self) -> &Bvh {
        &self.bvh
    }

    /// The distance of a point from the surface, negative inside.
    ///
    /// # Errors
    ///
    /// As [`Bvh::nearest`].
    pub fn signed_distance(&self, point: Point<f64>) -> Result<f64, QueryError> {
        let nearest = self.bvh.nearest(point)?;
        let offset = Vector::from(nearest.point).distance(point.into());
        let outwards = Vector::from(point) - Vector::from(nearest.point);
        let is_inside = offset > 0.0 && outwards.dot(self.pseudo_normal(&nearest)) < 0.0;
        Ok(if is_inside {
            -nearest.distance
        } else {
            nearest.distance
        })
    }

    /// The normal at a point of the surface, of any length: that of the face, the sum of those at
    /// an edge, or the sum weighted by angles at a vertex.
    fn pseudo_normal(&self, nearest: &Nearest) -> Vector<f64> {
        let triangle = nearest.triangle as usize;
        let is_zero = nearest.barycentric.map(|weight| weight == 0.0);
        match is_zero {
            [false, true, true] => self.vertices[self.triangles[triangle][0] as usize],
            [true, false, true] => self.vertices[self.triangles[triangle][1] as usize],
            [true, true, false] => self.vertices[self.triangles[triangle][2] as usize],
            [true, ..] => self.edges[triangle][0],
            [_, true, _] => self.edges[triangle][1],
            [.., true] => self.edges[triangle][2],
            _ => self.faces[triangle],
        }
    }
}
