//! Skinned, animated meshes as binary glTF 2.0.
//!
//! [`to_glb`] writes what the Khronos *glTF 2.0 Specification* calls a GLB file: a mesh with
//! normals and one material, a skin with any number of joints and of influences on a vertex, and
//! animations that turn and move the joints. The file is made to pass the Khronos validator without
//! errors or warnings. [`JointNode::from_skeleton`] and [`Animation::from_clip`] make the input
//! from the types of this crate.
//!
//! glTF is right-handed with *y* up and metres, as is everything here, so coordinates are written
//! as they are, in single precision. Quaternions are *(x, y, z, w)*: a turn by the angle α about
//! the unit axis *n* is *(n sin(α/2), cos(α/2))*.
//!
//! ```
//! use ga_anim::gltf::{Material, Model, to_glb};
//!
//! let model = Model {
//!     name: "triangle",
//!     positions: &[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
//!     normals: &[[0.0, 0.0, 1.0]; 3],
//!     triangles: &[[0, 1, 2]],
//!     material: Material::default(),
//!     skin: None,
//!     animations: &[],
//! };
//! let file = to_glb(&model)?;
//! assert_eq!(&file[..8], b"glTF\x02\0\0\0");
//! # Ok::<(), ga_anim::gltf::GltfError>(())
//! ```

mod animation;
mod buffer;
mod container;
mod error;
mod motion;
mod primitive;
mod skin;

use serde_json::{Value, json};

use crate::weights::SkinWeights;
use buffer::Buffer;
pub use error::GltfError;

/// A mesh, and what moves it.
#[derive(Clone, Copy, Debug)]
pub struct Model<'a> {
    /// The name of the mesh and of its node.
    pub name: &'a str,
    /// One point for each vertex, in metres.
    pub positions: &'a [[f64; 3]],
    /// One direction for each vertex, of any length; a zero vector, as for a vertex that no
    /// triangle uses, is written as straight up.
    pub normals: &'a [[f64; 3]],
    /// Three vertex indices for each triangle, counter-clockwise seen from outside. Triangles that
    /// name a vertex twice are left out.
    pub triangles: &'a [[u32; 3]],
    /// The look of the whole surface.
    pub material: Material<'a>,
    /// The joints that carry the mesh, if any.
    pub skin: Option<Skin<'a>>,
    /// Motions of the joints.
    pub animations: &'a [Animation],
}

/// A dielectric surface of one colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material<'a> {
    /// Its name.
    pub name: &'a str,
    /// Red, green, blue as linear light, 0 to 1.
    pub base_color: [f64; 3],
    /// 0 for a mirror, 1 for chalk.
    pub roughness: f64,
}

impl Default for Material<'_> {
    /// Warm grey plaster.
    fn default() -> Self {
        Self {
            name: "plaster",
            base_color: crate::render::from_srgb([214, 203, 190]),
            roughness: 0.8,
        }
    }
}

/// Joints at rest, and how they share the vertices.
#[derive(Clone, Copy, Debug)]
pub struct Skin<'a> {
    /// The joints, parents before children.
    pub joints: &'a [JointNode],
    /// The influences on each vertex of the mesh, numbered as in `joints`.
    pub weights: &'a SkinWeights,
}

/// A joint as a node of the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct JointNode {
    /// Its name.
    pub name: String,
    /// The joint above it, or `None` for a root.
    pub parent: Option<usize>,
    /// Where it is at rest, relative to its parent.
    pub rest: RigidTransform,
}

/// A rotation about the origin followed by a translation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidTransform {
    /// The unit quaternion (x, y, z, w).
    pub rotation: [f64; 4],
    /// The translation.
    pub translation: [f64; 3],
}

impl Default for RigidTransform {
    /// The identity.
    fn default() -> Self {
        Self {
            rotation: [0.0, 0.0, 0.0, 1.0],
            translation: [0.0; 3],
        }
    }
}

/// A motion: for some joints, where they are relative to their parents at each of some times.
#[derive(Clone, Debug, PartialEq)]
pub struct Animation {
    /// Its name.
    pub name: String,
    /// The times of the keys in seconds, from 0 on, rising.
    pub times: Vec<f64>,
    /// The joints that move; at most one track for each.
    pub tracks: Vec<Track>,
}

/// The motion of one joint. Viewers interpolate between keys, translations linearly and rotations
/// by slerp.
#[derive(Clone, Debug, PartialEq)]
pub struct Track {
    /// The joint, as an index into the skin's joints.
    pub joint: usize,
    /// Its place relative to its parent at each time of the animation.
    pub keys: Vec<RigidTransform>,
}

/// The bytes of a GLB file with the model in it.
///
/// The mesh stands at the root of the scene beside the joints. Influences are written four to a
/// `JOINTS_n`/`WEIGHTS_n` pair, the greatest first, so that viewers that know one pair only show
/// the best they can. Quaternions are normalised, and of a key's two signs the one nearer to the
/// key before is written, so that viewers that forget to choose still turn the short way. A
/// translation or rotation that stays within 10⁻⁷ of rest in every key gets no channel.
///
/// # Errors
///
/// [`GltfError`] names the element at fault.
pub fn to_glb(model: &Model) -> Result<Vec<u8>, GltfError> {
    let mut buffer = Buffer::default();
    let mut document = json!({
        "asset": { "version": "2.0", "generator": "Nullcone" },
        "scene": 0,
        "meshes": [primitive::mesh(model, &mut buffer)?],
        "materials": [material(&model.material)?],
    });
    let mut mesh_node = json!({ "name": model.name, "mesh": 0 });
    let mut nodes = Vec::new();
    let mut roots = Vec::new();
    if let Some(skin) = &model.skin {
        let joints = skin::joints(skin, model.positions.len(), &mut buffer)?;
        mesh_node["skin"] = json!(0);
        document["skins"] = json!([joints.skin]);
        nodes = joints.nodes;
        roots.push(joints.root);
    }
    roots.push(nodes.len());
    nodes.push(mesh_node);
    document["nodes"] = Value::Array(nodes);
    document["scenes"] = json!([{ "nodes": roots }]);

    let rest: &[JointNode] = model.skin.map_or(&[], |skin| skin.joints);
    let animations = animation::animations(model.animations, rest, &mut buffer)?;
    if !animations.is_empty() {
        document["animations"] = Value::Array(animations);
    }
    container::glb(document, buffer)
}

fn material(material: &Material) -> Result<Value, GltfError> {
    let [red, green, blue] = material.base_color;
    let fractions = [red, green, blue, material.roughness];
    if !fractions.iter().all(|f| (0.0..=1.0).contains(f)) {
        return Err(GltfError::Material);
    }
    Ok(json!({
        "name": material.name,
        "pbrMetallicRoughness": {
            "baseColorFactor": [red, green, blue, 1.0],
            "metallicFactor": 0.0,
            "roughnessFactor": material.roughness,
        },
    }))
}
