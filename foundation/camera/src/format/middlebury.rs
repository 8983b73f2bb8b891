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

use std::collections::HashSet;
use std::fmt::Write;
use std::str::FromStr;

use super::camera_file::{CameraFile, NamedCamera, Rectified, SIDES};
use super::error::{CameraFileError, Place, wrong_type};
use crate::Intrinsics;
use crate::rig::{RectifiedRig, RigError};

/// The rectified rig of a file.
pub(super) fn decode(text: &str) -> Result<CameraFile, CameraFileError> {
    let entries = Entries::new(text)?;
    let left = entries.camera("cam0")?;
    let right = entries.camera("cam1")?;
    let (baseline_line, millimetres) = entries.required::<f64>("baseline", "a number")?;
    let rig = RectifiedRig::new(left, right, millimetres * 1e-3).map_err(|error| {
        let line = match error {
            RigError::Baseline(_) => baseline_line,
            _ => entries.find("cam1").map_or(0, |(line, _)| line),
        };
        let error = Box::new(error);
        CameraFileError::Rectified { line, error }
    })?;
    if let Some((line, found)) = entries.optional::<f64>("doffs", "a number")? {
        let expected = rig.disparity_offset();
        // Principal points are written with three digits after the point.
        if (found - expected).abs() > 2e-3 || found.is_nan() {
            return Err(CameraFileError::Offset {
                place: Place::on_line(line, "doffs"),
                found,
                expected,
            });
        }
    }
    let whole = |key| entries.optional::<usize>(key, "a whole number");
    let size = match (whole("width")?, whole("height")?) {
        (Some((_, width)), Some((_, height))) => Some([width, height]),
        _ => None,
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
            disparities: whole("ndisp")?.map(|(_, count)| count),
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

/// Keys and values with their lines.
struct Entries<'a>(Vec<(&'a str, usize, &'a str)>);

impl<'a> Entries<'a> {
    fn new(text: &'a str) -> Result<Self, CameraFileError> {
        let mut found: Vec<(&str, usize, &str)> = Vec::new();
        let mut keys = HashSet::new();
        for (index, text) in text.lines().enumerate() {
            let line = index + 1;
            if text.trim().is_empty() {
                continue;
            }
            let (key, value) = text.split_once('=').ok_or(CameraFileError::Unsupported {
                line,
                problem: "not of the form key=value",
            })?;
            let (key, value) = (key.trim(), value.trim());
            if !keys.insert(key) {
                return Err(CameraFileError::Duplicate(Place::on_line(line, key)));
            }
            found.push((key, line, value));
        }
        Ok(Self(found))
    }

    fn find(&self, key: &str) -> Option<(usize, &'a str)> {
        let mut entries = self.0.iter();
        let (_, line, value) = entries.find(|(other, ..)| *other == key)?;
        Some((*line, value))
    }

    fn optional<T: FromStr>(
        &self,
        key: &'static str,
        expected: &'static str,
    ) -> Result<Option<(usize, T)>, CameraFileError> {
        let Some((line, value)) = self.find(key) else {
            return Ok(None);
        };
        let parsed = value.parse().map_err(|_| wrong_type(key, line, expected))?;
        Ok(Some((line, parsed)))
    }

    fn required<T: FromStr>(
        &self,
        key: &'static str,
        expected: &'static str,
    ) -> Result<(usize, T), CameraFileError> {
        self.optional(key, expected)?.ok_or_else(|| missing(key))
    }

    /// A matrix `[a b c; d e f; g h i]` that forms a camera.
    fn camera(&self, key: &'static str) -> Result<Intrinsics, CameraFileError> {
        let (line, text) = self.find(key).ok_or_else(|| missing(key))?;
        let expected = "a matrix [a b c; d e f; g h i]";
        let rows = matrix(text).ok_or_else(|| wrong_type(key, line, expected))?;
        Intrinsics::from_matrix(rows).map_err(|error| CameraFileError::Camera {
            place: Place::on_line(line, key),
            error: error.into(),
        })
    }
}

fn missing(key: &str) -> CameraFileError {
    CameraFileError::Missing {
        place: Place::on_line(0, key),
        also: Vec::new(),
    }
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
