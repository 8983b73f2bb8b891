//! Which pixels count in an evaluation, and which of them both cameras see.

use std::path::Path;

use ga_files::ReadError;
use ga_image::file;
use ga_image::picture::Picture;
use ga_image::plane::{Plane, PlaneView};

use super::DisparityMap;
use super::error::StereoError;

/// Which cameras see what a pixel of the left view shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Seen {
    /// Both.
    ByBoth,
    /// The left one: something hides it from the right one, or it is outside the right view.
    ByLeft,
}

/// Which cameras see what each pixel shows; `None` for pixels that do not count.
#[derive(Clone, Debug, PartialEq)]
pub struct Visibility {
    pixels: Plane<Option<Seen>>,
}

impl Visibility {
    /// The mask in the bytes of a picture file in grey, as Middlebury's `mask0nocc.png`: white
    /// pixels are seen by both cameras, those of half the range, 128 of 255, by the left camera,
    /// and black ones do not count. Where the levels are 0 and 1, 1 is white.
    ///
    /// # Errors
    ///
    /// [`StereoError::Format`], [`StereoError::Mask`] for a picture that is not grey, and
    /// [`StereoError::MaskLevel`] for another level.
    pub fn decode_mask(bytes: &[u8]) -> Result<Self, StereoError> {
        let (levels, white, half): (Plane<u16>, _, _) = match file::decode(bytes)? {
            Picture::Grey8(pixels) => (pixels.map(u16::from), 255, 128),
            Picture::Grey16(pixels) => (pixels, u16::MAX, 1 << 15),
            other => {
                let kind = other.view().kind();
                return Err(StereoError::Mask { kind });
            }
        };
        let is_binary = levels.values().iter().all(|&level| level <= 1);
        let is_known = |level: u16| is_binary || [0, half, white].contains(&level);
        if let Some(&level) = levels.values().iter().find(|&&level| !is_known(level)) {
            return Err(StereoError::MaskLevel { level });
        }
        let state = |level: u16| match level {
            0 => None,
            _ if level == half => Some(Seen::ByLeft),
            _ => Some(Seen::ByBoth),
        };
        Ok(Self {
            pixels: levels.map(state),
        })
    }

    /// Reads a mask; see [`decode_mask`](Self::decode_mask).
    ///
    /// # Errors
    ///
    /// [`ReadError`], which names the file and says why: it cannot be read, or a [`StereoError`].
    pub fn read_mask(path: impl AsRef<Path>) -> Result<Self, ReadError<StereoError>> {
        ga_files::read(path, Self::decode_mask)
    }

    /// From the truth of the pixels that both cameras see, as KITTI's `disp_noc`: others are seen
    /// by the left camera. All count.
    #[must_use]
    pub fn from_truth_of_visible(truth: &DisparityMap) -> Self {
        let state = |disparity: f32| match disparity.is_finite() && disparity != 0.0 {
            true => Some(Seen::ByBoth),
            false => Some(Seen::ByLeft),
        };
        Self {
            pixels: truth.plane().map(state),
        }
    }

    /// All pixels.
    #[must_use]
    pub fn view(&self) -> PlaneView<'_, Option<Seen>> {
        self.pixels.view()
    }
}
