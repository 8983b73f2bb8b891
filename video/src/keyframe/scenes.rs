//! Shots as lists for editing: CSV, and CMX 3600 edit decision lists.

use std::fmt::Write;

use super::shot::{Background, Shot};

/// The time of a frame as hours, minutes, seconds and frames, `HH:MM:SS:FF`, without dropped
/// numbers: at a rate such as 30000/1001, frames are counted in 30.
///
/// ```
/// use ga_video::keyframe::scenes::timecode;
///
/// assert_eq!(timecode(90_061, [24, 1]), "01:02:32:13");
/// assert_eq!(timecode(1800, [30000, 1001]), "00:01:00:00");
/// ```
#[must_use]
pub fn timecode(frame: usize, frames_per_second: [u32; 2]) -> String {
    let [numerator, denominator] = frames_per_second.map(|part| part.max(1) as usize);
    let rate = ((numerator + denominator / 2) / denominator).max(1);
    let (seconds, frames) = (frame / rate, frame % rate);
    format!(
        "{:02}:{:02}:{:02}:{frames:02}",
        seconds / 3600,
        seconds / 60 % 60,
        seconds % 60
    )
}

/// A table with a row for each shot: its number from 1, its first frame and the frame after its
/// last, their timecodes, its frames, and `static` or `dynamic`.
#[must_use]
pub fn csv(shots: &[Shot], frames_per_second: [u32; 2]) -> String {
    let mut text = String::from("shot,start,end,start_timecode,end_timecode,frames,background\n");
    for (number, Shot { frames, background }) in shots.iter().enumerate() {
        // Writing to a string does not fail.
        let _ = writeln!(
            text,
            "{},{},{},{},{},{},{}",
            number + 1,
            frames.start,
            frames.end,
            timecode(frames.start, frames_per_second),
            timecode(frames.end, frames_per_second),
            frames.len(),
            background.name()
        );
    }
    text
}

/// An edit decision list in the format CMX 3600: an event for each shot, which takes its frames
/// from the reel and puts them at the same place. The ends of ranges are exclusive there as here.
/// Such a list has 999 events at most; shots after that are not in it.
#[must_use]
pub fn edl(shots: &[Shot], frames_per_second: [u32; 2], title: &str) -> String {
    let clean: String = title.chars().filter(|c| !c.is_control()).take(70).collect();
    let mut text = format!("TITLE: {clean}\nFCM: NON-DROP FRAME\n\n");
    for (number, Shot { frames, .. }) in shots.iter().enumerate().take(999) {
        let [start, end] = [frames.start, frames.end].map(|f| timecode(f, frames_per_second));
        let _ = writeln!(
            text,
            "{:03}  AX       V     C        {start} {end} {start} {end}\n* FROM CLIP NAME: {clean}",
            number + 1
        );
    }
    text
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
