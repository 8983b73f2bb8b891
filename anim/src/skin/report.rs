use ga_runtime::cga3::Point;
use serde::Serialize;

use super::{Method, SkinError, skin};
use crate::pose::Pose;
use crate::skeleton::Skeleton;
use crate::weights::SkinWeights;

/// What a person in a pose measures, in the unit of the mesh with y up: whether the limbs are
/// whole, the feet on the ground and the head above.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct BodyReport {
    /// The greatest difference between the length of a bone in the pose and at rest.
    pub bone_length_error: f64,
    /// The height of the lowest vertex.
    pub lowest: f64,
    /// The height of the highest vertex above the lowest.
    pub height: f64,
    /// The direction from the root joint to the joint that is highest at rest, of length 1; (0,
    /// 1, 0) is upright.
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
                (distance(head, tail) - distance(joint.head, joint.tail)).abs()
            })
            .fold(0.0, f64::max);
        let highest_joint =
            (0..joints.len()).max_by(|&a, &b| joints[a].head[1].total_cmp(&joints[b].head[1]));
        let up = highest_joint.map_or([0.0; 3], |top| direction(bones[0][0], bones[top][0]));
        Ok(Self {
            bone_length_error,
            lowest,
            height: highest - lowest,
            up,
        })
    }
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    Point::from(a).distance(Point::from(b))
}

/// The unit vector from one place to another, or no direction at all between equal ones.
fn direction(from: [f64; 3], to: [f64; 3]) -> [f64; 3] {
    let distance = distance(from, to);
    if distance > 0.0 {
        std::array::from_fn(|axis| (to[axis] - from[axis]) / distance)
    } else {
        [0.0; 3]
    }
}
