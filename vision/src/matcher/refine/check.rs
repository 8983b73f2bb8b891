//! Left–right check: a point that both views show has the same disparity in both.

use super::super::winner::{STEPS, UNKNOWN};
use super::over_rows;

/// Marks as unknown what differs by more than a pixel from the disparity that the other view has at
/// the pixel it points to, or points out of it. `opposite` are the disparities of the other view in
/// whole pixels, with its columns mirrored.
pub(in super::super) fn check(map: &mut [u16], width: usize, opposite: &[u16]) {
    over_rows(map, width, |first, rows| {
        let opposite = opposite[first * width..].chunks_exact(width);
        for (row, opposite) in rows.chunks_exact_mut(width).zip(opposite) {
            for (column, disparity) in row.iter_mut().enumerate() {
                let nearest = disparity.saturating_add(STEPS / 2) / STEPS;
                let agrees = column
                    .checked_sub(usize::from(nearest))
                    .is_some_and(|target| opposite[width - 1 - target].abs_diff(nearest) <= 1);
                if !agrees {
                    *disparity = UNKNOWN;
                }
            }
        }
    });
}
