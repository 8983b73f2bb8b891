//! Lines of the plane fitted to points.

use alloc::vec;
use alloc::vec::Vec;

use super::cloud::Cloud;
use super::interface::fits;
use super::place::{Place, Step};
use super::planar_circle::in_space;
use super::shape::{Parameters, Shape};
use crate::cga2::{Line, Point};
use crate::geometry::FitError;
use crate::geometry::cga3::matrix::identity;
use crate::scalar::Real;
use crate::vga3::Vector;

fits! {
    Line, 2, PlanarLineFit, in_space;
    /// The line of the plane with the least sum of squared distances to two or more points; see
    /// [`Line::fit`](crate::cga3::Line::fit).
    ///
    /// The direction has length 1, and its component of largest magnitude is positive.
    ///
    /// The parameters of the [covariance](crate::geometry::fit::PrimitiveFit::covariance) are the
    /// angle of the direction in radians, counterclockwise, and the displacement of the line to the
    /// left of it at the [origin](crate::geometry::fit::PrimitiveFit::origin), the centroid of the
    /// points. As a point of space that has the third coordinate 0.
    ///
    /// # Errors
    /// Fewer than two points, numbers that are not finite, coincident points, and
    /// [`FitError::NotUnique`] where the points spread equally in all directions.
    ///
    /// ```
    /// use ga_runtime::cga2::{Line, Point};
    /// let points = [[0.0_f64, 1.0], [2.0, 2.0], [4.0, 3.0]].map(Point::from);
    /// let fit = Line::fit(&points).unwrap();
    /// assert!(fit.primitive.signed_distance(Point::new(6.0, 4.0)).unwrap().abs() < 1e-14);
    /// // Positive to the left of the direction.
    /// assert!(fit.primitive.direction()[0] > 0.0 && fit.residual(Point::new(0.0, 9.0)) > 0.0);
    /// ```
}

impl<S: Real<Mask = bool>> Shape<S, 2> for Line<S> {
    const COMPONENTS: usize = 1;
    const DIMENSION: usize = 1;
    const NEEDED: usize = 2;
    const IS_ROUND: bool = false;

    fn rows([x, _, z]: [S; 3], _: S) -> ([S; 2], [[S; 2]; 2]) {
        let (zero, one) = (S::zero(), S::one());
        ([-z, zero], [[-x, -one], [zero; 2]])
    }

    /// A rotation of the direction, the first axis, and a shift against the third, to the left.
    fn step([rotation, shift]: [S; 2]) -> Step<S> {
        let zero = S::zero();
        Step {
            angular: [zero, rotation, zero],
            linear: [zero, zero, -shift],
            curvature: zero,
        }
    }

    fn starts(cloud: &Cloud<S>) -> Result<Vec<Place<S>>, FitError<S>> {
        cloud.require_gap(0)?;
        let [(_, direction), ..] = cloud.principal;
        let upwards = Vector::new(S::zero(), S::zero(), S::one());
        let right = direction.cross(upwards);
        let place = Place::new(Vector::default(), upwards, right, S::zero());
        Ok(vec![place.ok_or(FitError::OutOfRange)?])
    }

    fn oriented(place: Place<S>) -> Place<S> {
        place.oriented(0, 1)
    }

    fn parameters(place: Place<S>) -> Parameters<S, 2> {
        let [first, second, third] = place.axes();
        let origin = place.origin();
        Parameters {
            origin: Vector::new(origin.e1, origin.e2, S::zero()),
            axes: [-third, second, first],
            rows: identity(),
            are_lengths: [false, true],
        }
    }

    fn element(origin: Vector<S>, [_, _, direction]: [Vector<S>; 3], _: S) -> Option<Self> {
        let point = Point::new(origin.e1, origin.e2);
        let line = Self::from_point_direction(point, [direction.e1, direction.e2]);
        line.moment().is_finite().then_some(line)
    }
}
