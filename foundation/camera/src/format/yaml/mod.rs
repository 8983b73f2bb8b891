//! Named numbers, texts and matrices, in the YAML that OpenCV's `FileStorage` writes.
//!
//! Such a file is YAML but for its first line, `%YAML:1.0`, whose colon the standard does not know.
//! Both spellings are read. A matrix is a map with the keys `rows`, `cols`, `dt` and `data`, tagged
//! `!!opencv-matrix`; plain lists of numbers, and of rows of numbers, are read as matrices too.
//!
//! ```
//! use ga_camera::format::yaml::{Matrix, Storage};
//!
//! let text = "%YAML:1.0
//! M1: !!opencv-matrix
//!    rows: 1
//!    cols: 2
//!    dt: d
//!    data: [ 1., 2.5 ]
//! ";
//! let storage = Storage::decode(text.as_bytes())?;
//! let found = storage.matrix("M1")?.unwrap();
//! assert_eq!((found.rows(), found.values()), (1, &[1.0, 2.5][..]));
//!
//! let mut written = Storage::default();
//! written.set_matrix("M1", Matrix::new(1, 2, vec![1.0, 2.5])?);
//! assert_eq!(Storage::decode(written.encode().as_bytes())?.matrix("M1")?, Some(found));
//! # Ok::<(), ga_camera::format::CameraFileError>(())
//! ```

mod entry;
mod matrix;
mod tree;
mod write;

pub use matrix::Matrix;

use entry::Entry;
use tree::{Content, Node};

use super::error::{CameraFileError, wrong_type};

/// Named values of a file, in its order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Storage {
    entries: Vec<(String, Entry)>,
}

impl Storage {
    /// Reads the text of a file.
    ///
    /// # Errors
    /// [`CameraFileError`] for what is not YAML, or not a map of names to values, with the line.
    pub fn decode(bytes: &[u8]) -> Result<Self, CameraFileError> {
        let entries = tree::entries(bytes)?.into_iter();
        Ok(Self {
            entries: entries
                .map(|(name, node)| (name, Entry::Read(node)))
                .collect(),
        })
    }

    /// The names, in the order of the file.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.entries.iter().map(|(name, _)| name.as_str())
    }

    /// The line on which a value begins, from 1; 0 for one that was not read from a file.
    #[must_use]
    pub fn line(&self, name: &str) -> usize {
        match self.entry(name) {
            Some(Entry::Read(node)) => node.line,
            _ => 0,
        }
    }

    fn entry(&self, name: &str) -> Option<&Entry> {
        let mut entries = self.entries.iter();
        let found = entries.find(|(other, _)| other == name)?;
        Some(&found.1)
    }

    /// The matrix of a name; `None` where the name is absent. All its numbers are finite.
    ///
    /// # Errors
    /// [`CameraFileError`] where the value is not a matrix, has another number of values than rows
    /// and columns say, or a number that is not finite.
    pub fn matrix(&self, name: &str) -> Result<Option<Matrix>, CameraFileError> {
        match self.entry(name) {
            None => Ok(None),
            Some(Entry::Matrix(matrix)) => Ok(Some(matrix.clone())),
            Some(Entry::Read(node)) => Matrix::from_node(name, node).map(Some),
            Some(Entry::Number(_) | Entry::Text(_)) => Err(wrong_type(name, 0, "a matrix")),
        }
    }

    /// The number of a name, finite; `None` where the name is absent.
    ///
    /// # Errors
    /// [`CameraFileError`] where the value is not a finite number.
    pub fn number(&self, name: &str) -> Result<Option<f64>, CameraFileError> {
        match self.entry(name) {
            None => Ok(None),
            Some(Entry::Number(number)) => Ok(Some(*number)),
            Some(Entry::Read(node)) => node.number(name).map(Some),
            Some(Entry::Text(_) | Entry::Matrix(_)) => Err(wrong_type(name, 0, "a number")),
        }
    }

    /// The text of a name; `None` where the name is absent.
    ///
    /// # Errors
    /// [`CameraFileError`] where the value is a list or a map.
    pub fn text(&self, name: &str) -> Result<Option<String>, CameraFileError> {
        match self.entry(name) {
            None => Ok(None),
            Some(Entry::Text(text)) => Ok(Some(text.clone())),
            Some(Entry::Read(Node {
                content: Content::Scalar(text),
                ..
            })) => Ok(Some(text.clone())),
            Some(_) => Err(wrong_type(name, self.line(name), "a text")),
        }
    }

    /// Adds or replaces a matrix.
    pub fn set_matrix(&mut self, name: &str, matrix: Matrix) {
        self.set(name, Entry::Matrix(matrix));
    }

    /// Adds or replaces a number.
    pub fn set_number(&mut self, name: &str, number: f64) {
        self.set(name, Entry::Number(number));
    }

    /// Adds or replaces a text.
    pub fn set_text(&mut self, name: &str, text: &str) {
        self.set(name, Entry::Text(text.to_owned()));
    }

    fn set(&mut self, name: &str, entry: Entry) {
        match self.entries.iter_mut().find(|(other, _)| other == name) {
            Some((_, old)) => *old = entry,
            None => self.entries.push((name.to_owned(), entry)),
        }
    }

    /// The text of a file with these values, as OpenCV writes it. Numbers are written with 17
    /// digits, so they come back exactly.
    #[must_use]
    pub fn encode(&self) -> String {
        write::encode(&self.entries)
    }
}
