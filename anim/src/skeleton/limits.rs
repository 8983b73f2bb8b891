//! Joint limits: which rotations a joint admits, and the admissible one nearest to any other.
//!
//! Two rotations are as far apart as the angle of the rotation between them. For unit rotors this
//! angle is `2 arccos |⟨A ~B⟩₀|`, so the nearest admissible rotor is the one with the greatest
//! |⟨A ~B⟩₀|. It has a closed form for the limits here. Write the part of a rotor that commutes
//! with the rotations about an axis a as the complex number z, and the rest as w:
//!
//! ```text
//! R = cos ½σ (cos ½τ − sin ½τ a I) + sin ½σ (…),   |z| = cos ½σ, arg z = ½τ, |w| = sin ½σ
//! ```
//!
//! with the *twist* τ about the axis, which is done first, and the *swing* σ about an axis
//! perpendicular to it, which moves the axis by the angle σ. A hinge admits w = 0, and the nearest
//! angle is τ, clamped on the circle. With swing and twist, the direction of w is free; the nearest
//! twist is τ' = τ clamped on the circle, and then the nearest swing has
//! `tan ½σ' = tan ½σ / cos ½(τ − τ')`, clamped to the cone.

use std::f64::consts::{PI, TAU};

use ga_runtime::cga3::Rotor;
use ga_runtime::vga3::Vector;

use super::Skeleton;
use crate::skeleton::SkeletonError;

/// The rotations that a joint admits, relative to its parent, from rest and in the axes of the
/// skeleton at rest.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Limit {
    /// All of them.
    #[default]
    Free,
    /// No rotation.
    Fixed,
    /// Rotations about one axis.
    Hinge {
        /// The axis, of any length.
        axis: [f64; 3],
        /// The least and the greatest angle in radians, right-handed about the axis.
        range: [f64; 2],
    },
    /// A cone for the direction of an axis, usually that of the bone, and a range for rotations
    /// about it.
    SwingTwist {
        /// The axis at rest, of any length.
        axis: [f64; 3],
        /// The greatest angle in radians between the axis and itself at rest, at most π.
        swing: f64,
        /// The least and the greatest angle of the rotation about the axis, which comes before the
        /// swing.
        twist: [f64; 2],
    },
}

/// The limits of all joints of a skeleton.
///
/// ```
/// use std::f64::consts::FRAC_PI_2;
///
/// use ga_anim::skeleton::{Joint, JointLimits, Limit, Skeleton};
/// use ga_runtime::cga3::Rotor;
///
/// let knee = Joint {
///     name: "knee".into(),
///     parent: None,
///     head: [0.0, 0.5, 0.0],
///     tail: [0.0, 0.1, 0.0],
/// };
/// let leg = Skeleton::new(vec![knee])?;
/// let hinge = Limit::Hinge { axis: [1.0, 0.0, 0.0], range: [0.0, 2.4] };
/// let limits = JointLimits::new(&leg, vec![hinge])?;
/// // A knee does not bend forwards.
/// let wrong = Rotor::from_axis_angle([1.0, 0.0, 0.0], -FRAC_PI_2).ok_or("no axis")?;
/// assert!(limits.clamp(0, wrong).to_axis_angle().1 < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct JointLimits {
    limits: Vec<Prepared>,
}

/// A limit with a unit axis.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Prepared {
    Free,
    Fixed,
    Hinge {
        axis: Vector<f64>,
        range: [f64; 2],
    },
    SwingTwist {
        axis: Vector<f64>,
        swing: f64,
        twist: [f64; 2],
    },
}

impl JointLimits {
    /// Limits for the joints of a skeleton, in their order.
    ///
    /// # Errors
    ///
    /// [`SkeletonError::LimitCount`], [`SkeletonError::LimitAxis`], [`SkeletonError::LimitRange`]
    /// and [`SkeletonError::LimitSwing`].
    pub fn new(skeleton: &Skeleton, limits: Vec<Limit>) -> Result<Self, SkeletonError> {
        let (expected, found) = (skeleton.len(), limits.len());
        if expected != found {
            return Err(SkeletonError::LimitCount { expected, found });
        }
        let joints = skeleton.joints().iter().zip(limits);
        let limits = joints.map(|(joint, limit)| prepared(&joint.name, limit));
        Ok(Self {
            limits: limits.collect::<Result<_, _>>()?,
        })
    }

    /// No limits, for this number of joints.
    #[must_use]
    pub fn free(joint_count: usize) -> Self {
        Self {
            limits: vec![Prepared::Free; joint_count],
        }
    }

    /// For how many joints the limits are.
    #[must_use]
    pub fn joint_count(&self) -> usize {
        self.limits.len()
    }

    /// The admissible rotation of a joint that is nearest to this one; the rotation itself where it
    /// is admissible. Where several are equally near, it is one of them. A joint beyond the last
    /// one is free.
    #[must_use]
    pub fn clamp(&self, joint: usize, rotor: Rotor<f64>) -> Rotor<f64> {
        match self.limits.get(joint) {
            None | Some(Prepared::Free) => rotor,
            Some(Prepared::Fixed) => Rotor::default(),
            Some(&Prepared::Hinge { axis, range }) => {
                rotation(axis, clamp_angle(angle_about(axis, rotor), range))
            }
            Some(&Prepared::SwingTwist { axis, swing, twist }) => {
                clamp_swing_twist(rotor, axis, swing, twist)
            }
        }
    }

    /// The angle in radians by which a joint's rotation is away from what is admissible.
    #[must_use]
    pub fn excess(&self, joint: usize, rotor: Rotor<f64>) -> f64 {
        let between = self.clamp(joint, rotor).reverse() * rotor;
        angle(between)
    }

    /// The unit axis about which alone a joint rotates, if it is a hinge.
    #[must_use]
    pub fn hinge_axis(&self, joint: usize) -> Option<Vector<f64>> {
        match self.limits.get(joint) {
            Some(&Prepared::Hinge { axis, .. }) => Some(axis),
            _ => None,
        }
    }

    /// Whether a joint cannot rotate.
    #[must_use]
    pub fn is_fixed(&self, joint: usize) -> bool {
        self.limits.get(joint) == Some(&Prepared::Fixed)
    }
}

/// The angle of a rotation in [0, π], the shorter way.
fn angle(rotor: Rotor<f64>) -> f64 {
    let sine = rotor.e12().hypot(rotor.e13()).hypot(rotor.e23());
    2.0 * sine.atan2(rotor.scalar().abs())
}

fn prepared(name: &str, limit: Limit) -> Result<Prepared, SkeletonError> {
    let unit = |axis: [f64; 3]| {
        let joint = || name.to_owned();
        let none = || SkeletonError::LimitAxis {
            joint: joint(),
            axis,
        };
        Vector::from(axis).normalized().ok_or_else(none)
    };
    let checked = |range: [f64; 2]| {
        let width = range[1] - range[0];
        if (0.0..=TAU * (1.0 + 1e-12)).contains(&width) && range[0].is_finite() {
            return Ok(range);
        }
        let joint = name.to_owned();
        Err(SkeletonError::LimitRange { joint, range })
    };
    Ok(match limit {
        Limit::Free => Prepared::Free,
        Limit::Fixed => Prepared::Fixed,
        Limit::Hinge { axis, range } => Prepared::Hinge {
            axis: unit(axis)?,
            range: checked(range)?,
        },
        Limit::SwingTwist { axis, swing, twist } => {
            if !(0.0..=PI).contains(&swing) {
                let joint = name.to_owned();
                return Err(SkeletonError::LimitSwing { joint, swing });
            }
            Prepared::SwingTwist {
                axis: unit(axis)?,
                swing,
                twist: checked(twist)?,
            }
        }
    })
}

/// The angle of the part of a rotor that rotates about an axis; 0 where there is no such part.
fn angle_about(axis: Vector<f64>, rotor: Rotor<f64>) -> f64 {
    let (vector, scalar) = rotor.to_quaternion();
    2.0 * Vector::from(vector).dot(axis).atan2(scalar)
}

fn rotation(axis: Vector<f64>, angle: f64) -> Rotor<f64> {
    let (sine, cosine) = (0.5 * angle).sin_cos();
    with_vector(axis * sine, cosine)
}

/// The rotor `w − v I` of a unit quaternion.
fn with_vector(vector: Vector<f64>, scalar: f64) -> Rotor<f64> {
    Rotor::new_unchecked(scalar, -vector.e3, vector.e2, -vector.e1)
}

/// The angle in a range that is nearest on the circle.
fn clamp_angle(angle: f64, [low, high]: [f64; 2]) -> f64 {
    if (low..=high).contains(&angle) {
        return angle;
    }
    // The same angle from `low` on.
    let above = low + (angle - low).rem_euclid(TAU);
    if above <= high {
        return above;
    }
    if above - high <= low + TAU - above {
        high
    } else {
        low
    }
}

fn clamp_swing_twist(
    rotor: Rotor<f64>,
    axis: Vector<f64>,
    swing: f64,
    twist: [f64; 2],
) -> Rotor<f64> {
    let (vector, scalar) = rotor.to_quaternion();
    let vector = Vector::from(vector);
    let along = vector.dot(axis);
    let across = vector - axis * along;
    let (cosine, sine) = (along.hypot(scalar), across.length());
    let found = 2.0 * along.atan2(scalar);
    let nearest = clamp_angle(found, twist);
    // The two may differ by whole rotations; then the cosine is negative, and −R is nearer, whose
    // other part is the opposite.
    let between = (0.5 * (found - nearest)).cos();
    let (between, across) = if between < 0.0 {
        (-between, -across)
    } else {
        (between, across)
    };
    let half = sine.atan2(cosine * between);
    if nearest == found && half <= 0.5 * swing {
        return rotor;
    }
    let (sine, cosine) = half.min(0.5 * swing).sin_cos();
    let (twist_sine, twist_cosine) = (0.5 * nearest).sin_cos();
    let aside = across.normalized().unwrap_or_default();
    with_vector(
        axis * (cosine * twist_sine) + aside * sine,
        cosine * twist_cosine,
    )
}
