//! Cameras as OpenCV and programs around it store them, in YAML, XML or JSON.
//!
//! | value | names that are read |
//! | --- | --- |
//! | K, 3×3 or nine numbers | `camera_matrix`, `cameraMatrix`, `K`, `M`, `mtx`, … |
//! | distortion | `distortion_coefficients`, `distCoeffs`, `dist_coeffs`, `D`, `dist`, … |
//! | the same of two cameras | marked as below |
//! | rotation, 3×3 or a rotation vector | `R`, `rotation`, `rvec`, `rotation_matrix` |
//! | translation in metres | `T`, `t`, `translation`, `tvec` |
//! | width, height | `image_width`, `image_height`, or a list `image_size` |
//! | fisheye | `fisheye_model: 1`, `fisheye: true`, `distortion_model: equidistant` or `fisheye` |
//! | the model | `camera_model`, `camera_type`, `model_type`, …; other models are refused |
//!
//! The names of the left and the right camera end in `1` and `2`, `_1` and `_2`, `0` and `1`, `_l`
//! and `_r`, `L` and `R`, `_left` and `_right`, or begin with `left_` and `right_`.
//!
//! In place of K and the distortion there may be `fx`, `fy`, `cx`, `cy`, and `k1`, `k2`, `p1`, `p2`
//! and so on, also in maps such as `intrinsics` and `distortion`.
//!
//! Of two cameras, a point of the left one's frame is at `R x + T` in the right one's; of one
//! camera, a point of the world is at `R x + T` in its frame. Values of cameras may stand in maps
//! of their own, whose names are then those of the cameras. A rotation that has few digits is
//! replaced by the nearest one. The distortion has 4, 5, 8, 12 or 14 numbers in OpenCV's order,
//! that of a fisheye 4; where nothing says which of both four numbers are, the lens is unclear.
//! Everything else in the file is ignored.

use ga_runtime::cga3::Motor;

use super::camera_file::{CameraFile, NamedCamera, SIDES, SINGLE};
use super::error::CameraFileError;
use super::fields;
use super::lens_name::{lens_of_any_name, lens_of_camera_model, named_lens};
use super::named_parameters::{self, FIRST, SECOND};
use super::storage::Storage;
use crate::LensModel;

const MATRIX: [&str; 7] = [
    "camera_matrix",
    "cameraMatrix",
    "Camera_Matrix",
    "K",
    "M",
    "mtx",
    "intrinsic_matrix",
];
const DISTORTION: [&str; 9] = [
    "distortion_coefficients",
    "distCoeffs",
    "dist_coeffs",
    "Distortion_Coefficients",
    "D",
    "dist",
    "dist_coeff",
    "distCoeff",
    "distortion",
];
const MATRICES: [&str; 6] = [
    "M",
    "K",
    "cameraMatrix",
    "camera_matrix",
    "mtx",
    "intrinsic_matrix",
];
const DISTORTIONS: [&str; 8] = [
    "D",
    "distCoeffs",
    "dist_coeffs",
    "distortion_coefficients",
    "dist",
    "dist_coeff",
    "distCoeff",
    "distortion",
];
const ROTATION: [&str; 4] = ["R", "rotation", "rvec", "rotation_matrix"];
const TRANSLATION: [&str; 4] = ["T", "t", "translation", "tvec"];
const SIZES: [[&str; 2]; 4] = [
    ["image_width", "image_height"],
    ["image_Width", "image_Height"],
    ["width", "height"],
    ["Camera.width", "Camera.height"],
];
const SIZE_LISTS: [&str; 2] = ["image_size", "imageSize"];
/// The matrix of ORB-SLAM3 from the frame of the right camera into that of the left one.
const RIGHT_TO_LEFT: &str = "Stereo.T_c1_c2";
const DISTORTION_MODELS: [&str; 2] = ["distortion_model", "distortion_type"];
/// The names of the model of a camera.
const CAMERA_MODELS: [&str; 8] = [
    "camera_model",
    "camera_type",
    "model_type",
    "lens_model",
    "lens_type",
    "projection_model",
    "Camera.type",
    "Camera.model",
];

/// What stands before and behind the names of the values of the left and the right camera. Those
/// that count from 0 come first: in them the left camera of others is the right one.
const MARKS: [[[&str; 2]; 2]; 11] = [
    [["", "0"], ["", "1"]],
    [["", "_0"], ["", "_1"]],
    [["", "1"], ["", "2"]],
    [["", "_1"], ["", "_2"]],
    [["", "_l"], ["", "_r"]],
    [["", "_L"], ["", "_R"]],
    [["", "l"], ["", "r"]],
    [["", "L"], ["", "R"]],
    [["", "_left"], ["", "_right"]],
    [["", "Left"], ["", "Right"]],
    [["left_", ""], ["right_", ""]],
];

/// How many of them count from 0.
const FROM_ZERO: usize = 2;

/// Whether there is a camera in it or in the maps in it.
pub(super) fn has_camera(storage: &Storage) -> bool {
    has_own(storage) || storage.maps().iter().any(|(_, inner)| has_camera(inner))
}

fn has_own(storage: &Storage) -> bool {
    marks(storage).is_some() || has_single(storage)
}

fn has_single(storage: &Storage) -> bool {
    fields::first(storage, &MATRIX).is_some() || named_parameters::has_camera(storage, &FIRST)
}

/// The cameras of a file.
pub(super) fn decode(storage: &Storage) -> Result<CameraFile, CameraFileError> {
    Ok(CameraFile::new(cameras(storage, &[])?))
}

/// The cameras of a map; what it does not say may stand in one of those around it, the nearest
/// first.
fn cameras(storage: &Storage, around: &[&Storage]) -> Result<Vec<NamedCamera>, CameraFileError> {
    if let Some(marks) = marks(storage) {
        return pair(storage, marks, around);
    }
    if named_parameters::has_camera(storage, &SECOND) {
        return numbered_pair(storage, around);
    }
    if has_single(storage) {
        return Ok(vec![single(storage, SINGLE, around)?]);
    }
    let maps = storage.maps();
    let inner: Vec<_> = maps.iter().filter(|(_, map)| has_camera(map)).collect();
    let around: Vec<&Storage> = [storage]
        .into_iter()
        .chain(around.iter().copied())
        .collect();
    match inner.as_slice() {
        [] => {
            // A model that is not read has other parameters.
            lens_model(storage, &around)?;
            let first = [MATRIX.as_slice(), &["M1", "K1", "cameraMatrix1"]].concat();
            Err(fields::missing(storage, &first))
        }
        [(_, only)] => cameras(only, &around),
        several => {
            let each = several.iter().map(|(name, map)| single(map, name, &around));
            let mut found = each.collect::<Result<Vec<_>, _>>()?;
            let is_right = |name: &str| name.to_ascii_lowercase().contains("right");
            if found.len() == 2 && is_right(&found[0].name) && !is_right(&found[1].name) {
                found.swap(0, 1);
            }
            if found.len() == 2 && found.iter().all(|camera| camera.pose.is_none()) {
                set_poses(&mut found, motion(storage)?);
            }
            Ok(found)
        }
    }
}

/// The marks of the names of two cameras.
fn marks(storage: &Storage) -> Option<&'static [[&'static str; 2]; 2]> {
    let has = |mark: &[&str; 2]| {
        let names = marked(&MATRICES, *mark);
        names.iter().any(|name| storage.has(name))
    };
    let both = MARKS.iter().find(|marks| marks.iter().all(has));
    // One of the two is named as missing.
    both.or_else(|| {
        MARKS[FROM_ZERO..]
            .iter()
            .find(|marks| marks.iter().any(has))
    })
}

fn marked(names: &[&str], [before, behind]: [&str; 2]) -> Vec<String> {
    let names = names.iter().map(|name| format!("{before}{name}{behind}"));
    names.collect()
}

fn pair(
    storage: &Storage,
    marks: &[[&str; 2]; 2],
    around: &[&Storage],
) -> Result<Vec<NamedCamera>, CameraFileError> {
    let (model, size) = (lens_model(storage, around)?, size(storage, around)?);
    let side = |side: usize| {
        let matrices = marked(&MATRICES, marks[side]);
        // A distortion may be marked in another way, but not by a count that begins elsewhere.
        let from_zero = MARKS[..FROM_ZERO].contains(marks);
        let others = match from_zero {
            true => &MARKS[..FROM_ZERO],
            false => &MARKS[FROM_ZERO..],
        };
        let all = [marks].into_iter().chain(others);
        let distortions = all.flat_map(|marks| marked(&DISTORTIONS, marks[side]));
        let distortions: Vec<String> = distortions.collect();
        let names = [&matrices, &distortions].map(|names| {
            let names = names.iter().map(String::as_str);
            names.collect::<Vec<&str>>()
        });
        let camera = fields::camera(storage, SIDES[side], [&names[0], &names[1]], model)?;
        Ok::<_, CameraFileError>(camera.with_size(size))
    };
    let mut found = vec![side(0)?, side(1)?];
    let scopes = [storage].into_iter().chain(around.iter().copied());
    for scope in scopes {
        if let Some(motion) = motion(scope)? {
            set_poses(&mut found, Some(motion));
            break;
        }
    }
    Ok(found)
}

/// Two cameras whose parameters have names, and the motion from the right one's frame into that of
/// the left one.
fn numbered_pair(
    storage: &Storage,
    around: &[&Storage],
) -> Result<Vec<NamedCamera>, CameraFileError> {
    let (model, size) = (lens_model(storage, around)?, size(storage, around)?);
    let side = |name, prefixes: &[&'static str]| {
        let camera = named_parameters::camera(storage, name, prefixes, model)?;
        let camera = camera.ok_or_else(|| fields::missing(storage, &["Camera1.fx"]))?;
        Ok::<_, CameraFileError>(camera.with_size(size))
    };
    let mut found = vec![side(SIDES[0], &FIRST)?, side(SIDES[1], &SECOND)?];
    let to_left = fields::transform(storage, RIGHT_TO_LEFT)?;
    set_poses(&mut found, to_left.map(Motor::reverse));
    Ok(found)
}

/// The world of a rig is the frame of its left camera.
fn set_poses(pair: &mut [NamedCamera], motion: Option<Motor<f64>>) {
    if let (Some(motion), [left, right]) = (motion, pair) {
        left.pose = Some(Motor::default());
        right.pose = Some(motion);
    }
}

/// The motor from the left camera's frame into the right one's, of a map or of one in it without a
/// camera.
fn motion(storage: &Storage) -> Result<Option<Motor<f64>>, CameraFileError> {
    let maps = storage.maps();
    let others = maps.iter().filter(|(_, map)| !has_camera(map));
    for scope in [storage].into_iter().chain(others.map(|(_, map)| map)) {
        let Some(motion) = fields::pose(scope, &ROTATION, &TRANSLATION)? else {
            continue;
        };
        if motion.translator().displacement() == [0.0; 3] {
            let name = fields::first(scope, &TRANSLATION).unwrap_or(TRANSLATION[0]);
            return Err(CameraFileError::ZeroBaseline(scope.place(name)));
        }
        return Ok(Some(motion));
    }
    Ok(None)
}

fn single(
    storage: &Storage,
    name: &str,
    around: &[&Storage],
) -> Result<NamedCamera, CameraFileError> {
    let model = lens_model(storage, around)?;
    let camera = match named_parameters::camera(storage, name, &FIRST, model)? {
        Some(camera) => camera,
        None => fields::camera(storage, name, [&MATRIX, &DISTORTION], model)?,
    };
    let has_both = [&ROTATION, &TRANSLATION]
        .iter()
        .all(|names| fields::first(storage, *names).is_some());
    let pose = match has_both {
        true => fields::pose(storage, &ROTATION, &TRANSLATION)?,
        false => None,
    };
    Ok(camera.with_size(size(storage, around)?).with_pose(pose))
}

fn size(storage: &Storage, around: &[&Storage]) -> Result<Option<[usize; 2]>, CameraFileError> {
    for scope in [storage].into_iter().chain(around.iter().copied()) {
        if let Some(size) = fields::size(scope, &SIZES, &SIZE_LISTS)? {
            return Ok(Some(size));
        }
    }
    Ok(None)
}

/// The kind of lens that a file states.
fn lens_model(
    storage: &Storage,
    around: &[&Storage],
) -> Result<Option<LensModel>, CameraFileError> {
    for scope in [storage].into_iter().chain(around.iter().copied()) {
        for key in ["fisheye_model", "fisheye", "is_fisheye"] {
            match scope.truth(key)? {
                Some(true) => return Ok(Some(LensModel::Fisheye)),
                Some(false) => return Ok(Some(LensModel::RadialTangential)),
                None => {}
            }
        }
        for key in DISTORTION_MODELS {
            if let Some(model) = named_lens(scope, key)? {
                return Ok(Some(model));
            }
        }
        for key in CAMERA_MODELS {
            if let Some(model) = lens_of_camera_model(scope, key)? {
                return Ok(Some(model));
            }
        }
        for key in ["lens", "model", "type"] {
            if let Some(model) = lens_of_any_name(scope, key)? {
                return Ok(Some(model));
            }
        }
    }
    Ok(None)
}
