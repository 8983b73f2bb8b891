use ga_runtime::cga3::{Motor, Point};

use crate::pose::moved;
use crate::skeleton::Skeleton;
use crate::skin::SkinError;
use crate::weights::{Influence, SkinWeights};

/// Of the body's height: how far above the ground a bone, and a vertex, still belongs to the sole.
const BONE: f64 = 1.0 / 16.0;
const VERTEX: f64 = 1.0 / 64.0;

/// What a body stands on at rest: points, each fixed to a joint.
#[derive(Clone, Debug, PartialEq)]
pub struct Soles {
    /// How many joints the skeleton has.
    pub(super) joint_count: usize,
    points: Vec<(usize, [f64; 3])>,
}

impl Soles {
    /// The lowest vertices of a mesh that stands upright at rest, up to 1/64 of its height above
    /// the lowest of all, each fixed to the joint that moves it most.
    ///
    /// # Errors
    ///
    /// [`SkinError::VertexCount`] when the weights are for another mesh.
    pub fn of_mesh(positions: &[Point<f64>], weights: &SkinWeights) -> Result<Self, SkinError> {
        let (expected, found) = (positions.len(), weights.vertex_count());
        if expected != found {
            return Err(SkinError::VertexCount { expected, found });
        }
        let places = || positions.iter().map(|position| position.coordinates());
        let limit = limit(places(), VERTEX);
        let strongest = weights.strongest(1);
        let points = places()
            .zip(strongest.iter())
            .filter(|(place, _)| place[1] <= limit)
            .filter_map(|(place, row)| {
                row.first()
                    .map(|&Influence { joint, .. }| (joint as usize, place))
            })
            .collect();
        Ok(Self {
            joint_count: weights.joint_count(),
            points,
        })
    }

    /// Where there is no mesh: points under the ends of those bones of a skeleton that lie within
    /// 1/16 of its height above its lowest point.
    #[must_use]
    pub fn of_skeleton(skeleton: &Skeleton) -> Self {
        let joints = skeleton.joints();
        let ends = || joints.iter().flat_map(|joint| [joint.head, joint.tail]);
        let limit = limit(ends(), BONE);
        let ground = ends().map(|end| end[1]).fold(f64::INFINITY, f64::min);
        let lies_low = joints
            .iter()
            .enumerate()
            .filter(|(_, joint)| joint.head[1].max(joint.tail[1]) <= limit);
        let points = lies_low.flat_map(|(index, joint)| {
            [joint.head, joint.tail].map(|[x, _, z]| (index, [x, ground, z]))
        });
        Self {
            joint_count: joints.len(),
            points: points.collect(),
        }
    }

    /// Whether a joint has a part of the sole.
    pub(super) fn has(&self, joint: usize) -> bool {
        self.points.iter().any(|&(other, _)| other == joint)
    }

    /// The height of the lowest point when the joints have moved so; not a number when one of them
    /// has none.
    pub(super) fn lowest(&self, motions: &[Motor<f64>]) -> f64 {
        let heights = self
            .points
            .iter()
            .map(|&(joint, point)| moved(motions[joint], point)[1]);
        heights
            .reduce(|a, b| if a < b || a.is_nan() { a } else { b })
            .unwrap_or(f64::NAN)
    }
}

/// The height up to which something belongs to the lowest `part` of the whole.
fn limit(places: impl Iterator<Item = [f64; 3]>, part: f64) -> f64 {
    let [low, high] = places.fold(
        [f64::INFINITY, f64::NEG_INFINITY],
        |[low, high], [_, y, _]| [low.min(y), high.max(y)],
    );
    low + part * (high - low)
}
