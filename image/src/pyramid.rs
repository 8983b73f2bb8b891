//! Gaussian pyramids: a picture at half, a quarter, an eighth of its size, and so on.

use crate::filter::{Border, Continued};
use crate::plane::{Plane, PlaneView};
use crate::sample::{Pixel, Sample};

const WEIGHTS: [f32; 5] = [1.0, 4.0, 6.0, 4.0, 1.0];
const RADIUS: usize = 2;

/// A picture and its halved versions, each made by [`halved`] from the one before.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_image::pyramid::Pyramid;
///
/// let pyramid = Pyramid::new(&Plane::filled(100, 31, 7u8), 4);
/// let sizes: Vec<_> = pyramid.levels().iter().map(|l| (l.width(), l.height())).collect();
/// assert_eq!(sizes, [(100, 31), (50, 16), (25, 8), (13, 4)]);
/// assert_eq!(pyramid.levels()[3].get(12, 3), Some(7));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Pyramid<P> {
    levels: Vec<Plane<P>>,
}

impl<P: Pixel> Pyramid<P> {
    /// The picture and its halved versions: `levels` in all, or fewer where one of a single pixel
    /// is reached.
    #[must_use]
    pub fn new<'a>(picture: impl Into<PlaneView<'a, P>>, levels: usize) -> Self {
        let mut made: Vec<Plane<P>> = Vec::new();
        if levels > 0 {
            made.push(picture.into().to_plane());
        }
        while let Some(last) = made.last() {
            if made.len() >= levels || last.width().max(last.height()) <= 1 {
                break;
            }
            let next = halved(last);
            made.push(next);
        }
        Self { levels: made }
    }

    /// The pictures, the original first.
    #[must_use]
    pub fn levels(&self) -> &[Plane<P>] {
        &self.levels
    }
}

/// The picture at half its size, rounded up: the binomial filter [1 4 6 4 1] / 16 along both axes,
/// then every second column and row, from the first. The border is mirrored at the centre of the
/// outermost pixels ([`Border::Mirror`]). So the centre of pixel *i* here is that of pixel 2*i*
/// there. OpenCV's `pyrDown` does the same; for integers the results are equal, with halves rounded
/// up.
#[must_use]
pub fn halved<'a, P: Pixel>(picture: impl Into<PlaneView<'a, P>>) -> Plane<P> {
    let picture = picture.into();
    let (width, height) = (picture.width().div_ceil(2), picture.height().div_ceil(2));
    let mut result = Plane::filled(width, height, P::default());
    if picture.is_empty() {
        return result;
    }
    let mut continued = Continued::new(picture.width(), RADIUS, Border::Mirror);
    // Row `i` along rows is in place `i % 5`.
    let mut ring = [(); 5].map(|()| vec![0.0f32; width * P::CHANNELS]);
    let mut ready = 0;
    for row in 0..height {
        while ready < picture.height() && ready <= 2 * row + RADIUS {
            let source = continued.row(P::samples(picture.row(ready)), P::CHANNELS);
            halve_row(source, &mut ring[ready % 5], P::CHANNELS);
            ready += 1;
        }
        let rows: [&[f32]; 5] = std::array::from_fn(|place| {
            let index = (2 * row + place).cast_signed() - RADIUS.cast_signed();
            ring[Border::Mirror.index(index, picture.height()) % 5].as_slice()
        });
        let target = P::samples_mut(result.row_mut(row));
        for (i, target) in target.iter_mut().enumerate() {
            let sum = (0..5)
                .map(|place| WEIGHTS[place] * rows[place][i])
                .sum::<f32>();
            // Sums of 16-bit numbers and weights stay below 2²⁴, so that integers are exact.
            *target = P::Sample::from_f32(sum * (1.0 / 256.0));
        }
    }
    result
}

fn halve_row(source: &[f32], target: &mut [f32], channels: usize) {
    for (column, target) in target.chunks_exact_mut(channels).enumerate() {
        let window = &source[2 * column * channels..][..5 * channels];
        for (channel, target) in target.iter_mut().enumerate() {
            let sample = |place: usize| WEIGHTS[place] * window[place * channels + channel];
            *target = (0..5).map(sample).sum();
        }
    }
}
