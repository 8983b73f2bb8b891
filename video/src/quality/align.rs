//! Which frames of two videos show the same moment.

use ga_image::plane::{Plane, PlaneError};
use ga_image::resample::{Method, resize};
use serde::{Deserialize, Serialize};

use super::properties::{FRAME_COUNT, PropertyDifference};
use crate::{Frame, Source, VideoError};

/// Columns and rows of the pictures by which frames are compared for an offset.
const SMALL: [usize; 2] = [32, 18];

/// How many offsets to either side are tried.
const OFFSETS: usize = 300;

/// By how much a sum of differences must be less than another one to count as less.
const ROUNDING: f64 = 1e-9;

/// The times and small pictures of the frames of a video.
#[derive(Clone, Debug, Default)]
pub struct Moments {
    seconds: Vec<f64>,
    pictures: Vec<Plane>,
}

/// Frames of two videos that show the same moments.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TimeAlignment {
    /// The seconds that are added to the times of the distorted video, so that its frames belong to
    /// those of the reference nearest in time.
    pub offset_seconds: f64,
    /// The mean squared difference of small pictures in luma, from 0 to 255, with this offset.
    pub mean_square_difference: f64,
    /// The same without an offset; `None` where no frames belong together then.
    pub unshifted_mean_square_difference: Option<f64>,
    /// How many frames of the reference belong to none of the distorted video.
    pub unmatched_reference_frames: usize,
    /// How many frames of the distorted video belong to none of the reference.
    pub unmatched_distorted_frames: usize,
    /// The numbers of the frames that belong together, that of the reference first.
    #[serde(skip)]
    pub pairs: Vec<[usize; 2]>,
}

impl Moments {
    /// Reads a video to its end.
    ///
    /// # Errors
    ///
    /// Those of [`Source::read`].
    pub fn of(mut source: impl Source) -> Result<Self, VideoError> {
        let (mut moments, mut frame) = (Self::default(), Frame::default());
        while source.read(&mut frame)? {
            let luma = &frame.samples.eight_bits().luma;
            let small = resize(luma, SMALL[0], SMALL[1], Method::Area);
            let small = small.map_err(|problem: PlaneError| VideoError::Unmeasured {
                frame: frame.index,
                problem,
            })?;
            moments.pictures.push(small.map(f32::from));
            moments.seconds.push(frame.time_seconds);
        }
        Ok(moments)
    }

    /// Half of the median time from a frame to the next: how far a moment may be from the frame
    /// that shows it. Infinite for one frame.
    fn half_interval(&self) -> f64 {
        let times = self.seconds.windows(2);
        let mut intervals: Vec<f64> = times.map(|pair| pair[1] - pair[0]).collect();
        intervals.sort_by(f64::total_cmp);
        let middle = intervals.get(intervals.len() / 2);
        middle.map_or(f64::INFINITY, |interval| 0.5 * interval)
    }

    /// The frame that is nearest in time.
    fn nearest(&self, seconds: f64) -> Option<usize> {
        let next = self.seconds.partition_point(|time| *time < seconds);
        let around = next.saturating_sub(1)..(next + 1).min(self.seconds.len());
        let distance = |place: &usize| (self.seconds[*place] - seconds).abs();
        around.min_by(|a, b| distance(a).total_cmp(&distance(b)))
    }
}

impl TimeAlignment {
    /// For each frame of the distorted video, the frame of the reference that is nearest in time
    /// and not farther than half of the time between frames, after the constant offset with the
    /// least mean squared difference of the pictures. Where several are equally good, as those of a
    /// still picture are, it is the one nearest to zero. An offset counts where at least half of
    /// the frames of the shorter video belong to one of the other. `None` where there is none.
    #[must_use]
    pub fn find(reference: &Moments, distorted: &Moments) -> Option<Self> {
        let first = *distorted.seconds.first()?;
        let later = reference.seconds.iter().take(OFFSETS);
        let later = later.map(|seconds| seconds - first);
        let start = *reference.seconds.first()?;
        let earlier = distorted.seconds.iter().take(OFFSETS);
        let earlier = earlier.map(|seconds| start - seconds);
        let mut offsets: Vec<f64> = later.chain(earlier).chain([0.0]).collect();
        offsets.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
        offsets.dedup();
        let least = reference.seconds.len().min(distorted.seconds.len());
        let found = |offset: f64| {
            let pairs = pairs(reference, distorted, offset);
            let difference = |pair: &[usize; 2]| {
                let [a, b] = [&reference.pictures[pair[0]], &distorted.pictures[pair[1]]];
                let pairs = a.values().iter().zip(b.values());
                let squares = pairs.map(|(a, b)| f64::from(a - b).powi(2));
                squares.sum::<f64>() / a.values().len() as f64
            };
            let is_enough = 2 * pairs.len() >= least && !pairs.is_empty();
            let sum = pairs.iter().map(difference).sum::<f64>();
            is_enough.then(|| (sum / pairs.len() as f64, pairs))
        };
        let mut best: Option<(f64, f64, Vec<[usize; 2]>)> = None;
        for offset in offsets {
            let Some((difference, pairs)) = found(offset) else {
                continue;
            };
            let is_less =
                |(_, least, _): &(f64, f64, Vec<[usize; 2]>)| difference < least * (1.0 - ROUNDING);
            if best.as_ref().is_none_or(is_less) {
                best = Some((offset, difference, pairs));
            }
        }
        let (offset_seconds, mean_square_difference, pairs) = best?;
        let [of_reference, of_distorted] = [0, 1].map(|side| {
            let mut frames: Vec<usize> = pairs.iter().map(|pair| pair[side]).collect();
            frames.dedup();
            frames.len()
        });
        let unshifted = found(0.0).map(|(difference, _)| difference);
        Some(Self {
            offset_seconds,
            mean_square_difference,
            unshifted_mean_square_difference: unshifted,
            unmatched_reference_frames: reference.seconds.len() - of_reference,
            unmatched_distorted_frames: distorted.seconds.len() - of_distorted,
            pairs,
        })
    }
}

impl TimeAlignment {
    /// The numbers of frames, where some belong to none of the other video.
    #[must_use]
    pub fn frame_difference(&self) -> Option<PropertyDifference> {
        let unmatched = [
            self.unmatched_reference_frames,
            self.unmatched_distorted_frames,
        ];
        let [reference, distorted] =
            unmatched.map(|unmatched| format!("{unmatched} without a counterpart"));
        (unmatched != [0, 0]).then_some(PropertyDifference {
            what: FRAME_COUNT,
            reference,
            distorted,
        })
    }
}

/// The frames that belong together with this offset, in order.
fn pairs(reference: &Moments, distorted: &Moments, offset: f64) -> Vec<[usize; 2]> {
    let half = reference.half_interval() * (1.0 + ROUNDING) + ROUNDING;
    let times = distorted.seconds.iter().enumerate();
    let pairs = times.filter_map(|(place, seconds)| {
        let seconds = seconds + offset;
        let nearest = reference.nearest(seconds)?;
        let is_near = (reference.seconds[nearest] - seconds).abs() <= half;
        is_near.then_some([nearest, place])
    });
    pairs.collect()
}
