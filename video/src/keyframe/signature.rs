//! A frame as a few numbers: its red, averaged over boxes.

use ga_image::plane::{Plane, PlaneView};
use ga_image::ycbcr::{Range, YCbCr};
use ga_runtime::batch::{Batch, Work};

use crate::{Planes, Samples};

/// Columns and rows of a signature; fewer where the frame has fewer.
pub const SIZE: [usize; 2] = [64, 36];

/// The number of rows of bytes whose sums fit into 16 bits.
const ROWS: usize = 257;

/// The red component of a frame, from 0 to 255, averaged over 64 × 36 boxes.
///
/// Red is a linear function of luma and of the colour difference Cr, so that both are averaged as
/// they are stored, and no pixel is converted. Means outside 0 to 255 become the nearest number in
/// it. Cui, §3.1.2, takes the red component because the three are highly similar.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_image::ycbcr::YCbCr;
/// use ga_video::keyframe::signature;
/// use ga_video::{Planes, Samples};
///
/// let white = Planes {
///     luma: Plane::filled(320, 180, 235_u8),
///     differences: [Plane::filled(160, 90, 128), Plane::filled(160, 90, 128)],
/// };
/// let red = signature::red(&Samples::Eight(white), YCbCr::default());
/// assert_eq!([red.width(), red.height()], [64, 36]);
/// assert!(red.values().iter().all(|value| (value - 255.0).abs() < 1e-3));
/// ```
#[must_use]
pub fn red(samples: &Samples, colours: YCbCr) -> Plane<f32> {
    let (width, height) = (
        SIZE[0].min(samples.size()[0]),
        SIZE[1].min(samples.size()[1]),
    );
    match samples {
        Samples::Eight(planes) => combined(planes, [width, height], colours, 1.0),
        Samples::Ten(planes) => combined(planes, [width, height], colours, 0.25),
    }
}

/// The means of a plane over boxes, as many as the columns and rows of `size`. Boxes differ by at
/// most one pixel in size; where the plane has fewer pixels than boxes, some share a pixel.
#[must_use]
pub fn box_means<S: Sample>(plane: PlaneView<'_, S>, size: [usize; 2]) -> Plane<f32> {
    let mut means = Plane::filled(size[0], size[1], 0.0);
    box_means_into(plane, &mut means);
    means
}

/// As [`box_means`], written to a plane with as many columns and rows as there are boxes. A plane
/// without pixels leaves it as it is.
pub fn box_means_into<S: Sample>(plane: PlaneView<'_, S>, means: &mut Plane<f32>) {
    if !plane.is_empty() {
        Batch::new().run(BoxMeans { plane, means });
    }
}

/// The numbers of planes: 8 bits, or 10 bits in 16.
pub trait Sample: Copy + Into<u32> + Default {
    /// Adds a row to sums, where at most [`ROWS`] rows of the greatest number are added.
    #[doc(hidden)]
    fn add(row: &[Self], sums: &mut [u16]);
    /// How many rows may be added.
    #[doc(hidden)]
    const ROWS: usize;
}

impl Sample for u8 {
    const ROWS: usize = ROWS;

    #[inline(always)]
    fn add(row: &[Self], sums: &mut [u16]) {
        for (sum, value) in sums.iter_mut().zip(row) {
            *sum += u16::from(*value);
        }
    }
}

impl Sample for u16 {
    // 64 · 1023 is less than 2¹⁶.
    const ROWS: usize = 64;

    #[inline(always)]
    fn add(row: &[Self], sums: &mut [u16]) {
        for (sum, value) in sums.iter_mut().zip(row) {
            // Numbers of 10 bits, whatever the plane has.
            *sum += (*value).min(1023);
        }
    }
}

struct BoxMeans<'a, 'm, S> {
    plane: PlaneView<'a, S>,
    means: &'m mut Plane<f32>,
}

impl<S: Sample> Work for BoxMeans<'_, '_, S> {
    #[inline(always)]
    fn run(self) {
        let (width, height) = (self.plane.width(), self.plane.height());
        let (columns, rows) = (self.means.width(), self.means.height());
        let columns_of: Vec<[usize; 2]> = (0..columns).map(|i| range(i, columns, width)).collect();
        let mut sums = vec![0_u16; width];
        let mut totals = vec![0_u32; columns];
        for row in 0..rows {
            let [top, bottom] = range(row, rows, height);
            totals.fill(0);
            for start in (top..bottom).step_by(S::ROWS) {
                sums.fill(0);
                for y in start..bottom.min(start + S::ROWS) {
                    S::add(self.plane.row(y), &mut sums);
                }
                for (total, [left, right]) in totals.iter_mut().zip(&columns_of) {
                    let part = sums[*left..*right].iter();
                    *total += part.map(|sum| u32::from(*sum)).sum::<u32>();
                }
            }
            let means = self
                .means
                .row_mut(row)
                .iter_mut()
                .zip(&totals)
                .zip(&columns_of);
            for ((mean, total), [left, right]) in means {
                *mean = *total as f32 / ((right - left) * (bottom - top)) as f32;
            }
        }
    }
}

/// The pixels of box `index` of `count` over `length` pixels: one at least.
fn range(index: usize, count: usize, length: usize) -> [usize; 2] {
    let start = (index * length / count).min(length - 1);
    [start, ((index + 1) * length / count).max(start + 1)]
}

/// Red of averaged luma and Cr; `to_eight` takes their numbers to those of 8 bits.
fn combined<S: Sample>(
    planes: &Planes<S>,
    size: [usize; 2],
    colours: YCbCr,
    to_eight: f32,
) -> Plane<f32> {
    let mut red = box_means(planes.luma.view(), size);
    let [kr, ..] = colours.luma.weights();
    let (black, luma_factor, colour_factor) = match colours.range {
        Range::Limited => (16.0, 255.0 / 219.0, 255.0 / 224.0),
        Range::Full => (0.0, 1.0, 1.0),
    };
    let cr = &planes.differences[1];
    let difference = (!cr.is_empty()).then(|| box_means(cr.view(), size));
    for (index, value) in red.values_mut().iter_mut().enumerate() {
        let cr = difference
            .as_ref()
            .map_or(128.0, |cr| to_eight * cr.values()[index]);
        let luma = luma_factor * (to_eight * *value - black);
        let red = luma + 2.0 * (1.0 - kr) * colour_factor * (cr - 128.0);
        *value = red.clamp(0.0, 255.0);
    }
    red
}
