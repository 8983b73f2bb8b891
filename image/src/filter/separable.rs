//! Convolution along rows, then along columns, with one row in memory for each weight.

use super::Border;
use crate::plane::{Plane, PlaneView};
use crate::sample::{Pixel, Sample};

/// Convolves with the same symmetric weights along both axes; `weights` has an odd length.
pub(super) fn convolve<P: Pixel>(
    picture: PlaneView<'_, P>,
    weights: &[f32],
    border: Border,
) -> Plane<P> {
    let (width, height) = (picture.width(), picture.height());
    let mut convolved = Plane::filled(width, height, P::default());
    if picture.is_empty() {
        return convolved;
    }
    let radius = weights.len() / 2;
    let row_length = width * P::CHANNELS;
    let mut continued = Continued::new(width, radius, border);
    // Row `i` along rows is in place `i % weights.len()`. The rows that a row of the result needs
    // lie within `radius` of it, since borders reflect to the inside.
    let mut ring = vec![vec![0.0f32; row_length]; weights.len()];
    let mut sums = vec![0.0f32; row_length];
    let mut ready = 0;
    for row in 0..height {
        while ready < height && ready <= row + radius {
            let source = continued.row(P::samples(picture.row(ready)), P::CHANNELS);
            let target = &mut ring[ready % weights.len()];
            target.fill(0.0);
            for (place, weight) in weights.iter().enumerate() {
                add_scaled(target, &source[place * P::CHANNELS..], *weight);
            }
            ready += 1;
        }
        sums.fill(0.0);
        for (place, weight) in weights.iter().enumerate() {
            let index = (row + place).cast_signed() - radius.cast_signed();
            let source = border.index(index, height) % weights.len();
            add_scaled(&mut sums, &ring[source], *weight);
        }
        let target = P::samples_mut(convolved.row_mut(row));
        for (target, sum) in target.iter_mut().zip(&sums) {
            *target = P::Sample::from_f32(*sum);
        }
    }
    convolved
}

/// Adds `weight` times the numbers of `from`, which may be longer.
#[inline]
pub(crate) fn add_scaled(to: &mut [f32], from: &[f32], weight: f32) {
    for (to, from) in to.iter_mut().zip(from) {
        *to += weight * from;
    }
}

/// Rows as floats, continued on both sides.
pub(crate) struct Continued {
    /// The columns that stand before the first and after the last.
    before: Vec<usize>,
    after: Vec<usize>,
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
            samples: Vec::new(),
        }
    }

    /// The row, continued.
    pub(crate) fn row<S: Sample>(&mut self, row: &[S], channels: usize) -> &[f32] {
        let pixel = |column: usize| {
            let samples = &row[column * channels..][..channels];
            samples.iter().map(|sample| sample.to_f32())
        };
        self.samples.clear();
        for column in &self.before {
            self.samples.extend(pixel(*column));
        }
        self.samples
            .extend(row.iter().map(|sample| sample.to_f32()));
        for column in &self.after {
            self.samples.extend(pixel(*column));
        }
        &self.samples
    }
}
