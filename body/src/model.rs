//! Bodies: a skeleton and the points of the body that pictures show.

use crate::BodyError;
use ga_anim::skeleton::{JointLimits, Skeleton, SkeletonError};
use ga_anim::skin::Method;

/// A point of the body that pictures show: a joint, or a point of the skin.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyPoint {
    /// The name, for messages and files.
    pub name: String,
    /// Where it is at rest, in the coordinates of the skeleton.
    pub at_rest: [f64; 3],
    /// The joints that it follows and how much it follows each: weights that sum to 1, as those of
    /// a vertex of the skin. A point that is fixed to a bone follows one joint with the weight 1.
    pub joints: Vec<(usize, f64)>,
}

impl BodyPoint {
    /// The head of a joint.
    pub(super) fn at_joint(skeleton: &Skeleton, joint: usize) -> Self {
        let at = &skeleton.joints()[joint];
        Self {
            name: at.name.clone(),
            at_rest: at.head,
            joints: vec![(joint, 1.0)],
        }
    }
}

/// A body: a skeleton in metres with the points that are observed, and limits of its joints.
///
/// The lengths of the bones are those of the skeleton, exactly.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyModel {
    skeleton: Skeleton,
    points: Vec<BodyPoint>,
    limits: Option<JointLimits>,
    blending: Method,
}

/// By how much weights may miss the sum of 1: those of files are rounded.
const ROUNDING: f64 = 1e-3;

impl BodyModel {
    /// A body whose points are given.
    ///
    /// # Errors
    /// [`BodyError::NoPoints`], [`BodyError::NoJoint`], [`BodyError::DuplicateName`],
    /// [`BodyError::JointMissing`], [`BodyError::Weights`] and [`BodyError::PointNotFinite`].
    pub fn new(skeleton: Skeleton, points: Vec<BodyPoint>) -> Result<Self, BodyError> {
        if points.is_empty() {
            return Err(BodyError::NoPoints);
        }
        for (index, point) in points.iter().enumerate() {
            check(&skeleton, point)?;
            if points[..index].iter().any(|other| other.name == point.name) {
                let name = point.name.clone();
                return Err(BodyError::DuplicateName { name });
            }
        }
        Ok(Self {
            skeleton,
            points,
            limits: None,
            blending: Method::default(),
        })
    }

    /// A body that is observed at the joints of these names, in this order.
    ///
    /// # Errors
    /// [`BodyError::NoJoint`] for a name that is not that of a joint,
    /// [`BodyError::DuplicateName`], [`BodyError::NoPoints`].
    pub fn of_joints<N: AsRef<str>>(skeleton: Skeleton, names: &[N]) -> Result<Self, BodyError> {
        let points = names.iter().map(|name| {
            let name = name.as_ref();
            let missing = || BodyError::NoJoint {
                name: name.to_owned(),
                joints: skeleton.joints().iter().map(|j| j.name.clone()).collect(),
            };
            let joint = skeleton.index(name).ok_or_else(missing)?;
            Ok(BodyPoint::at_joint(&skeleton, joint))
        });
        let points = points.collect::<Result<_, BodyError>>()?;
        Self::new(skeleton, points)
    }

    /// A body that is observed at all its joints, of those in the same place at rest the first one.
    /// Of the 31 joints of CMU's motion capture, 21 are in places of their own.
    ///
    /// # Errors
    /// None in practice: a skeleton has joints.
    pub fn of_distinct_joints(skeleton: Skeleton) -> Result<Self, BodyError> {
        let joints = skeleton.joints();
        let is_first = |index: &usize| {
            let head = joints[*index].head;
            joints[..*index].iter().all(|other| other.head != head)
        };
        let points = (0..joints.len()).filter(is_first);
        let points = points
            .map(|joint| BodyPoint::at_joint(&skeleton, joint))
            .collect();
        Self::new(skeleton, points)
    }

    /// The same body with limits of its joints.
    ///
    /// # Errors
    /// [`SkeletonError::LimitCount`] where they are for another number of joints.
    pub fn with_limits(self, limits: JointLimits) -> Result<Self, BodyError> {
        let (expected, found) = (self.skeleton.len(), limits.joint_count());
        if expected != found {
            return Err(SkeletonError::LimitCount { expected, found }.into());
        }
        Ok(Self {
            limits: Some(limits),
            ..self
        })
    }

    /// The same body with another way in which a point follows several joints; [`Method::Linear`]
    /// at first.
    #[must_use]
    pub fn with_blending(self, blending: Method) -> Self {
        Self { blending, ..self }
    }

    /// The same body with joints and points in other places.
    pub(super) fn with_skeleton(&self, skeleton: Skeleton, points: Vec<BodyPoint>) -> Self {
        Self {
            skeleton,
            points,
            ..self.clone()
        }
    }

    /// The skeleton, in metres.
    #[must_use]
    pub fn skeleton(&self) -> &Skeleton {
        &self.skeleton
    }

    /// The points that are observed.
    #[must_use]
    pub fn points(&self) -> &[BodyPoint] {
        &self.points
    }

    /// The limits of the joints.
    #[must_use]
    pub fn limits(&self) -> Option<&JointLimits> {
        self.limits.as_ref()
    }

    /// How a point follows several joints.
    #[must_use]
    pub fn blending(&self) -> Method {
        self.blending
    }
}

fn check(skeleton: &Skeleton, point: &BodyPoint) -> Result<(), BodyError> {
    let name = || point.name.clone();
    let count = skeleton.len();
    if let Some(&(joint, _)) = point.joints.iter().find(|(joint, _)| *joint >= count) {
        return Err(BodyError::JointMissing {
            name: name(),
            joint,
            count,
        });
    }
    let weights = || point.joints.iter().map(|(_, weight)| *weight);
    let sum: f64 = weights().sum();
    if !weights().all(|weight| weight >= 0.0) || (sum - 1.0).abs() > ROUNDING || sum.is_nan() {
        return Err(BodyError::Weights {
            name: name(),
            weights: weights().collect(),
        });
    }
    if !point.at_rest.iter().all(|x| x.is_finite()) {
        return Err(BodyError::PointNotFinite {
            name: name(),
            at_rest: point.at_rest,
        });
    }
    Ok(())
}
