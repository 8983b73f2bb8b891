//! Tangents of surfaces with texture coordinates, for normal maps.

use std::collections::HashMap;

use bevy_mikktspace::{Geometry, TangentSpace, generate_tangents};
use ga_runtime::vga3::Vector;

use crate::normals::vertex_normals;
use crate::polygon::Plane;
use crate::{CornerAttribute, Mesh, MeshError, Tangent, Tangents};

/// The tangents of a mesh by Mikkelsen's algorithm, which the programs that make and show normal
/// maps have in common.
///
/// Normals are those of the mesh, or [`vertex_normals`] where it has none. Quadrilaterals are left
/// to the algorithm, unless they are concave; these and faces of more corners are split as by
/// [`Mesh::triangles`]. A face gets no tangents where one of its corners
/// lacks a texture coordinate or has no normal. Tangents are computed in single precision.
///
/// Source: Mikkelsen, *Simulation of Wrinkled Surfaces Revisited*, 2008; the code is that of the
/// crate `bevy_mikktspace`.
///
/// # Errors
///
/// [`MeshError`].
///
/// # Examples
///
/// On a square whose picture lies upright, u grows along x and v along y:
///
/// ```
/// use ga_mesh::{obj, tangents};
///
/// let square = obj::decode(
///     b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n",
/// )?;
/// let tangents = tangents::mikktspace(&square, 0)?;
/// let tangent = tangents.get(0).ok_or("no tangent")?;
/// assert_eq!(tangent.direction.coordinates(), [1.0, 0.0, 0.0]);
/// assert_eq!(tangent.handedness, 1.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn mikktspace(mesh: &Mesh, set: usize) -> Result<Tangents, MeshError> {
    let texture = mesh
        .texture_coordinate_sets()
        .get(set)
        .ok_or(MeshError::NoTextureCoordinates { set })?;
    let mut surface = Surface::new(mesh, texture)?;
    match generate_tangents(&mut surface) {
        Ok(()) => Ok(surface.tangents()),
        // No reason exists in this version of the library.
        Err(_) => Err(MeshError::NoTextureCoordinates { set }),
    }
}

/// Triangles and quadrilaterals as the library takes them.
struct Surface {
    /// Three or four corners of the mesh for each, the last repeated for triangles.
    faces: Vec<[u32; 4]>,
    vertices: Vec<u32>,
    positions: Vec<[f32; 3]>,
    /// For each corner of the mesh.
    normals: Vec<[f32; 3]>,
    texture: Vec<[f32; 2]>,
    tangents: Vec<Option<TangentSpace>>,
}

impl Surface {
    fn new(mesh: &Mesh, texture: &CornerAttribute<[f64; 2]>) -> Result<Self, MeshError> {
        let corners = mesh.faces().corners();
        let mut positions = Vec::with_capacity(mesh.vertex_count());
        for (vertex, coordinates) in mesh.coordinates().enumerate() {
            let single = coordinates.map(|x| x as f32);
            if !single.iter().all(|x| x.is_finite()) {
                return Err(MeshError::TooFar {
                    vertex,
                    coordinates,
                });
            }
            positions.push(single);
        }
        for (index, &value) in texture.values.iter().enumerate() {
            if !value.iter().all(|&x| (x as f32).is_finite()) {
                return Err(MeshError::TextureTooLarge { index, value });
            }
        }
        let normals = corner_normals(mesh);
        let usable = |corner: u32| {
            let corner = corner as usize;
            texture.get(corner).is_some() && normals[corner] != Vector::default()
        };
        Ok(Self {
            faces: small_faces(mesh, usable),
            vertices: corners.to_vec(),
            positions,
            normals: normals
                .iter()
                .map(|normal| normal.coordinates().map(|x| x as f32))
                .collect(),
            texture: (0..corners.len())
                .map(|corner| {
                    texture
                        .get(corner)
                        .map_or([0.0; 2], |uv| uv.map(|x| x as f32))
                })
                .collect(),
            tangents: vec![None; corners.len()],
        })
    }

    fn corner(&self, face: usize, corner: usize) -> usize {
        self.faces[face][corner] as usize
    }

    fn tangents(&self) -> Tangents {
        let mut values = Vec::new();
        let mut numbers = HashMap::new();
        let corners = self.tangents.iter().map(|tangent| {
            let [x, y, z, handedness] = (*tangent)?.tangent_encoded();
            let direction = Vector::new(x, y, z).normalized()?;
            let key = [x, y, z, handedness].map(f32::to_bits);
            let number = *numbers.entry(key).or_insert_with(|| {
                values.push(Tangent {
                    direction: direction.coordinates().map(f64::from).into(),
                    handedness: handedness.into(),
                });
                values.len() as u32 - 1
            });
            Some(number)
        });
        let corners = corners.collect();
        Tangents { values, corners }
    }
}

/// The normal at each corner, the zero vector where there is none.
fn corner_normals(mesh: &Mesh) -> Vec<Vector<f64>> {
    let corners = mesh.faces().corners();
    if let Some(normals) = mesh.normals() {
        let normal = |corner| normals.get(corner).copied().unwrap_or_default();
        return (0..corners.len()).map(normal).collect();
    }
    let positions: Vec<[f64; 3]> = mesh.coordinates().collect();
    let normals = vertex_normals(&positions, &mesh.triangles());
    let of_vertex = |&vertex: &u32| Vector::from(normals[vertex as usize]);
    corners.iter().map(of_vertex).collect()
}

/// The faces all of whose corners are usable, split except for convex quadrilaterals.
fn small_faces(mesh: &Mesh, usable: impl Fn(u32) -> bool) -> Vec<[u32; 4]> {
    let faces = mesh.faces();
    let triangles = mesh.corner_triangles();
    let mut small = Vec::with_capacity(faces.len());
    let mut plane = Plane::default();
    for (face, polygon) in faces.iter().enumerate() {
        let range = faces.corner_range(face);
        let (first, end) = (range.start as u32, range.end as u32);
        if !(first..end).all(&usable) {
            continue;
        }
        plane.set(polygon.iter().map(|&v| mesh.positions()[v as usize].into()));
        if end - first == 4 && !plane.is_concave() {
            small.push([first, first + 1, first + 2, first + 3]);
        } else {
            let triangles = triangles[faces.triangle_range(face)].iter();
            small.extend(triangles.map(|&[a, b, c]| [a, b, c, c]));
        }
    }
    small
}

impl Geometry for Surface {
    fn num_faces(&self) -> usize {
        self.faces.len()
    }

    fn num_vertices_of_face(&self, face: usize) -> usize {
        let [.., third, fourth] = self.faces[face];
        if third == fourth { 3 } else { 4 }
    }

    fn position(&self, face: usize, corner: usize) -> [f32; 3] {
        self.positions[self.vertices[self.corner(face, corner)] as usize]
    }

    fn normal(&self, face: usize, corner: usize) -> [f32; 3] {
        self.normals[self.corner(face, corner)]
    }

    fn tex_coord(&self, face: usize, corner: usize) -> [f32; 2] {
        self.texture[self.corner(face, corner)]
    }

    fn set_tangent(&mut self, tangent: Option<TangentSpace>, face: usize, corner: usize) {
        let corner = self.corner(face, corner);
        if self.tangents[corner].is_none() {
            self.tangents[corner] = tangent;
        }
    }
}
