//! Skeletons, weights and clips as the plain data that [`ga_mesh::gltf::model`] writes.

use ga_mesh::gltf::model::{Animation, JointNode, Track};
use ga_runtime::cga3::{Motor, Translator};

use crate::clip::Clip;
use crate::pose::Pose;
use crate::skeleton::{Joint, Skeleton, SkeletonError};
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

/// A clip of a skeleton, one key for each frame and joint; the joints are those of
/// [`joint_nodes`].
///
/// Between keys a viewer interpolates each joint's rotation by slerp, as [`Pose::interpolate`]
/// does. It interpolates the rotation and the translation of the whole skeleton separately, not
/// along its screw, so where the skeleton both rotates and translates the frames of the clip should
/// be close together.
///
/// # Errors
///
/// [`SkeletonError`] when the clip is for a skeleton with another number of joints.
///
/// # Examples
///
/// ```
/// use ga_anim::{clip::Clip, gltf, pose::Pose, skeleton::{Joint, Skeleton}};
/// use ga_runtime::cga3::{Motor, Rotor};
///
/// let hip = Joint { name: "hip".into(), parent: None, head: [0.0, 1.0, 0.0], tail: [0.0; 3] };
/// let leg = Skeleton::new(vec![hip])?;
/// let half = Rotor::from_axis_angle([0.0, 0.0, 2.0], std::f64::consts::PI).ok_or("no axis")?;
/// let turned = Pose::from_rotors(&leg, Motor::default(), &[half])?;
/// let clip = Clip::new(0.5, vec![Pose::rest(1), turned])?;
///
/// let animation = gltf::animation("turn", &leg, &clip)?;
/// let key = animation.tracks[0].keys[1];
/// let (axis, angle) = key.rotor().to_axis_angle();
/// assert!((axis[2] - 1.0).abs() < 1e-15 && (angle - std::f64::consts::PI).abs() < 1e-15);
/// assert_eq!(key.translator().displacement(), [0.0, 1.0, 0.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn animation(name: &str, skeleton: &Skeleton, clip: &Clip) -> Result<Animation, SkeletonError> {
    let joints = skeleton.joints();
    for pose in clip.frames() {
        let (expected, found) = (joints.len(), pose.joints.len());
        if expected != found {
            return Err(SkeletonError::PoseLength { expected, found });
        }
    }
    let track = |(index, joint): (usize, &Joint)| {
        let there = translation(joint.head);
        let back = joint
            .parent
            .map(|parent| translation(joints[parent].head.map(|c| -c)));
        let key = |pose: &Pose| back.unwrap_or(pose.root) * pose.joints[index] * there;
        Track {
            joint: index,
            keys: clip.frames().iter().map(key).collect(),
        }
    };
    let frames = 0..clip.frames().len();
    Ok(Animation {
        name: name.to_owned(),
        times: frames
            .map(|frame| frame as f64 * clip.frame_time())
            .collect(),
        tracks: joints.iter().enumerate().map(track).collect(),
    })
}

fn translation(displacement: [f64; 3]) -> Motor<f64> {
    Motor::from(Translator::from_displacement(displacement))
}
