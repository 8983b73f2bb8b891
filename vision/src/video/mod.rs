//! Videos: frames one after another, as luma and colour differences.
//!
//! - [`frame`]: one frame, with its number and its time, and what all frames of a video share.

pub mod frame;

pub use frame::{Frame, Planes, Properties, Samples};
