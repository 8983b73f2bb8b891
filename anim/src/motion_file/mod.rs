//! Motions in files of any format, chosen by the ending of their names: a [`MotionFile`] is read,
//! and [`Written`] is what a recording becomes in a file.
//!
//! ```
//! use ga_anim::motion_file::{MotionFile, Options};
//!
//! let folder = tempfile::tempdir()?;
//! let path = folder.path().join("arm.bvh");
//! std::fs::write(
//!     &path,
//!     "HIERARCHY ROOT arm { OFFSET 0 0 0 CHANNELS 1 Xposition }
//!      MOTION Frames: 2 Frame Time: 0.5
//!      0
//!      40",
//! )?;
//! let options = Options { metres_per_unit: Some(0.01), ..Options::default() };
//! let file = MotionFile::read(&path, options)?;
//! assert_eq!(file.recording()?.duration(), 0.5);
//! let samples = file.samples(&[0.0, 0.25])?;
//! let [.., x] = samples[1].joints[0].matrix[0];
//! assert!((x - 0.2).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod contents;
mod file;
mod format;
mod loss;
mod sample;
mod written;

pub use contents::Contents;
pub use file::{MotionFile, Options};
pub use format::Format;
pub use loss::Loss;
pub use sample::{JointSample, Sample, TrackSample};
pub use written::{Animations, WriteOptions, Written};
