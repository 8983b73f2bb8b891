//! The `calib.txt` of the Middlebury and ETH3D stereo data: a rectified pair.
//!
//! ```text
//! cam0=[711.499 0 376.135; 0 711.499 227.447; 0 0 1]
//! cam1=[711.499 0 376.135; 0 711.499 227.447; 0 0 1]
//! doffs=0
//! baseline=59.9432
//! width=713
//! height=434
//! ndisp=713
//! ```
//!
//! `doffs` is the difference of the principal points in pixels, right minus left, the baseline is
//! in millimetres, and disparities are below `ndisp`. Other keys are ignored.

use std::collections::HashSet;
use std::path::Path;
use std::str::FromStr;

use ga_files::ReadError;

use crate::rig::{RectifiedRig, RectifiedRigError};
use crate::{CameraError, Intrinsics};

/// The contents of a `calib.txt`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Calib {
    /// The cameras, in metres.
    pub rig: RectifiedRig,
    /// Width and height of the pictures in pixels.
    pub size: Option<[usize; 2]>,
    /// An upper bound of the disparities in pixels.
    pub disparities: Option<usize>,
}

/// What is wrong with a `calib.txt`, and on which line, counted from 1.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CalibError {
    /// The bytes are not text.
    #[error("not text in UTF-8")]
    NotText,
    /// A line is not of the form `key=value`.
    #[error("line {line}: not of the form key=value")]
    Line {
        /// The line.
        line: usize,
    },
    /// A key is given twice.
    #[error("line {line}: {key} is given a second time")]
    Duplicate {
        /// The line of the second value.
        line: usize,
        /// The key.
        key: String,
    },
    /// A key is missing.
    #[error("there is no {key}")]
    Missing {
        /// The key.
        key: &'static str,
    },
    /// A value is not what it must be.
    #[error("line {line}: {key} is not {expected}")]
    Value {
        /// The line.
        line: usize,
        /// The key.
        key: &'static str,
        /// What it must be.
        expected: &'static str,
    },
    /// A matrix does not form a camera.
    #[error("line {line}: {key}: {error}")]
    Camera {
        /// The line.
        line: usize,
        /// The key.
        key: &'static str,
        /// What is wrong.
        error: Box<CameraError>,
    },
    /// The cameras and the baseline are not a rectified rig.
    #[error("line {line}: {error}")]
    Rig {
        /// The line of the right camera, or of the baseline.
        line: usize,
        /// What is wrong.
        error: RectifiedRigError,
    },
    /// The difference of the principal points is not `doffs`.
    #[error("line {line}: doffs is {found}, and the principal points differ by {expected}")]
    Offset {
        /// The line.
        line: usize,
        /// The value.
        found: f64,
        /// The difference.
        expected: f64,
    },
}

impl Calib {
    /// Reads the text of a file.
    ///
    /// # Errors
    /// [`CalibError`] for what is not such a file.
    pub fn decode(bytes: &[u8]) -> Result<Self, CalibError> {
        let entries = Entries::new(bytes)?;
        let left = entries.camera("cam0")?;
        let right = entries.camera("cam1")?;
        let (baseline_line, millimetres) = entries.required::<f64>("baseline", "a number")?;
        let rig = RectifiedRig::new(left, right, millimetres * 1e-3).map_err(|error| {
            let line = match error {
                RectifiedRigError::Baseline(_) => baseline_line,
                _ => entries.find("cam1").map_or(0, |(line, _)| line),
            };
            CalibError::Rig { line, error }
        })?;
        if let Some((line, found)) = entries.optional::<f64>("doffs", "a number")? {
            let expected = rig.disparity_offset();
            // Principal points are written with three digits after the point.
            if (found - expected).abs() > 2e-3 || found.is_nan() {
                return Err(CalibError::Offset {
                    line,
                    found,
                    expected,
                });
            }
        }
        let whole = |key| entries.optional::<usize>(key, "a whole number");
        let size = match (whole("width")?, whole("height")?) {
            (Some((_, width)), Some((_, height))) => Some([width, height]),
            _ => None,
        };
        Ok(Self {
            rig,
            size,
            disparities: whole("ndisp")?.map(|(_, count)| count),
        })
    }

    /// Reads a file.
    ///
    /// # Errors
    /// [`ReadError`] with the file and an error of [`decode`](Self::decode).
    pub fn read(path: impl AsRef<Path>) -> Result<Self, ReadError<CalibError>> {
        ga_files::read(path, Self::decode)
    }
}

/// Keys and values with their lines.
struct Entries<'a>(Vec<(&'a str, usize, &'a str)>);

impl<'a> Entries<'a> {
    fn new(bytes: &'a [u8]) -> Result<Self, CalibError> {
        let text = std::str::from_utf8(bytes).map_err(|_| CalibError::NotText)?;
        let mut found: Vec<(&str, usize, &str)> = Vec::new();
        let mut keys = HashSet::new();
        for (index, text) in text.lines().enumerate() {
            let line = index + 1;
            if text.trim().is_empty() {
                continue;
            }
            let (key, value) = text.split_once('=').ok_or(CalibError::Line { line })?;
            let (key, value) = (key.trim(), value.trim());
            if !keys.insert(key) {
                return Err(CalibError::Duplicate {
                    line,
                    key: key.to_owned(),
                });
            }
            found.push((key, line, value));
        }
        Ok(Self(found))
    }

    fn find(&self, key: &str) -> Option<(usize, &'a str)> {
        let mut entries = self.0.iter();
        let (_, line, value) = entries.find(|(other, ..)| *other == key)?;
        Some((*line, value))
    }

    fn optional<T: FromStr>(
        &self,
        key: &'static str,
        expected: &'static str,
    ) -> Result<Option<(usize, T)>, CalibError> {
        let Some((line, value)) = self.find(key) else {
            return Ok(None);
        };
        let parsed = value.parse().map_err(|_| CalibError::Value {
            line,
            key,
            expected,
        })?;
        Ok(Some((line, parsed)))
    }

    fn required<T: FromStr>(
        &self,
        key: &'static str,
        expected: &'static str,
    ) -> Result<(usize, T), CalibError> {
        self.optional(key, expected)?
            .ok_or(CalibError::Missing { key })
    }

    /// A matrix `[a b c; d e f; g h i]` that forms a camera.
    fn camera(&self, key: &'static str) -> Result<Intrinsics, CalibError> {
        let (line, text) = self.find(key).ok_or(CalibError::Missing { key })?;
        let refuse = CalibError::Value {
            line,
            key,
            expected: "a matrix [a b c; d e f; g h i]",
        };
        let rows = matrix(text).ok_or(refuse)?;
        Intrinsics::from_matrix(rows).map_err(|error| CalibError::Camera {
            line,
            key,
            error: error.into(),
        })
    }
}

fn matrix(text: &str) -> Option<[[f64; 3]; 3]> {
    let inside = text.strip_prefix('[')?.strip_suffix(']')?;
    let mut rows = inside.split(';').map(|row| {
        let mut numbers = row.split_whitespace().map(|word| word.parse::<f64>().ok());
        let row = [numbers.next()??, numbers.next()??, numbers.next()??];
        numbers.next().is_none().then_some(row)
    });
    let matrix = [rows.next()??, rows.next()??, rows.next()??];
    rows.next().is_none().then_some(matrix)
}
