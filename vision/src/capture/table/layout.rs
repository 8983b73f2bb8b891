//! Where frames and coordinates are in the rows of a table.

use std::collections::HashSet;

use ga_files::table::{Table, TableError};
use ga_runtime::cga3::Point;

use super::error::PointTableError;
use super::note::PointTableNote;
use super::row::PointRow;

pub(super) const AXES: [char; 3] = ['x', 'y', 'z'];

/// How the times of frames are known.
pub(super) enum Time {
    Unknown,
    /// A column of seconds.
    Column(usize),
    /// Frames in a second, which are numbered from 1.
    Rate(f64),
}

/// A table whose columns are understood.
pub(super) struct Layout {
    pub(super) table: Table,
    /// The line that says what the columns are, from 1.
    pub(super) header_line: usize,
    /// How many columns it has.
    pub(super) width: usize,
    /// The first row of a frame.
    pub(super) first_row: usize,
    /// The column of the names of frames; without it they are numbered from 0.
    pub(super) frame: Option<usize>,
    pub(super) time: Time,
    pub(super) points: Vec<PointColumns>,
    /// The length of the unit, where the file says it.
    pub(super) metres: Option<f64>,
    pub(super) notes: Vec<PointTableNote>,
    /// How many frames there are, as the file says.
    pub(super) stated_frames: Option<String>,
    /// Whether rows without anything are frames.
    pub(super) has_empty_frames: bool,
}

/// A point, whose three coordinates are in neighbouring columns.
pub(super) struct PointColumns {
    pub(super) name: String,
    pub(super) first: usize,
}

impl Layout {
    /// All frames, in metres.
    pub(super) fn frames(&self) -> Result<Vec<PointRow>, PointTableError> {
        let mut frames: Vec<PointRow> = Vec::new();
        for row in self.first_row..self.table.len() {
            if !self.has_empty_frames && is_empty(&self.table, row) {
                continue;
            }
            let frame = self.frame(row, frames.len())?;
            let is_later = match (frames.last().and_then(|last| last.time), frame.time) {
                (Some(before), Some(time)) => time > before,
                _ => true,
            };
            if !is_later {
                return Err(self.wrong_time(row));
            }
            frames.push(frame);
        }
        Ok(frames)
    }

    fn frame(&self, row: usize, index: usize) -> Result<PointRow, PointTableError> {
        let (table, line) = (&self.table, self.table.line(row));
        let needed = self.points.last().map_or(0, |point| point.first + 3);
        let found = table.width(row);
        let is_beyond = |column: usize| !table.text(row, column).is_empty();
        if found < needed || (self.width..found).any(is_beyond) {
            return Err(PointTableError::Table(TableError::Columns {
                line,
                first: self.header_line,
                found,
                expected: self.width,
            }));
        }
        let label = self.frame.map(|column| table.text(row, column).to_owned());
        let label = label.unwrap_or_else(|| index.to_string());
        let time = match self.time {
            Time::Unknown => None,
            Time::Column(column) => match table.number(row, column) {
                Ok(Some(time)) => Some(time),
                _ => return Err(self.wrong_time(row)),
            },
            Time::Rate(rate) => match label.parse::<u32>() {
                Ok(number) => Some((f64::from(number) - 1.0) / rate),
                Err(_) => return Err(self.wrong_time(row)),
            },
        };
        let points = self
            .points
            .iter()
            .map(|point| self.point(row, &label, point));
        Ok(PointRow {
            line,
            points: points.collect::<Result<_, _>>()?,
            label,
            time,
        })
    }

    fn point(
        &self,
        row: usize,
        frame: &str,
        point: &PointColumns,
    ) -> Result<Option<Point<f64>>, PointTableError> {
        let (table, line) = (&self.table, self.table.line(row));
        let columns = [0, 1, 2].map(|axis| point.first + axis);
        if columns
            .iter()
            .all(|column| table.number(row, *column) == Ok(None))
        {
            return Ok(None);
        }
        let mut place = [0.0; 3];
        for (axis, column) in columns.into_iter().enumerate() {
            let (frame, name, coordinate) = (frame.to_owned(), point.name.clone(), AXES[axis]);
            let number = table.number(row, column).ok().flatten();
            let scaled = number.map(|number| number * self.metres.unwrap_or(1.0));
            place[axis] = match scaled.filter(|number| number.is_finite()) {
                Some(number) => number,
                None if table.text(row, column).is_empty() => {
                    return Err(PointTableError::Partial {
                        line,
                        frame,
                        point: name,
                        coordinate,
                    });
                }
                None => {
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
    }

    fn wrong_time(&self, row: usize) -> PointTableError {
        let column = match self.time {
            Time::Column(column) => Some(column),
            Time::Rate(_) | Time::Unknown => self.frame,
        };
        PointTableError::Time {
            line: self.table.line(row),
            text: self.table.text(row, column.unwrap_or(0)).to_owned(),
        }
    }
}

/// Finds the columns of named markers in a row of axes, `X`, `Y`, `Z` or `X1`, `Y1`, `Z1`.
pub(super) struct MarkerColumns<'a> {
    pub(super) table: &'a Table,
    /// The row of the axes.
    pub(super) axes: usize,
    /// The row of the names, each at least in the first of its three columns.
    pub(super) names: usize,
    /// The first column that is not of the frame or its time.
    pub(super) first: usize,
}

impl MarkerColumns<'_> {
    /// The points, and the names of columns that are something else. `other` says what a column is
    /// if not a position.
    pub(super) fn find(
        &self,
        other: impl Fn(usize) -> Option<String>,
    ) -> Result<(Vec<PointColumns>, Vec<String>), PointTableError> {
        let (table, line) = (self.table, self.table.line(self.axes));
        let width = table.width(self.axes).max(table.width(self.names));
        let mut points: Vec<PointColumns> = Vec::new();
        let mut passed: Vec<String> = Vec::new();
        let mut names = HashSet::new();
        let mut pass = |name: String| {
            if !passed.contains(&name) {
                passed.push(name);
            }
        };
        let mut column = self.first;
        // The name of the columns up to the next name.
        let mut name = "";
        while column < width {
            let (text, here) = (
                table.text(self.axes, column),
                table.text(self.names, column),
            );
            if !here.is_empty() {
                name = here;
            }
            let something = other(column);
            if something.is_some() || axis(text) != Some(0) {
                if !(here.is_empty() && text.is_empty()) {
                    pass(something.unwrap_or_else(|| format!("{name} {text}")));
                }
                column += 1;
                continue;
            }
            if here.is_empty() {
                return Err(PointTableError::Header {
                    line: table.line(self.names),
                    column: column + 1,
                    name: String::new(),
                    expected: "the name of a point".to_owned(),
                });
            }
            for (k, letter) in AXES.iter().enumerate() {
                let found = table.text(self.axes, column + k);
                if axis(found) != Some(k) || other(column + k).is_some() {
                    return Err(PointTableError::Header {
                        line,
                        column: column + k + 1,
                        name: found.to_owned(),
                        expected: format!("the {letter} of {here}"),
                    });
                }
            }
            if is_without_name(here) {
                pass(here.to_owned());
            } else if names.insert(here) {
                points.push(PointColumns {
                    name: here.to_owned(),
                    first: column,
                });
            } else {
                let name = here.to_owned();
                let line = table.line(self.names);
                return Err(PointTableError::Twice { line, name });
            }
            column += 3;
        }
        match points.is_empty() {
            true => Err(PointTableError::NoMarker {
                line,
                columns: passed,
            }),
            false => Ok((points, passed)),
        }
    }
}

/// The length of a unit in metres.
pub(super) fn unit(text: &str, line: usize) -> Result<f64, PointTableError> {
    match text.to_ascii_lowercase().as_str() {
        "m" | "meter" | "meters" | "metre" | "metres" => Ok(1.0),
        "cm" | "centimeter" | "centimeters" | "centimetre" | "centimetres" => Ok(0.01),
        "mm" | "millimeter" | "millimeters" | "millimetre" | "millimetres" => Ok(0.001),
        _ => Err(PointTableError::Unit {
            line,
            text: text.to_owned(),
        }),
    }
}

/// The first row from another on whose first cell is a word.
pub(super) fn row_of(table: &Table, from: usize, word: &str) -> Option<usize> {
    let is_it = |row: &usize| table.text(*row, 0).eq_ignore_ascii_case(word);
    (from..table.len()).find(is_it)
}

/// Whether a row has nothing but separators.
pub(super) fn is_empty(table: &Table, row: usize) -> bool {
    (0..table.width(row)).all(|column| table.text(row, column).is_empty())
}

/// What is said of columns that were passed over.
pub(super) fn notes_of(passed: Vec<String>) -> Vec<PointTableNote> {
    match passed.is_empty() {
        true => Vec::new(),
        false => vec![PointTableNote::ColumnsPassedOver(passed)],
    }
}

/// The axis that a text names, 0 to 2, with the number of the marker or without.
fn axis(text: &str) -> Option<usize> {
    let mut letters = text
        .trim_end_matches(|letter: char| letter.is_ascii_digit())
        .chars();
    let letter = letters.next()?.to_ascii_lowercase();
    let index = AXES.iter().position(|axis| *axis == letter)?;
    letters.next().is_none().then_some(index)
}

/// Whether a marker was not recognised: Motive and Nexus number such markers anew in every gap.
fn is_without_name(name: &str) -> bool {
    let name = name.rsplit(':').next().unwrap_or(name);
    name.starts_with('*') || name.to_ascii_lowercase().starts_with("unlabeled")
}
