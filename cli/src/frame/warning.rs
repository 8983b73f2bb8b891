//! What a command warns of, in words and in JSON alike.

use std::path::Path;
use std::sync::Mutex;

use ga_mesh::Omission;
use serde::Serialize;

use crate::output;

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
    pub(crate) line: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) view: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) joint: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) frame: Option<usize>,
    /// Whether it was put right or needs nothing to be done.
    #[serde(skip)]
    pub(crate) is_note: bool,
    /// What is left out, and how many of it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) what: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) count: Option<usize>,
}

impl Warning {
    pub(crate) fn new(kind: &'static str, message: impl ToString) -> Self {
        Self {
            kind,
            message: message.to_string(),
            ..Self::default()
        }
    }

    /// The same as something that needs nothing to be done.
    pub(crate) fn into_note(self) -> Self {
        Self {
            is_note: true,
            ..self
        }
    }

    /// A warning of what a format cannot hold.
    pub(crate) fn of_omission(omission: &Omission, format: &str) -> Self {
        let message = format!("{omission}, since {format} has none");
        Self {
            what: Some(omission.what),
            count: Some(omission.count),
            ..Self::new("omission", message)
        }
    }

    pub(crate) fn in_file(self, file: &Path) -> Self {
        Self {
            file: Some(file.display().to_string()),
            ..self
        }
    }
}

/// What is known of the inputs of a command that has not ended.
static OF_INPUTS: Mutex<Vec<Warning>> = Mutex::new(Vec::new());

/// Keeps what is said of an input, which may be the reason why the command fails.
pub(crate) fn keep_for_failure(warnings: &[Warning]) {
    if let Ok(mut kept) = OF_INPUTS.lock() {
        kept.extend_from_slice(warnings);
    }
}

/// What is said of files in the report of any command.
static OF_FILES: Mutex<Vec<Warning>> = Mutex::new(Vec::new());

/// Adds a warning to those of the report.
pub(crate) fn warn(warning: Warning) {
    if let Ok(mut kept) = OF_FILES.lock() {
        kept.push(warning);
    }
}

/// Begins anew for a command after another.
pub(super) fn forget() {
    for all in [&OF_INPUTS, &OF_FILES] {
        if let Ok(mut kept) = all.lock() {
            kept.clear();
        }
    }
}

/// What is said of files.
pub(super) fn of_files() -> Vec<Warning> {
    let kept = OF_FILES.lock();
    kept.map_or_else(|_| Vec::new(), |kept| kept.clone())
}

/// Writes what is said of inputs and of files to standard error: that of a command that failed.
pub(super) fn print_of_failure() {
    if let Ok(kept) = OF_INPUTS.lock() {
        print(&kept);
    }
    print(&of_files());
}

/// Writes warnings to standard error, one a line.
pub(crate) fn print(warnings: &[Warning]) {
    for warning in warnings {
        let word = if warning.is_note { "note" } else { "warning" };
        output::print_error(&format!("{word}: {}\n", warning.line_of_text()));
    }
}

impl Warning {
    /// The sentence, after the file that it is about.
    pub(crate) fn line_of_text(&self) -> String {
        match &self.file {
            Some(file) => format!("{file}: {}", self.message),
            None => self.message.clone(),
        }
    }
}
