//! Skins and animations.

use super::Extras;

/// Joints that move the vertices of a mesh.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Skin {
    /// Its name.
    pub name: Option<String>,
    /// The nodes that are its joints, in the order in which vertices number them.
    pub joints: Vec<usize>,
    /// For each joint, the matrix that takes the mesh to the joint's frame at rest, column by
    /// column; the identity for each where empty.
    pub inverse_bind_matrices: Vec<[f32; 16]>,
    /// A node above all joints.
    pub skeleton: Option<usize>,
    /// Data of an application.
    pub extras: Extras,
}

/// A motion of nodes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Animation {
    /// Its name.
    pub name: Option<String>,
    /// What moves; at most one channel for each node and kind of [`Keys`].
    pub channels: Vec<Channel>,
    /// Data of an application.
    pub extras: Extras,
}

/// How one property of a node changes.
#[derive(Clone, Debug, PartialEq)]
pub struct Channel {
    /// The node.
    pub node: usize,
    /// The times of the keys in seconds, not negative and strictly increasing.
    pub times: Vec<f32>,
    /// What lies between the keys.
    pub interpolation: Interpolation,
    /// The values at those times. [`Interpolation::CubicSpline`] has three for each key: the
    /// tangent into it, its value, the tangent out of it.
    pub keys: Keys,
    /// Data of an application.
    pub extras: Extras,
}

/// What lies between two keys.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Interpolation {
    /// The straight line between them; for rotations the shorter arc, by slerp.
    #[default]
    Linear,
    /// The first of them.
    Step,
    /// The cubic Hermite spline through them; rotations are normalised.
    CubicSpline,
}

/// The values of a property of a node.
#[derive(Clone, Debug, PartialEq)]
pub enum Keys {
    /// Translations.
    Translation(Vec<[f32; 3]>),
    /// Rotations as unit quaternions (x, y, z, w).
    Rotation(Vec<[f32; 4]>),
    /// Factors along the axes.
    Scale(Vec<[f32; 3]>),
    /// Weights of morph targets: for each key one for each target.
    Weights(Vec<f32>),
}

impl Animation {
    /// The time of the last key of any channel, in seconds; 0 without channels.
    #[must_use]
    pub fn duration(&self) -> f64 {
        let last = self.channels.iter().filter_map(|c| c.times.last());
        last.copied().map(f64::from).fold(0.0, f64::max)
    }
}

impl Interpolation {
    /// How many values each key has.
    #[must_use]
    pub fn values_per_key(self) -> usize {
        match self {
            Self::Linear | Self::Step => 1,
            Self::CubicSpline => 3,
        }
    }
}

impl Keys {
    /// How many numbers a value has; weights count as one each.
    #[must_use]
    pub fn width(&self) -> usize {
        match self {
            Self::Translation(_) | Self::Scale(_) => 3,
            Self::Rotation(_) => 4,
            Self::Weights(_) => 1,
        }
    }

    /// The numbers of all values, one value after the other.
    #[must_use]
    pub fn numbers(&self) -> &[f32] {
        match self {
            Self::Translation(values) | Self::Scale(values) => values.as_flattened(),
            Self::Rotation(values) => values.as_flattened(),
            Self::Weights(values) => values,
        }
    }

    /// The name of the property, as glTF has it.
    #[must_use]
    pub fn path(&self) -> &'static str {
        match self {
            Self::Translation(_) => "translation",
            Self::Rotation(_) => "rotation",
            Self::Scale(_) => "scale",
            Self::Weights(_) => "weights",
        }
    }
}
