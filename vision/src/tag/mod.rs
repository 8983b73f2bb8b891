//! Tags: square fiducial markers with a number, in pictures, and boards of them.
//!
//! [`detect`] finds the tags of a [`Dictionary`] of ArUco or AprilTag: dark quadrangles in the
//! picture at several thresholds, whose corners are where lines through their edges meet, and whose
//! modules are read through the homography of these. [`CharucoBoard`] and [`AprilGrid`] tell which
//! points of a board are seen where.
//!
//! Places are pixel coordinates `[u, v]`: u to the right and v down from the centre of the top left
//! pixel, as OpenCV has them.

mod april_grid;
mod charuco;
mod code;
mod consistency;
mod detect;
mod dictionary;
mod edge;
mod error;
mod marker;
mod quad;
mod words;

pub use april_grid::AprilGrid;
pub use charuco::{CharucoBoard, CharucoPattern};
pub use detect::detect;
pub use dictionary::{Dictionary, UnknownDictionary};
pub use error::TagError;
pub use marker::{Tag, TagOptions};
