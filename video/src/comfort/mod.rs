//! The comfort of stereoscopic video: how much two views differ in what they should share, and how
//! much depth there is between them.
//!
//! Each quantity is a row of Cui, table 6, a [`Dimension`]. Its raw number, in a stated unit, gives
//! a [`Score`] from 0 to 15 by the limits of a [`Scale`]: green up to 7, orange up to 13, red
//! above. Angles are those at which a viewer sees the picture on a screen; see [`Viewing`]. Where a
//! frame does not show what is needed, a row has no score and says why: see [`Missing`].

pub mod align;
pub mod asynchrony;
mod change;
mod depth;
mod deviation;
mod dimension;
mod error;
mod formats;
mod frame;
mod geometry;
mod jackknife;
mod matching;
pub mod monitor;
mod observer;
mod order;
mod parallax;
mod part;
mod photometry;
mod record;
pub mod report;
mod row;
mod runs;
mod scale;
mod sharpness;
mod shift;
pub mod stereoscopy;
mod summary;
mod timeline;
mod tone;
mod viewing;

pub use dimension::{Dimension, Unit};
pub use error::ComfortError;
pub use frame::{FrameMeasures, FrameMeter};
pub use geometry::Geometry;
pub use matching::Match;
pub use observer::Observer;
pub use parallax::{Histogram, Parallax};
pub use part::measure;
pub use photometry::Photometry;
pub use record::Record;
pub use row::{Missing, Row};
pub use runs::FrameRuns;
pub use scale::{Level, SIZE, Scale, Score};
pub use shift::comfortable_shift;
pub use summary::{RowSummary, Summary, meaning};
pub use timeline::{DepthSummary, Interval, Timeline};
pub use tone::Tone;
pub use viewing::Viewing;
