//! What a command warns of, in words and in JSON alike.

use serde::Serialize;

/// Something that a user should know about a result, and where it is.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub(crate) struct Warning {
    /// What it is, as one word for programs: `unclear_unit`.
    pub(crate) kind: &'static str,
    /// The sentence for people.
    pub(crate) message: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) file: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) joint: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) frame: Option<usize>,
}

impl Warning {
    pub(crate) fn new(kind: &'static str, message: String) -> Self {
        Self {
            kind,
            message,
            ..Self::default()
        }
    }

    pub(crate) fn in_file(self, file: &str) -> Self {
        Self {
            file: Some(file.to_owned()),
            ..self
        }
    }
}

/// Writes warnings to standard error, one a line.
pub(crate) fn print(warnings: &[Warning]) {
    for warning in warnings {
        match &warning.file {
            Some(file) => eprintln!("warning: {file}: {}", warning.message),
            None => eprintln!("warning: {}", warning.message),
        }
    }
}
