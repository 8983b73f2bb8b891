//! Circles of the plane fitted to points.

use alloc::vec;
use alloc::vec::Vec;

use super::cloud::Cloud;
use super::interface::fits;
use super::place::{Place, Step};
use super::quadric::SquareMoments;
use super::radial::Radial;
use super::shape::{Parameters, Shape};
use crate::cga2::{Circle, Point};
use crate::geometry::FitError;
use crate::scalar::Real;
use crate::vga3::Vector;

fits! {
    Circle, 3, PlanarCircleFit, in_space;
    /// The circle of the plane with the least sum of squared distances to three or more points that
    /// are not collinear, `Σ (|xᵢ − c| − r)²`; see
    /// [`Sphere::fit`](crate::cga3::Sphere::fit).
    ///
    /// The parameters of the [covariance](crate::geometry::fit::PrimitiveFit::covariance) are the
    /// coordinates x and y of the centre, and the radius. As a point of space the
    /// [origin](crate::geometry::fit::PrimitiveFit::origin) has the third coordinate 0.
    ///
    /// # Errors
    /// Fewer than three points, numbers that are not finite, coincident or collinear points, and
    /// [`FitError::Flat`] where a line fits as well as any circle.
    ///
    /// ```
    /// use ga_runtime::cga2::{Circle, Point};
    /// let points = [[3.0_f64, 0.0], [0.0, 1.0], [-3.0, 0.0]].map(Point::from);
    /// let fit = Circle::fit(&points).unwrap();
    /// assert!((fit.primitive.radius().unwrap() - 5.0).abs() < 1e-14);
    /// ```
}

impl<S: Real<Mask = bool>> Shape<S, 3> for Circle<S> {
    const COMPONENTS: usize = 1;
    const DIMENSION: usize = 2;
    const NEEDED: usize = 3;
    const IS_ROUND: bool = true;

    fn rows([x, _, z]: [S; 3], curvature: S) -> ([S; 2], [[S; 3]; 2]) {
        let zero = S::zero();
        let radial = Radial::new(x * x, z, curvature);
        let row = [radial.tilt * x, -radial.normal, radial.curvature];
        ([radial.distance, zero], [row, [zero; 3]])
    }

    /// A tilt of the normal towards the first axis, a shift along it, and a change of the
    /// curvature.
    fn step([tilt, shift, curvature]: [S; 3]) -> Step<S> {
        let zero = S::zero();
        Step {
            angular: [zero, tilt, zero],
            linear: [zero, zero, shift],
            curvature,
        }
    }

    fn starts(cloud: &Cloud<S>) -> Result<Vec<Place<S>>, FitError<S>> {
        let (zero, one) = (S::zero(), S::one());
        let vectors = cloud.points.iter().map(|&(weight, place)| {
            let [x, y, _] = place.coordinates();
            (weight, [x.mul_add(x, y * y), x, y])
        });
        let axes = [Vector::new(one, zero, zero), Vector::new(zero, one, zero)];
        let moments = SquareMoments::of(vectors, cloud.total);
        let place = moments.place(axes, Vector::new(zero, zero, one));
        Ok(vec![place.ok_or(FitError::NotUnique)?])
    }

    fn oriented(place: Place<S>) -> Place<S> {
        place.facing_centre()
    }

    fn parameters(place: Place<S>) -> Parameters<S, 3> {
        let (zero, one) = (S::zero(), S::one());
        let radius = place.curvature.recip();
        let widening = -radius * radius;
        let [first, _, third] = place.axes();
        let origin = place.origin() + third * radius;
        let coordinate = |k: usize| [first[k] * radius, third[k], third[k] * widening];
        let unit = |k: usize| Vector::from([0, 1, 2].map(|i| if i == k { one } else { zero }));
        Parameters {
            origin: Vector::new(origin.e1, origin.e2, zero),
            axes: [0, 1, 2].map(unit),
            rows: [coordinate(0), coordinate(1), [zero, zero, widening]],
            are_lengths: [true; 3],
        }
    }

    fn element(origin: Vector<S>, _: [Vector<S>; 3], radius: S) -> Option<Self> {
        let circle = Self::from_centre_radius(Point::new(origin.e1, origin.e2), radius);
        circle.centre().zip(circle.radius_squared()).map(|_| circle)
    }
}

/// A point of the plane as a vector of space.
pub(super) fn in_space<S: Real>(point: Point<S>) -> Vector<S> {
    let [x, y] = point.coordinates();
    Vector::new(x, y, S::zero())
}
