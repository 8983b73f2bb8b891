//! Pictures as numbers: planes of pixels, colours and files.
//!
//! - [`plane`]: a grid of numbers, one for each pixel, and its blur.
//! - [`colour`]: linear light and its encoding as 8-bit sRGB.
//! - [`png`]: pictures as PNG files.
//!
//! Columns are counted from the left and rows from the top, both from 0. Pictures with 8 bits for
//! each channel are those of the crate [`image`].

pub mod colour;
pub mod plane;
pub mod png;
