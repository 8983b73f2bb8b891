//! Documents that are written to another folder.

use std::path::Path;

use super::super::uri::{self, Uri};
use super::super::{Document, ImageSource};
use crate::FileError;
use crate::relocation::Way;

impl Document {
    /// The document of a file as it is to be written to another file: where that lies in another
    /// folder, the URIs of pictures are changed so that they lead to the same pictures.
    ///
    /// # Errors
    ///
    /// [`FileError::Picture`] for a picture on another drive.
    pub fn relocated(&self, from: &Path, to: &Path) -> Result<Self, FileError> {
        let mut document = self.clone();
        let Some(way) = Way::new(from, to) else {
            return Ok(document);
        };
        for image in &mut document.images {
            if let ImageSource::Uri(text) = &mut image.source
                && let Some(Uri::File(path)) = uri::parse(text)
            {
                let before = path.to_string_lossy().replace('\\', "/");
                let path = way.of(&before)?;
                if path != before {
                    *text = uri::of_path(&path);
                }
            }
        }
        Ok(document)
    }
}
