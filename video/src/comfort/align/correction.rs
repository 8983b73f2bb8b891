//! What is changed in the right view of one frame, and how it is changed.

use ga_image::plane::Plane;
use ga_image::warp::{Interpolation, Warp};
use ga_image::ycbcr::YCbCr;

use super::super::Tone;
use super::super::stereoscopy::Alignment;
use crate::stereo::pixel_height;
use crate::{Planes, Samples};

/// The differences of a right view from its left one that are to be removed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Correction {
    /// How it is displaced, rotated and larger.
    pub alignment: Alignment,
    /// By how many columns its points are to be moved to the right after that, or to the left where
    /// it is negative: parallax rises by it.
    pub parallax_px: f64,
    /// How the codes of red, green and blue in the left view follow from its own.
    pub tones: [Tone; 3],
}

/// Changes right views, one after another.
///
/// Sampling and depth of the numbers stay. Pixels are interpolated by cubic convolution, the
/// colour differences for themselves, and rounded once; outside the border the view is mirrored. A
/// view without differences stays as it is.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_image::ycbcr::YCbCr;
/// use ga_video::comfort::align::{Correction, Corrector};
/// use ga_video::comfort::stereoscopy::Alignment;
/// use ga_video::{Planes, Samples};
///
/// // The right view is 2 pixels lower than the left one.
/// let luma = Plane::from_fn(8, 6, |_, row| 20 * row as u8);
/// let right = Samples::Eight(Planes { luma, ..Planes::default() });
/// let lower = Alignment { shift_px: 2.0, ..Alignment::default() };
/// let correction = Correction { alignment: lower, ..Correction::default() };
/// let corrected = Corrector::new(YCbCr::default()).corrected(&right, &correction);
/// let column: Vec<u8> = corrected.eight_bits().luma.rows().map(|row| row[3]).collect();
/// assert_eq!(column, [40, 60, 80, 100, 100, 80]);
/// ```
#[derive(Clone, Debug)]
pub struct Corrector {
    colours: YCbCr,
    pixel_height: f64,
    /// The maps for planes of these sizes that do what was done last.
    warps: Vec<Warp>,
    last: (Alignment, f64),
}

impl Corrector {
    /// For views in this encoding of colours, with square pixels.
    #[must_use]
    pub fn new(colours: YCbCr) -> Self {
        Self {
            colours,
            pixel_height: 1.0,
            warps: Vec::new(),
            last: Default::default(),
        }
    }

    /// The same for pixels of this width and height, as in
    /// [`Properties::pixel_aspect`](crate::Properties::pixel_aspect).
    #[must_use]
    pub fn with_pixel_aspect(self, aspect: [u32; 2]) -> Self {
        Self {
            pixel_height: pixel_height(aspect),
            ..self
        }
    }

    /// A right view without the differences.
    #[must_use]
    pub fn corrected(&mut self, right: &Samples, correction: &Correction) -> Samples {
        if *correction == Correction::default() {
            return right.clone();
        }
        match right {
            Samples::Eight(planes) => {
                let codes = self.codes(&map(planes, f32::from), correction);
                // A cast from float saturates.
                Samples::Eight(map(&codes, |code| (code + 0.5) as u8))
            }
            Samples::Ten(planes) => {
                let codes = self.codes(&map(planes, |number| 0.25 * f32::from(number)), correction);
                let number = |code: f32| ((4.0 * code + 0.5) as u16).min(1023);
                Samples::Ten(map(&codes, number))
            }
        }
    }

    /// The changed planes, all in codes of 8 bits.
    fn codes(&mut self, planes: &Planes<f32>, correction: &Correction) -> Planes<f32> {
        let luma = &planes.luma;
        let size = [luma.width(), luma.height()];
        let moves = (correction.alignment, correction.parallax_px);
        if self.last != moves {
            self.last = moves;
            self.warps.clear();
        }
        let [cb, cr] = planes.differences.each_ref();
        let moved = Planes {
            luma: self.moved(luma, size),
            differences: [self.moved(cb, size), self.moved(cr, size)],
        };
        match correction.tones == [Tone::default(); 3] {
            true => moved,
            false => Recoding::new(self.colours, &correction.tones).recoded(&moved),
        }
    }

    /// A plane of a view of this size, moved.
    fn moved(&mut self, plane: &Plane<f32>, view: [usize; 2]) -> Plane<f32> {
        let size = [plane.width(), plane.height()];
        if self.last == Default::default() || plane.is_empty() {
            return plane.clone();
        }
        let known = self.warps.iter().find(|warp| warp.size() == size);
        let warp = match known {
            Some(warp) => warp,
            None => {
                self.warps.push(self.warp(size, view));
                &self.warps[self.warps.len() - 1]
            }
        };
        // The map has the size of the plane.
        warp.warped(plane, 0.0).unwrap_or_default()
    }

    /// The map that moves a plane of a view.
    fn warp(&self, size: [usize; 2], view: [usize; 2]) -> Warp {
        let (alignment, parallax) = self.last;
        let (sine, cosine) = alignment.rotation_degrees.to_radians().sin_cos();
        let zoom = 1.0 + 0.01 * alignment.zoom_percent;
        // 1 or 2 pixels for each stored number.
        let pixels = [0, 1].map(|axis| view[axis].div_ceil(size[axis]) as f64);
        let sides = size.map(|side| side as f64);
        let middle = view.map(|side| 0.5 * side as f64);
        let warp = Warp::new(size, size, |place| {
            let [x, y] = [0, 1].map(|axis| place[axis] * pixels[axis] - middle[axis]);
            // In columns, so that angles are those of the picture that is shown.
            let [x, y] = [x - parallax, self.pixel_height * y];
            let source = [
                middle[0] + zoom * (x * cosine + y * sine),
                middle[1] + zoom * (y * cosine - x * sine) / self.pixel_height + alignment.shift_px,
            ];
            Some([0, 1].map(|axis| mirrored(source[axis] / pixels[axis], sides[axis])))
        });
        warp.with_interpolation(Interpolation::Cubic)
    }
}

/// The place inside a picture that a mirror at its border shows; the other border beyond that.
fn mirrored(place: f64, side: f64) -> f64 {
    (side - (side - place.abs()).abs()).clamp(0.0, side)
}

/// Luma and colour differences after a change of red, green and blue: a linear map of those before
/// it, and what is added.
struct Recoding {
    factors: [[f32; 3]; 3],
    added: [f32; 3],
}

impl Recoding {
    fn new(colours: YCbCr, tones: &[Tone; 3]) -> Self {
        let of = |encoded: [f32; 3]| {
            let rgb = colours.decoded(encoded);
            let changed = |k: usize| tones[k].apply(f64::from(rgb[k])) as f32;
            colours.encoded(std::array::from_fn(changed))
        };
        let neutral = [0.0, 128.0, 128.0];
        let origin = of(neutral);
        let columns = [0, 1, 2].map(|k: usize| {
            let mut one = neutral;
            one[k] += 100.0;
            let image = of(one);
            [0, 1, 2].map(|j: usize| 0.01 * (image[j] - origin[j]))
        });
        let factors = [0, 1, 2].map(|j: usize| columns.map(|column| column[j]));
        let added = [0, 1, 2].map(|j: usize| {
            let of_neutral: f32 = (0..3).map(|k| factors[j][k] * neutral[k]).sum();
            origin[j] - of_neutral
        });
        Self { factors, added }
    }

    fn value(&self, channel: usize, encoded: [f32; 3]) -> f32 {
        let [y, cb, cr] = self.factors[channel];
        self.added[channel] + y * encoded[0] + cb * encoded[1] + cr * encoded[2]
    }

    fn recoded(&self, planes: &Planes<f32>) -> Planes<f32> {
        let luma = &planes.luma;
        let size = [luma.width(), luma.height()];
        let [cb, cr] = &planes.differences;
        if cb.is_empty() {
            let differences = [Plane::default(), Plane::default()];
            let luma = luma.map(|luma| self.value(0, [luma, 128.0, 128.0]));
            return Planes { luma, differences };
        }
        let stored = [cb.width(), cb.height()];
        let pixels = [0, 1].map(|axis| size[axis].div_ceil(stored[axis]));
        // The colour differences at each pixel, and the means of luma at each of them.
        let fine = |plane: &Plane<f32>| {
            if stored == size {
                return plane.clone();
            }
            let [x, y] = pixels.map(|count| 1.0 / count as f64);
            let warp = Warp::new(size, stored, |place| Some([x * place[0], y * place[1]]));
            warp.warped(plane, 128.0).unwrap_or_default()
        };
        let [fine_cb, fine_cr] = [fine(cb), fine(cr)];
        let new_luma = Plane::from_fn(size[0], size[1], |column, row| {
            let all = [luma, &fine_cb, &fine_cr].map(|plane| plane.row(row)[column]);
            self.value(0, all)
        });
        let differences = [1, 2].map(|channel| {
            Plane::from_fn(stored[0], stored[1], |column, row| {
                let rows = (row * pixels[1]..size[1]).take(pixels[1]);
                let (mut sum, mut count) = (0.0, 0.0);
                for row in rows {
                    let columns = &luma.row(row)[column * pixels[0]..];
                    for value in columns.iter().take(pixels[0]) {
                        sum += value;
                        count += 1.0;
                    }
                }
                let mean = sum / f32::max(count, 1.0);
                self.value(channel, [mean, cb.row(row)[column], cr.row(row)[column]])
            })
        });
        Planes {
            luma: new_luma,
            differences,
        }
    }
}

fn map<T: Copy, U: Copy>(planes: &Planes<T>, change: impl Fn(T) -> U) -> Planes<U> {
    let [cb, cr] = planes
        .differences
        .each_ref()
        .map(|plane| plane.map(&change));
    Planes {
        luma: planes.luma.map(&change),
        differences: [cb, cr],
    }
}
