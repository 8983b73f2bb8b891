//! What is said about a video.

use std::fmt::Write;

use ga_video::keyframe::fade::{Colour, Direction};
use ga_video::keyframe::{Analysis, Reason};
use serde::Serialize;

/// The report as JSON. Intervals are half-open; a cut is the first frame of the new shot.
#[derive(Serialize)]
pub(super) struct Report {
    pub(super) frames: usize,
    pub(super) cuts: Vec<usize>,
    dissolves: Vec<Interval>,
    fades: Vec<FadeReport>,
    shots: Vec<ShotReport>,
    pub(super) key_frames: Vec<KeyFrameReport>,
}

#[derive(Serialize)]
struct Interval {
    start: usize,
    end: usize,
}

#[derive(Serialize)]
struct FadeReport {
    start: usize,
    end: usize,
    direction: &'static str,
    colour: &'static str,
}

#[derive(Serialize)]
struct ShotReport {
    start: usize,
    end: usize,
    background: &'static str,
}

#[derive(Serialize)]
pub(super) struct KeyFrameReport {
    pub(super) index: usize,
    /// In seconds after the first frame.
    pub(super) time: f64,
    pub(super) reason: &'static str,
    pub(super) score: f64,
}

fn reason(reason: Reason) -> &'static str {
    match reason {
        Reason::Shot => "shot",
        Reason::Background => "background",
        Reason::Action => "action",
    }
}

impl Report {
    pub(super) fn new(analysis: &Analysis) -> Self {
        let transitions = &analysis.transitions;
        let dissolves = transitions.dissolves.iter().map(|dissolve| Interval {
            start: dissolve.frames.start,
            end: dissolve.frames.end,
        });
        let fades = transitions.fades.iter().map(|fade| FadeReport {
            start: fade.frames.start,
            end: fade.frames.end,
            direction: match fade.direction {
                Direction::In => "in",
                Direction::Out => "out",
            },
            colour: match fade.colour {
                Colour::Black => "black",
                Colour::White => "white",
            },
        });
        let shots = analysis.shots.iter().map(|shot| ShotReport {
            start: shot.frames.start,
            end: shot.frames.end,
            background: shot.background.name(),
        });
        let key_frames = analysis.key_frames.iter().map(|key| KeyFrameReport {
            index: key.index,
            time: key.time_seconds,
            reason: reason(key.reason),
            score: key.score,
        });
        Self {
            frames: analysis.frames.len(),
            cuts: transitions.cuts.clone(),
            dissolves: dissolves.collect(),
            fades: fades.collect(),
            shots: shots.collect(),
            key_frames: key_frames.collect(),
        }
    }

    /// The dissolves and fades in words.
    pub(super) fn blended(&self) -> Vec<String> {
        let dissolves = self.dissolves.iter();
        let dissolves =
            dissolves.map(|Interval { start, end }| format!("dissolve {start} to {end}"));
        let fades = self.fades.iter().map(|fade| {
            let way = if fade.direction == "in" { "from" } else { "to" };
            let (direction, colour) = (fade.direction, fade.colour);
            format!(
                "fade {direction} {way} {colour}, {} to {}",
                fade.start, fade.end
            )
        });
        dissolves.chain(fades).collect()
    }

    pub(super) fn text(&self) -> String {
        let mut text = format!(
            "{} frames, {} shots, {} cuts, {} dissolves, {} fades, {} key frames\n",
            self.frames,
            self.shots.len(),
            self.cuts.len(),
            self.dissolves.len(),
            self.fades.len(),
            self.key_frames.len()
        );
        // Writing to a string does not fail.
        for line in self.blended() {
            let _ = writeln!(text, "{line}");
        }
        for shot in &self.shots {
            let _ = writeln!(
                text,
                "shot {} to {}, {} background",
                shot.start, shot.end, shot.background
            );
        }
        for key in &self.key_frames {
            let _ = writeln!(
                text,
                "key frame {} at {:.3} s: {}, score {:.3}",
                key.index, key.time, key.reason, key.score
            );
        }
        text
    }
}
