//! `transforms.json`, as Blender's data for radiance fields, instant-ngp and nerfstudio have it.
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
//! `camera_angle_x` and `camera_angle_y` in radians, and by `x_fov` and `y_fov` in degrees. The
//! middle of the first pixel is (0.5, 0.5) there. What stands in a frame counts before what stands
//! in the file. Blender's data have neither `w` nor `h`, which are then those of the picture, nor
//! the ending `.png` of its name.
//!
//! `camera_model` is one of the models of COLMAP, as nerfstudio writes it, or `is_fisheye` says
//! that the lens is a fisheye. Other models and coefficients are refused.

use std::path::{Path, PathBuf};

use ga_runtime::cga3::Motor;
use serde_json::Value;

use super::camera_file::{CameraFile, NamedCamera};
use super::colmap;
use super::error::{CameraFileError, Place, absent};
use super::fields::{pinhole, pixels};
use super::lens::stated_lens;
use super::picture_size::picture_size;
use super::rotation::homogeneous;
use crate::frame::y_up;
use crate::{Lens, LensModel};

/// Where pixels begin, before the middle of the first one.
const HALF: f64 = 0.5;

/// The coefficients of a radial–tangential lens in OpenCV's order.
const RADIAL_TANGENTIAL: [&str; 5] = ["k1", "k2", "p1", "p2", "k3"];
const FISHEYE: [&str; 4] = ["k1", "k2", "k3", "k4"];
/// All coefficients that files have. Those that a lens does not have are zero: `k4` is another term
/// in nerfstudio than in OpenCV.
const COEFFICIENTS: [&str; 8] = ["k1", "k2", "k3", "k4", "k5", "k6", "p1", "p2"];
/// Keys of projections that are not read.
const OTHERS: [(&str, &str); 4] = [
    ("ftheta_p0", "an f-theta lens"),
    ("latlong", "a panorama"),
    ("equirectangular", "a panorama"),
    ("orthographic", "an orthographic projection"),
];

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
        self.number(key)?.ok_or_else(|| absent(self.place(key)))
    }

    fn truth(&self, key: &str) -> Result<Option<bool>, CameraFileError> {
        let value = self.field(key);
        let truth = value.map(|value| {
            value.as_bool().ok_or_else(|| CameraFileError::Value {
                place: self.place(key),
                expected: "true or false",
            })
        });
        truth.transpose()
    }

    /// The focal length along a side of the picture, by itself or by an angle of view.
    fn focal(
        &self,
        [key, radians, degrees]: [&str; 3],
        side: f64,
    ) -> Result<Option<f64>, CameraFileError> {
        if let Some(focal) = self.number(key)? {
            return Ok(Some(focal));
        }
        let angle = match self.number(radians)? {
            Some(angle) => Some(angle),
            None => self.number(degrees)?.map(f64::to_radians),
        };
        Ok(angle.map(|angle| 0.5 * side / (0.5 * angle).tan()))
    }

    fn camera(&self, folder: &Path) -> Result<NamedCamera, CameraFileError> {
        let picture = self.picture(folder)?;
        let size = self.size(&picture)?;
        let [wide, high] = size.map(|side| side as f64);
        let fx = self.focal(["fl_x", "camera_angle_x", "x_fov"], wide)?;
        let fx = fx.map_or_else(|| self.required("fl_x"), Ok)?;
        let fy = self.focal(["fl_y", "camera_angle_y", "y_fov"], high)?;
        let cx = self.number("cx")?.unwrap_or(0.5 * wide) - HALF;
        let cy = self.number("cy")?.unwrap_or(0.5 * high) - HALF;
        let plain = pinhole([fx, fy.unwrap_or(fx)], [cx, cy], || self.place("fl_x"))?;
        let name = picture.file_name().unwrap_or(picture.as_os_str());
        let mut camera = NamedCamera::new(name.to_string_lossy(), plain.with_lens(self.lens()?));
        camera.picture = Some(picture);
        camera.size = Some(size);
        camera.pose = Some(self.pose()?);
        Ok(camera)
    }

    fn picture(&self, folder: &Path) -> Result<PathBuf, CameraFileError> {
        let key = "file_path";
        let picture = self.fields[0].get(key).and_then(Value::as_str);
        let picture = picture.ok_or_else(|| CameraFileError::Value {
            place: self.place(key),
            expected: "a path",
        })?;
        // Blender's data leave the ending out.
        Ok(match Path::new(picture).extension() {
            Some(_) => folder.join(picture),
            None => folder.join(format!("{picture}.png")),
        })
    }

    fn size(&self, picture: &Path) -> Result<[usize; 2], CameraFileError> {
        match (self.number("w")?, self.number("h")?) {
            (None, None) => picture_size(picture, || self.place("w")),
            (Some(wide), Some(high)) => Ok([
                pixels(self.place("w"), wide)?,
                pixels(self.place("h"), high)?,
            ]),
            (Some(_), None) => Err(absent(self.place("h"))),
            (None, Some(_)) => Err(absent(self.place("w"))),
        }
    }

    /// The lens of the model that is stated, or of the coefficients that there are.
    fn lens(&self) -> Result<Lens, CameraFileError> {
        for (key, projection) in OTHERS {
            if self
                .field(key)
                .is_some_and(|value| *value != Value::Bool(false))
            {
                return Err(CameraFileError::Projection {
                    place: self.place(key),
                    projection,
                });
            }
        }
        let key = "camera_model";
        let model = match self.field(key).map(Value::as_str) {
            None => None,
            Some(Some(name)) => Some(colmap::lens_of_model(name, || self.place(key))?),
            Some(None) => {
                return Err(CameraFileError::Value {
                    place: self.place(key),
                    expected: "the name of a model",
                });
            }
        };
        let model = match (model, self.truth("is_fisheye")?) {
            (Some(model), None) => model,
            (Some(model), Some(is_fisheye)) if is_fisheye == (model == LensModel::Fisheye) => model,
            (Some(_), Some(_)) => {
                return Err(CameraFileError::Twice {
                    place: self.place("is_fisheye"),
                    other: format!("another {key}"),
                });
            }
            (None, Some(true)) => LensModel::Fisheye,
            (None, _) => LensModel::RadialTangential,
        };
        let names: &[&str] = match model {
            LensModel::Pinhole => &[],
            LensModel::RadialTangential => &RADIAL_TANGENTIAL,
            LensModel::Fisheye => &FISHEYE,
        };
        for name in COEFFICIENTS {
            let value = self.number(name)?.unwrap_or(0.0);
            if value != 0.0 && !names.contains(&name) {
                return Err(CameraFileError::Value {
                    place: self.place(name),
                    expected: match model {
                        LensModel::Pinhole => "zero, as it is for a pinhole",
                        LensModel::RadialTangential => "zero: this term is not that of OpenCV",
                        LensModel::Fisheye => "zero, as it is for a fisheye",
                    },
                });
            }
        }
        let values = names
            .iter()
            .map(|name| Ok(self.number(name)?.unwrap_or(0.0)));
        let values = values.collect::<Result<Vec<_>, CameraFileError>>()?;
        stated_lens(&values, model, || self.place("k1"))
    }

    fn pose(&self) -> Result<Motor<f64>, CameraFileError> {
        let key = "transform_matrix";
        let row = |row: &Value| {
            let row = row.as_array().filter(|row| row.len() == 4)?;
            let mut numbers = [0.0; 4];
            for (number, value) in numbers.iter_mut().zip(row) {
                *number = value.as_f64()?;
            }
            Some(numbers)
        };
        let rows = self.fields[0].get(key).and_then(Value::as_array);
        let rows = rows.and_then(|rows| rows.iter().map(row).collect::<Option<Vec<_>>>());
        let rows = rows.ok_or_else(|| CameraFileError::Value {
            place: self.place(key),
            expected: "four rows of four numbers",
        })?;
        let to_world = homogeneous(&rows, || self.place(key))?;
        Ok(y_up() * to_world.reverse())
    }
}
