//! One camera as OpenCV stores it.
//!
//! `camera_matrix` is K, `distortion_coefficients` are those of the lens in OpenCV's order,
//! `image_width` and `image_height` the size of the pictures where it is known, and `fisheye_model`
//! is 1 for a fisheye. Other names are read too.

use super::storage::{Matrix, Storage};
use crate::{Intrinsics, Lens, LensModel};

/// The values of a file, to which others may be added.
///
/// ```
/// use std::path::Path;
/// use ga_camera::{Intrinsics, format};
/// let intrinsics = Intrinsics::new([500.0, 501.0], [320.0, 240.0])?;
/// let text = format::camera::storage(&intrinsics, Some([640, 480])).encode();
/// let file = format::decode(text.as_bytes(), Path::new(""))?;
/// assert_eq!(file.cameras[0].intrinsics()?, intrinsics);
/// assert_eq!(file.cameras[0].size, Some([640, 480]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn storage(intrinsics: &Intrinsics, size: Option<[usize; 2]>) -> Storage {
    let mut storage = Storage::default();
    set_size(&mut storage, size);
    if intrinsics.lens().model() == LensModel::Fisheye {
        storage.set_number("fisheye_model", 1.0);
    }
    let names = ["camera_matrix", "distortion_coefficients"];
    set_intrinsics(&mut storage, names, intrinsics);
    storage
}

pub(super) fn set_size(storage: &mut Storage, size: Option<[usize; 2]>) {
    if let Some([width, height]) = size {
        storage.set_number("image_width", width as f64);
        storage.set_number("image_height", height as f64);
    }
}

/// Stores K and the distortion, of which trailing zeros that OpenCV does not need are left out.
pub(super) fn set_intrinsics(
    storage: &mut Storage,
    [matrix, distortion]: [&str; 2],
    intrinsics: &Intrinsics,
) {
    let values = intrinsics.to_matrix().into_iter().flatten().collect();
    set(storage, matrix, [3, 3], values);
    let lens = intrinsics.lens();
    if lens == Lens::Pinhole {
        return;
    }
    let used = used_coefficients(&lens);
    set(storage, distortion, [1, used.len()], used);
}

/// The coefficients without the trailing zeros that files need not have.
pub(super) fn used_coefficients(lens: &Lens) -> Vec<f64> {
    let all = lens.coefficients();
    let used = all.iter().rposition(|x| *x != 0.0).map_or(0, |k| k + 1);
    let mut counts = lens.model().counts().iter().copied();
    let count = counts.find(|count| *count >= used);
    all[..count.unwrap_or(lens.coefficient_count())].to_vec()
}

/// Stores numbers that are known to be finite and to fill the shape.
pub(super) fn set(
    storage: &mut Storage,
    name: &str,
    [rows, columns]: [usize; 2],
    values: Vec<f64>,
) {
    if let Ok(matrix) = Matrix::new(rows, columns, values) {
        storage.set_matrix(name, matrix);
    }
}
