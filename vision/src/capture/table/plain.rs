//! Tables with a row of names such as `nose_x`, or without names.

use std::collections::HashSet;

use ga_files::table::Table;

use super::error::PointTableError;
use super::layout::{AXES, Layout, PointColumns, Time};

pub(super) fn layout(bytes: &[u8]) -> Result<Layout, PointTableError> {
    let table = Table::rectangular(bytes)?;
    let has_names = !table.names().is_empty();
    if !has_names && table.is_empty() {
        return Err(PointTableError::Empty);
    }
    let columns = match has_names {
        true => Columns::of_names(&table)?,
        false => Columns::without_names(&table)?,
    };
    let (header_line, width) = table.first_line();
    Ok(Layout {
        table,
        header_line,
        width,
        first_row: 0,
        frame: columns.frame,
        time: columns.time.map_or(Time::Unknown, Time::Column),
        points: columns.points,
        metres: None,
        notes: Vec::new(),
        stated_frames: None,
        has_empty_frames: true,
    })
}

/// Where the columns are.
#[derive(Default)]
struct Columns {
    frame: Option<usize>,
    time: Option<usize>,
    points: Vec<PointColumns>,
}

impl Columns {
    fn of_names(table: &Table) -> Result<Self, PointTableError> {
        let (header, (line, _)) = (table.names(), table.first_line());
        let mut found = Self::default();
        let mut first = 0;
        for (column, name) in header.iter().enumerate() {
            let is_letter = |letter: &char| letter.is_ascii_alphanumeric();
            let letters = name.chars().filter(is_letter).collect::<String>();
            match letters.to_ascii_lowercase().as_str() {
                "frame" | "framenumber" if found.frame.is_none() => found.frame = Some(column),
                "time" | "timeseconds" | "timesec" | "times" | "seconds" | "t"
                    if found.time.is_none() =>
                {
                    found.time = Some(column);
                }
                _ => break,
            }
            first = column + 1;
        }
        let mut names = HashSet::new();
        let mut columns = header.iter().enumerate().skip(first).peekable();
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
            let first = column;
            let owned = name.to_owned();
            if !names.insert(name) {
                return Err(PointTableError::Twice { line, name: owned });
            }
            found.points.push(PointColumns { name: owned, first });
        }
        if found.points.is_empty() {
            return Err(PointTableError::NoPoint { line });
        }
        Ok(found)
    }

    fn without_names(table: &Table) -> Result<Self, PointTableError> {
        let (line, found) = table.first_line();
        if !found.is_multiple_of(3) {
            return Err(PointTableError::NotTriples { line, found });
        }
        let point = |point: usize| PointColumns {
            name: point.to_string(),
            first: 3 * point,
        };
        Ok(Self {
            points: (0..found / 3).map(point).collect(),
            ..Self::default()
        })
    }
}

/// The name of a point and its axis, 0 to 2, from the name of a column such as `nose_x`.
fn coordinate(column: &str) -> Option<(&str, usize)> {
    let (name, axis) = column.rsplit_once(['_', '.', ':', '-', ' '])?;
    let axis = axis.to_ascii_lowercase();
    let index = AXES.iter().position(|letter| axis == letter.to_string())?;
    (!name.is_empty()).then_some((name, index))
}
