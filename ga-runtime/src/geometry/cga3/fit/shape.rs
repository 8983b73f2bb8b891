//! What the fits need to know of a primitive.

use alloc::vec::Vec;

use super::cloud::Cloud;
use super::place::{Place, Step};
use crate::geometry::FitError;
use crate::scalar::Real;
use crate::vga3::Vector;

/// A primitive with N unknowns that can be fitted to points.
pub(super) trait Shape<S: Real<Mask = bool>, const N: usize>: Sized {
    /// The number of components of the vector from a point to the nearest point of the primitive
    /// that are not zero by construction: 1 for surfaces, 2 for curves.
    const COMPONENTS: usize;
    /// The number of independent directions in which points must spread.
    const DIMENSION: usize;
    /// The least number of points, and the number of a random sample.
    const NEEDED: usize;
    /// Whether the primitive has a radius.
    const IS_ROUND: bool;

    /// The components of the distance of a point of the frame, and their derivatives by the
    /// unknowns of a [`step`](Self::step).
    fn rows(point: [S; 3], curvature: S) -> ([S; 2], [[S; N]; 2]);

    /// The change of place of a step.
    fn step(unknowns: [S; N]) -> Step<S>;

    /// Places from which to search for the least distances, the best first, with what is expected
    /// of them.
    fn starts(cloud: &Cloud<S>) -> Result<Vec<Place<S>>, FitError<S>>;

    /// The same place with the documented orientation.
    fn oriented(place: Place<S>) -> Place<S>;

    /// The parameters of the result as linear functions of a step.
    fn parameters(place: Place<S>) -> Parameters<S, N>;

    /// The primitive; `None` beyond the range of the scalar.
    fn element(origin: Vector<S>, axes: [Vector<S>; 3], radius: S) -> Option<Self>;
}

/// The parameters of a primitive, in which its covariance is given.
pub(super) struct Parameters<S, const N: usize> {
    /// A point: the centre, or a point of the axis or the primitive.
    pub(super) origin: Vector<S>,
    /// The axes along which the parameters are measured.
    pub(super) axes: [Vector<S>; 3],
    /// One row for each parameter, with its derivatives by the unknowns of a step.
    pub(super) rows: [[S; N]; N],
    /// Which parameters are lengths, not angles.
    pub(super) are_lengths: [bool; N],
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cga3::{Circle, Line, Plane, Sphere};
    use crate::geometry::fit::Cylinder;

    /// The derivatives of the distances by the unknowns of a step, and those of the parameters of
    /// the result, are those that differences give.
    fn check<P: Shape<f64, N>, const N: usize>(axis: Vector<f64>, curvature: f64) {
        let place = Place::new(
            Vector::new(0.3, -0.2, 0.1),
            axis,
            axis.orthonormal_pair()[0],
            curvature,
        )
        .unwrap();
        let point = Vector::new(0.7, 0.4, -0.5);
        let at = |place: Place<f64>| {
            let (distances, _) =
                P::rows(Place::local(place.motor.reverse(), point), place.curvature);
            distances
        };
        let local = Place::local(place.motor.reverse(), point);
        let (_, rows) = P::rows(local, curvature);
        let known = P::parameters(place);
        for unknown in 0..N {
            let size = 1e-6;
            let moved = |size: f64| {
                let mut step = [0.0; N];
                step[unknown] = size;
                place.moved(&P::step(step))
            };
            let (ahead, behind) = (moved(size), moved(-size));
            let pairs = at(ahead).into_iter().zip(at(behind));
            for ((x, y), row) in pairs.zip(rows).take(P::COMPONENTS) {
                let slope = (x - y) / (2.0 * size);
                assert!(
                    (slope - row[unknown]).abs() < 1e-8,
                    "by {unknown}: {slope}, not {}",
                    row[unknown]
                );
            }
            let (ahead, behind) = (P::parameters(ahead), P::parameters(behind));
            if P::IS_ROUND {
                let radius = (place.curvature + P::step(unit::<N>(unknown)).curvature * size)
                    .recip()
                    - (place.curvature - P::step(unit::<N>(unknown)).curvature * size).recip();
                assert!((radius / (2.0 * size) - known.rows[N - 1][unknown]).abs() < 1e-8);
            }
            let shift = (ahead.origin - behind.origin) / (2.0 * size);
            let tilt = (ahead.axes[2] - behind.axes[2]) / (2.0 * size);
            let mut parameter = 0;
            let tilts = known
                .are_lengths
                .iter()
                .filter(|is_length| !**is_length)
                .count();
            for axis in &known.axes[..tilts] {
                assert!((tilt.dot(*axis) - known.rows[parameter][unknown]).abs() < 1e-8);
                parameter += 1;
            }
            let lengths = N - parameter - usize::from(P::IS_ROUND);
            let along = if lengths < tilts {
                &known.axes[2..]
            } else {
                &known.axes[..lengths]
            };
            for axis in along {
                let slope = shift.dot(*axis);
                assert!(
                    (slope - known.rows[parameter][unknown]).abs() < 1e-8,
                    "parameter {parameter} by {unknown}: {slope}, not {}",
                    known.rows[parameter][unknown]
                );
                parameter += 1;
            }
        }
    }

    fn unit<const N: usize>(place: usize) -> [f64; N] {
        core::array::from_fn(|k| if k == place { 1.0 } else { 0.0 })
    }

    #[test]
    fn derivatives_are_those_of_differences() {
        let axis = Vector::new(0.48, 0.6, 0.64);
        for curvature in [0.8, 2.5, -1.2] {
            check::<Sphere<f64>, 4>(axis, curvature);
            check::<Circle<f64>, 6>(axis, curvature);
            check::<Cylinder<f64>, 5>(axis, curvature);
        }
        check::<Plane<f64>, 3>(axis, 0.0);
        check::<Line<f64>, 4>(axis, 0.0);
    }

    #[cfg(feature = "cga2")]
    #[test]
    fn derivatives_in_the_plane_are_those_of_differences() {
        let axis = Vector::new(0.0, 0.0, 1.0);
        for curvature in [0.8, 2.5, -1.2] {
            check::<crate::cga2::Circle<f64>, 3>(axis, curvature);
        }
        check::<crate::cga2::Line<f64>, 2>(axis, 0.0);
    }
}
