//! The `calib.txt` of the Middlebury and ETH3D stereo data: a rectified pair.
//!
//! ```text
//! cam0=[711.499 0 376.135; 0 711.499 227.447; 0 0 1]
//! cam1=[711.499 0 376.135; 0 711.499 227.447; 0 0 1]
//! doffs=0
//! baseline=59.9432
//! width=713
//! height=434
//! ndisp=713
//! ```
//!
//! `doffs` is the difference of the principal points in pixels, right minus left, the baseline is
//! in millimetres, and disparities are below `ndisp`. Other keys are ignored.

use std::fmt::Write;

use super::camera_file::{CameraFile, NamedCamera, Rectified, SIDES};
use super::error::{CameraFileError, absent, wrong_type};
use super::fields::{pinhole_of_matrix, pixels};
use super::key_values::KeyValues;
use crate::Intrinsics;
use crate::rig::{RectifiedRig, RigError};

/// The rectified rig of a file.
pub(super) fn decode(text: &str) -> Result<CameraFile, CameraFileError> {
    let entries = KeyValues::new(text, '=', "not of the form key=value")?;
    let left = camera(&entries, "cam0")?;
    let right = camera(&entries, "cam1")?;
    let millimetres = entries.number("baseline")?;
    let millimetres = millimetres.ok_or_else(|| absent(entries.place("baseline")))?;
    let rig = RectifiedRig::new(left, right, millimetres * 1e-3).map_err(|error| {
        let key = match error {
            RigError::Baseline(_) => "baseline",
            _ => "cam1",
        };
        CameraFileError::Rectified {
            line: entries.find(key).map_or(0, |(line, _)| line),
            error: Box::new(error),
        }
    })?;
    if let Some(found) = entries.number("doffs")? {
        let expected = rig.disparity_offset();
        // Principal points are written with three digits after the point.
        if (found - expected).abs() > 2e-3 {
            return Err(CameraFileError::Offset {
                place: entries.place("doffs"),
                found,
                expected,
            });
        }
    }
    let whole = |key| {
        let number = entries.number(key)?;
        let number = number.map(|number| pixels(entries.place(key), number));
        number.transpose()
    };
    let size = match (whole("width")?, whole("height")?) {
        (Some(width), Some(height)) => Some([width, height]),
        (Some(_), None) => return Err(entries.missing_beside("height", "width")),
        (None, Some(_)) => return Err(entries.missing_beside("width", "height")),
        (None, None) => None,
    };
    let cameras = rig.stereo_rig();
    let sides = SIDES.into_iter().zip([cameras.left, cameras.right]);
    let named = sides.map(|(name, camera)| {
        let named = NamedCamera::new(name, camera.intrinsics).with_size(size);
        named.with_pose(Some(camera.world_to_camera))
    });
    Ok(CameraFile {
        cameras: named.collect(),
        rectified: Some(Rectified {
            rig,
            disparities: whole("ndisp")?,
        }),
    })
}

/// The text of a file.
#[must_use]
pub fn encode(rectified: &Rectified, size: Option<[usize; 2]>) -> String {
    let rig = &rectified.rig;
    let mut text = String::new();
    let mut line = |key: &str, value: &dyn std::fmt::Display| {
        // Writing to a string does not fail.
        _ = writeln!(text, "{key}={value}");
    };
    for (key, camera) in [("cam0", rig.left()), ("cam1", rig.right())] {
        let rows = camera.to_matrix().map(|[a, b, c]| format!("{a} {b} {c}"));
        line(key, &format_args!("[{}]", rows.join("; ")));
    }
    line("doffs", &rig.disparity_offset());
    line("baseline", &(rig.baseline() * 1e3));
    if let Some([width, height]) = size {
        line("width", &width);
        line("height", &height);
    }
    if let Some(disparities) = rectified.disparities {
        line("ndisp", &disparities);
    }
    text
}

/// A matrix `[a b c; d e f; g h i]` that forms a camera.
fn camera(entries: &KeyValues, key: &str) -> Result<Intrinsics, CameraFileError> {
    let (line, text) = entries
        .find(key)
        .ok_or_else(|| absent(entries.place(key)))?;
    let expected = "a matrix [a b c; d e f; g h i]";
    let rows = matrix(text).ok_or_else(|| wrong_type(key, line, expected))?;
    pinhole_of_matrix(rows, || entries.place(key))
}

fn matrix(text: &str) -> Option<[[f64; 3]; 3]> {
    let inside = text.strip_prefix('[')?.strip_suffix(']')?;
    let mut rows = inside.split(';').map(|row| {
        let mut numbers = row.split_whitespace().map(|word| word.parse::<f64>().ok());
        let row = [numbers.next()??, numbers.next()??, numbers.next()??];
        numbers.next().is_none().then_some(row)
    });
    let matrix = [rows.next()??, rows.next()??, rows.next()??];
    rows.next().is_none().then_some(matrix)
}
