//! TRC, as OpenSim and Pose2Sim write it.
//!
//! Cells are separated by tabs. The first line begins with `PathFileType`, the second names the
//! values of the third, among them `Units` and `NumFrames`, and the row that begins with `Frame#`
//! names the markers over the row of their axes.

use ga_files::table::Table;

use super::error::PointTableError;
use super::layout::{Layout, MarkerColumns, Time, notes_of, row_of, unit};
use super::note::PointTableNote;

pub(super) fn layout(bytes: &[u8]) -> Result<Layout, PointTableError> {
    let table = Table::without_names(bytes)?;
    let missing = |missing| PointTableError::NoLine {
        format: "TRC",
        missing,
    };
    let names = row_of(&table, 1, "frame#").ok_or_else(|| missing("names, Frame#, Time"))?;
    let axes = names + 1;
    let columns = MarkerColumns {
        table: &table,
        axes,
        names,
        first: 2,
    };
    let (points, passed) = columns.find(|_| None)?;
    let mut notes = notes_of(passed);
    let keys = row_of(&table, 1, "datarate").filter(|&row| row < names);
    let value = |key: &str| {
        let keys = keys?;
        let mut columns = 0..table.width(keys);
        let column = columns.find(|&k| table.text(keys, k).eq_ignore_ascii_case(key))?;
        Some(table.text(keys + 1, column)).filter(|text| !text.is_empty())
    };
    let metres = match value("units") {
        Some(text) => Some(unit(text, table.line(keys.map_or(0, |keys| keys + 1)))?),
        None => {
            notes.push(PointTableNote::NoUnit);
            None
        }
    };
    Ok(Layout {
        header_line: table.line(names),
        width: table.width(names).max(table.width(axes)),
        first_row: axes + 1,
        frame: Some(0),
        time: Time::Column(1),
        points,
        metres,
        notes,
        stated_frames: value("numframes").map(str::to_owned),
        has_empty_frames: false,
        table,
    })
}
