//! One pass over a strip of rows, from the top downwards, with one row of costs in memory.

use std::ops::Range;

use ga_runtime::batch::Work;

use super::cost::{NEVER, row_costs};
use super::features::Features;
use super::lanes::LANES;
use super::path::{PathRow, Penalties};
use super::view::View;
use super::winner::{Opposite, winner};

/// The rows above a strip from which its paths begin.
pub(super) const WARM_UP: usize = 16;
/// Paths that arrive at each pixel: from the left, from the right, and three from above.
const PATHS: usize = 5;

/// What a pass needs in memory.
#[derive(Clone, Debug)]
pub(super) struct Scratch {
    features: [Features; 2],
    costs: Vec<u8>,
    /// The paths from the upper left, from above and from the upper right, of the row above and of
    /// this row.
    above: [PathRow; 3],
    here: [PathRow; 3],
    forward: PathRow,
    backward: PathRow,
    sums: Vec<u16>,
    opposite: Opposite,
}

impl Scratch {
    /// For rows of `width` pixels with `range` disparities.
    pub(super) fn new(width: usize, range: usize) -> Self {
        let padded = range.next_multiple_of(LANES);
        let features = || Features::new(width, padded);
        let path = || PathRow::new(width, padded);
        Self {
            features: [features(), features()],
            costs: vec![0; width * padded],
            above: [path(), path(), path()],
            here: [path(), path(), path()],
            forward: path(),
            backward: path(),
            sums: vec![0; padded],
            opposite: Opposite::new(width, padded),
        }
    }
}

/// What a pass finds in its strip.
#[derive(Debug)]
pub(super) struct Found<'a> {
    /// The disparities of the reference view in 1/32 px.
    pub(super) disparities: &'a mut [u16],
    /// How clear they are, from 0 to 255.
    pub(super) confidence: &'a mut [u8],
    /// The disparities of the other view in whole pixels; its columns are mirrored.
    pub(super) opposite: &'a mut [u16],
}

/// What all strips of a pass have in common.
#[derive(Clone, Copy, Debug)]
pub(super) struct Task<'a> {
    pub(super) reference: &'a View,
    pub(super) other: &'a View,
    pub(super) range: usize,
    pub(super) penalties: &'a Penalties,
    /// The cost of candidates outside the other view.
    pub(super) outside: u8,
}

/// The pass over the strip `rows`.
pub(super) struct Sweep<'a> {
    pub(super) task: Task<'a>,
    pub(super) rows: Range<usize>,
    pub(super) scratch: &'a mut Scratch,
    pub(super) found: Found<'a>,
}

impl Work for Sweep<'_> {
    #[inline(always)]
    fn run(mut self) {
        let width = self.task.reference.width();
        let start = self.rows.start.saturating_sub(WARM_UP);
        for row in start..self.rows.end {
            self.costs(row);
            self.down_and_forward(row, row == start);
            if let Some(index) = row.checked_sub(self.rows.start) {
                self.backward(row, index * width);
            }
            let scratch = &mut *self.scratch;
            std::mem::swap(&mut scratch.above, &mut scratch.here);
        }
    }
}

impl Sweep<'_> {
    #[inline(always)]
    fn costs(&mut self, row: usize) {
        let Task {
            reference,
            other,
            range,
            outside,
            ..
        } = self.task;
        let scratch = &mut *self.scratch;
        let [left, right] = &mut scratch.features;
        left.compute(reference, row);
        right.compute(other, row);
        let stride = scratch.sums.len();
        row_costs(left, right, range, outside, &mut scratch.costs, stride);
    }

    /// The paths from above and from the left.
    #[inline(always)]
    fn down_and_forward(&mut self, row: usize, is_first: bool) {
        let view = self.task.reference;
        let penalties = self.task.penalties;
        let width = view.width();
        let scratch = &mut *self.scratch;
        let stride = scratch.sums.len();
        let levels = view.row(row);
        let levels_above = view.row(row.saturating_sub(1));
        for (column, costs) in scratch.costs.chunks_exact(stride).enumerate() {
            let level = levels[column];
            let from = [column.checked_sub(1), Some(column), Some(column + 1)];
            let paths = scratch.here.iter_mut().zip(&scratch.above).zip(from);
            for ((here, above), from) in paths {
                match from {
                    Some(from) if !is_first && from < width => {
                        let pair = [level, levels_above[from]];
                        here.advance(column, costs, (above, from), penalties, pair);
                    }
                    _ => here.begin(column, costs),
                }
            }
            let forward = &mut scratch.forward;
            match column.checked_sub(1) {
                Some(from) => {
                    let pair = [level, levels[from]];
                    forward.advance_within(column, costs, from, penalties, pair);
                }
                None => forward.begin(column, costs),
            }
        }
    }

    /// The paths from the right, and the winners, from the pixel `place` of the strip.
    #[inline(always)]
    fn backward(&mut self, row: usize, place: usize) {
        let view = self.task.reference;
        let penalties = self.task.penalties;
        let width = view.width();
        let scratch = &mut *self.scratch;
        let stride = scratch.sums.len();
        let levels = view.row(row);
        scratch.opposite.clear(PATHS as u16 * u16::from(NEVER));
        let costs = scratch.costs.chunks_exact(stride).enumerate().rev();
        for (column, costs) in costs {
            let backward = &mut scratch.backward;
            let from = column + 1;
            if from < width {
                let pair = [levels[column], levels[from]];
                backward.advance_within(column, costs, from, penalties, pair);
            } else {
                backward.begin(column, costs);
            }
            let [a, b, c] = &scratch.here;
            let paths = [a, b, c, &scratch.forward, &scratch.backward];
            sum(paths.map(|path| path.pixel(column)), &mut scratch.sums);
            scratch.opposite.take(column, width, &scratch.sums);
            let best = winner(&mut scratch.sums, self.task.range);
            self.found.disparities[place + column] = best.disparity;
            self.found.confidence[place + column] = best.confidence;
        }
        let opposite = scratch.opposite.disparities(width);
        self.found.opposite[place..][..width].copy_from_slice(opposite);
    }
}

/// The sums of the path costs.
#[inline(always)]
fn sum(paths: [&[u8]; PATHS], sums: &mut [u16]) {
    let paths = paths.map(|path| path.as_chunks::<LANES>().0);
    for (index, sums) in sums.as_chunks_mut::<LANES>().0.iter_mut().enumerate() {
        let blocks = paths.map(|path| &path[index]);
        for lane in 0..LANES {
            sums[lane] = blocks.iter().map(|block| u16::from(block[lane])).sum();
        }
    }
}
