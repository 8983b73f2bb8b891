//! The kind of lens that a file names.

use super::error::CameraFileError;
use super::storage::Storage;
use crate::LensModel;

/// Projections that other programs have and that are not read, in small letters.
const OTHERS: [&str; 18] = [
    "omni",
    "omnidirectional",
    "mei",
    "ds",
    "double_sphere",
    "doublesphere",
    "eucm",
    "ucm",
    "fov",
    "atan",
    "scaramuzza",
    "ocam",
    "ocamcalib",
    "ftheta",
    "division",
    "equirectangular",
    "spherical",
    "latlong",
];

/// The kind of lens that a text names; an empty text states none.
pub(super) fn named_lens(
    storage: &Storage,
    key: &str,
) -> Result<Option<LensModel>, CameraFileError> {
    let text = storage.text(key)?.unwrap_or_default();
    if text.is_empty() {
        return Ok(None);
    }
    match known(&text) {
        Some(model) => Ok(Some(model)),
        None => Err(unknown(storage, key, text)),
    }
}

/// The kind of lens that the model of a camera implies: that of a pinhole says nothing of the
/// distortion.
pub(super) fn lens_of_camera_model(
    storage: &Storage,
    key: &str,
) -> Result<Option<LensModel>, CameraFileError> {
    let model = named_lens(storage, key)?;
    Ok(model.filter(|model| *model != LensModel::Pinhole))
}

/// As [`lens_of_camera_model`] for a key under which other things stand too, as the name of a
/// product. What is not a projection is none.
pub(super) fn lens_of_any_name(
    storage: &Storage,
    key: &str,
) -> Result<Option<LensModel>, CameraFileError> {
    let Ok(Some(text)) = storage.text(key) else {
        return Ok(None);
    };
    if known(&text).is_some() || OTHERS.contains(&text.to_ascii_lowercase().as_str()) {
        return lens_of_camera_model(storage, key);
    }
    Ok(None)
}

fn known(text: &str) -> Option<LensModel> {
    let mut models = LensModel::ALL.into_iter();
    models.find(|model| model.names().any(|name| name.eq_ignore_ascii_case(text)))
}

fn unknown(storage: &Storage, key: &str, text: String) -> CameraFileError {
    let names = LensModel::ALL.into_iter().flat_map(LensModel::names);
    CameraFileError::Model {
        place: storage.place(key),
        found: text.into(),
        known: names.collect(),
    }
}
