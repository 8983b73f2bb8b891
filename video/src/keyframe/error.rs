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
}
