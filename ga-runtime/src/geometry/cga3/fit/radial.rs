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
    /// The distance of the point `q = t + z n`, with the square `t²` of its tangential part, from
    /// the round of curvature κ that touches the tangent plane at the origin.
    ///
    /// The distance is `ρ − 1/κ` for the distance `ρ = |q − n/κ|` from the centre. With
    /// `w = κρ = √(κ²t² + (κz − 1)²)` it is `(κq² − 2z)/(1 + w)`, which also holds for κ = 0, where
    /// it is −z (Chernov, Circular and Linear Regression, 2010, section 3.2).
    #[inline]
    pub(super) fn new(tangential_square: S, z: S, curvature: S) -> Self {
        let square = z.mul_add(z, tangential_square);
        let power = curvature * square - z - z;
        let slope = curvature * z - S::one();
        let w = (curvature * curvature)
            .mul_add(tangential_square, slope * slope)
            .sqrt();
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
            normal: slope * inverse,
            tilt: -inverse,
            curvature: z.mul_add(distance, square) * inverse / (S::one() + w),
        }
    }
}
