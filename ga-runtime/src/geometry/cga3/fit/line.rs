//! Lines fitted to points.

use alloc::vec;
use alloc::vec::Vec;

use super::cloud::Cloud;
use super::interface::fits;
use super::place::{Place, Step};
use super::shape::{Parameters, Shape};
use crate::cga3::{Line, Point};
use crate::geometry::FitError;
use crate::geometry::cga3::matrix::identity;
use crate::scalar::Real;
use crate::vga3::Vector;

fits! {
    Line, 4, LineFit, Vector::from;
    /// The line with the least sum of squared distances to two or more points: through their
    /// centroid, along the direction of their greatest variance, the eigenvector of the largest
    /// eigenvalue of their moments (Pearson, On lines and planes of closest fit to systems of
    /// points in space, 1901). One Gauss–Newton step or two restore the accuracy that the squares
    /// lose.
    ///
    /// The direction has length 1, and its component of largest magnitude is positive.
    ///
    /// The parameters of the [covariance](crate::geometry::fit::PrimitiveFit::covariance) are the
    /// changes of the direction along the first and the second of the
    /// [axes](crate::geometry::fit::PrimitiveFit::axes), in radians, and the displacements of the
    /// line along these two axes at the [origin](crate::geometry::fit::PrimitiveFit::origin), which
    /// is the centroid of the points. The third axis is the direction.
    ///
    /// # Errors
    /// Fewer than two points, numbers that are not finite, coincident points, and
    /// [`FitError::NotUnique`] where the greatest variance belongs to several directions.
    ///
    /// ```
    /// use ga_runtime::cga3::{Line, Point};
    /// let points = [0.0_f64, 1.0, 2.0, 5.0].map(|t| Point::new(1.0 + t, 2.0 - t, 3.0 * t));
    /// let fit = Line::fit(&points).unwrap();
    /// assert!(fit.primitive.distance(Point::new(-1.0, 4.0, -6.0)).unwrap() < 1e-14);
    /// assert!(fit.residual(Point::new(1.0, 2.0, 0.0)) < 1e-14);
    /// ```
}

impl<S: Real<Mask = bool>> Shape<S, 4> for Line<S> {
    const COMPONENTS: usize = 2;
    const DIMENSION: usize = 1;
    const NEEDED: usize = 2;
    const IS_ROUND: bool = false;

    fn rows([x, y, z]: [S; 3], _: S) -> ([S; 2], [[S; 4]; 2]) {
        let (zero, one) = (S::zero(), S::one());
        ([z, x], [[-y, zero, -one, zero], [zero, -y, zero, -one]])
    }

    /// Tilts of the direction, the second axis, towards the third and the first, and shifts along
    /// them.
    fn step([third, first, shift_third, shift_first]: [S; 4]) -> Step<S> {
        let zero = S::zero();
        Step {
            angular: [third, zero, -first],
            linear: [shift_first, zero, shift_third],
            curvature: zero,
        }
    }

    fn starts(cloud: &Cloud<S>) -> Result<Vec<Place<S>>, FitError<S>> {
        cloud.require_gap(0)?;
        let [(_, direction), _, (_, third)] = cloud.principal;
        let place = Place::new(Vector::default(), direction, third, S::zero());
        Ok(vec![place.ok_or(FitError::OutOfRange)?])
    }

    fn oriented(place: Place<S>) -> Place<S> {
        place.oriented(1, 2)
    }

    fn parameters(place: Place<S>) -> Parameters<S, 4> {
        let [first, second, third] = place.axes();
        Parameters {
            origin: place.origin(),
            axes: [third, first, second],
            rows: identity(),
            are_lengths: [false, false, true, true],
        }
    }

    fn element(origin: Vector<S>, axes: [Vector<S>; 3], _: S) -> Option<Self> {
        let line = Self::from_point_direction(origin.into(), axes[2].into());
        line.support().map(|_| line)
    }
}
