//! The holes of a strip of rows, filled along smooth paths.

use std::ops::Range;

use ga_runtime::batch::Work;

use crate::matcher::cost::{NEVER, difference};
use crate::matcher::lanes::{Block, LANES};
use crate::matcher::path::step;
use crate::matcher::view::View;
use crate::matcher::winner::{STEPS, UNKNOWN, least_cost, winner};

/// The cost of a candidate that the other view would see.
const SEEN: u8 = 30;
/// What a step to the next disparity costs a path.
const P1: u8 = 6;
/// The rows above and below a strip from which paths come.
const CONTEXT: usize = 24;
/// The path cost at a known disparity, for each pixel that a candidate is off, and its greatest.
const SLOPE: usize = 20;
const HIGHEST: usize = 100;

/// What a strip needs in memory.
#[derive(Debug)]
pub(super) struct Scratch {
    /// The greatest disparity, at each pixel of the other view, that it cannot see.
    limits: Vec<u16>,
    costs: Vec<u8>,
    /// Path costs at the holes of this row and of the row before, for three directions.
    here: [Vec<u8>; 3],
    before: [Vec<u8>; 3],
    least_here: [Vec<u8>; 3],
    least_before: [Vec<u8>; 3],
    /// Path costs along the row, of the pixel before and of this one.
    along: [Vec<u8>; 2],
    /// Sums of path costs for each hole of the strip that is filled.
    sums: Vec<u16>,
}

impl Scratch {
    pub(super) fn new(width: usize, padded: usize) -> Self {
        let paths = || [(); 3].map(|()| vec![NEVER; width * (padded + 1) + 1]);
        let least = || [(); 3].map(|()| vec![0; width]);
        Self {
            limits: vec![UNKNOWN; width + padded],
            costs: vec![0; padded],
            here: paths(),
            before: paths(),
            least_here: least(),
            least_before: least(),
            along: [(); 2].map(|()| vec![NEVER; padded + 2]),
            sums: Vec::new(),
        }
    }

    /// Makes room for a number of path costs.
    pub(super) fn reserve(&mut self, numbers: usize) {
        self.sums.clear();
        self.sums.reserve_exact(numbers);
    }
}

/// The rows of a strip, the number of its holes, and what they are filled from.
pub(super) struct Strip<'a> {
    pub(super) tables: &'a Tables,
    pub(super) map: &'a [u16],
    pub(super) view: &'a View,
    pub(super) other: &'a [u16],
    pub(super) rows: Range<usize>,
    pub(super) holes: usize,
    pub(super) filled: &'a mut [u16],
    pub(super) scratch: &'a mut Scratch,
}

impl Work for Strip<'_> {
    const WIDE: bool = true;

    #[inline(always)]
    fn run(mut self) {
        let (start, end) = (self.rows.start, self.rows.end);
        let numbers = self.holes * self.tables.padded;
        self.scratch.sums.clear();
        self.scratch.sums.resize(numbers, 0);
        let top = start.saturating_sub(CONTEXT);
        let bottom = (end + CONTEXT).min(self.view.height());
        let mut hole = 0;
        for row in top..end {
            let above = (row > top).then(|| row - 1);
            hole = self.row(row, above, hole, true);
        }
        hole = self.holes;
        for row in (start..bottom).rev() {
            let below = (row + 1 < bottom).then_some(row + 1);
            hole = self.row(row, below, hole, false);
        }
    }
}

impl Strip<'_> {
    /// Continues the paths to the holes of a row, from the row before on their way; downwards,
    /// those along the row as well. `hole` counts the holes of the strip that are filled from its
    /// top, and is that behind the ones before; the new count is returned.
    #[inline(always)]
    fn row(&mut self, row: usize, before: Option<usize>, hole: usize, downwards: bool) -> usize {
        let width = self.tables.width;
        let is_inside = self.rows.contains(&row);
        let map = &self.map[row * width..][..width];
        self.limits(row);
        let border = at_border(map);
        let first = if is_inside && !downwards {
            hole - count(&map[border..])
        } else {
            hole
        };
        let mut slot = first;
        for column in 0..width {
            if map[column] != UNKNOWN {
                continue;
            }
            self.costs(column);
            for direction in 0..3 {
                self.advance(row, column, before, direction);
            }
            if is_inside && column >= border {
                self.add(slot, column);
                slot += 1;
            }
        }
        if is_inside {
            if downwards {
                self.along(row, border, [first, slot]);
            } else {
                self.choose(row, border, first);
            }
        }
        let scratch = &mut *self.scratch;
        std::mem::swap(&mut scratch.here, &mut scratch.before);
        std::mem::swap(&mut scratch.least_here, &mut scratch.least_before);
        if downwards { slot } else { first }
    }

    /// What the other view cannot see in this row.
    #[inline(always)]
    fn limits(&mut self, row: usize) {
        let width = self.tables.width;
        let other = &self.other[row * width..][..width];
        for (limit, disparity) in self.scratch.limits.iter_mut().zip(other) {
            *limit = disparity.saturating_add(1);
        }
    }

    /// The costs of the candidates of a hole.
    #[inline(always)]
    fn costs(&mut self, column: usize) {
        let scratch = &mut *self.scratch;
        let start = self.tables.width - 1 - column;
        let limits = scratch.limits[start..][..self.tables.padded]
            .as_chunks::<LANES>()
            .0;
        let costs = scratch.costs.as_chunks_mut::<LANES>().0;
        for (index, (costs, limits)) in costs.iter_mut().zip(limits).enumerate() {
            let first = (index * LANES) as u16;
            let mut seen = [0u16; LANES];
            for lane in 0..LANES {
                let is_seen = first + lane as u16 > limits[lane];
                seen[lane] = if is_seen { u16::from(SEEN) } else { 0 };
            }
            let mut block: Block = [0; LANES];
            for lane in 0..LANES {
                block[lane] = seen[lane] as u8;
            }
            *costs = block;
        }
        scratch.costs[self.tables.range..].fill(NEVER);
    }

    /// One step to a hole from the row before, in one of three directions.
    #[inline(always)]
    fn advance(&mut self, row: usize, column: usize, before: Option<usize>, direction: usize) {
        let width = self.tables.width;
        let stride = self.tables.padded + 1;
        let scratch = &mut *self.scratch;
        let after = &mut scratch.here[direction][column * stride + 1..][..stride - 1];
        let from = (column + direction).checked_sub(1).filter(|c| *c < width);
        let least = &mut scratch.least_here[direction][column];
        let (Some(before), Some(from)) = (before, from) else {
            after.copy_from_slice(&scratch.costs);
            *least = scratch.costs.iter().copied().min().unwrap_or(0);
            return;
        };
        let levels = [self.view.row(row)[column], self.view.row(before)[from]];
        let p2 = self.tables.large[usize::from(difference(levels[0], levels[1]))];
        let known = self.map[before * width + from];
        let (costs, least_before) = if known == UNKNOWN {
            let costs = &scratch.before[direction][from * stride..][..stride + 1];
            (costs, scratch.least_before[direction][from])
        } else {
            (self.tables.known(known), 0)
        };
        *least = step(&scratch.costs, costs, least_before, P1, p2, after);
    }

    /// Adds the path costs of three directions to those of a hole.
    #[inline(always)]
    fn add(&mut self, slot: usize, column: usize) {
        let stride = self.tables.padded + 1;
        let scratch = &mut *self.scratch;
        let sums = &mut scratch.sums[slot * (stride - 1)..][..stride - 1];
        for path in &scratch.here {
            add(sums, &path[column * stride + 1..][..stride - 1]);
        }
    }

    /// The paths along the row, both ways, to its holes from column `border` on, which have the
    /// numbers from `first` to `end`.
    #[inline(always)]
    fn along(&mut self, row: usize, border: usize, [first, end]: [usize; 2]) {
        let width = self.tables.width;
        let padded = self.tables.padded;
        let map = &self.map[row * width..][..width];
        let levels = self.view.row(row);
        let mut state = std::mem::take(&mut self.scratch.along);
        for forward in [true, false] {
            let mut least = 0;
            let mut slot = if forward { first } else { end };
            for step_number in 0..width - border {
                let column = if forward {
                    border + step_number
                } else {
                    width - 1 - step_number
                };
                if map[column] != UNKNOWN {
                    continue;
                }
                self.costs(column);
                let scratch = &mut *self.scratch;
                let [before, after] = &mut state;
                let from = if forward {
                    column.checked_sub(1)
                } else {
                    Some(column + 1)
                };
                let after_costs = &mut after[1..=padded];
                match from.filter(|from| *from < width) {
                    Some(from) => {
                        let gap = difference(levels[column], levels[from]);
                        let p2 = self.tables.large[usize::from(gap)];
                        let (costs, least_before) = if map[from] == UNKNOWN {
                            (before.as_slice(), least)
                        } else {
                            (self.tables.known(map[from]), 0)
                        };
                        least = step(&scratch.costs, costs, least_before, P1, p2, after_costs);
                    }
                    None => {
                        after_costs.copy_from_slice(&scratch.costs);
                        least = scratch.costs.iter().copied().min().unwrap_or(0);
                    }
                }
                if !forward {
                    slot -= 1;
                }
                add(&mut scratch.sums[slot * padded..][..padded], after_costs);
                if forward {
                    slot += 1;
                }
                state.swap(0, 1);
            }
        }
        self.scratch.along = state;
    }

    /// The best candidates of the holes of a row from column `border` on.
    #[inline(always)]
    fn choose(&mut self, row: usize, border: usize, first: usize) {
        let width = self.tables.width;
        let padded = self.tables.padded;
        let map = &self.map[row * width..][..width];
        let filled = &mut self.filled[(row - self.rows.start) * width..][..width];
        let mut slot = first;
        for column in border..width {
            if map[column] == UNKNOWN {
                let sums = &self.scratch.sums[slot * padded..][..padded];
                filled[column] =
                    winner(sums, least_cost(sums), None, self.tables.range).disparity();
                slot += 1;
            }
        }
    }
}

/// What the filling of all strips of maps of one size has in common.
#[derive(Debug)]
pub(super) struct Tables {
    pub(super) width: usize,
    pub(super) range: usize,
    pub(super) padded: usize,
    /// The path costs at a known disparity: those for disparity d begin at `padded` − d.
    tent: Vec<u8>,
    large: [u8; 256],
}

impl Tables {
    pub(super) fn new(width: usize, range: usize) -> Self {
        let padded = range.next_multiple_of(LANES);
        let tent = (0..2 * padded + 2).map(|k| (SLOPE * k.abs_diff(padded + 1)).min(HIGHEST) as u8);
        Self {
            width,
            range,
            padded,
            tent: tent.collect(),
            large: std::array::from_fn(|g| (60.0 / (1.0 + g as f32 / 3.0)).max(8.0) as u8),
        }
    }
}

impl Tables {
    /// The path costs at a pixel of known disparity, with a margin of one on either side.
    #[inline(always)]
    fn known(&self, disparity: u16) -> &[u8] {
        let nearest = usize::from(disparity.saturating_add(STEPS / 2) / STEPS).min(self.range - 1);
        &self.tent[self.padded - nearest..][..self.padded + 2]
    }
}

#[inline(always)]
fn add(sums: &mut [u16], costs: &[u8]) {
    let sums = sums.as_chunks_mut::<LANES>().0.iter_mut();
    for (sums, costs) in sums.zip(costs.as_chunks::<LANES>().0) {
        let mut total = *sums;
        for lane in 0..LANES {
            total[lane] += u16::from(costs[lane]);
        }
        *sums = total;
    }
}

/// The number of holes.
pub(super) fn count(map: &[u16]) -> usize {
    map.iter().filter(|d| **d == UNKNOWN).count()
}

/// The length of the hole that begins at the first column.
pub(super) fn at_border(row: &[u16]) -> usize {
    row.iter().take_while(|d| **d == UNKNOWN).count()
}
