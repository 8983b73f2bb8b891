//! CSV as Nexus of Vicon exports it.
//!
//! The section `Trajectories` has the rate in its second line, then rows of the names of markers,
//! of `Frame,Sub Frame,X,Y,Z` and of units. It ends at an empty line; other sections, of devices
//! and models, are passed over.

use ga_files::table::Table;

use super::error::PointTableError;
use super::layout::{Layout, MarkerColumns, Time, notes_of, row_of, unit};

const FORMAT: &str = "Vicon CSV";

/// Whether a text has a section of trajectories.
pub(super) fn is_vicon(bytes: &[u8]) -> bool {
    section_line(bytes).is_some()
}

pub(super) fn layout(bytes: &[u8]) -> Result<Layout, PointTableError> {
    let missing = |missing| PointTableError::NoLine {
        format: FORMAT,
        missing,
    };
    let start = section_line(bytes).ok_or_else(|| missing("Trajectories"))?;
    let rate_text = lines(bytes).nth(start + 1).map(cell).unwrap_or_default();
    let rate = rate_text.parse().ok();
    let rate = rate.filter(|rate: &f64| rate.is_finite() && *rate > 0.0);
    let rate = rate.ok_or(PointTableError::Rate {
        line: start + 2,
        text: rate_text,
    })?;
    // Empty lines before the section keep the numbers of lines.
    let mut text = vec![b'\n'; start + 2];
    let section = lines(bytes).skip(start + 2);
    for line in section.take_while(|line| !line.trim_ascii().is_empty()) {
        text.extend_from_slice(line);
        text.push(b'\n');
    }
    let table = Table::without_names(&text)?;
    let axes = row_of(&table, 0, "frame").filter(|&row| row > 0);
    let axes = axes.ok_or_else(|| missing("names, and one of axes, Frame,Sub Frame,X"))?;
    let columns = MarkerColumns {
        table: &table,
        axes,
        names: axes - 1,
        first: 2,
    };
    let (points, passed) = columns.find(|_| None)?;
    let units = axes + 1;
    if table.len() <= units {
        return Err(missing("units"));
    }
    let mut metres = None;
    for point in &points {
        for column in point.first..point.first + 3 {
            let text = table.text(units, column);
            let found = unit(text, table.line(units))?;
            if *metres.get_or_insert(found) != found {
                return Err(PointTableError::Unit {
                    line: table.line(units),
                    text: text.to_owned(),
                });
            }
        }
    }
    Ok(Layout {
        header_line: table.line(axes),
        width: table.width(axes),
        first_row: units + 1,
        frame: Some(0),
        time: Time::Rate(rate),
        points,
        metres,
        notes: notes_of(passed),
        stated_frames: None,
        has_empty_frames: false,
        table,
    })
}

/// The line of the word that begins the section, from 0.
fn section_line(bytes: &[u8]) -> Option<usize> {
    lines(bytes).position(|line| cell(line).eq_ignore_ascii_case("trajectories"))
}

fn lines(bytes: &[u8]) -> impl Iterator<Item = &[u8]> {
    bytes.split(|byte| *byte == b'\n')
}

/// The text of a line with one cell.
fn cell(line: &[u8]) -> String {
    let text = String::from_utf8_lossy(line);
    text.trim_matches(|letter: char| letter.is_whitespace() || matches!(letter, ',' | ';' | '"'))
        .to_owned()
}
