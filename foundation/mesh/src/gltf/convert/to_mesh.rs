//! From a document to a mesh.

use super::super::problem::{Element, Problem};
use super::super::{Document, Node, Primitive};
use super::material;
use super::place::{Placed, World};
use crate::places::first_of_equal;
use crate::{
    CornerAttribute, Faces, FormatError, Group, Mesh, MeshError, Normals, Polylines, Rgba, Tangent,
    Tangents,
};

/// What becomes of vertices with the same position.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Vertices {
    /// Each stays a vertex, so that they are numbered as in the file.
    #[default]
    Kept,
    /// Those with equal coordinates become one vertex, so that faces are connected across seams of
    /// texture coordinates and normals. Of their colours the first is kept. Corners of faces keep
    /// their texture coordinates, normals and tangents.
    Merged,
}

pub(super) fn mesh(document: &Document, vertices: Vertices) -> Result<Mesh, FormatError> {
    document.validate()?;
    let shown = document.shown_nodes();
    check_size(document, &shown)?;
    let world = World::new(document)?;
    let placed = shown.into_iter().flat_map(|index| {
        let (world, node) = (&world, &document.nodes[index]);
        let mesh = node.mesh.map(|mesh| &document.meshes[mesh]);
        let primitives = mesh.map_or(&[][..], |mesh| &mesh.primitives);
        let place = move |(number, primitive)| (index, number, world.place(index, node, primitive));
        primitives.iter().enumerate().map(place)
    });
    placed_mesh(document, placed, vertices)
}

/// The mesh of primitives, each given by a node, its number in the node's mesh, and its places.
pub(super) fn placed_mesh(
    document: &Document,
    placed: impl IntoIterator<Item = (usize, usize, Placed)>,
    vertices: Vertices,
) -> Result<Mesh, FormatError> {
    let mut parts = Parts::default();
    let mut last = None;
    for (index, number, placed) in placed {
        let fault = |problem| FormatError::gltf(Element::Node(index), problem);
        let found = document.nodes.get(index).and_then(|node| {
            let mesh = document.meshes.get(node.mesh?)?;
            Some((node, mesh, mesh.primitives.get(number)?))
        });
        let (node, mesh, primitive) = found.ok_or_else(|| fault(Problem::Missing("primitive")))?;
        let (expected, found) = (primitive.positions.len(), placed.positions.len());
        if expected != found {
            let problem = MeshError::VertexCount { expected, found };
            return Err(fault(Problem::Mesh(problem.into())));
        }
        if last != Some(index) {
            let name = name(index, node, mesh);
            parts.objects.push(Group {
                name,
                faces: Vec::new(),
            });
        }
        last = Some(index);
        let first_face = parts.faces.len() as u32;
        let added = parts.add(primitive, placed);
        added.map_err(|problem| fault(Problem::Mesh(problem.into())))?;
        if let Some(object) = parts.objects.last_mut() {
            object.faces.extend(first_face..parts.faces.len() as u32);
        }
    }
    if vertices == Vertices::Merged {
        parts.merge();
    }
    parts
        .into_mesh(document)
        .map_err(|problem| FormatError::gltf(Element::File, Problem::Mesh(problem.into())))
}

/// Many nodes may place one mesh. A few bytes for each must not become a mesh of any size, so nodes
/// may place 16 million corners and vertices, or each mesh a thousand times.
fn check_size(document: &Document, shown: &[usize]) -> Result<(), FormatError> {
    const FREE: u64 = 1 << 24;
    const TIMES: u64 = 1000;
    let size = |primitive: &Primitive| {
        let indices = primitive.indices.as_ref().map_or(0, Vec::len);
        (primitive.vertex_count() + indices) as u64
    };
    let meshes = document.meshes.iter();
    let sizes: Vec<u64> = meshes
        .map(|mesh| mesh.primitives.iter().map(size).sum())
        .collect();
    let placed = shown.iter().filter_map(|&node| document.nodes[node].mesh);
    let needed = placed.fold(0, |sum: u64, mesh| sum.saturating_add(sizes[mesh]));
    let limit = FREE.max(TIMES.saturating_mul(sizes.iter().sum()));
    if needed > limit {
        // As bytes: three numbers of eight bytes each.
        let [needed, limit] = [needed, limit].map(|count| count.saturating_mul(24));
        let problem = Problem::TooLarge { needed, limit };
        return Err(FormatError::gltf(Element::File, problem));
    }
    Ok(())
}

/// The name of a node, of its mesh, or else its number.
fn name(index: usize, node: &Node, mesh: &super::super::Mesh) -> String {
    let name = node.name.as_ref().or(mesh.name.as_ref());
    name.cloned().unwrap_or_else(|| format!("node {index}"))
}

/// A mesh under construction.
#[derive(Default)]
struct Parts {
    positions: Vec<[f64; 3]>,
    /// The vertices as they are numbered in `positions`, three for each face.
    faces: Vec<[u32; 3]>,
    face_materials: Vec<Option<u32>>,
    /// For each vertex its attributes; the corners of faces refer to the vertices before any merge.
    colours: Vec<Option<Rgba>>,
    texcoords: Vec<Vec<Option<[f64; 2]>>>,
    normals: Vec<Option<ga_runtime::vga3::Vector<f64>>>,
    tangents: Vec<Option<Tangent>>,
    /// For each vertex before any merge the one that it is now.
    merged: Option<Vec<u32>>,
    objects: Vec<Group>,
    polylines: Vec<Vec<u32>>,
    points: Vec<u32>,
}

impl Parts {
    fn add(&mut self, primitive: &Primitive, placed: Placed) -> Result<(), MeshError> {
        // A primitive without positions cannot be seen.
        let vertices = placed.positions.len();
        if vertices == 0 {
            return Ok(());
        }
        let first = self.positions.len();
        let count = first + vertices;
        let too_large = |_| MeshError::TooLarge {
            what: "vertices",
            count,
        };
        let offset = u32::try_from(count).map_err(too_large)? - vertices as u32;
        self.positions.extend(placed.positions);
        for mut triangle in primitive.triangles() {
            if placed.is_mirrored {
                triangle.swap(1, 2);
            }
            self.faces.push(triangle.map(|vertex| vertex + offset));
            self.face_materials
                .push(primitive.material.map(|m| m as u32));
        }
        let placed_at = |vertices: Vec<u32>| vertices.into_iter().map(move |v| v + offset);
        let lines = primitive.polylines().into_iter();
        self.polylines
            .extend(lines.map(|line| placed_at(line).collect()));
        self.points.extend(placed_at(primitive.points()));

        let colours = primitive.colours.first().into_iter().flatten();
        self.colours.extend(colours.map(|c| Some(c.map(f64::from))));
        self.colours.resize(count, None);
        for (set, coordinates) in primitive.texcoords.iter().enumerate() {
            if set == self.texcoords.len() {
                self.texcoords.push(vec![None; first]);
            }
            // glTF has v down.
            let upwards = |&[u, v]: &[f32; 2]| Some([u.into(), 1.0 - f64::from(v)]);
            self.texcoords[set].extend(coordinates.iter().map(upwards));
        }
        for set in &mut self.texcoords {
            set.resize(count, None);
        }
        let is_direction =
            |vector: &ga_runtime::vga3::Vector<f64>| vector.coordinates() != [0.0; 3];
        let normals = placed.normals.into_iter();
        self.normals
            .extend(normals.map(|normal| Some(normal).filter(is_direction)));
        self.normals.resize(count, None);
        let mirror = if placed.is_mirrored { -1.0 } else { 1.0 };
        let tangents = placed.tangents.into_iter().zip(&primitive.tangents);
        self.tangents
            .extend(tangents.map(|(direction, &[_, _, _, sign])| {
                let handedness = mirror * f64::from(sign).signum();
                let tangent = Tangent {
                    direction,
                    handedness,
                };
                is_direction(&direction).then_some(tangent)
            }));
        self.tangents.resize(count, None);
        Ok(())
    }

    /// Makes vertices with equal coordinates one.
    fn merge(&mut self) {
        let mut positions = Vec::new();
        let mut colours = Vec::new();
        let mut merged: Vec<u32> = Vec::with_capacity(self.positions.len());
        let first = first_of_equal(self.positions.iter().copied());
        for (vertex, first) in first.into_iter().enumerate() {
            let first = first as usize;
            if first == vertex {
                positions.push(self.positions[vertex]);
                colours.push(self.colours[vertex]);
                merged.push(positions.len() as u32 - 1);
            } else {
                merged.push(merged[first]);
            }
        }
        (self.positions, self.colours) = (positions, colours);
        for line in &mut self.polylines {
            line.iter_mut()
                .for_each(|vertex| *vertex = merged[*vertex as usize]);
        }
        self.points
            .iter_mut()
            .for_each(|vertex| *vertex = merged[*vertex as usize]);
        self.merged = Some(merged);
    }

    fn into_mesh(self, document: &Document) -> Result<Mesh, MeshError> {
        let corners: &[u32] = self.faces.as_flattened();
        let vertex = |&corner: &u32| match &self.merged {
            Some(merged) => merged[corner as usize],
            None => corner,
        };
        let polygons = self
            .faces
            .iter()
            .map(|face| face.map(|corner| vertex(&corner)));
        let mut mesh = Mesh::new(self.positions, Faces::from_polygons(polygons)?)?;
        if self.colours.iter().any(Option::is_some) {
            let colours = self.colours.iter().map(|colour| colour.unwrap_or([1.0; 4]));
            mesh = mesh.with_colours(colours.collect())?;
        }
        let texcoords = self.texcoords.iter();
        let texcoords = texcoords.map(|set| at_corners(set, corners));
        mesh = mesh.with_texture_coordinates(texcoords.collect())?;
        if self.normals.iter().any(Option::is_some) {
            let normals: Normals = at_corners(&self.normals, corners);
            mesh = mesh.with_normals(normals)?;
        }
        if self.tangents.iter().any(Option::is_some) {
            let tangents: Tangents = at_corners(&self.tangents, corners);
            mesh = mesh.with_tangents(tangents)?;
        }
        if !document.materials.is_empty() {
            let materials = material::to_materials(document);
            mesh = mesh.with_materials(materials, self.face_materials)?;
        }
        mesh.with_objects(self.objects)?
            .with_polylines(Polylines::from_lines(&self.polylines)?)?
            .with_points(self.points)
    }
}

/// The attribute of corners from that of vertices, of which some have none.
fn at_corners<T: Copy>(of_vertices: &[Option<T>], corners: &[u32]) -> CornerAttribute<T> {
    let mut values = Vec::new();
    let numbers: Vec<Option<u32>> = of_vertices
        .iter()
        .map(|value| {
            value.map(|value| {
                values.push(value);
                values.len() as u32 - 1
            })
        })
        .collect();
    let corners = corners.iter().map(|&vertex| numbers[vertex as usize]);
    CornerAttribute {
        corners: corners.collect(),
        values,
    }
}
