//! Whether the depth of a frame continues that of the frame before.

use super::FrameMeasures;
use super::stereoscopy::IDENTICAL;

/// Columns and rows of the cells in which parallaxes are averaged.
const CELLS: [usize; 2] = [16, 9];

/// A parallax of at least this part of the width, and of at least this number of pixels, is
/// clearly not zero.
const LEAST: f64 = 0.001;
const LEAST_PX: f64 = 0.5;

/// The least number of cells that tell.
const LEAST_CELLS: usize = 8;

/// The least part of them that must agree.
const AGREEING: f64 = 0.8;

/// What a frame shows of depth.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) enum Depth {
    /// Too few points are found in both views.
    #[default]
    Unmatched,
    /// All points have the same place in both views.
    Identical,
    /// There is hardly any depth, or it is seen in few places.
    Weak,
    /// Parallaxes in parts of the width, by the cells of a grid; NaN in those where none is clearly
    /// different from zero.
    Clear(Vec<f32>),
}

/// How the depth of a frame follows that of the one before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Continuity {
    /// It is about the same.
    Same,
    /// It is about the opposite.
    Exchanged,
    /// Neither.
    Unclear,
}

impl Depth {
    /// What the measures of a frame of this size show.
    pub(super) fn of(measures: &FrameMeasures, size: [usize; 2]) -> Self {
        let Some(parallax) = &measures.parallax else {
            return Self::Unmatched;
        };
        let [width, height] = size.map(|side| side as f64);
        let identical = IDENTICAL * width;
        if parallax.near_px.abs() < identical && parallax.far_px.abs() < identical {
            return Self::Identical;
        }
        let mut cells = vec![(0.0, 0.0); CELLS[0] * CELLS[1]];
        for found in &measures.matches {
            // The middle between both places stays where it is when the views are exchanged.
            let place = [0, 1].map(|axis| {
                let middle = 0.5 * (found.left[axis] + found.right[axis]) + 0.5;
                let part = (middle / [width, height][axis]).clamp(0.0, 1.0);
                ((part * CELLS[axis] as f64) as usize).min(CELLS[axis] - 1)
            });
            let cell = &mut cells[place[1] * CELLS[0] + place[0]];
            cell.0 += found.right[0] - found.left[0];
            cell.1 += 1.0;
        }
        let least = (LEAST * width).max(LEAST_PX);
        let mean = |(sum, count): (f64, f64)| {
            let mean = sum / count;
            match mean.abs() >= least {
                true => (mean / width) as f32,
                // Zero, or no match at all.
                false => f32::NAN,
            }
        };
        let cells: Vec<f32> = cells.into_iter().map(mean).collect();
        match cells.iter().filter(|cell| !cell.is_nan()).count() >= LEAST_CELLS {
            true => Self::Clear(cells),
            false => Self::Weak,
        }
    }

    /// Whether an exchange of the views would show.
    pub(super) fn is_clear(&self) -> bool {
        matches!(self, Self::Clear(_))
    }

    /// How the depth of the next frame follows this one.
    pub(super) fn continuity(&self, next: &Self) -> Continuity {
        let (Self::Clear(before), Self::Clear(now)) = (self, next) else {
            let is_same = std::mem::discriminant(self) == std::mem::discriminant(next);
            return match is_same {
                true => Continuity::Same,
                false => Continuity::Unclear,
            };
        };
        let (mut same, mut exchanged, mut count) = (0, 0, 0);
        for (before, now) in before.iter().zip(now) {
            if before.is_nan() || now.is_nan() {
                continue;
            }
            // Within a factor of two of each other, or of the opposite.
            let (difference, sum) = ((before - now).abs(), (before + now).abs());
            same += usize::from(3.0 * difference < sum);
            exchanged += usize::from(3.0 * sum < difference);
            count += 1;
        }
        let agree = |votes: usize| votes as f64 >= AGREEING * count as f64;
        if count < LEAST_CELLS {
            Continuity::Unclear
        } else if agree(same) {
            Continuity::Same
        } else if agree(exchanged) {
            Continuity::Exchanged
        } else {
            Continuity::Unclear
        }
    }
}
