//! The matching cost of a pixel and its candidates.

use super::features::{Features, PLANES};
use super::lanes::{Block, LANES};

/// The cost of a candidate that is not to be chosen: disparities beyond the range, up to a whole
/// number of blocks.
pub(super) const NEVER: u8 = u8::MAX;
/// No cost is above this: 3/2 of 62 bits, and 3 + 8 for level and slope.
pub(super) const HIGHEST: u8 = 104;

/// The costs of all disparities of one pixel:
///
/// ⌊3/2 · Hamming distance of the census⌋ + ⌊min(|ΔI|, 12) / 4⌋ + min(|Δ slope|, 8).
///
/// `column` is the pixel's, `right` the mirrored features of the other view. `costs` has one number
/// for each disparity, a whole number of blocks. Candidates outside the view have a cost without
/// meaning.
#[inline(always)]
pub(super) fn pixel_costs(
    left: &Features,
    right: &Features,
    width: usize,
    column: usize,
    costs: &mut [u8],
) {
    let census: [u8; PLANES] = std::array::from_fn(|plane| left.census[plane][column]);
    let (level, slope) = (left.levels[column], left.slopes[column]);
    let start = width - 1 - column;
    let length = costs.len();
    let planes: [&[u8]; PLANES] = std::array::from_fn(|p| &right.census[p][start..][..length]);
    let levels = &right.levels[start..][..length];
    let slopes = &right.slopes[start..][..length];
    let (blocks, _) = costs.as_chunks_mut::<LANES>();
    for (index, block) in blocks.iter_mut().enumerate() {
        let at = index * LANES;
        let mut distance: Block = [0; LANES];
        for (plane, byte) in planes.iter().zip(census) {
            let bytes = &plane[at..][..LANES];
            for lane in 0..LANES {
                distance[lane] += (bytes[lane] ^ byte).count_ones() as u8;
            }
        }
        let levels = &levels[at..][..LANES];
        let slopes = &slopes[at..][..LANES];
        for lane in 0..LANES {
            let hamming = distance[lane] + (distance[lane] >> 1);
            let brightness = levels[lane].abs_diff(level).min(12) >> 2;
            block[lane] = hamming + brightness + slopes[lane].abs_diff(slope).min(8);
        }
    }
}

/// The costs of a row of pixels, `stride` numbers for each, of which the first `range` are those of
/// disparities 0 to `range` − 1. Candidates outside the other view cost `outside`.
#[inline(always)]
pub(super) fn row_costs(
    left: &Features,
    right: &Features,
    range: usize,
    outside: u8,
    costs: &mut [u8],
    stride: usize,
) {
    let width = costs.len() / stride;
    for (column, costs) in costs.chunks_exact_mut(stride).enumerate() {
        pixel_costs(left, right, width, column, costs);
        if column + 1 < range {
            costs[column + 1..range].fill(outside);
        }
        costs[range..].fill(NEVER);
    }
}
