//! CSV as Motive of OptiTrack exports it.
//!
//! The first line is a list of keys and values, among them `Length Units`. Rows of types, names and
//! properties of the columns follow, of which only markers have positions of points; rigid bodies
//! and bones are passed over. The row that begins with `Frame` names the axes.

use ga_files::table::Table;

use super::error::PointTableError;
use super::layout::{Layout, MarkerColumns, Time, is_empty, notes_of, row_of, unit};
use super::note::PointTableNote;

const FORMAT: &str = "Motive CSV";

pub(super) fn layout(bytes: &[u8]) -> Result<Layout, PointTableError> {
    let table = Table::without_names(bytes)?;
    let missing = |missing| PointTableError::NoLine {
        format: FORMAT,
        missing,
    };
    let axes = row_of(&table, 1, "frame").ok_or_else(|| missing("axes, Frame,Time (Seconds),X"))?;
    // Rows of types, names and properties, in this order where the second column does not say it.
    let rows: Vec<_> = (1..axes).filter(|&row| !is_empty(&table, row)).collect();
    let labelled = |word: &str, place: usize| {
        let by_label = rows
            .iter()
            .find(|&&row| table.text(row, 1).eq_ignore_ascii_case(word));
        by_label.or_else(|| rows.get(place)).copied()
    };
    let types = labelled("Type", 0).ok_or_else(|| missing("types"))?;
    let names = labelled("Name", 1).ok_or_else(|| missing("names"))?;
    let properties = rows.last().copied().filter(|&row| row > names);
    let properties = properties.ok_or_else(|| missing("properties"))?;
    let other = |column: usize| {
        let (kind, name) = (table.text(types, column), table.text(names, column));
        let is_marker = kind.eq_ignore_ascii_case("Marker");
        let is_position = table
            .text(properties, column)
            .eq_ignore_ascii_case("Position");
        (!(is_marker && is_position)).then(|| format!("{kind} {name}").trim().to_owned())
    };
    let columns = MarkerColumns {
        table: &table,
        axes,
        names,
        first: 2,
    };
    let (points, passed) = columns.find(other)?;
    let mut notes = notes_of(passed);
    let width = table.width(0);
    let key = |name: &str| (0..width).find(|&k| table.text(0, k).eq_ignore_ascii_case(name));
    let metres = match key("Length Units") {
        Some(column) => Some(unit(table.text(0, column + 1), table.line(0))?),
        None => {
            notes.push(PointTableNote::NoUnit);
            None
        }
    };
    Ok(Layout {
        header_line: table.line(axes),
        width: table.width(axes),
        first_row: axes + 1,
        frame: Some(0),
        time: Time::Column(1),
        points,
        metres,
        notes,
        stated_frames: None,
        has_empty_frames: false,
        table,
    })
}
