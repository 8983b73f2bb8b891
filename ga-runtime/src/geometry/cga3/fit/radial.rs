//! Distances from a round that is seen from a point of it.

use crate::scalar::Real;

/// The signed distance of a point from a sphere or a circle, positive on the outside of a positive
/// curvature, with its derivatives.
pub(super) struct Radial<S> {
    pub(super) distance: S,
    /// By the coordinates of the point: `(along, across)` the normal at the origin. Those along
    /// tangents are `tangential` times the coordinate.
    pub(super) tangential: S,
    /// By the third coordinate of the point.
    pub(super) normal: S,
    /// By a rotation of the round about the origin, per unit of the tangential coordinate towards
    /// which the normal moves.
    pub(super) tilt: S,
    /// By the curvature.
    pub(super) curvature: S,
}

impl<S: Real<Mask = bool>> Radial<S> {
    /// The distance of the point q with the square `q²` and the height z over the tangent plane
    /// from the round of curvature κ that touches it at the origin.
    ///
    /// The distance is `ρ − 1/κ` for the distance `ρ = |q − n/κ|` from the centre. With
    /// `w = κρ = √(1 + κ(κq² − 2z))` it is `(κq² − 2z)/(1 + w)`, which also holds for κ = 0, where
    /// it is −z (Chernov, Circular and Linear Regression, 2010, section 3.2).
    #[inline]
    pub(super) fn new(square: S, z: S, curvature: S) -> Self {
        let power = curvature * square - z - z;
        let w = curvature.mul_add(power, S::one()).max(S::zero()).sqrt();
        let distance = power / (S::one() + w);
        // At the centre the distance has no slope.
        let inverse = if S::epsilon().less_than(w) {
            w.recip()
        } else {
            S::zero()
        };
        Self {
            distance,
            tangential: curvature * inverse,
            normal: (curvature * z - S::one()) * inverse,
            tilt: -inverse,
            curvature: z.mul_add(distance, square) * inverse / (S::one() + w),
        }
    }
}
