//! The quality of pictures and videos against a reference, with and without attention.
//!
//! - [`Meter`]: PSNR, SSIM, MS-SSIM and VIF of two frames, and PSNR and SSIM weighted by attention.
//! - [`Vif`]: visual information fidelity at four scales.
//! - [`VideoComparison`]: the measures of two videos, frame by frame as they are read.
//! - [`TimeAlignment`], [`Scaled`]: videos of other times or another size than their reference.
//! - [`compare_pictures`]: the same of two pictures.
//! - [`MEASURES`]: what is measured, as a list from which reports follow.
//! - [`Same`]: what of two frames is identical, [`mean_ciede2000`]: how far their colours differ.
//! - [`Pooled`]: one number for many frames: mean, harmonic mean, least, percentiles.
//! - [`PictureQuality`], [`VideoQuality`]: all that is reported, with pages; [`svg()`] and
//!   [`csv()`] show the frames.
//!
//! Measures of two planes are in [`ga_image::quality`], the model of attention is in
//! [`attention`](crate::attention).

mod align;
mod colour_difference;
mod entry;
mod mean;
mod measure;
mod measures;
mod number;
mod page;
mod pictures;
mod plot;
mod pooled_entry;
mod pooling;
mod properties;
mod report;
mod same;
mod scale;
mod table;
mod video;
mod vif;

pub use align::{Moments, TimeAlignment};
pub use colour_difference::mean_ciede2000;
pub use entry::MeasureRow;
pub use measure::{MEASURES, Measure, Part, Scale};
pub use measures::{Measures, Meter, SSIM_LEAST_SIDE};
pub use page::ComparedFiles;
pub use pictures::{compare_pictures, similarity_map};
pub use plot::svg;
pub use pooling::{PERCENTILES, Pooled};
pub use properties::{FRAME_COUNT, FRAME_RATE, PropertyDifference};
pub use report::{POOLED, PictureQuality, VideoQuality};
pub use same::Same;
pub use scale::Scaled;
pub use table::csv;
pub use video::{FrameQuality, VideoComparison};
pub use vif::{VIF_LEAST_SIDE, Vif};
