//! What a fit returns.

use super::cloud::Cloud;
use super::loss::{Limited, loss};
use super::place::Place;
use super::refinement::Equations;
use super::shape::{Parameters, Shape};
use crate::cga3::Point;
use crate::geometry::FitError;
use crate::geometry::cga3::matrix::{Matrix, inverse_of_positive_definite};
use crate::scalar::Real;
use crate::vga3::Vector;

/// A primitive that was fitted to points, with N unknowns.
///
/// The page of the primitive's `fit` says in which N parameters its
/// [`covariance`](Self::covariance) is given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrimitiveFit<P, S, const N: usize> {
    /// The primitive.
    pub primitive: P,
    origin: Vector<S>,
    axes: [Vector<S>; 3],
    radius: S,
    pub(super) located: Located<S>,
    mean_square: S,
    variance: Option<S>,
    unit_covariance: Option<Matrix<S, N>>,
}

impl<P, S: Real<Mask = bool>, const N: usize> PrimitiveFit<P, S, N> {
    /// The centre of a sphere or circle, or the point of a plane, a line or the axis of a cylinder
    /// that is beside the centroid of the points.
    #[must_use]
    pub fn origin(&self) -> Point<S> {
        self.origin.into()
    }

    /// Right-handed orthonormal axes, along which some parameters of the covariance are measured.
    /// The third one is the normal of a plane or circle and the direction of a line or cylinder; of
    /// a sphere they are the axes of coordinates.
    #[must_use]
    pub fn axes(&self) -> [[S; 3]; 3] {
        self.axes.map(Vector::coordinates)
    }

    /// The radius; zero for planes and lines.
    #[must_use]
    pub fn radius(&self) -> S {
        self.radius
    }

    /// The root mean square of the distances of the points, `√(Σ wᵢ dᵢ² / Σ wᵢ)`.
    #[must_use]
    pub fn rms(&self) -> S {
        self.mean_square.sqrt() * self.located.unit
    }

    /// The standard deviation of the coordinates of a point of weight 1, estimated from the
    /// residuals: `√(Σ wᵢ dᵢ² / (m − N))`, where m is the number of points of weight above zero for
    /// a surface, and twice that number for a curve, since two coordinates of each point are
    /// measured there. `None` where `m ≤ N`.
    ///
    /// Of a robust fit it is that by which the covariance of an M-estimate is
    /// `(Σψ²/(m − N)) / (mean ψ′)² (JᵀJ)⁻¹` (Huber and Ronchetti, Robust Statistics, 2009, section
    /// 7.6), over the inliers.
    #[must_use]
    pub fn standard_deviation(&self) -> Option<S> {
        self.variance.map(S::sqrt)
    }

    /// The covariance of the parameters for the estimated
    /// [`standard_deviation`](Self::standard_deviation), to first order in it: its square times the
    /// inverse of the Gauss–Newton matrix `Σ wᵢ JᵢᵀJᵢ`. Lengths are in the unit of the points,
    /// angles in radians. `None` where there is no standard deviation, or the points do not
    /// determine all parameters.
    #[must_use]
    pub fn covariance(&self) -> Option<[[S; N]; N]> {
        self.scaled(self.variance?)
    }

    /// The covariance of the parameters, given the standard deviation of the coordinates of a point
    /// of weight 1. `None` where the points do not determine all parameters.
    #[must_use]
    pub fn covariance_for(&self, standard_deviation: S) -> Option<[[S; N]; N]> {
        self.scaled(standard_deviation * standard_deviation)
    }

    fn scaled(&self, variance: S) -> Option<[[S; N]; N]> {
        let matrix = self.unit_covariance?;
        finite(matrix.map(|row| row.map(|entry| entry * variance)))
    }
}

/// A place with the centroid and the unit of length in which it is given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Located<S> {
    pub(super) centroid: Vector<S>,
    pub(super) unit: S,
    pub(super) place: Place<S>,
}

impl<S: Real<Mask = bool>> Located<S> {
    pub(super) fn new(cloud: &Cloud<S>, place: Place<S>) -> Self {
        Self {
            centroid: cloud.centroid,
            unit: cloud.unit,
            place,
        }
    }

    /// The signed distance of a point from a surface, or its distance from a curve.
    pub(super) fn residual<P: Shape<S, N>, const N: usize>(&self, point: Vector<S>) -> S {
        let inside = (point - self.centroid).divided(self.unit);
        let local = Place::local(self.place.motor.reverse(), inside);
        let ([first, second], _) = P::rows(local, self.place.curvature);
        let distance = if P::COMPONENTS == 1 {
            first
        } else {
            first.hypot(second)
        };
        distance * self.unit
    }

    /// The place as seen from another centroid.
    pub(super) fn seen_from(&self, cloud: &Cloud<S>) -> Place<S> {
        self.place
            .outside(self.centroid - cloud.centroid, self.unit)
            .seen_from(Vector::default(), cloud.unit)
    }

    /// The primitive alone.
    pub(super) fn element<P: Shape<S, N>, const N: usize>(&self) -> Result<P, FitError<S>> {
        let parameters = P::parameters(P::oriented(self.place));
        let (origin, radius) = self.outside::<P, N>(&parameters)?;
        P::element(origin, parameters.axes, radius).ok_or(FitError::OutOfRange)
    }

    /// The origin of parameters and the radius, outside.
    fn outside<P: Shape<S, N>, const N: usize>(
        &self,
        parameters: &Parameters<S, N>,
    ) -> Result<(Vector<S>, S), FitError<S>> {
        // The sagitta of a primitive of less curvature is rounding, within 8√ε of the extent.
        let flat = S::epsilon().sqrt() * S::from_integer(8);
        if P::IS_ROUND && !flat.less_than(self.place.curvature.abs()) {
            return Err(FitError::Flat);
        }
        let origin = self.centroid + parameters.origin * self.unit;
        let radius = if P::IS_ROUND {
            self.unit / self.place.curvature.abs()
        } else {
            S::zero()
        };
        if !(origin.is_finite() && radius.is_finite()) {
            return Err(FitError::OutOfRange);
        }
        Ok((origin, radius))
    }
}

/// The result at a place of the least distances.
pub(super) fn fitted<P: Shape<S, N>, S: Real<Mask = bool>, const N: usize>(
    cloud: &Cloud<S>,
    place: Place<S>,
    limited: Limited<S>,
) -> Result<PrimitiveFit<P, S, N>, FitError<S>> {
    let place = P::oriented(place);
    let parameters = P::parameters(place);
    let located = Located::new(cloud, place);
    let (origin, radius) = located.outside::<P, N>(&parameters)?;
    let primitive = P::element(origin, parameters.axes, radius).ok_or(FitError::OutOfRange)?;
    let equations = Equations::<S, N>::at::<P>(&cloud.points, place, None);
    let mean_square = equations.cost / cloud.total;
    let measured = cloud.points.len() * P::COMPONENTS;
    let variance = (measured > N).then(|| {
        let freedom = S::from_integer((measured - N) as i64);
        let sum = match limited {
            None => equations.cost,
            Some(_) => spread::<P, S, N>(cloud, place, limited),
        };
        cloud.largest_weight * sum / freedom * (cloud.unit * cloud.unit)
    });
    let variance = variance.filter(|variance| variance.is_finite());
    Ok(PrimitiveFit {
        primitive,
        origin,
        axes: parameters.axes,
        radius,
        located,
        mean_square,
        variance,
        unit_covariance: unit_covariance(cloud, equations.matrix, &parameters),
    })
}

/// The covariance for the standard deviation 1.
fn unit_covariance<S: Real<Mask = bool>, const N: usize>(
    cloud: &Cloud<S>,
    matrix: Matrix<S, N>,
    parameters: &Parameters<S, N>,
) -> Option<Matrix<S, N>> {
    let of_steps = inverse_of_positive_definite(matrix)?;
    let units = parameters.are_lengths.map(|is_length| {
        if is_length {
            S::one()
        } else {
            cloud.unit.recip()
        }
    });
    let dot = |a: &[S; N], b: &[S; N]| {
        let pairs = a.iter().zip(b);
        pairs.fold(S::zero(), |sum, (&x, &y)| x.mul_add(y, sum))
    };
    let images = parameters
        .rows
        .map(|row| of_steps.map(|column| dot(&column, &row)));
    let matrix = core::array::from_fn(|i| {
        core::array::from_fn(|j| {
            let entry = dot(&parameters.rows[i], &images[j]);
            entry * (units[i] * units[j]) / cloud.largest_weight
        })
    });
    finite(matrix)
}

fn finite<S: Real<Mask = bool>, const N: usize>(matrix: Matrix<S, N>) -> Option<Matrix<S, N>> {
    let is_finite = matrix.iter().flatten().all(|entry| entry.is_finite());
    is_finite.then_some(matrix)
}

/// `Σ ψ²/(mean ψ′)²` at a place, over the components of the distances.
fn spread<P: Shape<S, N>, S: Real<Mask = bool>, const N: usize>(
    cloud: &Cloud<S>,
    place: Place<S>,
    limited: Limited<S>,
) -> S {
    let zero = S::zero();
    let to_frame = place.motor.reverse();
    let (mut squares, mut slopes) = (zero, zero);
    for &(_, point) in &cloud.points {
        let (distances, _) = P::rows(Place::local(to_frame, point), place.curvature);
        let square = distances[..P::COMPONENTS]
            .iter()
            .fold(zero, |sum, &r| r.mul_add(r, sum));
        let [_, factor, slope] = loss(limited, square);
        squares += factor * factor * square;
        // Of two components, the one across the distance has the slope ψ/r.
        slopes += if P::COMPONENTS == 1 {
            slope
        } else {
            (slope + factor) * S::from_ratio(1, 2)
        };
    }
    let mean = slopes / S::from_integer(cloud.points.len() as i64);
    squares / (mean * mean)
}
