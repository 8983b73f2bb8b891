//! The figure as files: OBJ at rest, binary glTF with its motion.

use anyhow::{Context, Result};
use ga_anim::clip::Clip;
use ga_anim::gltf;
use ga_mesh::gltf::model::{Material, Model, Skin, to_glb};
use ga_mesh::normals::vertex_normals;
use ga_mesh::obj;

use crate::figure::Figure;

/// The mesh at rest, in metres.
pub(crate) fn obj(figure: &Figure) -> Vec<u8> {
    obj::to_text(&figure.mesh).into_bytes()
}

/// The mesh with skeleton, skin weights and one animation.
pub(crate) fn glb(figure: &Figure, clip: &Clip, clip_name: &str) -> Result<Vec<u8>> {
    let positions: Vec<[f64; 3]> = figure.mesh.coordinates().collect();
    let triangles = figure.mesh.triangles();
    let animation = gltf::animation(clip_name, &figure.skeleton, clip)?;
    let model = Model {
        name: &figure.name,
        positions: &positions,
        normals: &vertex_normals(&positions, &triangles),
        triangles: &triangles,
        material: Material::default(),
        skin: Some(Skin {
            joints: &gltf::joint_nodes(&figure.skeleton),
            weights: &gltf::vertex_weights(&figure.weights),
        }),
        animations: &[animation],
    };
    to_glb(&model).context("the model cannot be written as glTF")
}
