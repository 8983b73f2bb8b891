//! Models from meshes.

use std::collections::HashMap;
use std::path::Path;

use ga_image::colour::LinearColour;
use ga_mesh::{CornerAttribute, Mesh, tangents};

use super::textures::Loader;
use super::{Corners, Line, Model, Part};
use crate::texture::TextureError;

impl Model {
    /// A mesh as it is drawn. The files of its pictures are looked for in `folder`, or left out
    /// without one.
    ///
    /// Each of the mesh's objects becomes an object of the scene, in their order, followed by the
    /// faces that are in none; a face in several belongs to the first. Polygons are split as
    /// [`Mesh::triangles`] does. A triangle with a corner without a normal is flat; a mesh without
    /// normals is smooth. A mesh with a normal map but without tangents gets those of MikkTSpace.
    ///
    /// The back of a face is drawn where its material is
    /// [`double_sided`](ga_mesh::Material::double_sided) and where it has no material; see
    /// [`with_both_sides`](Model::with_both_sides). Textures that are placed by a third or later
    /// set of texture coordinates are placed by the first one, with one of the
    /// [`warnings`](Model::warnings). Textures of Phong's model are not used.
    ///
    /// Parts that a material cuts out, [`AlphaMode::Mask`](ga_mesh::AlphaMode::Mask), do not cast
    /// shadows; transparent parts cast one where their opacity is at least 1/2.
    ///
    /// # Errors
    ///
    /// [`TextureError`] for a picture that exists and cannot be read. A picture that does not
    /// exist is left out, with a warning.
    pub fn from_mesh(mesh: &Mesh, folder: Option<&Path>) -> Result<Self, TextureError> {
        let mut model = Self::default();
        let mut loader = Loader::new(&mut model, folder);
        let mut surfaces = Vec::with_capacity(mesh.materials().len());
        for material in mesh.materials() {
            surfaces.push(loader.surface(material)?);
        }
        model.surfaces = surfaces;
        model.set_shape(mesh);
        Ok(model)
    }

    /// Takes the faces, lines and points of another mesh, whose materials are those of this model:
    /// its mesh in another pose.
    pub fn set_shape(&mut self, mesh: &Mesh) {
        let model = self;
        let triangles = Triangles::new(mesh);
        let normals = mesh
            .normals()
            .map(|normals| triangles.attribute(normals, |normal| normal.coordinates()));
        let mut computed = None;
        if mesh.tangents().is_none() && model.surfaces.iter().any(|s| s.normal.is_some()) {
            let mut textures = mesh.materials().iter();
            let set = textures.find_map(|material| Some(material.normal_texture.as_ref()?.set));
            computed = tangents::mikktspace(mesh, set.unwrap_or(0) as usize).ok();
        }
        let tangents = mesh.tangents().or(computed.as_ref()).map(|tangents| {
            triangles.attribute(tangents, |tangent| {
                let [x, y, z] = tangent.direction.coordinates();
                [x, y, z, tangent.handedness]
            })
        });
        let mut sets = mesh.texture_coordinate_sets().iter();
        let texture_coordinates = [sets.next(), sets.next()]
            .map(|set| set.map(|set| triangles.attribute(set, |&coordinates| coordinates)));
        let parts = members(mesh, &triangles).into_iter().map(|members| Part {
            normals: select(&normals, &members),
            texture_coordinates: texture_coordinates
                .each_ref()
                .map(|set| select(set, &members)),
            tangents: select(&tangents, &members),
            ..part(mesh, &triangles, &members)
        });
        model.parts = parts.collect();
        model.normals = normals.map(|normals| normals.values).unwrap_or_default();
        model.tangents = tangents.map(|tangents| tangents.values).unwrap_or_default();
        model.texture_coordinates = texture_coordinates.map(|set| {
            let values = set.map(|coordinates| coordinates.values);
            values.unwrap_or_default()
        });
        model.lines = lines(mesh);
        model.dots = dots(mesh);
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
        for face in 0..mesh.faces().len() {
            let triangles = mesh.faces().triangle_range(face);
            faces.extend(triangles.map(|_| face as u32));
        }
        let material = |&face: &u32| mesh.face_materials().get(face as usize).copied().flatten();
        Self {
            vertices: mesh.triangles(),
            corners: mesh.corner_triangles(),
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

/// The colour of lines and points of a mesh without colours.
const INK: [u8; 3] = [30, 40, 60];

/// The edges of polylines. One between vertices of different colours has the mean of both.
fn lines(mesh: &Mesh) -> Vec<Line> {
    let place = |vertex: u32| mesh.positions()[vertex as usize].coordinates();
    let edges = mesh.polylines().iter().flat_map(|line| line.windows(2));
    let edges = edges.map(|edge| Line {
        ends: [place(edge[0]), place(edge[1])],
        colour: colour_of(mesh, edge[0]).lerp(colour_of(mesh, edge[1]), 0.5),
    });
    edges.collect()
}

fn dots(mesh: &Mesh) -> Vec<([f64; 3], LinearColour)> {
    let points = mesh.points().iter();
    let points = points.map(|&vertex| {
        let position = mesh.positions()[vertex as usize].coordinates();
        (position, colour_of(mesh, vertex))
    });
    points.collect()
}

fn colour_of(mesh: &Mesh, vertex: u32) -> LinearColour {
    mesh.colours()
        .map_or(LinearColour::from_srgb(INK), |colours| {
            let [red, green, blue, _] = colours[vertex as usize];
            LinearColour::new(red, green, blue)
        })
}
