//! What snakes can work with.

use super::super::polygon::perimeter;
use super::{Potential, SnakeOptions};
use crate::contour::ContourError;
use ga_numerics::banded::ring::Ring;

pub(super) fn check(
    start: &[[f64; 2]],
    potential: &Potential,
    options: &SnakeOptions,
) -> Result<(), ContourError> {
    if start.len() < Ring::LEAST {
        return Err(ContourError::SnakeTooFew {
            count: start.len(),
            least: Ring::LEAST,
        });
    }
    for (setting, value, may_be_zero) in [
        ("tension", options.tension, true),
        ("rigidity", options.rigidity, true),
        ("tolerance", options.tolerance, true),
        ("greatest move", options.greatest_move, false),
    ] {
        let is_valid = value.is_finite() && (value > 0.0 || may_be_zero && value == 0.0);
        if !is_valid {
            return Err(ContourError::Setting { setting, value });
        }
    }
    if options.resampled_every == Some(0) {
        return Err(ContourError::Setting {
            setting: "number of steps between resampling",
            value: 0.0,
        });
    }
    check_inside(start, potential.size())?;
    let spacing = perimeter(start) / start.len() as f64;
    let stiffness = options.tension / spacing.powi(2) + options.rigidity / spacing.powi(4);
    if !(spacing > 0.0 && stiffness.is_finite()) {
        return Err(ContourError::NoLength { spacing });
    }
    Ok(())
}

/// That all points are in a picture of this size, which reaches half a pixel beyond the centres of
/// its outermost pixels.
pub(super) fn check_inside(points: &[[f64; 2]], size: [usize; 2]) -> Result<(), ContourError> {
    let is_inside = |point: &[f64; 2]| {
        let mut axes = point.iter().zip(size);
        axes.all(|(place, length)| (-0.5..=length as f64 - 0.5).contains(place))
    };
    match points.iter().position(|point| !is_inside(point)) {
        None => Ok(()),
        Some(index) => Err(ContourError::Outside {
            index,
            point: points[index],
            size,
        }),
    }
}
