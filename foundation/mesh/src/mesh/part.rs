//! Parts of meshes.

use crate::{Faces, Group, Mesh, Polylines};

/// A mesh cut out of a larger one, and where its vertices come from.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// The faces that were kept and only the vertices they use, both in their original order, with
    /// all their attributes; polylines and points are left out.
    pub mesh: Mesh,
    /// For each vertex of `mesh`, its index in the larger mesh, in ascending order.
    pub vertices: Vec<u32>,
}

impl Mesh {
    /// The faces of the group of this name, or of the object where there is no such group, with the
    /// vertices they use; `None` when there is neither.
    ///
    /// A mesh made for modelling may contain more than the body: guides for clothes, small cubes
    /// that mark joints.
    #[must_use]
    pub fn part(&self, name: &str) -> Option<Part> {
        let group = self.group(name).or_else(|| self.object(name))?;
        Some(self.part_of_faces(&group.faces))
    }

    /// `faces` are in range and in ascending order.
    fn part_of_faces(&self, faces: &[u32]) -> Part {
        let (vertices, kept) = self.used_vertices(faces);
        let corners = || {
            faces
                .iter()
                .flat_map(|&face| self.faces.corner_range(face as usize))
        };
        let at_vertices = |&v: &u32| v as usize;
        let mesh = Mesh {
            positions: vertices
                .iter()
                .map(at_vertices)
                .map(|v| self.positions[v])
                .collect(),
            faces: kept,
            colours: self.colours.as_ref().map(|colours| {
                vertices
                    .iter()
                    .map(at_vertices)
                    .map(|v| colours[v])
                    .collect()
            }),
            texture_coordinates: self
                .texture_coordinates
                .iter()
                .map(|set| set.at_corners(corners()))
                .collect(),
            normals: self
                .normals
                .as_ref()
                .map(|normals| normals.at_corners(corners())),
            tangents: self
                .tangents
                .as_ref()
                .map(|tangents| tangents.at_corners(corners())),
            groups: restricted(&self.groups, faces),
            objects: restricted(&self.objects, faces),
            materials: self.materials.clone(),
            face_materials: faces
                .iter()
                .filter_map(|&face| self.face_materials.get(face as usize).copied())
                .collect(),
            polylines: Polylines::default(),
            points: Vec::new(),
        };
        Part { mesh, vertices }
    }

    /// The vertices that these faces use, in ascending order, and the faces with these numbered.
    fn used_vertices(&self, faces: &[u32]) -> (Vec<u32>, Faces) {
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
        let mut polygon = Vec::new();
        for &face in faces {
            let corners = &self.faces.corners()[self.faces.corner_range(face as usize)];
            polygon.clear();
            polygon.extend(corners.iter().map(|&v| number[v as usize]));
            kept.push(&polygon)
                .expect("a face of a mesh is a face of its part");
        }
        (vertices, kept)
    }
}

/// The groups with only these faces, numbered by their place in the list; without empty groups.
fn restricted(groups: &[Group], faces: &[u32]) -> Vec<Group> {
    let groups = groups.iter().filter_map(|group| {
        let within = |face| faces.binary_search(face).ok().map(|index| index as u32);
        let faces: Vec<u32> = group.faces.iter().filter_map(within).collect();
        (!faces.is_empty()).then(|| Group {
            name: group.name.clone(),
            faces,
        })
    });
    groups.collect()
}
