//! Joints in any order.

use super::{Joint, Skeleton};
use crate::skeleton::SkeletonError;

impl Skeleton {
    /// A skeleton of joints in any order, in which `parent` counts in the order given, and where
    /// each joint of the result was there. Parents are put before their children; apart from that,
    /// the order stays as it is.
    ///
    /// # Errors
    ///
    /// [`SkeletonError::Empty`], [`SkeletonError::ParentMissing`], [`SkeletonError::Cycle`],
    /// [`SkeletonError::DuplicateName`] and [`SkeletonError::NotFinite`]: of joints that are their
    /// own ancestors, the first is named.
    ///
    /// ```
    /// use ga_anim::skeleton::{Joint, Skeleton, SkeletonError};
    ///
    /// let joint = |name: &str, parent| Joint {
    ///     name: name.into(),
    ///     parent,
    ///     head: [0.0; 3],
    ///     tail: [0.0, 1.0, 0.0],
    /// };
    /// let (skeleton, from) =
    ///     Skeleton::in_any_order(vec![joint("hand", Some(1)), joint("arm", None)])?;
    /// assert_eq!((skeleton.joints()[1].name.as_str(), from), ("hand", vec![1, 0]));
    ///
    /// let ring = vec![joint("a", None), joint("b", Some(2)), joint("c", Some(1))];
    /// assert_eq!(
    ///     Skeleton::in_any_order(ring),
    ///     Err(SkeletonError::Cycle { name: "b".into() })
    /// );
    /// # Ok::<(), SkeletonError>(())
    /// ```
    pub fn in_any_order(joints: Vec<Joint>) -> Result<(Self, Vec<usize>), SkeletonError> {
        let count = joints.len();
        let mut from: Vec<usize> = Vec::with_capacity(count);
        let mut place: Vec<Option<usize>> = vec![None; count];
        let mut path = Vec::new();
        for start in 0..count {
            // From a joint up to the first ancestor that has its place.
            let mut above = Some(start);
            while let Some(joint) = above.filter(|&joint| place[joint].is_none()) {
                if path.len() == count {
                    let name = first_in_cycle(&joints, joint);
                    return Err(SkeletonError::Cycle { name });
                }
                path.push(joint);
                above = joints[joint].parent;
                if let Some(parent) = above.filter(|&parent| parent >= count) {
                    let name = joints[joint].name.clone();
                    return Err(SkeletonError::ParentMissing { name, parent });
                }
            }
            while let Some(joint) = path.pop() {
                place[joint] = Some(from.len());
                from.push(joint);
            }
        }
        let ordered = from.iter().map(|&joint| Joint {
            parent: joints[joint].parent.and_then(|parent| place[parent]),
            ..joints[joint].clone()
        });
        Ok((Self::new(ordered.collect())?, from))
    }
}

/// The name of the first joint, in the order given, of the cycle that the ancestors of a joint lead
/// into.
fn first_in_cycle(joints: &[Joint], start: usize) -> String {
    // After as many steps as there are joints one is in the cycle.
    let up = |joint: usize| joints[joint].parent.unwrap_or(joint);
    let inside = (0..joints.len()).fold(start, |joint, _| up(joint));
    let mut first = inside;
    let mut joint = up(inside);
    while joint != inside {
        first = first.min(joint);
        joint = up(joint);
    }
    joints[first].name.clone()
}
