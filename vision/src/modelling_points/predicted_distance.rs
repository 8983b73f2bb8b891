//! The paper's predicted distance of a modelling point.

use crate::disparity::DisparityMapError;

/// The quantities of eq. 2 that do not come from the views.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DistanceControls {
    /// φ, the controllable prediction position.
    pub position: f64,
    /// t, the correlation direction.
    pub direction: f64,
    /// C, the simulated fixed value.
    pub constant: f64,
}

/// The predicted distance of a modelling point (Cui, eq. 2),
///
/// ```text
/// K = φ² Q (1 − C)/(S Q + t) − S
/// ```
///
/// with the visual deviation S and the visual point spacing Q. It is a heuristic of the paper, in
/// units of S, and nothing else here depends on it; the metric depth is that of
/// [`Place`](super::Place).
///
/// ```
/// use ga_vision::modelling_points::{DistanceControls, predicted_distance};
///
/// let controls = DistanceControls { position: 3.0, direction: 2.0, constant: 0.5 };
/// assert_eq!(predicted_distance(4.0, 2.0, controls)?, 9.0 * 2.0 * 0.5 / 10.0 - 4.0);
/// # Ok::<(), ga_vision::disparity::DisparityMapError>(())
/// ```
///
/// # Errors
///
/// [`DisparityMapError::Denominator`] where S Q + t is zero, and [`DisparityMapError::NotFinite`]
/// where a number or the result is not finite.
pub fn predicted_distance(
    deviation: f64,
    spacing: f64,
    controls: DistanceControls,
) -> Result<f64, DisparityMapError> {
    let DistanceControls {
        position,
        direction,
        constant,
    } = controls;
    let denominator = deviation * spacing + direction;
    if denominator == 0.0 {
        return Err(DisparityMapError::Denominator {
            deviation,
            spacing,
            direction,
        });
    }
    let result = position * position * spacing * (1.0 - constant) / denominator - deviation;
    // A denominator that overflows would leave a finite result.
    if result.is_finite() && denominator.is_finite() {
        Ok(result)
    } else {
        Err(DisparityMapError::NotFinite([
            deviation, spacing, position, direction, constant,
        ]))
    }
}
