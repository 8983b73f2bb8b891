//! What is said of a part that was written.

use std::path::Path;

use serde::Serialize;

use super::About;

#[derive(Clone, Debug, Serialize)]
pub(crate) struct PartWritten {
    out: String,
    frames: usize,
    first_frame: usize,
    last_frame: usize,
}

impl PartWritten {
    pub(crate) fn new(path: &Path, about: &About) -> Self {
        let [first, end] = about.frames;
        Self {
            out: path.display().to_string(),
            frames: end - first,
            first_frame: first,
            last_frame: end - 1,
        }
    }

    pub(crate) fn text(&self) -> String {
        format!(
            "wrote {}, frames {} to {}\n",
            self.out, self.first_frame, self.last_frame
        )
    }
}
