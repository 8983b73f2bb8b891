//! Matrices of numbers.

use crate::format::error::{CameraFileError, Place, wrong_type};
use crate::format::node::{Content, Node};

/// Numbers in rows and columns.
#[derive(Clone, Debug, PartialEq)]
pub struct Matrix {
    rows: usize,
    columns: usize,
    values: Vec<f64>,
}

impl Matrix {
    /// A matrix from its values by rows.
    ///
    /// # Errors
    /// [`CameraFileError::ValueCount`] for another number of values, [`CameraFileError::NotFinite`]
    /// for one that is not finite. The name in the error is empty, the line 0.
    pub fn new(rows: usize, columns: usize, values: Vec<f64>) -> Result<Self, CameraFileError> {
        Self::named("", 0, rows, columns, values)
    }

    fn named(
        name: &str,
        line: usize,
        rows: usize,
        columns: usize,
        values: Vec<f64>,
    ) -> Result<Self, CameraFileError> {
        if rows.checked_mul(columns) != Some(values.len()) {
            return Err(CameraFileError::ValueCount {
                place: Place::on_line(line, name),
                found: values.len(),
                rows,
                columns,
            });
        }
        if let Some(value) = values.iter().copied().find(|value| !value.is_finite()) {
            return Err(CameraFileError::NotFinite {
                place: Place::on_line(line, name),
                value,
            });
        }
        Ok(Self {
            rows,
            columns,
            values,
        })
    }

    /// The number of rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// The number of columns; of a matrix with channels, columns times channels.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// The values by rows.
    #[must_use]
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    pub(super) fn from_node(name: &str, node: &Node) -> Result<Self, CameraFileError> {
        match &node.content {
            Content::Scalar(_) => Err(wrong_type(name, node.line, "a matrix")),
            Content::List(items) => Self::from_list(name, node.line, items),
            Content::Map(entries) => Self::from_map(name, node.line, entries),
        }
    }

    /// A column of numbers, or a list of rows.
    fn from_list(name: &str, line: usize, items: &[Node]) -> Result<Self, CameraFileError> {
        let mut values = Vec::new();
        let mut columns = None;
        for item in items {
            let (numbers, width) = match &item.content {
                Content::List(row) => (row.as_slice(), row.len()),
                _ => (std::slice::from_ref(item), 1),
            };
            if columns.is_some_and(|columns| columns != width) {
                return Err(wrong_type(name, item.line, "a list of rows of one length"));
            }
            columns = Some(width);
            for number in numbers {
                values.push(number.number(name)?);
            }
        }
        Self::named(name, line, items.len(), columns.unwrap_or(0), values)
    }

    fn from_map(
        name: &str,
        line: usize,
        entries: &[(String, Node)],
    ) -> Result<Self, CameraFileError> {
        let entry = |key: &str| entries.iter().find(|(other, _)| other == key);
        let size = |key: &str| -> Result<usize, CameraFileError> {
            let Some((_, node)) = entry(key) else {
                return Err(wrong_type(name, line, "a matrix with rows, cols and data"));
            };
            let number = node.number(name)?;
            if number >= 0.0 && number <= f64::from(u32::MAX) && number.fract() == 0.0 {
                Ok(number as usize)
            } else {
                Err(wrong_type(
                    name,
                    node.line,
                    "a matrix with whole rows and cols",
                ))
            }
        };
        let (rows, columns) = match entry("sizes") {
            Some((_, sizes)) => {
                let sizes = Self::from_node(name, sizes)?;
                // One dimension is a column; of more than two, the last ones are in one row.
                let (rows, others) = sizes.values().split_first().unwrap_or((&0.0, &[]));
                (*rows as usize, others.iter().product::<f64>() as usize)
            }
            None => (size("rows")?, size("cols")?),
        };
        let channels = match entry("dt") {
            None => 1,
            Some((_, node)) => channels(node)
                .ok_or_else(|| wrong_type(name, node.line, "a matrix of numbers: see its dt"))?,
        };
        let Some((_, data)) = entry("data") else {
            return Err(wrong_type(name, line, "a matrix with rows, cols and data"));
        };
        let items = match &data.content {
            Content::List(items) => items.as_slice(),
            // One number, as XML has it.
            Content::Scalar(_) => std::slice::from_ref(data),
            Content::Map(_) => {
                return Err(wrong_type(name, data.line, "a matrix with a list of data"));
            }
        };
        let values: Result<Vec<f64>, CameraFileError> =
            items.iter().map(|item| item.number(name)).collect();
        let width = columns.saturating_mul(channels);
        Self::named(name, line, rows, width, values?)
    }
}

/// The number of channels of an element type, such as 1 for `d` and 2 for `2f`.
fn channels(node: &Node) -> Option<usize> {
    let Content::Scalar(text) = &node.content else {
        return None;
    };
    let kind = text.trim_start_matches(|c: char| c.is_ascii_digit());
    let count = &text[..text.len() - kind.len()];
    let is_known = matches!(kind, "u" | "c" | "w" | "s" | "i" | "f" | "d" | "h");
    match (is_known, count) {
        (false, _) => None,
        (true, "") => Some(1),
        (true, digits) => digits.parse().ok(),
    }
}
