//! The weighted median at edges of the map.

use ga_runtime::batch::{Batch, Work};

use super::super::view::View;
use super::super::winner::STEPS;
use super::{clamped_row, over_rows};

/// Pixels on either side.
const REACH: isize = 3;
const SIDE: usize = 2 * REACH as usize + 1;
/// The pixels of the window, and of whole vector registers.
const WINDOW: usize = SIDE * SIDE;
const PADDED: usize = 64;

/// The weighted median of 7 × 7 pixels, with weights exp(−|ΔI| / 15 − distance / 10).
#[derive(Clone, Debug)]
pub(in super::super) struct WeightedMedian {
    /// By the difference of levels, for each place of the window; their sums fit in 16 bits.
    weights: Vec<[u16; WINDOW]>,
}

impl WeightedMedian {
    pub(in super::super) fn new() -> Self {
        let weight = |difference: usize, place: usize| {
            let [x, y] = [place % SIDE, place / SIDE].map(|k| k as f32 - REACH as f32);
            let distance = x.hypot(y);
            (1300.0 * (-(difference as f32) / 15.0 - distance / 10.0).exp()).round() as u16
        };
        Self {
            weights: (0..256)
                .map(|difference| std::array::from_fn(|place| weight(difference, place)))
                .collect(),
        }
    }

    /// Replaces the disparities around which the 3 × 3 differ by more than 1.5 px. All disparities
    /// are known.
    pub(in super::super) fn at_edges(&self, map: &[u16], view: &View, medians: &mut [u16]) {
        let batch = Batch::new();
        over_rows(medians, view.width(), |first, rows| {
            batch.run(AtEdges {
                weights: &self.weights,
                map,
                view,
                first,
                rows,
            });
        });
    }
}

struct AtEdges<'a> {
    weights: &'a [[u16; WINDOW]],
    map: &'a [u16],
    view: &'a View,
    first: usize,
    rows: &'a mut [u16],
}

impl Work for AtEdges<'_> {
    #[inline(always)]
    fn run(self) {
        let width = self.view.width();
        let mut spread = vec![0u16; width];
        for (index, medians) in self.rows.chunks_exact_mut(width).enumerate() {
            let row = (self.first + index).cast_signed();
            let lines = [-1, 0, 1].map(|dy| clamped_row(self.map, width, row + dy));
            spreads(lines, &mut spread);
            for (column, median) in medians.iter_mut().enumerate() {
                *median = if spread[column] > STEPS + STEPS / 2 {
                    weighted_median(self.weights, self.map, self.view, column, row)
                } else {
                    lines[1][column]
                };
            }
        }
    }
}

/// The range of the disparities in 3 × 3.
#[inline(always)]
fn spreads(lines: [&[u16]; 3], spread: &mut [u16]) {
    let width = spread.len();
    let [above, middle, below] = lines;
    let range = |column: usize| {
        let [a, b, c] = [above[column], middle[column], below[column]];
        (a.min(b).min(c), a.max(b).max(c))
    };
    for column in 1..width.saturating_sub(1) {
        let [a, b, c] = [range(column - 1), range(column), range(column + 1)];
        spread[column] = a.1.max(b.1).max(c.1) - a.0.min(b.0).min(c.0);
    }
    for column in [0, width - 1] {
        let parts = [
            column.saturating_sub(1),
            column,
            (column + 1).min(width - 1),
        ]
        .map(range);
        let low = parts.iter().map(|part| part.0).min().unwrap_or(0);
        let high = parts.iter().map(|part| part.1).max().unwrap_or(0);
        spread[column] = high - low;
    }
}

#[inline(always)]
fn weighted_median(
    table: &[[u16; WINDOW]],
    map: &[u16],
    view: &View,
    column: usize,
    row: isize,
) -> u16 {
    let width = view.width();
    let last = width.cast_signed() - 1;
    let height = view.height().cast_signed();
    let mut values = [u16::MAX; PADDED];
    let mut weights = [0u16; PADDED];
    let level = view.row(row.cast_unsigned())[column];
    for dy in 0..SIDE {
        let y = (row + dy.cast_signed() - REACH).clamp(0, height - 1);
        let disparities = clamped_row(map, width, y);
        let levels = view.row(y.cast_unsigned());
        for dx in 0..SIDE {
            let x = (column.cast_signed() + dx.cast_signed() - REACH).clamp(0, last);
            let (x, place) = (x.cast_unsigned(), dy * SIDE + dx);
            values[place] = disparities[x];
            weights[place] = table[usize::from(levels[x].abs_diff(level))][place];
        }
    }
    let total: u32 = weights.iter().map(|w| u32::from(*w)).sum();
    let half = total.div_ceil(2) as u16;
    // The smallest number at or below which half of the weight lies, by bisection.
    let mut low = values.iter().copied().min().unwrap_or(0);
    let mut high = values[..WINDOW].iter().copied().max().unwrap_or(0);
    while low < high {
        let middle = low + (high - low) / 2;
        let mut below = 0u16;
        for lane in 0..PADDED {
            below += if values[lane] <= middle {
                weights[lane]
            } else {
                0
            };
        }
        if below >= half {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    low
}
