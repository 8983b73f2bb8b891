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

use ga_runtime::cga3::{Motor, Point};

use crate::weights::SkinWeights;

pub use crate::weights::error::SkinError;
pub use binding::Binding;
pub use bounds::bounds;
pub use ga_runtime::batch::skin::{Mix, Posed, SkinScalar};
pub use palette::{Method, Palette};
pub use report::BodyReport;
pub use stretch::Stretched;

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
