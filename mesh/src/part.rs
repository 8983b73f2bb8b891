//! Parts of meshes.

use crate::{Faces, Group, Mesh, Texture};

/// A mesh cut out of a larger one, and where its vertices come from.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// The faces that were kept and only the vertices they use, both in their original order.
    pub mesh: Mesh,
    /// For each vertex of `mesh`, its index in the larger mesh, in ascending order.
    pub vertices: Vec<u32>,
}

impl Mesh {
    /// The faces of one group with the vertices they use, or `None` when there is no such group.
    ///
    /// A mesh made for modelling may contain more than the body: guides for clothes, small cubes
    /// that mark joints.
    #[must_use]
    pub fn part(&self, group: &str) -> Option<Part> {
        Some(self.part_of_faces(&self.group(group)?.faces))
    }

    /// `faces` are in range and in ascending order.
    fn part_of_faces(&self, faces: &[u32]) -> Part {
        const UNUSED: u32 = u32::MAX;
        let mut number = vec![UNUSED; self.positions.len()];
        for &face in faces {
            for &vertex in &self.faces.corners()[self.faces.corner_range(face as usize)] {
                number[vertex as usize] = 0;
            }
        }
        let mut vertices = Vec::new();
        for (old, new) in number.iter_mut().enumerate() {
            if *new != UNUSED {
                *new = vertices.len() as u32;
                vertices.push(old as u32);
            }
        }

        let mut kept = Faces::default();
        let mut texture_corners = Vec::new();
        for &face in faces {
            let range = self.faces.corner_range(face as usize);
            let corners: Vec<u32> = self.faces.corners()[range.clone()]
                .iter()
                .map(|&v| number[v as usize])
                .collect();
            kept.push(&corners)
                .expect("a face of a mesh is a face of its part");
            if let Some(texture) = &self.texture {
                texture_corners.extend_from_slice(&texture.corners[range]);
            }
        }
        let groups = self.groups.iter().filter_map(|group| {
            let within = |face| faces.binary_search(face).ok().map(|index| index as u32);
            let faces: Vec<u32> = group.faces.iter().filter_map(within).collect();
            (!faces.is_empty()).then(|| Group {
                name: group.name.clone(),
                faces,
            })
        });
        let mesh = Mesh {
            positions: vertices
                .iter()
                .map(|&v| self.positions[v as usize])
                .collect(),
            faces: kept,
            texture: self.texture.as_ref().map(|texture| Texture {
                coordinates: texture.coordinates.clone(),
                corners: texture_corners,
            }),
            groups: groups.collect(),
        };
        Part { mesh, vertices }
    }
}
