//! The matching cost of a pixel and its candidates.

use std::ops::Range;

use super::features::{Features, PLANES};
use super::lanes::{Block, LANES};
use super::view::View;

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
    let start = width - 1 - column;
    let length = costs.len();
    let census: [u8; PLANES] = std::array::from_fn(|plane| left.census[plane][column]);
    let plane = |plane: usize| -> &[Block] { right.census[plane][start..][..length].as_chunks().0 };
    // One by one: arrays of slices go through memory.
    let (p0, p1, p2, p3) = (plane(0), plane(1), plane(2), plane(3));
    let (p4, p5, p6, p7) = (plane(4), plane(5), plane(6), plane(7));
    let (level, slope) = (left.levels[column], left.slopes[column]);
    let levels: &[Block] = right.levels[start..][..length].as_chunks().0;
    let slopes: &[Block] = right.slopes[start..][..length].as_chunks().0;
    let blocks = costs.as_chunks_mut::<LANES>().0;
    for (index, block) in blocks.iter_mut().enumerate() {
        let bytes: [&Block; PLANES] = [
            &p0[index], &p1[index], &p2[index], &p3[index], &p4[index], &p5[index], &p6[index],
            &p7[index],
        ];
        let (levels, slopes) = (&levels[index], &slopes[index]);
        let mut sums: Block = [0; LANES];
        for lane in 0..LANES {
            let mut distance = 0;
            for plane in 0..PLANES {
                distance += (bytes[plane][lane] ^ census[plane]).count_ones() as u8;
            }
            let brightness = difference(levels[lane], level).min(12) >> 2;
            let steepness = difference(slopes[lane], slope).min(8);
            sums[lane] = distance + (distance >> 1) + brightness + steepness;
        }
        *block = sums;
    }
}

/// |a − b|, which `abs_diff` computes in 32 bits.
#[inline(always)]
pub(super) fn difference(a: u8, b: u8) -> u8 {
    a.max(b) - a.min(b)
}

/// Which of the candidates of a pixel lie in the other view, and what the others cost.
#[derive(Clone, Debug)]
pub(super) struct Candidates {
    /// The columns of both views that show something; those of the other one are mirrored.
    seen: [Range<usize>; 2],
    width: usize,
    range: usize,
    outside: u8,
}

impl Candidates {
    /// The candidates of pixels of a view for disparities from 0 to `range` − 1, of which those
    /// outside the other view cost `outside`.
    pub(super) fn new(views: [&View; 2], range: usize, outside: u8) -> Self {
        Self {
            seen: views.map(View::seen),
            width: views[0].width(),
            range,
            outside,
        }
    }

    /// The candidates of the pixels of a column that lie in the other view.
    #[inline(always)]
    pub(super) fn of(&self, column: usize) -> Range<usize> {
        let [seen, other] = &self.seen;
        let start = self.width - 1 - column;
        let range = if seen.contains(&column) {
            self.range
        } else {
            0
        };
        let place = |end: usize| end.saturating_sub(start).min(range);
        place(other.start)..place(other.end)
    }
}

/// The costs of a row of pixels, `stride` numbers for each, of which the first are those of the
/// candidates. Numbers that are those of no candidate are set to `beyond`.
#[inline(always)]
pub(super) fn row_costs(
    left: &Features,
    right: &Features,
    candidates: &Candidates,
    beyond: u8,
    costs: &mut [u8],
    stride: usize,
) {
    let Candidates {
        width,
        range,
        outside,
        ..
    } = *candidates;
    for (column, costs) in costs.chunks_exact_mut(stride).enumerate() {
        pixel_costs(left, right, width, column, costs);
        let inside = candidates.of(column);
        // Most pixels have all candidates, and to fill nothing takes its time as well.
        if inside.start > 0 {
            costs[..inside.start].fill(outside);
        }
        if inside.end < range {
            costs[inside.end..range].fill(outside);
        }
        if range < stride {
            costs[range..].fill(beyond);
        }
    }
}
