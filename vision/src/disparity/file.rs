//! Disparity maps in files.
//!
//! A map is stored as a PFM file with one float for each pixel, as the Middlebury data sets have
//! it: rows from the bottom upwards, the order of the bytes told by the sign of the scale in the
//! header, infinity where the disparity is unknown. The magnitude of the scale is not applied.
//!
//! Truths also come as grey PNG files with 8 or 16 bits, which store a multiple of the disparity.

use std::path::Path;

use ga_files::ReadError;
use ga_image::file::{self, FormatError};
use ga_image::pfm::{self, ByteOrder};
use ga_image::picture::Picture;
use ga_image::plane::Plane;

use super::DisparityMap;
use crate::disparity::StereoError;

/// The disparity map in the bytes of a PFM file. Numbers that are not finite are unknown.
///
/// # Errors
///
/// [`StereoError::Format`] with what is wrong with the bytes, and
/// [`StereoError::Kind`] for a PFM file in colour.
pub fn decode(bytes: &[u8]) -> Result<DisparityMap, StereoError> {
    match pfm::decode(bytes)? {
        Picture::GreyF32(pixels) => Ok(DisparityMap::new(pixels)),
        other => Err(StereoError::Kind {
            kind: other.view().kind(),
        }),
    }
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
/// assert_eq!(file::decode(&bytes)?, map);
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

/// Reads a PFM file; see [`decode`].
///
/// # Errors
///
/// [`ReadError`], which names the file and says why: it cannot be read, or a
/// [`StereoError`].
pub fn read(path: impl AsRef<Path>) -> Result<DisparityMap, ReadError<StereoError>> {
    ga_files::read(path, decode)
}

/// Writes a PFM file, whole or not at all; see [`encode`].
///
/// # Errors
///
/// [`StereoError::Format`] and [`StereoError::Write`].
pub fn write(path: impl AsRef<Path>, map: &DisparityMap) -> Result<(), StereoError> {
    Ok(ga_files::write(path, &encode(map)?)?)
}

/// The true disparities in the bytes of a picture file of any kind, PFM, PNG or PGM: the stored
/// numbers, divided by `scale`. Numbers that are not finite are unknown. A stored 0 remains 0;
/// [`ErrorMap`](super::evaluation::ErrorMap) leaves it out.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_vision::disparity::file;
///
/// let bytes = ga_image::png::encode(&Plane::filled(2, 2, 30u8))?;
/// assert_eq!(file::decode_truth(&bytes, 4.0)?.get(1, 1), Some(7.5));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// [`StereoError::Format`], [`StereoError::Kind`] and [`StereoError::Scale`].
pub fn decode_truth(bytes: &[u8], scale: f64) -> Result<DisparityMap, StereoError> {
    if !(scale > 0.0 && scale.is_finite()) {
        return Err(StereoError::Scale { scale });
    }
    let stored: Plane<f32> = match file::decode(bytes)? {
        Picture::GreyF32(pixels) => pixels,
        Picture::Grey8(pixels) => pixels.map(f32::from),
        Picture::Grey16(pixels) => pixels.map(f32::from),
        other => {
            return Err(StereoError::Kind {
                kind: other.view().kind(),
            });
        }
    };
    Ok(DisparityMap::new(
        stored.map(|value| (f64::from(value) / scale) as f32),
    ))
}

/// Reads true disparities; see [`decode_truth`].
///
/// # Errors
///
/// [`ReadError`], which names the file and says why: it cannot be read, or a
/// [`StereoError`].
pub fn read_truth(
    path: impl AsRef<Path>,
    scale: f64,
) -> Result<DisparityMap, ReadError<StereoError>> {
    ga_files::read(path, |bytes| decode_truth(bytes, scale))
}
