//! The quality of pictures and videos against a reference, with and without attention.
//!
//! - [`Meter`]: PSNR, SSIM and MS-SSIM of two frames, and PSNR and SSIM weighted by attention.
//! - [`VideoComparison`]: the measures of two videos, frame by frame as they are read.
//! - [`compare_pictures`]: the same of two pictures.
//! - [`MEASURES`]: what is measured, as a list from which reports follow.
//! - [`Pooled`]: one number for many frames: mean, harmonic mean, least, percentiles.
//! - [`PictureQuality`], [`VideoQuality`]: all that is reported, with pages; [`svg()`] and
//!   [`csv()`] show the frames.
//!
//! Measures of two planes are in [`ga_image::quality`], the model of attention is in
//! [`attention`](crate::attention).

mod measure;
mod measures;
mod page;
mod pictures;
mod plot;
mod pooling;
mod report;
mod table;
mod video;

pub use measure::{MEASURES, Measure, Scale};
pub use measures::{Measures, Meter};
pub use page::ComparedFiles;
pub use pictures::{compare_pictures, similarity_map};
pub use plot::svg;
pub use pooling::{PERCENTILES, Pooled};
pub use report::{MeasureRow, POOLED, PictureQuality, VideoQuality};
pub use table::csv;
pub use video::{FrameQuality, VideoComparison};
