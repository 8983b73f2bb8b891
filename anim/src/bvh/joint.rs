//! Joints of a BVH skeleton.

/// A joint of a BVH skeleton.
#[derive(Clone, Debug, PartialEq)]
pub struct BvhJoint {
    /// The name, unique in its file.
    pub name: String,
    /// The index of the parent joint, or `None` for a root. Parents come before children.
    pub parent: Option<usize>,
    /// Where the joint is at rest, relative to its parent.
    pub offset: [f64; 3],
    /// The joint's channels, in the order of the file.
    pub channels: Vec<Channel>,
    /// How many channels the joints before this one have.
    pub first_channel: usize,
    /// The end of the bone at rest, relative to this joint, if the joint has an End Site.
    pub end_site: Option<[f64; 3]>,
}

/// What one number of a frame moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Channel {
    /// A translation along an axis: 0, 1, 2 for x, y, z.
    Position(usize),
    /// A rotation about an axis: 0, 1, 2 for x, y, z; in degrees, by the right-hand rule.
    Rotation(usize),
}
