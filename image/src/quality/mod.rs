//! How much two pictures differ: mean squared error, PSNR and SSIM.

mod error;
mod ssim;

pub use error::{mse, psnr};
pub(crate) use error::{squared_error, squared_error_of_bytes};
pub use ssim::{Similarity, Ssim};
