//! What a snake cannot work with.

use ga_image::filter::SigmaError;

use super::super::polygon::perimeter;
use super::{Potential, SnakeOptions};
use ga_numerics::banded::ring::Ring;

/// Why a snake does not move.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SnakeError {
    /// There are too few points.
    #[error("{count} points are too few for a snake; at least {least} are needed")]
    TooFew {
        /// The number of points.
        count: usize,
        /// The least number.
        least: usize,
    },
    /// All points are at one place, or so near each other that the tension or the rigidity by the
    /// power of their distance is infinite.
    #[error("the points of a snake are {spacing} pixels apart on average")]
    NoLength {
        /// The mean distance of neighbouring points in pixels.
        spacing: f64,
    },
    /// A point is not in the picture.
    #[error(
        "point {index} of the contour, at ({}, {}), is outside the picture of {} × {} pixels",
        point[0], point[1], size[0], size[1]
    )]
    Outside {
        /// The point, counted from 0.
        index: usize,
        /// Where it is.
        point: [f64; 2],
        /// Columns and rows of the picture.
        size: [usize; 2],
    },
    /// A setting is not a number that it can be.
    #[error("the {setting} of a snake cannot be {value}")]
    Setting {
        /// The setting.
        setting: &'static str,
        /// Its value.
        value: f64,
    },
    /// The energy or its slope is infinite or not a number.
    #[error(
        "the energy of the snake is beyond the range of numbers: the tension of {tension}, the \
         rigidity of {rigidity} or the potential is too great"
    )]
    EnergyNotFinite {
        /// α.
        tension: f64,
        /// β.
        rigidity: f64,
    },
    /// The picture is too small for slopes.
    #[error("a picture of {width} × {height} pixels is too small for a snake")]
    TooSmall {
        /// Columns.
        width: usize,
        /// Rows.
        height: usize,
    },
    /// A pixel is infinite or not a number.
    #[error("the pixel in column {column} and row {row} is not finite")]
    NotFinite {
        /// The column.
        column: usize,
        /// The row.
        row: usize,
    },
    /// The equations of a flow were not solved.
    #[error("the flow of the edges was not found in {steps} steps: a part of {residual} is left")]
    FlowNotConverged {
        /// How many steps were taken.
        steps: usize,
        /// The residual by the right-hand side.
        residual: f64,
    },
    /// The picture cannot be blurred so.
    #[error(transparent)]
    Sigma(#[from] SigmaError),
}

pub(super) fn check(
    start: &[[f64; 2]],
    potential: &Potential,
    options: &SnakeOptions,
) -> Result<(), SnakeError> {
    if start.len() < Ring::LEAST {
        return Err(SnakeError::TooFew {
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
            return Err(SnakeError::Setting { setting, value });
        }
    }
    if options.resampled_every == Some(0) {
        return Err(SnakeError::Setting {
            setting: "number of steps between resampling",
            value: 0.0,
        });
    }
    check_inside(start, potential.size())?;
    let spacing = perimeter(start) / start.len() as f64;
    let stiffness = options.tension / spacing.powi(2) + options.rigidity / spacing.powi(4);
    if !(spacing > 0.0 && stiffness.is_finite()) {
        return Err(SnakeError::NoLength { spacing });
    }
    Ok(())
}

/// That all points are in a picture of this size, which reaches half a pixel beyond the centres of
/// its outermost pixels.
pub(super) fn check_inside(points: &[[f64; 2]], size: [usize; 2]) -> Result<(), SnakeError> {
    let is_inside = |point: &[f64; 2]| {
        let mut axes = point.iter().zip(size);
        axes.all(|(place, length)| (-0.5..=length as f64 - 0.5).contains(place))
    };
    match points.iter().position(|point| !is_inside(point)) {
        None => Ok(()),
        Some(index) => Err(SnakeError::Outside {
            index,
            point: points[index],
            size,
        }),
    }
}
