//! The values of a camera in a map of names to values.

use ga_runtime::cga3::{Motor, Rotor, Translator};

use super::camera_file::NamedCamera;
use super::error::{CameraFileError, Place, refused};
use super::lens::lens;
use super::rotation::{homogeneous, nearest_rotor};
use super::storage::Storage;
use crate::{Intrinsics, Lens, LensModel};

/// The first of several names under which a value is stored.
pub(super) fn first<'a>(storage: &Storage, names: &[&'a str]) -> Option<&'a str> {
    let mut names = names.iter().copied();
    names.find(|name| storage.has(name))
}

pub(super) fn missing(storage: &Storage, names: &[&str]) -> CameraFileError {
    CameraFileError::Missing {
        place: storage.place(names[0]),
        also: names[1..].iter().map(ToString::to_string).collect(),
    }
}

/// A matrix of some shape, with the name under which it was found.
pub(super) fn shaped<'a, const N: usize>(
    storage: &Storage,
    names: &[&'a str],
    shapes: &[[usize; 2]],
    expected: &'static str,
) -> Result<(&'a str, [f64; N]), CameraFileError> {
    let name = first(storage, names).ok_or_else(|| missing(storage, names))?;
    let matrix = storage.matrix(name)?;
    let matrix = matrix.ok_or_else(|| missing(storage, names))?;
    let values = <[f64; N]>::try_from(matrix.values());
    match values {
        Ok(values) if shapes.contains(&[matrix.rows(), matrix.columns()]) => Ok((name, values)),
        _ => Err(CameraFileError::Shape {
            place: storage.place(name),
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

/// A camera without distortion.
pub(super) fn pinhole(
    focal: [f64; 2],
    principal: [f64; 2],
    place: impl FnOnce() -> Place,
) -> Result<Intrinsics, CameraFileError> {
    Intrinsics::new(focal, principal).map_err(|error| refused(place(), error))
}

/// The same of K by rows.
pub(super) fn pinhole_of_matrix(
    rows: [[f64; 3]; 3],
    place: impl FnOnce() -> Place,
) -> Result<Intrinsics, CameraFileError> {
    Intrinsics::from_matrix(rows).map_err(|error| refused(place(), error))
}

/// Focal lengths and principal point from K, which is 3×3 or a list by rows.
fn projection(storage: &Storage, names: &[&str]) -> Result<Intrinsics, CameraFileError> {
    let shapes = [[3, 3], [9, 1], [1, 9]];
    let (name, values) = shaped::<9>(storage, names, &shapes, "3 × 3")?;
    pinhole_of_matrix(by_rows(values), || storage.place(name))
}

/// The camera of K and of the coefficients of its lens, whose kind the file may state.
pub(super) fn camera(
    storage: &Storage,
    name: &str,
    [matrix, distortion]: [&[&str]; 2],
    stated: Option<LensModel>,
) -> Result<NamedCamera, CameraFileError> {
    let plain = projection(storage, matrix)?;
    let camera = |lens: Lens| NamedCamera::new(name, plain.with_lens(lens));
    let Some(key) = first(storage, distortion) else {
        return match stated {
            Some(LensModel::Fisheye) => Err(missing(storage, distortion)),
            _ => Ok(camera(Lens::Pinhole)),
        };
    };
    let place = || storage.place(key);
    if let Some(matrix) = storage.matrix(key)?
        && matrix.rows() > 1
        && matrix.columns() > 1
    {
        return Err(CameraFileError::Shape {
            place: place(),
            rows: matrix.rows(),
            columns: matrix.columns(),
            expected: "one row or one column",
        });
    }
    let values = storage.list(key)?.unwrap_or_default();
    let (lens, unstated) = lens(&values, stated, place)?;
    Ok(camera(lens).with_unstated_lens(unstated))
}

/// Columns and rows of pictures, under a pair of names or as a list.
pub(super) fn size(
    storage: &Storage,
    pairs: &[[&'static str; 2]],
    lists: &[&'static str],
) -> Result<Option<[usize; 2]>, CameraFileError> {
    for [wide, high] in pairs {
        let pixels = |name, value| pixels(storage.place(name), value);
        match (storage.number(wide)?, storage.number(high)?) {
            (None, None) => {}
            (Some(width), Some(height)) => {
                return Ok(Some([pixels(wide, width)?, pixels(high, height)?]));
            }
            (Some(_), None) => return Err(missing(storage, &[high])),
            (None, Some(_)) => return Err(missing(storage, &[wide])),
        }
    }
    if first(storage, lists).is_none() {
        return Ok(None);
    }
    let shapes = [[2, 1], [1, 2]];
    let (name, [width, height]) = shaped::<2>(storage, lists, &shapes, "width and height")?;
    let pixels = |value| pixels(storage.place(name), value);
    Ok(Some([pixels(width)?, pixels(height)?]))
}

pub(super) fn pixels(place: Place, value: f64) -> Result<usize, CameraFileError> {
    if value >= 1.0 && value <= f64::from(u32::MAX) && value.fract() == 0.0 {
        Ok(value as usize)
    } else {
        Err(CameraFileError::Size { place, value })
    }
}

/// The motor of a rotation, 3×3 or a vector, and a translation, where there is one of them.
pub(super) fn pose(
    storage: &Storage,
    rotations: &[&str],
    translations: &[&str],
) -> Result<Option<Motor<f64>>, CameraFileError> {
    if first(storage, rotations)
        .or(first(storage, translations))
        .is_none()
    {
        return Ok(None);
    }
    let shapes = [[3, 1], [1, 3]];
    let (_, along) = shaped::<3>(storage, translations, &shapes, "three components")?;
    Ok(Some(
        Translator::from_displacement(along) * rotor(storage, rotations)?,
    ))
}

fn rotor(storage: &Storage, names: &[&str]) -> Result<Rotor<f64>, CameraFileError> {
    let name = first(storage, names).ok_or_else(|| missing(storage, names))?;
    if let Some(vector) = storage.matrix(name)?.filter(|m| m.values().len() == 3) {
        let vector = [0, 1, 2].map(|k| vector.values()[k]);
        return Rotor::from_rotation_vector(vector).ok_or_else(|| CameraFileError::Value {
            place: storage.place(name),
            expected: "a rotation vector",
        });
    }
    let shapes = [[3, 3], [9, 1], [1, 9]];
    let (_, values) = shaped::<9>(storage, names, &shapes, "3 × 3 or three components")?;
    nearest_rotor(by_rows(values), || storage.place(name))
}

/// The motor of a matrix 4×4, or of its first three rows.
pub(super) fn transform(
    storage: &Storage,
    name: &str,
) -> Result<Option<Motor<f64>>, CameraFileError> {
    let Some(matrix) = storage.matrix(name)? else {
        return Ok(None);
    };
    if matrix.columns() != 4 || !matches!(matrix.rows(), 3 | 4) {
        return Err(CameraFileError::Shape {
            place: storage.place(name),
            rows: matrix.rows(),
            columns: matrix.columns(),
            expected: "4 × 4",
        });
    }
    let (rows, _) = matrix.values().as_chunks();
    homogeneous(rows, || storage.place(name)).map(Some)
}
