//! The measures of two pictures.

use anyhow::{Context, Result};
use ga_image::grey::Luma;
use ga_image::picture::Picture;
use ga_image::plane::{Plane, PlaneError};
use ga_image::png;
use ga_image::quality::{Ssim, Weights};
use ga_image::sample::Pixel;
use ga_video::quality::{Measures, Meter};

/// Compares pictures in luma by BT.601: with 8 bits where both have 8, otherwise as floats from 0
/// to 1.
pub(super) fn measure(
    reference: &Picture,
    distorted: &Picture,
    map: Option<Weights>,
) -> Result<Measures, PlaneError> {
    let seen: Plane<u8> = reference.to_grey(Luma::Bt601);
    if has_eight_bits(reference) && has_eight_bits(distorted) {
        compare(&seen, &distorted.to_grey(Luma::Bt601), &seen, map, 255.0)
    } else {
        let [reference, distorted]: [Plane; 2] =
            [reference, distorted].map(|picture| picture.to_grey(Luma::Bt601));
        compare(&reference, &distorted, &seen, map, 1.0)
    }
}

/// SSIM around each pixel as a grey picture: negative values are black, 1 is white.
pub(super) fn similarity_png(reference: &Picture, distorted: &Picture) -> Result<Vec<u8>> {
    let [reference, distorted]: [Plane; 2] =
        [reference, distorted].map(|picture| picture.to_grey(Luma::Bt601));
    let map = Ssim::new(1.0).map(&reference, &distorted)?;
    let levels = map.map(|ssim| (255.0 * ssim.clamp(0.0, 1.0)).round() as u8);
    png::encode(&levels).context("cannot encode the map of SSIM")
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
