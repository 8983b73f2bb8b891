//! Skinning: the positions of the vertices when the joints move.
//!
//! Each vertex follows several joints by weights w that sum to 1, any number of them.
//!
//! | method | formula | keeps |
//! | --- | --- | --- |
//! | [`Method::Linear`] | x' = (Σ w A) x | straight lines; volume is lost where joints twist |
//! | [`Method::Motor`] | x' = B S x ~B | lengths about each joint: B is a rigid motion |
//! | [`Method::DualQuaternion`] | x' = B x ~B | the same, and drops scale |
//!
//! Here A = \[R\|t\] is the 3×4 matrix of a joint's motor G, B = Σ ± w G, normalised, and S = Σ w S
//! the mean of what the joints scale at rest, the identity for joints that only move.
//!
//! In the motor blend each G takes the sign that brings it nearer to the strongest one's, since G
//! and −G are one motion. The sum lies in the 8 coefficients of a dual quaternion and is made a
//! motor again by its norm; for rotors and translators this is the dual quaternion blend.
//!
//! [`skin`] moves vertices once. For many frames a [`Binding`] is prepared once and takes a
//! [`Palette`] of motions for each frame; it also moves normals and tangents, in `f32` or `f64`,
//! and mixes the methods ([`Binding::pose_mixed`]).
//!
//! Sources: N. Magnenat-Thalmann, R. Laperrière, D. Thalmann, "Joint-dependent local deformations
//! for hand animation and object grasping", 1988; L. Kavan, S. Collins, J. Žára, C. O'Sullivan,
//! "Geometric skinning with approximate dual quaternion blending", ACM Transactions on Graphics
//! 27(4), 2008.

mod binding;
mod bounds;
mod palette;
mod report;
mod stretch;

use ga_runtime::batch::LengthMismatch;
use ga_runtime::batch::skin::SkinError as BatchError;
use ga_runtime::cga3::{Motor, Point};

use crate::pose::PoseError;
use crate::weights::SkinWeights;

pub use binding::Binding;
pub use bounds::bounds;
pub use ga_runtime::batch::skin::{Mix, Posed, SkinScalar};
pub use palette::Palette;
pub use report::BodyReport;
pub use stretch::Stretched;

/// How the motions of several joints are combined into that of a vertex.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Method {
    /// The weighted mean of the positions to which the joints would take the vertex.
    #[default]
    Linear,
    /// The weighted mean of the joints' motors, after that of their stretches.
    Motor,
    /// The weighted mean of the joints' motors alone: where joints scale, the scale is dropped.
    DualQuaternion,
}

/// Why positions, weights and motions do not fit together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SkinError {
    /// There are weights for another number of vertices.
    #[error("weights for {found} vertices, but there are {expected}")]
    VertexCount {
        /// How many vertices there are.
        expected: usize,
        /// How many have weights.
        found: usize,
    },
    /// There are motions for another number of joints.
    #[error("{found} motions for weights on {expected} joints")]
    JointCount {
        /// How many joints the weights are for.
        expected: usize,
        /// How many motions there are.
        found: usize,
    },
    /// There is no vertex to measure.
    #[error("a mesh without vertices has no height")]
    NoVertices,
    /// A pose does not fit the skeleton.
    #[error(transparent)]
    Pose(#[from] PoseError),
    /// The motion of a joint is not finite, or not a unit motor.
    #[error("the motion of joint {joint} is not finite or not a unit motor")]
    BadMotion {
        /// The joint.
        joint: usize,
    },
    /// Normals or tangents are asked for, but the binding has none.
    #[error("normals or tangents are asked for, but the vertices were bound without them")]
    NoDirections,
    /// A mixture needs a palette of the linear blend and one of a blend of motors.
    #[error(
        "the first palette of a mixture must be of the linear blend, the second of a blend of motors"
    )]
    NotBoth,
    /// More joints or pairs of joints than the indices can count.
    #[error("there are more than 65,536 joints, or too many pairs of them")]
    TooLarge,
}

/// What the binding checks itself cannot occur again; weights are checked by [`SkinWeights`].
impl From<BatchError> for SkinError {
    fn from(error: BatchError) -> Self {
        match error {
            BatchError::Length(LengthMismatch { expected, found }) => {
                Self::VertexCount { expected, found }
            }
            BatchError::BadMotion { joint } => Self::BadMotion { joint },
            BatchError::NoDirections => Self::NoDirections,
            _ => Self::TooLarge,
        }
    }
}

/// Moves the vertices at rest by the motions of the joints (see
/// [`Pose::motions`](crate::pose::Pose::motions)).
///
/// # Errors
///
/// [`SkinError::VertexCount`], [`SkinError::JointCount`], [`SkinError::TooLarge`], and
/// [`SkinError::BadMotion`], which does not occur for unit motors.
///
/// # Examples
///
/// Half way between rest and a rotation by 90°, the linear blend lies inside the arc and the motor
/// blend on it.
///
/// ```
/// use ga_anim::skin::{self, Method};
/// use ga_anim::weights::SkinWeights;
/// use ga_runtime::cga3::{Motor, Point, Rotor};
///
/// let quarter =
///     Rotor::from_axis_angle([0.0, 0.0, 1.0], std::f64::consts::FRAC_PI_2).ok_or("no axis")?;
/// let motions = [Motor::default(), Motor::from(quarter)];
/// let weights = SkinWeights::new(2, [[(0, 0.5), (1, 0.5)]])?;
/// let radius = |method| {
///     skin::skin(&[[1.0, 0.0, 0.0].into()], &weights, &motions, method)
///         .map(|moved| moved[0].distance(Point::new(0.0, 0.0, 0.0)))
/// };
/// assert!((radius(Method::Linear)? - 0.5f64.sqrt()).abs() < 1e-15);
/// assert!((radius(Method::Motor)? - 1.0).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn skin(
    positions: &[Point<f64>],
    weights: &SkinWeights,
    motions: &[Motor<f64>],
    method: Method,
) -> Result<Vec<Point<f64>>, SkinError> {
    let binding = Binding::new(positions, weights)?;
    let mut palette = binding.palette(method);
    palette.set_motions(motions)?;
    let mut moved = positions.to_vec();
    binding.pose(&palette, Posed::of_points(&mut moved))?;
    Ok(moved)
}
