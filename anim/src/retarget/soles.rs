use std::collections::BTreeMap;

use ga_runtime::batch;
use ga_runtime::cga3::{Motor, Point};
use ga_runtime::vga3::Vector;

use crate::pose::moved;
use crate::skeleton::Skeleton;
use crate::weights::error::SkinError;
use crate::weights::{Influence, SkinWeights};

/// As fractions of the body's height: the greatest height above the ground at which a bone, and a
/// vertex, belongs to the sole.
const BONE: f64 = 1.0 / 16.0;
const VERTEX: f64 = 1.0 / 64.0;

/// What a body stands on at rest: points, each fixed to a joint.
#[derive(Clone, Debug, PartialEq)]
pub struct Soles {
    /// How many joints the skeleton has.
    pub(super) joint_count: usize,
    /// The points of each joint that has any, in the order of the joints.
    points: Vec<(usize, Vec<Point<f64>>)>,
}

impl Soles {
    /// The lowest vertices of a mesh that stands upright at rest, up to 1/64 of its height above
    /// the lowest one, each fixed to the joint that moves it most.
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
            });
        Ok(Self::new(weights.joint_count(), points))
    }

    /// The soles of a skeleton without a mesh: points on the ground below the ends of those bones
    /// that lie within 1/16 of its height above its lowest point, or of those ends where no bone
    /// lies there.
    #[must_use]
    pub fn of_skeleton(skeleton: &Skeleton) -> Self {
        Self::of_pose(skeleton, &vec![Motor::default(); skeleton.len()])
    }

    /// The same of a skeleton that stands after these motions of its joints.
    pub(super) fn of_pose(skeleton: &Skeleton, motions: &[Motor<f64>]) -> Self {
        let joints = skeleton.joints().iter().zip(motions);
        let bones =
            joints.map(|(joint, &motion)| [joint.head, joint.tail].map(|end| moved(motion, end)));
        let bones: Vec<[[f64; 3]; 2]> = bones.collect();
        let ends = || bones.iter().flatten().copied();
        let limit = limit(ends(), BONE);
        let ground = ends().map(|end| end[1]).fold(f64::INFINITY, f64::min);
        let is_low = |end: &[f64; 3]| end[1] <= limit;
        let any_lies_low = bones.iter().any(|bone| bone.iter().all(is_low));
        let low_ends = bones.iter().enumerate().flat_map(|(index, bone)| {
            let counts = !any_lies_low || bone.iter().all(is_low);
            let ends = bone.iter().filter(move |end| counts && is_low(end));
            ends.map(move |&end| (index, end))
        });
        let points = low_ends
            .map(|(index, [x, _, z])| (index, moved(motions[index].reverse(), [x, ground, z])));
        Self::new(skeleton.len(), points)
    }

    fn new(joint_count: usize, points: impl Iterator<Item = (usize, [f64; 3])>) -> Self {
        let mut by_joint: BTreeMap<usize, Vec<Point<f64>>> = BTreeMap::new();
        for (joint, place) in points {
            by_joint.entry(joint).or_default().push(place.into());
        }
        Self {
            joint_count,
            points: by_joint.into_iter().collect(),
        }
    }

    /// Those of some joints; `None` where these have none.
    pub(super) fn of_joints(&self, is_counted: impl Fn(usize) -> bool) -> Option<Self> {
        let counted = self.points.iter().filter(|(joint, _)| is_counted(*joint));
        let points: Vec<_> = counted.cloned().collect();
        let joint_count = self.joint_count;
        (!points.is_empty()).then_some(Self {
            joint_count,
            points,
        })
    }

    /// The joints that have a part of the sole.
    pub(super) fn joints(&self) -> impl Iterator<Item = usize> + '_ {
        self.points.iter().map(|&(joint, _)| joint)
    }

    /// The mean of the points of some joints at rest; `None` where they have none.
    pub(super) fn middle(&self, is_counted: impl Fn(usize) -> bool) -> Option<Vector<f64>> {
        let counted = self.points.iter().filter(|(joint, _)| is_counted(*joint));
        let places = counted.flat_map(|(_, points)| points);
        let (sum, count) = places.fold((Vector::default(), 0u32), |(sum, count), &point| {
            (sum + Vector::from(point), count + 1)
        });
        (count > 0).then(|| sum / f64::from(count))
    }

    /// The height of the lowest point after these motions of the joints; not a number when one of
    /// the heights is not.
    pub(super) fn lowest(&self, motions: &[Motor<f64>]) -> f64 {
        self.lowest_of(motions, |_| true)
    }

    /// The same of the points of some joints; not a number where they have none.
    pub(super) fn lowest_of(
        &self,
        motions: &[Motor<f64>],
        is_counted: impl Fn(usize) -> bool,
    ) -> f64 {
        let mut moved = Vec::new();
        let mut lowest: Option<f64> = None;
        for (joint, points) in self.points.iter().filter(|(joint, _)| is_counted(*joint)) {
            moved.clone_from(points);
            batch::transform(&motions[*joint], &mut moved);
            for point in &moved {
                let height = point.e2();
                lowest = Some(match lowest {
                    Some(least) if least < height || least.is_nan() => least,
                    _ => height,
                });
            }
        }
        lowest.unwrap_or(f64::NAN)
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

#[cfg(test)]
mod tests {
    use ga_runtime::cga3::Translator;

    use super::*;
    use crate::skeleton::Joint;

    #[test]
    fn the_middle_of_soles_is_their_mean() {
        let positions = [[0.0, 0.0, 0.0], [0.5, 0.0, 1.0], [0.0, 9.0, 0.0]].map(Point::from);
        let rows = [1, 1, 0].map(|joint| vec![(joint, 1.0)]);
        let weights = SkinWeights::new(2, rows).unwrap();
        let soles = Soles::of_mesh(&positions, &weights).unwrap();
        assert_eq!(soles.middle(|_| true), Some(Vector::new(0.25, 0.0, 0.5)));
        assert_eq!(soles.middle(|joint| joint == 0), None);
    }

    /// In the pose from which soles were found, they lie on the ground of that pose.
    #[test]
    fn soles_of_a_pose_move_with_their_joints() {
        let bone = |name: &str, parent, head, tail| Joint {
            name: name.into(),
            parent,
            head,
            tail,
        };
        let skeleton = Skeleton::new(vec![
            bone("leg", None, [0.0, 16.0, 0.0], [0.0, 1.0, 0.0]),
            bone("foot", Some(0), [0.0, 0.5, 0.0], [0.0, 0.0, 2.0]),
        ]);
        let skeleton = skeleton.unwrap();
        let lifted = Translator::from_displacement([3.0, 5.0, 0.0]).into();
        let motions = [lifted, lifted];
        let lowest = Soles::of_pose(&skeleton, &motions).lowest(&motions);
        assert!((lowest - 5.0).abs() < 1e-12, "{lowest}");
    }
}
