//! The `camchain.yaml` of kalibr.
//!
//! ```text
//! cam0:
//!   camera_model: pinhole
//!   intrinsics: [525.25, 526.5, 319.5, 239.5]
//!   distortion_model: radtan
//!   distortion_coeffs: [-0.37, 0.24, 0.001, -0.002]
//!   resolution: [640, 480]
//! cam1:
//!   T_cn_cnm1: [[1, 0, 0, -0.12], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
//!   …
//! ```
//!
//! `intrinsics` are f_x, f_y, c_x and c_y; `radtan` has k1, k2, p1 and p2, and `equidistant` the
//! four coefficients of a fisheye. `T_cn_cnm1` takes the frame of the camera whose number is one
//! less into that of this one, in metres; that camera must be there. The world is the frame of the
//! first camera, or, where there is no such chain, that of the inertial sensor, from which
//! `T_cam_imu` leads. Models other than `pinhole` are refused.
//!
//! `sensor.yaml` of the EuRoC data has the values of one camera, with `distortion_coefficients`,
//! and `T_BS`, which takes its frame into that of the body: there the world is the body.

use std::fmt::Write;

use ga_runtime::cga3::Motor;

use super::camera_file::{CameraFile, NamedCamera, SINGLE};
use super::error::CameraFileError;
use super::fields::{first, missing, pinhole, size, transform};
use super::lens::stated_lens;
use super::lens_name::named_lens;
use super::rotation::rows;
use super::storage::{Storage, list};
use crate::LensModel;

const CHAIN: &str = "T_cn_cnm1";
const TO_SENSOR: &str = "T_cam_imu";
const TO_BODY: &str = "T_BS";
const COEFFICIENTS: [&str; 2] = ["distortion_coeffs", "distortion_coefficients"];

/// Whether there is a camera of kalibr, or one of EuRoC.
pub(super) fn is_chain(storage: &Storage) -> bool {
    let maps = storage.maps();
    is_alone(storage) || maps.iter().any(|(name, map)| is_camera(name, map))
}

/// Whether the values are those of one camera, in no map of its own. Parameters with names are not
/// kalibr's.
fn is_alone(storage: &Storage) -> bool {
    let is_list = storage.list("intrinsics").is_ok_and(|list| list.is_some());
    storage.has("camera_model") && is_list
}

fn is_camera(name: &str, map: &Storage) -> bool {
    let has = ["camera_model", "intrinsics"].map(|key| map.has(key));
    has == [true; 2] || (is_numbered(name) && has.contains(&true))
}

/// The cameras of a file.
pub(super) fn decode(storage: &Storage) -> Result<CameraFile, CameraFileError> {
    if is_alone(storage) {
        let pose = transform(storage, TO_BODY)?.map(Motor::reverse);
        let camera = camera(SINGLE, storage)?.with_pose(pose);
        return Ok(CameraFile::new(vec![camera]));
    }
    let mut maps = storage.maps();
    // Other maps, as of targets, are none of cameras.
    maps.retain(|(name, map)| is_camera(name, map) || is_numbered(name));
    // Programs that sort names write cam10 before cam2.
    if let Some(numbers) = maps
        .iter()
        .map(|(name, _)| number(name))
        .collect::<Option<Vec<_>>>()
    {
        let mut numbered: Vec<_> = numbers.into_iter().zip(maps).collect();
        numbered.sort_by_key(|(number, _)| *number);
        maps = numbered.into_iter().map(|(_, map)| map).collect();
    }
    let cameras = maps.iter().map(|(name, map)| camera(name, map));
    let mut cameras = cameras.collect::<Result<Vec<_>, _>>()?;
    let is_chain = maps.len() > 1 && maps.iter().skip(1).any(|(_, map)| map.has(CHAIN));
    let mut world = Motor::default();
    for (index, ((_, map), camera)) in maps.iter().zip(&mut cameras).enumerate() {
        camera.pose = match (is_chain, index) {
            (true, 0) => Some(world),
            (true, _) => {
                let step = transform(map, CHAIN)?.ok_or_else(|| missing(map, &[CHAIN]))?;
                check_previous(&maps[index - 1].0, &maps[index])?;
                world = step * world;
                Some(world)
            }
            (false, _) => transform(map, TO_SENSOR)?,
        };
    }
    Ok(CameraFile::new(cameras))
}

/// Checks that a camera from whose frame one leads into that of the next is the one of the number
/// before.
fn check_previous(before: &str, (name, map): &(String, Storage)) -> Result<(), CameraFileError> {
    let missing = match (number(before), number(name)) {
        (Some(before), Some(own)) if own != before + 1 => Some(own.saturating_sub(1)),
        _ => None,
    };
    match missing {
        None => Ok(()),
        Some(missing) => Err(CameraFileError::NoSuchFrame {
            place: map.place(CHAIN),
            from: format!("cam{missing}"),
        }),
    }
}

/// Whether a name is `cam` with a number.
fn is_numbered(name: &str) -> bool {
    number(name).is_some()
}

/// The number behind `cam`.
fn number(name: &str) -> Option<usize> {
    name.strip_prefix("cam")?.parse().ok()
}

fn camera(name: &str, map: &Storage) -> Result<NamedCamera, CameraFileError> {
    match map.text("camera_model")? {
        Some(model) if model != "pinhole" => {
            return Err(CameraFileError::Model {
                place: map.place("camera_model"),
                found: model.into(),
                known: Box::new(["pinhole"]),
            });
        }
        _ => {}
    }
    let key = "intrinsics";
    let values = map.list(key)?.ok_or_else(|| missing(map, &[key]))?;
    let &[fx, fy, cx, cy] = values.as_slice() else {
        return Err(CameraFileError::Shape {
            place: map.place(key),
            rows: values.len(),
            columns: 1,
            expected: "four: f_x, f_y, c_x and c_y",
        });
    };
    let plain = pinhole([fx, fy], [cx, cy], || map.place(key))?;
    let coefficients = first(map, &COEFFICIENTS).unwrap_or(COEFFICIENTS[0]);
    let values = map.list(coefficients)?.unwrap_or_default();
    let model = named_lens(map, "distortion_model")?;
    if model.is_none() && !values.is_empty() {
        return Err(missing(map, &["distortion_model"]));
    }
    let model = model.unwrap_or(LensModel::Pinhole);
    let lens = stated_lens(&values, model, || map.place(coefficients))?;
    let size = size(map, &[], &["resolution"])?;
    Ok(NamedCamera::new(name, plain.with_lens(lens)).with_size(size))
}

/// The text of a file.
pub(super) fn encode(cameras: &[NamedCamera]) -> Result<String, CameraFileError> {
    let mut text = String::new();
    let has_poses = cameras.iter().all(|camera| camera.pose.is_some());
    let mut before = None;
    // Writing to a string does not fail.
    for (index, camera) in cameras.iter().enumerate() {
        let intrinsics = camera.intrinsics()?;
        let lens = intrinsics.lens();
        let coefficients = lens.coefficients();
        let refuse = |what| CameraFileError::CannotHold {
            format: "kalibr's camchain",
            what,
            name: camera.name.clone(),
        };
        if coefficients[4..].iter().any(|x| *x != 0.0) {
            return Err(refuse("a distortion beyond k1, k2, p1 and p2"));
        }
        let model = match lens.model() {
            LensModel::Fisheye => "equidistant",
            LensModel::Pinhole | LensModel::RadialTangential => "radtan",
        };
        _ = writeln!(
            text,
            "cam{index}:\n  cam_overlaps: {:?}",
            others(index, cameras.len())
        );
        if let (true, Some(pose)) = (has_poses, camera.pose) {
            if let Some(before) = before {
                _ = writeln!(text, "  {CHAIN}:");
                let step: Motor<f64> = pose * Motor::reverse(before);
                let last = [0.0, 0.0, 0.0, 1.0];
                for row in rows(step).into_iter().chain([last]) {
                    _ = writeln!(text, "  - [{}]", list(&row, ", "));
                }
            }
            before = Some(pose);
        }
        let ([fx, fy], [cx, cy]) = (intrinsics.focal(), intrinsics.principal());
        _ = writeln!(
            text,
            "  camera_model: pinhole\n  distortion_coeffs: [{}]\n  distortion_model: {model}\n  \
             intrinsics: [{}]",
            list(&coefficients[..4], ", "),
            list(&[fx, fy, cx, cy], ", ")
        );
        if let Some([width, height]) = camera.size {
            _ = writeln!(text, "  resolution: [{width}, {height}]");
        }
        _ = writeln!(text, "  rostopic: /cam{index}/image_raw");
    }
    Ok(text)
}

fn others(index: usize, count: usize) -> Vec<usize> {
    (0..count).filter(|other| *other != index).collect()
}
