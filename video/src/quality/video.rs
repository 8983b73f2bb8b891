//! The measures of two videos.

use ga_image::plane::{Plane, PlaneError};
use ga_image::quality::{Weights, mse};
use ga_image::sample::Pixel;

use super::measures::{Measures, Meter, psnr_of};
use crate::{Frame, Planes, Samples, Source, VideoError};

/// The measures of one frame of a video.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameQuality {
    /// The number of the frame, from 0.
    pub index: usize,
    /// When the reference shows it, in seconds after its first frame.
    pub time_seconds: f64,
    /// The measures of luma.
    pub luma: Measures,
    /// PSNR of Cb and Cr in decibels; `None` for grey videos.
    pub psnr_differences: Option<[f64; 2]>,
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
    reference: R,
    distorted: D,
    frames: [Frame; 2],
    meter: Meter,
    next: usize,
    ended: bool,
}

impl<R: Source, D: Source> VideoComparison<R, D> {
    /// Compares a video with its reference. Attention is computed from the luma of the reference,
    /// unless there is a `map` of it for all frames.
    ///
    /// # Errors
    ///
    /// [`VideoError::Properties`] when the videos differ in size, sampling or bit depth.
    pub fn new(reference: R, distorted: D, map: Option<Weights>) -> Result<Self, VideoError> {
        let (first, second) = (reference.properties(), distorted.properties());
        let size = |[width, height]: [usize; 2]| format!("{width} × {height} pixels");
        let differ = |what, reference, distorted| VideoError::Properties {
            what,
            reference,
            distorted,
        };
        if first.size != second.size {
            return Err(differ("size", size(first.size), size(second.size)));
        }
        if first.bit_depth != second.bit_depth {
            let bits = |depth: u32| format!("{depth} bits");
            let bits = [first.bit_depth, second.bit_depth].map(bits);
            let [reference, distorted] = bits;
            return Err(differ("depth", reference, distorted));
        }
        if first.sampling != second.sampling {
            let [reference, distorted] =
                [first.sampling, second.sampling].map(|sampling| format!("{sampling:?}"));
            return Err(differ("sampling", reference, distorted));
        }
        let range = f64::from((1u32 << first.bit_depth) - 1);
        let problem = |problem: PlaneError| VideoError::Unmeasured { frame: 0, problem };
        let meter = match map {
            Some(map) => Meter::with_map(map, range),
            None => Meter::new(first.size, range).map_err(problem)?,
        };
        Ok(Self {
            reference,
            distorted,
            frames: Default::default(),
            meter,
            next: 0,
            ended: false,
        })
    }

    /// The number of frames, where both videos state it.
    #[must_use]
    pub fn frame_count(&self) -> Option<usize> {
        let [reference, distorted] =
            [self.reference.properties(), self.distorted.properties()].map(|p| p.frame_count);
        Some(reference?.min(distorted?))
    }

    /// The difference between the greatest and the least possible number: 255 for 8 bits.
    #[must_use]
    pub fn range(&self) -> f64 {
        self.meter.range()
    }

    fn measure(&mut self) -> Result<Option<FrameQuality>, VideoError> {
        let [reference, distorted] = &mut self.frames;
        let found = [
            self.reference.read(reference)?,
            self.distorted.read(distorted)?,
        ];
        let frame = self.next;
        let ended = match found {
            [true, true] => None,
            [false, false] => return Ok(None),
            [false, true] => Some("reference"),
            [true, false] => Some("distorted"),
        };
        if let Some(ended) = ended {
            return Err(VideoError::ReferenceLength { frame, ended });
        }
        self.next += 1;
        let eight = reference.samples.eight_bits();
        let meter = &mut self.meter;
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
        let (luma, psnr_differences) =
            measured.map_err(|problem| VideoError::Unmeasured { frame, problem })?;
        Ok(Some(FrameQuality {
            index: frame,
            time_seconds: reference.time_seconds,
            luma,
            psnr_differences,
        }))
    }
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

/// The measures of luma, and PSNR of the colour differences where there are any.
fn planes<T: Pixel>(
    meter: &mut Meter,
    reference: &Planes<T>,
    distorted: &Planes<T>,
    luma: &Plane<u8>,
) -> Result<(Measures, Option<[f64; 2]>), PlaneError> {
    let measures = meter.compare(&reference.luma, &distorted.luma, luma)?;
    if reference.differences[0].is_empty() {
        return Ok((measures, None));
    }
    let mut psnr = [0.0; 2];
    let pairs = reference.differences.iter().zip(&distorted.differences);
    for (psnr, (a, b)) in psnr.iter_mut().zip(pairs) {
        *psnr = psnr_of(mse(a, b)?, meter.range());
    }
    Ok((measures, Some(psnr)))
}
