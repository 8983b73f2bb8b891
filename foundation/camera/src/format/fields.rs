//! The values of a camera in a map of names to values.

use ga_runtime::cga3::{Motor, Rotor, Translator};

use super::camera_file::NamedCamera;
use super::error::{CameraFileError, Place};
use super::rotation::nearest_rotor;
use super::storage::Storage;
use crate::{CameraError, Intrinsics, Lens, LensModel};

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

/// The numbers do not form a camera.
pub(super) fn refused(place: Place, error: CameraError) -> CameraFileError {
    CameraFileError::Camera {
        place,
        error: error.into(),
    }
}

/// Focal lengths and principal point from K, which is 3×3 or a list by rows.
fn pinhole(storage: &Storage, names: &[&str]) -> Result<Intrinsics, CameraFileError> {
    let shapes = [[3, 3], [9, 1], [1, 9]];
    let (name, values) = shaped::<9>(storage, names, &shapes, "3 × 3")?;
    let plain = Intrinsics::from_matrix(by_rows(values));
    plain.map_err(|error| refused(storage.place(name), error))
}

/// The camera of K and of the coefficients of its lens, whose kind the file may state.
pub(super) fn camera(
    storage: &Storage,
    name: &str,
    [matrix, distortion]: [&[&str]; 2],
    stated: Option<LensModel>,
) -> Result<NamedCamera, CameraFileError> {
    let plain = pinhole(storage, matrix)?;
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
    let (lens, is_unclear) = lens(&values, stated).map_err(|error| refused(place(), error))?;
    Ok(camera(lens).with_unclear_lens(is_unclear.then(place)))
}

/// The lens of some coefficients, and whether it may be one of another kind: a lens whose kind is
/// not stated is radial–tangential, as that of most files, unless it has four coefficients.
pub(super) fn lens(values: &[f64], stated: Option<LensModel>) -> Result<(Lens, bool), CameraError> {
    let are_zero = values.iter().all(|x| *x == 0.0);
    let lens = match stated {
        Some(LensModel::Fisheye) => LensModel::Fisheye.lens(values)?,
        _ if values.is_empty() => Lens::Pinhole,
        Some(LensModel::Pinhole) if are_zero => Lens::Pinhole,
        Some(LensModel::Pinhole) => LensModel::Pinhole.lens(values)?,
        _ => match LensModel::RadialTangential.lens(values)? {
            // A lens without distortion is a pinhole.
            _ if are_zero => Lens::Pinhole,
            lens => lens,
        },
    };
    Ok((lens, stated.is_none() && values.len() == 4 && !are_zero))
}

/// The kind of lens that a text names.
pub(super) fn named_lens(
    storage: &Storage,
    key: &str,
) -> Result<Option<LensModel>, CameraFileError> {
    let Some(text) = storage.text(key)? else {
        return Ok(None);
    };
    let names = LensModel::ALL.map(|model| model.names().map(move |name| (name, model)));
    let names: Vec<_> = names.into_iter().flatten().collect();
    let named = names
        .iter()
        .find(|(known, _)| known.eq_ignore_ascii_case(&text));
    match named {
        Some((_, model)) => Ok(Some(*model)),
        None => Err(CameraFileError::Model {
            place: storage.place(key),
            found: text.into(),
            known: names.iter().map(|(known, _)| *known).collect(),
        }),
    }
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
    let refuse = |deviation| CameraFileError::Rotation {
        place: storage.place(name),
        deviation,
    };
    if let Some(vector) = storage.matrix(name)?.filter(|m| m.values().len() == 3) {
        let vector = [0, 1, 2].map(|k| vector.values()[k]);
        return Rotor::from_rotation_vector(vector).ok_or(refuse(f64::INFINITY));
    }
    let shapes = [[3, 3], [9, 1], [1, 9]];
    let (_, values) = shaped::<9>(storage, names, &shapes, "3 × 3 or three components")?;
    nearest_rotor(by_rows(values)).map_err(refuse)
}

/// The motor of a matrix 4×4, or of its first three rows.
pub(super) fn transform(
    storage: &Storage,
    name: &str,
) -> Result<Option<Motor<f64>>, CameraFileError> {
    let Some(matrix) = storage.matrix(name)? else {
        return Ok(None);
    };
    let values = matrix.values();
    let is_whole = matrix.columns() == 4 && matches!(matrix.rows(), 3 | 4);
    if !is_whole {
        return Err(CameraFileError::Shape {
            place: storage.place(name),
            rows: matrix.rows(),
            columns: matrix.columns(),
            expected: "4 × 4",
        });
    }
    let rows = [0, 1, 2].map(|row| [0, 1, 2, 3].map(|column| values[4 * row + column]));
    let motor = rigid(rows).map_err(|deviation| CameraFileError::Rotation {
        place: storage.place(name),
        deviation,
    })?;
    Ok(Some(motor))
}

/// The motor of the rows of a rotation and a translation, or how far the former is from a rotation.
pub(super) fn rigid(rows: [[f64; 4]; 3]) -> Result<Motor<f64>, f64> {
    let rotor = nearest_rotor(rows.map(|[a, b, c, _]| [a, b, c]))?;
    Ok(Translator::from_displacement(rows.map(|row| row[3])) * rotor)
}

/// The rows of a motor's rotation and translation.
pub(super) fn rows(motor: Motor<f64>) -> [[f64; 4]; 3] {
    let (rotation, along) = (motor.rotor().to_matrix(), motor.translator().displacement());
    [0, 1, 2].map(|row| {
        let [a, b, c] = rotation[row];
        [a, b, c, along[row]]
    })
}
