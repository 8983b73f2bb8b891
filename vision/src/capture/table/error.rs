//! What is wrong with tables of points.

use ga_files::table::TableError;

/// What is wrong with a table of points.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PointTableError {
    /// The text is not a table.
    #[error(transparent)]
    Table(#[from] TableError),
    /// The file is one of C3D.
    #[error(
        "this is a C3D file, which is not read; export it as TRC or CSV, for instance with Mokka \
         or the program that recorded it"
    )]
    C3d,
    /// There is no frame.
    #[error("there are no frames")]
    Empty,
    /// No point is seen in any frame.
    #[error("no point is seen in any frame")]
    NothingSeen,
    /// The table has no columns of points.
    #[error("line {line}: there are no points; each has three columns, NAME_x, NAME_y and NAME_z")]
    NoPoint {
        /// The line in the file, from 1.
        line: usize,
    },
    /// A file of a program for motion capture has no columns of markers.
    #[error("line {line}: there are no positions of markers{}", passed(columns))]
    NoMarker {
        /// The line in the file, from 1.
        line: usize,
        /// The columns that are something else.
        columns: Vec<String>,
    },
    /// A line that a format has before the frames is not there.
    #[error("{format}: there is no line of {missing} before the frames")]
    NoLine {
        /// The name of the format.
        format: &'static str,
        /// What the line would say.
        missing: &'static str,
    },
    /// The unit of length is not known.
    #[error(
        "line {line}: {text:?} is not a unit of length that is known, such as mm, cm, m, \
         Millimeters or Meters"
    )]
    Unit {
        /// The line in the file, from 1.
        line: usize,
        /// What the file says.
        text: String,
    },
    /// The number of frames in a second is not above 0.
    #[error("line {line}: the rate {text:?} is not a number of frames in a second")]
    Rate {
        /// The line in the file, from 1.
        line: usize,
        /// What the file says.
        text: String,
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
    /// Several points have a name after their prefixes.
    #[error("{name}: several points have this name: {}", shortened(names))]
    SeveralPoints {
        /// The name that was asked for.
        name: String,
        /// Their full names.
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
    #[error("{place}: point {point} is missing in the reference frame{}", because(*at_origin))]
    MissingAtRest {
        /// The line and the name of the frame.
        place: String,
        /// The name of the point.
        point: String,
        /// Whether its place there is 0,0,0, the sign of a lost marker.
        at_origin: bool,
    },
}

/// All names, or the first of many.
pub(super) fn shortened(names: &[String]) -> String {
    match names.len() {
        0..=30 => names.join(", "),
        count => format!("{} and {} others", names[..8].join(", "), count - 8),
    }
}

fn passed(columns: &[String]) -> String {
    match columns {
        [] => String::new(),
        columns => format!("; other columns are {}", shortened(columns)),
    }
}

fn because(at_origin: bool) -> &'static str {
    match at_origin {
        true => ", where it is 0,0,0, which is read as not seen",
        false => "",
    }
}
