//! Skeletons: joints in a tree at rest, each with the bone that it rotates, and the limits of their
//! rotations.

mod error;
mod limits;
mod order;

use std::collections::HashMap;

pub use error::SkeletonError;
pub use limits::{JointLimits, Limit};

/// A joint and its bone, at rest, in the coordinates of the mesh.
///
/// The joint is at `head` and the bone goes from there to `tail`. A rotation of the joint rotates
/// its bone, and everything below it, about `head`.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// The name, unique in its skeleton.
    pub name: String,
    /// The index of the parent joint, or `None` for a root.
    pub parent: Option<usize>,
    /// Where the joint is and the bone begins.
    pub head: [f64; 3],
    /// Where the bone ends. It may equal `head`: such a joint has no direction.
    pub tail: [f64; 3],
}

/// A tree of joints (or several trees), in which parents come before their children.
///
/// So one pass over [`Skeleton::joints`] from first to last always meets a parent before its
/// children.
///
/// # Examples
///
/// ```
/// use ga_anim::skeleton::{Joint, Skeleton};
///
/// let hip = Joint {
///     name: "hip".into(),
///     parent: None,
///     head: [0.0, 0.9, 0.0],
///     tail: [0.0, 0.5, 0.0],
/// };
/// let knee = Joint {
///     name: "knee".into(),
///     parent: Some(0),
///     head: [0.0, 0.5, 0.0],
///     tail: [0.0, 0.1, 0.0],
/// };
/// let leg = Skeleton::new(vec![hip, knee])?;
/// assert_eq!(leg.index("knee"), Some(1));
/// # Ok::<(), ga_anim::skeleton::SkeletonError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Skeleton {
    joints: Vec<Joint>,
    by_name: HashMap<String, usize>,
}

impl Skeleton {
    /// A skeleton of these joints, parents first.
    ///
    /// # Errors
    ///
    /// [`SkeletonError::Empty`], [`SkeletonError::ParentNotBefore`],
    /// [`SkeletonError::DuplicateName`] and [`SkeletonError::NotFinite`].
    pub fn new(joints: Vec<Joint>) -> Result<Self, SkeletonError> {
        if joints.is_empty() {
            return Err(SkeletonError::Empty);
        }
        let mut by_name = HashMap::with_capacity(joints.len());
        for (index, joint) in joints.iter().enumerate() {
            let name = joint.name.clone();
            if let Some(parent) = joint.parent.filter(|&parent| parent >= index) {
                return Err(SkeletonError::ParentNotBefore { name, parent });
            }
            let (head, tail) = (joint.head, joint.tail);
            if !head.iter().chain(&tail).all(|x| x.is_finite()) {
                return Err(SkeletonError::NotFinite { name, head, tail });
            }
            if by_name.insert(name.clone(), index).is_some() {
                return Err(SkeletonError::DuplicateName { name });
            }
        }
        Ok(Self { joints, by_name })
    }

    /// The joints, parents before children.
    #[must_use]
    pub fn joints(&self) -> &[Joint] {
        &self.joints
    }

    /// How many joints there are; never 0.
    #[must_use]
    #[expect(clippy::len_without_is_empty, reason = "a skeleton is never empty")]
    pub fn len(&self) -> usize {
        self.joints.len()
    }

    /// The index of the joint of this name.
    #[must_use]
    pub fn index(&self, name: &str) -> Option<usize> {
        self.by_name.get(name).copied()
    }

    /// The joint of this name.
    #[must_use]
    pub fn joint(&self, name: &str) -> Option<&Joint> {
        self.index(name).map(|index| &self.joints[index])
    }

    /// The indices of the joints right below `joint`.
    pub fn children(&self, joint: usize) -> impl Iterator<Item = usize> + '_ {
        (0..self.joints.len()).filter(move |&other| self.joints[other].parent == Some(joint))
    }

    /// The same skeleton in another unit: every coordinate times `factor`.
    ///
    /// # Errors
    ///
    /// [`SkeletonError::NotFinite`] when a product overflows or `factor` is not a number.
    pub fn scaled(&self, factor: f64) -> Result<Self, SkeletonError> {
        let scale = |x: [f64; 3]| x.map(|x| x * factor);
        Self::new(
            self.joints
                .iter()
                .map(|joint| Joint {
                    head: scale(joint.head),
                    tail: scale(joint.tail),
                    ..joint.clone()
                })
                .collect(),
        )
    }
}
