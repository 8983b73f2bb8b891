//! Why sheets cannot be drawn.

use crate::RenderError;

/// Why a sheet cannot be drawn.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum SheetError {
    /// There are no frames.
    #[error("a contact sheet needs at least one frame")]
    NoFrames,
    /// A frame cannot be drawn.
    #[error("frame {number}: {source}")]
    Frame {
        /// The frame's number.
        number: usize,
        /// Why not.
        source: RenderError,
    },
    /// The figure has no camera that sees it, or the style is not usable.
    #[error(transparent)]
    Picture(#[from] RenderError),
    /// Rows from key to key need at least two key frames, the first frame and the last among them.
    #[error(
        "rows from key to key, but the first and the last of the frames are not two key frames"
    )]
    NotKeyToKey,
    /// A sheet without columns, or one that is too large.
    #[error("a contact sheet of {columns} columns and {rows} rows cannot be made")]
    Size {
        /// Columns of pictures.
        columns: usize,
        /// Rows of pictures.
        rows: usize,
    },
}
