//! An object of JSON with the keys of a camera or a view.

use ga_runtime::cga3::Rotor;
use serde_json::{Map, Value};

use crate::LensModel;
use crate::format::camera_file::NamedCamera;
use crate::format::error::{CameraFileError, Place, absent};
use crate::format::fields::pinhole;
use crate::format::lens::lens;
use crate::format::rotation::{ROTATION_TOLERANCE, nearest_rotor};

/// The keys of a pose.
pub(super) const POSE: [&str; 3] = ["rotation", "quaternion_wxyz", "translation"];
/// The keys of a camera without its pose.
pub(super) const CAMERA: [&str; 11] = [
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
pub(super) struct Object<'a> {
    view: Option<usize>,
    prefix: &'static str,
    fields: &'a Map<String, Value>,
}

impl<'a> Object<'a> {
    /// An object whose keys are `known` or those of a pose.
    pub(super) fn new(
        view: Option<usize>,
        prefix: &'static str,
        value: &'a Value,
        known: &[&str],
    ) -> Result<Self, CameraFileError> {
        let Some(fields) = value.as_object() else {
            return Err(CameraFileError::Value {
                place: Place {
                    line: None,
                    view,
                    key: match (prefix, view) {
                        ("", Some(view)) => format!("views[{view}]"),
                        (prefix, _) => prefix.trim_end_matches('.').to_owned(),
                    },
                },
                expected: "an object",
            });
        };
        let is_known =
            |key: &&String| known.contains(&key.as_str()) || POSE.contains(&key.as_str());
        if let Some(key) = fields.keys().find(|key| !is_known(key)) {
            let key = format!("{prefix}{key}");
            return Err(CameraFileError::Unknown(Place {
                line: None,
                view,
                key,
            }));
        }
        Ok(Self {
            view,
            prefix,
            fields,
        })
    }

    pub(super) fn field(&self, key: &str) -> Option<&'a Value> {
        self.fields.get(key)
    }

    pub(super) fn place(&self, key: &str) -> Place {
        Place {
            line: None,
            view: self.view,
            key: format!("{}{key}", self.prefix),
        }
    }

    pub(super) fn missing(&self, key: &str) -> CameraFileError {
        absent(self.place(key))
    }

    pub(super) fn of_type(&self, key: &str, expected: &'static str) -> CameraFileError {
        CameraFileError::Value {
            place: self.place(key),
            expected,
        }
    }

    pub(super) fn required(&self, key: &str) -> Result<&'a Value, CameraFileError> {
        self.fields.get(key).ok_or_else(|| self.missing(key))
    }

    fn number(&self, key: &str) -> Result<f64, CameraFileError> {
        let number = self.required(key)?.as_f64();
        number.ok_or_else(|| self.of_type(key, "a number"))
    }

    fn pixels(&self, key: &str) -> Result<usize, CameraFileError> {
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
    ) -> Result<Vec<f64>, CameraFileError> {
        let numbers = value.as_array().map(|list| list.iter().map(Value::as_f64));
        let numbers = numbers.and_then(|numbers| numbers.collect::<Option<Vec<f64>>>());
        numbers.ok_or_else(|| self.of_type(key, expected))
    }

    pub(super) fn numbers<const N: usize>(
        &self,
        key: &str,
        value: &Value,
        expected: &'static str,
    ) -> Result<[f64; N], CameraFileError> {
        let numbers = <[f64; N]>::try_from(self.list(key, value, expected)?);
        numbers.map_err(|_| self.of_type(key, expected))
    }

    pub(super) fn matrix(&self, key: &str, value: &Value) -> Result<Rotor<f64>, CameraFileError> {
        let expected = "three rows of three numbers";
        let rows = value.as_array().filter(|rows| rows.len() == 3);
        let rows = rows.ok_or_else(|| self.of_type(key, expected))?;
        let mut matrix = [[0.0; 3]; 3];
        for (to, row) in matrix.iter_mut().zip(rows) {
            *to = self.numbers(key, row, expected)?;
        }
        nearest_rotor(matrix, || self.place(key))
    }

    pub(super) fn quaternion(
        &self,
        key: &str,
        value: &Value,
    ) -> Result<Rotor<f64>, CameraFileError> {
        let [w, x, y, z] = self.numbers(key, value, "four numbers")?;
        let deviation = ((w * w + x * x + y * y + z * z).sqrt() - 1.0).abs();
        if deviation.is_nan() || deviation > ROTATION_TOLERANCE {
            return Err(self.no_rotation(key, deviation));
        }
        Rotor::from_quaternion([x, y, z], w).ok_or_else(|| self.no_rotation(key, deviation))
    }

    fn no_rotation(&self, key: &str, deviation: f64) -> CameraFileError {
        CameraFileError::Rotation {
            place: self.place(key),
            deviation,
        }
    }

    /// What the keys of a camera say but for its pose.
    pub(super) fn camera(&self, name: &str) -> Result<NamedCamera, CameraFileError> {
        let focal = [self.number("fx")?, self.number("fy")?];
        let principal = [self.number("cx")?, self.number("cy")?];
        let plain = pinhole(focal, principal, || self.whole())?;
        let optional = |key: &str| {
            let given = self.fields.contains_key(key);
            given.then(|| self.number(key)).transpose()
        };
        let skew = optional("skew")?.unwrap_or(0.0);
        let unknown = || CameraFileError::Lens {
            place: self.place("lens"),
            known: LensModel::ALL.map(LensModel::name).to_vec(),
        };
        let named = |value: &Value| value.as_str().and_then(LensModel::named);
        let named = match self.fields.get("lens") {
            Some(value) => Some(named(value).ok_or_else(unknown)?),
            None => None,
        };
        let values = match self.fields.get("distortion") {
            Some(value) => self.list("distortion", value, "a list of numbers")?,
            None => Vec::new(),
        };
        if named == Some(LensModel::Pinhole) && !values.is_empty() {
            return Err(self.of_type("distortion", "empty, which the lens \"pinhole\" needs"));
        }
        let (lens, unstated) = lens(&values, named, || self.place("distortion"))?;
        let mut camera = NamedCamera::new(name, plain.with_lens(lens)).with_skew(skew);
        camera = camera.with_unstated_lens(unstated);
        camera.size = Some([self.pixels("width")?, self.pixels("height")?]);
        camera.near = optional("near")?;
        camera.far = optional("far")?;
        Ok(camera)
    }

    /// The place of the object itself.
    fn whole(&self) -> Place {
        Place {
            line: None,
            view: self.view,
            key: "camera".to_owned(),
        }
    }
}
