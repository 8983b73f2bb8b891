//! Cameras whose parameters have names of their own: `fx`, `fy`, `cx`, `cy`, `k1` and so on, in the
//! map of the camera, with `Camera.` before them, or in maps such as `intrinsics` and `distortion`.
//! Of two cameras, `Camera1.` and `Camera2.` stand before them, as ORB-SLAM3 has it.

use super::camera_file::NamedCamera;
use super::error::CameraFileError;
use super::fields::{missing, pinhole};
use super::lens::{stated_lens, unstated_lens};
use super::storage::Storage;
use crate::LensModel;

/// What stands before the names of the only or the first camera.
pub(super) const FIRST: [&str; 3] = ["", "Camera.", "Camera1."];
/// The same of the second one.
pub(super) const SECOND: [&str; 1] = ["Camera2."];
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
/// The coefficients of a radial–tangential lens in OpenCV's order.
const RADIAL_TANGENTIAL: [&str; 8] = ["k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6"];
const FISHEYE: [&str; 4] = ["k1", "k2", "k3", "k4"];

/// Parameters that only another projection has, and which.
const OTHERS: [(&[&str], &str); 2] = [
    (&["xi"], "the double sphere or the omnidirectional camera"),
    (
        &["alpha", "beta"],
        "the extended unified model of cameras (EUCM)",
    ),
];

/// Whether there are the parameters of a projection.
pub(super) fn has_camera(storage: &Storage, prefixes: &[&'static str]) -> bool {
    scope(storage, &PROJECTIONS, prefixes, all_of(&PINHOLE)).is_some()
}

/// Whether all of some names are those of values.
fn all_of<'a>(names: &'a [&str]) -> impl Fn(&dyn Fn(&str) -> bool) -> bool + 'a {
    move |has: &dyn Fn(&str) -> bool| names.iter().all(|name| has(name))
}

/// Whether any of some names is that of a value.
fn any_of<'a>(names: &'a [&str]) -> impl Fn(&dyn Fn(&str) -> bool) -> bool + 'a {
    move |has: &dyn Fn(&str) -> bool| names.iter().any(|name| has(name))
}

/// The map in which some parameters are, and what stands before their names.
fn scope(
    storage: &Storage,
    maps: &[&str],
    prefixes: &[&'static str],
    is_it: impl Fn(&dyn Fn(&str) -> bool) -> bool,
) -> Option<(Storage, &'static str)> {
    let maps = storage
        .maps()
        .into_iter()
        .filter(|(name, _)| maps.contains(&name.as_str()));
    let scopes = [storage.clone()]
        .into_iter()
        .chain(maps.map(|(_, map)| map));
    let mut both = scopes.flat_map(|map| prefixes.iter().map(move |prefix| (map.clone(), *prefix)));
    both.find(|(map, prefix)| is_it(&|name| map.has(&format!("{prefix}{name}"))))
}

/// The camera of a map that has such parameters; its lens may be stated.
pub(super) fn camera(
    storage: &Storage,
    name: &str,
    prefixes: &[&'static str],
    stated: Option<LensModel>,
) -> Result<Option<NamedCamera>, CameraFileError> {
    let Some((map, prefix)) = scope(storage, &PROJECTIONS, prefixes, all_of(&PINHOLE)) else {
        return Ok(None);
    };
    let key = |name: &str| format!("{prefix}{name}");
    let mut numbers = [0.0; 4];
    for (number, name) in numbers.iter_mut().zip(PINHOLE) {
        *number = map.number(&key(name))?.unwrap_or_default();
    }
    let [fx, fy, cx, cy] = numbers;
    let plain = pinhole([fx, fy], [cx, cy], || map.place(&key("fx")))?;
    for (names, projection) in OTHERS {
        if names.iter().all(|name| map.has(&key(name))) {
            return Err(CameraFileError::Projection {
                place: map.place(&key(names[0])),
                projection,
            });
        }
    }
    let is_lens = any_of(&RADIAL_TANGENTIAL);
    let beside = is_lens(&|name| map.has(&key(name))).then(|| (map.clone(), prefix));
    let Some((map, prefix)) = beside.or_else(|| scope(storage, &DISTORTIONS, prefixes, is_lens))
    else {
        return match stated {
            Some(LensModel::Fisheye) => Err(missing(&map, &["k1"])),
            _ => Ok(Some(NamedCamera::new(name, plain))),
        };
    };
    let key = |name: &str| format!("{prefix}{name}");
    let has = |name: &str| map.has(&key(name));
    let values = |names: &[&str]| {
        let values = names
            .iter()
            .map(|name| Ok(map.number(&key(name))?.unwrap_or(0.0)));
        values.collect::<Result<Vec<_>, CameraFileError>>()
    };
    let place = || {
        let first = RADIAL_TANGENTIAL.into_iter().find(|name| has(name));
        map.place(&key(first.unwrap_or("k1")))
    };
    // A fisheye has four radial terms and no tangential ones, and so may another lens.
    let may_be_fisheye = has("k4") && !any_of(&["p1", "p2", "k5", "k6"])(&has);
    let (lens, unstated) = match stated {
        Some(LensModel::Fisheye) => (
            stated_lens(&values(&FISHEYE)?, LensModel::Fisheye, place)?,
            None,
        ),
        None if may_be_fisheye => {
            let (radial, fisheye) = (values(&RADIAL_TANGENTIAL)?, values(&FISHEYE)?);
            let (lens, unstated) = unstated_lens(&radial, &fisheye, place)?;
            (lens, Some(unstated))
        }
        stated => {
            let model = stated.unwrap_or(LensModel::RadialTangential);
            (
                stated_lens(&values(&RADIAL_TANGENTIAL)?, model, place)?,
                None,
            )
        }
    };
    let camera = NamedCamera::new(name, plain.with_lens(lens));
    Ok(Some(camera.with_unstated_lens(unstated)))
}
