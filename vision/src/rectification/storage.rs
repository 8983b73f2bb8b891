//! The result of a rectification as a file of cameras.

use ga_camera::format::CameraFileError;
use ga_camera::format::rig;
use ga_camera::format::storage::{Matrix, Storage};

use super::Rectification;

impl Rectification {
    /// The rectified cameras, with the matrices that OpenCV's `stereoRectify` returns:
    /// `R1`, `R2`, `P1`, `P2` and `Q`.
    ///
    /// # Errors
    /// [`CameraFileError`] where the numbers do not fit the format.
    pub fn storage(&self) -> Result<Storage, CameraFileError> {
        let found = self;
        let mut storage = rig::storage(&found.rig.stereo_rig(), Some(found.size))?;
        for (name, motor) in [("R1", found.left.motor), ("R2", found.right.motor)] {
            let rows = motor.rotor().to_matrix();
            storage.set_matrix(
                name,
                Matrix::new(3, 3, rows.into_iter().flatten().collect())?,
            );
        }
        let (left, right) = (found.rig.left(), found.rig.right());
        let (focal, baseline) = (left.focal()[0], found.rig.baseline());
        for (name, camera, along) in [("P1", left, 0.0), ("P2", right, -focal * baseline)] {
            let [a, b, c] = camera.to_matrix();
            let rows = [
                [a[0], a[1], a[2], along],
                [b[0], b[1], b[2], 0.0],
                [c[0], c[1], c[2], 0.0],
            ];
            storage.set_matrix(
                name,
                Matrix::new(3, 4, rows.into_iter().flatten().collect())?,
            );
        }
        let [cx, cy] = left.principal();
        let offset = found.rig.disparity_offset() / baseline;
        let q = [
            [1.0, 0.0, 0.0, -cx],
            [0.0, 1.0, 0.0, -cy],
            [0.0, 0.0, 0.0, focal],
            [0.0, 0.0, 1.0 / baseline, offset],
        ];
        storage.set_matrix("Q", Matrix::new(4, 4, q.into_iter().flatten().collect())?);
        Ok(storage)
    }
}
