//! One step along a path of semi-global matching (H. Hirschmüller, "Stereo processing by semiglobal
//! matching and mutual information", IEEE Transactions on Pattern Analysis and Machine Intelligence
//! 30, 2008).

use super::cost::{HIGHEST, NEVER};
use super::lanes::{Block, LANES, least};

/// The penalties for a change of the disparity from one pixel to the next.
#[derive(Clone, Debug)]
pub(super) struct Penalties {
    /// P₁, for a change by 1.
    small: u8,
    /// P₂, for any other change, by the difference of the levels of the two pixels.
    large: [u8; 256],
}

impl Penalties {
    /// P₁ = 12 k, P₂ = 60 k / (1 + ⌊g / (4 + `noise`)⌋) for a difference g, at least P₁ + 2 and at
    /// most 150. k rises with the median of the least costs of all pixels, which is large where the
    /// views are noisy or do not fit.
    pub(super) fn new(median_cost: u8, noise: f32) -> Self {
        let k = (f32::from(median_cost) / 6.0).clamp(1.0, 3.0);
        let small = (12.0 * k).round();
        let large = |difference: usize| {
            let steps = (difference as f32 / (4.0 + noise)).floor();
            (60.0 * k / (1.0 + steps)).clamp(small + 2.0, 150.0) as u8
        };
        let penalties = Self {
            small: small as u8,
            large: std::array::from_fn(large),
        };
        // Path costs are at most a cost plus P₂, and fit in bytes.
        debug_assert!(
            penalties
                .large
                .iter()
                .all(|p| p.checked_add(HIGHEST).is_some())
        );
        penalties
    }

    /// P₂ between two pixels.
    #[inline(always)]
    fn between(&self, level: u8, previous: u8) -> u8 {
        self.large[usize::from(level.abs_diff(previous))]
    }
}

/// The costs of paths that arrive at the pixels of a row: for each pixel a number for each
/// disparity and a margin before them, which is also that behind those of the pixel before. The
/// costs of each pixel are known up to a constant, since only differences count.
#[derive(Clone, Debug)]
pub(super) struct PathRow {
    values: Vec<u8>,
    least: Vec<u8>,
    stride: usize,
}

impl PathRow {
    /// For `width` pixels with `range` numbers each, a whole number of blocks.
    pub(super) fn new(width: usize, range: usize) -> Self {
        let stride = range + 1;
        Self {
            values: vec![NEVER; width * stride + 1],
            least: vec![0; width],
            stride,
        }
    }

    /// The path costs of a pixel.
    #[inline(always)]
    pub(super) fn pixel(&self, column: usize) -> &[u8] {
        &self.values[column * self.stride + 1..][..self.stride - 1]
    }

    /// Begins a path at a pixel: its path costs are its matching costs.
    #[inline(always)]
    pub(super) fn begin(&mut self, column: usize, costs: &[u8]) {
        let range = self.stride - 1;
        let values = &mut self.values[column * self.stride + 1..][..range];
        values.copy_from_slice(&costs[..range]);
        let mut smallest: Block = [u8::MAX; LANES];
        for block in values.as_chunks::<LANES>().0 {
            for lane in 0..LANES {
                smallest[lane] = smallest[lane].min(block[lane]);
            }
        }
        self.least[column] = least(smallest);
    }

    /// Continues a path from `previous`, a pixel of another row:
    ///
    /// L(d) = C(d) + min(L′(d), L′(d − 1) + P₁, L′(d + 1) + P₁, min L′ + P₂) − min L′.
    #[inline(always)]
    pub(super) fn advance(
        &mut self,
        column: usize,
        costs: &[u8],
        previous: (&Self, usize),
        penalties: &Penalties,
        levels: [u8; 2],
    ) {
        let (row, from) = previous;
        let before = &row.values[from * self.stride..][..self.stride + 1];
        let values = &mut self.values[column * self.stride + 1..][..self.stride - 1];
        let p2 = penalties.between(levels[0], levels[1]);
        self.least[column] = step(costs, before, row.least[from], penalties.small, p2, values);
    }

    /// Continues a path from a pixel of the same row.
    #[inline(always)]
    pub(super) fn advance_within(
        &mut self,
        column: usize,
        costs: &[u8],
        from: usize,
        penalties: &Penalties,
        levels: [u8; 2],
    ) {
        let stride = self.stride;
        let p2 = penalties.between(levels[0], levels[1]);
        let least_before = self.least[from];
        // The margin between two neighbours belongs to both, and is only read.
        let (before, values): (&[u8], &mut [u8]) = if from < column {
            let (low, high) = self.values.split_at_mut(column * stride + 1);
            (&low[from * stride..][..stride + 1], &mut high[..stride - 1])
        } else {
            let (low, high) = self.values.split_at_mut(from * stride);
            (
                &high[..stride + 1],
                &mut low[column * stride + 1..][..stride - 1],
            )
        };
        self.least[column] = step(costs, before, least_before, penalties.small, p2, values);
    }
}

/// One step, from path costs with a margin on both sides; returns the least of the new ones.
#[inline(always)]
pub(super) fn step(
    costs: &[u8],
    before: &[u8],
    least_before: u8,
    p1: u8,
    p2: u8,
    after: &mut [u8],
) -> u8 {
    let range = after.len();
    let limit = least_before.saturating_add(p2);
    let below = before[..range].as_chunks::<LANES>().0;
    let same = before[1..][..range].as_chunks::<LANES>().0;
    let above = before[2..][..range].as_chunks::<LANES>().0;
    let costs = costs[..range].as_chunks::<LANES>().0;
    let after = after.as_chunks_mut::<LANES>().0;
    let mut smallest: Block = [u8::MAX; LANES];
    let neighbours = below.iter().zip(same).zip(above);
    for (((below, same), above), (cost, after)) in neighbours.zip(costs.iter().zip(after)) {
        let mut next: Block = [0; LANES];
        for lane in 0..LANES {
            let changed = below[lane].min(above[lane]).saturating_add(p1);
            let best = same[lane].min(changed).min(limit);
            next[lane] = best.saturating_sub(least_before).saturating_add(cost[lane]);
        }
        for lane in 0..LANES {
            smallest[lane] = smallest[lane].min(next[lane]);
        }
        *after = next;
    }
    least(smallest)
}
