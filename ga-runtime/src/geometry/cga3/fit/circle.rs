//! Circles in space fitted to points.

use alloc::vec;
use alloc::vec::Vec;

use super::cloud::Cloud;
use super::interface::fits;
use super::place::{Place, Step};
use super::quadric::SquareMoments;
use super::radial::Radial;
use super::shape::{Parameters, Shape};
use crate::cga3::{Circle, Point};
use crate::geometry::FitError;
use crate::scalar::Real;
use crate::vga3::Vector;

fits! {
    Circle, 6, CircleFit, Vector::from;
    /// The circle in space with the least sum of squared distances to three or more points that are
    /// not collinear: `Σ (ρᵢ − r)² + hᵢ²`, for the height h of a point above the plane of the
    /// circle and its distance ρ from the axis.
    ///
    /// The search begins with an algebraic fit, [`fit_algebraically`](Self::fit_algebraically), and
    /// continues by the method of Levenberg and Marquardt over the motor of a frame at a point of
    /// the circle, and the curvature.
    ///
    /// The normal has length 1, and its component of largest magnitude is positive.
    ///
    /// The parameters of the [covariance](crate::geometry::fit::PrimitiveFit::covariance) are the
    /// changes of the normal along the first and the second of the
    /// [axes](crate::geometry::fit::PrimitiveFit::axes), in radians, the displacements of the
    /// centre along the three axes, and the radius. The third axis is the normal.
    ///
    /// # Errors
    /// Fewer than three points, numbers that are not finite, coincident or collinear points,
    /// [`FitError::Flat`] where a line fits as well as any circle, and
    /// [`FitError::NotUnique`] where no plane fits best.
    ///
    /// ```
    /// use ga_runtime::cga3::{Circle, Point};
    /// // In the plane x = 1 about (1, 2, 3).
    /// let points = [0.0_f64, 1.0, 2.0, 3.0, 4.5]
    ///     .map(|t| Point::new(1.0, 2.0 + 0.5 * t.cos(), 3.0 + 0.5 * t.sin()));
    /// let fit = Circle::fit(&points).unwrap();
    /// assert!(fit.origin().distance(Point::new(1.0, 2.0, 3.0)) < 1e-14);
    /// assert!((fit.radius() - 0.5).abs() < 1e-14);
    /// assert!((fit.primitive.unit_normal().unwrap()[0] - 1.0).abs() < 1e-14);
    /// ```
}

impl<S: Real<Mask = bool>> Circle<S> {
    /// The circle by algebraic fits alone: in the plane of least squared distances, Taubin's fit,
    /// as in [`Sphere::fit_algebraically`](crate::cga3::Sphere::fit_algebraically).
    ///
    /// # Errors
    /// Those of [`Circle::fit`].
    pub fn fit_algebraically(points: &[Point<S>]) -> Result<Self, FitError<S>> {
        super::interface::start(points)
    }
}

impl<S: Real<Mask = bool>> Shape<S, 6> for Circle<S> {
    const COMPONENTS: usize = 2;
    const DIMENSION: usize = 2;
    const NEEDED: usize = 3;
    const IS_ROUND: bool = true;

    fn rows([x, y, z]: [S; 3], curvature: S) -> ([S; 2], [[S; 6]; 2]) {
        let (zero, one) = (S::zero(), S::one());
        let radial = Radial::new(x * x, z, curvature);
        let in_plane = [
            -radial.normal * y,
            -radial.tangential * x * y,
            radial.tilt * x,
            -radial.normal,
            zero,
            radial.curvature,
        ];
        let height = [z, x, zero, zero, -one, zero];
        ([radial.distance, y], [in_plane, height])
    }

    /// Tilts of the plane's normal, the second axis, towards the third and the first, a rotation in
    /// the plane, shifts along the third and the second axis, and a change of the curvature.
    fn step([third, first, rotation, shift, height, curvature]: [S; 6]) -> Step<S> {
        Step {
            angular: [third, rotation, -first],
            linear: [S::zero(), height, shift],
            curvature,
        }
    }

    fn starts(cloud: &Cloud<S>) -> Result<Vec<Place<S>>, FitError<S>> {
        cloud.require_gap(1)?;
        let [(_, u), (_, v), (_, normal)] = cloud.principal;
        let vectors = cloud.points.iter().map(|&(weight, place)| {
            let [x, y] = [u, v].map(|axis| axis.dot(place));
            (weight, [x.mul_add(x, y * y), x, y])
        });
        let place = SquareMoments::of(vectors, cloud.total).place([u, v], normal);
        Ok(vec![place.ok_or(FitError::NotUnique)?])
    }

    fn oriented(place: Place<S>) -> Place<S> {
        place.facing_centre().oriented(1, 2)
    }

    fn parameters(place: Place<S>) -> Parameters<S, 6> {
        let (zero, one) = (S::zero(), S::one());
        let radius = place.curvature.recip();
        let widening = -radius * radius;
        let [first, second, third] = place.axes();
        // The centre is the origin and the radius along the third axis.
        Parameters {
            origin: place.origin() + third * radius,
            axes: [third, first, second],
            rows: [
                [one, zero, zero, zero, zero, zero],
                [zero, one, zero, zero, zero, zero],
                [zero, zero, zero, one, zero, widening],
                [zero, zero, radius, zero, zero, zero],
                [-radius, zero, zero, zero, one, zero],
                [zero, zero, zero, zero, zero, widening],
            ],
            are_lengths: [false, false, true, true, true, true],
        }
    }

    fn element(origin: Vector<S>, axes: [Vector<S>; 3], radius: S) -> Option<Self> {
        Self::from_centre_normal_radius(origin.into(), axes[2].into(), radius)
    }
}
