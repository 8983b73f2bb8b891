//! One step of refinement.

use std::sync::OnceLock;

use super::sharpness::Sharpness;
use super::{Cage, Scheme, Stencils, catmull_clark, loops};
use crate::MeshError;

/// One step of refinement.
#[derive(Clone, Debug)]
pub struct Refined {
    /// The refined faces with what is left of the creases.
    pub cage: Cage,
    /// The refined vertices as weighted sums of the coarse ones.
    pub stencils: Stencils,
}

impl Cage {
    /// The faces and vertices of the next level.
    ///
    /// Vertex v stays vertex v. With V vertices and E edges, the new vertex on edge e is V + e, and
    /// in Catmull and Clark's scheme the new vertex in face f is V + E + f.
    ///
    /// Loop's scheme puts four triangles in the place of each: one at each corner, which begins
    /// there, and the one in the middle, which begins with the vertex on the first side. Catmull
    /// and Clark's puts a quadrilateral in the place of each corner, which begins at that corner.
    ///
    /// # Errors
    ///
    /// [`MeshError::RefinedTooLarge`].
    pub fn refine(&self) -> Result<Refined, MeshError> {
        let edges = self.edges();
        let (old_corners, old_faces) = (self.faces.corners().len() as u64, self.faces.len() as u64);
        let (new_vertices, corners) = match self.rules.scheme {
            Scheme::Loop => (edges.len() as u64, 4 * old_corners),
            Scheme::CatmullClark => (edges.len() as u64 + old_faces, 4 * old_corners),
        };
        let vertices = self.vertices as u64 + new_vertices;
        for (what, count) in [("vertices", vertices), ("corners", corners)] {
            if count > u64::from(u32::MAX) {
                return Err(MeshError::RefinedTooLarge { what, count });
            }
        }
        let sharpness = Sharpness::new(self);
        let (faces, stencils) = match self.rules.scheme {
            Scheme::Loop => (loops::faces(self)?, loops::stencils(self, &sharpness)),
            Scheme::CatmullClark => (
                catmull_clark::faces(self)?,
                catmull_clark::stencils(self, &sharpness),
            ),
        };
        let cage = Self {
            faces,
            vertices: vertices as usize,
            rules: self.rules,
            smoothing: self.smoothing,
            creases: sharpness.refined_creases(),
            corners: sharpness.refined_corners(),
            fixed: self.fixed.clone(),
            edges: OnceLock::new(),
        };
        Ok(Refined { cage, stencils })
    }
}
