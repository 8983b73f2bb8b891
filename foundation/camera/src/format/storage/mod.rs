//! Named numbers, texts and matrices, in the YAML, XML and JSON that OpenCV's `FileStorage` writes.
//!
//! Such YAML has a first line, `%YAML:1.0`, whose colon the standard does not know. Both spellings
//! are read. A matrix is a map with the keys `rows`, `cols`, `dt` and `data`, tagged
//! `!!opencv-matrix`, or with the key `sizes` in place of the first two; plain lists of numbers,
//! and of rows of numbers, are read as matrices too.
//!
//! ```
//! use ga_camera::format::storage::{Matrix, Storage};
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
mod json;
mod matrix;
mod number;
mod xml;
mod yaml;

pub use matrix::Matrix;

pub(super) use number::list;
pub(super) use yaml::in_quotes;

use std::collections::HashSet;

use entry::Entry;

use super::error::{CameraFileError, Place, wrong_type};
use super::node::{Content, Node};
use super::syntax;
use super::text::text;

/// Named values of a file, in its order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Storage {
    entries: Vec<(String, Entry)>,
    /// The names of the maps around it, each with a point behind it.
    prefix: String,
    /// The line on which it begins; 0 for that of a file.
    line: usize,
}

impl Storage {
    /// Reads the text of a file in YAML, JSON or XML. Several documents of YAML that share no name,
    /// as two files that were joined, are one.
    ///
    /// # Errors
    /// [`CameraFileError`] for what is not such a text, or not a map of names to values, with the
    /// line.
    pub fn decode(bytes: &[u8]) -> Result<Self, CameraFileError> {
        let text = text(bytes)?;
        if text.trim_start().starts_with('<') {
            return Ok(Self::of_entries(syntax::xml::Xml::parse(text)?.entries()?));
        }
        let mut documents = Self::documents(text)?.into_iter();
        match (documents.next(), documents.next()) {
            (Some(only), None) => Ok(only),
            (_, second) => Err(CameraFileError::Unsupported {
                line: second.map_or(1, |second| second.first_line()),
                problem: "a second document begins here",
            }),
        }
    }

    /// The documents of a text in YAML; those that share no name as one.
    pub(super) fn documents(text: &str) -> Result<Vec<Self>, CameraFileError> {
        let documents = syntax::yaml::documents(text)?;
        let mut names = HashSet::new();
        let all = documents.iter().flatten();
        let are_apart = all.map(|(name, _)| name).all(|name| names.insert(name));
        if are_apart {
            let joined = documents.into_iter().flatten().collect();
            return Ok(vec![Self::of_entries(joined)]);
        }
        Ok(documents.into_iter().map(Self::of_entries).collect())
    }

    pub(super) fn of_entries(entries: Vec<(String, Node)>) -> Self {
        let entries = entries.into_iter();
        Self {
            entries: entries
                .map(|(name, node)| (name, Entry::Read(node)))
                .collect(),
            prefix: String::new(),
            line: 0,
        }
    }

    /// The line on which the first value begins.
    pub(super) fn first_line(&self) -> usize {
        self.names().next().map_or(0, |name| self.line(name))
    }

    /// Where a value stands, or in which map it would.
    pub(super) fn place(&self, name: &str) -> Place {
        let line = match self.has(name) {
            true => self.line(name),
            false => self.line,
        };
        Place::on_line(line, self.full(name))
    }

    fn full(&self, name: &str) -> String {
        format!("{}{name}", self.prefix)
    }

    /// The maps of names to values in it, also those of lists, each with its name.
    pub(super) fn maps(&self) -> Vec<(String, Self)> {
        let mut found = Vec::new();
        for (name, entry) in &self.entries {
            let Entry::Read(node) = entry else { continue };
            match &node.content {
                Content::Map(entries) => {
                    found.push((name.clone(), self.inner(name, node.line, entries)));
                }
                Content::List(items) => {
                    for (index, item) in items.iter().enumerate() {
                        if let Content::Map(entries) = &item.content {
                            let name = format!("{name}[{index}]");
                            let inner = self.inner(&name, item.line, entries);
                            let own = inner.text("name").ok().flatten();
                            found.push((own.unwrap_or_else(|| index.to_string()), inner));
                        }
                    }
                }
                Content::Scalar(_) => {}
            }
        }
        found
    }

    fn inner(&self, name: &str, line: usize, entries: &[(String, Node)]) -> Self {
        Self {
            line,
            prefix: format!("{}{name}.", self.prefix),
            ..Self::of_entries(entries.to_vec())
        }
    }

    /// The numbers of a list, or a number by itself; `None` where the name is absent.
    pub(super) fn list(&self, name: &str) -> Result<Option<Vec<f64>>, CameraFileError> {
        let Some(Entry::Read(node)) = self.entry(name) else {
            return Ok(self.matrix(name)?.map(|matrix| matrix.values().to_vec()));
        };
        if let Content::Scalar(_) = node.content {
            return Ok(Some(vec![node.number(&self.full(name))?]));
        }
        Ok(self.matrix(name)?.map(|matrix| matrix.values().to_vec()))
    }

    /// Whether a value is true: `true`, `yes` or a number other than 0. A list or a map is neither.
    pub(super) fn truth(&self, name: &str) -> Result<Option<bool>, CameraFileError> {
        let Ok(Some(text)) = self.text(name) else {
            return Ok(None);
        };
        match text.to_ascii_lowercase().as_str() {
            "true" | "yes" | "on" => Ok(Some(true)),
            "false" | "no" | "off" => Ok(Some(false)),
            _ => self.number(name).map(|number| number.map(|x| x != 0.0)),
        }
    }

    pub(super) fn has(&self, name: &str) -> bool {
        self.entry(name).is_some()
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
            Some(Entry::Read(node)) => Matrix::from_node(&self.full(name), node).map(Some),
            Some(Entry::Number(_) | Entry::Text(_)) => {
                Err(wrong_type(&self.full(name), 0, "a matrix"))
            }
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
            Some(Entry::Read(node)) => node.number(&self.full(name)).map(Some),
            Some(Entry::Text(_) | Entry::Matrix(_)) => {
                Err(wrong_type(&self.full(name), 0, "a number"))
            }
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
            Some(_) => Err(wrong_type(&self.full(name), self.line(name), "a text")),
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

    /// The text of a file in YAML with these values, as OpenCV writes it. Numbers are written with
    /// 17 digits, so they come back exactly.
    #[must_use]
    pub fn encode(&self) -> String {
        yaml::encode(&self.entries)
    }

    /// The same in XML. A name that is none in XML is an error of its reader.
    #[must_use]
    pub fn encode_xml(&self) -> String {
        xml::encode(&self.entries)
    }

    /// The same in JSON.
    #[must_use]
    pub fn encode_json(&self) -> String {
        json::encode(&self.entries)
    }
}
