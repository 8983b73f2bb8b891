//! The choice of key frames in two stages.

use std::collections::VecDeque;

use ga_image::plane::{Plane, PlaneError, PlaneView};
use ga_image::quality::{Information, MutualInformation};
use ga_numerics::order_statistics::median;
use serde::Serialize;

use super::difference::at_rest;
use super::fade::Level;
use super::layout::{Layout, without_bars};
use super::shot::{Shot, Transitions};

/// The strict thresholds of the first stage: the least difference of the background and of the
/// region of objects from the last candidate, relative to the contrast of the frames.
const BACKGROUND: f32 = 0.12;
const OBJECT: f32 = 0.25;

/// A candidate also differs from the last one this many times more than two frames usually do.
const RATIO: f32 = 3.0;

/// The least time between two candidates of a shot, in seconds.
const APART: f64 = 0.4;

/// The change by which a frame is certainly not of the same shot.
const OTHER_SHOT: f32 = 0.3;

/// After this number of frames with a change below [`CALM`] a candidate may be taken from a picture
/// that has come to rest.
const CALM_FRAMES: usize = 4;
const CALM: f32 = 0.02;

/// The difference from the last candidate that such a picture has.
const SETTLED: f32 = 0.04;

/// After this number of frames with a change below [`CALM`] whatever is usual, it need not differ.
const REST_FRAMES: usize = 10;

/// A frame is nearly black below this root mean square of red, and below this fraction of the
/// brightest frame.
const BLACK: f32 = 6.0;
const BLACK_FRACTION: f32 = 0.12;

/// Pictures whose levels have less information than this, in bits, are even.
const EVEN_BITS: f64 = 0.05;

/// Why a frame is a key frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Reason {
    /// It is the first clear frame of its shot.
    Shot,
    /// The background differs from the key frame before it.
    Background,
    /// The objects differ, and the background does not.
    Action,
}

impl Reason {
    /// `shot`, `background` or `action`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Shot => "shot",
            Self::Background => "background",
            Self::Action => "action",
        }
    }
}

/// A frame that passed the first stage.
#[derive(Clone, Debug, PartialEq)]
pub struct Candidate {
    /// Its number.
    pub index: usize,
    /// When it is shown, in seconds after the first frame.
    pub time_seconds: f64,
    /// What differs from the candidate before it.
    pub reason: Reason,
    /// How much is new since the candidate before it, 0 to 1; see [`novelty`]. Where only objects
    /// act, how much is new in their region.
    pub novelty: f64,
    level: Level,
}

/// A chosen frame.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct KeyFrame {
    /// Its number.
    pub index: usize,
    /// When it is shown, in seconds after the first frame.
    #[serde(rename = "time")]
    pub time_seconds: f64,
    /// Why it was chosen.
    pub reason: Reason,
    /// How much is new in it, from 0 to 1; see [`novelty`]. Where only objects act, how much is new
    /// in their region.
    pub score: f64,
}

/// How much of a picture another does not say, in comparison with what neighbouring frames say of
/// each other: 1 − I(A; B) / I, where `usual_bits` is the usual mutual information I of neighbours.
/// It is 0 for still pictures whatever their noise is, and 1 where nothing is in common. Without
/// neighbours, min(H(A), H(B)) stands for I. Between even pictures, whose entropies are almost 0,
/// nothing is new where `same` says that they look alike, and everything otherwise.
#[must_use]
pub fn novelty(information: Information, usual_bits: Option<f64>, same: bool) -> f64 {
    let least = least_bits(information);
    let usual = usual_bits.unwrap_or(least).min(least);
    if usual < EVEN_BITS {
        return if same { 0.0 } else { 1.0 };
    }
    (1.0 - information.mutual_bits() / usual).clamp(0.0, 1.0)
}

fn least_bits(information: Information) -> f64 {
    information.first_bits.min(information.second_bits)
}

/// The first stage, while frames come in. It keeps the luma of one frame.
#[derive(Debug, Default)]
pub(super) struct Selector {
    candidates: Vec<Candidate>,
    anchor: Plane<f32>,
    luma: Plane<u8>,
    changes: Recent,
    bits: Recent,
    calm: usize,
    rest: usize,
    unsettled: bool,
    is_restless: bool,
}

/// The last 15 numbers.
#[derive(Clone, Debug, Default)]
struct Recent(VecDeque<f64>);

impl Recent {
    fn push(&mut self, value: f64) {
        if self.0.len() == 15 {
            self.0.pop_front();
        }
        self.0.push_back(value);
    }

    fn median(&self) -> Option<f64> {
        let mut sorted: Vec<f64> = self.0.iter().copied().collect();
        median(&mut sorted)
    }
}

/// What the first stage knows of a frame.
pub(super) struct Seen<'a> {
    pub(super) index: usize,
    pub(super) time_seconds: f64,
    pub(super) signature: &'a Plane<f32>,
    pub(super) level: Level,
    pub(super) luma: PlaneView<'a, u8>,
    /// The difference from the frame before it after the motion of the camera.
    pub(super) change: f32,
    /// The same at rest.
    pub(super) change_at_rest: f32,
    /// Mutual information with the frame before it.
    pub(super) mutual_bits: Option<f64>,
    /// Whether a candidate is needed in any case.
    pub(super) forced: bool,
}

impl Selector {
    /// The number of the last candidate.
    pub(super) fn last(&self) -> Option<usize> {
        self.candidates.last().map(|candidate| candidate.index)
    }

    /// Examines the next frame; returns whether it is a candidate.
    pub(super) fn examine(
        &mut self,
        seen: &Seen<'_>,
        layout: Layout,
        information: &mut MutualInformation,
    ) -> Result<bool, PlaneError> {
        let usual_bits = self.bits.median();
        if let Some(bits) = seen.mutual_bits {
            self.bits.push(bits);
        }
        self.changes.push(f64::from(seen.change_at_rest));
        let usual = self.changes.median().unwrap_or(0.0) as f32;
        self.calm = if seen.change_at_rest < CALM.max(1.5 * usual) {
            self.calm + 1
        } else {
            0
        };
        self.rest = if seen.change_at_rest < CALM {
            self.rest + 1
        } else {
            0
        };
        let Some(last) = self.candidates.last() else {
            self.take(seen, Reason::Shot, 1.0);
            return Ok(true);
        };
        let difference = at_rest(&self.anchor, seen.signature, layout);
        let (background, object) = (difference.background(layout), difference.object());
        let differs = |least: f32, value: f32| value > least.max(RATIO * usual);
        let apart = seen.time_seconds - last.time_seconds >= APART || seen.change > OTHER_SHOT;
        let reason = if differs(BACKGROUND, background) {
            Reason::Background
        } else {
            Reason::Action
        };
        let far = apart && (reason == Reason::Background || differs(OBJECT, object));
        let settled = self.unsettled
            && self.calm >= CALM_FRAMES
            && (background > SETTLED || object > SETTLED);
        // The last frames of a dissolve hardly differ from its end, which a shot needs.
        let settled = settled || (self.is_restless && self.rest >= REST_FRAMES);
        if !(far || settled || seen.forced) {
            return Ok(false);
        }
        let same = background.max(object) < SETTLED;
        let whole = information.compare(&self.luma, seen.luma)?;
        let mut new = novelty(whole, usual_bits, same);
        if reason == Reason::Action && object > SETTLED {
            // Most of the picture stands still, and hides what is new in the region of objects.
            if let Some([before, now]) = self.objects(seen, layout) {
                let inside = information.compare(before, now)?;
                let share = least_bits(inside) / least_bits(whole).max(EVEN_BITS);
                let usual_bits = usual_bits.map(|bits| bits * share);
                new = new.max(novelty(inside, usual_bits, false));
            }
        }
        self.take(seen, reason, new);
        Ok(true)
    }

    /// The region of objects in the last candidate and in a frame.
    fn objects<'a>(&'a self, seen: &'a Seen<'_>, layout: Layout) -> Option<[PlaneView<'a, u8>; 2]> {
        let inside = without_bars(&self.anchor, seen.signature)?;
        let place = layout.blocks().first()?.place;
        let range = |[from, to]: [usize; 2], [near, far]: [f32; 2], boxes: usize, side: usize| {
            let scale = side as f32 / boxes as f32;
            let at = |part: f32| (scale * (from as f32 + part * (to - from) as f32)) as usize;
            (at(near), at(far) - at(near))
        };
        let (boxes, luma) = (&self.anchor, seen.luma);
        let edges = ([inside.left, inside.right], [place.left, place.right]);
        let (left, width) = range(edges.0, edges.1, boxes.width(), luma.width());
        let edges = ([inside.top, inside.bottom], [place.top, place.bottom]);
        let (top, height) = range(edges.0, edges.1, boxes.height(), luma.height());
        let before = self.luma.view().part(left, top, width, height)?;
        let now = luma.part(left, top, width, height)?;
        (!now.is_empty()).then_some([before, now])
    }

    fn take(&mut self, seen: &Seen<'_>, reason: Reason, novelty: f64) {
        self.candidates.push(Candidate {
            index: seen.index,
            time_seconds: seen.time_seconds,
            reason,
            novelty,
            level: seen.level,
        });
        self.anchor = seen.signature.clone();
        self.luma = seen.luma.to_plane();
        self.unsettled = self.calm < CALM_FRAMES;
        self.is_restless = self.rest < REST_FRAMES;
    }

    /// The second stage: of the candidates that are neither blended, faded, flashes nor black, the
    /// first of each shot and those with enough that is new; `budget` keeps the first of each shot
    /// longest, and the others by what is new in them.
    pub(super) fn finish(
        self,
        transitions: &Transitions,
        shots: &[Shot],
        threshold: f64,
        budget: Option<usize>,
    ) -> Vec<KeyFrame> {
        let energy = |level: Level| level.mean.hypot(level.deviation);
        let levels = self
            .candidates
            .iter()
            .map(|candidate| energy(candidate.level));
        let dark = BLACK.max(BLACK_FRACTION * levels.fold(0.0, f32::max));
        let mut chosen: Vec<KeyFrame> = Vec::new();
        for Shot { frames, .. } in shots {
            let clear = self.candidates.iter().filter(|candidate| {
                frames.contains(&candidate.index)
                    && transitions.is_clear(candidate.index)
                    && energy(candidate.level) > dark
                    && !candidate.level.is_flat()
            });
            for (position, candidate) in clear.enumerate() {
                let reason = if position == 0 {
                    Reason::Shot
                } else {
                    candidate.reason
                };
                if position == 0 || candidate.novelty >= threshold {
                    chosen.push(KeyFrame {
                        index: candidate.index,
                        time_seconds: candidate.time_seconds,
                        reason,
                        score: candidate.novelty,
                    });
                }
            }
        }
        if let Some(budget) = budget {
            chosen.sort_by(|a, b| {
                let first = |key: &KeyFrame| key.reason == Reason::Shot;
                first(b).cmp(&first(a)).then(b.score.total_cmp(&a.score))
            });
            chosen.truncate(budget);
            chosen.sort_unstable_by_key(|key| key.index);
        }
        chosen
    }
}
