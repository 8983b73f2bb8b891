//! Disparity maps in files.
//!
//! PFM files hold one float for each pixel, as the Middlebury data sets have it: rows from the
//! bottom upwards, the order of the bytes told by the sign of the scale in the header, infinity
//! where the disparity is unknown. The magnitude of the scale is not applied.
//!
//! Grey PNG and PGM files with 8 or 16 bits hold a multiple of each disparity, and 0 where it is
//! unknown. That of 16 bits is [`KITTI_SCALE`] unless another one is given.

use std::path::Path;

use ga_files::ReadError;
use ga_image::file::{self, FormatError};
use ga_image::pfm::{self, ByteOrder};
use ga_image::picture::Picture;
use ga_image::plane::Plane;
use ga_image::png;

use super::DisparityMap;
use crate::disparity::StereoError;

/// Pictures of 16 bits hold this number × the disparity, as those of the KITTI data sets do.
pub const KITTI_SCALE: f64 = 256.0;

/// The disparity map in the bytes of a picture file in grey: the stored numbers, divided by
/// `scale`. Without one, those of 16 bits are divided by [`KITTI_SCALE`], and others are
/// disparities. Floats that are not finite are unknown, and so are whole numbers that are 0.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_vision::disparity::file;
///
/// let bytes = ga_image::png::encode(&Plane::from_values(2, 1, vec![30u8, 0])?)?;
/// let map = file::decode(&bytes, Some(4.0))?;
/// assert_eq!((map.get(0, 0), map.get(1, 0)), (Some(7.5), None));
/// let deep = ga_image::png::encode(&Plane::filled(1, 1, 640u16))?;
/// assert_eq!(file::decode(&deep, None)?.get(0, 0), Some(2.5));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// [`StereoError::Format`] with what is wrong with the bytes, [`StereoError::Kind`] for a picture
/// that is not grey, and [`StereoError::Scale`].
pub fn decode(bytes: &[u8], scale: Option<f64>) -> Result<DisparityMap, StereoError> {
    if let Some(scale) = scale.filter(|scale| !(*scale > 0.0 && scale.is_finite())) {
        return Err(StereoError::Scale { scale });
    }
    let whole = |number: u16| match number {
        0 => f32::NAN,
        _ => f32::from(number),
    };
    let (stored, usual): (Plane<f32>, f64) = match file::decode(bytes)? {
        Picture::GreyF32(pixels) => (pixels, 1.0),
        Picture::Grey8(pixels) => (pixels.map(|number| whole(number.into())), 1.0),
        Picture::Grey16(pixels) => (pixels.map(whole), KITTI_SCALE),
        other => {
            return Err(StereoError::Kind {
                kind: other.view().kind(),
            });
        }
    };
    let scale = scale.unwrap_or(usual);
    Ok(DisparityMap::new(
        stored.map(|value| (f64::from(value) / scale) as f32),
    ))
}

/// Reads a disparity map; see [`decode`].
///
/// # Errors
///
/// [`ReadError`], which names the file and says why: it cannot be read, or a
/// [`StereoError`].
pub fn read(
    path: impl AsRef<Path>,
    scale: Option<f64>,
) -> Result<DisparityMap, ReadError<StereoError>> {
    ga_files::read(path, |bytes| decode(bytes, scale))
}

/// The bytes of a PFM file with the lowest byte of each float first; unknown disparities are stored
/// as infinity.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_vision::disparity::{DisparityMap, file};
///
/// let map = DisparityMap::new(Plane::from_values(1, 2, vec![0.25, f32::NAN])?);
/// let bytes = file::encode(&map)?;
/// // The bottom row is stored first.
/// assert_eq!(bytes, b"Pf\n1 2\n-1.0\n\0\0\x80\x7f\0\0\x80\x3e");
/// assert_eq!(file::decode(&bytes, None)?, map);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// [`FormatError::Size`] when the map has no pixels.
pub fn encode(map: &DisparityMap) -> Result<Vec<u8>, FormatError> {
    if map.known() == map.plane().values().len() {
        return pfm::encode(map.plane(), ByteOrder::Little);
    }
    let stored = |value: f32| if value.is_nan() { f32::INFINITY } else { value };
    pfm::encode(&map.plane().map(stored), ByteOrder::Little)
}

/// The bytes of a grey PNG file with 16 bits, as KITTI has it: each disparity × [`KITTI_SCALE`],
/// rounded, and 0 where it is unknown. A disparity that would be 0 is stored as 1.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_vision::disparity::{DisparityMap, file};
///
/// let map = DisparityMap::new(Plane::from_values(2, 1, vec![12.25, f32::NAN])?);
/// assert_eq!(file::decode(&file::encode_png(&map)?, None)?, map);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// [`StereoError::NotInPng`] for a disparity that is negative or too great, and
/// [`StereoError::Format`] when the map has no pixels.
pub fn encode_png(map: &DisparityMap) -> Result<Vec<u8>, StereoError> {
    let greatest = f64::from(u16::MAX) / KITTI_SCALE;
    for disparity in map.range().unwrap_or_default() {
        if !(0.0..=greatest).contains(&f64::from(disparity)) {
            return Err(StereoError::NotInPng {
                disparity,
                greatest,
            });
        }
    }
    let stored = |value: f32| match value.is_nan() {
        true => 0,
        // The conversion saturates.
        false => ((f64::from(value) * KITTI_SCALE).round() as u16).max(1),
    };
    Ok(png::encode(&map.plane().map(stored))?)
}

/// Writes a PFM file, whole or not at all; see [`encode`].
///
/// # Errors
///
/// [`StereoError::Format`] and [`StereoError::Write`].
pub fn write(path: impl AsRef<Path>, map: &DisparityMap) -> Result<(), StereoError> {
    Ok(ga_files::write(path, &encode(map)?)?)
}
