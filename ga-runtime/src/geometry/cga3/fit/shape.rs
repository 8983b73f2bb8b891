//! What the fits need to know of a primitive.

use alloc::vec::Vec;

use super::cloud::Cloud;
use super::error::PrimitiveFitError;
use super::place::{Place, Step};
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

    /// The components of the distance of a point of the frame, and their derivatives by the unknowns
    /// of a [`step`](Self::step).
    fn rows(point: [S; 3], curvature: S) -> ([S; 2], [[S; N]; 2]);

    /// The change of place of a step.
    fn step(unknowns: [S; N]) -> Step<S>;

    /// Places from which to search for the least distances, the best first, with what is expected of
    /// them.
    fn starts(cloud: &Cloud<S>) -> Result<Vec<Place<S>>, PrimitiveFitError<S>>;

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
