//! One camera in OpenCV's YAML.
//!
//! | value | names that are read, the first is written |
//! | --- | --- |
//! | K, 3×3 | `camera_matrix`, `cameraMatrix`, `Camera_Matrix`, `K`, `M` |
//! | distortion | `distortion_coefficients`, `distCoeffs`, `dist_coeffs`, `D` |
//! | width | `image_width`, `image_Width`, the first of a list `image_size` or `imageSize` |
//! | height | `image_height`, `image_Height`, the second of that list |
//! | fisheye | `fisheye_model: 1`, `distortion_model: equidistant` or `fisheye` |
//!
//! The distortion has 4, 5, 8, 12 or 14 numbers in OpenCV's order, that of a fisheye 4. The names
//! `Camera_Matrix` and `Distortion_Coefficients` are those of an old example of OpenCV.
//! Without distortion the camera is a pinhole. Everything else in the file is ignored.

use super::camera_file::{CameraFile, NamedCamera, SINGLE};
use super::error::{CameraFileError, Place};
use super::yaml::{Matrix, Storage};
use crate::{CameraError, Intrinsics, Lens, LensModel};

/// The names of K.
pub(super) const MATRIX: [&str; 5] = ["camera_matrix", "cameraMatrix", "Camera_Matrix", "K", "M"];
const DISTORTION: [&str; 5] = [
    "distortion_coefficients",
    "distCoeffs",
    "dist_coeffs",
    "Distortion_Coefficients",
    "D",
];

/// The camera of a file.
pub(super) fn decode(storage: &Storage) -> Result<CameraFile, CameraFileError> {
    let intrinsics = intrinsics(storage, &MATRIX, &DISTORTION, lens_model(storage)?)?;
    let camera = NamedCamera::new(SINGLE, intrinsics).with_size(size(storage)?);
    Ok(CameraFile::new(vec![camera]))
}

/// The text of a file.
///
/// ```
/// use std::path::Path;
/// use ga_camera::{Intrinsics, format};
/// let intrinsics = Intrinsics::new([500.0, 501.0], [320.0, 240.0])?;
/// let text = format::camera::encode(&intrinsics, Some([640, 480]));
/// let file = format::decode(text.as_bytes(), Path::new(""))?;
/// assert_eq!(file.cameras[0].intrinsics()?, intrinsics);
/// assert_eq!(file.cameras[0].size, Some([640, 480]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn encode(intrinsics: &Intrinsics, size: Option<[usize; 2]>) -> String {
    let mut storage = Storage::default();
    set_size(&mut storage, size);
    if intrinsics.lens().model() == LensModel::Fisheye {
        storage.set_number("fisheye_model", 1.0);
    }
    set_intrinsics(&mut storage, [MATRIX[0], DISTORTION[0]], intrinsics);
    storage.encode()
}

/// The first of several names under which a value is stored.
pub(super) fn first<'a>(storage: &Storage, names: &[&'a str]) -> Option<&'a str> {
    let mut names = names.iter().copied();
    names.find(|name| storage.names().any(|other| other == *name))
}

pub(super) fn missing(names: &[&'static str]) -> CameraFileError {
    CameraFileError::Missing {
        place: Place::on_line(0, names[0]),
        also: names[1..].to_vec(),
    }
}

/// Where a value stands.
pub(super) fn place(storage: &Storage, name: &str) -> Place {
    Place::on_line(storage.line(name), name)
}

/// A matrix of some shape, with the name under which it was found.
pub(super) fn shaped<'a, const N: usize>(
    storage: &Storage,
    names: &[&'static str],
    shapes: &[[usize; 2]],
    expected: &'static str,
) -> Result<(&'a str, [f64; N]), CameraFileError> {
    let name = first(storage, names).ok_or_else(|| missing(names))?;
    let matrix = storage.matrix(name)?.ok_or_else(|| missing(names))?;
    let values = <[f64; N]>::try_from(matrix.values());
    match values {
        Ok(values) if shapes.contains(&[matrix.rows(), matrix.columns()]) => Ok((name, values)),
        _ => Err(CameraFileError::Shape {
            place: place(storage, name),
            rows: matrix.rows(),
            columns: matrix.columns(),
            expected,
        }),
    }
}

pub(super) fn by_rows(values: [f64; 9]) -> [[f64; 3]; 3] {
    let [a, b, c, d, e, f, g, h, i] = values;
    [[a, b, c], [d, e, f], [g, h, i]]
}

pub(super) fn intrinsics(
    storage: &Storage,
    matrix: &[&'static str],
    distortion: &[&'static str],
    model: LensModel,
) -> Result<Intrinsics, CameraFileError> {
    let (name, values) = shaped::<9>(storage, matrix, &[[3, 3]], "3 × 3")?;
    let refuse = |name: &str, error: CameraError| CameraFileError::Camera {
        place: place(storage, name),
        error: error.into(),
    };
    let plain = Intrinsics::from_matrix(by_rows(values)).map_err(|error| refuse(name, error))?;
    let Some(name) = first(storage, distortion) else {
        return Ok(plain);
    };
    let matrix = storage.matrix(name)?.ok_or_else(|| missing(distortion))?;
    if matrix.rows() > 1 && matrix.columns() > 1 {
        return Err(CameraFileError::Shape {
            place: place(storage, name),
            rows: matrix.rows(),
            columns: matrix.columns(),
            expected: "one row or one column",
        });
    }
    let lens = match matrix.values() {
        [] => Ok(Lens::Pinhole),
        values => model.lens(values),
    };
    Ok(plain.with_lens(lens.map_err(|error| refuse(name, error))?))
}

/// The kind of lens that a distortion describes; that of most files where the file does not say it.
pub(super) fn lens_model(storage: &Storage) -> Result<LensModel, CameraFileError> {
    if let Some(number) = storage.number("fisheye_model")? {
        return Ok(match number {
            0.0 => LensModel::RadialTangential,
            _ => LensModel::Fisheye,
        });
    }
    let Some(name) = storage.text("distortion_model")? else {
        return Ok(LensModel::RadialTangential);
    };
    let distorting = LensModel::ALL
        .into_iter()
        .filter(|model| *model != LensModel::Pinhole);
    let names = distorting.flat_map(|model| model.names().map(move |name| (name, model)));
    let names: Vec<_> = names.collect();
    let named = names.iter().find(|(known, _)| *known == name);
    named
        .map(|(_, model)| *model)
        .ok_or_else(|| CameraFileError::Lens {
            place: place(storage, "distortion_model"),
            known: names.iter().map(|(known, _)| *known).collect(),
        })
}

pub(super) fn size(storage: &Storage) -> Result<Option<[usize; 2]>, CameraFileError> {
    for names in [
        ["image_width", "image_height"],
        ["image_Width", "image_Height"],
    ] {
        let [width, height] =
            names.map(|name| Ok::<_, CameraFileError>((name, storage.number(name)?)));
        match (width?, height?) {
            ((_, None), (_, None)) => {}
            ((first, Some(width)), (second, Some(height))) => {
                let pixels = |name, value| pixels(place(storage, name), value);
                return Ok(Some([pixels(first, width)?, pixels(second, height)?]));
            }
            ((name, None), _) | (_, (name, None)) => {
                return Err(missing(&[name]));
            }
        }
    }
    let names = ["image_size", "imageSize"];
    if first(storage, &names).is_none() {
        return Ok(None);
    }
    let (name, [width, height]) =
        shaped::<2>(storage, &names, &[[2, 1], [1, 2]], "width and height")?;
    let pixels = |value| pixels(place(storage, name), value);
    Ok(Some([pixels(width)?, pixels(height)?]))
}

fn pixels(place: Place, value: f64) -> Result<usize, CameraFileError> {
    if value >= 1.0 && value <= f64::from(u32::MAX) && value.fract() == 0.0 {
        Ok(value as usize)
    } else {
        Err(CameraFileError::Size { place, value })
    }
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
    let all = lens.coefficients();
    let used = all.iter().rposition(|x| *x != 0.0).map_or(0, |k| k + 1);
    let mut counts = lens.model().counts().iter().copied();
    let count = counts.find(|count| *count >= used);
    let count = count.unwrap_or(lens.coefficient_count());
    set(storage, distortion, [1, count], all[..count].to_vec());
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
