//! The strips of rows in which a view is matched, and their memory.

use std::ops::Range;

use ga_runtime::batch::{Batch, Work};
use rayon::prelude::*;

use super::cost::{Candidates, pixel_costs};
use super::features::Features;
use super::lanes::LANES;
use super::parts::Spare;
use super::sweep::{Found, Scratch, Sweep, Task, WARM_UP};
use super::view::View;

/// The height of a strip, about: where costs are averaged over regions, the rows above and below it
/// that have to be computed as well are more.
const STRIP: [usize; 2] = [128, 240];
/// The bytes that the strips computed at the same time may need, without and with regions; two
/// strips may always.
const AT_ONCE: [usize; 2] = [12 << 20, 64 << 20];
/// The bytes that are kept for the next pair.
const KEPT: usize = 16 << 20;
/// Of this many rows, one is looked at for the median cost.
const SAMPLED: usize = 12;
/// The sampled rows that are computed together.
const TOGETHER: usize = 4;

/// The strips of rows of a view, and memory for those that are computed at the same time.
#[derive(Debug)]
pub(super) struct Strips {
    width: usize,
    height: usize,
    range: usize,
    has_support: bool,
    spare: Spare<Scratch>,
}

impl Strips {
    pub(super) fn new(width: usize, height: usize, range: usize, has_support: bool) -> Self {
        Self {
            width,
            height,
            range,
            has_support,
            spare: Spare::default(),
        }
    }

    /// The rows of each strip; they do not depend on the number of threads. An even number of
    /// strips of the same work, in which rows above count as well, keeps two threads busy to the
    /// end.
    fn rows(&self) -> impl Iterator<Item = Range<usize>> + use<> {
        let strip = STRIP[usize::from(self.has_support)];
        let pairs = (self.height + strip) / (2 * strip);
        let count = (2 * pairs).max(1);
        let work = self.height + (count - 1) * WARM_UP;
        let start = move |strip: usize| strip * work / count - strip.saturating_sub(1) * WARM_UP;
        (0..count).map(move |strip| start(strip)..start(strip + 1))
    }

    /// Makes the memory for matching with a number of threads.
    pub(super) fn prepare(&self, threads: usize) {
        let most = (AT_ONCE[usize::from(self.has_support)] / self.scratch_bytes()).max(2);
        let count = most.min(threads).min(2 * self.rows().count());
        let new = || Scratch::new(self.width, self.range, self.has_support);
        self.spare.prepare(count, new, |_| ());
    }

    /// Gives memory back where it is much.
    pub(super) fn release(&self) {
        self.spare.keep_at_most(KEPT, self.scratch_bytes());
    }

    fn scratch_bytes(&self) -> usize {
        Scratch::bytes(self.width, self.range, self.has_support)
    }

    /// Matches all strips of some passes.
    pub(super) fn run<'a>(&self, passes: impl IntoIterator<Item = (Task<'a>, Found<'a>)>) {
        let mut strips = Vec::new();
        for (task, mut found) in passes {
            for rows in self.rows() {
                let found = found.split_off(rows.len() * self.width);
                strips.push((task, rows, found));
            }
        }
        let batch = Batch::new();
        self.spare.compute(strips, |(task, rows, found), scratch| {
            batch.run(Sweep {
                task,
                rows,
                scratch,
                found,
            });
        });
    }

    /// The median of the least costs of the pixels in a sample of the rows.
    pub(super) fn median_cost(&self, reference: &View, other: &View, range: usize) -> u8 {
        let rows: Vec<usize> = (SAMPLED / 2..self.height).step_by(SAMPLED).collect();
        let counted = rows.par_chunks(TOGETHER).map(|rows| {
            let mut counts = [0; 256];
            Batch::new().run(Sample {
                reference,
                other,
                range,
                rows,
                counts: &mut counts,
            });
            counts
        });
        let sum = |a: [u32; 256], b: [u32; 256]| std::array::from_fn(|cost| a[cost] + b[cost]);
        let counts = counted.reduce(|| [0; 256], sum);
        let total: u32 = counts.iter().sum();
        let mut below = 0;
        let median = counts.iter().position(|count| {
            below += count;
            2 * below >= total
        });
        median.unwrap_or(0) as u8
    }
}

/// Counts the least costs of the pixels of some rows.
struct Sample<'a> {
    reference: &'a View,
    other: &'a View,
    range: usize,
    rows: &'a [usize],
    counts: &'a mut [u32; 256],
}

impl Work for Sample<'_> {
    const WIDE: bool = true;

    #[inline(always)]
    fn run(self) {
        let width = self.reference.width();
        let stride = self.range.next_multiple_of(LANES);
        let [mut left, mut right] = [(); 2].map(|()| Features::new(width, stride));
        let candidates = Candidates::new([self.reference, self.other], self.range, 0);
        let mut costs = vec![0; stride];
        for row in self.rows {
            left.compute(self.reference, *row);
            right.compute(self.other, *row);
            for column in 0..width {
                pixel_costs(&left, &right, width, column, &mut costs);
                let inside = &costs[candidates.of(column)];
                if !inside.is_empty() {
                    let least = inside.iter().fold(u8::MAX, |least, cost| least.min(*cost));
                    self.counts[usize::from(least)] += 1;
                }
            }
        }
    }
}
