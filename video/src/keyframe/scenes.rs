//! Shots as lists for editing: CSV, and CMX 3600 edit decision lists.

use std::fmt::Write;

use ga_files::table::{Cell, Separator, row};

use super::shot::{Background, Shot};
use super::timecode::TimeBase;

/// A table with a row for each shot: its number from 1, its first frame and the frame after its
/// last, their timecodes, its frames, `static` or `dynamic`, both times in seconds, and the frames
/// in a second of the timecodes. `times` has the time of each frame in seconds, and that of the end
/// of the last. Without a time base timecodes and rate are missing.
#[must_use]
pub fn csv(shots: &[Shot], times: &[f64], base: Option<TimeBase>) -> String {
    let names = [
        "shot",
        "start",
        "end",
        "start_timecode",
        "end_timecode",
        "frames",
        "background",
        "start_seconds",
        "end_seconds",
        "rate",
    ];
    let mut text = names.join(",") + "\n";
    let rate = base.map(|base| base.rate().map(|part| part.to_string()).join("/"));
    for (number, Shot { frames, background }) in shots.iter().enumerate() {
        let seconds = [frames.start, frames.end].map(|frame| time(times, frame));
        let [start, end] = seconds.map(|time| {
            base.map(|base| base.code(time))
                .map_or(Cell::Missing, Cell::Text)
        });
        let count = |number: usize| Cell::Number(number as f64);
        let [from, to] = seconds.map(|time| Cell::Text(format!("{time:.6}")));
        let cells = [
            count(number + 1),
            count(frames.start),
            count(frames.end),
            start,
            end,
            count(frames.len()),
            Cell::Text(background.name().into()),
            from,
            to,
            rate.clone().map_or(Cell::Missing, Cell::Text),
        ];
        text += &row(cells, Separator::Comma);
    }
    text
}

/// An edit decision list in the format CMX 3600: an event for each shot, which takes its frames
/// from the reel and puts them at the same place. The ends of ranges are exclusive there as here.
/// Such a list has 999 events at most; shots after that are not in it. `times` are those of
/// [`csv`]. Each event has its times in seconds and the rate of the timecodes as a comment.
#[must_use]
pub fn edl(shots: &[Shot], times: &[f64], base: TimeBase, title: &str) -> String {
    let clean: String = title.chars().filter(|c| !c.is_control()).take(70).collect();
    let counted = if base.drops() { "DROP" } else { "NON-DROP" };
    let [numerator, denominator] = base.rate();
    let mut text = format!("TITLE: {clean}\nFCM: {counted} FRAME\n\n");
    for (number, Shot { frames, .. }) in shots.iter().enumerate().take(999) {
        let [from, to] = [frames.start, frames.end].map(|frame| time(times, frame));
        let [start, end] = [from, to].map(|time| base.code(time));
        let _ = writeln!(
            text,
            "{:03}  AX       V     C        {start} {end} {start} {end}\n\
             * FROM CLIP NAME: {clean}\n\
             * SECONDS: {from:.6} TO {to:.6}, {numerator}/{denominator} FRAMES IN A SECOND",
            number + 1
        );
    }
    text
}

/// The time of a frame; the last one for those after it.
fn time(times: &[f64], frame: usize) -> f64 {
    times.get(frame).or(times.last()).copied().unwrap_or(0.0)
}

impl Background {
    /// `static` or `dynamic`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Static => "static",
            Self::Dynamic => "dynamic",
        }
    }
}
