//! What is wrong with a YAML file of cameras.

use crate::CameraError;

/// What is wrong with a YAML file of cameras, and on which line, counted from 1.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum YamlError {
    /// The bytes are not text.
    #[error("line {line}: not text in UTF-8")]
    NotText {
        /// The line with the first byte that is not UTF-8.
        line: usize,
    },
    /// The text is XML.
    #[error("line 1: this is XML; only YAML is read")]
    Xml,
    /// The text is not YAML.
    #[error("line {line}: not YAML: {problem}")]
    Syntax {
        /// The line.
        line: usize,
        /// What the parser says.
        problem: String,
    },
    /// What is valid YAML has no place in such a file.
    #[error("line {line}: {problem}")]
    Unsupported {
        /// The line.
        line: usize,
        /// What it is.
        problem: &'static str,
    },
    /// A name is given twice.
    #[error("line {line}: `{name}` is given a second time")]
    Duplicate {
        /// The line of the second value.
        line: usize,
        /// The name.
        name: String,
    },
    /// A value is missing.
    #[error("there is no `{name}`{also}")]
    Missing {
        /// The first name under which it was looked for.
        name: &'static str,
        /// Other names under which it was looked for, as part of the message.
        also: String,
    },
    /// A value has another type.
    #[error("line {line}: `{name}` is not {expected}")]
    Type {
        /// The name.
        name: String,
        /// The line of the value.
        line: usize,
        /// What it must be.
        expected: &'static str,
    },
    /// A number is infinite or not a number.
    #[error("line {line}: `{name}` has the value {value}, which is not finite")]
    NotFinite {
        /// The name.
        name: String,
        /// The line of the number.
        line: usize,
        /// The number.
        value: f64,
    },
    /// A matrix has another number of values than its rows and columns say.
    #[error("line {line}: `{name}` has {found} values, not {rows} × {columns}")]
    ValueCount {
        /// The name.
        name: String,
        /// The line of the matrix.
        line: usize,
        /// How many values there are.
        found: usize,
        /// The number of rows.
        rows: usize,
        /// The number of columns, times that of channels.
        columns: usize,
    },
    /// A matrix does not have the shape that its meaning demands.
    #[error("line {line}: `{name}` has {rows} × {columns} values, not {expected}")]
    Shape {
        /// The name.
        name: String,
        /// The line of the matrix.
        line: usize,
        /// The number of rows.
        rows: usize,
        /// The number of columns.
        columns: usize,
        /// What is expected.
        expected: &'static str,
    },
    /// The numbers do not form a camera.
    #[error("line {line}: `{name}`: {error}")]
    Camera {
        /// The name of the matrix.
        name: String,
        /// The line of the matrix.
        line: usize,
        /// What is wrong.
        error: Box<CameraError>,
    },
    /// A matrix is not a rotation.
    #[error(
        "line {line}: `{name}` is not a rotation: it differs from the nearest by {deviation:e}"
    )]
    Rotation {
        /// The name of the matrix.
        name: String,
        /// The line of the matrix.
        line: usize,
        /// The largest difference of an entry from the nearest rotation.
        deviation: f64,
    },
    /// The two cameras of a rig are at the same place.
    #[error("line {line}: `{name}` is zero, so the cameras are at the same place")]
    ZeroBaseline {
        /// The name of the translation.
        name: String,
        /// The line of the translation.
        line: usize,
    },
    /// A number of pixels is not a positive integer.
    #[error("line {line}: `{name}` is {value}, not a number of pixels")]
    Size {
        /// The name.
        name: String,
        /// The line.
        line: usize,
        /// The number.
        value: f64,
    },
    /// One camera of a rig is a fisheye and the other is not: the format has one mark for both.
    #[error("a file cannot hold a fisheye and another lens in one rig")]
    MixedLenses,
}

pub(super) fn wrong_type(name: &str, line: usize, expected: &'static str) -> YamlError {
    YamlError::Type {
        name: name.to_owned(),
        line,
        expected,
    }
}
