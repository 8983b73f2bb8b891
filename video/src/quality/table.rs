//! The measures of all frames as a table.

use ga_files::table::{Cell, Separator, row};

use super::measure::MEASURES;
use super::video::FrameQuality;

/// Comma-separated values: `frame`, `time_seconds`, the keys of [`MEASURES`] and `distorted_frame`,
/// then a row for each frame. A measure that a frame does not have is empty.
#[must_use]
pub fn csv(frames: &[FrameQuality]) -> String {
    let keys = MEASURES.iter().map(|measure| measure.key);
    let names = ["frame", "time_seconds"].into_iter().chain(keys);
    let names = names.chain(["distorted_frame"]);
    let names = names.map(|name| Cell::Text(name.to_owned()));
    let mut text = row(names, Separator::Comma);
    for frame in frames {
        let values = MEASURES.iter().map(|measure| (measure.value)(frame));
        let place = [frame.index as f64, frame.time_seconds].map(Some);
        let distorted = Some(frame.distorted_index as f64);
        let cells = place.into_iter().chain(values).chain([distorted]);
        let cells = cells.map(Cell::from);
        text += &row(cells, Separator::Comma);
    }
    text
}
