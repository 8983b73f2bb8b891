//! Tables of points in frames, as CSV.

use std::collections::HashSet;

use csv::{ReaderBuilder, StringRecord, Trim};
use ga_runtime::cga3::Point;

/// Points of a face over time, in metres.
pub(super) struct Points {
    /// The names of the points.
    pub(super) names: Vec<String>,
    pub(super) frames: Vec<Frame>,
}

/// A row of the table.
pub(super) struct Frame {
    /// The line in the file, from 1.
    pub(super) line: u64,
    /// Its name: what the column `frame` has, or else the number of the row, from 0.
    pub(super) label: String,
    /// The time in seconds, where the table has a column for it.
    pub(super) time: Option<f64>,
    /// Each point, `None` where its fields are empty.
    pub(super) points: Vec<Option<Point<f64>>>,
}

/// What is wrong with a table of points.
#[derive(Debug, thiserror::Error)]
pub(super) enum PointsError {
    #[error("{0}")]
    Csv(#[from] csv::Error),
    #[error("there are no frames")]
    Empty,
    #[error("line {line}: there are no points; each has three columns, NAME_x, NAME_y and NAME_z")]
    NoPoint { line: u64 },
    #[error(
        "line {line}, column {column} ({name:?}): expected {expected}; a point has the columns \
         NAME_x, NAME_y and NAME_z, and before all points there may be `frame` and `time_seconds`"
    )]
    Header {
        line: u64,
        column: usize,
        name: String,
        expected: String,
    },
    #[error("line {line}: point {name:?} is there twice")]
    Twice { line: u64, name: String },
    #[error(
        "line {line}: {found} columns without names; without names there are three for each point"
    )]
    NotTriples { line: u64, found: usize },
    #[error("line {line}: {found} columns, but line {first} has {expected}")]
    Columns {
        line: u64,
        found: usize,
        first: u64,
        expected: usize,
    },
    #[error(
        "line {line}, frame {frame}: {coordinate} of point {point} is {text:?}, not a finite number"
    )]
    Number {
        line: u64,
        frame: String,
        coordinate: char,
        point: String,
        text: String,
    },
    #[error(
        "line {line}, frame {frame}: {coordinate} of point {point} is empty, but not all of its \
         coordinates are; a missing point has three empty fields"
    )]
    Partial {
        line: u64,
        frame: String,
        point: String,
        coordinate: char,
    },
    #[error("line {line}: the time {text:?} is not a finite number above that of the line before")]
    Time { line: u64, text: String },
    #[error("line {line}: frame {label:?} is there twice")]
    SameFrame { line: u64, label: String },
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

impl Points {
    pub(super) fn parse(bytes: &[u8]) -> Result<Self, PointsError> {
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        let mut reader = ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .trim(Trim::All)
            .from_reader(bytes);
        let mut records = reader.records().peekable();
        let Some(Ok(first)) = records.peek().filter(|first| first.is_ok()) else {
            let problem = records.next().and_then(Result::err);
            return Err(problem.map_or(PointsError::Empty, Into::into));
        };
        let (width, first_line) = (first.len(), line_of(first));
        // A line with a number is not a line of names.
        let has_header = first.iter().all(|field| field.parse::<f64>().is_err());
        let columns = match has_header {
            true => Columns::of_names(first)?,
            false => Columns::without_names(first)?,
        };
        let mut frames: Vec<Frame> = Vec::new();
        for record in records.skip(usize::from(has_header)) {
            let record = record?;
            if record.len() != width {
                return Err(PointsError::Columns {
                    line: line_of(&record),
                    found: record.len(),
                    first: first_line,
                    expected: width,
                });
            }
            let frame = columns.frame(&record, frames.len())?;
            let is_later = match (frames.last().and_then(|last| last.time), frame.time) {
                (Some(before), Some(time)) => time > before,
                _ => true,
            };
            if !is_later {
                return Err(PointsError::Time {
                    line: frame.line,
                    text: record[columns.time.unwrap_or(0)].to_owned(),
                });
            }
            frames.push(frame);
        }
        if frames.is_empty() {
            return Err(PointsError::Empty);
        }
        check_labels(&frames)?;
        Ok(Self {
            names: columns.names,
            frames,
        })
    }

    /// A point by its name, or else by its number from 0.
    pub(super) fn point(&self, word: &str) -> Option<usize> {
        let by_name = self.names.iter().position(|name| name == word);
        let by_number = || word.parse().ok().filter(|&k: &usize| k < self.names.len());
        by_name.or_else(by_number)
    }

    /// How a message names a frame.
    pub(super) fn place(&self, frame: usize) -> String {
        let Frame { line, label, .. } = &self.frames[frame];
        format!("line {line}, frame {label}")
    }

    /// Times in seconds from the first frame on, by their column or by the rate.
    pub(super) fn times(&self, frames_per_second: f64) -> Vec<f64> {
        let start = self.frames[0].time.unwrap_or(0.0);
        let frames = self.frames.iter().enumerate();
        let by_rate = |k: usize| k as f64 / frames_per_second;
        frames
            .map(|(k, frame)| frame.time.map_or_else(|| by_rate(k), |time| time - start))
            .collect()
    }
}

fn line_of(record: &StringRecord) -> u64 {
    record.position().map_or(1, csv::Position::line)
}

fn check_labels(frames: &[Frame]) -> Result<(), PointsError> {
    let mut labels: Vec<_> = frames.iter().map(|f| (f.label.as_str(), f.line)).collect();
    labels.sort_unstable();
    let twice = labels.windows(2).find(|pair| pair[0].0 == pair[1].0);
    match twice {
        Some(pair) => Err(PointsError::SameFrame {
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
    fn of_names(header: &StringRecord) -> Result<Self, PointsError> {
        let line = line_of(header);
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
            let wrong = |column: usize, name: &str, expected: String| PointsError::Header {
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
                return Err(PointsError::Twice { line, name });
            }
            found.names.push(name.to_owned());
        }
        if found.names.is_empty() {
            return Err(PointsError::NoPoint { line });
        }
        Ok(found)
    }

    fn without_names(first: &StringRecord) -> Result<Self, PointsError> {
        let (line, found) = (line_of(first), first.len());
        if !found.is_multiple_of(3) {
            return Err(PointsError::NotTriples { line, found });
        }
        Ok(Self {
            frame: None,
            time: None,
            first: 0,
            names: (0..found / 3).map(|point| point.to_string()).collect(),
        })
    }

    fn frame(&self, record: &StringRecord, index: usize) -> Result<Frame, PointsError> {
        let line = line_of(record);
        let label = self.frame.map(|column| record[column].to_owned());
        let label = label.unwrap_or_else(|| index.to_string());
        let number = |text: &str| text.parse::<f64>().ok().filter(|x| x.is_finite());
        let time = self.time.map(|column| {
            let text = &record[column];
            number(text).ok_or_else(|| PointsError::Time {
                line,
                text: text.to_owned(),
            })
        });
        let point = |point: usize| {
            let fields = [0, 1, 2].map(|axis| &record[self.first + 3 * point + axis]);
            if fields.iter().all(|field| field.is_empty()) {
                return Ok(None);
            }
            let mut place = [0.0; 3];
            for (axis, text) in fields.into_iter().enumerate() {
                let (frame, name) = (label.clone(), self.names[point].clone());
                let coordinate = AXES[axis];
                place[axis] = match number(text) {
                    Some(number) => number,
                    None if text.is_empty() => {
                        return Err(PointsError::Partial {
                            line,
                            frame,
                            point: name,
                            coordinate,
                        });
                    }
                    None => {
                        return Err(PointsError::Number {
                            line,
                            frame,
                            coordinate,
                            point: name,
                            text: text.to_owned(),
                        });
                    }
                };
            }
            Ok(Some(Point::from(place)))
        };
        Ok(Frame {
            line,
            points: (0..self.names.len()).map(point).collect::<Result<_, _>>()?,
            label,
            time: time.transpose()?,
        })
    }
}
