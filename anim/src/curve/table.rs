//! Tables of keys, as [`ga_files::table`] reads and writes them.

use ga_files::table::{Cell, Separator, Table, TableError, row};

use super::resample::Resampled;

/// Keys: their times, and the values of each channel.
///
/// A row has a time and a column for each channel. A first line without any number names them.
///
/// ```
/// use ga_anim::curve::table::KeyTable;
///
/// let table = KeyTable::decode(b"t,height\n0,1\n0.5,3\n")?;
/// assert_eq!(table.names, ["t", "height"]);
/// assert_eq!(table.channels, [[1.0, 3.0]]);
/// # Ok::<_, ga_anim::curve::table::KeyTableError>(())
/// ```
#[derive(Clone, Debug)]
pub struct KeyTable {
    /// The names of all columns, the first of which is that of the times.
    pub names: Vec<String>,
    /// Whether the names stand in the file.
    has_header: bool,
    /// At least one.
    pub times: Vec<f64>,
    /// The values of each channel at the times.
    pub channels: Vec<Vec<f64>>,
    /// The line of each key in the file, from 1.
    pub lines: Vec<usize>,
}

/// What is wrong with a table.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum KeyTableError {
    /// The text is not a table.
    #[error(transparent)]
    Table(#[from] TableError),
    /// There is no key.
    #[error("there are no keys")]
    Empty,
    /// There are fewer than two columns.
    #[error("line {line}: a column of times and at least one channel are needed")]
    NoChannel {
        /// The line in the file, from 1.
        line: usize,
    },
}

impl KeyTable {
    /// Reads a table.
    ///
    /// # Errors
    /// What is wrong with the table, with the line.
    pub fn decode(bytes: &[u8]) -> Result<Self, KeyTableError> {
        let table = Table::rectangular(bytes)?;
        let has_header = !table.names().is_empty();
        let (first, width) = table.first_line();
        match (width, table.len()) {
            (2.., 1..) => {}
            (0, _) | (2.., 0) => return Err(KeyTableError::Empty),
            _ => return Err(KeyTableError::NoChannel { line: first }),
        }
        let channels = (1..width).map(|channel| format!("channel {channel}"));
        let mut keys = Self {
            names: match has_header {
                true => table.names().to_vec(),
                false => std::iter::once("t".to_owned()).chain(channels).collect(),
            },
            has_header,
            times: Vec::new(),
            channels: vec![Vec::new(); width - 1],
            lines: Vec::new(),
        };
        for row in 0..table.len() {
            for column in 0..width {
                let Ok(Some(number)) = table.number(row, column) else {
                    return Err(KeyTableError::Table(TableError::Number {
                        line: table.line(row),
                        column: format!("{} ({})", column + 1, keys.names[column]),
                        text: table.text(row, column).to_owned(),
                    }));
                };
                match column.checked_sub(1) {
                    None => keys.times.push(number),
                    Some(channel) => keys.channels[channel].push(number),
                }
            }
            keys.lines.push(table.line(row));
        }
        Ok(keys)
    }

    /// How a message names a column, by its index.
    pub fn column(&self, column: usize) -> String {
        format!("column {} ({})", column + 1, self.names[column])
    }

    /// Rows under the names of this table, as CSV. Each number reads back exactly.
    pub fn with_rows(&self, rows: &Resampled<Vec<f64>>) -> String {
        let mut text = String::new();
        if self.has_header {
            let names = self.names.iter().cloned().map(Cell::Text);
            text += &row(names, Separator::Comma);
        }
        for (time, values) in rows.times.iter().zip(&rows.values) {
            let numbers = std::iter::once(time).chain(values);
            text += &row(numbers.copied().map(Cell::exact), Separator::Comma);
        }
        text
    }
}
