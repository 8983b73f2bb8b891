//! What was measured of two videos, before it is summed up.

use anyhow::{Result, ensure};
use ga_video::quality::{FrameQuality, PropertyDifference, TimeAlignment};
use serde::{Deserialize, Serialize};

/// The measures of frames of two videos, and what was done before.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Found {
    /// Columns and rows.
    pub(super) size: [usize; 2],
    pub(super) properties: Vec<PropertyDifference>,
    pub(super) alignment: Option<TimeAlignment>,
    pub(super) scaling: Option<Scaling>,
    pub(super) frames: Vec<FrameQuality>,
}

/// How a video was brought to the size of its reference.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Scaling {
    /// Its own columns and rows.
    pub(super) from: [usize; 2],
    pub(super) in_words: String,
}

impl Found {
    /// Adds the frames of the next part.
    pub(super) fn append(&mut self, next: Self) -> Result<()> {
        let Self {
            size,
            properties,
            alignment,
            scaling,
            frames,
        } = next;
        // Of the same inputs and options all this is the same. The pairs of frames, which parts do
        // not keep, are no longer needed.
        ensure!(
            self.size == size
                && self.properties == properties
                && self.alignment == alignment
                && self.scaling == scaling,
            "the parts state other properties of the videos"
        );
        self.frames.extend(frames);
        Ok(())
    }
}
