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

use std::path::Path;

use ga_files::{ReadError, WriteError};
use ga_runtime::cga3::{Motor, Rotor, Translator};
use nalgebra_035::Matrix3;

use super::camera::{by_rows, intrinsics, is_fisheye, set, set_intrinsics, set_size, shaped, size};
use super::yaml::{Storage, YamlError};
use crate::rig::StereoRig;
use crate::{Camera, Lens};

/// How far the entries of a matrix may be from those of a rotation: matrices with four digits after
/// the point are accepted.
const ROTATION_TOLERANCE: f64 = 1e-4;

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

/// A rig whose world is the frame of its left camera, and the size of its pictures in pixels where
/// it is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigFile {
    /// The two cameras.
    pub rig: StereoRig,
    /// Width and height.
    pub size: Option<[usize; 2]>,
}

impl RigFile {
    /// Reads a rig from the text of a file.
    ///
    /// # Errors
    /// [`YamlError`] for what is not such YAML, and for a rig that is missing or impossible.
    pub fn decode(bytes: &[u8]) -> Result<Self, YamlError> {
        let storage = Storage::decode(bytes)?;
        let is_fisheye = is_fisheye(&storage)?;
        let side = |k: usize| intrinsics(&storage, &MATRICES[k], &DISTORTIONS[k], is_fisheye);
        let camera = |intrinsics, world_to_camera| Camera {
            intrinsics,
            world_to_camera,
        };
        let rig = StereoRig {
            left: camera(side(0)?, Motor::default()),
            right: camera(side(1)?, pose(&storage)?),
        };
        Ok(Self {
            rig,
            size: size(&storage)?,
        })
    }

    /// Reads a file.
    ///
    /// # Errors
    /// [`ReadError`] with the file and an error of [`decode`](Self::decode).
    pub fn read(path: impl AsRef<Path>) -> Result<Self, ReadError<YamlError>> {
        ga_files::read(path, Self::decode)
    }

    /// The text of a file.
    ///
    /// # Errors
    /// [`YamlError::MixedLenses`] where one camera is a fisheye and the other is not.
    pub fn encode(&self) -> Result<String, YamlError> {
        Ok(self.storage()?.encode())
    }

    /// The values of a file, to which others may be added.
    ///
    /// # Errors
    /// As [`encode`](Self::encode).
    pub fn storage(&self) -> Result<Storage, YamlError> {
        let mut storage = Storage::default();
        set_size(&mut storage, self.size);
        let sides = [self.rig.left.intrinsics, self.rig.right.intrinsics];
        match sides.map(|side| matches!(side.lens(), Lens::Fisheye(_))) {
            [true, true] => storage.set_number("fisheye_model", 1.0),
            [false, false] => {}
            _ => return Err(YamlError::MixedLenses),
        }
        for (k, side) in sides.iter().enumerate() {
            set_intrinsics(&mut storage, [MATRICES[k][0], DISTORTIONS[k][0]], side);
        }
        let pose = self.rig.left_to_right().motor;
        let rotation = pose.rotor().to_matrix().into_iter().flatten().collect();
        set(&mut storage, ROTATION[0], [3, 3], rotation);
        let translation = pose.translator().displacement().to_vec();
        set(&mut storage, TRANSLATION[0], [3, 1], translation);
        Ok(storage)
    }

    /// Writes a file, whole or not at all.
    ///
    /// # Errors
    /// [`RigWriteError`] where the format cannot hold the rig, or the file cannot be written.
    pub fn write(&self, path: impl AsRef<Path>) -> Result<(), RigWriteError> {
        Ok(ga_files::write(path, self.encode()?.as_bytes())?)
    }
}

/// Why a rig was not written.
#[derive(Debug, thiserror::Error)]
pub enum RigWriteError {
    /// The format cannot hold it.
    #[error(transparent)]
    Contents(#[from] YamlError),
    /// The file cannot be written.
    #[error(transparent)]
    Write(#[from] WriteError),
}

fn pose(storage: &Storage) -> Result<Motor<f64>, YamlError> {
    let (name, translation) =
        shaped::<3>(storage, &TRANSLATION, &[[3, 1], [1, 3]], "three components")?;
    if translation == [0.0; 3] {
        return Err(YamlError::ZeroBaseline {
            name: name.to_owned(),
            line: storage.line(name),
        });
    }
    let rotor = rotor(storage)?;
    Ok(Translator::from_displacement(translation) * rotor)
}

fn rotor(storage: &Storage) -> Result<Rotor<f64>, YamlError> {
    let name = ROTATION[0];
    let refuse = |deviation| YamlError::Rotation {
        name: name.to_owned(),
        line: storage.line(name),
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

/// The rotation nearest to a matrix, unless one of its entries is further than
/// [`ROTATION_TOLERANCE`] from it; then how far.
pub(super) fn nearest_rotor(rows: [[f64; 3]; 3]) -> Result<Rotor<f64>, f64> {
    if let Some(rotor) = Rotor::from_matrix(rows) {
        return Ok(rotor);
    }
    let given = Matrix3::from_fn(|row, column| rows[row][column]);
    let parts = given.svd(true, true);
    let (Some(u), Some(v)) = (parts.u, parts.v_t) else {
        return Err(f64::INFINITY);
    };
    let nearest = u * v;
    let deviation = (nearest - given).amax();
    if nearest.determinant() < 0.0 || deviation.is_nan() || deviation > ROTATION_TOLERANCE {
        return Err(if nearest.determinant() < 0.0 {
            2.0
        } else {
            deviation
        });
    }
    let rows = [0, 1, 2].map(|row| [0, 1, 2].map(|column| nearest[(row, column)]));
    Rotor::from_matrix(rows).ok_or(deviation)
}
