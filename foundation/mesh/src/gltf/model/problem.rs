//! Why a model cannot be written.

/// Why a model cannot be written. Everything is counted from 0.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ModelProblem {
    /// There is no vertex, or no triangle with three different corners.
    #[error("the mesh has no triangles")]
    Empty,
    /// A number is NaN or infinite in single precision.
    #[error("{what} {index} is not finite in single precision")]
    NotFinite {
        /// What the number belongs to.
        what: &'static str,
        /// Which one.
        index: usize,
    },
    /// A triangle names a vertex that does not exist.
    #[error("triangle {triangle} names vertex {vertex}, but there are {vertices} vertices")]
    Triangle {
        /// The triangle.
        triangle: usize,
        /// The vertex it names.
        vertex: u32,
        /// How many vertices there are.
        vertices: usize,
    },
    /// There are not as many normals or lists of weights as vertices.
    #[error("{found} {what}, not {expected}")]
    Count {
        /// What there is too much or too little of.
        what: &'static str,
        /// How many there should be.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// The colour or the roughness is not between 0 and 1.
    #[error("the material's colour or roughness is not between 0 and 1")]
    Material,
    /// A skin has no joints, or more than 16 bits can number.
    #[error("a skin has 1 to 65536 joints, but this one has {0}")]
    JointCount(usize),
    /// A joint's parent does not come before it.
    #[error("joint {joint:?} does not come after its parent {parent}")]
    ParentNotBefore {
        /// The joint's name.
        joint: String,
        /// The parent it names.
        parent: usize,
    },
    /// A joint's motor at rest cannot be normalised: its rotor is zero, or it is not finite.
    #[error("the rest of joint {joint:?} is not a rigid motion")]
    Rest {
        /// The joint's name.
        joint: String,
    },
    /// The weights of a vertex are negative or do not sum to 1.
    #[error("the weights of vertex {vertex} are negative or do not sum to 1: their sum is {sum}")]
    Weights {
        /// The vertex.
        vertex: usize,
        /// The sum of its weights.
        sum: f64,
    },
    /// A vertex is moved by a joint that does not exist.
    #[error("vertex {vertex} is moved by joint {joint}, but there are {joints} joints")]
    Influence {
        /// The vertex.
        vertex: usize,
        /// The joint.
        joint: u32,
        /// How many joints there are.
        joints: usize,
    },
    /// An animation has no keys or moves no joint.
    #[error("animation {animation:?} has no keys")]
    NoKeys {
        /// The animation's name.
        animation: String,
    },
    /// A time is negative, not finite, or not after the one before in single precision.
    #[error("animation {animation:?}: key {key} does not come after the key before it")]
    Time {
        /// The animation's name.
        animation: String,
        /// The key.
        key: usize,
    },
    /// A track is for a joint that does not exist or that has one already.
    #[error("animation {animation:?}: joint {joint} does not exist or has two tracks")]
    TrackJoint {
        /// The animation's name.
        animation: String,
        /// The joint.
        joint: usize,
    },
    /// The number of keys of a track differs from the number of times.
    #[error("animation {animation:?}: {found} keys for joint {joint}, but {expected} times")]
    TrackLength {
        /// The animation's name.
        animation: String,
        /// The joint.
        joint: usize,
        /// How many times there are.
        expected: usize,
        /// How many keys there are.
        found: usize,
    },
    /// A key is not finite in single precision, or its rotor is zero.
    #[error("animation {animation:?}: key {key} of joint {joint} is not a rigid motion")]
    Key {
        /// The animation's name.
        animation: String,
        /// The joint.
        joint: usize,
        /// The key.
        key: usize,
    },
}
