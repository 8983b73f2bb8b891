//! The strips of rows in which a view is matched, and their memory.

use std::ops::Range;
use std::sync::{Mutex, PoisonError};

use ga_runtime::batch::{Batch, Work};
use rayon::prelude::*;

use super::cost::pixel_costs;
use super::features::Features;
use super::lanes::LANES;
use super::sweep::{Found, Scratch, Sweep, Task};
use super::view::View;

/// The height of a strip, about: where costs are averaged over regions, the rows above and below it
/// that have to be computed as well are more.
const STRIP: [usize; 2] = [128, 240];
/// Of this many rows, one is looked at for the median cost.
const SAMPLED: usize = 12;

/// The strips of rows of a view, and memory for as many as are computed at the same time.
#[derive(Debug)]
pub(super) struct Strips {
    width: usize,
    height: usize,
    range: usize,
    has_support: bool,
    spare: Mutex<Vec<Scratch>>,
}

impl Strips {
    pub(super) fn new(width: usize, height: usize, range: usize, has_support: bool) -> Self {
        Self {
            width,
            height,
            range,
            has_support,
            spare: Mutex::default(),
        }
    }

    /// The rows of each strip; they do not depend on the number of threads.
    fn rows(&self) -> impl Iterator<Item = Range<usize>> {
        let strip = STRIP[usize::from(self.has_support)];
        let count = ((self.height + strip / 2) / strip).max(1);
        let height = self.height;
        (0..count).map(move |strip| strip * height / count..(strip + 1) * height / count)
    }

    /// Matches all strips.
    pub(super) fn run(
        &self,
        task: Task<'_>,
        mut disparities: &mut [u16],
        mut confidence: &mut [u8],
        mut opposite: &mut [u16],
    ) {
        let mut strips = Vec::new();
        for rows in self.rows() {
            let pixels = rows.len() * self.width;
            let found = Found {
                disparities: split_off(&mut disparities, pixels),
                confidence: split_off(&mut confidence, pixels),
                opposite: split_off(&mut opposite, pixels),
            };
            strips.push((rows, found));
        }
        let batch = Batch::new();
        strips.into_par_iter().for_each(|(rows, found)| {
            let mut scratch = self.scratch();
            batch.run(Sweep {
                task,
                rows,
                scratch: &mut scratch,
                found,
            });
            self.spare().push(scratch);
        });
    }

    fn scratch(&self) -> Scratch {
        let spare = self.spare().pop();
        spare.unwrap_or_else(|| Scratch::new(self.width, self.range, self.has_support))
    }

    fn spare(&self) -> std::sync::MutexGuard<'_, Vec<Scratch>> {
        self.spare.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The median of the least costs of the pixels in a sample of the rows.
    pub(super) fn median_cost(&self, reference: &View, other: &View, range: usize) -> u8 {
        let mut counts = [0; 256];
        Batch::new().run(Sample {
            reference,
            other,
            range,
            counts: &mut counts,
        });
        let total: u32 = counts.iter().sum();
        let mut below = 0;
        let median = counts.iter().position(|count| {
            below += count;
            2 * below >= total
        });
        median.unwrap_or(0) as u8
    }
}

/// The first numbers of a slice, which then begins behind them.
fn split_off<'a, T>(slice: &mut &'a mut [T], length: usize) -> &'a mut [T] {
    let (first, rest) = std::mem::take(slice).split_at_mut(length);
    *slice = rest;
    first
}

/// Counts the least costs of pixels.
struct Sample<'a> {
    reference: &'a View,
    other: &'a View,
    range: usize,
    counts: &'a mut [u32; 256],
}

impl Work for Sample<'_> {
    #[inline(always)]
    fn run(self) {
        let width = self.reference.width();
        let stride = self.range.next_multiple_of(LANES);
        let [mut left, mut right] = [(); 2].map(|()| Features::new(width, stride));
        let mut costs = vec![0; stride];
        for row in (SAMPLED / 2..self.reference.height()).step_by(SAMPLED) {
            left.compute(self.reference, row);
            right.compute(self.other, row);
            for column in 0..width {
                pixel_costs(&left, &right, width, column, &mut costs);
                let seen = self.range.min(column + 1);
                let least = costs[..seen].iter().copied().min().unwrap_or(0);
                self.counts[usize::from(least)] += 1;
            }
        }
    }
}
