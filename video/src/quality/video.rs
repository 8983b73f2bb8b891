//! The measures of two videos.

use ga_image::plane::{Plane, PlaneError};
use ga_image::quality::{Weights, mse};
use ga_image::sample::Pixel;
use ga_image::ycbcr::YCbCr;
use serde::{Deserialize, Serialize};

use super::colour_difference::mean_ciede2000;
use super::measures::{Measures, Meter, psnr_of};
use super::properties::{PropertyDifference, property_differences};
use super::same::Same;
use crate::{Frame, Planes, Samples, Source, VideoError};

/// The measures of one frame of a video.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct FrameQuality {
    /// The number of the frame of the reference, from 0.
    pub index: usize,
    /// When the reference shows it, in seconds after its first frame.
    pub time_seconds: f64,
    /// The number of the frame that is compared with it.
    pub distorted_index: usize,
    /// How much later that one is shown, in seconds.
    pub time_offset_seconds: f64,
    /// The measures of luma.
    pub luma: Measures,
    /// PSNR of Cb and Cr in decibels; `None` for grey videos.
    #[serde(with = "super::number::pair")]
    pub psnr_differences: Option<[f64; 2]>,
    /// PSNR in decibels by the mean squared error over all samples: those of luma, Cb and Cr, where
    /// a plane counts by its size, or those of red, green and blue of pictures.
    #[serde(with = "super::number")]
    pub psnr_all: f64,
    /// [`mean_ciede2000`] of the colours as sRGB, where colour differences are those stored for a
    /// pixel, without interpolation; `None` where numbers have more than 8 bits.
    pub ciede2000: Option<f64>,
    /// What is identical.
    pub same: Same,
}

impl FrameQuality {
    /// (6 PSNR_Y + PSNR_Cb + PSNR_Cr) / 8 in decibels, which the experts for video coding report
    /// for 4:2:0 (J.-R. Ohm et al., "Comparison of the coding efficiency of video coding
    /// standards", 2012); `None` for grey videos.
    #[must_use]
    pub fn psnr_6_1_1(&self) -> Option<f64> {
        self.psnr_differences
            .map(|[cb, cr]| (6.0 * self.luma.psnr + cb + cr) / 8.0)
    }
}

/// The measures of the frames of two videos, one after another: an iterator that reads them as it
/// goes, and needs memory for two frames. After an error it ends; what it gave before is valid.
#[derive(Debug)]
pub struct VideoComparison<R, D> {
    reference: Reading<R>,
    distorted: Reading<D>,
    /// Which frames are compared, where that is not each with that of the same number.
    pairs: Option<std::vec::IntoIter<[usize; 2]>>,
    meter: Meter,
    next: usize,
    ended: bool,
}

/// A video with the last frame that was read.
#[derive(Debug)]
struct Reading<S> {
    source: S,
    frame: Frame,
    /// How many frames were read.
    count: usize,
}

impl<S: Source> Reading<S> {
    fn new(source: S) -> Self {
        Self {
            source,
            frame: Frame::default(),
            count: 0,
        }
    }

    /// Reads up to a frame; whether it is there.
    fn read_to(&mut self, index: usize) -> Result<bool, VideoError> {
        while self.count <= index {
            if !self.source.read(&mut self.frame)? {
                return Ok(false);
            }
            self.count += 1;
        }
        Ok(true)
    }
}

impl<R: Source, D: Source> VideoComparison<R, D> {
    /// Compares a video with its reference. Attention is computed from the luma of the reference,
    /// unless there is a `map` of it for all frames.
    ///
    /// # Errors
    ///
    /// [`VideoError::Properties`] when the videos differ in size, sampling, bit depth or range, so
    /// that their numbers do not mean the same.
    pub fn new(reference: R, distorted: D, map: Option<Weights>) -> Result<Self, VideoError> {
        let (first, second) = (reference.properties(), distorted.properties());
        super::properties::comparable(first, second)?;
        let range = f64::from((1u32 << first.bit_depth) - 1);
        let problem = |problem: PlaneError| VideoError::Unmeasured { frame: 0, problem };
        let meter = match map {
            Some(map) => Meter::with_map(map, range),
            None => Meter::new(first.size, range).map_err(problem)?,
        };
        Ok(Self {
            reference: Reading::new(reference),
            distorted: Reading::new(distorted),
            pairs: None,
            meter,
            next: 0,
            ended: false,
        })
    }

    /// Compares these frames, the number of that of the reference first. Neither numbers of a pair
    /// may be less than those of the pair before.
    #[must_use]
    pub fn of_pairs(self, pairs: Vec<[usize; 2]>) -> Self {
        Self {
            pairs: Some(pairs.into_iter()),
            ..self
        }
    }

    /// Begins with this frame of the comparison instead of the first. The frame before it is
    /// measured, since attention looks at the motion from it, so that all measures are those of a
    /// comparison of all frames.
    ///
    /// # Errors
    ///
    /// Those of the frame before.
    pub fn starting_at(mut self, frame: usize) -> Result<Self, VideoError> {
        let Some(before) = frame.checked_sub(1) else {
            return Ok(self);
        };
        self.next = before;
        if let Some(pairs) = &mut self.pairs {
            pairs.by_ref().take(before).for_each(drop);
        }
        self.next().transpose()?;
        Ok(self)
    }

    /// The number of frames that are compared, where it is known.
    #[must_use]
    pub fn frame_count(&self) -> Option<usize> {
        if let Some(pairs) = &self.pairs {
            return Some(pairs.len());
        }
        let reference = self.reference.source.properties().frame_count;
        Some(reference?.min(self.distorted.source.properties().frame_count?))
    }

    /// What else the videos state differently. Their numbers are compared all the same.
    #[must_use]
    pub fn property_differences(&self) -> Vec<PropertyDifference> {
        property_differences(
            self.reference.source.properties(),
            self.distorted.source.properties(),
        )
    }

    fn measure(&mut self) -> Result<Option<FrameQuality>, VideoError> {
        let [index, distorted_index] = match &mut self.pairs {
            None => [self.next; 2],
            Some(pairs) => match pairs.next() {
                Some(pair) => pair,
                None => return Ok(None),
            },
        };
        let found = [
            self.reference.read_to(index)?,
            self.distorted.read_to(distorted_index)?,
        ];
        let ended = match found {
            [true, true] => None,
            [false, false] => return Ok(None),
            [false, true] => Some(("reference", index)),
            [true, false] => Some(("distorted", distorted_index)),
        };
        if let Some((ended, frame)) = ended {
            return Err(VideoError::ReferenceLength { frame, ended });
        }
        self.next += 1;
        let colours = self.reference.source.properties().colours;
        let frames = [&self.reference.frame, &self.distorted.frame];
        frame_quality(&mut self.meter, [index, distorted_index], frames, colours).map(Some)
    }
}

/// The measures of two frames. Unlike the comparison of sources of any kind, this is compiled once.
fn frame_quality(
    meter: &mut Meter,
    [index, distorted_index]: [usize; 2],
    [reference, distorted]: [&Frame; 2],
    colours: YCbCr,
) -> Result<FrameQuality, VideoError> {
    let eight = reference.samples.eight_bits();
    let measured = match (&reference.samples, &distorted.samples) {
        (Samples::Eight(a), Samples::Eight(b)) => planes(meter, a, b, &eight.luma),
        (Samples::Ten(a), Samples::Ten(b)) => planes(meter, a, b, &eight.luma),
        (a, b) => {
            let [reference, distorted] = [a, b].map(|s| format!("{} bits", s.bit_depth()));
            return Err(VideoError::Properties {
                what: "depth",
                reference,
                distorted,
            });
        }
    };
    let measured = measured.map_err(|problem| VideoError::Unmeasured {
        frame: index,
        problem,
    })?;
    let has_eight_bits = reference.samples.bit_depth() == 8;
    let ciede2000 = has_eight_bits.then(|| match measured.same.is_all() {
        true => 0.0,
        false => mean_ciede2000(&reference.to_rgb(colours), &distorted.to_rgb(colours)),
    });
    Ok(FrameQuality {
        index,
        time_seconds: reference.time_seconds,
        distorted_index,
        time_offset_seconds: distorted.time_seconds - reference.time_seconds,
        luma: measured.luma,
        psnr_differences: measured.psnr_differences,
        psnr_all: measured.psnr_all,
        ciede2000,
        same: measured.same,
    })
}

impl<R: Source, D: Source> Iterator for VideoComparison<R, D> {
    type Item = Result<FrameQuality, VideoError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.ended {
            return None;
        }
        let measured = self.measure().transpose();
        self.ended = !matches!(measured, Some(Ok(_)));
        measured
    }
}

/// What is found of the planes of two frames.
struct Measured {
    luma: Measures,
    psnr_differences: Option<[f64; 2]>,
    psnr_all: f64,
    same: Same,
}

fn planes<T: Pixel>(
    meter: &mut Meter,
    reference: &Planes<T>,
    distorted: &Planes<T>,
    seen: &Plane<u8>,
) -> Result<Measured, PlaneError> {
    let luma = meter.compare(&reference.luma, &distorted.luma, seen)?;
    let range = meter.range();
    let is_luma_same = luma.mse == 0.0;
    if reference.differences[0].is_empty() {
        return Ok(Measured {
            luma,
            psnr_differences: None,
            psnr_all: luma.psnr,
            same: Same {
                luma: is_luma_same,
                ..Same::ALL
            },
        });
    }
    let [cb, cr] = [0, 1].map(|k| mse(&reference.differences[k], &distorted.differences[k]));
    let errors = [luma.mse, cb?, cr?];
    let sizes = reference
        .as_array()
        .map(|plane| (plane.width() * plane.height()) as f64);
    let all = errors.iter().zip(&sizes).map(|(mse, size)| mse * size);
    Ok(Measured {
        luma,
        psnr_differences: Some([errors[1], errors[2]].map(|mse| psnr_of(mse, range))),
        psnr_all: psnr_of(all.sum::<f64>() / sizes.iter().sum::<f64>(), range),
        same: Same {
            luma: is_luma_same,
            colours: errors[1..] == [0.0, 0.0],
            ..Same::ALL
        },
    })
}
