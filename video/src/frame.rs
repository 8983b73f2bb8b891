//! Frames of a video.

use std::borrow::Cow;
use std::mem;

use ga_image::plane::Plane;
use ga_image::y4m::Sampling;
use ga_image::ycbcr::YCbCr;

/// One frame of a video.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Frame {
    /// Its number in the video, from 0.
    pub index: usize,
    /// When it is shown, in seconds after the first frame.
    pub time_seconds: f64,
    /// Its pixels.
    pub samples: Samples,
}

/// The pixels of a frame, as they are stored.
#[derive(Clone, Debug, PartialEq)]
pub enum Samples {
    /// Numbers of 8 bits.
    Eight(Planes<u8>),
    /// Numbers of 10 bits, from 0 to 1023.
    Ten(Planes<u16>),
}

/// Luma and the two colour differences.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Planes<T> {
    /// Luma, as wide and high as the video.
    pub luma: Plane<T>,
    /// Cb and Cr, as wide and high as the sampling of the video says (odd sizes round up); without
    /// pixels in a grey video.
    pub differences: [Plane<T>; 2],
}

/// What all frames of a video share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Properties {
    /// Columns and rows.
    pub size: [usize; 2],
    /// Where colour differences are stored.
    pub sampling: Sampling,
    /// Bits of each number: 8 or 10.
    pub bit_depth: u32,
    /// Weights and range of the colours.
    pub colours: YCbCr,
    /// Width and height of a pixel: 1 and 1 for a square.
    pub pixel_aspect: [u32; 2],
    /// Frames in a second as numerator and denominator, where the video states one rate. Times of
    /// frames come from [`Frame::time_seconds`], also where the rate varies.
    pub frames_per_second: Option<[u32; 2]>,
    /// The number of frames, where it is known before they are read.
    pub frame_count: Option<usize>,
}

impl Properties {
    /// Frames in a second as numerator and denominator: as stated, or the
    /// [mean](Self::mean_rate) of a number of frames.
    #[must_use]
    pub fn rate(&self, frames: usize, last_seconds: f64) -> [u32; 2] {
        let of_times = || Self::mean_rate(frames, last_seconds);
        self.frames_per_second.unwrap_or_else(of_times)
    }

    /// Frames in a second as numerator and denominator, where the last of a number of frames begins
    /// at this time; 25 where they do not show it.
    ///
    /// ```
    /// assert_eq!(ga_video::Properties::mean_rate(31, 1.0), [30_000, 1000]);
    /// assert_eq!(ga_video::Properties::mean_rate(1, 0.0), [25, 1]);
    /// ```
    #[must_use]
    pub fn mean_rate(frames: usize, last_seconds: f64) -> [u32; 2] {
        let rate = (frames.saturating_sub(1)) as f64 / last_seconds;
        // A cast from float saturates.
        match rate.is_finite() && rate > 0.0 {
            true => [(1000.0 * rate).round() as u32, 1000],
            false => [25, 1],
        }
    }
}

impl Frame {
    /// The frame in red, green and blue, for people to look at. Each pixel takes the stored colour
    /// differences of the square or pair to which it belongs, without interpolation; a grey video
    /// stays grey.
    ///
    /// ```
    /// use ga_image::plane::Plane;
    /// use ga_image::ycbcr::YCbCr;
    /// use ga_video::{Frame, Planes, Samples};
    ///
    /// let luma = Plane::filled(3, 1, 940_u16);
    /// let samples = Samples::Ten(Planes { luma, ..Planes::default() });
    /// let frame = Frame { samples, ..Frame::default() };
    /// assert_eq!(frame.to_rgb(YCbCr::default()).get(2, 0), Some([255; 3]));
    /// ```
    #[must_use]
    pub fn to_rgb(&self, colours: YCbCr) -> Plane<[u8; 3]> {
        match &self.samples {
            Samples::Eight(planes) => planes.to_rgb(128, |encoded| colours.to_rgb(encoded)),
            Samples::Ten(planes) => {
                planes.to_rgb(512, |encoded| colours.to_rgb_of_ten_bits(encoded))
            }
        }
    }
}

impl<T> Planes<T> {
    /// Luma, Cb and Cr.
    #[must_use]
    pub fn as_array(&self) -> [&Plane<T>; 3] {
        let [cb, cr] = &self.differences;
        [&self.luma, cb, cr]
    }
}

impl<T: Copy> Planes<T> {
    fn to_rgb(&self, neutral: T, colour: impl Fn([T; 3]) -> [u8; 3]) -> Plane<[u8; 3]> {
        let [cb, cr] = &self.differences;
        let (width, height) = (self.luma.width(), self.luma.height());
        // 1 or 2 pixels for each stored number.
        let across = width.div_ceil(cb.width().max(1)).max(1);
        let down = height.div_ceil(cb.height().max(1)).max(1);
        let difference =
            |plane: &Plane<T>, c, r| plane.get(c / across, r / down).unwrap_or(neutral);
        Plane::from_fn(width, height, |c, r| {
            colour([
                self.luma.row(r)[c],
                difference(cb, c, r),
                difference(cr, c, r),
            ])
        })
    }
}

impl Default for Samples {
    /// Without pixels.
    fn default() -> Self {
        Self::Eight(Planes::default())
    }
}

impl Samples {
    /// Columns and rows.
    #[must_use]
    pub fn size(&self) -> [usize; 2] {
        match self {
            Self::Eight(planes) => [planes.luma.width(), planes.luma.height()],
            Self::Ten(planes) => [planes.luma.width(), planes.luma.height()],
        }
    }

    /// Bits of each number.
    #[must_use]
    pub fn bit_depth(&self) -> u32 {
        match self {
            Self::Eight(_) => 8,
            Self::Ten(_) => 10,
        }
    }

    /// The planes of 8 bits, whose memory is to be used again; empty ones for another depth.
    pub(super) fn take_eight(&mut self) -> Planes<u8> {
        match mem::take(self) {
            Self::Eight(planes) => planes,
            Self::Ten(_) => Planes::default(),
        }
    }

    /// As [`take_eight`](Self::take_eight), for 10 bits.
    pub(super) fn take_ten(&mut self) -> Planes<u16> {
        match mem::take(self) {
            Self::Eight(_) => Planes::default(),
            Self::Ten(planes) => planes,
        }
    }

    /// The pixels in 8 bits: as they are, or v / 4 rounded to the nearest number for 10 bits, which
    /// takes black 64 to 16 and white 940 to 235.
    ///
    /// ```
    /// use ga_image::plane::Plane;
    /// use ga_video::{Planes, Samples};
    ///
    /// let luma = Plane::filled(2, 1, 940_u16);
    /// let ten = Samples::Ten(Planes { luma, ..Planes::default() });
    /// assert_eq!(ten.eight_bits().luma.get(0, 0), Some(235));
    /// ```
    #[must_use]
    pub fn eight_bits(&self) -> Cow<'_, Planes<u8>> {
        match self {
            Self::Eight(planes) => Cow::Borrowed(planes),
            Self::Ten(planes) => {
                let eight = |plane: &Plane<u16>| plane.map(|v| ((v + 2) / 4).min(255) as u8);
                Cow::Owned(Planes {
                    luma: eight(&planes.luma),
                    differences: [eight(&planes.differences[0]), eight(&planes.differences[1])],
                })
            }
        }
    }
}
