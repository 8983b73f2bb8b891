//! Models of COLMAP: `cameras.txt` and `images.txt`, or `cameras.bin` and `images.bin`, in a
//! folder.
//!
//! Each image is a camera, named after it, with the pose that the model states; without the images,
//! each of the cameras is one, named by its number, without a pose. A quaternion, the scalar first,
//! and a translation take the world into the camera's frame. The middle of the first pixel is
//! (0.5, 0.5) there, and lengths are in the unit of the model, which no file states.
//!
//! Pictures are looked for in the folder, and in the folder `images` beside it or above it.

mod binary;
mod device;
mod model;
mod text;

use std::path::{Path, PathBuf};

use device::{Device, Shot};

use super::camera_file::{CameraFile, NamedCamera};
use super::error::{CameraFileError, Place};
use crate::LensModel;

pub(super) use text::is_camera_line;

/// The names of the file of cameras and of that of images, by the ending.
const TEXT: [&str; 2] = ["cameras.txt", "images.txt"];
/// The names of the files that are written.
pub(super) const NAMES: [&str; 3] = [TEXT[0], TEXT[1], "points3D.txt"];
const BINARY: [&str; 2] = ["cameras.bin", "images.bin"];

/// The texts of a model by their names; that of images where the poses are known.
pub(super) fn encode(
    cameras: &[NamedCamera],
) -> Result<Vec<(&'static str, String)>, CameraFileError> {
    let mut texts = vec![(TEXT[0], text::encode_cameras(cameras)?)];
    if cameras.iter().any(|camera| camera.pose.is_some()) {
        let points = "# 3D point list with one line of data per point:\n";
        texts.push((TEXT[1], text::encode_images(cameras)?));
        texts.push((NAMES[2], points.to_owned()));
    }
    Ok(texts)
}

/// The kind of lens that a model of a camera has by its name.
pub(super) fn lens_of_model(
    name: &str,
    place: impl FnOnce() -> Place,
) -> Result<LensModel, CameraFileError> {
    Ok(model::find(Some(name), 0, place)?.lens)
}

/// Whether a text is that of cameras of a model.
pub(super) fn is_model(text: &str) -> bool {
    let mut lines = text.lines().map(str::trim);
    let first = lines.find(|line| !line.is_empty() && !line.starts_with('#'));
    first.is_some_and(is_camera_line)
}

/// Whether bytes may be those of cameras of a model: a count in eight bytes, which is not large.
pub(super) fn is_binary(bytes: &[u8]) -> bool {
    let count = bytes.first_chunk().map(|bytes| u64::from_le_bytes(*bytes));
    count.is_some_and(|count| (1..1 << 24).contains(&count))
}

/// The file of cameras in a folder, where there is one.
pub(super) fn file_in(folder: &Path) -> Option<PathBuf> {
    let files = [TEXT[0], BINARY[0]].map(|name| folder.join(name));
    files.into_iter().find(|file| file.is_file())
}

/// The cameras of a text, or of bytes that are none, in a folder.
pub(super) fn decode(bytes: &[u8], folder: &Path) -> Result<CameraFile, CameraFileError> {
    let (devices, name, decode): (_, _, DecodeShots) = match std::str::from_utf8(bytes) {
        Ok(words) if !is_binary(bytes) => (text::devices(words)?, TEXT[1], text::shots),
        _ => (binary::devices(bytes)?, BINARY[1], binary::shots),
    };
    let shots = shots(&folder.join(name), &devices, decode)?;
    Ok(CameraFile::new(cameras(&devices, shots, folder)))
}

type DecodeShots = fn(&[u8]) -> Result<Vec<Shot>, CameraFileError>;

/// The images of a file, each with its device; none where there is no such file.
fn shots<'a>(
    path: &Path,
    devices: &'a [Device],
    decode: DecodeShots,
) -> Result<Vec<(Shot, &'a Device)>, CameraFileError> {
    if !path.is_file() {
        return Ok(Vec::new());
    }
    let with_device = |shot: Shot| {
        let device = devices.iter().find(|device| device.id == shot.device);
        let device = device.ok_or_else(|| CameraFileError::Value {
            place: Place::on_line(shot.place, format!("{}: CAMERA_ID", shot.name)),
            expected: "the number of a camera of the model",
        })?;
        Ok((shot, device))
    };
    let found = ga_files::read(path, |bytes| {
        decode(bytes)?.into_iter().map(with_device).collect()
    });
    found.map_err(|error| CameraFileError::Images(Box::new(error)))
}

/// The cameras of the images, or, without any, the devices.
fn cameras(devices: &[Device], shots: Vec<(Shot, &Device)>, folder: &Path) -> Vec<NamedCamera> {
    let named = |name: String, device: &Device| {
        NamedCamera::new(name, device.intrinsics).with_size(Some(device.size))
    };
    if shots.is_empty() {
        let all = devices.iter();
        return all
            .map(|device| named(device.id.to_string(), device))
            .collect();
    }
    let cameras = shots.into_iter().map(|(shot, device)| {
        let places = [
            folder.to_path_buf(),
            folder.join("images"),
            folder.join("../images"),
            folder.join("../../images"),
        ];
        let pictures = places.map(|place| place.join(&shot.name));
        let picture = pictures.into_iter().find(|path| path.is_file());
        let mut camera = named(shot.name, device).with_pose(Some(shot.pose));
        camera.picture = picture;
        camera
    });
    cameras.collect()
}
