//! Skeletons and weights as the plain data that [`ga_mesh::gltf::model`] writes.

use ga_mesh::gltf::model::JointNode;
use ga_runtime::cga3::{Motor, Translator};

use crate::skeleton::{Joint, Skeleton};
use crate::weights::{Influence, SkinWeights};

/// The joints of a skeleton, at rest.
#[must_use]
pub fn joint_nodes(skeleton: &Skeleton) -> Vec<JointNode> {
    let joints = skeleton.joints();
    let node = |joint: &Joint| {
        let above = joint.parent.map_or([0.0; 3], |parent| joints[parent].head);
        JointNode {
            name: joint.name.clone(),
            parent: joint.parent,
            rest: translation(std::array::from_fn(|axis| joint.head[axis] - above[axis])),
        }
    };
    joints.iter().map(node).collect()
}

/// The joints that move each vertex, with their weights.
#[must_use]
pub fn vertex_weights(weights: &SkinWeights) -> Vec<Vec<(u32, f64)>> {
    let pair = |influence: &Influence| (influence.joint, influence.weight);
    weights
        .iter()
        .map(|influences| influences.iter().map(pair).collect())
        .collect()
}

fn translation(displacement: [f64; 3]) -> Motor<f64> {
    Motor::from(Translator::from_displacement(displacement))
}
