//! Models from meshes.

use std::collections::HashMap;
use std::path::Path;

use ga_mesh::{CornerAttribute, Mesh, Texture, tangents};

use super::textures::{Loader, TextureFileError};
use super::{Corners, Model, Part};

impl Model {
    /// A mesh as it is drawn. The files of its pictures are looked for in `folder`, or left out
    /// without one.
    ///
    /// Each of the mesh's objects becomes an object of the scene, in their order, followed by the
    /// faces that are in none; a face in several belongs to the first. Polygons are split as
    /// [`Mesh::triangles`] does. A triangle with a corner without a normal is flat; a mesh without
    /// normals is smooth. A mesh with a normal map but without tangents gets those of MikkTSpace.
    ///
    /// Some things are drawn otherwise than the materials ask for; those with a mark have one of
    /// the [`warnings`](Model::warnings):
    ///
    /// - (marked) All textures of a material are placed by the set of texture coordinates and the
    ///   offset, rotation and scale of its base colour, or of the first other texture that it has.
    /// - (marked) Transparent surfaces, [`AlphaMode::Blend`](ga_mesh::AlphaMode::Blend), are drawn
    ///   opaque.
    /// - Both sides of each face are drawn, whether or not the material is
    ///   [`double_sided`](ga_mesh::Material::double_sided).
    /// - Textures of Phong's model are not used.
    ///
    /// Parts that a material cuts out, [`AlphaMode::Mask`](ga_mesh::AlphaMode::Mask), do not cast
    /// shadows.
    ///
    /// # Errors
    ///
    /// [`TextureFileError`] for a picture that exists and cannot be read. A picture that does not
    /// exist is left out, with a warning.
    pub fn from_mesh(mesh: &Mesh, folder: Option<&Path>) -> Result<Self, TextureFileError> {
        let mut model = Self::default();
        let mut loader = Loader::new(&mut model, folder);
        let mut surfaces = Vec::with_capacity(mesh.materials().len());
        for material in mesh.materials() {
            surfaces.push(loader.surface(material)?);
        }
        model.surfaces = surfaces;

        let triangles = Triangles::new(mesh);
        let normals = mesh
            .normals()
            .map(|normals| triangles.attribute(normals, |normal| normal.coordinates()));
        let mut computed = None;
        if mesh.tangents().is_none() && model.surfaces.iter().any(|s| s.normal.is_some()) {
            computed = tangents::mikktspace(mesh, 0).ok();
        }
        let tangents = mesh.tangents().or(computed.as_ref()).map(|tangents| {
            triangles.attribute(tangents, |tangent| {
                let [x, y, z] = tangent.direction.coordinates();
                [x, y, z, tangent.handedness]
            })
        });
        let texture_coordinates = texture_coordinates(mesh, &triangles);
        for members in members(mesh, &triangles) {
            model.parts.push(Part {
                normals: select(&normals, &members),
                texture_coordinates: select(&texture_coordinates, &members),
                tangents: select(&tangents, &members),
                ..part(mesh, &triangles, &members)
            });
        }
        model.normals = normals.map(|normals| normals.values).unwrap_or_default();
        model.tangents = tangents.map(|tangents| tangents.values).unwrap_or_default();
        model.texture_coordinates = texture_coordinates
            .map(|coordinates| coordinates.values)
            .unwrap_or_default();
        Ok(model)
    }
}

/// Values at the corners of all triangles.
struct Values<T> {
    values: Vec<T>,
    corners: Corners,
}

/// The triangles of a mesh.
struct Triangles {
    vertices: Vec<[u32; 3]>,
    /// The indices of the corners in the mesh's list of corners.
    corners: Vec<[u32; 3]>,
    materials: Vec<Option<u32>>,
    /// The face that each is a part of.
    faces: Vec<u32>,
}

impl Triangles {
    fn new(mesh: &Mesh) -> Self {
        let mut faces = Vec::new();
        for (face, polygon) in mesh.faces().iter().enumerate() {
            faces.extend(std::iter::repeat_n(face as u32, polygon.len() - 2));
        }
        let material = |&face: &u32| mesh.face_materials().get(face as usize).copied().flatten();
        Self {
            vertices: mesh.triangles(),
            corners: mesh.faces().corner_triangles(),
            materials: faces.iter().map(material).collect(),
            faces,
        }
    }

    fn attribute<T, U>(
        &self,
        attribute: &CornerAttribute<T>,
        value: impl Fn(&T) -> U,
    ) -> Values<U> {
        let index = |corner: u32| attribute.corners[corner as usize];
        let corners = self.corners.iter();
        Values {
            values: attribute.values.iter().map(value).collect(),
            corners: corners
                .map(|&[a, b, c]| Some([index(a)?, index(b)?, index(c)?]))
                .collect(),
        }
    }
}

/// The triangles of each object that has any.
fn members(mesh: &Mesh, triangles: &Triangles) -> Vec<Vec<usize>> {
    let rest = mesh.objects().len();
    let mut object_of_face = vec![rest; mesh.faces().len()];
    for (index, object) in mesh.objects().iter().enumerate().rev() {
        for &face in &object.faces {
            object_of_face[face as usize] = index;
        }
    }
    let mut members = vec![Vec::new(); rest + 1];
    for (triangle, &face) in triangles.faces.iter().enumerate() {
        members[object_of_face[face as usize]].push(triangle);
    }
    members.retain(|members| !members.is_empty());
    members
}

/// Some triangles with the vertices that they use, in the order of their use.
fn part(mesh: &Mesh, triangles: &Triangles, members: &[usize]) -> Part {
    let mut number: HashMap<u32, u32> = HashMap::new();
    let mut vertices = Vec::new();
    let mut part = Part::default();
    for &member in members {
        let corners = triangles.vertices[member].map(|vertex| {
            *number.entry(vertex).or_insert_with(|| {
                vertices.push(vertex as usize);
                (vertices.len() - 1) as u32
            })
        });
        part.triangles.push(corners);
        part.materials.push(triangles.materials[member]);
    }
    let positions = vertices.iter().map(|&vertex| mesh.positions()[vertex]);
    part.positions = positions.map(|position| position.coordinates()).collect();
    if let Some(colours) = mesh.colours() {
        part.colours = vertices.iter().map(|&vertex| colours[vertex]).collect();
    }
    part
}

fn select<T>(values: &Option<Values<T>>, members: &[usize]) -> Option<Corners> {
    let corners = &values.as_ref()?.corners;
    Some(members.iter().map(|&member| corners[member]).collect())
}

/// The texture coordinates of each corner as its material asks for them.
fn texture_coordinates(mesh: &Mesh, triangles: &Triangles) -> Option<Values<[f64; 2]>> {
    let sets = mesh.texture_coordinate_sets();
    let first = sets.first()?;
    let textures: Vec<Option<&Texture>> = mesh
        .materials()
        .iter()
        .map(|material| material.textures().next())
        .collect();
    if !textures.iter().flatten().any(|texture| is_moved(texture)) {
        return Some(triangles.attribute(first, |&coordinates| coordinates));
    }
    let mut expanded = Values {
        values: Vec::with_capacity(3 * triangles.corners.len()),
        corners: Vec::with_capacity(triangles.corners.len()),
    };
    for (&triangle, material) in triangles.corners.iter().zip(&triangles.materials) {
        let texture = material.and_then(|material| textures[material as usize]);
        let set = texture.map_or(Some(first), |texture| sets.get(texture.set as usize));
        let here = set.and_then(|set| {
            let [a, b, c] = triangle.map(|corner| set.get(corner as usize).copied());
            Some([a?, b?, c?])
        });
        expanded.corners.push(here.map(|coordinates| {
            let begin = expanded.values.len() as u32;
            let moved = coordinates.map(|p| texture.map_or(p, |texture| texture.place(p)));
            expanded.values.extend(moved);
            [begin, begin + 1, begin + 2]
        }));
    }
    Some(expanded)
}

fn is_moved(texture: &Texture) -> bool {
    texture.set != 0
        || texture.offset != [0.0; 2]
        || texture.rotation != 0.0
        || texture.scale != [1.0; 2]
}
