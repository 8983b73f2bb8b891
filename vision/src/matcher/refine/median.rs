//! The median of 3 × 3 pixels.

use ga_runtime::batch::{Batch, Work};

use super::{clamped_row, over_rows};

/// Replaces each disparity by the median of the 3 × 3 around it, where those beyond the border are
/// the outermost ones. Unknown disparities count as greater than all.
pub(in super::super) fn median(map: &[u16], width: usize, medians: &mut [u16]) {
    let batch = Batch::new();
    over_rows(medians, width, |first, rows| {
        batch.run(Median {
            map,
            width,
            first,
            rows,
        });
    });
}

struct Median<'a> {
    map: &'a [u16],
    width: usize,
    first: usize,
    rows: &'a mut [u16],
}

impl Work for Median<'_> {
    const WIDE: bool = true;

    #[inline(always)]
    fn run(self) {
        let width = self.width;
        let mut sorted = [vec![0; width + 2], vec![0; width + 2], vec![0; width + 2]];
        for (index, row) in self.rows.chunks_exact_mut(width).enumerate() {
            let middle = (self.first + index).cast_signed();
            let lines = [
                clamped_row(self.map, width, middle - 1),
                clamped_row(self.map, width, middle),
                clamped_row(self.map, width, middle + 1),
            ];
            sort_columns(lines, &mut sorted);
            let [low, mid, high] =
                [&sorted[0], &sorted[1], &sorted[2]].map(|row| &row[..width + 2]);
            for (column, value) in row.iter_mut().enumerate() {
                // The median of nine, of which each three of a column are sorted, is the median of
                // the greatest of the least, the median of the medians and the least of the
                // greatest.
                let (a, b, c) = (low[column], low[column + 1], low[column + 2]);
                let greatest = a.max(b).max(c);
                let (a, b, c) = (mid[column], mid[column + 1], mid[column + 2]);
                let middle = a.min(b).max(a.max(b).min(c));
                let (a, b, c) = (high[column], high[column + 1], high[column + 2]);
                let least = a.min(b).min(c);
                *value = greatest.min(middle).max(greatest.max(middle).min(least));
            }
        }
    }
}

/// Sorts each column of three rows, with a margin of one column on either side.
#[inline(always)]
fn sort_columns(lines: [&[u16]; 3], sorted: &mut [Vec<u16>; 3]) {
    let width = lines[0].len();
    let [low, mid, high] = sorted;
    let [above, middle, below] = lines;
    {
        let [low, mid, high] = [low, mid, high].map(|row| &mut row[1..=width]);
        for column in 0..width {
            let (a, b, c) = (above[column], middle[column], below[column]);
            let (small, large) = (a.min(b), a.max(b));
            low[column] = small.min(c);
            mid[column] = small.max(large.min(c));
            high[column] = large.max(c);
        }
    }
    for row in sorted {
        row[0] = row[1];
        row[width + 1] = row[width];
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn it_is_the_fifth_of_nine(
            (width, map) in (1usize..20, 1usize..20).prop_flat_map(|(width, height)| {
                (Just(width), prop::collection::vec(0u16..50, width * height))
            })
        ) {
            let mut medians = vec![0; map.len()];
            median(&map, width, &mut medians);
            for (place, found) in medians.iter().enumerate() {
                let (column, row) = ((place % width).cast_signed(), (place / width).cast_signed());
                let mut around: Vec<u16> = (0..9isize)
                    .map(|k| {
                        let x = (column + k % 3 - 1).clamp(0, width.cast_signed() - 1);
                        clamped_row(&map, width, row + k / 3 - 1)[x.cast_unsigned()]
                    })
                    .collect();
                around.sort_unstable();
                prop_assert_eq!(*found, around[4]);
            }
        }
    }
}
