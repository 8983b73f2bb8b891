//! A stereo rig in OpenCV's YAML.
//!
//! The names are those of OpenCV's `stereoCalibrate` and of its examples:
//!
//! | value | names that are read, the first is written |
//! | --- | --- |
//! | K of the left camera, 3×3 | `M1`, `K1`, `cameraMatrix1`, `camera_matrix_1` |
//! | its distortion | `D1`, `distCoeffs1`, `dist_coeffs_1`, `distortion_coefficients_1` |
//! | the right camera | the same with 2 |
//! | rotation from left to right, 3×3 or a rotation vector | `R` |
//! | translation from left to right in metres | `T`, `t` |
//! | size of the pictures, fisheye | as for [one camera](super::camera) |
//!
//! A point of the left camera's frame is at `x_right = R x_left + T` in the right one's. A rotation
//! that has few digits is replaced by the nearest one.

use ga_runtime::cga3::{Motor, Rotor, Translator};

use super::camera::{
    self, by_rows, first, intrinsics, lens_model, missing, place, set, set_intrinsics, set_size,
    shaped, size,
};
use super::camera_file::{CameraFile, NamedCamera};
use super::error::CameraFileError;
use super::rotation::nearest_rotor;
use super::yaml::Storage;
use crate::LensModel;
use crate::rig::StereoRig;

const MATRICES: [[&str; 4]; 2] = [
    ["M1", "K1", "cameraMatrix1", "camera_matrix_1"],
    ["M2", "K2", "cameraMatrix2", "camera_matrix_2"],
];
const DISTORTIONS: [[&str; 4]; 2] = [
    [
        "D1",
        "distCoeffs1",
        "dist_coeffs_1",
        "distortion_coefficients_1",
    ],
    [
        "D2",
        "distCoeffs2",
        "dist_coeffs_2",
        "distortion_coefficients_2",
    ],
];
const ROTATION: [&str; 1] = ["R"];
const TRANSLATION: [&str; 2] = ["T", "t"];

/// The names of the cameras.
pub(super) const SIDES: [&str; 2] = ["left", "right"];

/// Whether there is the matrix of a camera.
pub(super) fn has_matrix(storage: &Storage) -> bool {
    let is_pair = MATRICES.iter().any(|names| first(storage, names).is_some());
    is_pair || first(storage, &camera::MATRIX).is_some()
}

/// The cameras of a file of one or of two.
pub(super) fn decode(storage: &Storage) -> Result<CameraFile, CameraFileError> {
    if MATRICES.iter().any(|names| first(storage, names).is_some()) {
        return pair(storage);
    }
    match first(storage, &camera::MATRIX) {
        Some(_) => camera::decode(storage),
        None => Err(missing(&[camera::MATRIX.as_slice(), &MATRICES[0]].concat())),
    }
}

fn pair(storage: &Storage) -> Result<CameraFile, CameraFileError> {
    let model = lens_model(storage)?;
    let side = |k: usize| intrinsics(storage, &MATRICES[k], &DISTORTIONS[k], model);
    let intrinsics = [side(0)?, side(1)?];
    let poses = [Motor::default(), pose(storage)?];
    let size = size(storage)?;
    let camera = |k: usize| {
        let camera = NamedCamera::new(SIDES[k], intrinsics[k]).with_size(size);
        camera.with_pose(Some(poses[k]))
    };
    Ok(CameraFile::new(vec![camera(0), camera(1)]))
}

/// The text of a file.
///
/// # Errors
/// As [`storage`].
pub fn encode(rig: &StereoRig, size: Option<[usize; 2]>) -> Result<String, CameraFileError> {
    Ok(storage(rig, size)?.encode())
}

/// The values of a file, to which others may be added.
///
/// # Errors
/// [`CameraFileError::MixedLenses`] where one camera is a fisheye and the other is not.
pub fn storage(rig: &StereoRig, size: Option<[usize; 2]>) -> Result<Storage, CameraFileError> {
    let mut storage = Storage::default();
    set_size(&mut storage, size);
    let sides = [rig.left.intrinsics, rig.right.intrinsics];
    match sides.map(|side| side.lens().model() == LensModel::Fisheye) {
        [true, true] => storage.set_number("fisheye_model", 1.0),
        [false, false] => {}
        _ => return Err(CameraFileError::MixedLenses),
    }
    for (k, side) in sides.iter().enumerate() {
        set_intrinsics(&mut storage, [MATRICES[k][0], DISTORTIONS[k][0]], side);
    }
    let pose = rig.left_to_right().motor;
    let rotation = pose.rotor().to_matrix().into_iter().flatten().collect();
    set(&mut storage, ROTATION[0], [3, 3], rotation);
    let translation = pose.translator().displacement().to_vec();
    set(&mut storage, TRANSLATION[0], [3, 1], translation);
    Ok(storage)
}

fn pose(storage: &Storage) -> Result<Motor<f64>, CameraFileError> {
    let (name, translation) =
        shaped::<3>(storage, &TRANSLATION, &[[3, 1], [1, 3]], "three components")?;
    if translation == [0.0; 3] {
        return Err(CameraFileError::ZeroBaseline(place(storage, name)));
    }
    let rotor = rotor(storage)?;
    Ok(Translator::from_displacement(translation) * rotor)
}

fn rotor(storage: &Storage) -> Result<Rotor<f64>, CameraFileError> {
    let name = ROTATION[0];
    let refuse = |deviation| CameraFileError::Rotation {
        place: place(storage, name),
        deviation,
    };
    if let Some(vector) = storage.matrix(name)?.filter(|m| m.values().len() == 3) {
        let vector = [0, 1, 2].map(|k| vector.values()[k]);
        return Rotor::from_rotation_vector(vector).ok_or(refuse(f64::INFINITY));
    }
    let (_, values) = shaped::<9>(storage, &ROTATION, &[[3, 3]], "3 × 3 or three components")?;
    let rows = by_rows(values);
    nearest_rotor(rows).map_err(refuse)
}
