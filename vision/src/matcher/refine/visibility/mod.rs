//! Disparities for the pixels that have none, from what the other view can see.
//!
//! A pixel without a match is mostly hidden from the other view. Then each candidate point on its
//! ray lies behind the surface that the other view shows at the candidate's place: a candidate in
//! front of that surface would be seen instead of it. Candidates in front cost something, the
//! others nothing, and smooth paths that begin at the known disparities around the hole choose
//! among them.

mod strip;

use crate::matcher::refine::visibility::strip::Tables;
use std::ops::Range;
use strip::{at_border, count};

use ga_runtime::batch::Batch;

use super::super::parts::Spare;
use super::super::view::View;
use strip::{Scratch, Strip};

/// The greatest number of rows of a strip.
const STRIP: usize = 64;
/// A strip of more than one row has at most as many holes as this number of rows has pixels.
const ROWS_OF_HOLES: usize = 8;
/// The bytes that the strips computed at the same time may need; two strips may always.
const AT_ONCE: usize = 8 << 20;
/// Fills holes of maps of one size.
#[derive(Debug)]
pub(in super::super) struct VisibilityFill {
    tables: Tables,
    spare: Spare<Scratch>,
}

impl VisibilityFill {
    pub(in super::super) fn new(width: usize, range: usize) -> Self {
        Self {
            tables: Tables::new(width, range),
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
            let (filled, below) = rest.split_at_mut(rows.len() * self.tables.width);
            rest = below;
            if holes > 0 {
                strips.push((rows, holes, filled));
            }
        }
        let batch = Batch::new();
        self.spare
            .compute(strips, |(rows, holes, filled), scratch| {
                batch.run(Strip {
                    tables: &self.tables,
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
        let numbers = holes.max().unwrap_or(0) * self.tables.padded;
        // Of the paths from three directions, at two rows, and of the sums.
        let bytes = 6 * self.tables.width * self.tables.padded + size_of::<u16>() * numbers;
        let most = (AT_ONCE / bytes).max(2);
        let new = || Scratch::new(self.tables.width, self.tables.padded);
        let threads = most.min(threads);
        self.spare
            .prepare(threads, new, |scratch| scratch.reserve(numbers));
    }

    /// Gives the memory back.
    pub(in super::super) fn release(&self) {
        self.spare.keep_at_most(0, 1);
    }

    /// The rows of each strip, and the holes that are filled there. They depend on the map alone.
    fn strips(&self, map: &[u16]) -> Vec<(Range<usize>, usize)> {
        let mut strips = Vec::new();
        let (mut start, mut holes) = (0, 0);
        for (row, disparities) in map.chunks_exact(self.tables.width).enumerate() {
            let here = count(&disparities[at_border(disparities)..]);
            let is_full = holes + here > ROWS_OF_HOLES * self.tables.width || row - start == STRIP;
            if is_full && row > start {
                strips.push((start..row, holes));
                (start, holes) = (row, 0);
            }
            holes += here;
        }
        strips.push((start..map.len() / self.tables.width, holes));
        strips
    }
}

#[cfg(test)]
mod tests {
    use ga_image::plane::Plane;

    use super::super::super::winner::{STEPS, UNKNOWN};
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
        view.fill(levels.view(), |level| level, 0);
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
        view.fill(Plane::filled(40, 9, 7u8).view(), |level| level, 0);
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
