//! Tables of keys as CSV.

use anyhow::Result;
use csv::{ReaderBuilder, StringRecord, Trim, Writer};
use ga_anim::curve::Resampled;

/// Keys: their times, and the values of each channel.
pub(super) struct Table {
    /// The names of all columns, the first of which is that of the times.
    pub(super) names: Vec<String>,
    /// Whether the names stand in the file.
    has_header: bool,
    pub(super) times: Vec<f64>,
    pub(super) channels: Vec<Vec<f64>>,
    /// The line of each key in the file, from 1.
    pub(super) lines: Vec<u64>,
}

/// What is wrong with a table.
#[derive(Debug, thiserror::Error)]
pub(super) enum TableError {
    #[error("{0}")]
    Csv(#[from] csv::Error),
    #[error("there are no keys")]
    Empty,
    #[error("line {line}: a column of times and at least one channel are needed")]
    NoChannel { line: u64 },
    #[error("line {line}: {found} columns, but line {first} has {expected}")]
    Columns {
        line: u64,
        found: usize,
        first: u64,
        expected: usize,
    },
    #[error("line {line}, column {column} ({name}): {text:?} is not a finite number")]
    Number {
        line: u64,
        column: usize,
        name: String,
        text: String,
    },
}

impl Table {
    pub(super) fn parse(bytes: &[u8]) -> Result<Self, TableError> {
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
                .map_or(TableError::Empty, Into::into));
        };
        let (width, first_line) = (first.len(), line(first));
        if width < 2 {
            return Err(TableError::NoChannel { line: first_line });
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
                return Err(TableError::Columns {
                    line,
                    found,
                    first: first_line,
                    expected: width,
                });
            }
            for (column, field) in record.iter().enumerate() {
                let Some(number) = field.parse::<f64>().ok().filter(|x| x.is_finite()) else {
                    let (name, text) = (table.names[column].clone(), field.to_string());
                    return Err(TableError::Number {
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
            Err(TableError::Empty)
        } else {
            Ok(table)
        }
    }

    /// How a message names a column, by its index.
    pub(super) fn column(&self, column: usize) -> String {
        format!("column {} ({})", column + 1, self.names[column])
    }

    /// Rows under the names of this table, as CSV. Each number reads back exactly.
    pub(super) fn with_rows(&self, rows: &Resampled<Vec<f64>>) -> Result<Vec<u8>> {
        let mut writer = Writer::from_writer(Vec::new());
        if self.has_header {
            writer.write_record(&self.names)?;
        }
        for (time, values) in rows.times.iter().zip(&rows.values) {
            let numbers = std::iter::once(time).chain(values);
            writer.write_record(numbers.map(|number| format!("{number:?}")))?;
        }
        Ok(writer.into_inner()?)
    }
}
