//! Shots, and whether their background stands still.

use std::ops::Range;

use serde::Serialize;

use super::cut::{STILL, usual};
use super::dissolve::Dissolve;
use super::fade::{Direction, Fade};
use super::flash::{Flash, Kind};

/// A shot: the frames from one cut to the next.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Shot {
    /// Its frames, half-open.
    #[serde(flatten)]
    pub frames: Range<usize>,
    /// Whether its background stands still.
    pub background: Background,
}

/// Whether the background of a shot stands still.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Background {
    /// It stands still; objects may move.
    Static,
    /// The camera or the background moves.
    Dynamic,
}

/// Beyond this difference of the background within half a second it moves.
const MOVING: f32 = 0.12;

/// The last step from or to an even frame, within this number of frames of a fade, is not a cut.
const NEAR_FADE: usize = 3;

/// A cut stands out if its change is this multiple of that of most other frames.
const ISOLATED: f32 = 2.5;

/// The transitions of a video.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Transitions {
    /// The first frames of shots that follow a hard cut.
    pub cuts: Vec<usize>,
    /// Dissolves, whose middle divides two shots.
    pub dissolves: Vec<Dissolve>,
    /// Fades. Between one out and one in, the middle of the even frames divides two shots.
    pub fades: Vec<Fade>,
    /// Flashes, which are no shots, and stray shots of one frame or two.
    pub flashes: Vec<Flash>,
}

impl Transitions {
    /// Removes cuts and dissolves that are parts of other transitions. A cut that stands out among
    /// the changes of a dissolve shows that there is none.
    pub(super) fn reconcile(&mut self, changes: &[f32]) {
        let Self {
            cuts,
            dissolves,
            fades,
            flashes,
        } = self;
        dissolves.retain(|dissolve| {
            let frames = &dissolve.frames;
            let usual_beside = |cut: usize| {
                let others = (frames.start..=frames.end).filter(|index| *index != cut);
                let changes = others.filter_map(|index| changes.get(index).copied());
                usual(changes.collect())
            };
            let stands_out = |cut: &usize| {
                (frames.start..=frames.end).contains(cut)
                    && changes[*cut] > ISOLATED * (usual_beside(*cut) + STILL)
            };
            !cuts.iter().any(stands_out) && !fades.iter().any(|fade| overlap(&fade.frames, frames))
        });
        cuts.retain(|cut| {
            let within = |frames: &Range<usize>, margin: usize| {
                (frames.start.saturating_sub(margin)..=frames.end + margin).contains(cut)
            };
            !fades.iter().any(|fade| within(&fade.frames, NEAR_FADE))
                && !dissolves.iter().any(|dissolve| within(&dissolve.frames, 0))
        });
        flashes.retain(|flash| {
            let is_boundary = |frame| cuts.contains(&frame) || frame == 0 || frame == changes.len();
            let Range { start, end } = flash.frames;
            flash.kind == Kind::Flash || (is_boundary(start) && is_boundary(end))
        });
    }

    /// Whether a frame is neither blended nor faded nor in a flash.
    #[must_use]
    pub fn is_clear(&self, frame: usize) -> bool {
        !self
            .dissolves
            .iter()
            .any(|dissolve| dissolve.frames.contains(&frame))
            && !self.fades.iter().any(|fade| fade.frames.contains(&frame))
            && !self
                .flashes
                .iter()
                .any(|flash| flash.kind == Kind::Flash && flash.frames.contains(&frame))
    }

    /// The dissolves, the fades, and the flashes and stray shots in words.
    #[must_use]
    pub fn blended(&self) -> Vec<String> {
        let dissolves = self.dissolves.iter().map(|dissolve| &dissolve.frames);
        let dissolves = dissolves.map(|Range { start, end }| format!("dissolve {start} to {end}"));
        let fades = self.fades.iter().map(|fade| {
            let direction = match fade.direction {
                Direction::In => "in from",
                Direction::Out => "out to",
            };
            let (Range { start, end }, colour) = (&fade.frames, fade.colour);
            format!("fade {direction} {colour}, {start} to {end}")
        });
        let flashes = self.flashes.iter().map(|Flash { frames, kind }| {
            format!("{} {} to {}", kind.name(), frames.start, frames.end)
        });
        dissolves.chain(fades).chain(flashes).collect()
    }

    /// The first frames of all shots but the first, in order, with `true` for hard cuts.
    fn boundaries(&self) -> Vec<(usize, bool)> {
        let mut boundaries: Vec<(usize, bool)> = self.cuts.iter().map(|cut| (*cut, true)).collect();
        let middle = |start: usize, end: usize| (start + end).div_ceil(2);
        for Dissolve { frames, .. } in &self.dissolves {
            boundaries.push((middle(frames.start, frames.end), false));
        }
        for pair in self.fades.windows(2) {
            if [pair[0].direction, pair[1].direction] == [Direction::Out, Direction::In] {
                let (start, end) = (
                    pair[0].frames.end,
                    pair[1].frames.start.max(pair[0].frames.end),
                );
                if !self.cuts.iter().any(|cut| (start..=end).contains(cut)) {
                    boundaries.push((middle(start, end), false));
                }
            }
        }
        boundaries.sort_unstable();
        boundaries.dedup_by_key(|boundary| boundary.0);
        boundaries
    }

    /// The shots of a video with a frame for each number of `moving`. A boundary less than `least`
    /// frames after the one before it, or before the end, does not count, and a cut there is
    /// removed.
    ///
    /// `moving[i]` is the difference of the background from half a second before frame i.
    pub(super) fn shots(&mut self, moving: &[f32], reach: &[usize], least: usize) -> Vec<Shot> {
        let count = moving.len();
        let mut starts = vec![0];
        for (boundary, hard) in self.boundaries() {
            let last = starts[starts.len() - 1];
            let inside = boundary > last && boundary < count;
            if inside && boundary - last >= least && count - boundary >= least {
                starts.push(boundary);
            } else if hard {
                self.cuts.retain(|cut| *cut != boundary);
            }
        }
        let ends = starts[1..].iter().copied().chain([count]);
        starts
            .iter()
            .zip(ends)
            .filter(|(start, end)| *start < end)
            .map(|(start, end)| Shot {
                frames: *start..end,
                background: self.background(*start..end, moving, reach),
            })
            .collect()
    }

    /// The median over the frames of a shot decides, without blended and faded ones.
    fn background(&self, frames: Range<usize>, moving: &[f32], reach: &[usize]) -> Background {
        let start = frames.start;
        let within = |frame: &usize| *frame >= start + reach[*frame] && reach[*frame] > 0;
        let differences = frames
            .filter(within)
            .filter(|frame| self.is_clear(*frame) && self.is_clear(*frame - reach[*frame]))
            .map(|frame| moving[frame]);
        match usual(differences.collect()) > MOVING {
            true => Background::Dynamic,
            false => Background::Static,
        }
    }
}

fn overlap(a: &Range<usize>, b: &Range<usize>) -> bool {
    a.start < b.end && b.start < a.end
}
