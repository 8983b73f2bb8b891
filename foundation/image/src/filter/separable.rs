//! Convolution along rows, then along columns, with one row in memory for each weight.

use ga_runtime::batch::{Batch, Work};

use super::Border;
use crate::plane::{Plane, PlaneView};
use crate::sample::{Pixel, Sample};

/// Convolves with the same symmetric weights along both axes. `weights` are those of the middle and
/// of the pixels at rising distances from it; there is at least one.
pub(super) fn convolve<P: Pixel>(
    picture: PlaneView<'_, P>,
    weights: &[f32],
    border: Border,
) -> Plane<P> {
    let mut convolved = Plane::filled(picture.width(), picture.height(), P::default());
    if !picture.is_empty() {
        Batch::new().run(Convolution {
            picture,
            weights,
            border,
            convolved: &mut convolved,
        });
    }
    convolved
}

struct Convolution<'a, P> {
    picture: PlaneView<'a, P>,
    weights: &'a [f32],
    border: Border,
    convolved: &'a mut Plane<P>,
}

impl<P: Pixel> Work for Convolution<'_, P> {
    #[inline(always)]
    fn run(self) {
        let (width, height) = (self.picture.width(), self.picture.height());
        let radius = self.weights.len() - 1;
        let slots = 2 * radius + 1;
        let row_length = width * P::CHANNELS;
        let mut continued = Continued::new(width, radius, self.border);
        // Row `i` along rows is in place `i % slots`. The rows that a row of the result needs lie
        // within `radius` of it, since borders reflect to the inside.
        let mut ring = vec![vec![0.0f32; row_length]; slots];
        let mut sums = vec![0.0f32; row_length];
        let mut ready = 0;
        for row in 0..height {
            while ready < height && ready <= row + radius {
                let source = continued.row(P::CHANNELS, |floats| {
                    P::Sample::to_floats(P::samples(self.picture.row(ready)), floats);
                });
                let at = |column: usize| &source[column * P::CHANNELS..];
                let pair = |d: usize| (at(radius - d), at(radius + d));
                weighted_sum(&mut ring[ready % slots], self.weights, pair);
                ready += 1;
            }
            let at = |offset: usize| {
                let index = (row + offset).cast_signed() - radius.cast_signed();
                ring[self.border.index(index, height) % slots].as_slice()
            };
            weighted_sum(&mut sums, self.weights, |d| {
                (at(radius - d), at(radius + d))
            });
            let target = P::samples_mut(self.convolved.row_mut(row));
            for (target, sum) in target.iter_mut().zip(&sums) {
                *target = P::Sample::from_f32(*sum);
            }
        }
    }
}

/// The sum of the numbers in the middle and of those at each distance on both sides, weighted.
#[inline(always)]
fn weighted_sum<'a>(
    sums: &mut [f32],
    weights: &[f32],
    pair: impl Fn(usize) -> (&'a [f32], &'a [f32]),
) {
    for (d, weight) in weights.iter().enumerate() {
        let (before, after) = pair(d);
        if d == 0 {
            for (sum, middle) in sums.iter_mut().zip(before) {
                *sum = weight * middle;
            }
        } else {
            for ((sum, before), after) in sums.iter_mut().zip(before).zip(after) {
                *sum += weight * (before + after);
            }
        }
    }
}

/// Rows of floats, continued on both sides.
pub(crate) struct Continued {
    /// The columns that stand before the first and after the last.
    before: Vec<usize>,
    after: Vec<usize>,
    width: usize,
    samples: Vec<f32>,
}

impl Continued {
    /// For rows of `width` pixels, continued by `radius` pixels on either side.
    pub(crate) fn new(width: usize, radius: usize, border: Border) -> Self {
        let (columns, reach) = (width.cast_signed(), radius.cast_signed());
        let indices =
            |range: std::ops::Range<isize>| range.map(|index| border.index(index, width)).collect();
        Self {
            before: indices(-reach..0),
            after: indices(columns..columns + reach),
            width,
            samples: Vec::new(),
        }
    }

    /// The row that `fill` writes, continued.
    #[inline(always)]
    pub(crate) fn row(&mut self, channels: usize, fill: impl FnOnce(&mut [f32])) -> &[f32] {
        let start = self.before.len() * channels;
        let end = start + self.width * channels;
        self.samples.resize(end + self.after.len() * channels, 0.0);
        fill(&mut self.samples[start..end]);
        let outside = [(0, &self.before), (end, &self.after)];
        for (place, columns) in outside {
            for (offset, column) in columns.iter().enumerate() {
                let pixel = start + column * channels;
                self.samples
                    .copy_within(pixel..pixel + channels, place + offset * channels);
            }
        }
        &self.samples
    }
}
