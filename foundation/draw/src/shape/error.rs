//! Why elements cannot be drawn.

/// The reason why an element cannot be drawn.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NotDrawable {
    /// All coefficients are zero.
    #[error("all its coefficients are zero")]
    Zero,
    /// A coefficient, or a coordinate computed from the coefficients, is not finite.
    #[error("one of its numbers is {0}, which is not finite")]
    NotFinite(f64),
    /// The absolute value of a coordinate or a length is larger than 1e100.
    #[error("one of its coordinates or lengths is {0:e}, which is beyond the limit of 1e100")]
    TooLarge(f64),
    /// Its weight is zero: it is at infinity, or a direction without a place.
    #[error("its weight is zero: it is at infinity and has no place")]
    NoWeight,
    /// It is neither a blade, which is an outer product of vectors, nor a motor.
    #[error("it is neither a blade nor a motor")]
    NeitherBladeNorMotor,
    /// The trajectory has no points.
    #[error("the trajectory has no points")]
    EmptyTrajectory,
}
