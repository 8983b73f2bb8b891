//! The connected parts of a mesh.

use super::union::DisjointSets;
use crate::Mesh;

/// The connected components of the faces of a mesh: two faces are connected where they have a
/// vertex in common, directly or through others.
///
/// # Examples
///
/// ```
/// use ga_mesh::{Faces, Mesh, topology::Components};
///
/// let faces = Faces::from_polygons([[0, 1, 2], [3, 4, 5], [2, 1, 6]])?;
/// let mesh = Mesh::new(vec![[0.0; 3]; 7], faces)?;
/// let components = Components::of_mesh(&mesh);
/// assert_eq!(components.count, 2);
/// assert_eq!(components.of_faces, [0, 1, 0]);
/// # Ok::<(), ga_mesh::MeshError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Components {
    /// How many there are. Vertices without a face do not count.
    pub count: usize,
    /// The component of each face; components are numbered in the order of their first faces.
    pub of_faces: Vec<u32>,
}

impl Components {
    /// The components of a mesh.
    #[must_use]
    pub fn of_mesh(mesh: &Mesh) -> Self {
        let mut sets = DisjointSets::new(mesh.vertex_count());
        for face in mesh.faces() {
            for pair in face.windows(2) {
                sets.unite(pair[0], pair[1]);
            }
        }
        const NONE: u32 = u32::MAX;
        let mut numbers = vec![NONE; mesh.vertex_count()];
        let mut count = 0;
        let number = |face: &[u32]| {
            let number = &mut numbers[sets.find(face[0]) as usize];
            if *number == NONE {
                *number = count;
                count += 1;
            }
            *number
        };
        let of_faces = mesh.faces().iter().map(number).collect();
        Self {
            count: count as usize,
            of_faces,
        }
    }
}
