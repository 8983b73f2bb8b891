//! Spheres fitted to points.

use alloc::vec;
use alloc::vec::Vec;

use super::cloud::Cloud;
use super::interface::fits;
use super::place::{Place, Step};
use super::quadric::SquareMoments;
use super::radial::Radial;
use super::shape::{Parameters, Shape};
use crate::cga3::{Point, Sphere};
use crate::geometry::FitError;
use crate::scalar::Real;
use crate::vga3::Vector;

fits! {
    Sphere, 4, SphereFit, Vector::from;
    /// The sphere with the least sum of squared distances to four or more points that are not
    /// coplanar, `Σ (|xᵢ − c| − r)²`.
    ///
    /// The search begins with an algebraic fit, [`fit_algebraically`](Self::fit_algebraically), and
    /// continues by the method of Levenberg and Marquardt over the tangent plane and the curvature
    /// at a point of the sphere, which stay finite where the radius does not.
    ///
    /// The parameters of the [covariance](crate::geometry::fit::PrimitiveFit::covariance) are the
    /// coordinates x, y, z of the centre, and the radius.
    ///
    /// # Errors
    /// Fewer than four points, numbers that are not finite, coincident, collinear or coplanar
    /// points, and [`FitError::Flat`] where a plane fits as well as any sphere.
    ///
    /// ```
    /// use ga_runtime::cga3::{Point, Sphere};
    /// use ga_runtime::geometry::FitError;
    /// let points = [[4.0_f64, 2.0, 3.0], [1.0, 5.0, 3.0], [1.0, 2.0, 6.0], [-2.0, 2.0, 3.0]];
    /// let points = points.map(Point::from);
    /// let fit = Sphere::fit(&points).unwrap();
    /// assert!(fit.origin().distance(Point::new(1.0, 2.0, 3.0)) < 1e-14);
    /// assert!((fit.radius() - 3.0).abs() < 1e-14 && fit.rms() < 1e-14);
    /// // A signed distance, positive outside.
    /// assert!((fit.residual(Point::new(1.0, 2.0, 8.0)) - 2.0).abs() < 1e-14);
    /// let flat = points.map(|p| Point::new(p.x(), p.y(), 0.0));
    /// assert_eq!(Sphere::fit(&flat).unwrap_err(), FitError::Coplanar);
    /// ```
}

impl<S: Real<Mask = bool>> Sphere<S> {
    /// The sphere by Taubin's algebraic fit alone, which makes the sum of squares of
    /// `A x² + B·x + C` least relative to that of its gradient, in a closed form. It is exact for
    /// points on a sphere, and close to the least distances where their errors are small against
    /// the radius. See [`Sphere::fit`].
    ///
    /// # Errors
    /// Those of [`Sphere::fit`].
    pub fn fit_algebraically(points: &[Point<S>]) -> Result<Self, FitError<S>> {
        super::interface::start(points)
    }
}

impl<S: Real<Mask = bool>> Shape<S, 4> for Sphere<S> {
    const COMPONENTS: usize = 1;
    const DIMENSION: usize = 3;
    const NEEDED: usize = 4;
    const IS_ROUND: bool = true;

    fn rows([x, y, z]: [S; 3], curvature: S) -> ([S; 2], [[S; 4]; 2]) {
        let radial = Radial::new(x.mul_add(x, y * y), z, curvature);
        let row = [
            radial.tilt * x,
            radial.tilt * y,
            -radial.normal,
            radial.curvature,
        ];
        ([radial.distance, S::zero()], [row, [S::zero(); 4]])
    }

    /// Tilts of the normal towards the first and the second axis, a shift along it, and a change of
    /// the curvature.
    fn step([first, second, shift, curvature]: [S; 4]) -> Step<S> {
        let zero = S::zero();
        Step {
            angular: [-second, first, zero],
            linear: [zero, zero, shift],
            curvature,
        }
    }

    fn starts(cloud: &Cloud<S>) -> Result<Vec<Place<S>>, FitError<S>> {
        let vectors = cloud.points.iter().map(|&(weight, place)| {
            let [x, y, z] = place.coordinates();
            (weight, [place.length_squared(), x, y, z])
        });
        let ([a, x, y, z], c, _) = SquareMoments::of(vectors, cloud.total).round();
        let place = Place::of_round([a, c], Vector::new(x, y, z), None);
        Ok(vec![place.ok_or(FitError::NotUnique)?])
    }

    fn oriented(place: Place<S>) -> Place<S> {
        place.facing_centre()
    }

    fn parameters(place: Place<S>) -> Parameters<S, 4> {
        let (zero, one) = (S::zero(), S::one());
        let radius = place.curvature.recip();
        let widening = -radius * radius;
        let axes = place.axes();
        // The centre is the origin and the radius along the normal.
        let coordinate = |k: usize| {
            [
                axes[0][k] * radius,
                axes[1][k] * radius,
                axes[2][k],
                axes[2][k] * widening,
            ]
        };
        let unit = |k: usize| Vector::from([0, 1, 2].map(|i| if i == k { one } else { zero }));
        Parameters {
            origin: place.origin() + axes[2] * radius,
            axes: [0, 1, 2].map(unit),
            rows: [
                coordinate(0),
                coordinate(1),
                coordinate(2),
                [zero, zero, zero, widening],
            ],
            are_lengths: [true; 4],
        }
    }

    fn element(origin: Vector<S>, _: [Vector<S>; 3], radius: S) -> Option<Self> {
        let sphere = Self::from_centre_radius(origin.into(), radius);
        sphere.centre().zip(sphere.radius_squared()).map(|_| sphere)
    }
}
