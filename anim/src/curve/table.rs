//! Tables of keys as CSV.

use csv::{ReaderBuilder, StringRecord, Trim, Writer};

use super::resample::Resampled;

/// Keys: their times, and the values of each channel.
///
/// A row has a time and a column for each channel. A first line without any number names them.
///
/// ```
/// use ga_anim::curve::table::KeyTable;
///
/// let table = KeyTable::parse(b"t,height\n0,1\n0.5,3\n")?;
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
    pub lines: Vec<u64>,
}

/// What is wrong with a table.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum KeyTableError {
    /// The text is not CSV.
    #[error("{0}")]
    Csv(#[from] csv::Error),
    /// There is no key.
    #[error("there are no keys")]
    Empty,
    /// There are fewer than two columns.
    #[error("line {line}: a column of times and at least one channel are needed")]
    NoChannel {
        /// The line in the file, from 1.
        line: u64,
    },
    /// A line has another number of columns.
    #[error("line {line}: {found} columns, but line {first} has {expected}")]
    Columns {
        /// The line in the file, from 1.
        line: u64,
        /// What was found.
        found: usize,
        /// The line that it is compared with.
        first: u64,
        /// What is expected.
        expected: usize,
    },
    /// A field is not a finite number.
    #[error("line {line}, column {column} ({name}): {text:?} is not a finite number")]
    Number {
        /// The line in the file, from 1.
        line: u64,
        /// The column, from 1.
        column: usize,
        /// The name.
        name: String,
        /// The text of the field.
        text: String,
    },
}

impl KeyTable {
    /// Reads a table.
    ///
    /// # Errors
    /// What is wrong with the table, with the line.
    pub fn parse(bytes: &[u8]) -> Result<Self, KeyTableError> {
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        let mut reader = ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .trim(Trim::All)
            .from_reader(bytes);
        let mut records = reader.records().peekable();
        let line = |record: &StringRecord| record.position().map_or(1, csv::Position::line);
        let Some(Ok(first)) = records.peek().filter(|first| first.is_ok()) else {
            return Err(records
                .next()
                .and_then(Result::err)
                .map_or(KeyTableError::Empty, Into::into));
        };
        let (width, first_line) = (first.len(), line(first));
        if width < 2 {
            return Err(KeyTableError::NoChannel { line: first_line });
        }
        // A first line without any number is a line of names.
        let has_header = first.iter().all(|field| field.parse::<f64>().is_err());
        let names: Vec<String> = match has_header {
            true => first.iter().map(str::to_string).collect(),
            false => std::iter::once("t".to_string())
                .chain((1..width).map(|channel| format!("channel {channel}")))
                .collect(),
        };
        let mut table = Self {
            names,
            has_header,
            times: Vec::new(),
            channels: vec![Vec::new(); width - 1],
            lines: Vec::new(),
        };
        for record in records.skip(usize::from(has_header)) {
            let record = record?;
            let line = line(&record);
            if record.len() != width {
                let found = record.len();
                return Err(KeyTableError::Columns {
                    line,
                    found,
                    first: first_line,
                    expected: width,
                });
            }
            for (column, field) in record.iter().enumerate() {
                let Some(number) = field.parse::<f64>().ok().filter(|x| x.is_finite()) else {
                    let (name, text) = (table.names[column].clone(), field.to_string());
                    return Err(KeyTableError::Number {
                        line,
                        column: column + 1,
                        name,
                        text,
                    });
                };
                match column.checked_sub(1) {
                    None => table.times.push(number),
                    Some(channel) => table.channels[channel].push(number),
                }
            }
            table.lines.push(line);
        }
        if table.times.is_empty() {
            Err(KeyTableError::Empty)
        } else {
            Ok(table)
        }
    }

    /// How a message names a column, by its index.
    pub fn column(&self, column: usize) -> String {
        format!("column {} ({})", column + 1, self.names[column])
    }

    /// Rows under the names of this table, as CSV. Each number reads back exactly.
    ///
    /// # Errors
    /// A name cannot be written as CSV.
    pub fn with_rows(&self, rows: &Resampled<Vec<f64>>) -> Result<Vec<u8>, csv::Error> {
        let mut writer = Writer::from_writer(Vec::new());
        if self.has_header {
            writer.write_record(&self.names)?;
        }
        for (time, values) in rows.times.iter().zip(&rows.values) {
            let numbers = std::iter::once(time).chain(values);
            writer.write_record(numbers.map(|number| format!("{number:?}")))?;
        }
        writer
            .into_inner()
            .map_err(|error| error.into_error().into())
    }
}
