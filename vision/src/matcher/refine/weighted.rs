//! The weighted median at edges of the map.

use ga_runtime::batch::{Batch, Work};

use super::super::cost::difference;
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
    const WIDE: bool = true;

    #[inline(always)]
    fn run(self) {
        let width = self.view.width();
        let mut spread = vec![0; width];
        let mut extremes = [vec![0; width + 2], vec![0; width + 2]];
        for (index, medians) in self.rows.chunks_exact_mut(width).enumerate() {
            let row = (self.first + index).cast_signed();
            let lines = [
                clamped_row(self.map, width, row - 1),
                clamped_row(self.map, width, row),
                clamped_row(self.map, width, row + 1),
            ];
            spreads(lines, &mut extremes, &mut spread);
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
fn spreads(lines: [&[u16]; 3], extremes: &mut [Vec<u16>; 2], spread: &mut [u16]) {
    let width = spread.len();
    let [above, middle, below] = lines;
    let [low, high] = extremes;
    {
        let (low, high) = (&mut low[1..=width], &mut high[1..=width]);
        for column in 0..width {
            let (a, b, c) = (above[column], middle[column], below[column]);
            low[column] = a.min(b).min(c);
            high[column] = a.max(b).max(c);
        }
    }
    for row in [&mut *low, &mut *high] {
        row[0] = row[1];
        row[width + 1] = row[width];
    }
    let (low, high) = (&low[..width + 2], &high[..width + 2]);
    for column in 0..width {
        let least = low[column].min(low[column + 1]).min(low[column + 2]);
        let greatest = high[column].max(high[column + 1]).max(high[column + 2]);
        spread[column] = greatest - least;
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
    let is_inside = (REACH..=last - REACH).contains(&column.cast_signed());
    for dy in 0..SIDE {
        let y = (row + dy.cast_signed() - REACH).clamp(0, height - 1);
        let disparities = clamped_row(map, width, y);
        let levels = view.row(y.cast_unsigned());
        if is_inside {
            let start = column - REACH as usize;
            let (disparities, levels) = (&disparities[start..][..SIDE], &levels[start..][..SIDE]);
            for dx in 0..SIDE {
                let place = dy * SIDE + dx;
                values[place] = disparities[dx];
                let gap = difference(levels[dx], level);
                weights[place] = table[usize::from(gap)][place];
            }
        } else {
            for dx in 0..SIDE {
                let x = (column.cast_signed() + dx.cast_signed() - REACH).clamp(0, last);
                let (x, place) = (x.cast_unsigned(), dy * SIDE + dx);
                values[place] = disparities[x];
                weights[place] = table[usize::from(difference(levels[x], level))][place];
            }
        }
    }
    let total: u32 = weights.iter().map(|w| u32::from(*w)).sum();
    let half = total.div_ceil(2) as u16;
    // The smallest number at or below which half of the weight lies, by bisection.
    let (mut low, mut high) = (u16::MAX, 0);
    for value in &values[..WINDOW] {
        low = low.min(*value);
        high = high.max(*value);
    }
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
