//! The mean of what lies near in place and in disparity.

use ga_runtime::batch::{Batch, Work};

use super::super::winner::STEPS;
use super::{clamped_row, over_rows};

/// The mean of those disparities of the 3 × 3 around a pixel that differ from its own by at most
/// 1 px, in pixels from `least`, which stands for 0 in the map. All disparities are known.
pub(in super::super) fn smooth(map: &[u16], width: usize, least: f32, means: &mut [f32]) {
    let batch = Batch::new();
    over_rows(means, width, |first, rows| {
        batch.run(Smooth {
            map,
            width,
            least,
            first,
            rows,
        });
    });
}

struct Smooth<'a> {
    map: &'a [u16],
    width: usize,
    least: f32,
    first: usize,
    rows: &'a mut [f32],
}

impl Work for Smooth<'_> {
    const WIDE: bool = true;

    #[inline(always)]
    fn run(self) {
        let width = self.width;
        let mut padded = [vec![0; width + 2], vec![0; width + 2], vec![0; width + 2]];
        for (index, row) in self.rows.chunks_exact_mut(width).enumerate() {
            let middle = (self.first + index).cast_signed();
            for (dy, line) in padded.iter_mut().enumerate() {
                let source = clamped_row(self.map, width, middle + dy.cast_signed() - 1);
                line[1..=width].copy_from_slice(source);
                line[0] = source[0];
                line[width + 1] = source[width - 1];
            }
            let [a, b, c] = &padded;
            let around = [
                &a[..width],
                &a[1..][..width],
                &a[2..][..width],
                &b[..width],
                &b[1..][..width],
                &b[2..][..width],
                &c[..width],
                &c[1..][..width],
                &c[2..][..width],
            ];
            for (column, mean) in row.iter_mut().enumerate() {
                let own = around[4][column];
                let mut sum = 0;
                let mut count = 0;
                for line in around {
                    let near = line[column].abs_diff(own) <= STEPS;
                    // Differences are small, and sums of them fit.
                    sum += if near {
                        line[column].wrapping_sub(own).cast_signed()
                    } else {
                        0
                    };
                    count += i16::from(near);
                }
                let value = f32::from(own) + f32::from(sum) / f32::from(count);
                *mean = value / f32::from(STEPS) + self.least;
            }
        }
    }
}
