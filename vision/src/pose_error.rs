//! The distance of reconstructed joints from the true ones.

use ga_runtime::cga3::Point;

/// Why two poses cannot be compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ComparisonError {
    /// The poses have different numbers of joints.
    #[error("{found} joints were reconstructed, but there are {expected} true ones")]
    Counts {
        /// How many there should be.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// There are no joints.
    #[error("poses without joints have no mean error")]
    Empty,
}

/// The mean distance between reconstructed and true joints, in the unit of the coordinates (mean
/// per joint position error, MPJPE; Cui, table 3).
///
/// # Errors
/// [`ComparisonError`] where there are no joints, or different numbers of them.
///
/// ```
/// use ga_runtime::cga3::Point;
/// use ga_vision::pose_error::mean_per_joint_position_error;
/// let truth = [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Point::from);
/// let found = [[0.0, 0.0, 0.5], [0.0, 1.0, 0.0]].map(Point::from);
/// assert_eq!(mean_per_joint_position_error(&truth, &found), Ok(0.25));
/// ```
pub fn mean_per_joint_position_error(
    truth: &[Point<f64>],
    found: &[Point<f64>],
) -> Result<f64, ComparisonError> {
    if truth.len() != found.len() {
        return Err(ComparisonError::Counts {
            expected: truth.len(),
            found: found.len(),
        });
    }
    if truth.is_empty() {
        return Err(ComparisonError::Empty);
    }
    let total: f64 = truth.iter().zip(found).map(|(a, b)| a.distance(*b)).sum();
    Ok(total / truth.len() as f64)
}
