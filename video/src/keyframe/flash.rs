//! A few frames that differ from those around them: flashes of light, and stray shots.

use std::ops::Range;

use serde::Serialize;

use super::blend::Ends;
use super::difference::{after_motion, moments};
use super::layout::{Layout, Rectangle};
use super::likeness::{is_brighter, is_one_scene};
use super::window::Window;

/// The greatest number of frames of a flash, and of a stray shot.
const FLASH: usize = 3;
pub(super) const STRAY: usize = 2;

/// The greatest change between the frames around a flash, relative to that at its beginning.
const SAME: f32 = 0.4;

/// The standard deviation of a frame without a picture, at most.
const FLAT: f32 = 2.0;

/// The greatest part of a picture that a blend of the frames around it does not explain.
const RESIDUAL: f32 = 0.4;

/// A few frames that differ from those around them.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Flash {
    /// These frames, half-open.
    #[serde(flatten)]
    pub frames: Range<usize>,
    /// What they are.
    pub kind: Kind,
}

/// What a few frames are that differ from those around them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// The scene beside them in brighter light, or no picture: at most three frames, and no shot.
    Flash,
    /// Another scene for one frame or two, as an error of editing leaves it: a shot between cuts.
    StrayShot,
}

impl Kind {
    /// `flash` or `stray shot`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Flash => "flash",
            Self::StrayShot => "stray shot",
        }
    }
}

/// The frames around a change of which the first one after them looks like the last one before
/// them.
pub(super) fn between(
    index: usize,
    change: f32,
    window: &Window,
    layout: Layout,
) -> Option<Range<usize>> {
    let ranges = (1..=FLASH).flat_map(|length| {
        (0..=length).filter_map(move |back| Some(index.checked_sub(back)?..index - back + length))
    });
    ranges.into_iter().find(|frames| {
        let before = frames
            .start
            .checked_sub(1)
            .and_then(|frame| window.get(frame));
        let ends = before.zip(window.get(frames.end));
        ends.is_some_and(|(a, b)| after_motion(a, b, layout).typical() < SAME * change)
    })
}

/// What a few frames are between the two frames `beside`.
pub(super) fn kind(
    beside: [usize; 2],
    frames: &Range<usize>,
    window: &Window,
    layout: Layout,
) -> Kind {
    let lit = |frame: usize| {
        let Some(picture) = window.get(frame) else {
            return false;
        };
        let [_, deviation] = moments(picture, Rectangle::of(picture));
        let beside = beside.iter().filter_map(|frame| window.get(*frame));
        let mut scenes = beside.map(|scene| {
            is_brighter(scene, picture)
                || is_one_scene(scene, picture)
                || after_motion(scene, picture, layout).typical() < 0.3
        });
        deviation < FLAT || scenes.any(|is_lit| is_lit)
    };
    match frames.len() > STRAY || frames.clone().any(lit) {
        true => Kind::Flash,
        false => Kind::StrayShot,
    }
}

/// Whether some of the frames are blends of those around them, as where the rate was converted.
pub(super) fn is_blend(
    beside: [usize; 2],
    frames: &Range<usize>,
    window: &Window,
    layout: Layout,
) -> bool {
    let Some(ends) = Ends::new(beside, window, layout) else {
        return false;
    };
    let mut pictures = frames
        .clone()
        .filter_map(|frame| Some((frame, window.get(frame)?)));
    pictures.any(|(frame, picture)| {
        let blend = ends.blend(picture, frame);
        (0.1..0.9).contains(&blend.fraction) && blend.residual < RESIDUAL
    })
}
