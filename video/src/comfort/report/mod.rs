//! The report of the comfort of a video as a page that needs no other file: what is good and what
//! to mend first, all scores over time, the depth budget, and the worst moments as pictures.
//!
//! A [`Report`] is told of each frame while the video is read, as by an
//! [`Observer`](crate::comfort::Observer).

mod axis;
mod causes;
mod depth;
mod heat;
mod kept;
mod moments;
mod notes;
mod page;
mod raw;
mod thumbnail;
mod verdict;
mod words;

use crate::comfort::{Dimension, FrameMeasures, Level, Record, Timeline, Viewing};
use crate::{Frame, Properties};

use causes::Heights;
use moments::Moments;
pub use notes::notes;

/// Whether `nullcone video align` removes something that strains the eyes in a frame.
#[must_use]
pub fn can_align(record: &Record, viewing: &Viewing) -> bool {
    Dimension::ALL.into_iter().any(|dimension| {
        let score = record.row(dimension).score;
        let strains = score.is_ok_and(|score| score.level() != Level::Green);
        strains && words::can_align(record, dimension, viewing)
    })
}

/// What the page says of the video besides measurements.
#[derive(Clone, Debug)]
pub struct About {
    /// The names of the files.
    pub title: String,
    /// The command that removes what can be removed; `None` for standard input.
    pub align: Option<String>,
    /// Its options that shift parallax as is recommended for these viewers.
    pub shift: String,
    /// Of each view.
    pub properties: Properties,
    /// Where the viewers sit.
    pub viewing: Viewing,
}

/// What is gathered while a video is read. Memory does not depend on its length.
#[derive(Debug)]
pub struct Report {
    about: About,
    timeline: Timeline,
    moments: Moments,
    heights: Heights,
    last_seconds: f64,
}

impl Report {
    /// Of no frame yet.
    #[must_use]
    pub fn new(about: About) -> Self {
        Self {
            timeline: Timeline::default(),
            moments: Moments::new(about.viewing, about.properties.pixel_aspect),
            heights: Heights::default(),
            about,
            last_seconds: 0.0,
        }
    }

    /// Keeps the views of a frame until it is known whether they are shown.
    pub fn measured(&mut self, views: &[Frame; 2], measures: &FrameMeasures) {
        self.moments.measured(views, measures);
    }

    /// Adds a frame.
    pub fn complete(&mut self, record: Record) {
        self.timeline.add(&record);
        if let Some(geometry) = &record.measures.geometry {
            self.heights.add(geometry, self.about.properties.size);
        }
        self.last_seconds = record.time_seconds;
        self.moments.complete(record);
    }

    /// Frames in a second.
    fn rate(&self, frames: usize) -> [u32; 2] {
        self.about.properties.rate(frames, self.last_seconds)
    }
}
