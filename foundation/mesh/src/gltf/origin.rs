//! The file that a document was read from.

use std::fmt;
use std::path::PathBuf;
use std::sync::Arc;

use serde_json::{Map, Value};

use super::json;

/// The file that a document was read from, for a writer: what has not been changed since is
/// written as it stands there, with its types of numbers and with all that a
/// [`Document`](super::Document) has no place for, such as extensions that this crate does not
/// know. Of an element that was changed, those extensions are kept.
///
/// Elements are compared by their places in the lists of the document, so that new ones belong at
/// the ends; animations may stand anywhere. A document that is made, not read, has the default,
/// which is not a file. All origins are equal, since they say where a document comes from and not
/// what it is.
///
/// # Examples
///
/// ```
/// use ga_mesh::gltf;
///
/// let file = br#"{"asset": {"version": "2.0"}, "extensionsUsed": ["KHR_lights_punctual"],
///     "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point"}]}},
///     "nodes": [{"extensions": {"KHR_lights_punctual": {"light": 0}}}]}"#;
/// let mut document = gltf::decode(file)?;
/// document.nodes[0].name = Some("lamp".to_owned());
/// let text = String::from_utf8(gltf::encode_files(&document, "lamp")?.json)?;
/// assert!(text.contains(r#""KHR_lights_punctual":{"light":0}"#));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Default)]
pub struct Origin(Option<Arc<File>>);

/// A file as it was read.
pub(super) struct File {
    /// Its JSON, as far as a document needs it.
    pub(super) root: json::Root,
    /// All of its JSON, but for the URIs of buffers.
    pub(super) json: Map<String, Value>,
    /// The bytes of every buffer; none where compressed ones stand for them.
    pub(super) buffers: Vec<Option<Vec<u8>>>,
    /// The bytes of the file without its buffers.
    pub(super) size: usize,
    /// The files of buffers, relative to the folder of this one.
    pub(super) parts: Vec<PathBuf>,
}

impl Origin {
    pub(super) fn new(file: File) -> Self {
        Self(Some(Arc::new(file)))
    }

    /// The files of the buffers, relative to the folder of the file.
    #[must_use]
    pub fn buffer_files(&self) -> &[PathBuf] {
        self.file().map_or(&[], |file| &file.parts)
    }

    pub(super) fn file(&self) -> Option<&File> {
        self.0.as_deref()
    }
}

impl File {
    /// An element of one of the lists.
    pub(super) fn element(&self, list: &str, index: usize) -> Option<&Value> {
        self.json.get(list)?.get(index)
    }
}

impl PartialEq for Origin {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl fmt::Debug for Origin {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(match self.0 {
            Some(_) => "Origin(a file)",
            None => "Origin(no file)",
        })
    }
}
