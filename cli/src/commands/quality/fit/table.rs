//! Scores as CSV: a line with names, and numbers under them.

use csv::{ReaderBuilder, Trim};

/// Columns of numbers with names.
pub(super) struct Table {
    names: Vec<String>,
    columns: Vec<Vec<String>>,
    /// The line of each row in the file, from 1.
    lines: Vec<u64>,
}

/// What is wrong with a table.
#[derive(Debug, thiserror::Error)]
pub(super) enum TableError {
    #[error("{0}")]
    Csv(#[from] csv::Error),
    #[error("there is no column {wanted}; the first line names {names}")]
    Column { wanted: String, names: String },
    #[error("line {line}, column {column}: {text:?} is not a finite number")]
    Number {
        line: u64,
        column: String,
        text: String,
    },
}

impl Table {
    pub(super) fn parse(bytes: &[u8]) -> Result<Self, TableError> {
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        let mut reader = ReaderBuilder::new().trim(Trim::All).from_reader(bytes);
        let names: Vec<String> = reader.headers()?.iter().map(str::to_owned).collect();
        let (mut columns, mut lines) = (vec![Vec::new(); names.len()], Vec::new());
        for record in reader.records() {
            let record = record?;
            lines.push(record.position().map_or(1, csv::Position::line));
            for (column, field) in columns.iter_mut().zip(&record) {
                column.push(field.to_owned());
            }
        }
        Ok(Self {
            names,
            columns,
            lines,
        })
    }

    /// Whether there is a column of this name.
    pub(super) fn has(&self, name: &str) -> bool {
        self.place(name).is_some()
    }

    /// The numbers of a column.
    pub(super) fn numbers(&self, name: &str) -> Result<Vec<f64>, TableError> {
        let Some(place) = self.place(name) else {
            return Err(TableError::Column {
                wanted: name.to_owned(),
                names: self.names.join(", "),
            });
        };
        let rows = self.columns[place].iter().zip(&self.lines);
        rows.map(|(text, line)| {
            let number = text.parse::<f64>().ok().filter(|x| x.is_finite());
            number.ok_or_else(|| TableError::Number {
                line: *line,
                column: name.to_owned(),
                text: text.clone(),
            })
        })
        .collect()
    }

    fn place(&self, name: &str) -> Option<usize> {
        let mut names = self.names.iter();
        names.position(|other| other.eq_ignore_ascii_case(name))
    }
}
