//! What is said of a PLY file that is read.

use std::fmt;

/// What a reader of PLY has decided where the file is not clear.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Warning {
    /// The colours of the vertices, or their opacities, are `float` or `double` and whole numbers
    /// up to 255. They are divided by 255.
    ByteColours,
}

impl Warning {
    /// What it is, as one word for programs.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        match self {
            Warning::ByteColours => "byte_colours",
        }
    }
}

impl From<&Warning> for crate::Warning {
    fn from(warning: &Warning) -> Self {
        Self {
            kind: warning.kind(),
            file: None,
            line: None,
            message: warning.to_string(),
        }
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Warning::ByteColours => f.write_str(
                "the colours of the vertices go beyond 1 and are whole numbers up to 255; they are \
                 divided by 255",
            ),
        }
    }
}
