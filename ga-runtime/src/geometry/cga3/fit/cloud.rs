//! Weighted points relative to their centroid, and how they spread.

use alloc::vec::Vec;

use crate::geometry::FitError;
use crate::geometry::cga3::matrix::{symmetric, symmetric_eigen};
use crate::geometry::cga3::weight::checked;
use crate::scalar::Real;
use crate::vga3::Vector;

/// A point with its weight.
pub(super) type Weighted<S> = (S, Vector<S>);

/// The points of weight above zero relative to their centroid, in a unit of length in which no
/// coordinate is above 1.
pub(super) struct Cloud<S> {
    /// The weights are divided by the largest.
    pub(super) points: Vec<Weighted<S>>,
    pub(super) centroid: Vector<S>,
    pub(super) unit: S,
    pub(super) largest_weight: S,
    /// The sum of the weights of [`points`](Self::points).
    pub(super) total: S,
    /// The mean squares along the principal axes, the largest first, and the axes.
    pub(super) principal: [(S, Vector<S>); 3],
    /// The number of independent directions in which the points spread.
    dimension: usize,
}

impl<S: Real<Mask = bool>> Cloud<S> {
    /// Reads weighted points, of which a least number is needed.
    pub(super) fn of(
        points: impl ExactSizeIterator<Item = Weighted<S>>,
        needed: usize,
    ) -> Result<Self, FitError<S>> {
        let zero = S::zero();
        let mut kept = Vec::with_capacity(points.len());
        let (mut largest_weight, mut is_empty) = (zero, true);
        for (index, (weight, place)) in points.enumerate() {
            largest_weight = largest_weight.max(checked(index, weight)?);
            if !place.is_finite() {
                return Err(FitError::PointNotFinite { index });
            }
            is_empty = false;
            if zero.less_than(weight) {
                kept.push((weight, place));
            }
        }
        if !is_empty && kept.is_empty() {
            return Err(FitError::ZeroWeights);
        }
        if kept.len() < needed {
            let found = kept.len();
            return Err(FitError::TooFewPoints { found, needed });
        }
        Self::centred(kept, largest_weight)
    }

    fn centred(mut points: Vec<Weighted<S>>, largest_weight: S) -> Result<Self, FitError<S>> {
        let zero = S::zero();
        let first = points
            .first()
            .map_or(Vector::default(), |&(_, place)| place);
        let (mut total, mut sum) = (zero, Vector::default());
        let mut largest = Vector::default();
        for (weight, place) in &mut points {
            *weight = *weight / largest_weight;
            total += *weight;
            sum += (*place - first) * *weight;
            largest = largest.max(place.abs());
        }
        let centroid = first + sum.divided(total);
        let mut extent = Vector::default();
        for (_, place) in &mut points {
            *place -= centroid;
            extent = extent.max(place.abs());
        }
        let greatest = |v: Vector<S>| v.e1.max(v.e2).max(v.e3);
        let (unit, largest) = (greatest(extent), greatest(largest));
        if !unit.is_finite() {
            return Err(FitError::OutOfRange);
        }
        let rounding = largest * S::epsilon() * S::from_integer(4);
        if !rounding.less_than(unit) {
            return Err(FitError::Coincident);
        }
        let mut moments = [[zero; 3]; 3];
        for (weight, place) in &mut points {
            *place = place.divided(unit);
            let weighted = (*place * *weight).coordinates();
            for row in 0..3 {
                for column in 0..=row {
                    moments[row][column] =
                        weighted[row].mul_add(place[column], moments[row][column]);
                }
            }
        }
        let principal = symmetric_eigen(symmetric(moments))
            .map(|(square, axis)| (square / total, Vector::from(axis)));
        let dimension = dimension(&points, principal, rounding / unit);
        Ok(Self {
            points,
            centroid,
            unit,
            largest_weight,
            total,
            principal,
            dimension,
        })
    }

    /// An error where the points spread in fewer independent directions than that: within 8√ε of
    /// their extent, and the rounding of their coordinates.
    pub(super) fn require(&self, dimension: usize) -> Result<(), FitError<S>> {
        if dimension <= self.dimension {
            return Ok(());
        }
        Err(match self.dimension {
            0 => FitError::Coincident,
            1 => FitError::Collinear,
            _ => FitError::Coplanar,
        })
    }

    /// An error where the mean squares along two principal axes are equal up to rounding, so that
    /// no direction between these axes is preferred.
    pub(super) fn require_gap(&self, axis: usize) -> Result<(), FitError<S>> {
        let [(largest, _), ..] = self.principal;
        let gap = self.principal[axis].0 - self.principal[axis + 1].0;
        if !(largest * S::epsilon() * S::from_integer(16)).less_than(gap) {
            return Err(FitError::NotUnique);
        }
        Ok(())
    }
}

fn dimension<S: Real<Mask = bool>>(
    points: &[Weighted<S>],
    principal: [(S, Vector<S>); 3],
    rounding: S,
) -> usize {
    let mut extents = [S::zero(); 3];
    for &(_, place) in points {
        for (extent, (_, axis)) in extents.iter_mut().zip(principal) {
            *extent = extent.max(axis.dot(place).abs());
        }
    }
    let thin = S::epsilon().sqrt() * S::from_integer(8) * extents[0] + rounding;
    extents
        .into_iter()
        .take_while(|extent| thin.less_than(*extent))
        .count()
}
