//! Key frames of video in two stages, after Cui, §3.1.
//!
//! [`Analyser`] takes the frames of a video one after another and finds its cuts, dissolves and
//! fades, its shots with a background that stands still or moves, and the key frames.
//!
//! - [`signature`]: a frame as its red component over 64 × 36 boxes.
//! - [`layout`]: blocks of objects and of the background; black bars.
//! - [`difference`]: how much two frames differ, block by block.
//! - [`colour`]: the colour of a frame without a picture.
//! - [`cut`], [`dissolve`], [`fade`]: where one shot ends and the next begins.
//! - [`flash`]: a few frames that differ from those around them.
//! - [`shot`]: shots, and whether their background stands still.
//! - [`select`]: first stage, the difference of the background and of objects from the last
//!   candidate; second stage, mutual information at full resolution.
//! - [`analysis`]: all of it, frame by frame.
//! - [`analyse`]: the same of a file, with [`Pictures`] of key frames, a page and a chart.
//! - [`information`](fn@information): what takes the most time, for some of the frames.
//! - [`statistics`]: Cui, table 1. [`evaluation`]: found cuts against labelled ones.
//! - [`scenes`]: shots as CSV and as an edit decision list. [`timecode`]: how frames are counted.
//! - [`split`]: each shot as a film.

pub mod analysis;
mod blend;
pub mod colour;
pub mod cut;
pub mod difference;
pub mod dissolve;
mod error;
pub mod evaluation;
pub mod fade;
pub mod flash;
mod information;
pub mod layout;
mod likeness;
mod page;
mod pictures;
mod plot;
mod reading;
pub mod scenes;
pub mod select;
pub mod shot;
pub mod signature;
pub mod split;
pub mod statistics;
pub mod timecode;
pub mod window;

pub use analysis::{Analyser, Analysis, FrameMeasures, Options};
pub use error::{KeyFrameError, TimeBaseError};
pub use information::information;
pub use pictures::Pictures;
pub use reading::{Analysed, analyse};
pub use select::{KeyFrame, Reason};
pub use shot::{Background, Shot, Transitions};
