//! How much two pictures differ: mean squared error, PSNR, SSIM and mutual information.

mod error;
mod information;
mod ssim;

pub use error::{mse, psnr};
pub(crate) use error::{squared_error, squared_error_of_bytes};
pub use information::{Information, MutualInformation, mutual_information};
pub use ssim::{Similarity, Ssim};
