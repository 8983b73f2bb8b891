//! Sets of cells, a bit each.

use super::chart::Flat;
use super::raster;

/// Places closer than this to a cell count as within it, so that rounding when the coordinates are
/// written cannot take a triangle into a cell that it has not claimed.
pub(super) const SLACK: f64 = 1e-6;

/// A grid of cells, each in the set or not.
#[derive(Clone, Debug)]
pub(super) struct Mask {
    pub(super) width: usize,
    pub(super) height: usize,
    /// Words of 64 cells in a row.
    pub(super) stride: usize,
    pub(super) words: Vec<u64>,
}

impl Mask {
    pub(super) fn empty(width: usize, height: usize) -> Self {
        let stride = width.div_ceil(64);
        Self {
            width,
            height,
            stride,
            words: vec![0; stride * height],
        }
    }

    /// The cells that some triangles touch, and those within `margin` cells of them. The least
    /// coordinates of the triangles are `margin`.
    pub(super) fn of_triangles(triangles: &[[u32; 3]], places: &[Flat], margin: usize) -> Self {
        let mut reach = [0.0_f64; 2];
        for place in places {
            reach = [reach[0].max(place[0]), reach[1].max(place[1])];
        }
        let extent = |axis: usize| (reach[axis] + SLACK) as usize + 1 + margin;
        let mut mask = Self::empty(extent(0), extent(1));
        for triangle in triangles {
            let corners = triangle.map(|vertex| places[vertex as usize]);
            raster::touched(corners, SLACK, |row, [first, last]| {
                let row = (row.max(0) as usize).min(mask.height - 1);
                let last = (last.max(0) as usize).min(mask.width - 1);
                mask.fill(row, first.max(0) as usize, last);
            });
        }
        mask.dilate(margin);
        mask
    }

    pub(super) fn row(&self, row: usize) -> &[u64] {
        &self.words[row * self.stride..(row + 1) * self.stride]
    }

    /// Puts the cells from `first` to `last` of a row into the set.
    fn fill(&mut self, row: usize, first: usize, last: usize) {
        let row = &mut self.words[row * self.stride..(row + 1) * self.stride];
        let (a, b) = (first / 64, last / 64);
        let head = u64::MAX << (first % 64);
        let tail = u64::MAX >> (63 - last % 64);
        if a == b {
            row[a] |= head & tail;
        } else {
            row[a] |= head;
            row[a + 1..b].fill(u64::MAX);
            row[b] |= tail;
        }
    }

    /// Adds all cells within `margin` rows and columns of the set.
    fn dilate(&mut self, margin: usize) {
        for _ in 0..margin {
            for row in self.words.chunks_exact_mut(self.stride) {
                let mut carry = 0;
                for at in 0..row.len() {
                    let word = row[at];
                    let after = row.get(at + 1).copied().unwrap_or(0);
                    row[at] = word | word << 1 | word >> 1 | carry | after << 63;
                    carry = word >> 63;
                }
            }
            let mut above = vec![0; self.stride];
            for row in 0..self.height {
                for at in 0..self.stride {
                    let place = row * self.stride + at;
                    let word = self.words[place];
                    let below = self.words.get(place + self.stride).copied().unwrap_or(0);
                    self.words[place] = word | above[at] | below;
                    above[at] = word;
                }
            }
        }
    }

    /// How many cells are in the set.
    pub(super) fn count(&self) -> usize {
        self.words
            .iter()
            .map(|word| word.count_ones() as usize)
            .sum()
    }

    /// The longest run of cells of a row that are in the set, or with `inverted` that are not.
    pub(super) fn longest_run(&self, row: usize, inverted: bool) -> usize {
        let mut longest = 0;
        let mut run = 0;
        for (at, &word) in self.row(row).iter().enumerate() {
            let mut word = if inverted { !word } else { word };
            let mut left = (self.width - 64 * at).min(64) as u32;
            while left > 0 {
                let ones = word.trailing_ones().min(left);
                run += ones as usize;
                longest = longest.max(run);
                left -= ones;
                if left == 0 {
                    break;
                }
                run = 0;
                let zeros = (word >> (ones % 64)).trailing_zeros().min(left);
                left -= zeros;
                word = word.checked_shr(ones + zeros).unwrap_or(0);
            }
        }
        longest
    }

    /// The first cell of the run that contains this cell of the set.
    pub(super) fn run_start(&self, row: usize, column: usize) -> usize {
        let row = self.row(row);
        let mut at = column / 64;
        // The cells up to `column`, at the high end of the word.
        let mut ones = (row[at] << (63 - column % 64)).leading_ones() as usize;
        let mut start = column + 1 - ones;
        while start % 64 == 0 && start > 0 && ones > 0 {
            at -= 1;
            ones = row[at].leading_ones() as usize;
            start -= ones;
        }
        start
    }
}
