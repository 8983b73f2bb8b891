//! From a mesh to a document.

use std::borrow::Cow;
use std::collections::BTreeMap;

use ga_runtime::vga3::Vector;
use serde_json::json;

use super::super::{self as gltf, Asset, Document, Mode, MorphTarget, Node, Primitive, Scene};
use super::material;
use crate::normals::vertex_normals;
use crate::{Mesh, tangents};

/// A morph target of a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Target<'a> {
    /// Its name.
    pub name: &'a str,
    /// The displacement of each vertex of the mesh where its weight is 1.
    pub displacements: &'a [Vector<f64>],
}

/// What all faces of a primitive have in common.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord)]
struct Kind {
    /// The object, or the number of objects for faces without one.
    object: usize,
    material: Option<u32>,
    /// For each set of texture coordinates whether all corners have them.
    texcoords: Vec<bool>,
    normals: bool,
    tangents: bool,
}

/// A corner as far as it matters to a vertex of a primitive: the vertex and the indices of the
/// corner's attributes.
type Key = (u32, Vec<Option<u32>>);

pub(super) fn document(mesh: &Mesh, targets: &[Target<'_>]) -> Document {
    let shape = &with_tangents(mesh);
    let mesh: &Mesh = shape;
    let targets: Vec<_> = targets.iter().map(|one| Moved::new(mesh, one)).collect();
    let names: Vec<_> = targets.iter().map(|target| target.name).collect();
    let mut document = Document {
        asset: Asset::of_this_crate(),
        scene: Some(0),
        ..Document::default()
    };
    material::from_materials(mesh.materials(), &mut document);
    // One list of primitives for each object, and one for faces without an object and for lines.
    let mut lists: Vec<Vec<Primitive>> = vec![Vec::new(); mesh.objects().len() + 1];
    let split = mesh.corner_triangles();
    for (kind, faces) in kinds(mesh) {
        let mut primitive = triangles(mesh, &split, &targets, &kind, &faces);
        let sets = primitive.texcoords.len();
        primitive.material = primitive
            .material
            .map(|material| material::with_sets(material, sets, &mut document));
        lists[kind.object].push(primitive);
    }
    lists[mesh.objects().len()].extend(lines(mesh, &targets));
    let named = lists.into_iter().enumerate().map(|(object, primitives)| {
        let object = mesh.objects().get(object);
        (object.map(|object| object.name.clone()), primitives)
    });
    let named = named.filter(|(_, primitives)| !primitives.is_empty());
    for (index, (name, primitives)) in named.enumerate() {
        document.meshes.push(gltf::Mesh {
            name: name.clone(),
            primitives,
            // The custom of programs that name morph targets; glTF itself has no names for them.
            extras: (!names.is_empty()).then(|| json!({ "targetNames": names })),
            ..gltf::Mesh::default()
        });
        document.nodes.push(Node {
            name,
            mesh: Some(index),
            ..Node::default()
        });
    }
    document.scenes.push(Scene {
        nodes: (0..document.nodes.len()).collect(),
        ..Scene::default()
    });
    document
}

/// The mesh with tangents where a material has a texture of normals, which is defined by them.
fn with_tangents(mesh: &Mesh) -> Cow<'_, Mesh> {
    let mut textures = mesh.materials().iter().map(|m| m.normal_texture.as_ref());
    if let Some(texture) = textures.find_map(|texture| texture)
        && mesh.normals().is_some()
        && mesh.tangents().is_none()
        && let Ok(tangents) = tangents::mikktspace(mesh, texture.set as usize)
        && let Ok(mesh) = mesh.clone().with_tangents(tangents)
    {
        return Cow::Owned(mesh);
    }
    Cow::Borrowed(mesh)
}

/// The faces of each kind, in the order of the objects and, within one, of the materials.
fn kinds(mesh: &Mesh) -> BTreeMap<Kind, Vec<usize>> {
    let mut objects = vec![mesh.objects().len(); mesh.faces().len()];
    for (index, object) in mesh.objects().iter().enumerate() {
        object
            .faces
            .iter()
            .for_each(|&face| objects[face as usize] = index);
    }
    let mut kinds: BTreeMap<Kind, Vec<usize>> = BTreeMap::new();
    for (face, &object) in objects.iter().enumerate() {
        let corners = mesh.faces().corner_range(face);
        let all = |list: &[Option<u32>]| list[corners.clone()].iter().all(Option::is_some);
        let normals = mesh.normals().is_some_and(|normals| all(&normals.corners));
        let kind = Kind {
            object,
            material: mesh.face_materials().get(face).copied().flatten(),
            texcoords: {
                let sets = mesh.texture_coordinate_sets().iter();
                // A set must not be missing where a later one is there.
                let mut has: Vec<bool> = sets.map(|set| all(&set.corners)).collect();
                let count = has.iter().position(|has| !has).unwrap_or(has.len());
                has[count..].fill(false);
                has
            },
            normals,
            tangents: normals
                && mesh
                    .tangents()
                    .is_some_and(|tangents| all(&tangents.corners)),
        };
        kinds.entry(kind).or_default().push(face);
    }
    kinds
}

/// The primitive of faces of one kind. Its vertices are in the order of those of the mesh, whose
/// triangles are `split`, as indices of corners.
fn triangles(
    mesh: &Mesh,
    split: &[[u32; 3]],
    targets: &[Moved<'_>],
    kind: &Kind,
    faces: &[usize],
) -> Primitive {
    let key = |corner: usize| -> Key {
        let sets = mesh.texture_coordinate_sets().iter().zip(&kind.texcoords);
        let texcoords = sets
            .filter(|(_, has)| **has)
            .map(|(set, _)| set.corners[corner]);
        let normal = mesh.normals().filter(|_| kind.normals);
        let tangent = mesh.tangents().filter(|_| kind.tangents);
        let directions = [
            normal.and_then(|normals| normals.corners[corner]),
            tangent.and_then(|tangents| tangents.corners[corner]),
        ];
        let vertex = mesh.faces().corners()[corner];
        (vertex, texcoords.chain(directions).collect())
    };
    // For each distinct corner its first index in the mesh, then its index in the primitive.
    let mut corners: BTreeMap<Key, (usize, u32)> = BTreeMap::new();
    for &face in faces {
        for corner in mesh.faces().corner_range(face) {
            corners.entry(key(corner)).or_insert((corner, 0));
        }
    }
    let mut firsts = Vec::with_capacity(corners.len());
    for (first, number) in corners.values_mut() {
        *number = firsts.len() as u32;
        firsts.push(*first);
    }
    let mut indices = Vec::new();
    for &face in faces {
        let of_face = split[mesh.faces().triangle_range(face)].as_flattened();
        indices.extend(of_face.iter().map(|&c| corners[&key(c as usize)].1));
    }
    let vertices = firsts.iter().map(|&corner| mesh.faces().corners()[corner]);
    let mut primitive = vertices_of(mesh, targets, vertices.clone());
    primitive.mode = Mode::Triangles;
    primitive.indices = Some(indices);
    primitive.material = kind.material.map(|material| material as usize);
    let sets = mesh.texture_coordinate_sets().iter().zip(&kind.texcoords);
    for (set, _) in sets.filter(|(_, has)| **has) {
        let values = firsts.iter().filter_map(|&corner| set.get(corner));
        // glTF has v down.
        let downwards = |&[u, v]: &[f64; 2]| [u as f32, (1.0 - v) as f32];
        primitive.texcoords.push(values.map(downwards).collect());
    }
    if let Some(normals) = mesh.normals().filter(|_| kind.normals) {
        let values = firsts.iter().filter_map(|&corner| normals.get(corner));
        primitive.normals = values.map(|n| n.coordinates().map(|c| c as f32)).collect();
        for (found, target) in primitive.targets.iter_mut().zip(targets) {
            let change = |vertex: u32| target.normals[vertex as usize].map(|c| c as f32);
            found.normals = vertices.clone().map(change).collect();
        }
    }
    if let Some(tangents) = mesh.tangents().filter(|_| kind.tangents) {
        let values = firsts.iter().filter_map(|&corner| tangents.get(corner));
        let tangent = |tangent: &crate::Tangent| {
            let [x, y, z] = tangent.direction.coordinates().map(|c| c as f32);
            [x, y, z, tangent.handedness as f32]
        };
        primitive.tangents = values.map(tangent).collect();
    }
    primitive
}

/// A morph target with the change of the normals.
struct Moved<'a> {
    name: &'a str,
    displacements: &'a [Vector<f64>],
    /// For each vertex; empty where the mesh has no normals.
    normals: Vec<[f64; 3]>,
}

impl<'a> Moved<'a> {
    fn new(mesh: &Mesh, target: &Target<'a>) -> Self {
        let normals = mesh.normals().map(|_| {
            let rest: Vec<[f64; 3]> = mesh.coordinates().collect();
            let pairs = rest.iter().zip(target.displacements);
            let moved: Vec<_> = pairs
                .map(|(&place, &by)| (Vector::from(place) + by).coordinates())
                .collect();
            let triangles = mesh.triangles();
            let [rest, moved] = [&rest, &moved].map(|p| vertex_normals(p, &triangles));
            let pairs = moved.into_iter().zip(rest);
            let change = |(a, b): ([f64; 3], [f64; 3])| Vector::from(a) - Vector::from(b);
            pairs.map(|pair| change(pair).coordinates()).collect()
        });
        Self {
            name: target.name,
            displacements: target.displacements,
            normals: normals.unwrap_or_default(),
        }
    }
}

/// A primitive with the places, displacements and colours of these vertices.
fn vertices_of(
    mesh: &Mesh,
    targets: &[Moved<'_>],
    vertices: impl Iterator<Item = u32> + Clone,
) -> Primitive {
    let place = |vertex: u32| mesh.positions()[vertex as usize].coordinates();
    let positions = vertices
        .clone()
        .map(|vertex| place(vertex).map(|c| c as f32));
    let colours = mesh.colours().map(|colours| {
        // glTF has no colours brighter than white.
        let colour = |vertex: u32| colours[vertex as usize].map(|c| c.clamp(0.0, 1.0) as f32);
        vertices.clone().map(colour).collect()
    });
    let targets = targets.iter().map(|target| {
        let by = |vertex: u32| target.displacements[vertex as usize].coordinates();
        let positions = vertices.clone().map(|vertex| by(vertex).map(|c| c as f32));
        MorphTarget {
            positions: positions.collect(),
            ..MorphTarget::default()
        }
    });
    Primitive {
        positions: positions.collect(),
        colours: colours.into_iter().collect(),
        targets: targets.collect(),
        ..Primitive::default()
    }
}

/// How many polylines of more than two vertices are a primitive each. The accessors of a primitive
/// take far more memory than a short polyline.
const STRIPS: usize = 256;

/// The edges, which are polylines of two vertices, as one primitive; the longer polylines, one
/// primitive each, or as edges where there are many; and the points.
fn lines(mesh: &Mesh, targets: &[Moved<'_>]) -> Vec<Primitive> {
    let strip = |line: &[u32]| Primitive {
        mode: Mode::LineStrip,
        ..vertices_of(mesh, targets, line.iter().copied())
    };
    let long = || mesh.polylines().iter().filter(|line| line.len() > 2);
    let has_strips = long().count() <= STRIPS;
    let of_edges = mesh.polylines().iter();
    let of_edges = of_edges.filter(|line| !has_strips || line.len() == 2);
    let edges: Vec<u32> = of_edges
        .flat_map(|line| line.windows(2))
        .flatten()
        .copied()
        .collect();
    let mut primitives = Vec::new();
    if !edges.is_empty() {
        primitives.push(segments(mesh, targets, &edges));
    }
    if has_strips {
        primitives.extend(long().map(strip));
    }
    if !mesh.points().is_empty() {
        primitives.push(Primitive {
            mode: Mode::Points,
            ..vertices_of(mesh, targets, mesh.points().iter().copied())
        });
    }
    primitives
}

/// Edges, two vertices each, as one primitive with indices.
fn segments(mesh: &Mesh, targets: &[Moved<'_>], edges: &[u32]) -> Primitive {
    let mut used = edges.to_vec();
    used.sort_unstable();
    used.dedup();
    let index = |vertex| used.partition_point(|&other| other < vertex) as u32;
    Primitive {
        mode: Mode::Lines,
        indices: Some(edges.iter().map(|&vertex| index(vertex)).collect()),
        ..vertices_of(mesh, targets, used.iter().copied())
    }
}
