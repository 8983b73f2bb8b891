//! Skinning: the positions of the vertices when the joints move.
//!
//! Each vertex follows several joints by weights w that sum to 1, any number of them.
//!
//! | method | formula | keeps |
//! | --- | --- | --- |
//! | [`Method::Linear`] | x' = (Σ w A) x | straight lines; volume is lost where joints twist |
//! | [`Method::Motor`] | x' = B x ~B | lengths about each joint: B is a rigid motion |
//!
//! Here A = \[R\|t\] is the 3×4 matrix of a joint's motor G, and B = Σ ± w G, normalised.
//!
//! In the motor blend each G takes the sign that brings it nearer to the strongest one's, since G
//! and −G are one motion. The sum lies in the 8 coefficients of a dual quaternion and is made a
//! motor again by its norm; for rotors and translators this is the dual quaternion blend.
//!
//! Sources: N. Magnenat-Thalmann, R. Laperrière, D. Thalmann, "Joint-dependent local deformations
//! for hand animation and object grasping", 1988; L. Kavan, S. Collins, J. Žára, C. O'Sullivan,
//! "Geometric skinning with approximate dual quaternion blending", ACM Transactions on Graphics
//! 27(4), 2008.

mod linear;
mod motor;
mod report;

use ga_runtime::cga3::{Motor, Point};

use crate::pose::PoseError;
use crate::weights::SkinWeights;

pub use report::BodyReport;

/// How the motions of several joints are combined into that of a vertex.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Method {
    /// The weighted mean of the positions to which the joints would take the vertex.
    #[default]
    Linear,
    /// The weighted mean of the joints' motors.
    Motor,
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
    /// The motors of a vertex have no mean: they are not unit motors, or not finite.
    #[error("the motions of vertex {vertex} have no mean")]
    NoMean {
        /// The vertex.
        vertex: usize,
    },
}

/// Moves the vertices at rest by the motions of the joints (see
/// [`Pose::motions`](crate::pose::Pose::motions)).
///
/// # Errors
///
/// Any [`SkinError`]; [`SkinError::NoMean`] only from [`Method::Motor`] and never for unit motors.
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
    let (expected, found) = (positions.len(), weights.vertex_count());
    if expected != found {
        return Err(SkinError::VertexCount { expected, found });
    }
    let (expected, found) = (weights.joint_count(), motions.len());
    if expected != found {
        return Err(SkinError::JointCount { expected, found });
    }
    match method {
        Method::Linear => Ok(linear::blend(positions, weights, motions)),
        Method::Motor => motor::blend(positions, weights, motions),
    }
}
