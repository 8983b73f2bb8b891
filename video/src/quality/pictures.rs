//! The measures of two pictures.

use ga_image::grey::Luma;
use ga_image::picture::Picture;
use ga_image::plane::{Plane, PlaneError};
use ga_image::quality::{Ssim, Weights, psnr};
use ga_image::sample::{Pixel, Sample};
use ga_image::ycbcr::{Range, YCbCr};

use super::colour_difference::mean_ciede2000;
use super::measures::{Measures, Meter};
use super::same::Same;
use super::video::FrameQuality;

/// Compares two pictures, as a video of one frame, in luma by BT.601: with 8 bits where both have
/// 8, otherwise as floats from 0 to 1. Weights are those of `map`, or of the model of
/// [`Attention`](crate::attention::Attention).
///
/// Pictures in colour are also compared in Cb and Cr by BT.601, from 0 to 255 and not rounded, and
/// in all samples of red, green and blue; alpha is compared for identity alone.
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
/// assert_eq!(found.same.differing(), ["luma", "colours"]);
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
    let has_eight_bits = [reference, distorted].into_iter().all(has_eight_bits);
    let luma = if has_eight_bits {
        compare(&seen, &distorted.to_grey(Luma::Bt601), &seen, map, 255.0)?
    } else {
        let [reference, distorted] = floats(reference, distorted);
        compare(&reference, &distorted, &seen, map, 1.0)?
    };
    let (psnr_all, ciede2000) = if has_eight_bits {
        let [a, b] = [reference, distorted].map(Picture::to_rgb::<u8>);
        (psnr(&a, &b, 255.0)?, Some(mean_ciede2000(&a, &b)))
    } else {
        let [a, b] = [reference, distorted].map(Picture::to_rgb::<f32>);
        (psnr(&a, &b, 1.0)?, None)
    };
    let is_in_colour = [reference, distorted].into_iter().any(is_in_colour);
    let psnr_differences = is_in_colour.then(|| psnr_differences(reference, distorted));
    let same = match [reference, distorted].into_iter().any(has_floats) {
        true => same::<f32>(reference, distorted),
        false => same::<u16>(reference, distorted),
    };
    Ok(FrameQuality {
        index: 0,
        time_seconds: 0.0,
        distorted_index: 0,
        time_offset_seconds: 0.0,
        luma,
        psnr_differences: psnr_differences.transpose()?,
        psnr_all,
        ciede2000,
        same: Same {
            luma: luma.mse == 0.0,
            ..same
        },
    })
}

/// PSNR of Cb and Cr by BT.601 in the range of pictures, whose numbers are not rounded.
fn psnr_differences(reference: &Picture, distorted: &Picture) -> Result<[f64; 2], PlaneError> {
    let encoding = YCbCr {
        luma: Luma::Bt601,
        range: Range::Full,
    };
    let [a, b] = [reference, distorted].map(|picture| {
        let rgb = picture.to_rgb::<f32>();
        rgb.map(|rgb: [f32; 3]| encoding.encoded(rgb.map(|channel| 255.0 * channel)))
    });
    let channel = |channel: usize| {
        let [a, b] = [&a, &b].map(|plane| plane.map(|encoded: [f32; 3]| encoded[channel]));
        psnr(&a, &b, 255.0)
    };
    Ok([channel(1)?, channel(2)?])
}

/// Whether colours and alpha are the same in numbers of a kind that holds both exactly.
fn same<T: Sample>(reference: &Picture, distorted: &Picture) -> Same {
    let [a, b] = [reference, distorted].map(Picture::to_rgba::<T>);
    let mut pairs = a.values().iter().zip(b.values());
    Same {
        colours: pairs.clone().all(|(a, b)| a[..3] == b[..3]),
        alpha: pairs.all(|(a, b)| a[3] == b[3]),
        ..Same::ALL
    }
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

/// The lumas from 0 to 1. They are not rounded to the depth of a picture, so that those of the same
/// colours with 8 and with 16 bits are equal.
fn floats(reference: &Picture, distorted: &Picture) -> [Plane; 2] {
    [reference, distorted].map(|picture| Luma::Bt601.plane(&picture.to_rgb::<f32>()))
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

fn has_floats(picture: &Picture) -> bool {
    matches!(picture, Picture::GreyF32(_) | Picture::RgbF32(_))
}

fn is_in_colour(picture: &Picture) -> bool {
    match picture {
        Picture::Grey8(_)
        | Picture::GreyAlpha8(_)
        | Picture::Grey16(_)
        | Picture::GreyAlpha16(_)
        | Picture::GreyF32(_) => false,
        Picture::Rgb8(_)
        | Picture::Rgba8(_)
        | Picture::Rgb16(_)
        | Picture::Rgba16(_)
        | Picture::RgbF32(_) => true,
    }
}
