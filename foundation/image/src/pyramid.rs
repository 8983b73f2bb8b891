//! Gaussian pyramids: a picture at half, a quarter, an eighth of its size, and so on.

use ga_runtime::batch::{Batch, Work};

use crate::filter::{Border, Continued};
use crate::plane::{Plane, PlaneView};
use crate::sample::{Pixel, Sample};

/// Neighbours on either side that take part.
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
    P::halved(picture.into())
}

/// As [`halved`], compiled where it is called.
pub(crate) fn by_filter<P: Pixel>(picture: PlaneView<'_, P>) -> Plane<P> {
    let (width, height) = (picture.width().div_ceil(2), picture.height().div_ceil(2));
    let mut result = Plane::filled(width, height, P::default());
    if !picture.is_empty() {
        Batch::new().run(Halving {
            picture,
            result: &mut result,
        });
    }
    result
}

struct Halving<'a, P> {
    picture: PlaneView<'a, P>,
    result: &'a mut Plane<P>,
}

impl<P: Pixel> Work for Halving<'_, P> {
    #[inline(always)]
    fn run(self) {
        let length = self.picture.width() * P::CHANNELS;
        let mut continued = Continued::new(self.picture.width(), RADIUS, Border::Mirror);
        let columns = self.result.width() * P::CHANNELS;
        // The columns of even and of odd index, each in a row of its own, so that the loop over
        // them is one over neighbours in memory.
        let mut even = vec![0.0; columns + 2 * P::CHANNELS];
        let mut odd = vec![0.0; columns + P::CHANNELS];
        for row in 0..self.result.height() {
            let [a, b, c, d, e]: [&[P::Sample]; 5] = std::array::from_fn(|place| {
                let index = (2 * row + place).cast_signed() - RADIUS.cast_signed();
                let row = Border::Mirror.index(index, self.picture.height());
                &P::samples(self.picture.row(row))[..length]
            });
            let source = continued.row(P::CHANNELS, |sums| {
                let outer = a.iter().zip(e);
                let rows = outer.zip(b.iter().zip(d)).zip(c);
                for (sum, (((a, e), (b, d)), c)) in sums.iter_mut().zip(rows) {
                    *sum = weighted_sum([*a, *b, *c, *d, *e].map(P::Sample::to_f32));
                }
            });
            separate(source, P::CHANNELS, &mut even, &mut odd);
            let target = P::samples_mut(self.result.row_mut(row));
            let outer = even.iter().zip(&even[2 * P::CHANNELS..]);
            let inner = odd.iter().zip(&odd[P::CHANNELS..]);
            let numbers = outer.zip(inner).zip(&even[P::CHANNELS..]);
            for (target, (((a, e), (b, d)), c)) in target.iter_mut().zip(numbers) {
                // Sums of 16-bit numbers and weights stay below 2²⁴, so that integers are exact.
                *target = P::Sample::from_f32(weighted_sum([*a, *b, *c, *d, *e]) * (1.0 / 256.0));
            }
        }
    }
}

/// Copies pixels of even index to `even`, and those of odd index, one fewer, to `odd`.
#[inline(always)]
fn separate(pixels: &[f32], channels: usize, even: &mut [f32], odd: &mut [f32]) {
    let last = even.len() - channels;
    even[last..].copy_from_slice(&pixels[2 * last..][..channels]);
    let halves = even
        .chunks_exact_mut(channels)
        .zip(odd.chunks_exact_mut(channels));
    for (pair, (even, odd)) in pixels.chunks_exact(2 * channels).zip(halves) {
        even.copy_from_slice(&pair[..channels]);
        odd.copy_from_slice(&pair[channels..]);
    }
}

/// By [1 4 6 4 1].
#[inline(always)]
fn weighted_sum([a, b, c, d, e]: [f32; 5]) -> f32 {
    (a + e) + 4.0 * (b + d) + 6.0 * c
}
