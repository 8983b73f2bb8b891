//! Reading and analysing a whole video.

use std::path::Path;

use serde::Serialize;

use super::analysis::{Analyser, Analysis, Options};
use super::error::KeyFrameError;
use super::pictures::Pictures;
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
    /// Frames in a second: as stated, or from the times of the frames.
    #[must_use]
    pub fn rate(&self) -> [u32; 2] {
        let frames = &self.analysis.frames;
        let seconds = frames.last().map_or(0.0, |frame| frame.time_seconds);
        self.properties.rate(frames.len(), seconds)
    }
}

/// How many frames lie between two calls of `progress`.
const STEP: usize = 16;

/// Analyses a video, which is opened as by [`open`](crate::open). Pictures of frames that may
/// become key frames are added to `pictures`. `progress` hears after every 16 frames how many there
/// were, and how many there are, or about twice as many as there were where that is not known.
///
/// # Errors
///
/// [`KeyFrameError::Video`] where no frame can be read; where pictures cannot be kept. What is
/// wrong later is the [`failure`](Analysed::failure) of the analysis.
pub fn analyse(
    path: &Path,
    options: Options,
    mut pictures: Option<&mut Pictures>,
    mut progress: impl FnMut(usize, usize),
) -> Result<Analysed, KeyFrameError> {
    let mut source = crate::open(path)?;
    let properties = *source.properties();
    let mut analyser = Analyser::new(options, properties.colours);
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
