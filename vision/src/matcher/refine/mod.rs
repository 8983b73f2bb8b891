//! What happens to the disparities after they are found. Maps are slices of 1/32 px, row by row,
//! where [`UNKNOWN`](super::winner::UNKNOWN) stands for a disparity that is not known.

pub(super) mod check;
pub(super) mod fill;
pub(super) mod median;
pub(super) mod smooth;
pub(super) mod speckle;
pub(super) mod visibility;
pub(super) mod weighted;

use rayon::prelude::*;

/// The rows that are computed together. Results do not depend on it.
const TOGETHER: usize = 16;

/// Computes the rows of a map in parallel: `compute` gets the number of the first row, and the
/// rows.
pub(super) fn over_rows<T: Send>(
    map: &mut [T],
    width: usize,
    compute: impl Fn(usize, &mut [T]) + Sync + Send,
) {
    let parts = map.par_chunks_mut(TOGETHER * width);
    parts
        .enumerate()
        .for_each(|(index, rows)| compute(index * TOGETHER, rows));
}

/// The row of a map at a signed place; beyond the border, the outermost row.
#[inline(always)]
fn clamped_row(map: &[u16], width: usize, row: isize) -> &[u16] {
    let last = (map.len() / width).cast_signed() - 1;
    &map[row.clamp(0, last).cast_unsigned() * width..][..width]
}
