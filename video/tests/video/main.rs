//! Videos and their measures against other programs and clips that are known.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod attention;
mod comfort;
mod comfort_over_time;
mod keyframe;
mod opinion;
mod quality;
mod source;
