//! A stereo rig as OpenCV stores it.
//!
//! The names are those of OpenCV's `stereoCalibrate` and of its examples: `M1`, `D1`, `M2` and `D2`
//! are K and the distortion of the left and the right camera, `R` and `T` the rotation and the
//! translation in metres from the left camera to the right one, and the others those of
//! [one camera](super::camera). Other names are read too.

use ga_runtime::cga3::Motor;

use super::camera::{set, set_intrinsics, set_size};
use super::error::CameraFileError;
use super::storage::Storage;
use crate::rig::StereoRig;
use crate::{Intrinsics, LensModel};

/// The names of K and the distortion of both cameras.
const NAMES: [[&str; 2]; 2] = [["M1", "D1"], ["M2", "D2"]];

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
    let sides = [rig.left.intrinsics, rig.right.intrinsics];
    let pose = rig.left_to_right().motor;
    storage_of(sides, Some(pose), size)
}

/// The values of two cameras, whose pose may not be known.
pub(super) fn storage_of(
    sides: [Intrinsics; 2],
    pose: Option<Motor<f64>>,
    size: Option<[usize; 2]>,
) -> Result<Storage, CameraFileError> {
    let mut storage = Storage::default();
    set_size(&mut storage, size);
    match sides.map(|side| side.lens().model() == LensModel::Fisheye) {
        [true, true] => storage.set_number("fisheye_model", 1.0),
        [false, false] => {}
        _ => return Err(CameraFileError::MixedLenses),
    }
    for (k, side) in sides.iter().enumerate() {
        set_intrinsics(&mut storage, NAMES[k], side);
    }
    if let Some(pose) = pose {
        set_pose(&mut storage, pose);
    }
    Ok(storage)
}

/// Stores rotation and translation.
pub(super) fn set_pose(storage: &mut Storage, pose: Motor<f64>) {
    let rotation = pose.rotor().to_matrix().into_iter().flatten().collect();
    set(storage, "R", [3, 3], rotation);
    let translation = pose.translator().displacement().to_vec();
    set(storage, "T", [3, 1], translation);
}
