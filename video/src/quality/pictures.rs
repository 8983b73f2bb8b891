//! The measures of two pictures.

use ga_image::grey::Luma;
use ga_image::picture::Picture;
use ga_image::plane::{Plane, PlaneError};
use ga_image::quality::{Ssim, Weights};
use ga_image::sample::Pixel;

use super::measures::{Measures, Meter};
use super::video::FrameQuality;

/// Compares two pictures, as a video of one frame, in luma by BT.601: with 8 bits where both have
/// 8, otherwise as floats from 0 to 1. Weights are those of `map`, or of the model of
/// [`Attention`](crate::attention::Attention).
///
/// ```
/// use ga_image::picture::Picture;
/// use ga_image::plane::Plane;
/// use ga_video::quality::compare_pictures;
///
/// let reference = Plane::from_fn(64, 48, |column, row| (column * row % 200) as u8);
/// let noisy = reference.map(|level| level ^ 4);
/// let found = compare_pictures(&Picture::Grey8(reference), &Picture::Grey8(noisy), None)?;
/// // Each level is off by 4 of 255.
/// assert!((found.luma.psnr - 20.0 * (255.0_f64 / 4.0).log10()).abs() < 1e-9);
/// # Ok::<(), ga_image::plane::PlaneError>(())
/// ```
///
/// # Errors
///
/// Those of [`Meter::compare`].
pub fn compare_pictures(
    reference: &Picture,
    distorted: &Picture,
    map: Option<Weights>,
) -> Result<FrameQuality, PlaneError> {
    let seen: Plane<u8> = reference.to_grey(Luma::Bt601);
    let luma = if has_eight_bits(reference) && has_eight_bits(distorted) {
        compare(&seen, &distorted.to_grey(Luma::Bt601), &seen, map, 255.0)?
    } else {
        let [reference, distorted] = floats(reference, distorted);
        compare(&reference, &distorted, &seen, map, 1.0)?
    };
    Ok(FrameQuality {
        index: 0,
        time_seconds: 0.0,
        luma,
        psnr_differences: None,
    })
}

/// SSIM around each pixel as a grey picture: negative values are black, 1 is white.
///
/// # Errors
///
/// Those of [`Ssim::map`].
pub fn similarity_map(reference: &Picture, distorted: &Picture) -> Result<Plane<u8>, PlaneError> {
    let [reference, distorted] = floats(reference, distorted);
    let map = Ssim::new(1.0).map(&reference, &distorted)?;
    Ok(map.map(|ssim| (255.0 * ssim.clamp(0.0, 1.0)).round() as u8))
}

/// The lumas from 0 to 1.
fn floats(reference: &Picture, distorted: &Picture) -> [Plane; 2] {
    [reference, distorted].map(|picture| picture.to_grey(Luma::Bt601))
}

fn compare<P: Pixel>(
    reference: &Plane<P>,
    distorted: &Plane<P>,
    seen: &Plane<u8>,
    map: Option<Weights>,
    range: f64,
) -> Result<Measures, PlaneError> {
    let mut meter = match map {
        Some(map) => Meter::with_map(map, range),
        None => Meter::new([seen.width(), seen.height()], range)?,
    };
    meter.compare(reference, distorted, seen)
}

fn has_eight_bits(picture: &Picture) -> bool {
    matches!(
        picture,
        Picture::Grey8(_) | Picture::GreyAlpha8(_) | Picture::Rgb8(_) | Picture::Rgba8(_)
    )
}
