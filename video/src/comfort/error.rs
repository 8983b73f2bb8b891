//! Why a video cannot be analysed, or not further.

use ga_image::file::FormatError;
use ga_image::plane::PlaneError;

use crate::VideoError;
use ga_vision::disparity::StereoError;

/// Why a stereoscopic video cannot be analysed, or not further, or not be viewed so. Frames are
/// counted from 0; what was given before an error remains valid.
#[derive(Debug, thiserror::Error)]
pub enum ComfortError {
    /// The video cannot be read.
    #[error(transparent)]
    Video(#[from] VideoError),
    /// The video shows one view, not two in one frame.
    #[error(
        "frame {frame}: the video shows one view: its halves are not alike, and the picture \
         continues from one to the other"
    )]
    Mono {
        /// The frame.
        frame: usize,
    },
    /// A view has another size than the views before it.
    #[error("frame {frame}: {source}")]
    Size {
        /// The frame.
        frame: usize,
        /// The sizes.
        source: PlaneError,
    },
    /// The views cannot be matched.
    #[error("frame {frame}: {source}")]
    Match {
        /// The frame.
        frame: usize,
        /// Why.
        source: StereoError,
    },
    /// The video has fewer frames than one eye is late.
    #[error("the video has {frames} frames, and one eye is {delay} frames late")]
    TooShort {
        /// The number of frames.
        frames: usize,
        /// The delay.
        delay: u64,
    },
    /// The video without its defects cannot be written.
    #[error(transparent)]
    Output(#[from] FormatError),
    /// The threads could not be started.
    #[error("the threads of the analysis cannot be started: {0}")]
    Threads(#[from] rayon::ThreadPoolBuildError),
    /// A length of the viewing conditions is not positive and finite.
    #[error("the {quantity} of {metres} m is not positive and finite")]
    Viewing {
        /// Which length it is.
        quantity: &'static str,
        /// The length in metres.
        metres: f64,
    },
}

impl ComfortError {
    /// The frame at which the analysis ended, where it did at a frame.
    #[must_use]
    pub fn frame(&self) -> Option<usize> {
        match self {
            Self::Video(error) => error.frame(),
            Self::Mono { frame } | Self::Size { frame, .. } | Self::Match { frame, .. } => {
                Some(*frame)
            }
            Self::TooShort { .. } | Self::Output(_) | Self::Threads(_) | Self::Viewing { .. } => {
                None
            }
        }
    }
}
