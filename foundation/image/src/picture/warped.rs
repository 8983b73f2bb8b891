//! Pictures seen through a map of places.

use super::{Picture, PictureView};
use crate::plane::PlaneError;
use crate::warp::Warp;

impl PictureView<'_> {
    /// The picture seen through a map of places. Outside of it all samples are zero: black, and
    /// transparent where there is an alpha channel.
    ///
    /// # Errors
    ///
    /// [`PlaneError::Differs`] where the map is for pictures of another size.
    pub fn warped(&self, warp: &Warp) -> Result<Picture, PlaneError> {
        Ok(match self {
            Self::Grey8(view) => warp.warped(*view, 0)?.into(),
            Self::GreyAlpha8(view) => warp.warped(*view, [0; 2])?.into(),
            Self::Rgb8(view) => warp.warped(*view, [0; 3])?.into(),
            Self::Rgba8(view) => warp.warped(*view, [0; 4])?.into(),
            Self::Grey16(view) => warp.warped(*view, 0)?.into(),
            Self::GreyAlpha16(view) => warp.warped(*view, [0; 2])?.into(),
            Self::Rgb16(view) => warp.warped(*view, [0; 3])?.into(),
            Self::Rgba16(view) => warp.warped(*view, [0; 4])?.into(),
            Self::GreyF32(view) => warp.warped(*view, 0.0)?.into(),
            Self::RgbF32(view) => warp.warped(*view, [0.0; 3])?.into(),
        })
    }
}
