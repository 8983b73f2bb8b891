//! How much two pictures differ: mean squared error, PSNR, SSIM, MS-SSIM, the first two
//! also with a weight for each pixel, and mutual information.

mod error;
mod information;
mod multiscale;
mod ssim;
mod weighted;

use error::peak_ratio;
pub use error::{mse, psnr};
pub use information::{Information, MutualInformation, mutual_information};
pub use multiscale::{MULTISCALE_LEAST_SIDE, MultiScale, SCALES};
pub use ssim::{Similarity, Ssim, WeightedSimilarity};
pub use weighted::{Weights, weighted_mse, weighted_psnr};
