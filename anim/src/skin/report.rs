use ga_runtime::cga3::Point;
use ga_runtime::vga3::Vector;
use serde::Serialize;

use super::{Method, skin};
use crate::pose::Pose;
use crate::skeleton::Skeleton;
use crate::weights::SkinWeights;
use crate::weights::error::SkinError;

/// Measurements of a person in a pose, in the unit of the mesh with y up: they show whether the
/// bones keep their lengths, the feet are on the ground and the head is above.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct BodyReport {
    /// The greatest difference between the length of a bone in the pose and at rest.
    pub bone_length_error: f64,
    /// The height of the lowest vertex.
    pub lowest: f64,
    /// The height of the highest vertex above the lowest.
    pub height: f64,
    /// The unit direction from the root joint to the joint that is highest at rest; (0, 1, 0) is
    /// upright.
    pub up: [f64; 3],
}

impl BodyReport {
    /// Measures a skinned mesh in a pose.
    ///
    /// # Errors
    ///
    /// As [`skin`], and [`SkinError::NoVertices`].
    pub fn new(
        positions: &[Point<f64>],
        weights: &SkinWeights,
        skeleton: &Skeleton,
        pose: &Pose,
        method: Method,
    ) -> Result<Self, SkinError> {
        let moved = skin(positions, weights, &pose.motions(skeleton)?, method)?;
        let heights = moved.iter().map(|position| position.coordinates()[1]);
        let lowest = heights
            .clone()
            .reduce(f64::min)
            .ok_or(SkinError::NoVertices)?;
        let highest = heights.fold(lowest, f64::max);

        let bones = pose.bones(skeleton)?;
        let joints = skeleton.joints();
        let bone_length_error = joints
            .iter()
            .zip(&bones)
            .map(|(joint, &[head, tail])| {
                let length = Vector::from(head).distance(tail.into());
                (length - Vector::from(joint.head).distance(joint.tail.into())).abs()
            })
            .fold(0.0, f64::max);
        let highest_joint =
            (0..joints.len()).max_by(|&a, &b| joints[a].head[1].total_cmp(&joints[b].head[1]));
        // Equal positions have no direction.
        let up = highest_joint
            .and_then(|top| (Vector::from(bones[top][0]) - Vector::from(bones[0][0])).normalized())
            .unwrap_or_default()
            .coordinates();
        Ok(Self {
            bone_length_error,
            lowest,
            height: highest - lowest,
            up,
        })
    }
}
