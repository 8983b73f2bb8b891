//! The TOML of aniposelib and Pose2Sim.
//!
//! ```text
//! [cam_0]
//! name = "left"
//! size = [ 640, 480,]
//! matrix = [ [ 500.0, 0.0, 319.5,], [ 0.0, 500.0, 239.5,], [ 0.0, 0.0, 1.0,],]
//! distortions = [ -0.1, 0.02, 0.0, 0.0, 0.0,]
//! rotation = [ 0.0, 0.1, 0.0,]
//! translation = [ -0.12, 0.0, 0.0,]
//! fisheye = false
//! ```
//!
//! `distortions` are in OpenCV's order; `rotation` is a rotation vector. A point p of the world is
//! at `R p + t` in the camera's frame, in metres in the files of Pose2Sim. The file states no unit,
//! and aniposelib's has that of its board.

use std::fmt::Write;

use super::camera::used_coefficients;
use super::camera_file::{CameraFile, NamedCamera};
use super::error::{CameraFileError, absent};
use super::fields::{self, pose, size};
use super::storage::{Storage, in_quotes, list};
use crate::LensModel;

const MATRIX: &str = "matrix";
const DISTORTIONS: [&str; 2] = ["distortions", "distortion"];

/// The cameras of a file.
pub(super) fn decode(storage: &Storage) -> Result<CameraFile, CameraFileError> {
    let maps = storage.maps();
    let cameras = maps.iter().filter(|(_, map)| map.has(MATRIX));
    let cameras = cameras.map(|(section, map)| {
        let model = match map.truth("fisheye")? {
            Some(true) => LensModel::Fisheye,
            Some(false) | None => LensModel::RadialTangential,
        };
        let name = map.text("name")?;
        let name = name.as_deref().unwrap_or(section);
        let camera = fields::camera(map, name, [&[MATRIX], &DISTORTIONS], Some(model))?;
        let camera = camera.with_size(size(map, &[], &["size"])?);
        Ok(camera.with_pose(pose(map, &["rotation"], &["translation"])?))
    });
    let cameras = cameras.collect::<Result<Vec<_>, CameraFileError>>()?;
    match cameras.is_empty() {
        false => Ok(CameraFile::new(cameras)),
        true => Err(absent(storage.place(MATRIX))),
    }
}

/// The text of a file.
pub(super) fn encode(cameras: &[NamedCamera]) -> Result<String, CameraFileError> {
    let mut text = String::new();
    let list = |values: &[f64]| format!("[ {},]", list(values, ", "));
    // Writing to a string does not fail.
    for (index, camera) in cameras.iter().enumerate() {
        let intrinsics = camera.intrinsics()?;
        let lens = intrinsics.lens();
        let name = in_quotes(&camera.name);
        _ = writeln!(text, "[cam_{index}]\nname = {name}");
        if let Some([width, height]) = camera.size {
            _ = writeln!(text, "size = [ {width}, {height},]");
        }
        let rows = intrinsics.to_matrix().map(|row| list(&row));
        let used = used_coefficients(&lens);
        let coefficients = if used.is_empty() { vec![0.0; 5] } else { used };
        let is_fisheye = lens.model() == LensModel::Fisheye;
        _ = writeln!(
            text,
            "matrix = [ {},]\ndistortions = {}",
            rows.join(", "),
            list(&coefficients)
        );
        if let Some(pose) = camera.pose {
            let rotation = pose.rotor().canonical().to_rotation_vector();
            let translation = pose.translator().displacement();
            _ = writeln!(
                text,
                "rotation = {}\ntranslation = {}",
                list(&rotation),
                list(&translation)
            );
        }
        _ = writeln!(text, "fisheye = {is_fisheye}\n");
    }
    _ = writeln!(text, "[metadata]\nadjusted = false\nerror = 0.0");
    Ok(text)
}
