//! How much sharper one view is than the other.

use std::ops::RangeInclusive;

use ga_image::plane::{Plane, PlaneView};
use ga_runtime::batch::{Batch, Work};

use super::matching::Match;
use ga_numerics::order_statistics::median;

/// Slopes are summed over this number of pixels on either side of a match.
const RADIUS: usize = 7;

/// What is added to sums of squared slopes of differences of two pixels, so that flat surroundings
/// have a logarithm: less than their rounding adds.
const FLOOR: f64 = 100.0;

/// The binary logarithm of the sharpness of the right view over that of the left one, at points
/// that both show; `None` where none of them is far enough from the borders.
///
/// Sharpness is the root mean square of slopes, divided by the contrast. Contrast is how much the
/// means of luma around the points differ from each other, which blur hardly changes: a view of
/// less contrast has smaller slopes and is not less sharp.
pub(super) fn measure(
    views: [&Plane<u8>; 2],
    matches: &[Match],
    memory: &mut Vec<f64>,
) -> Option<f64> {
    memory.clear();
    for found in matches {
        let mut energies = [None; 2];
        for (side, place) in [found.left, found.right].into_iter().enumerate() {
            energies[side] = slopes_around(views[side].view(), place);
        }
        if let [Some(left), Some(right)] = energies {
            memory.push(0.5 * (right / left).log2());
        }
    }
    let slopes = median(memory)?;
    let [left, right] = [0, 1].map(|side| contrast(matches, side));
    let contrast = (right / left).log2();
    Some(slopes - contrast).filter(|sharpness| sharpness.is_finite())
}

/// The mean absolute difference of luma of neighbouring matches; at least one level, below which it
/// is noise.
fn contrast(matches: &[Match], side: usize) -> f64 {
    let differences = matches
        .windows(2)
        .map(|pair| (pair[1].luma[side] - pair[0].luma[side]).abs());
    let count = matches.len().saturating_sub(1).max(1);
    (differences.sum::<f64>() / count as f64).max(1.0)
}

/// The sum of the squared slopes around a pixel, in squared levels for two pixels; `None` near the
/// border.
fn slopes_around(view: PlaneView<'_, u8>, place: [f64; 2]) -> Option<f64> {
    const SIDE: usize = 2 * RADIUS + 3;
    let [column, row] = place.map(|x| x.round().max(0.0) as usize);
    let [left, above] = [column, row].map(|x| x.checked_sub(RADIUS + 1));
    let part = view.part(left?, above?, SIDE, SIDE)?;
    let mut sum = 0;
    Batch::new().run(Slopes {
        part,
        sum: &mut sum,
    });
    Some(FLOOR + f64::from(sum))
}

struct Slopes<'a> {
    part: PlaneView<'a, u8>,
    sum: &'a mut u32,
}

impl Work for Slopes<'_> {
    #[inline(always)]
    fn run(self) {
        const INNER: RangeInclusive<usize> = 1..=2 * RADIUS + 1;
        for row in INNER {
            let [above, line, below] = [row - 1, row, row + 1].map(|row| self.part.row(row));
            for column in INNER {
                let x = i32::from(line[column + 1]) - i32::from(line[column - 1]);
                let y = i32::from(below[column]) - i32::from(above[column]);
                *self.sum += (x * x + y * y) as u32;
            }
        }
    }
}
