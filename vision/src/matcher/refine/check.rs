//! Left–right check: a point that both views show has the same disparity in both.

use std::ops::Range;

use super::super::winner::{STEPS, UNKNOWN};
use super::over_rows;

/// Marks as unknown what differs by more than a pixel from the disparity that the other view has at
/// the pixel it points to, or points out of it. The disparities of `map` are multiples of
/// 1 / `STEPS` px, those of `other` whole pixels; its columns are mirrored.
pub(in super::super) fn check<const STEPS: u16>(map: &mut [u16], width: usize, other: &[u16]) {
    over_rows(map, width, |first, rows| {
        let other = other[first * width..].chunks_exact(width);
        for (row, other) in rows.chunks_exact_mut(width).zip(other) {
            for (column, disparity) in row.iter_mut().enumerate() {
                let nearest = disparity.saturating_add(STEPS / 2) / STEPS;
                let agrees = column
                    .checked_sub(usize::from(nearest))
                    .is_some_and(|target| other[width - 1 - target].abs_diff(nearest) <= 1);
                if !agrees {
                    *disparity = UNKNOWN;
                }
            }
        }
    });
}

/// Marks as unknown the disparities of the columns that show nothing.
pub(in super::super) fn hide(map: &mut [u16], width: usize, seen: Range<usize>) {
    if seen.len() < width {
        for row in map.chunks_exact_mut(width) {
            row[..seen.start].fill(UNKNOWN);
            row[seen.end..].fill(UNKNOWN);
        }
    }
}

/// Rounds disparities to whole pixels, in which they are then given.
pub(in super::super) fn to_pixels(map: &mut [u16], width: usize) {
    over_rows(map, width, |_, rows| {
        for disparity in rows {
            if *disparity != UNKNOWN {
                *disparity = (*disparity + STEPS / 2) / STEPS;
            }
        }
    });
}
