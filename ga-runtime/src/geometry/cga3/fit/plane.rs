//! Planes fitted to points.

use alloc::vec;
use alloc::vec::Vec;

use super::cloud::Cloud;
use super::interface::fits;
use super::place::{Place, Step};
use super::shape::{Parameters, Shape};
use crate::cga3::{Plane, Point};
use crate::geometry::FitError;
use crate::geometry::cga3::matrix::identity;
use crate::scalar::Real;
use crate::vga3::Vector;

fits! {
    Plane, 3, PlaneFit, Vector::from;
    /// The plane with the least sum of squared distances to three or more points that are not
    /// collinear: through their centroid, perpendicular to the direction of their least variance,
    /// the eigenvector of the smallest eigenvalue of their moments (Pearson, On lines and planes of
    /// closest fit to systems of points in space, 1901). One Gauss–Newton step or two restore the
    /// accuracy that the squares lose.
    ///
    /// The normal has length 1, and its component of largest magnitude is positive.
    ///
    /// The parameters of the [covariance](crate::geometry::fit::PrimitiveFit::covariance) are the
    /// changes of the normal n along the first and the second of the
    /// [axes](crate::geometry::fit::PrimitiveFit::axes), in radians, and the change of the distance
    /// along n of the plane at the [origin](crate::geometry::fit::PrimitiveFit::origin), which is
    /// the centroid of the points. The third axis is n.
    ///
    /// # Errors
    /// Fewer than three points, numbers that are not finite, coincident or collinear points, and
    /// [`FitError::NotUnique`] where the least variance belongs to several directions.
    ///
    /// ```
    /// use ga_runtime::cga3::{Plane, Point};
    /// let points = [[0.0_f64, 0.0, 1.0], [4.0, 0.0, 1.2], [4.0, 4.0, 1.0], [0.0, 4.0, 1.2]];
    /// let fit = Plane::fit(&points.map(Point::from)).unwrap();
    /// let plane = fit.primitive;
    /// assert!((plane.signed_distance(Point::new(9.0, 9.0, 3.1)).unwrap() - 2.0).abs() < 1e-14);
    /// assert!((fit.rms() - 0.1).abs() < 1e-14);
    /// // Four points and three unknowns leave one degree of freedom.
    /// assert!((fit.standard_deviation().unwrap() - 0.2).abs() < 1e-14);
    /// // The height at the centroid has a quarter of the variance of one point.
    /// assert!((fit.covariance().unwrap()[2][2] - 0.01).abs() < 1e-14);
    /// ```
}

impl<S: Real<Mask = bool>> Shape<S, 3> for Plane<S> {
    const COMPONENTS: usize = 1;
    const DIMENSION: usize = 2;
    const NEEDED: usize = 3;
    const IS_ROUND: bool = false;

    fn rows([x, y, z]: [S; 3], _: S) -> ([S; 2], [[S; 3]; 2]) {
        let zero = S::zero();
        ([z, zero], [[x, y, -S::one()], [zero; 3]])
    }

    /// Tilts of the normal towards the first and the second axis, and a shift along it.
    fn step([first, second, shift]: [S; 3]) -> Step<S> {
        let zero = S::zero();
        Step {
            angular: [-second, first, zero],
            linear: [zero, zero, shift],
            curvature: zero,
        }
    }

    fn starts(cloud: &Cloud<S>) -> Result<Vec<Place<S>>, FitError<S>> {
        cloud.require_gap(1)?;
        let [_, (_, second), (_, normal)] = cloud.principal;
        let place = Place::new(Vector::default(), second, normal, S::zero());
        Ok(vec![place.ok_or(FitError::OutOfRange)?])
    }

    fn oriented(place: Place<S>) -> Place<S> {
        place.oriented(2, 0)
    }

    fn parameters(place: Place<S>) -> Parameters<S, 3> {
        Parameters {
            origin: place.origin(),
            axes: place.axes(),
            rows: identity(),
            are_lengths: [false, false, true],
        }
    }

    fn element(origin: Vector<S>, axes: [Vector<S>; 3], _: S) -> Option<Self> {
        let plane = Self::from_point_normal(origin.into(), axes[2].into());
        plane.support().map(|_| plane)
    }
}
