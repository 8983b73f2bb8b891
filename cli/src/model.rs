//! The figure as files: OBJ at rest, binary glTF with its motion.

use std::collections::HashMap;

use anyhow::{Context, Result};
use ga_anim::clip::Clip;
use ga_anim::gltf;
use ga_mesh::gltf::model::{Dielectric, Model, Skin, to_document};
use ga_mesh::gltf::{Document, Image, ImageSource, Sampler, TextureElement, TextureInfo, encode};
use ga_mesh::normals::vertex_normals;
use ga_mesh::{Filter, Minification, Wrap, obj};

use crate::figure::Figure;
use crate::output::File;

pub(crate) const OBJ: &str = "model.obj";
pub(crate) const MTL: &str = "model.mtl";
pub(crate) const SKIN: &str = "skin.png";
const GLB: &str = "model.glb";

/// The names of all files of a model.
pub(crate) const NAMES: [&str; 4] = [OBJ, GLB, MTL, SKIN];

/// The mesh at rest, in metres, and the mesh with skeleton, skin weights and one animation; then
/// the material and the picture that the first refers to, if the figure is painted.
pub(crate) fn files(figure: &Figure, clip: &Clip, clip_name: &str) -> Result<Vec<File>> {
    let painted = figure.paint.as_ref();
    let png = painted
        .map(ga_image::png::encode)
        .transpose()
        .context("the painted skin cannot be encoded")?;
    let contents = glb(figure, clip, clip_name, png.as_deref())?;
    let glb = File {
        name: GLB,
        contents,
    };
    let file = |name, contents| File { name, contents };
    let Some(png) = png else {
        let text = obj::encode(&figure.mesh);
        return Ok(vec![file(OBJ, text.into_bytes()), glb]);
    };
    let material = ga_mesh::Material {
        roughness: ROUGHNESS,
        base_colour_texture: Some(ga_mesh::Texture::file(SKIN)),
        ..ga_mesh::Material::named(MATERIAL)
    };
    let faces = vec![Some(0); figure.mesh.faces().len()];
    let mesh = figure.mesh.clone().with_materials(vec![material], faces)?;
    let mut written = obj::encode_files(&mesh, "model").into_iter();
    let mut next = || written.next().map(|(_, contents)| contents);
    let (obj, mtl) = next().zip(next()).context("the material is not written")?;
    Ok(vec![file(OBJ, obj), glb, file(MTL, mtl), file(SKIN, png)])
}

/// The name of the painted skin's material, and its roughness.
const MATERIAL: &str = "skin";
pub(crate) const ROUGHNESS: f64 = 0.8;

/// The mesh with skeleton, skin weights and one animation as binary glTF, painted with a PNG.
pub(crate) fn glb(
    figure: &Figure,
    clip: &Clip,
    clip_name: &str,
    png: Option<&[u8]>,
) -> Result<Vec<u8>> {
    let positions: Vec<[f64; 3]> = figure.mesh.coordinates().collect();
    let normals = vertex_normals(&positions, &figure.mesh.triangles());
    let weights = gltf::vertex_weights(&figure.weights);
    let split = Split::new(figure);
    let at = |vertex: &u32| *vertex as usize;
    let positions: Vec<_> = split.vertices.iter().map(|v| positions[at(v)]).collect();
    let normals: Vec<_> = split.vertices.iter().map(|v| normals[at(v)]).collect();
    let weights: Vec<_> = split
        .vertices
        .iter()
        .map(|v| weights[at(v)].clone())
        .collect();
    let material = match png {
        Some(_) => Dielectric {
            name: MATERIAL,
            base_colour: [1.0; 3],
            roughness: ROUGHNESS,
        },
        None => Dielectric::default(),
    };
    let animation = gltf::animation(clip_name, &figure.skeleton, clip)?;
    let model = Model {
        name: &figure.name,
        positions: &positions,
        normals: &normals,
        triangles: &split.triangles,
        material,
        skin: Some(Skin {
            joints: &gltf::joint_nodes(&figure.skeleton),
            weights: &weights,
        }),
        animations: &[animation],
    };
    let mut document = to_document(&model).context("the model cannot be written as glTF")?;
    if let Some(png) = png {
        paint(&mut document, &split.coordinates, png);
    }
    encode(&document).context("the model cannot be written as glTF")
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

/// The vertices of a figure as glTF numbers them: one that has several texture coordinates is
/// there several times.
struct Split {
    /// For each vertex that of the mesh.
    vertices: Vec<u32>,
    /// Its texture coordinates; empty where the figure is not painted.
    coordinates: Vec<[f64; 2]>,
    triangles: Vec<[u32; 3]>,
}

impl Split {
    fn new(figure: &Figure) -> Self {
        let mesh = &figure.mesh;
        let painted = figure.paint.is_some();
        let Some(coordinates) = mesh.texture_coordinates().filter(|_| painted) else {
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
        let triangles = mesh.faces().corner_triangles();
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
