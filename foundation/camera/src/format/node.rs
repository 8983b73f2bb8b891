//! The values of a file with their lines, whatever its syntax.

use super::error::{CameraFileError, Place, finite, wrong_type};

/// How deeply lists and maps may be nested: files of cameras have four levels.
pub(super) const DEPTH: usize = 16;

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Node {
    /// From 1.
    pub(super) line: usize,
    pub(super) content: Content,
}

#[derive(Clone, Debug, PartialEq)]
pub(super) enum Content {
    Scalar(String),
    List(Vec<Node>),
    Map(Vec<(String, Node)>),
}

impl Node {
    /// The finite number that a value is.
    pub(super) fn number(&self, name: &str) -> Result<f64, CameraFileError> {
        let Content::Scalar(text) = &self.content else {
            return Err(wrong_type(name, self.line, "a number"));
        };
        let number = match text.to_ascii_lowercase().as_str() {
            ".nan" => f64::NAN,
            ".inf" | "+.inf" => f64::INFINITY,
            "-.inf" => f64::NEG_INFINITY,
            other => other
                .parse()
                .map_err(|_| wrong_type(name, self.line, "a number"))?,
        };
        finite(|| Place::on_line(self.line, name), number)
    }
}

pub(super) fn too_deep(line: usize) -> CameraFileError {
    CameraFileError::Unsupported {
        line,
        problem: "lists and maps are nested too deeply",
    }
}
