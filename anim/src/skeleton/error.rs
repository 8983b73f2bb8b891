//! What can be wrong with a skeleton, its limits and its poses.

/// Joints that do not form a skeleton, limits that its joints cannot have, or a pose of another
/// one.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SkeletonError {
    /// There is no joint.
    #[error("the skeleton has no joints")]
    Empty,
    /// A joint's parent is not among the joints before it, so it is missing, or the joints are out
    /// of order or in a cycle.
    #[error("joint {name:?} has joint {parent} as its parent, which does not come before it")]
    ParentNotBefore {
        /// The joint.
        name: String,
        /// The index that it has as its parent.
        parent: usize,
    },
    /// A joint's parent does not exist.
    #[error("joint {name:?} has joint {parent} as its parent, which does not exist")]
    ParentMissing {
        /// The joint.
        name: String,
        /// The index that it has as its parent.
        parent: usize,
    },
    /// A joint is its own ancestor.
    #[error("joint {name:?} is its own ancestor")]
    Cycle {
        /// The joint.
        name: String,
    },
    /// Two joints have the same name.
    #[error("two joints are called {name:?}")]
    DuplicateName {
        /// The name.
        name: String,
    },
    /// A coordinate of a joint is infinite or not a number.
    #[error("joint {name:?} has a coordinate that is not finite: head {head:?}, tail {tail:?}")]
    NotFinite {
        /// The joint.
        name: String,
        /// Its head.
        head: [f64; 3],
        /// Its tail.
        tail: [f64; 3],
    },
    /// The number of limits is not that of the joints.
    #[error("{found} limits for a skeleton of {expected} joints")]
    LimitCount {
        /// How many joints there are.
        expected: usize,
        /// How many limits.
        found: usize,
    },
    /// The axis has no length or is not finite.
    #[error("joint {joint:?}: {axis:?} is not an axis")]
    LimitAxis {
        /// The joint.
        joint: String,
        /// The axis.
        axis: [f64; 3],
    },
    /// The range is empty, wider than a whole rotation, or not finite.
    #[error("joint {joint:?}: from {} to {} rad is not a range of angles", .range[0], .range[1])]
    LimitRange {
        /// The joint.
        joint: String,
        /// The range.
        range: [f64; 2],
    },
    /// The greatest swing is not between 0 and π.
    #[error("joint {joint:?}: {swing} rad is not the angle of a cone")]
    LimitSwing {
        /// The joint.
        joint: String,
        /// The angle.
        swing: f64,
    },
    /// A pose does not fit a skeleton.
    #[error("a pose of {found} joints for a skeleton of {expected}")]
    PoseLength {
        /// How many joints the skeleton has.
        expected: usize,
        /// How many the pose has.
        found: usize,
    },
}
