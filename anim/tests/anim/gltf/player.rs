//! A player of GLB files that shares nothing with the writer.

use glam::{DMat4, DQuat, DVec3, Mat4};
use gltf::animation::util::ReadOutputs;

/// What a viewer shows at one key of the first animation, or at rest.
pub(super) struct Played {
    /// The positions of the vertices of the first mesh.
    pub(super) positions: Vec<DVec3>,
    /// The time of the key in seconds, 0 at rest.
    pub(super) time: f64,
}

/// A node's frame relative to its parent's.
#[derive(Clone, Copy)]
struct Local {
    rotation: DQuat,
    translation: DVec3,
}

impl Local {
    fn matrix(self) -> DMat4 {
        DMat4::from_rotation_translation(self.rotation.normalize(), self.translation)
    }
}

fn quaternion(rotation: [f32; 4]) -> DQuat {
    DQuat::from_array(rotation.map(f64::from))
}

fn vector(coordinates: [f32; 3]) -> DVec3 {
    DVec3::from(coordinates.map(f64::from))
}

/// Reads a file and plays it.
pub(super) fn play(file: &[u8], key: Option<usize>) -> Played {
    let (document, buffers, _) = gltf::import_slice(file).unwrap();
    let data = |buffer: gltf::Buffer| Some(&buffers[buffer.index()][..]);

    let mut parents = vec![None; document.nodes().len()];
    let mut locals = Vec::new();
    for node in document.nodes() {
        for child in node.children() {
            parents[child.index()] = Some(node.index());
        }
        let (translation, rotation, scale) = node.transform().decomposed();
        assert_eq!(scale, [1.0; 3]);
        locals.push(Local {
            rotation: quaternion(rotation),
            translation: vector(translation),
        });
    }
    let mut time = 0.0;
    if let Some(key) = key {
        for channel in document.animations().next().unwrap().channels() {
            let local = &mut locals[channel.target().node().index()];
            let reader = channel.reader(data);
            time = f64::from(reader.read_inputs().unwrap().nth(key).unwrap());
            match reader.read_outputs().unwrap() {
                ReadOutputs::Rotations(keys) => {
                    local.rotation = quaternion(keys.into_f32().nth(key).unwrap());
                }
                ReadOutputs::Translations(mut keys) => {
                    local.translation = vector(keys.nth(key).unwrap());
                }
                _ => panic!("a channel is neither of rotations nor of translations"),
            }
        }
    }

    let global = |node: usize| {
        let chain = std::iter::successors(Some(node), |&node| parents[node]);
        chain.fold(DMat4::IDENTITY, |below, node| locals[node].matrix() * below)
    };
    let skin = document.skins().next().unwrap();
    let inverse_bind = skin.reader(data).read_inverse_bind_matrices().unwrap();
    let joints = skin.joints().zip(inverse_bind);
    let matrices: Vec<DMat4> = joints
        .map(|(joint, bind)| global(joint.index()) * Mat4::from_cols_array_2d(&bind).as_dmat4())
        .collect();

    let mesh = document.meshes().next().unwrap();
    let primitive = mesh.primitives().next().unwrap();
    let reader = primitive.reader(data);
    let rest: Vec<DVec3> = reader.read_positions().unwrap().map(vector).collect();
    let mut positions = vec![DVec3::ZERO; rest.len()];
    for set in 0.. {
        let Some(joints) = reader.read_joints(set) else {
            break;
        };
        let weights = reader.read_weights(set).unwrap().into_f32();
        for (vertex, (joints, weights)) in joints.into_u16().zip(weights).enumerate() {
            for (joint, weight) in joints.into_iter().zip(weights) {
                let moved = matrices[usize::from(joint)].transform_point3(rest[vertex]);
                positions[vertex] += moved * f64::from(weight);
            }
        }
    }
    Played { positions, time }
}
