//! Cylinders, and cylinders fitted to points.

use alloc::vec::Vec;

use super::cloud::Cloud;
use super::cylinder_axis::axes;
use super::interface::fits;
use super::place::{Place, Step};
use super::radial::Radial;
use super::shape::{Parameters, Shape};
use crate::cga3::{Line, Point};
use crate::geometry::FitError;
use crate::scalar::Real;
use crate::vga3::Vector;

/// A circular cylinder without ends: the points at one distance from a line. The conformal model
/// has no blade for it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinder<S> {
    /// The axis.
    pub axis: Line<S>,
    /// The distance of the points of the cylinder from the axis.
    pub radius: S,
}

impl<S: Real<Mask = bool>> Cylinder<S> {
    /// The distance of a point, positive outside; `None` for an axis of weight zero, or beyond the
    /// range of the scalar.
    ///
    /// ```
    /// use ga_runtime::cga3::{Line, Point};
    /// use ga_runtime::geometry::fit::Cylinder;
    /// let axis = Line::from_point_direction(Point::new(1.0, 0.0, 0.0), [0.0, 0.0, 1.0]);
    /// let cylinder = Cylinder { axis, radius: 2.0 };
    /// assert_eq!(cylinder.signed_distance(Point::new(1.0, 5.0, 9.0)), Some(3.0));
    /// ```
    #[must_use]
    pub fn signed_distance(self, point: Point<S>) -> Option<S> {
        Some(self.axis.distance(point)? - self.radius)
    }
}

fits! {
    Cylinder, 5, CylinderFit, Vector::from;
    /// The cylinder with the least sum of squared distances to six or more points that are not
    /// coplanar: `Σ (ρᵢ − r)²` for their distances ρ from the axis.
    ///
    /// The search begins with an algebraic fit, [`fit_algebraically`](Self::fit_algebraically), and
    /// continues by the method of Levenberg and Marquardt over the motor of a frame at a point of
    /// the cylinder, and the curvature; where several axes are about as good, from each of them.
    ///
    /// The direction of the axis has length 1, and its component of largest magnitude is positive.
    ///
    /// The parameters of the [covariance](crate::geometry::fit::PrimitiveFit::covariance) are the
    /// changes of the axis's direction along the first and the second of the
    /// [axes](crate::geometry::fit::PrimitiveFit::axes), in radians, the displacements of the
    /// cylinder's axis along these two at the [origin](crate::geometry::fit::PrimitiveFit::origin),
    /// which is the point of it nearest to the centroid of the points, and the radius. The third
    /// axis is the direction.
    ///
    /// # Errors
    /// Fewer than six points, since five lie on several cylinders; numbers that are not finite;
    /// coincident, collinear or coplanar points, and [`FitError::Flat`] where a plane fits
    /// as well as any cylinder.
    ///
    /// ```
    /// use ga_runtime::cga3::Point;
    /// use ga_runtime::geometry::fit::Cylinder;
    /// // About the vertical line through (1, 2, 0).
    /// let points: Vec<_> = (0..12)
    ///     .map(f64::from)
    ///     .map(|t| Point::new(1.0 + 0.5 * t.cos(), 2.0 + 0.5 * t.sin(), 0.1 * t * t))
    ///     .collect();
    /// let fit = Cylinder::fit(&points).unwrap();
    /// assert!((fit.primitive.radius - 0.5).abs() < 1e-13);
    /// let axis = fit.primitive.axis;
    /// assert!(axis.distance(Point::new(1.0, 2.0, 7.0)).unwrap() < 1e-12);
    /// ```
}

impl<S: Real<Mask = bool>> Cylinder<S> {
    /// The cylinder by algebraic fits alone. For any direction of the axis, Taubin's fit of a
    /// circle to the points seen along it follows from their moments up to the fourth order, which
    /// are summed once (Eberly, Fitting 3D data with a cylinder, 2003, has the fit of Kåsa in its
    /// place); of some hundred directions the best ones are improved by small steps. The direction
    /// is accurate to about a thousandth.
    ///
    /// # Errors
    /// Those of [`Cylinder::fit`].
    pub fn fit_algebraically(points: &[Point<S>]) -> Result<Self, FitError<S>> {
        super::interface::start(points)
    }
}

impl<S: Real<Mask = bool>> Shape<S, 5> for Cylinder<S> {
    const COMPONENTS: usize = 1;
    const DIMENSION: usize = 3;
    const NEEDED: usize = 6;
    const IS_ROUND: bool = true;

    fn rows([x, y, z]: [S; 3], curvature: S) -> ([S; 2], [[S; 5]; 2]) {
        let zero = S::zero();
        let radial = Radial::new(x * x, z, curvature);
        let row = [
            -radial.normal * y,
            -radial.tangential * x * y,
            radial.tilt * x,
            -radial.normal,
            radial.curvature,
        ];
        ([radial.distance, zero], [row, [zero; 5]])
    }

    /// Tilts of the cylinder's axis, the second one, towards the third and the first, a rotation
    /// about it, a shift along the third and a change of the curvature.
    fn step([third, first, rotation, shift, curvature]: [S; 5]) -> Step<S> {
        let zero = S::zero();
        Step {
            angular: [third, rotation, -first],
            linear: [zero, zero, shift],
            curvature,
        }
    }

    fn starts(cloud: &Cloud<S>) -> Result<Vec<Place<S>>, FitError<S>> {
        let found = axes(cloud);
        if found.is_empty() {
            return Err(FitError::NotUnique);
        }
        Ok(found)
    }

    fn oriented(place: Place<S>) -> Place<S> {
        let place = place.facing_centre().oriented(1, 2);
        let zero = S::zero();
        let along = place.origin().dot(place.axes()[1]);
        place.moved(&Step {
            angular: [zero; 3],
            linear: [zero, -along, zero],
            curvature: zero,
        })
    }

    fn parameters(place: Place<S>) -> Parameters<S, 5> {
        let (zero, one) = (S::zero(), S::one());
        let radius = place.curvature.recip();
        let widening = -radius * radius;
        let [first, second, third] = place.axes();
        // The axis passes through the end of the radius along the third axis of the frame.
        Parameters {
            origin: place.origin() + third * radius,
            axes: [third, first, second],
            rows: [
                [one, zero, zero, zero, zero],
                [zero, one, zero, zero, zero],
                [zero, zero, zero, one, widening],
                [zero, zero, radius, zero, zero],
                [zero, zero, zero, zero, widening],
            ],
            are_lengths: [false, false, true, true, true],
        }
    }

    fn element(origin: Vector<S>, axes: [Vector<S>; 3], radius: S) -> Option<Self> {
        let axis = Line::from_point_direction(origin.into(), axes[2].into());
        axis.support().map(|_| Self { axis, radius })
    }
}
