//! Cameras from JSON.

use std::path::Path;

use ga_runtime::cga3::{Motor, Rotor, Translator};
use serde_json::Value;

use super::object::{CAMERA, Object, POSE};
use crate::format::camera_file::{CameraFile, NamedCamera, SINGLE};
use crate::format::error::CameraFileError;
use crate::format::opencv;
use crate::format::storage::Storage;
use crate::format::syntax::json::parse;
use crate::format::text::text;

/// Whether a value is one camera or a list of views.
pub(in crate::format) fn is_own(value: &Value) -> bool {
    is_camera(value) || value.get("views").is_some()
}

fn is_camera(value: &Value) -> bool {
    let keys = ["fx", "fy", "cx", "cy"];
    let fields = value.as_object();
    fields.is_some_and(|fields| keys.iter().any(|key| fields.contains_key(*key)))
}

/// The camera of an object, or those of a list of views.
pub(in crate::format) fn decode(
    file: &Value,
    folder: &Path,
) -> Result<CameraFile, CameraFileError> {
    if is_camera(file) {
        return Ok(CameraFile::new(vec![single(file)?]));
    }
    let views = file.get("views").and_then(Value::as_array);
    let views = views.filter(|views| !views.is_empty());
    let views = views.ok_or(CameraFileError::NoViews)?.iter().enumerate();
    let cameras = views.map(|(index, value)| view(index, value, folder));
    Ok(CameraFile::new(cameras.collect::<Result<_, _>>()?))
}

/// The camera of a file of its own.
fn single(value: &Value) -> Result<NamedCamera, CameraFileError> {
    let object = Object::new(None, "", value, &CAMERA)?;
    let camera = object.camera(SINGLE)?;
    Ok(camera.with_pose(pose(&object, None)?))
}

fn view(index: usize, value: &Value, folder: &Path) -> Result<NamedCamera, CameraFileError> {
    let object = Object::new(Some(index), "", value, &["picture", "camera"])?;
    let picture = object.required("picture")?;
    let picture = picture
        .as_str()
        .ok_or_else(|| object.of_type("picture", "a path"))?;
    let given = object.required("camera")?;
    let referred;
    let (mut camera, inner) = match given.as_str() {
        Some(path) => {
            let path = folder.join(path);
            let read = ga_files::read(&path, |bytes| Referred::decode(bytes, index));
            referred = read.map_err(|error| CameraFileError::Referred {
                place: object.place("camera"),
                error: Box::new(error),
            })?;
            match &referred {
                Referred::Yaml(camera) => ((**camera).clone(), None),
                Referred::Json(value) => {
                    let inner = Object::new(Some(index), "camera.", value, &CAMERA)?;
                    (inner.camera(SINGLE)?, Some(inner))
                }
            }
        }
        None => {
            let inner = Object::new(Some(index), "camera.", given, &CAMERA)?;
            (inner.camera(SINGLE)?, Some(inner))
        }
    };
    let pose = pose(&object, inner.as_ref())?;
    let pose = pose.ok_or_else(|| object.missing(POSE[0]))?;
    let picture = folder.join(picture);
    let name = picture.file_name().unwrap_or(picture.as_os_str());
    camera.name = name.to_string_lossy().into_owned();
    camera.pose = Some(pose);
    camera.picture = Some(picture);
    Ok(camera)
}

/// The file of one camera to which a view refers.
enum Referred {
    Yaml(Box<NamedCamera>),
    Json(Value),
}

impl Referred {
    fn decode(bytes: &[u8], view: usize) -> Result<Self, CameraFileError> {
        let text = text(bytes)?;
        if text.trim_start().starts_with('{') {
            let value = parse(text)?;
            // Its faults are named here, where the error names the file.
            Object::new(Some(view), "camera.", &value, &CAMERA)?.camera(SINGLE)?;
            return Ok(Self::Json(value));
        }
        let file = opencv::decode(&Storage::decode(bytes)?)?;
        Ok(Self::Yaml(Box::new(file.one(None)?.clone())))
    }
}

/// The pose of an object, or of the object of a camera in it, where one of them has some of it.
fn pose(object: &Object, inner: Option<&Object>) -> Result<Option<Motor<f64>>, CameraFileError> {
    let value = |key: &str| {
        let own = object.field(key).map(|value| (object, value));
        let of_camera = inner.and_then(|camera| Some((camera, camera.field(key)?)));
        match (own, of_camera) {
            (Some(_), Some((camera, _))) => Err(CameraFileError::Twice {
                place: object.place(key),
                other: camera.place(key).key,
            }),
            (own, of_camera) => Ok(own.or(of_camera)),
        }
    };
    let [rotation, quaternion, translation] = POSE;
    let rotor: Option<Rotor<f64>> = match (value(rotation)?, value(quaternion)?) {
        (Some((at, value)), None) => Some(at.matrix(rotation, value)?),
        (None, Some((at, value))) => Some(at.quaternion(quaternion, value)?),
        (None, None) => None,
        (Some(_), Some(_)) => {
            return Err(CameraFileError::Twice {
                place: object.place(rotation),
                other: quaternion.to_owned(),
            });
        }
    };
    match (rotor, value(translation)?) {
        (None, None) => Ok(None),
        (None, Some(_)) => Err(object.missing(rotation)),
        (Some(_), None) => Err(object.missing(translation)),
        (Some(rotor), Some((at, value))) => {
            let displacement: [f64; 3] = at.numbers(translation, value, "three numbers")?;
            Ok(Some(Translator::from_displacement(displacement) * rotor))
        }
    }
}
