//! The figure with its motion as binary glTF.

use std::collections::HashMap;

use ga_anim::character::Character;
use ga_anim::clip::Clip;
use ga_anim::gltf::{self, Rigged};
use ga_anim::motion_file::Loss;
use ga_mesh::gltf::model::{Dielectric, Model, Skin, to_document};
use ga_mesh::gltf::{
    Document, Image, ImageSource, Node, Sampler, TextureElement, TextureInfo, Transform,
};
use ga_mesh::normals::vertex_normals;
use ga_mesh::{Filter, Mesh, Minification, Wrap};

use crate::error::CharacterError;
use crate::figure::Figure;

/// The name of the painted skin's material.
pub(crate) const MATERIAL: &str = "skin";

/// The roughness of a painted skin.
pub(crate) const ROUGHNESS: f64 = 0.8;

/// The figure with a motion as binary glTF: its document with the motion as the first animation, or
/// else its mesh with skeleton and skin weights, painted with a PNG where it is painted. The result
/// also says what of the motion is not in it.
///
/// # Errors
///
/// [`CharacterError::Document`] for a clip of another skeleton, [`CharacterError::Gltf`] where
/// numbers do not fit the format, and [`CharacterError::Encode`] for a painted skin without pixels.
pub fn encode(
    figure: &Figure,
    clip: &Clip,
    clip_name: &str,
) -> Result<(Vec<u8>, Vec<Loss>), CharacterError> {
    let (document, losses) = animated(figure, clip, clip_name)?;
    Ok((ga_mesh::gltf::encode(&document)?, losses))
}

/// The document that [`encode`] writes, and what of the motion is not in it.
pub(crate) fn animated(
    figure: &Figure,
    clip: &Clip,
    clip_name: &str,
) -> Result<(Document, Vec<Loss>), CharacterError> {
    let rigged = match &figure.document {
        Some(document) => Rigged::new(&scaled(document, figure.metres_per_unit))?,
        None => {
            let skeleton = figure.character.skeleton.clone();
            let nodes = (0..skeleton.len()).collect();
            let png = figure.png()?;
            Rigged::from_nodes(document_of(figure, png.as_deref())?, skeleton, nodes)?
        }
    };
    Ok(rigged.with_clip(clip_name, clip)?)
}

/// A document in metres: all that stands in its scenes is below a node with the length of its unit
/// as factor, but for skinned meshes, which only their joints move.
fn scaled(document: &Document, metres_per_unit: f64) -> Document {
    let mut document = document.clone();
    if metres_per_unit == 1.0 {
        return document;
    }
    let is_scaled = |&node: &usize| {
        let Node { skin, children, .. } = &document.nodes[node];
        skin.is_none() || !children.is_empty()
    };
    let mut roots: Vec<usize> = match &document.scenes[..] {
        [] => top_nodes(&document),
        scenes => scenes
            .iter()
            .flat_map(|scene| scene.nodes.clone())
            .collect(),
    };
    roots.retain(is_scaled);
    roots.sort_unstable();
    roots.dedup();
    let unit = document.nodes.len();
    for scene in &mut document.scenes {
        let before = scene.nodes.len();
        scene.nodes.retain(|node| !roots.contains(node));
        if scene.nodes.len() < before {
            scene.nodes.push(unit);
        }
    }
    document.nodes.push(Node {
        name: Some("unit".to_owned()),
        children: roots,
        transform: Transform::Decomposed {
            translation: [0.0; 3],
            rotation: [0.0, 0.0, 0.0, 1.0],
            scale: [metres_per_unit as f32; 3],
        },
        ..Node::default()
    });
    document
}

/// The nodes without one above them.
fn top_nodes(document: &Document) -> Vec<usize> {
    let mut is_child = vec![false; document.nodes.len()];
    for &child in document.nodes.iter().flat_map(|node| &node.children) {
        is_child[child] = true;
    }
    (0..is_child.len())
        .filter(|&node| !is_child[node])
        .collect()
}

/// The mesh of a figure with skeleton and skin weights. The joints are the first nodes.
fn document_of(figure: &Figure, png: Option<&[u8]>) -> Result<Document, CharacterError> {
    let Character {
        mesh,
        skeleton,
        weights,
    } = &figure.character;
    let positions: Vec<[f64; 3]> = mesh.coordinates().collect();
    let normals = vertex_normals(&positions, &mesh.triangles());
    let weights = gltf::vertex_weights(weights);
    let split = Split::new(mesh, png.is_some());
    let vertices = || split.vertices.iter().map(|&vertex| vertex as usize);
    let positions: Vec<_> = vertices().map(|vertex| positions[vertex]).collect();
    let normals: Vec<_> = vertices().map(|vertex| normals[vertex]).collect();
    let weights: Vec<_> = vertices().map(|vertex| weights[vertex].clone()).collect();
    let material = match png {
        Some(_) => Dielectric {
            name: MATERIAL,
            base_colour: [1.0; 3],
            roughness: ROUGHNESS,
        },
        None => Dielectric::default(),
    };
    let model = Model {
        name: &figure.name,
        positions: &positions,
        normals: &normals,
        triangles: &split.triangles,
        material,
        skin: Some(Skin {
            joints: &gltf::joint_nodes(skeleton),
            weights: &weights,
        }),
        animations: &[],
    };
    let mut document = to_document(&model)?;
    if let Some(png) = png {
        paint(&mut document, &split.coordinates, png);
    }
    Ok(document)
}

/// Gives the mesh of a document texture coordinates and its material the picture.
fn paint(document: &mut Document, coordinates: &[[f64; 2]], png: &[u8]) {
    document.images.push(Image {
        name: Some(MATERIAL.to_owned()),
        source: ImageSource::Bytes {
            media_type: "image/png".to_owned(),
            bytes: png.to_vec(),
        },
        extras: None,
    });
    document.samplers.push(Sampler {
        magnification: Some(Filter::Linear),
        minification: Some(Minification {
            filter: Filter::Linear,
            levels: Some(Filter::Linear),
        }),
        wrap_u: Wrap::ClampToEdge,
        wrap_v: Wrap::ClampToEdge,
        ..Sampler::default()
    });
    document.textures.push(TextureElement {
        sampler: Some(document.samplers.len() - 1),
        image: Some(document.images.len() - 1),
        ..TextureElement::default()
    });
    let texture = document.textures.len() - 1;
    for material in &mut document.materials {
        material.base_colour_texture = Some(TextureInfo {
            texture,
            ..TextureInfo::default()
        });
    }
    for mesh in &mut document.meshes {
        for primitive in &mut mesh.primitives {
            // glTF has v down.
            let downwards = coordinates
                .iter()
                .map(|&[u, v]| [u as f32, (1.0 - v) as f32]);
            primitive.texcoords = vec![downwards.collect()];
        }
    }
}

/// The vertices of a mesh as glTF numbers them: one that has several texture coordinates is
/// there several times.
struct Split {
    /// For each vertex that of the mesh.
    vertices: Vec<u32>,
    /// Its texture coordinates; empty where the mesh is not painted.
    coordinates: Vec<[f64; 2]>,
    triangles: Vec<[u32; 3]>,
}

impl Split {
    fn new(mesh: &Mesh, is_painted: bool) -> Self {
        let Some(coordinates) = mesh.texture_coordinates().filter(|_| is_painted) else {
            return Self {
                vertices: (0..mesh.vertex_count() as u32).collect(),
                coordinates: Vec::new(),
                triangles: mesh.triangles(),
            };
        };
        let corners = mesh.faces().corners();
        let mut numbers: HashMap<(u32, Option<u32>), u32> = HashMap::new();
        let mut vertices = Vec::new();
        let mut of_vertices = Vec::new();
        let mut number = |corner: u32| {
            let corner = corner as usize;
            let key = (corners[corner], coordinates.corners[corner]);
            *numbers.entry(key).or_insert_with(|| {
                vertices.push(key.0);
                of_vertices.push(coordinates.get(corner).copied().unwrap_or_default());
                vertices.len() as u32 - 1
            })
        };
        let triangles = mesh.corner_triangles();
        let triangles = triangles
            .into_iter()
            .map(|triangle| triangle.map(&mut number));
        Self {
            triangles: triangles.collect(),
            vertices,
            coordinates: of_vertices,
        }
    }
}
