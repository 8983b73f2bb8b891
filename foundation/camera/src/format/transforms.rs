//! `transforms.json`, as Blender's data for radiance fields and instant-ngp have it.
//!
//! ```json
//! {"fl_x": 500, "fl_y": 500, "cx": 320, "cy": 240, "w": 640, "h": 480,
//!  "k1": 0.01, "k2": 0, "p1": 0, "p2": 0,
//!  "frames": [{"file_path": "images/0001.png",
//!              "transform_matrix": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 4], [0, 0, 0, 1]]}]}
//! ```
//!
//! `transform_matrix` takes the camera's frame, with x to the right, y up and z backwards, into the
//! world, whose unit the file does not state. Focal lengths are also given by the angles of view
//! `camera_angle_x` and `camera_angle_y`. The middle of the first pixel is (0.5, 0.5) there. What
//! stands in a frame counts before what stands in the file.

use std::path::Path;

use serde_json::Value;

use super::camera_file::{CameraFile, NamedCamera};
use super::error::{CameraFileError, Place};
use super::fields::{lens, pixels, refused, rigid};
use crate::frame::y_up;
use crate::{Intrinsics, LensModel};

/// Where pixels begin, before the middle of the first one.
const HALF: f64 = 0.5;

/// Whether it is such a file.
pub(super) fn is_transforms(value: &Value) -> bool {
    let frames = value.get("frames").and_then(Value::as_array);
    frames.is_some_and(|frames| {
        let mut frames = frames.iter();
        frames.any(|frame| frame.get("transform_matrix").is_some())
    })
}

/// The cameras of a file in a folder.
pub(super) fn decode(value: &Value, folder: &Path) -> Result<CameraFile, CameraFileError> {
    let frames = value.get("frames").and_then(Value::as_array);
    let frames = frames.map(Vec::as_slice).unwrap_or_default().iter();
    let cameras = frames.enumerate().map(|(index, frame)| {
        let frame = Frame {
            index,
            fields: [frame, value],
        };
        frame.camera(folder)
    });
    Ok(CameraFile::new(cameras.collect::<Result<_, _>>()?))
}

/// A frame, and the file around it.
struct Frame<'a> {
    index: usize,
    fields: [&'a Value; 2],
}

impl Frame<'_> {
    fn place(&self, key: &str) -> Place {
        Place {
            line: None,
            view: Some(self.index),
            key: key.to_owned(),
        }
    }

    fn field(&self, key: &str) -> Option<&Value> {
        self.fields.iter().find_map(|fields| fields.get(key))
    }

    fn number(&self, key: &str) -> Result<Option<f64>, CameraFileError> {
        let Some(value) = self.field(key) else {
            return Ok(None);
        };
        match value.as_f64() {
            Some(number) => Ok(Some(number)),
            None => Err(CameraFileError::Value {
                place: self.place(key),
                expected: "a number",
            }),
        }
    }

    fn required(&self, key: &str) -> Result<f64, CameraFileError> {
        self.number(key)?.ok_or_else(|| CameraFileError::Missing {
            place: self.place(key),
            also: Vec::new(),
        })
    }

    /// The focal length along a side of the picture, by itself or by an angle of view.
    fn focal(&self, key: &str, angle: &str, side: f64) -> Result<Option<f64>, CameraFileError> {
        if let Some(focal) = self.number(key)? {
            return Ok(Some(focal));
        }
        let angle = self.number(angle)?;
        Ok(angle.map(|angle| 0.5 * side / (0.5 * angle).tan()))
    }

    fn camera(&self, folder: &Path) -> Result<NamedCamera, CameraFileError> {
        let [wide, high] = [self.required("w")?, self.required("h")?];
        let size = [
            pixels(self.place("w"), wide)?,
            pixels(self.place("h"), high)?,
        ];
        let fx = self.focal("fl_x", "camera_angle_x", wide)?;
        let fx = fx.map_or_else(|| self.required("fl_x"), Ok)?;
        let fy = self.focal("fl_y", "camera_angle_y", high)?.unwrap_or(fx);
        let cx = self.number("cx")?.unwrap_or(0.5 * wide) - HALF;
        let cy = self.number("cy")?.unwrap_or(0.5 * high) - HALF;
        let plain = Intrinsics::new([fx, fy], [cx, cy]);
        let plain = plain.map_err(|error| refused(self.place("fl_x"), error))?;
        let is_fisheye = self.field("is_fisheye").and_then(Value::as_bool) == Some(true)
            || self.field("camera_model").and_then(Value::as_str) == Some("OPENCV_FISHEYE");
        let (model, names) = match is_fisheye {
            true => (LensModel::Fisheye, ["k1", "k2", "k3", "k4"].as_slice()),
            false => (
                LensModel::RadialTangential,
                ["k1", "k2", "p1", "p2", "k3"].as_slice(),
            ),
        };
        let values = names
            .iter()
            .map(|name| Ok(self.number(name)?.unwrap_or(0.0)));
        let values = values.collect::<Result<Vec<_>, CameraFileError>>()?;
        let (lens, _) =
            lens(&values, Some(model)).map_err(|error| refused(self.place("k1"), error))?;

        let key = "file_path";
        let picture = self.fields[0].get(key).and_then(Value::as_str);
        let picture = picture.ok_or_else(|| CameraFileError::Value {
            place: self.place(key),
            expected: "a path",
        })?;
        // Blender's data leave the ending out.
        let picture = match Path::new(picture).extension() {
            Some(_) => folder.join(picture),
            None => folder.join(format!("{picture}.png")),
        };
        let name = picture.file_name().unwrap_or(picture.as_os_str());
        let mut camera = NamedCamera::new(name.to_string_lossy(), plain.with_lens(lens));
        camera.picture = Some(picture.clone());
        camera.size = Some(size);
        camera.pose = Some(self.pose()?);
        Ok(camera)
    }

    fn pose(&self) -> Result<ga_runtime::cga3::Motor<f64>, CameraFileError> {
        let key = "transform_matrix";
        let rows = self.fields[0].get(key).and_then(Value::as_array);
        let row = |k: usize| {
            let row = rows.and_then(|rows| rows.get(k)).and_then(Value::as_array);
            let row = row.filter(|row| row.len() == 4)?;
            let mut numbers = [0.0; 4];
            for (number, value) in numbers.iter_mut().zip(row) {
                *number = value.as_f64()?;
            }
            Some(numbers)
        };
        let (Some(a), Some(b), Some(c)) = (row(0), row(1), row(2)) else {
            return Err(CameraFileError::Value {
                place: self.place(key),
                expected: "four rows of four numbers",
            });
        };
        let to_world = rigid([a, b, c]).map_err(|deviation| CameraFileError::Rotation {
            place: self.place(key),
            deviation,
        })?;
        Ok(y_up() * to_world.reverse())
    }
}
