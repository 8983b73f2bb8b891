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

use std::path::Path;

use ga_files::{ReadError, WriteError};

use super::yaml::{Matrix, Storage, YamlError};
use crate::{CameraError, Fisheye, Intrinsics, Lens, RadialTangential};

const MATRIX: [&str; 5] = ["camera_matrix", "cameraMatrix", "Camera_Matrix", "K", "M"];
const DISTORTION: [&str; 5] = [
    "distortion_coefficients",
    "distCoeffs",
    "dist_coeffs",
    "Distortion_Coefficients",
    "D",
];

/// A camera, and the size of its pictures in pixels where it is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraFile {
    /// Focal lengths, principal point and lens.
    pub intrinsics: Intrinsics,
    /// Width and height.
    pub size: Option<[usize; 2]>,
}

impl CameraFile {
    /// Reads a camera from the text of a file.
    ///
    /// # Errors
    /// [`YamlError`] for what is not such YAML, and for a camera that is missing or impossible.
    ///
    /// ```
    /// use ga_camera::format::camera::CameraFile;
    /// let text = "%YAML:1.0\n---\nK: [[500, 0, 320], [0, 501, 240], [0, 0, 1]]\n";
    /// let file = CameraFile::decode(text.as_bytes())?;
    /// assert_eq!(file.intrinsics.focal(), [500.0, 501.0]);
    /// assert_eq!(file, CameraFile::decode(file.encode().as_bytes())?);
    /// # Ok::<(), ga_camera::format::yaml::YamlError>(())
    /// ```
    pub fn decode(bytes: &[u8]) -> Result<Self, YamlError> {
        let storage = Storage::decode(bytes)?;
        let is_fisheye = is_fisheye(&storage)?;
        Ok(Self {
            intrinsics: intrinsics(&storage, &MATRIX, &DISTORTION, is_fisheye)?,
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
    #[must_use]
    pub fn encode(&self) -> String {
        let mut storage = Storage::default();
        set_size(&mut storage, self.size);
        if matches!(self.intrinsics.lens(), Lens::Fisheye(_)) {
            storage.set_number("fisheye_model", 1.0);
        }
        set_intrinsics(&mut storage, [MATRIX[0], DISTORTION[0]], &self.intrinsics);
        storage.encode()
    }

    /// Writes a file, whole or not at all.
    ///
    /// # Errors
    /// [`WriteError`] where it cannot be written.
    pub fn write(&self, path: impl AsRef<Path>) -> Result<(), WriteError> {
        ga_files::write(path, self.encode().as_bytes())
    }
}

/// The first of several names under which a value is stored.
pub(super) fn first<'a>(storage: &Storage, names: &[&'a str]) -> Option<&'a str> {
    let mut names = names.iter().copied();
    names.find(|name| storage.names().any(|other| other == *name))
}

pub(super) fn missing(names: &[&'static str]) -> YamlError {
    let quoted: Vec<String> = names[1..].iter().map(|name| format!("`{name}`")).collect();
    YamlError::Missing {
        name: names[0],
        also: match quoted.as_slice() {
            [] => String::new(),
            quoted => format!(", and none of {}", quoted.join(", ")),
        },
    }
}

/// A matrix of some shape, with the name under which it was found.
pub(super) fn shaped<'a, const N: usize>(
    storage: &Storage,
    names: &[&'static str],
    shapes: &[[usize; 2]],
    expected: &'static str,
) -> Result<(&'a str, [f64; N]), YamlError> {
    let name = first(storage, names).ok_or_else(|| missing(names))?;
    let matrix = storage.matrix(name)?.ok_or_else(|| missing(names))?;
    let values = <[f64; N]>::try_from(matrix.values());
    match values {
        Ok(values) if shapes.contains(&[matrix.rows(), matrix.columns()]) => Ok((name, values)),
        _ => Err(YamlError::Shape {
            name: name.to_owned(),
            line: storage.line(name),
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
    is_fisheye: bool,
) -> Result<Intrinsics, YamlError> {
    let (name, values) = shaped::<9>(storage, matrix, &[[3, 3]], "3 × 3")?;
    let refuse = |name: &str, error: CameraError| YamlError::Camera {
        name: name.to_owned(),
        line: storage.line(name),
        error: error.into(),
    };
    let plain = Intrinsics::from_matrix(by_rows(values)).map_err(|error| refuse(name, error))?;
    let Some(name) = first(storage, distortion) else {
        return Ok(plain);
    };
    let matrix = storage.matrix(name)?.ok_or_else(|| missing(distortion))?;
    if matrix.rows() > 1 && matrix.columns() > 1 {
        return Err(YamlError::Shape {
            name: name.to_owned(),
            line: storage.line(name),
            rows: matrix.rows(),
            columns: matrix.columns(),
            expected: "one row or one column",
        });
    }
    let values = matrix.values();
    let lens = match (values, is_fisheye) {
        ([], _) => Ok(Lens::Pinhole),
        (values, true) => Fisheye::new(values).map(Lens::from),
        (values, false) => RadialTangential::new(values).map(Lens::from),
    };
    Ok(plain.with_lens(lens.map_err(|error| refuse(name, error))?))
}

pub(super) fn is_fisheye(storage: &Storage) -> Result<bool, YamlError> {
    if let Some(number) = storage.number("fisheye_model")? {
        return Ok(number != 0.0);
    }
    match storage.text("distortion_model")?.as_deref() {
        Some("equidistant" | "fisheye") => Ok(true),
        None | Some("plumb_bob" | "rational_polynomial" | "radtan") => Ok(false),
        Some(_) => Err(YamlError::Type {
            name: "distortion_model".to_owned(),
            line: storage.line("distortion_model"),
            expected: "equidistant, fisheye, plumb_bob, radtan or rational_polynomial",
        }),
    }
}

pub(super) fn size(storage: &Storage) -> Result<Option<[usize; 2]>, YamlError> {
    for names in [
        ["image_width", "image_height"],
        ["image_Width", "image_Height"],
    ] {
        let [width, height] = names.map(|name| Ok::<_, YamlError>((name, storage.number(name)?)));
        match (width?, height?) {
            ((_, None), (_, None)) => {}
            ((first, Some(width)), (second, Some(height))) => {
                let pixels = |name, value| pixels(name, storage.line(name), value);
                return Ok(Some([pixels(first, width)?, pixels(second, height)?]));
            }
            ((name, None), _) | (_, (name, None)) => {
                return Err(YamlError::Missing {
                    name,
                    also: String::new(),
                });
            }
        }
    }
    let names = ["image_size", "imageSize"];
    if first(storage, &names).is_none() {
        return Ok(None);
    }
    let (name, [width, height]) =
        shaped::<2>(storage, &names, &[[2, 1], [1, 2]], "width and height")?;
    let line = storage.line(name);
    Ok(Some([
        pixels(name, line, width)?,
        pixels(name, line, height)?,
    ]))
}

fn pixels(name: &str, line: usize, value: f64) -> Result<usize, YamlError> {
    if value >= 1.0 && value <= f64::from(u32::MAX) && value.fract() == 0.0 {
        Ok(value as usize)
    } else {
        Err(YamlError::Size {
            name: name.to_owned(),
            line,
            value,
        })
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
    let all = intrinsics.lens().coefficients();
    let count = match intrinsics.lens() {
        Lens::Pinhole => return,
        Lens::Fisheye(_) => 4,
        Lens::RadialTangential(_) => {
            let used = all.iter().rposition(|x| *x != 0.0).map_or(0, |k| k + 1);
            let counts = [5, 8, 12, 14];
            counts
                .into_iter()
                .find(|count| *count >= used)
                .unwrap_or(14)
        }
    };
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
