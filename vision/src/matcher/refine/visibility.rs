//! Disparities for the pixels that have none, from what the other view can see.
//!
//! A pixel without a match is mostly hidden from the other view. Then each candidate point on its
//! ray lies behind the surface that the other view shows at the candidate's place: a candidate in
//! front of that surface would be seen instead of it. Candidates in front cost something, the
//! others nothing, and smooth paths that begin at the known disparities around the hole choose
//! among them.

use std::ops::Range;

use ga_runtime::batch::{Batch, Work};

use super::super::cost::{NEVER, difference};
use super::super::lanes::{Block, LANES};
use super::super::parts::Spare;
use super::super::path::step;
use super::super::view::View;
use super::super::winner::{STEPS, UNKNOWN, least_cost, winner};

/// The greatest number of rows of a strip, and those above and below it from which paths come.
const STRIP: usize = 64;
const CONTEXT: usize = 24;
/// A strip of more than one row has at most as many holes as this number of rows has pixels.
const ROWS_OF_HOLES: usize = 8;
/// The bytes that the strips computed at the same time may need; two strips may always.
const AT_ONCE: usize = 8 << 20;
/// The cost of a candidate that the other view would see.
const SEEN: u8 = 30;
/// The path cost at a known disparity, for each pixel that a candidate is off, and its greatest.
const SLOPE: usize = 20;
const HIGHEST: usize = 100;
const P1: u8 = 6;

/// Fills holes of maps of one size.
#[derive(Debug)]
pub(in super::super) struct VisibilityFill {
    width: usize,
    range: usize,
    padded: usize,
    /// The path costs at a known disparity: those for disparity d begin at `padded` − d.
    tent: Vec<u8>,
    large: [u8; 256],
    spare: Spare<Scratch>,
}

/// What a strip needs in memory.
#[derive(Debug)]
struct Scratch {
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

impl VisibilityFill {
    pub(in super::super) fn new(width: usize, range: usize) -> Self {
        let padded = range.next_multiple_of(LANES);
        let tent = (0..2 * padded + 2).map(|k| (SLOPE * k.abs_diff(padded + 1)).min(HIGHEST) as u8);
        Self {
            width,
            range,
            padded,
            tent: tent.collect(),
            large: std::array::from_fn(|g| (60.0 / (1.0 + g as f32 / 3.0)).max(8.0) as u8),
            spare: Spare::default(),
        }
    }

    /// Fills the holes of a map. `other` has the disparities of the other view in whole pixels,
    /// with its columns mirrored, where they are confirmed. Holes that begin at the first column
    /// are left as they are: the other view shows nothing of them.
    pub(in super::super) fn fill(
        &self,
        map: &[u16],
        view: &View,
        other: &[u16],
        filled: &mut [u16],
    ) {
        filled.copy_from_slice(map);
        let mut strips = Vec::new();
        let mut rest = filled;
        for (rows, holes) in self.strips(map) {
            let (filled, below) = rest.split_at_mut(rows.len() * self.width);
            rest = below;
            if holes > 0 {
                strips.push((rows, holes, filled));
            }
        }
        let batch = Batch::new();
        self.spare
            .compute(strips, |(rows, holes, filled), scratch| {
                batch.run(Strip {
                    fill: self,
                    map,
                    view,
                    other,
                    rows,
                    holes,
                    filled,
                    scratch,
                });
            });
    }

    /// Makes the memory for filling a map with a number of threads.
    pub(in super::super) fn prepare(&self, map: &[u16], threads: usize) {
        let holes = self.strips(map).into_iter().map(|(_, holes)| holes);
        let numbers = holes.max().unwrap_or(0) * self.padded;
        // Of the paths from three directions, at two rows, and of the sums.
        let bytes = 6 * self.width * self.padded + size_of::<u16>() * numbers;
        let most = (AT_ONCE / bytes).max(2);
        let new = || Scratch::new(self.width, self.padded);
        self.spare.prepare(most.min(threads), new, |scratch| {
            scratch.sums.clear();
            scratch.sums.reserve_exact(numbers);
        });
    }

    /// Gives the memory back.
    pub(in super::super) fn release(&self) {
        self.spare.keep_at_most(0, 1);
    }

    /// The rows of each strip, and the holes that are filled there. They depend on the map alone.
    fn strips(&self, map: &[u16]) -> Vec<(Range<usize>, usize)> {
        let mut strips = Vec::new();
        let (mut start, mut holes) = (0, 0);
        for (row, disparities) in map.chunks_exact(self.width).enumerate() {
            let here = count(&disparities[at_border(disparities)..]);
            let is_full = holes + here > ROWS_OF_HOLES * self.width || row - start == STRIP;
            if is_full && row > start {
                strips.push((start..row, holes));
                (start, holes) = (row, 0);
            }
            holes += here;
        }
        strips.push((start..map.len() / self.width, holes));
        strips
    }
}

/// The number of holes.
fn count(map: &[u16]) -> usize {
    map.iter().filter(|d| **d == UNKNOWN).count()
}

/// The length of the hole that begins at the first column.
fn at_border(row: &[u16]) -> usize {
    row.iter().take_while(|d| **d == UNKNOWN).count()
}

impl Scratch {
    fn new(width: usize, padded: usize) -> Self {
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
}

struct Strip<'a> {
    fill: &'a VisibilityFill,
    map: &'a [u16],
    view: &'a View,
    other: &'a [u16],
    rows: Range<usize>,
    holes: usize,
    filled: &'a mut [u16],
    scratch: &'a mut Scratch,
}

impl Work for Strip<'_> {
    #[inline(always)]
    fn run(mut self) {
        let (start, end) = (self.rows.start, self.rows.end);
        let numbers = self.holes * self.fill.padded;
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
        let width = self.fill.width;
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
        let width = self.fill.width;
        let other = &self.other[row * width..][..width];
        for (limit, disparity) in self.scratch.limits.iter_mut().zip(other) {
            *limit = disparity.saturating_add(1);
        }
    }

    /// The costs of the candidates of a hole.
    #[inline(always)]
    fn costs(&mut self, column: usize) {
        let scratch = &mut *self.scratch;
        let start = self.fill.width - 1 - column;
        let limits = scratch.limits[start..][..self.fill.padded]
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
        scratch.costs[self.fill.range..].fill(NEVER);
    }

    /// One step to a hole from the row before, in one of three directions.
    #[inline(always)]
    fn advance(&mut self, row: usize, column: usize, before: Option<usize>, direction: usize) {
        let width = self.fill.width;
        let stride = self.fill.padded + 1;
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
        let p2 = self.fill.large[usize::from(difference(levels[0], levels[1]))];
        let known = self.map[before * width + from];
        let (costs, least_before) = if known == UNKNOWN {
            let costs = &scratch.before[direction][from * stride..][..stride + 1];
            (costs, scratch.least_before[direction][from])
        } else {
            (self.fill.known(known), 0)
        };
        *least = step(&scratch.costs, costs, least_before, P1, p2, after);
    }

    /// Adds the path costs of three directions to those of a hole.
    #[inline(always)]
    fn add(&mut self, slot: usize, column: usize) {
        let stride = self.fill.padded + 1;
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
        let width = self.fill.width;
        let padded = self.fill.padded;
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
                        let p2 = self.fill.large[usize::from(gap)];
                        let (costs, least_before) = if map[from] == UNKNOWN {
                            (before.as_slice(), least)
                        } else {
                            (self.fill.known(map[from]), 0)
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
        let width = self.fill.width;
        let padded = self.fill.padded;
        let map = &self.map[row * width..][..width];
        let filled = &mut self.filled[(row - self.rows.start) * width..][..width];
        let mut slot = first;
        for column in border..width {
            if map[column] == UNKNOWN {
                let sums = &self.scratch.sums[slot * padded..][..padded];
                filled[column] = winner(sums, least_cost(sums), None, self.fill.range).disparity;
                slot += 1;
            }
        }
    }
}

impl VisibilityFill {
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

#[cfg(test)]
mod tests {
    use ga_image::plane::Plane;

    use super::*;

    #[test]
    fn what_a_rectangle_hides_is_background() {
        // 64 of 85 rows have more holes than a strip may have.
        [20, 85].into_iter().for_each(what_it_hides_is_background);
    }

    /// A bright rectangle at disparity 12 before a dark background at 4: the right view shows the
    /// background up to the rectangle's image, and the hole to the left of it is behind it.
    fn what_it_hides_is_background(rows: usize) {
        let (width, height, range) = (60, rows + 40, 20);
        let hiding = 20..20 + rows;
        let is_square =
            |column: usize, row: usize| (30..50).contains(&column) && hiding.contains(&row);
        let levels = Plane::from_fn(width, height, |column, row| {
            if is_square(column, row) { 200u8 } else { 50 }
        });
        let mut view = View::new(width, height, false);
        view.fill(levels.view(), &std::array::from_fn(|level| level as u8));
        let mut map = Vec::new();
        let mut other = vec![UNKNOWN; width * height];
        for row in 0..height {
            for column in 0..width {
                let disparity = if is_square(column, row) { 12 } else { 4 };
                let is_hidden =
                    disparity == 4 && hiding.contains(&row) && (22..42).contains(&column);
                map.push([disparity * STEPS, UNKNOWN][usize::from(is_hidden)]);
                if !is_hidden && column >= usize::from(disparity) {
                    let target = column - usize::from(disparity);
                    other[row * width + width - 1 - target] = disparity;
                }
            }
        }
        let holes = count(&map);
        assert_eq!(holes, 8 * rows);
        let fill = VisibilityFill::new(width, range);
        let strips = fill.strips(&map);
        for (rows, holes) in &strips {
            assert!(rows.len() <= STRIP && *holes <= ROWS_OF_HOLES * width);
        }
        assert_eq!(strips.iter().map(|(_, holes)| holes).sum::<usize>(), holes);
        let mut filled = vec![0; map.len()];
        fill.prepare(&map, 2);
        fill.fill(&map, &view, &other, &mut filled);
        for (place, (before, after)) in map.iter().zip(&filled).enumerate() {
            let expected = Some(*before).filter(|d| *d != UNKNOWN).unwrap_or(4 * STEPS);
            assert!(after.abs_diff(expected) <= STEPS / 2, "{place}: {after}");
        }
    }

    /// Runs at the left border are not filled; a map without anything known stays so.
    #[test]
    fn the_left_border_is_left_alone() {
        let mut view = View::new(40, 9, false);
        view.fill(Plane::filled(40, 9, 7u8).view(), &[7; 256]);
        let mut map = vec![5 * STEPS; 40 * 9];
        for row in map.chunks_exact_mut(40) {
            row[..6].fill(UNKNOWN);
            row[20] = UNKNOWN;
        }
        let other = vec![UNKNOWN; map.len()];
        let fill = VisibilityFill::new(40, 32);
        let mut filled = vec![0; map.len()];
        fill.prepare(&map, 1);
        fill.fill(&map, &view, &other, &mut filled);
        for row in filled.chunks_exact(40) {
            assert!(row[..6].iter().all(|d| *d == UNKNOWN));
            assert!(row[6..].iter().all(|d| *d == 5 * STEPS));
        }
        map.fill(UNKNOWN);
        fill.fill(&map, &view, &other, &mut filled);
        assert!(filled.iter().all(|d| *d == UNKNOWN));
    }
}
