//! One mesh with normals and one material, a skin with any number of joints and of influences on a
//! vertex, and animations that rotate and translate the joints.
//!
//! [`to_document`] makes a [`Document`] of them and [`encode`] a file, which passes the Khronos
//! validator without errors or warnings. Skin and animations are plain data here: joints with
//! names, parents and motors at rest, weights as lists, tracks of times and motors. The crate
//! ga-anim makes joints and weights from its skeletons and skins.
//!
//! Coordinates are written as they are, in single precision. A motor is written as its translation
//! and its quaternion *(x, y, z, w)*, which for a rotation by the angle α about the unit axis *n*
//! is *(n sin(α/2), cos(α/2))*.
//!
//! ```
//! use ga_mesh::gltf::model::{Dielectric, Model, encode};
//!
//! let model = Model {
//!     name: "triangle",
//!     positions: &[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
//!     normals: &[[0.0, 0.0, 1.0]; 3],
//!     triangles: &[[0, 1, 2]],
//!     material: Dielectric::default(),
//!     skin: None,
//!     animations: &[],
//! };
//! let file = encode(&model)?;
//! assert_eq!(&file[..8], b"glTF\x02\0\0\0");
//! # Ok::<(), ga_mesh::FormatError>(())
//! ```

mod animation;
mod parts;
mod precision;
mod primitive;
mod problem;
mod rigid;
mod skin;

use super::{self as gltf, Asset, Document, Mesh, Node, Scene};
use crate::FormatError;
pub use parts::{Animation, Dielectric, JointNode, Model, Skin, Track};
pub use problem::ModelProblem;

/// The model as a document.
///
/// The mesh stands at the root of the scene beside the joints. Influences are written four to a
/// `JOINTS_n`/`WEIGHTS_n` pair, the greatest first, so that a viewer that reads one pair only shows
/// the best approximation. Motors are normalised. Of the two signs of a key's quaternion the one
/// nearer to the key before is written, so that viewers that do not choose still take the shorter
/// rotation. A translation or rotation that stays within 10⁻⁷ of rest in every key gets no channel.
///
/// # Errors
///
/// [`FormatError`] names the faulty element.
pub fn to_document(model: &Model) -> Result<Document, FormatError> {
    let mut document = Document {
        asset: Asset::of_this_crate(),
        materials: vec![material(&model.material)?],
        meshes: vec![Mesh {
            name: Some(model.name.to_owned()),
            primitives: vec![primitive::primitive(model)?],
            ..Mesh::default()
        }],
        scene: Some(0),
        ..Document::default()
    };
    let mut roots = Vec::new();
    if let Some(skin) = &model.skin {
        roots.push(skin::add(skin, model.positions.len(), &mut document)?);
    }
    roots.push(document.nodes.len());
    document.nodes.push(Node {
        name: Some(model.name.to_owned()),
        mesh: Some(0),
        skin: model.skin.map(|_| 0),
        ..Node::default()
    });
    document.scenes.push(Scene {
        nodes: roots,
        ..Scene::default()
    });
    let joints: &[JointNode] = model.skin.map_or(&[], |skin| skin.joints);
    for animation in model.animations {
        document
            .animations
            .push(animation::animation(animation, joints)?);
    }
    Ok(document)
}

/// The bytes of a GLB file that contains the model; see [`to_document`].
///
/// # Errors
///
/// As [`to_document`].
pub fn encode(model: &Model) -> Result<Vec<u8>, FormatError> {
    gltf::encode(&to_document(model)?)
}

fn material(material: &Dielectric) -> Result<gltf::MaterialElement, ModelProblem> {
    let [red, green, blue] = material.base_colour;
    let fractions = [red, green, blue, material.roughness];
    if !fractions.iter().all(|f| (0.0..=1.0).contains(f)) {
        return Err(ModelProblem::Material);
    }
    Ok(gltf::MaterialElement {
        name: Some(material.name.to_owned()),
        base_colour: [red, green, blue, 1.0].map(|c| c as f32),
        metallic: 0.0,
        roughness: material.roughness as f32,
        ..gltf::MaterialElement::default()
    })
}
