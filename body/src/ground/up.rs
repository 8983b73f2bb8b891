//! Which way is up.
//!
//! Persons stand and walk upright in the mean, to some degrees; feet that stand in several places
//! stand on one plane. The direction u is the one of the least sum
//!
//! ```text
//! Σ (u · (p − p̄))² / σ² + |u − t|² / τ²
//! ```
//!
//! over all places p at which a point of a foot stands, in groups of one height with the mean p̄,
//! and the mean direction t from the ankles to the shoulders, with the deviations σ and τ.

use ga_runtime::vga3::Vector;
use nalgebra_035::{Matrix3, Vector3};

use super::UpSource;

/// How far places at which feet stand are from a plane, as a standard deviation in metres.
const PLANE: f64 = 0.012;
/// How far the mean posture of a person is from upright, in radians.
const POSTURE: f64 = 6.0 * std::f64::consts::PI / 180.0;
/// Feet say more than the posture where they know the direction to this part of its deviation.
const KNOWN: f64 = 0.5;
/// An axis of the world is up where it is within so many deviations of what feet and posture say.
const AXIS: f64 = 3.0;
const ROUNDS: usize = 5;

/// The mean posture of a person.
pub(crate) struct Leaning(pub(crate) Vector<f64>);

/// A direction that is up.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Upright {
    pub(crate) up: Vector<f64>,
    /// In radians.
    pub(crate) deviation: f64,
    pub(crate) source: UpSource,
}

impl Leaning {
    /// The mean direction from the lower to the upper ends of a body.
    pub(crate) fn of(ends: impl Iterator<Item = [Vector<f64>; 2]>) -> Option<Self> {
        let sum = ends.fold(Vector::default(), |sum, [low, high]| {
            let way = high - low;
            sum + way / way.length().max(f64::MIN_POSITIVE)
        });
        let length = sum.length();
        (length > 0.0 && length.is_finite()).then(|| Self(sum / length))
    }
}

impl Upright {
    /// By the posture, and by groups of places that are equally high.
    pub(crate) fn new(
        leaning: &Leaning,
        groups: &[Vec<Vector<f64>>],
        has_upright_axis: bool,
    ) -> Self {
        let mut scatter = Matrix3::zeros();
        for group in groups {
            let count = group.len().max(1) as f64;
            let mean = group
                .iter()
                .fold(Vector::default(), |sum, place| sum + *place / count);
            for place in group {
                let way = Vector3::from((*place - mean).coordinates());
                scatter += way * way.transpose();
            }
        }
        let information = scatter / (PLANE * PLANE);
        let posture = 1.0 / (POSTURE * POSTURE);
        let lean = Vector3::from(leaning.0.coordinates());
        let mut up = lean;
        // The least sum on the unit sphere, by steps in its tangent plane.
        for _ in 0..ROUNDS {
            let across = Matrix3::identity() - up * up.transpose();
            let gradient = across * (information * up + (up - lean) * posture);
            let matrix =
                across * information * across + across * posture + up * up.transpose() * posture;
            let Some(inverse) = matrix.try_inverse() else {
                break;
            };
            up = (up - inverse * gradient).normalize();
        }
        let across = Matrix3::identity() - up * up.transpose();
        // Along the direction itself nothing is asked.
        let matrix = across * (information * across + Matrix3::identity() * posture)
            + up * up.transpose() * (information.trace() + posture);
        let deviation = matrix
            .symmetric_eigenvalues()
            .min()
            .max(f64::MIN_POSITIVE)
            .sqrt()
            .recip();
        let found = Vector::from(<[f64; 3]>::from(up));
        if has_upright_axis && let Some(axis) = nearest_axis(found, AXIS * deviation) {
            return Self {
                up: axis,
                deviation: 0.0,
                source: UpSource::Axis,
            };
        }
        Self {
            up: found,
            deviation,
            source: match deviation < KNOWN * POSTURE {
                true => UpSource::Feet,
                false => UpSource::Posture,
            },
        }
    }

    /// A direction that is given; `None` where it is none.
    pub(crate) fn given(up: [f64; 3]) -> Option<Self> {
        let up = Vector::from(up);
        let length = up.length();
        (length > 0.0 && length.is_finite()).then(|| Self {
            up: up / length,
            deviation: 0.0,
            source: UpSource::Given,
        })
    }
}

fn nearest_axis(up: Vector<f64>, within: f64) -> Option<Vector<f64>> {
    let axes = [Vector::X, Vector::Y, Vector::Z];
    let all = axes.into_iter().flat_map(|axis| [axis, -axis]);
    let best = all.max_by(|a, b| a.dot(up).total_cmp(&b.dot(up)))?;
    (best.dot(up) > within.cos()).then_some(best)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Steps along a line on a plane with a normal, left and right of it.
    fn steps(normal: Vector<f64>) -> Vec<Vector<f64>> {
        let along = Vector::X - normal * normal.dot(Vector::X);
        let along = along / along.length();
        let beside = normal.cross(along);
        let step = |k: usize| {
            let side = if k.is_multiple_of(2) { 0.1 } else { -0.1 };
            along * (0.35 * k as f64) + beside * side + normal * 0.08
        };
        (0..6).map(step).collect()
    }

    #[test]
    fn feet_say_more_than_a_person_who_leans() {
        let normal = Vector::new(0.05, 0.99, -0.12);
        let normal = normal / normal.length();
        let leaning = normal + Vector::new(0.1, 0.0, 0.05);
        let leaning = Leaning(leaning / leaning.length());
        let found = Upright::new(&leaning, &[steps(normal)], false);
        assert_eq!(found.source, UpSource::Feet);
        let angle = found.up.cross(normal).length();
        assert!(
            angle < 0.02 && angle < 4.0 * found.deviation,
            "{angle} {}",
            found.deviation
        );
        // One foot that stands says nothing.
        let alone = Upright::new(&leaning, &[vec![Vector::X]], false);
        assert_eq!(alone.source, UpSource::Posture);
        assert!(alone.up.distance(leaning.0) < 1e-9);
        assert!((alone.deviation - POSTURE).abs() < 1e-9);
    }

    #[test]
    fn an_axis_of_the_world_is_up_where_it_is_near() {
        let leaning = Leaning(Vector::new(0.05, -0.03, 0.998));
        let found = Upright::new(&leaning, &[], true);
        assert_eq!((found.up, found.source), (Vector::Z, UpSource::Axis));
        let slanted = Leaning(Vector::new(0.6, 0.0, 0.8));
        assert_eq!(Upright::new(&slanted, &[], true).source, UpSource::Posture);
        assert!(Upright::given([0.0; 3]).is_none());
        assert_eq!(Upright::given([0.0, 0.0, -2.0]).unwrap().up, -Vector::Z);
    }
}
