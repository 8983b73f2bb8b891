//! The quality of pictures and videos against a reference, with and without attention.
//!
//! - [`Meter`]: PSNR, SSIM and MS-SSIM of two frames, and PSNR and SSIM weighted by attention.
//! - [`VideoComparison`]: the measures of two videos, frame by frame as they are read.
//! - [`MEASURES`]: what is measured, as a list from which reports follow.
//! - [`Pooled`]: one number for many frames: mean, harmonic mean, least, percentiles.
//!
//! Measures of two planes are in [`ga_image::quality`], the model of attention is in
//! [`attention`](crate::attention).

mod measure;
mod measures;
mod pooling;
mod video;

pub use measure::{MEASURES, Measure, Scale};
pub use measures::{Measures, Meter};
pub use pooling::{PERCENTILES, Pooled};
pub use video::{FrameQuality, VideoComparison};
