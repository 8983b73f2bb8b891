//! Tables of keys, as [`ga_files::table`] reads and writes them.

use ga_files::table::{Cell, Separator, Table, TableError, row};

use super::channel_ends::ChannelEnds;
use super::ends::Ends;
use super::error::CurveError;
use super::piecewise::Curve;
use super::spline::SplineSystem;

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
    /// The slopes at the ends are for another number of channels.
    #[error("{found} slopes, but there must be two, or two for each channel: {expected}")]
    Slopes {
        /// How many slopes there are.
        found: usize,
        /// How many there are for all channels.
        expected: usize,
    },
    /// A periodic curve does not end at the value at which it begins.
    #[error(
        "line {line}, {column}: a periodic curve ends where it begins, at {first}, not at {last}"
    )]
    NotPeriodic {
        /// The line of the last key, from 1.
        line: usize,
        /// The column of the channel.
        column: String,
        /// Its value at the first key.
        first: f64,
        /// Its value at the last key.
        last: f64,
    },
    /// A key does not fit the others.
    #[error("line {line}, {column}: {problem}")]
    Key {
        /// The line of the key, from 1.
        line: usize,
        /// The column of the number.
        column: String,
        /// What is wrong.
        problem: CurveError,
    },
    /// The keys do not form a curve.
    #[error(transparent)]
    Curve(#[from] CurveError),
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

    /// A cubic spline through the keys of each channel.
    ///
    /// # Errors
    /// [`KeyTableError::Slopes`], [`KeyTableError::NotPeriodic`], [`KeyTableError::Key`] and
    /// [`KeyTableError::Curve`].
    ///
    /// ```
    /// use ga_anim::curve::table::KeyTable;
    ///
    /// let tent = KeyTable::decode(b"t,x\n0,0\n1,1\n2,0\n")?;
    /// // (3t − t³)/2 and its mirror image.
    /// assert_eq!(tent.splines(&"natural".parse()?)?[0].value(0.5), 0.6875);
    ///
    /// let open = KeyTable::decode(b"t,x\n0,0\n1,1\n2,2\n")?;
    /// let error = open.splines(&"periodic".parse()?).unwrap_err().to_string();
    /// assert!(error.starts_with("line 4, column 2 (x): a periodic curve ends where it begins"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn splines(&self, ends: &ChannelEnds) -> Result<Vec<Curve<f64>>, KeyTableError> {
        let count = self.channels.len();
        if let ChannelEnds::Slopes(slopes) = ends
            && ends.of_channel(0, count).is_none()
        {
            return Err(KeyTableError::Slopes {
                found: slopes.len(),
                expected: 2 * count,
            });
        }
        let system = SplineSystem::new(&self.times, ends.kind());
        let system = system.map_err(|problem| self.located(problem, 0))?;
        let channels = self.channels.iter().enumerate();
        channels
            .map(|(channel, values)| {
                match ends.of_channel(channel, count) {
                    Some(Ends::Slopes(slopes)) => system.fit_with_slopes(values, slopes),
                    _ => system.fit(values),
                }
                .map_err(|problem| self.located(problem, channel + 1))
            })
            .collect()
    }

    /// An error with the line and the column that it is about.
    fn located(&self, problem: CurveError, column: usize) -> KeyTableError {
        let key = match problem {
            CurveError::Time { key, .. }
            | CurveError::NotRising { key, .. }
            | CurveError::NotFinite { key, .. }
            | CurveError::OutOfRange { key } => key,
            CurveError::NotPeriodic { .. } => self.lines.len().saturating_sub(1),
            other => return other.into(),
        };
        let Some(&line) = self.lines.get(key) else {
            return problem.into();
        };
        let column = self.column(column);
        match problem {
            CurveError::NotPeriodic { first, last, .. } => KeyTableError::NotPeriodic {
                line,
                column,
                first,
                last,
            },
            problem => KeyTableError::Key {
                line,
                column,
                problem,
            },
        }
    }

    /// How a message names a column, by its index.
    fn column(&self, column: usize) -> String {
        format!("column {} ({})", column + 1, self.names[column])
    }

    /// Times, and the values of the channels at each, under the names of this table, as CSV. Each
    /// number reads back exactly.
    #[must_use]
    pub fn with_rows(&self, times: &[f64], values: &[Vec<f64>]) -> String {
        let mut text = String::new();
        if self.has_header {
            let names = self.names.iter().cloned().map(Cell::Text);
            text += &row(names, Separator::Comma);
        }
        for (time, values) in times.iter().zip(values) {
            let numbers = std::iter::once(time).chain(values);
            text += &row(numbers.copied().map(Cell::exact), Separator::Comma);
        }
        text
    }
}
