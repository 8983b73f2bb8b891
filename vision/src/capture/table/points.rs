//! Tables of points in frames.

use std::collections::HashSet;

use ga_files::table::{Table, TableError};
use ga_runtime::cga3::Point;

/// Points of a face over time, in metres.
#[derive(Clone, Debug)]
pub struct PointTable {
    /// The names of the points.
    pub names: Vec<String>,
    /// At least one.
    pub frames: Vec<PointRow>,
}

/// A row of the table.
#[derive(Clone, Debug)]
pub struct PointRow {
    /// The line in the file, from 1.
    pub line: usize,
    /// Its name: what the column `frame` has, or else the number of the row, from 0.
    pub label: String,
    /// The time in seconds, where the table has a column for it.
    pub time: Option<f64>,
    /// Each point, `None` where its fields are empty.
    pub points: Vec<Option<Point<f64>>>,
}

/// What is wrong with a table of points.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PointTableError {
    /// The text is not a table.
    #[error(transparent)]
    Table(#[from] TableError),
    /// There is no frame.
    #[error("there are no frames")]
    Empty,
    /// The table has no columns of points.
    #[error("line {line}: there are no points; each has three columns, NAME_x, NAME_y and NAME_z")]
    NoPoint {
        /// The line in the file, from 1.
        line: usize,
    },
    /// The name of a column is not that of a coordinate.
    #[error(
        "line {line}, column {column} ({name:?}): expected {expected}; a point has the columns \
         NAME_x, NAME_y and NAME_z, and before all points there may be `frame` and `time_seconds`"
    )]
    Header {
        /// The line in the file, from 1.
        line: usize,
        /// The column, from 1.
        column: usize,
        /// The name.
        name: String,
        /// What is expected.
        expected: String,
    },
    /// Two points have one name.
    #[error("line {line}: point {name:?} is there twice")]
    Twice {
        /// The line in the file, from 1.
        line: usize,
        /// The name.
        name: String,
    },
    /// Columns without names are not three for each point.
    #[error(
        "line {line}: {found} columns without names; without names there are three for each point"
    )]
    NotTriples {
        /// The line in the file, from 1.
        line: usize,
        /// What was found.
        found: usize,
    },
    /// A coordinate is not a finite number.
    #[error(
        "line {line}, frame {frame}: {coordinate} of point {point} is {text:?}, not a finite number"
    )]
    Number {
        /// The line in the file, from 1.
        line: usize,
        /// The name of the frame.
        frame: String,
        /// The axis.
        coordinate: char,
        /// The name of the point.
        point: String,
        /// The text of the field.
        text: String,
    },
    /// Some coordinates of a point are there, and others not.
    #[error(
        "line {line}, frame {frame}: {coordinate} of point {point} is empty, but not all of its \
         coordinates are; a missing point has three empty fields"
    )]
    Partial {
        /// The line in the file, from 1.
        line: usize,
        /// The name of the frame.
        frame: String,
        /// The name of the point.
        point: String,
        /// The axis.
        coordinate: char,
    },
    /// A time is not a number, or not later than the one before.
    #[error("line {line}: the time {text:?} is not a finite number above that of the line before")]
    Time {
        /// The line in the file, from 1.
        line: usize,
        /// The text of the field.
        text: String,
    },
    /// Two frames have one name.
    #[error("line {line}: frame {label:?} is there twice")]
    SameFrame {
        /// The line in the file, from 1.
        line: usize,
        /// The name of the frame.
        label: String,
    },
    /// No point has a name.
    #[error("{name}: this is not a point; the points are {}", shortened(names))]
    NoSuchPoint {
        /// The name that was asked for.
        name: String,
        /// The names that there are.
        names: Vec<String>,
    },
    /// No frame has a name.
    #[error("{name}: there is no such frame; they are {first} to {last}")]
    NoFrame {
        /// The name that was asked for.
        name: String,
        /// The name of the first frame.
        first: String,
        /// The name of the last frame.
        last: String,
    },
    /// A point was not seen in the frame in which the head is at rest.
    #[error("{place}: point {point} is missing in the reference frame")]
    MissingAtRest {
        /// The line and the name of the frame.
        place: String,
        /// The name of the point.
        point: String,
    },
}

/// All names, or the first of many.
fn shortened(names: &[String]) -> String {
    match names.len() {
        0..=30 => names.join(", "),
        count => format!("{} and {} others", names[..8].join(", "), count - 8),
    }
}

const AXES: [char; 3] = ['x', 'y', 'z'];

/// Where the columns are.
struct Columns {
    frame: Option<usize>,
    time: Option<usize>,
    /// The first coordinate.
    first: usize,
    names: Vec<String>,
}

impl PointTable {
    /// Reads a table.
    ///
    /// # Errors
    /// What is wrong with the table, with the line.
    pub fn decode(bytes: &[u8]) -> Result<Self, PointTableError> {
        let table = Table::rectangular(bytes)?;
        let has_names = !table.names().is_empty();
        if !has_names && table.is_empty() {
            return Err(PointTableError::Empty);
        }
        let columns = match has_names {
            true => Columns::of_names(&table)?,
            false => Columns::without_names(&table)?,
        };
        let mut frames: Vec<PointRow> = Vec::new();
        for row in 0..table.len() {
            let frame = columns.frame(&table, row)?;
            let is_later = match (frames.last().and_then(|last| last.time), frame.time) {
                (Some(before), Some(time)) => time > before,
                _ => true,
            };
            if !is_later {
                return Err(PointTableError::Time {
                    line: frame.line,
                    text: table.text(row, columns.time.unwrap_or(0)).to_owned(),
                });
            }
            frames.push(frame);
        }
        if frames.is_empty() {
            return Err(PointTableError::Empty);
        }
        check_labels(&frames)?;
        Ok(Self {
            names: columns.names,
            frames,
        })
    }

    /// A point by its name, or else by its number from 0.
    ///
    /// # Errors
    /// [`PointTableError::NoSuchPoint`].
    pub fn point(&self, word: &str) -> Result<usize, PointTableError> {
        let by_name = self.names.iter().position(|name| name == word);
        let by_number = || word.parse().ok().filter(|&k: &usize| k < self.names.len());
        let found = by_name.or_else(by_number);
        found.ok_or_else(|| PointTableError::NoSuchPoint {
            name: word.to_owned(),
            names: self.names.clone(),
        })
    }

    /// A frame by its name.
    ///
    /// # Errors
    /// [`PointTableError::NoFrame`].
    pub fn frame(&self, name: &str) -> Result<usize, PointTableError> {
        let found = self.frames.iter().position(|frame| frame.label == name);
        let label = |frame: Option<&PointRow>| frame.map_or("", |frame| &frame.label).to_owned();
        found.ok_or_else(|| PointTableError::NoFrame {
            name: name.to_owned(),
            first: label(self.frames.first()),
            last: label(self.frames.last()),
        })
    }

    /// The points of a frame, which must be there, in which the head is at rest.
    ///
    /// # Errors
    /// [`PointTableError::MissingAtRest`] for the first point that was not seen.
    pub fn rest(&self, frame: usize) -> Result<Vec<Point<f64>>, PointTableError> {
        let row = self.frames[frame].points.iter().zip(&self.names);
        let place = |(place, name): (&Option<Point<f64>>, &String)| {
            place.ok_or_else(|| PointTableError::MissingAtRest {
                place: self.place(frame),
                point: name.clone(),
            })
        };
        row.map(place).collect()
    }

    /// How a message names a frame, which must be there.
    pub fn place(&self, frame: usize) -> String {
        let PointRow { line, label, .. } = &self.frames[frame];
        format!("line {line}, frame {label}")
    }

    /// Times in seconds from the first frame on, by their column or by the rate.
    pub fn times(&self, frames_per_second: f64) -> Vec<f64> {
        let start = self.frames[0].time.unwrap_or(0.0);
        let frames = self.frames.iter().enumerate();
        let by_rate = |k: usize| k as f64 / frames_per_second;
        frames
            .map(|(k, frame)| frame.time.map_or_else(|| by_rate(k), |time| time - start))
            .collect()
    }
}

fn check_labels(frames: &[PointRow]) -> Result<(), PointTableError> {
    let mut labels: Vec<_> = frames.iter().map(|f| (f.label.as_str(), f.line)).collect();
    labels.sort_unstable();
    let twice = labels.windows(2).find(|pair| pair[0].0 == pair[1].0);
    match twice {
        Some(pair) => Err(PointTableError::SameFrame {
            line: pair[1].1,
            label: pair[1].0.to_owned(),
        }),
        None => Ok(()),
    }
}

/// The name of a point and its axis, 0 to 2, from the name of a column such as `nose_x`.
fn coordinate(column: &str) -> Option<(&str, usize)> {
    let (name, axis) = column.rsplit_once(['_', '.', ':', '-', ' '])?;
    let axis = axis.to_ascii_lowercase();
    let index = AXES.iter().position(|letter| axis == letter.to_string())?;
    (!name.is_empty()).then_some((name, index))
}

impl Columns {
    fn of_names(table: &Table) -> Result<Self, PointTableError> {
        let (header, (line, _)) = (table.names(), table.first_line());
        let mut found = Self {
            frame: None,
            time: None,
            first: 0,
            names: Vec::new(),
        };
        for (column, name) in header.iter().enumerate() {
            match name.to_ascii_lowercase().as_str() {
                "frame" if found.frame.is_none() => found.frame = Some(column),
                "time" | "time_seconds" | "seconds" | "t" if found.time.is_none() => {
                    found.time = Some(column);
                }
                _ => break,
            }
            found.first = column + 1;
        }
        let mut names = HashSet::new();
        let mut columns = header.iter().enumerate().skip(found.first).peekable();
        while let Some(&(column, text)) = columns.peek() {
            let wrong = |column: usize, name: &str, expected: String| PointTableError::Header {
                line,
                column: column + 1,
                name: name.to_owned(),
                expected,
            };
            let Some((name, 0)) = coordinate(text) else {
                return Err(wrong(column, text, "the x of a point".to_owned()));
            };
            for (axis, letter) in AXES.iter().enumerate() {
                let expected = || format!("{name}_{letter}");
                match columns.next() {
                    Some((_, text)) if coordinate(text) == Some((name, axis)) => {}
                    Some((column, text)) => return Err(wrong(column, text, expected())),
                    None => return Err(wrong(header.len(), "", expected())),
                }
            }
            if !names.insert(name) {
                let name = name.to_owned();
                return Err(PointTableError::Twice { line, name });
            }
            found.names.push(name.to_owned());
        }
        if found.names.is_empty() {
            return Err(PointTableError::NoPoint { line });
        }
        Ok(found)
    }

    fn without_names(table: &Table) -> Result<Self, PointTableError> {
        let (line, found) = (table.line(0), table.width(0));
        if !found.is_multiple_of(3) {
            return Err(PointTableError::NotTriples { line, found });
        }
        Ok(Self {
            frame: None,
            time: None,
            first: 0,
            names: (0..found / 3).map(|point| point.to_string()).collect(),
        })
    }

    fn frame(&self, table: &Table, row: usize) -> Result<PointRow, PointTableError> {
        let line = table.line(row);
        let label = self.frame.map(|column| table.text(row, column).to_owned());
        let label = label.unwrap_or_else(|| row.to_string());
        let time = self.time.map(|column| {
            let number = table.number(row, column).ok().flatten();
            number.ok_or_else(|| PointTableError::Time {
                line,
                text: table.text(row, column).to_owned(),
            })
        });
        let point = |point: usize| {
            let columns = [0, 1, 2].map(|axis| self.first + 3 * point + axis);
            if columns
                .iter()
                .all(|column| table.number(row, *column) == Ok(None))
            {
                return Ok(None);
            }
            let mut place = [0.0; 3];
            for (axis, column) in columns.into_iter().enumerate() {
                let (frame, name) = (label.clone(), self.names[point].clone());
                let coordinate = AXES[axis];
                place[axis] = match table.number(row, column) {
                    Ok(Some(number)) => number,
                    Ok(None) if table.text(row, column).is_empty() => {
                        return Err(PointTableError::Partial {
                            line,
                            frame,
                            point: name,
                            coordinate,
                        });
                    }
                    Ok(None) | Err(_) => {
                        return Err(PointTableError::Number {
                            line,
                            frame,
                            coordinate,
                            point: name,
                            text: table.text(row, column).to_owned(),
                        });
                    }
                };
            }
            Ok(Some(Point::from(place)))
        };
        Ok(PointRow {
            line,
            points: (0..self.names.len()).map(point).collect::<Result<_, _>>()?,
            label,
            time: time.transpose()?,
        })
    }
}
