//! Pictures as numbers: planes of pixels, filters, quality, colours and files.
//!
//! - [`plane`]: grids of pixels, owned and borrowed; [`sample`]: what a pixel may be.
//! - [`picture`]: pictures whose kind of pixel is known only at run time.
//! - [`file`](mod@file): reading and writing pictures of any known format; [`png`], [`jpeg`],
//!   [`pnm`], [`pfm`] and [`y4m`]: each format with all that it offers; [`orientation`]: which side
//!   of a picture is up.
//! - [`film`]: films that are written while their pictures are made.
//! - [`colour`]: linear light and its encoding as 8-bit sRGB; [`grey`](mod@grey): from colour to
//!   grey; [`ycbcr`]: the encoding of video.
//! - [`filter`]: Gaussian blur and gradients; [`pyramid`]: halved sizes; [`resample`]: other sizes;
//!   [`interpolation`]: values between pixels; [`warp`]: pictures seen through a map of places.
//! - [`threshold`]: pixels above a level; [`canny`]: edges.
//! - [`quality`]: PSNR and SSIM of two pictures.
//! - [`sensor`]: exposure and noise; [`grain`](mod@grain): noise of several sizes.
//!
//! Columns are counted from the left and rows from the top, both from 0. The pixel in column *c*
//! and row *r* covers the square from (*c*, *r*) to (*c* + 1, *r* + 1): its centre is at
//! (*c* + ½, *r* + ½).
//!
//! ```
//! use ga_image::file;
//! use ga_image::filter::{Border, Gaussian};
//! use ga_image::grey::Luma;
//! use ga_image::plane::Plane;
//!
//! let folder = tempfile::tempdir()?;
//! let path = folder.path().join("picture.png");
//! let picture = Plane::from_fn(64, 48, |column, row| [4 * column as u8, 5 * row as u8, 0]);
//! file::write(&path, &picture)?;
//!
//! let grey = file::read(&path)?.to_grey::<f32>(Luma::Bt601);
//! let smooth = Gaussian::new(2.0)?.blur(&grey, Border::Mirror);
//! file::write(folder.path().join("smooth.pfm"), &smooth)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod canny;
pub mod colour;
mod decoder;
pub mod file;
pub mod film;
pub mod filter;
mod format;
mod format_error;
pub mod grain;
pub mod grey;
mod header;
pub mod interpolation;
pub mod jpeg;
mod luma;
pub mod orientation;
mod oriented;
pub mod pfm;
pub mod picture;
pub mod plane;
pub mod png;
pub mod pnm;
pub mod pyramid;
pub mod quality;
pub mod resample;
pub mod sample;
mod save;
pub mod sensor;
mod size;
pub mod threshold;
pub mod warp;
pub mod y4m;
pub mod ycbcr;
