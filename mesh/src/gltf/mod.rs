//! Skinned, animated meshes as binary glTF 2.0.
//!
//! [`to_glb`] writes what the Khronos *glTF 2.0 Specification* calls a GLB file: a mesh with
//! normals and one material, a skin with any number of joints and of influences on a vertex, and
//! animations that rotate and translate the joints. The file passes the Khronos validator without
//! errors or warnings. Skin and animations are plain data here: joints with names, parents and
//! motors at rest, weights as lists, tracks of times and motors. The crate ga-anim makes them from
//! its skeletons and clips.
//!
//! glTF is right-handed with *y* up and metres. Coordinates are written as they are, in single
//! precision. A motor is written as its translation and its quaternion *(x, y, z, w)*, which for a
//! rotation by the angle α about the unit axis *n* is *(n sin(α/2), cos(α/2))*.
//!
//! ```
//! use ga_mesh::gltf::{Material, Model, to_glb};
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
//! # Ok::<(), ga_mesh::gltf::GltfError>(())
//! ```

mod animation;
mod document;
mod error;
mod primitive;
mod rigid;
mod skin;

use ga_runtime::cga3::Motor;
use gltf_json as json;
use gltf_json::material::{PbrBaseColorFactor, PbrMetallicRoughness, StrengthFactor};

use document::Document;
pub use error::GltfError;

/// A mesh, and what moves it.
#[derive(Clone, Copy, Debug)]
pub struct Model<'a> {
    /// The name of the mesh and of its node.
    pub name: &'a str,
    /// One point for each vertex, in metres.
    pub positions: &'a [[f64; 3]],
    /// One direction for each vertex, of any length. A zero vector, as for a vertex that no
    /// triangle uses, is written as straight up.
    pub normals: &'a [[f64; 3]],
    /// Three vertex indices for each triangle, counter-clockwise seen from outside. Triangles that
    /// name a vertex twice are left out.
    pub triangles: &'a [[u32; 3]],
    /// The appearance of the whole surface.
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
    pub base_colour: [f64; 3],
    /// 0 for a mirror, 1 for chalk.
    pub roughness: f64,
}

impl Default for Material<'_> {
    /// Warm grey plaster, (214, 203, 190) in sRGB.
    fn default() -> Self {
        Self {
            name: "plaster",
            base_colour: [0.6724431569576875, 0.5972017883637634, 0.5149176653765214],
            roughness: 0.8,
        }
    }
}

/// Joints at rest, and their influence on the vertices.
#[derive(Clone, Copy, Debug)]
pub struct Skin<'a> {
    /// The joints, parents before children.
    pub joints: &'a [JointNode],
    /// For each vertex of the mesh, the joints that move it, as indices into `joints`, with their
    /// weights, which sum to 1.
    pub weights: &'a [Vec<(u32, f64)>],
}

/// A joint as a node of the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct JointNode {
    /// Its name.
    pub name: String,
    /// The joint above it, or `None` for a root.
    pub parent: Option<usize>,
    /// Its frame at rest relative to its parent's frame.
    pub rest: Motor<f64>,
}

/// A motion: for some joints, their frames relative to their parents at each of some times.
#[derive(Clone, Debug, PartialEq)]
pub struct Animation {
    /// Its name.
    pub name: String,
    /// The times of the keys in seconds, not negative and strictly increasing.
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
    /// Its frame relative to its parent's frame at each time of the animation.
    pub keys: Vec<Motor<f64>>,
}

/// The bytes of a GLB file that contains the model.
///
/// The mesh stands at the root of the scene beside the joints. Influences are written four to a
/// `JOINTS_n`/`WEIGHTS_n` pair, the greatest first, so that a viewer that reads one pair only shows
/// the best approximation. Motors are normalised. Of the two signs of a key's quaternion the one
/// nearer to the key before is written, so that viewers that do not choose still take the shorter
/// rotation. A translation or rotation that stays within 10⁻⁷ of rest in every key gets no channel.
///
/// # Errors
///
/// [`GltfError`] names the faulty element.
pub fn to_glb(model: &Model) -> Result<Vec<u8>, GltfError> {
    let mut document = Document::default();
    document.root.asset.generator = Some("Nullcone".to_owned());
    let material = document.root.push(material(&model.material)?);
    let mesh = primitive::add(model, material, &mut document)?;
    let mut mesh_node = json::Node {
        name: Some(model.name.to_owned()),
        mesh: Some(mesh),
        ..json::Node::default()
    };
    let mut roots = Vec::new();
    if let Some(skin) = &model.skin {
        let (skin, root) = skin::add(skin, model.positions.len(), &mut document)?;
        mesh_node.skin = Some(skin);
        roots.push(root);
    }
    roots.push(document.root.push(mesh_node));
    document.root.scene = Some(document.root.push(json::Scene {
        name: None,
        nodes: roots,
        extensions: None,
        extras: Default::default(),
    }));
    let joints: &[JointNode] = model.skin.map_or(&[], |skin| skin.joints);
    for animation in model.animations {
        animation::add(animation, joints, &mut document)?;
    }
    document.into_glb()
}

fn material(material: &Material) -> Result<json::Material, GltfError> {
    let [red, green, blue] = material.base_colour;
    let fractions = [red, green, blue, material.roughness];
    if !fractions.iter().all(|f| (0.0..=1.0).contains(f)) {
        return Err(GltfError::Material);
    }
    Ok(json::Material {
        name: Some(material.name.to_owned()),
        pbr_metallic_roughness: PbrMetallicRoughness {
            base_color_factor: PbrBaseColorFactor([red, green, blue, 1.0].map(|c| c as f32)),
            metallic_factor: StrengthFactor(0.0),
            roughness_factor: StrengthFactor(material.roughness as f32),
            ..PbrMetallicRoughness::default()
        },
        ..json::Material::default()
    })
}
