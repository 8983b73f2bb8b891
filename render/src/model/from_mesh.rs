//! Models from meshes.

use std::path::Path;

use ga_mesh::{CornerAttribute, Mesh, Texture};

use super::textures::{Loader, TextureFileError};
use super::{Corners, Model, Part};

impl Model {
    /// A mesh as it is drawn. The files of its pictures are looked for in `folder`, or left out
    /// without one.
    ///
    /// Polygons are split as [`Mesh::triangles`] does. A corner without a normal makes its triangle
    /// flat; a mesh without normals is smooth. All textures of a material are placed by the texture
    /// coordinates and the change of them that its base colour asks for, or the first other texture
    /// that it has.
    ///
    /// # Errors
    ///
    /// [`TextureFileError`] for a picture that exists and cannot be read. A picture that does not
    /// exist is left out, with one of the [`warnings`](Model::warnings).
    pub fn from_mesh(mesh: &Mesh, folder: Option<&Path>) -> Result<Self, TextureFileError> {
        let mut model = Self::default();
        let mut loader = Loader::new(&mut model, folder);
        let mut surfaces = Vec::with_capacity(mesh.materials().len());
        for material in mesh.materials() {
            surfaces.push(loader.surface(material)?);
        }
        model.surfaces = surfaces;

        let corners = mesh.faces().corner_triangles();
        let materials = materials(mesh);
        let part = Part {
            positions: mesh.coordinates().collect(),
            triangles: mesh.triangles(),
            normals: mesh
                .normals()
                .map(|normals| at_corners(normals, &corners, |normal| normal.coordinates())),
            tangents: mesh.tangents().map(|tangents| {
                at_corners(tangents, &corners, |tangent| {
                    let [x, y, z] = tangent.direction.coordinates();
                    [x, y, z, tangent.handedness]
                })
            }),
            texture_coordinates: texture_coordinates(mesh, &corners, &materials),
            colours: mesh.colours().map(<[_]>::to_vec).unwrap_or_default(),
            materials,
        };
        model.parts.push(part);
        Ok(model)
    }
}

/// The material of each triangle.
fn materials(mesh: &Mesh) -> Vec<Option<u32>> {
    let mut materials = Vec::new();
    for (face, polygon) in mesh.faces().iter().enumerate() {
        let material = mesh.face_materials().get(face).copied().flatten();
        materials.extend(std::iter::repeat_n(material, polygon.len() - 2));
    }
    materials
}

fn at_corners<T, U>(
    attribute: &CornerAttribute<T>,
    corners: &[[u32; 3]],
    value: impl Fn(&T) -> U,
) -> Corners<U> {
    let index = |corner: u32| attribute.corners[corner as usize];
    Corners {
        values: attribute.values.iter().map(value).collect(),
        corners: corners
            .iter()
            .map(|&[a, b, c]| Some([index(a)?, index(b)?, index(c)?]))
            .collect(),
    }
}

/// The texture coordinates of each corner as its material asks for them.
fn texture_coordinates(
    mesh: &Mesh,
    corners: &[[u32; 3]],
    materials: &[Option<u32>],
) -> Option<Corners<[f64; 2]>> {
    let sets = mesh.texture_coordinate_sets();
    let first = sets.first()?;
    let textures: Vec<Option<&Texture>> = mesh
        .materials()
        .iter()
        .map(|material| material.textures().next())
        .collect();
    if !textures.iter().flatten().any(|texture| is_moved(texture)) {
        return Some(at_corners(first, corners, |&coordinates| coordinates));
    }
    let mut expanded = Corners {
        values: Vec::with_capacity(3 * corners.len()),
        corners: Vec::with_capacity(corners.len()),
    };
    for (&triangle, material) in corners.iter().zip(materials) {
        let texture = material.and_then(|material| textures[material as usize]);
        let set = texture.map_or(Some(first), |texture| sets.get(texture.set as usize));
        let here = set.and_then(|set| {
            let [a, b, c] = triangle.map(|corner| set.get(corner as usize).copied());
            Some([a?, b?, c?])
        });
        expanded.corners.push(here.map(|coordinates| {
            let begin = expanded.values.len() as u32;
            let moved = coordinates.map(|p| texture.map_or(p, |texture| place(texture, p)));
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

/// S R p + o; see [`Texture`].
fn place(texture: &Texture, [u, v]: [f64; 2]) -> [f64; 2] {
    let (sine, cosine) = texture.rotation.sin_cos();
    let rotated = [cosine * u - sine * v, sine * u + cosine * v];
    [0, 1].map(|i| texture.scale[i] * rotated[i] + texture.offset[i])
}
