//! Views: pictures with their cameras, as JSON.
//!
//! ```json
//! {"views": [
//!   {"picture": "front.png",
//!    "camera": {"width": 640, "height": 480, "fx": 500, "fy": 500, "cx": 319.5, "cy": 239.5},
//!    "rotation": [[1, 0, 0], [0, -1, 0], [0, 0, -1]], "translation": [0, 0, 2]},
//!   {"picture": "side.jpg", "camera": "side.yml",
//!    "quaternion_wxyz": [0, 0.707107, 0, 0.707107], "translation": [0, 0.1, 2]},
//!   {"picture": "top.png", "camera": "top.json"}
//! ]}
//! ```
//!
//! Paths are relative to the file. Of each view:
//!
//! - `picture`: the path of the picture.
//! - `camera`: an object as below, or the path of a `.json` file with such an object, or that of
//!   [OpenCV's YAML](super::camera).
//! - `rotation`: the rotation R from the world to the camera, three rows.
//! - `quaternion_wxyz`: the same as a quaternion, the scalar first, in place of `rotation`.
//! - `translation`: the translation t, in the unit of the mesh.
//!
//! A point p of the world is at x = R p + t in the camera's frame, with x to the right, y down and
//! z forward. The pose stands beside the camera or in its object. In the object of a camera:
//!
//! - `width`, `height`: the size of the picture in pixels.
//! - `fx`, `fy`, `cx`, `cy`: focal lengths and principal point in pixels; (0, 0) is the middle of
//!   the top left pixel.
//! - `distortion`: 4, 5, 8, 12 or 14 coefficients in OpenCV's order, 4 for a fisheye; none for a
//!   pinhole.
//! - `lens`: `"pinhole"`, `"radial-tangential"` or `"fisheye"`, where the coefficients do not say
//!   it.
//! - `skew`, `near`, `far`: of the cameras of `nullcone render`; the skew must be 0, the others are
//!   not used.
//!
//! A rotation that has few digits is replaced by the nearest one.

use std::path::{Path, PathBuf};

use ga_files::ReadError;
use ga_runtime::cga3::{Rotor, Translator};
use serde_json::{Map, Value};

use super::camera::CameraFile;
use super::rig::nearest_rotor;
use super::yaml::YamlError;
use crate::{Camera, CameraError, Fisheye, Intrinsics, Lens, RadialTangential};

/// A picture's path and the camera that took it.
#[derive(Clone, Debug, PartialEq)]
pub struct ViewEntry {
    /// The picture, found from the folder of the file.
    pub picture: PathBuf,
    /// The camera with its pose.
    pub camera: Camera,
    /// The width and height for which the camera is given, where they are known.
    pub size: Option<[usize; 2]>,
}

/// What is wrong with a file of views. Views count from 0.
#[derive(Debug, thiserror::Error)]
pub enum ViewsError {
    /// It is not JSON.
    #[error(transparent)]
    Json(#[from] serde_json::Error),
    /// There is no list of views, or an empty one.
    #[error("`views` is not a list of at least one view")]
    NoViews,
    /// A key is missing.
    #[error("view {view}: `{key}` is missing")]
    Missing {
        /// Which view.
        view: usize,
        /// The key, with those of the objects around it.
        key: String,
    },
    /// A key is not known.
    #[error("view {view}: `{key}` is not a key of a view")]
    Unknown {
        /// Which view.
        view: usize,
        /// The key.
        key: String,
    },
    /// A value is not of its type.
    #[error("view {view}: `{key}` is not {expected}")]
    Type {
        /// Which view.
        view: usize,
        /// The key.
        key: String,
        /// What it must be.
        expected: &'static str,
    },
    /// A value is given twice.
    #[error("view {view}: `{key}` is given, and also `{other}`")]
    Twice {
        /// Which view.
        view: usize,
        /// One key.
        key: String,
        /// The other one.
        other: String,
    },
    /// Numbers are not a rotation.
    #[error("view {view}: `{key}` is not a rotation, or further than 0.0001 from one")]
    Rotation {
        /// Which view.
        view: usize,
        /// The key.
        key: String,
    },
    /// Numbers do not form a camera.
    #[error("view {view}: `camera`: {error}")]
    Camera {
        /// Which view.
        view: usize,
        /// What is wrong with it.
        error: Box<CameraError>,
    },
    /// A camera's YAML cannot be read.
    #[error("view {view}: `camera`: {error}")]
    Yaml {
        /// Which view.
        view: usize,
        /// What is wrong with it.
        error: ReadError<YamlError>,
    },
    /// A camera's JSON cannot be read.
    #[error("view {view}: `camera`: {error}")]
    CameraJson {
        /// Which view.
        view: usize,
        /// What is wrong with it.
        error: ReadError<serde_json::Error>,
    },
}

/// The name of the file in a folder of views.
pub const FILE_NAME: &str = "views.json";

/// Reads a file, or [`FILE_NAME`] in a folder.
///
/// # Errors
/// [`ReadError`] with the file and an error of [`decode`].
pub fn read(path: impl AsRef<Path>) -> Result<Vec<ViewEntry>, ReadError<ViewsError>> {
    let path = match path.as_ref() {
        folder if folder.is_dir() => folder.join(FILE_NAME),
        file => file.to_owned(),
    };
    let folder = path.parent().unwrap_or(Path::new(""));
    ga_files::read(&path, |bytes| decode(bytes, folder))
}

/// Reads views from the text of a file that lies in a folder.
///
/// # Errors
/// [`ViewsError`], which names the view and the key.
///
/// ```
/// use std::path::Path;
/// use ga_camera::format::views;
/// let text = br#"{"views": [{"picture": "a.png", "translation": [0, 0, 2],
///     "quaternion_wxyz": [0, 1, 0, 0],
///     "camera": {"width": 64, "height": 48, "fx": 50, "fy": 50, "cx": 31.5, "cy": 23.5}}]}"#;
/// let views = views::decode(text, Path::new("scene"))?;
/// assert_eq!(views[0].picture, Path::new("scene/a.png"));
/// assert_eq!(views[0].size, Some([64, 48]));
/// // The camera looks along −z from z = 2.
/// assert_eq!(views[0].camera.centre().coordinates(), [0.0, 0.0, 2.0]);
///
/// let wrong = views::decode(br#"{"views": [{"picture": "a.png"}]}"#, Path::new(""));
/// assert_eq!(wrong.unwrap_err().to_string(), "view 0: `camera` is missing");
/// # Ok::<(), views::ViewsError>(())
/// ```
pub fn decode(bytes: &[u8], folder: &Path) -> Result<Vec<ViewEntry>, ViewsError> {
    let file: Value = serde_json::from_slice(bytes)?;
    let views = file.get("views").and_then(Value::as_array);
    let views = views.filter(|views| !views.is_empty());
    let views = views.ok_or(ViewsError::NoViews)?;
    let entries = views.iter().enumerate();
    entries
        .map(|(view, value)| entry(view, value, folder))
        .collect()
}

const POSE: [&str; 3] = ["rotation", "quaternion_wxyz", "translation"];
const CAMERA: [&str; 11] = [
    "width",
    "height",
    "fx",
    "fy",
    "cx",
    "cy",
    "distortion",
    "lens",
    "skew",
    "near",
    "far",
];

/// An object of a view, with the key at which it stands.
struct Object<'a> {
    view: usize,
    prefix: &'static str,
    fields: &'a Map<String, Value>,
}

fn entry(view: usize, value: &Value, folder: &Path) -> Result<ViewEntry, ViewsError> {
    let object = Object::new(view, "", value, &["picture", "camera"])?;
    let picture = object.required("picture")?;
    let picture = picture
        .as_str()
        .ok_or_else(|| object.of_type("picture", "a path"))?;
    let given = object.required("camera")?;
    let loaded;
    let (intrinsics, size, inner) = match given.as_str() {
        Some(path) if path.to_ascii_lowercase().ends_with(".json") => {
            let read = ga_files::read(folder.join(path), |bytes| serde_json::from_slice(bytes));
            loaded = read.map_err(|error| ViewsError::CameraJson { view, error })?;
            let camera = Object::new(view, "camera.", &loaded, &CAMERA)?;
            let (intrinsics, size) = camera.intrinsics()?;
            (intrinsics, size, Some(camera))
        }
        Some(path) => {
            let file = CameraFile::read(folder.join(path));
            let file = file.map_err(|error| ViewsError::Yaml { view, error })?;
            (file.intrinsics, file.size, None)
        }
        None => {
            let camera = Object::new(view, "camera.", given, &CAMERA)?;
            let (intrinsics, size) = camera.intrinsics()?;
            (intrinsics, size, Some(camera))
        }
    };
    let pose = |key: &'static str| -> Result<Option<(&Object, &Value)>, ViewsError> {
        let own = object.fields.get(key).map(|value| (&object, value));
        let of_camera = inner.as_ref();
        let of_camera = of_camera.and_then(|camera| Some((camera, camera.fields.get(key)?)));
        match (own, of_camera) {
            (Some(_), Some(_)) => Err(ViewsError::Twice {
                view,
                key: key.to_owned(),
                other: format!("camera.{key}"),
            }),
            (own, of_camera) => Ok(own.or(of_camera)),
        }
    };
    let [rotation, quaternion, translation] = POSE;
    let rotor = match (pose(rotation)?, pose(quaternion)?) {
        (Some((at, value)), None) => at.matrix(rotation, value)?,
        (None, Some((at, value))) => at.quaternion(quaternion, value)?,
        (None, None) => return Err(object.missing(rotation)),
        (Some(_), Some(_)) => {
            return Err(ViewsError::Twice {
                view,
                key: rotation.to_owned(),
                other: quaternion.to_owned(),
            });
        }
    };
    let (at, value) = pose(translation)?.ok_or_else(|| object.missing(translation))?;
    let displacement: [f64; 3] = at.numbers(translation, value, "three numbers")?;
    Ok(ViewEntry {
        picture: folder.join(picture),
        camera: Camera {
            intrinsics,
            world_to_camera: Translator::from_displacement(displacement) * rotor,
        },
        size,
    })
}

impl<'a> Object<'a> {
    /// An object whose keys are `known` or those of a pose.
    fn new(
        view: usize,
        prefix: &'static str,
        value: &'a Value,
        known: &[&str],
    ) -> Result<Self, ViewsError> {
        let Some(fields) = value.as_object() else {
            return Err(ViewsError::Type {
                view,
                key: match prefix {
                    "" => format!("views[{view}]"),
                    prefix => prefix.trim_end_matches('.').to_owned(),
                },
                expected: "an object",
            });
        };
        let is_known =
            |key: &&String| known.contains(&key.as_str()) || POSE.contains(&key.as_str());
        if let Some(key) = fields.keys().find(|key| !is_known(key)) {
            let key = format!("{prefix}{key}");
            return Err(ViewsError::Unknown { view, key });
        }
        Ok(Self {
            view,
            prefix,
            fields,
        })
    }

    fn key(&self, key: &str) -> String {
        format!("{}{key}", self.prefix)
    }

    fn missing(&self, key: &str) -> ViewsError {
        ViewsError::Missing {
            view: self.view,
            key: self.key(key),
        }
    }

    fn of_type(&self, key: &str, expected: &'static str) -> ViewsError {
        ViewsError::Type {
            view: self.view,
            key: self.key(key),
            expected,
        }
    }

    fn required(&self, key: &str) -> Result<&'a Value, ViewsError> {
        self.fields.get(key).ok_or_else(|| self.missing(key))
    }

    fn number(&self, key: &str) -> Result<f64, ViewsError> {
        let number = self.required(key)?.as_f64();
        number.ok_or_else(|| self.of_type(key, "a number"))
    }

    fn pixels(&self, key: &str) -> Result<usize, ViewsError> {
        let expected = "a number of pixels from 1 to 4294967295";
        let number = self.required(key)?.as_u64();
        let number = number.and_then(|number| u32::try_from(number).ok());
        let number = number.filter(|number| *number > 0);
        Ok(number.ok_or_else(|| self.of_type(key, expected))? as usize)
    }

    fn list(
        &self,
        key: &str,
        value: &Value,
        expected: &'static str,
    ) -> Result<Vec<f64>, ViewsError> {
        let numbers = value.as_array().map(|list| list.iter().map(Value::as_f64));
        let numbers = numbers.and_then(|numbers| numbers.collect::<Option<Vec<f64>>>());
        numbers.ok_or_else(|| self.of_type(key, expected))
    }

    fn numbers<const N: usize>(
        &self,
        key: &str,
        value: &Value,
        expected: &'static str,
    ) -> Result<[f64; N], ViewsError> {
        let numbers = <[f64; N]>::try_from(self.list(key, value, expected)?);
        numbers.map_err(|_| self.of_type(key, expected))
    }

    fn matrix(&self, key: &str, value: &Value) -> Result<Rotor<f64>, ViewsError> {
        let expected = "three rows of three numbers";
        let rows = value.as_array().filter(|rows| rows.len() == 3);
        let rows = rows.ok_or_else(|| self.of_type(key, expected))?;
        let mut matrix = [[0.0; 3]; 3];
        for (to, row) in matrix.iter_mut().zip(rows) {
            *to = self.numbers(key, row, expected)?;
        }
        nearest_rotor(matrix).map_err(|_| self.no_rotation(key))
    }

    fn quaternion(&self, key: &str, value: &Value) -> Result<Rotor<f64>, ViewsError> {
        let [w, x, y, z] = self.numbers(key, value, "four numbers")?;
        let length = (w * w + x * x + y * y + z * z).sqrt();
        if length.is_nan() || (length - 1.0).abs() > 1e-4 {
            return Err(self.no_rotation(key));
        }
        Rotor::from_quaternion([x, y, z], w).ok_or_else(|| self.no_rotation(key))
    }

    fn no_rotation(&self, key: &str) -> ViewsError {
        ViewsError::Rotation {
            view: self.view,
            key: self.key(key),
        }
    }

    /// Focal lengths, principal point, lens and size of a camera.
    fn intrinsics(&self) -> Result<(Intrinsics, Option<[usize; 2]>), ViewsError> {
        let view = self.view;
        let refuse = |error| ViewsError::Camera {
            view,
            error: Box::new(error),
        };
        let focal = [self.number("fx")?, self.number("fy")?];
        let principal = [self.number("cx")?, self.number("cy")?];
        let plain = Intrinsics::new(focal, principal).map_err(refuse)?;
        if self.fields.contains_key("skew") && self.number("skew")? != 0.0 {
            return Err(self.of_type("skew", "0: pictures with skew are not supported"));
        }
        let kinds = "\"pinhole\", \"radial-tangential\" or \"fisheye\"";
        let kind = match self.fields.get("lens") {
            Some(value) => Some(value.as_str().ok_or_else(|| self.of_type("lens", kinds))?),
            None => None,
        };
        let values = match self.fields.get("distortion") {
            Some(value) => self.list("distortion", value, "a list of numbers")?,
            None => Vec::new(),
        };
        let lens = match (kind, values.as_slice()) {
            (None | Some("pinhole" | "radial-tangential"), []) => Lens::Pinhole,
            (Some("fisheye"), values) => Fisheye::new(values).map_err(refuse)?.into(),
            (None | Some("radial-tangential"), values) => {
                RadialTangential::new(values).map_err(refuse)?.into()
            }
            (Some("pinhole"), _) => {
                return Err(self.of_type("distortion", "empty, which the lens \"pinhole\" needs"));
            }
            (Some(_), _) => return Err(self.of_type("lens", kinds)),
        };
        let size = [self.pixels("width")?, self.pixels("height")?];
        Ok((plain.with_lens(lens), Some(size)))
    }
}
