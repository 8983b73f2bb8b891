//! Reading and analysing a whole video.

use std::collections::VecDeque;
use std::path::Path;

use serde::Serialize;

use super::analysis::{Analyser, Analysis, Options};
use super::error::KeyFrameError;
use super::pictures::Pictures;
use super::timecode::rate_of_times;
use crate::{Frame, Properties, Samples};

/// A video as far as it could be read. Its JSON is that of the analysis.
#[derive(Debug, Serialize)]
pub struct Analysed {
    /// What was found.
    #[serde(flatten)]
    pub analysis: Analysis,
    /// What all frames share.
    #[serde(skip)]
    pub properties: Properties,
    /// Why it could not be read further.
    #[serde(skip)]
    pub failure: Option<KeyFrameError>,
}

impl Analysed {
    /// The time of each frame in seconds, and that of the end of the last, which is shown as long
    /// as the frame before it. Of a video that states no rate and whose times are nevertheless
    /// even, as of pictures, they were assumed, and follow from the `given` rate instead.
    #[must_use]
    pub fn times(&self, given: Option<[u32; 2]>) -> Vec<f64> {
        let frames = self.analysis.frames.iter();
        let mut times: Vec<f64> = frames.map(|frame| frame.time_seconds).collect();
        let step = |pair: &[f64]| pair[1] - pair[0];
        let stated = self.properties.frames_per_second;
        let is_even = times
            .windows(2)
            .all(|pair| (step(pair) - step(&times)).abs() < 1e-6);
        let assumed = given.filter(|_| stated.is_none() && is_even && times.len() > 1);
        if let Some([numerator, denominator]) = assumed {
            let rate = f64::from(numerator) / f64::from(denominator);
            return (0..=times.len()).map(|frame| frame as f64 / rate).collect();
        }
        let last = times.last().copied().unwrap_or(0.0);
        let shown = match (stated, times.as_slice()) {
            (Some([numerator, denominator]), _) => f64::from(denominator) / f64::from(numerator),
            (None, [.., before, last]) => last - before,
            (None, _) => 0.0,
        };
        times.push(last + shown);
        times
    }

    /// Frames in a second: as stated, or their mean.
    #[must_use]
    pub fn mean_rate(&self) -> [u32; 2] {
        let frames = &self.analysis.frames;
        let seconds = frames.last().map_or(0.0, |frame| frame.time_seconds);
        self.properties.rate(frames.len(), seconds)
    }

    /// Frames in a second: as stated, or where that varies the usual rate at whose frames all times
    /// are; `None` where there is none.
    #[must_use]
    pub fn rate(&self) -> Option<[u32; 2]> {
        let stated = self.properties.frames_per_second;
        let times = self.analysis.frames.iter().map(|frame| frame.time_seconds);
        stated.or_else(|| rate_of_times(&times.collect::<Vec<f64>>()))
    }
}

/// How many frames lie between two calls of `progress`.
const STEP: usize = 16;

/// Analyses a video, which is opened as by [`open`](crate::open). How much the first frames say of
/// those before them may be known as `measured`, by [`information`](super::information). Pictures
/// of frames that may become key frames are added to `pictures`. `progress` hears after every 16
/// frames how many there were, and how many there are, or about twice as many as there were where
/// that is not known.
///
/// # Errors
///
/// [`KeyFrameError::Video`] where no frame can be read; where pictures cannot be kept. What is
/// wrong later is the [`failure`](Analysed::failure) of the analysis.
pub fn analyse(
    path: &Path,
    options: Options,
    measured: impl Into<VecDeque<Option<f64>>>,
    mut pictures: Option<&mut Pictures>,
    mut progress: impl FnMut(usize, usize),
) -> Result<Analysed, KeyFrameError> {
    let mut source = crate::open(path)?;
    let properties = *source.properties();
    let mut analyser = Analyser::new(options, properties.colours).with_information(measured);
    let mut frame = Frame::default();
    let mut count = 0;
    let failure = loop {
        match source.read(&mut frame) {
            Ok(true) => {}
            Ok(false) => break None,
            Err(error) if count == 0 => return Err(error.into()),
            Err(error) => break Some(error.into()),
        }
        let is_candidate = match analyser.push(&frame) {
            Ok(is_candidate) => is_candidate,
            Err(problem) => {
                break Some(KeyFrameError::Frame {
                    file: path.to_path_buf(),
                    problem: Box::new(problem),
                });
            }
        };
        if let Some(pictures) = pictures.as_deref_mut().filter(|_| is_candidate) {
            // In 8 bits, as the frame was compared with others.
            let samples = Samples::Eight(frame.samples.eight_bits().into_owned());
            let seen = Frame {
                samples,
                ..Frame::default()
            };
            pictures.keep(count, &seen.to_rgb(properties.colours))?;
        }
        count += 1;
        if count.is_multiple_of(STEP) {
            progress(count, properties.frame_count.unwrap_or(2 * count));
        }
    };
    Ok(Analysed {
        analysis: analyser.finish(),
        properties,
        failure,
    })
}
