//! Cameras whose parameters have names of their own: `fx`, `fy`, `cx`, `cy`, `k1` and so on, in the
//! map of the camera, with `Camera.` before them, or in maps such as `intrinsics` and `distortion`.

use super::camera_file::NamedCamera;
use super::error::CameraFileError;
use super::fields::{lens, missing, refused};
use super::storage::Storage;
use crate::{Intrinsics, LensModel};

const PREFIXES: [&str; 3] = ["", "Camera.", "Camera1."];
const PROJECTIONS: [&str; 7] = [
    "intrinsics",
    "intrinsic",
    "camera_intrinsics",
    "projection_parameters",
    "camera_matrix",
    "cameraMatrix",
    "K",
];
const DISTORTIONS: [&str; 6] = [
    "distortion",
    "distortion_coefficients",
    "distortion_parameters",
    "dist_coeffs",
    "distCoeffs",
    "D",
];
const PINHOLE: [&str; 4] = ["fx", "fy", "cx", "cy"];

/// Whether there are the parameters of a projection.
pub(super) fn has_camera(storage: &Storage) -> bool {
    scope(storage, &PROJECTIONS, &PINHOLE).is_some()
}

/// The map in which all of some parameters are, and what stands before their names.
fn scope(storage: &Storage, maps: &[&str], names: &[&str]) -> Option<(Storage, &'static str)> {
    let maps = storage
        .maps()
        .into_iter()
        .filter(|(name, _)| maps.contains(&name.as_str()));
    let scopes = [storage.clone()]
        .into_iter()
        .chain(maps.map(|(_, map)| map));
    let mut both = scopes.flat_map(|map| PREFIXES.map(|prefix| (map.clone(), prefix)));
    both.find(|(map, prefix)| names.iter().all(|name| map.has(&format!("{prefix}{name}"))))
}

/// The camera of a map that has such parameters; its lens may be stated.
pub(super) fn camera(
    storage: &Storage,
    name: &str,
    stated: Option<LensModel>,
) -> Result<Option<NamedCamera>, CameraFileError> {
    let Some((map, prefix)) = scope(storage, &PROJECTIONS, &PINHOLE) else {
        return Ok(None);
    };
    let key = |name: &str| format!("{prefix}{name}");
    let mut numbers = [0.0; 4];
    for (number, name) in numbers.iter_mut().zip(PINHOLE) {
        *number = map.number(&key(name))?.unwrap_or_default();
    }
    let [fx, fy, cx, cy] = numbers;
    let plain = Intrinsics::new([fx, fy], [cx, cy]);
    let plain = plain.map_err(|error| refused(map.place(&key("fx")), error))?;
    let Some((map, prefix)) = scope(storage, &DISTORTIONS, &["k1"]) else {
        return match stated {
            Some(LensModel::Fisheye) => Err(missing(&map, &["k1"])),
            _ => Ok(Some(NamedCamera::new(name, plain))),
        };
    };
    let key = |name: &str| format!("{prefix}{name}");
    let has = |name: &str| map.has(&key(name));
    // A fisheye has four radial terms and no tangential ones.
    let is_fisheye = match stated {
        Some(model) => model == LensModel::Fisheye,
        None => has("k4") && !["p1", "p2", "k5", "k6"].into_iter().any(has),
    };
    let (model, names) = match is_fisheye {
        true => (LensModel::Fisheye, ["k1", "k2", "k3", "k4"].as_slice()),
        false => (
            LensModel::RadialTangential,
            ["k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6"].as_slice(),
        ),
    };
    let values = names
        .iter()
        .map(|name| Ok(map.number(&key(name))?.unwrap_or(0.0)));
    let values = values.collect::<Result<Vec<_>, CameraFileError>>()?;
    let found = lens(&values, Some(model));
    let (lens, _) = found.map_err(|error| refused(map.place(&key("k1")), error))?;
    Ok(Some(NamedCamera::new(name, plain.with_lens(lens))))
}
