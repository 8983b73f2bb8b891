//! Reading and analysing a video.

use std::path::Path;

use anyhow::{Error, Result};
use clap::ValueEnum;
use ga_image::plane::Plane;
use ga_image::y4m;
use ga_video::keyframe::layout::Layout;
use ga_video::keyframe::{Analyser, Analysis, Options};
use ga_video::{Frame, Properties};

use super::spool::Spool;
use crate::frame::Progress;

/// The blocks into which frames are divided.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Blocks {
    /// Objects in the middle, background in the four corners.
    Five,
    /// Cui's: objects below the middle, background at the left, above and at the right.
    Paper,
}

impl From<Blocks> for Layout {
    fn from(blocks: Blocks) -> Self {
        match blocks {
            Blocks::Five => Self::Five,
            Blocks::Paper => Self::Paper,
        }
    }
}

/// A video as far as it could be read.
pub(super) struct Analysed {
    pub(super) analysis: Analysis,
    pub(super) properties: Properties,
    /// Why it could not be read further.
    pub(super) failure: Option<Error>,
}

impl Analysed {
    /// Frames in a second: as stated, or from the times of the frames.
    pub(super) fn rate(&self) -> [u32; 2] {
        let frames = &self.analysis.frames;
        let seconds = frames.last().map_or(0.0, |frame| frame.time_seconds);
        self.properties.rate(frames.len(), seconds)
    }
}

/// Analyses a video; `-` is Y4M from standard input. Pictures of frames that may become key frames
/// go to the spool, where there is one.
pub(super) fn analyse(
    path: &Path,
    options: Options,
    mut spool: Option<&mut Spool>,
    progress: &Progress,
) -> Result<Analysed> {
    let mut source = ga_video::open(path)?;
    let properties = *source.properties();
    let mut analyser = Analyser::new(options, properties.colours);
    let mut frame = Frame::default();
    let mut count = 0_u64;
    let failure = loop {
        match source.read(&mut frame) {
            Ok(true) => {}
            Ok(false) => break None,
            Err(error) if count == 0 => return Err(error.into()),
            Err(error) => break Some(error.into()),
        }
        let candidate = match analyser.push(&frame) {
            Ok(candidate) => candidate,
            Err(error) => break Some(Error::new(error).context(path.display().to_string())),
        };
        if let Some(spool) = spool.as_deref_mut().filter(|_| candidate) {
            spool.keep(count as usize, &rgb(&frame, &properties))?;
        }
        count += 1;
        if count.is_multiple_of(16) {
            progress.at(
                count,
                properties.frame_count.map_or(2 * count, |all| all as u64),
            );
        }
    };
    Ok(Analysed {
        analysis: analyser.finish(),
        properties,
        failure,
    })
}

fn rgb(frame: &Frame, properties: &Properties) -> Plane<[u8; 3]> {
    let planes = frame.samples.eight_bits();
    let [cb, cr] = &planes.differences;
    let frame = y4m::Frame {
        luma: planes.luma.view(),
        differences: [cb.view(), cr.view()],
    };
    frame.to_rgb(properties.colours)
}
