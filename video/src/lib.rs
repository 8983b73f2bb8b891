//! Videos: frames one after another, as luma and colour differences, and what is measured of them.
//!
//! Reading:
//!
//! - [`frame`](mod@frame): one frame, with its number and its time, and what all frames of a video
//!   share.
//! - [`source`]: where frames come from, and [`open`] for files of any known kind.
//! - [`images`]: numbered pictures; [`stereo`]: videos of two views.
//! - `mp4`: H.264 in MP4, also written (feature `mp4`).
//! - [`y4m`]: videos without compression, from files and pipes.
//!
//! Measuring:
//!
//! - [`keyframe`]: cuts, shots and key frames.
//! - [`attention`]: which parts of a frame people look at.
//! - [`quality`]: how much a video differs from a reference, and where people look.
//! - [`opinion`]: how well a measure of quality predicts what people say, and tables of ratings.
//! - `comfort`: how comfortable stereoscopic video is to watch (feature `comfort`, a default).

pub mod attention;
#[cfg(feature = "comfort")]
pub mod comfort;
mod error;
pub mod ffmpeg;
pub mod frame;
pub mod images;
pub mod keyframe;
#[cfg(feature = "mp4")]
pub mod mp4;
mod open;
pub mod opinion;
pub mod quality;
pub mod source;
pub mod stereo;
pub mod y4m;

pub use error::VideoError;
pub use frame::{Frame, Planes, Properties, Samples};
pub use open::{open, open_with_stills};
pub use source::Source;
