//! What users should know of a table of points and its frames.

use std::path::Path;

use ga_vision::capture::table::PointTable;
use ga_vision::capture::{FrameOutcome, HeadMotion};

use crate::frame::Warning;

/// How many frames a warning names.
const NAMED: usize = 5;

/// What was left out or assumed when a table was read.
pub(super) fn of_table(points: &PointTable, file: &Path) -> Vec<Warning> {
    let notes = points.notes.iter();
    let warning = notes.map(|note| Warning {
        count: note.count(),
        ..Warning::new(note.kind(), note).in_file(file)
    });
    warning.collect()
}

/// The frames that have no pose.
pub(super) fn of_frames(
    points: &PointTable,
    frames: &[FrameOutcome],
    file: &Path,
) -> Option<Warning> {
    let unsolved = frames.iter().enumerate();
    let unsolved = unsolved.filter_map(|(frame, found)| {
        let problem = found.as_ref().err()?;
        Some(format!(
            "{}: {}",
            points.place(frame),
            points.reason(problem)
        ))
    });
    let reasons: Vec<_> = unsolved.collect();
    let (count, all) = (reasons.len(), frames.len());
    let message = format!(
        "{count} of {all} frames have no pose, and are left empty ({})",
        shortened(&reasons)
    );
    (count > 0).then(|| Warning {
        count: Some(count),
        ..Warning::new("frames_without_pose", message).in_file(file)
    })
}

/// The frames that have a pose but show no key of the surface.
pub(super) fn of_motion(
    points: &PointTable,
    frames: &[FrameOutcome],
    motion: &HeadMotion,
    file: &Path,
) -> Option<Warning> {
    let empty = motion.empty_frames().into_iter();
    let empty = empty.filter(|&frame| frames[frame].is_ok());
    let places: Vec<_> = empty.map(|frame| points.place(frame)).collect();
    let message = format!(
        "{} frames show no key of the surface, whose expression they leave out ({})",
        places.len(),
        shortened(&places)
    );
    (!places.is_empty()).then(|| Warning {
        count: Some(places.len()),
        ..Warning::new("frames_without_keys", message).in_file(file)
    })
}

fn shortened(texts: &[String]) -> String {
    let first = texts[..texts.len().min(NAMED)].join("; ");
    match texts.len().saturating_sub(NAMED) {
        0 => first,
        more => format!("{first}; and {more} others"),
    }
}
