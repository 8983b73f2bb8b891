//! Videos: frames one after another, as luma and colour differences.
//!
//! - [`frame`](mod@frame): one frame, with its number and its time, and what all frames of a video
//!   share.
//! - [`source`]: where frames come from, and [`open`] for files of any known kind.
//! - [`images`]: numbered pictures; [`stereo`]: videos of two views.
//! - `mp4`: H.264 in MP4 (feature `mp4`).
//! - [`y4m`]: videos without compression, from files and pipes.

mod error;
pub mod frame;
pub mod images;
#[cfg(feature = "mp4")]
pub mod mp4;
pub mod source;
pub mod stereo;
pub mod y4m;

pub use error::VideoError;
pub use frame::{Frame, Planes, Properties, Samples};
pub use source::{Source, open, open_with_stills};
