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

    /// The cells that an image touches, given by the segments of its boundary, and those within
    /// `margin` cells of them. The least coordinates of the segments are `margin` and a little.
    pub(super) fn of_image(boundary: &[[Flat; 2]], margin: usize) -> Self {
        let mut reach = [0.0_f64; 2];
        for place in boundary.iter().flatten() {
            reach = [reach[0].max(place[0]), reach[1].max(place[1])];
        }
        let extent = |axis: usize| (reach[axis] + SLACK) as usize + 1 + margin;
        let mut mask = Self::empty(extent(0), extent(1));
        // A cell that no segment touches is inside if its centre is.
        for &segment in boundary {
            raster::crossings(segment, |row, column| {
                let (row, column) = (row.max(0) as usize, column.max(0) as usize);
                if row < mask.height && column < mask.width {
                    mask.words[row * mask.stride + column / 64] ^= 1 << (column % 64);
                }
            });
        }
        mask.fill_between();
        for &[a, b] in boundary {
            raster::touched([a, b, b], SLACK, |row, columns| {
                mask.fill(row, columns, |_, _| ());
            });
        }
        mask.dilate(margin);
        mask
    }

    /// Replaces each cell by the parity of the cells of its row up to it.
    fn fill_between(&mut self) {
        for row in self.words.chunks_exact_mut(self.stride) {
            let mut carry = 0;
            for word in row {
                for shift in [1, 2, 4, 8, 16, 32] {
                    *word ^= *word << shift;
                }
                *word ^= carry;
                carry = (*word >> 63).wrapping_neg();
            }
        }
    }

    /// The squares of `cell` × `cell` cells that contain one of the set.
    pub(super) fn coarse(self, cell: usize) -> Self {
        if cell == 1 {
            return self;
        }
        let mut coarse = Self::empty(self.width.div_ceil(cell), self.height.div_ceil(cell));
        let mut union = vec![0; self.stride];
        for (row, words) in coarse.words.chunks_exact_mut(coarse.stride).enumerate() {
            union.fill(0);
            for row in cell * row..(cell * row + cell).min(self.height) {
                for (union, word) in union.iter_mut().zip(self.row(row)) {
                    *union |= word;
                }
            }
            for (at, &word) in union.iter().enumerate() {
                let mut word = word;
                while word != 0 {
                    let column = (64 * at + word.trailing_zeros() as usize) / cell;
                    words[column / 64] |= 1 << (column % 64);
                    // On to the first cell of the next square.
                    let next = (column + 1) * cell - 64 * at;
                    word = if next < 64 { word >> next << next } else { 0 };
                }
            }
        }
        coarse
    }

    pub(super) fn row(&self, row: usize) -> &[u64] {
        &self.words[row * self.stride..(row + 1) * self.stride]
    }

    /// Puts the cells of a row from the first to the last column, as far as there are such cells,
    /// into the set. Calls
    /// `common(index, cells)` for each word with cells that were in it already.
    pub(super) fn fill(
        &mut self,
        row: i64,
        [first, last]: [i64; 2],
        mut common: impl FnMut(usize, u64),
    ) {
        if !(0..self.height as i64).contains(&row) || last < 0 || first >= self.width as i64 {
            return;
        }
        let (first, last) = (first.max(0) as usize, (last as usize).min(self.width - 1));
        let begin = row as usize * self.stride;
        let (a, b) = (first / 64, last / 64);
        for at in a..=b {
            let head = if at == a {
                u64::MAX << (first % 64)
            } else {
                u64::MAX
            };
            let tail = if at == b {
                u64::MAX >> (63 - last % 64)
            } else {
                u64::MAX
            };
            let word = &mut self.words[begin + at];
            if *word & head & tail != 0 {
                common(begin + at, *word & head & tail);
            }
            *word |= head & tail;
        }
    }

    /// Puts the cells of another mask into the set, moved by some columns and rows. Calls
    /// `common(index, cells)` for each word with cells that were in it already.
    pub(super) fn add(
        &mut self,
        other: &Self,
        [column, row]: [usize; 2],
        mut common: impl FnMut(usize, u64),
    ) {
        let (skip, shift) = (column / 64, column % 64);
        for at in 0..other.height.min(self.height.saturating_sub(row)) {
            let begin = (row + at) * self.stride;
            let mut before = 0;
            for index in 0..=other.stride {
                let word = other.row(at).get(index).copied().unwrap_or(0);
                let moved =
                    word << shift | u64::checked_shr(before, 64 - shift as u32).unwrap_or(0);
                before = word;
                if skip + index < self.stride {
                    let place = begin + skip + index;
                    if self.words[place] & moved != 0 {
                        common(place, self.words[place] & moved);
                    }
                    self.words[place] |= moved;
                }
            }
        }
    }

    /// Adds all cells within `margin` rows and columns of the set.
    pub(super) fn dilate(&mut self, margin: usize) {
        // After as many steps as there are columns or rows every cell has been reached.
        for _ in 0..margin.min(self.width.max(self.height)) {
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
                for (at, above) in above.iter_mut().enumerate() {
                    let place = row * self.stride + at;
                    let word = self.words[place];
                    let below = self.words.get(place + self.stride).copied().unwrap_or(0);
                    self.words[place] = word | *above | below;
                    *above = word;
                }
            }
        }
        // Cells to the right of the last column do not exist.
        let spare = 64 * self.stride - self.width;
        for row in self.words.chunks_exact_mut(self.stride) {
            row[self.stride - 1] &= u64::MAX >> spare;
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
        while start.is_multiple_of(64) && start > 0 && ones > 0 {
            at -= 1;
            ones = row[at].leading_ones() as usize;
            start -= ones;
        }
        start
    }
}
