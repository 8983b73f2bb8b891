//! The report of the comfort of a video as a page that needs no other file.

mod axis;
mod depth;
mod heat;
mod kept;
mod moments;
mod page;
mod raw;
mod thumbnail;
mod verdict;
mod words;

use ga_video::comfort::{Dimension, FrameMeasures, Level, Record, Timeline, Viewing};
use ga_video::{Frame, Properties};

use crate::commands::video::input::rate;
use moments::Moments;

/// Whether `nullcone video align` removes something that strains the eyes in a frame.
pub(super) fn can_align(record: &Record, viewing: &Viewing) -> bool {
    Dimension::ALL.into_iter().any(|dimension| {
        let score = record.row(dimension).score;
        let strains = score.is_ok_and(|score| score.level() != Level::Green);
        strains && words::can_align(record, dimension, viewing)
    })
}

/// What the page says of the video besides measurements.
pub(super) struct About {
    /// The names of the files.
    pub(super) title: String,
    /// The command that removes what can be removed; `None` for standard input.
    pub(super) align: Option<String>,
    /// Of each view.
    pub(super) properties: Properties,
    pub(super) viewing: Viewing,
}

/// What is gathered while a video is read. Memory does not depend on its length.
pub(super) struct Report {
    about: About,
    timeline: Timeline,
    moments: Moments,
    last_seconds: f64,
}

impl Report {
    pub(super) fn new(about: About) -> Self {
        Self {
            timeline: Timeline::default(),
            moments: Moments::new(about.viewing),
            about,
            last_seconds: 0.0,
        }
    }

    pub(super) fn measured(&mut self, views: &[Frame; 2], measures: &FrameMeasures) {
        self.moments.measured(views, measures);
    }

    pub(super) fn complete(&mut self, record: Record) {
        self.timeline.add(&record);
        self.last_seconds = record.time_seconds;
        self.moments.complete(record);
    }

    /// Frames in a second.
    fn rate(&self, frames: usize) -> [u32; 2] {
        rate(&self.about.properties, frames, self.last_seconds)
    }
}
