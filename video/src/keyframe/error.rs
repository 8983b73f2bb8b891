//! Why the key frames of a video cannot be found or kept.

use std::io;
use std::path::PathBuf;

use ga_image::file::FormatError;

use crate::VideoError;

/// Why the key frames of a video cannot be found or kept.
#[derive(Debug, thiserror::Error)]
pub enum KeyFrameError {
    /// The video cannot be read.
    #[error(transparent)]
    Video(#[from] VideoError),
    /// A frame cannot be analysed.
    #[error("{}: {problem}", file.display())]
    Frame {
        /// The video.
        file: PathBuf,
        /// What is wrong.
        problem: Box<VideoError>,
    },
    /// Pictures cannot be kept on disk.
    #[error("cannot {task} a temporary file: {source}")]
    Temporary {
        /// What failed, such as `write to`.
        task: &'static str,
        /// What the operating system said.
        source: io::Error,
    },
    /// A picture of a frame that is not later than those before.
    #[error("the picture of frame {frame} comes after that of frame {after}")]
    Order {
        /// The frame.
        frame: usize,
        /// The last frame before.
        after: usize,
    },
    /// A picture cannot be kept.
    #[error("cannot keep the picture of frame {frame}: {problem}")]
    Picture {
        /// The number of the frame.
        frame: usize,
        /// What is wrong.
        problem: FormatError,
    },
    /// A shot cannot be written as a film.
    #[error("cannot write the shots: {0}")]
    Split(String),
}

/// Why frames cannot be counted.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum TimeBaseError {
    /// Half a frame in a second is the least.
    #[error("{0} frames in a second: it must be a rate from 1/2 on")]
    Rate(String),
    /// The timecode of the first frame is none.
    #[error(
        "{0:?} is no timecode of this rate: it must be HH:MM:SS:FF, or HH:MM:SS;FF where numbers \
         are dropped, and of a frame that is counted"
    )]
    Start(String),
    /// Numbers are dropped at a rate for which this is not defined.
    #[error("numbers of frames are dropped at 30000/1001 and 60000/1001 in a second, not at {0}")]
    Drop(String),
}
