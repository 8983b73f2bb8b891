//! Hard cuts, by a rule that adapts to what is usual around each frame.

use std::ops::Range;

use ga_numerics::order_statistics::median;

use super::flash::{self, Flash, Kind, STRAY};
use super::layout::Layout;
use super::likeness::is_one_scene;
use super::window::Window;

/// The number of frames before a frame, and after it, that say what change is usual there.
pub const AROUND: usize = 8;

/// The least ratio of a cut to the usual change.
const RATIO: f32 = 3.0;

/// What is added to the usual change, so that the change of a still picture is not zero.
pub(super) const STILL: f32 = 0.04;

/// A cut also counts where it exceeds the usual change by this much, and by this multiple of
/// the median deviation from it.
const STEADY: f32 = 0.15;
const SPREADS: f32 = 9.0;

/// The least change of a cut.
const LEAST: f32 = 0.3;

/// The nearest that two cuts may be, in frames, unless there is a stray shot between them.
const NEAREST: usize = 3;

/// The frames at which a new shot begins, found while changes come in.
///
/// The change of a frame is its [typical](super::difference::Difference::typical) difference from
/// the frame before it, after the motion of the camera and after the factor of brightness between
/// them: independent of contrast and brightness, of flicker, of bars, and of a caption or an object
/// in less than half of the blocks. A cut is a change of at least 0.3 that is three times the
/// median of the changes of the 8 frames before it and of the 8 after it, or by far outside of
/// their spread. Where both frames show one scene, behind an object or in other light, there is no
/// cut; a few frames between two changes are a [`Flash`] or a shot. Measured settings of our own;
/// Cui, §3.1.2, states a fixed threshold without its value.
#[derive(Clone, Debug, Default)]
pub struct CutDetector {
    next: usize,
    suspects: Vec<Suspect>,
    flashes: Vec<Flash>,
}

/// A frame that may begin a shot.
#[derive(Clone, Copy, Debug)]
struct Suspect {
    index: usize,
    change: f32,
    /// Whether the frames since the suspect before are a shot, however few they are.
    is_apart: bool,
}

impl CutDetector {
    /// Examines the frames for which enough later frames are known; `at_end` says that no more
    /// come. `changes[i]` is the change from frame i − 1 to frame i.
    pub fn advance(&mut self, changes: &[f32], window: &Window, layout: Layout, at_end: bool) {
        let end = match at_end {
            true => changes.len(),
            false => changes.len().saturating_sub(AROUND),
        };
        for index in self.next.max(1)..end {
            if changes[index] > threshold(changes, index) {
                self.examine(index, changes, window, layout);
            }
        }
        self.next = self.next.max(end);
    }

    fn examine(&mut self, index: usize, changes: &[f32], window: &Window, layout: Layout) {
        let change = changes[index];
        let mut suspect = Suspect {
            index,
            change,
            is_apart: false,
        };
        if let Some(frames) = flash::between(index, change, window, layout) {
            let kind = flash::kind([frames.start - 1, frames.end], &frames, window, layout);
            if kind == Kind::StrayShot {
                suspect.is_apart = true;
                self.suspects.push(suspect);
            }
            self.report(frames, kind);
            return;
        }
        let [before, now] = [index - 1, index].map(|frame| window.get(frame));
        if before.zip(now).is_some_and(|(a, b)| is_one_scene(a, b)) {
            return;
        }
        // The first frames, and the last ones, have a shot on one side only.
        for (frames, neighbour) in [(0..index, index), (index..changes.len(), index - 1)] {
            if frames.len() <= STRAY {
                let kind = flash::kind([neighbour; 2], &frames, window, layout);
                self.report(frames, kind);
                if kind == Kind::Flash {
                    return;
                }
            }
        }
        let last = self.suspects.last().copied();
        if let Some(last) = last.filter(|last| index - last.index < NEAREST && !last.is_apart) {
            let frames = last.index..index;
            let kind = flash::kind([last.index - 1, index], &frames, window, layout);
            suspect.is_apart = kind == Kind::StrayShot;
            if !flash::is_blend([last.index - 1, index], &frames, window, layout) {
                self.report(frames, kind);
            } else {
                suspect.is_apart = false;
            }
        }
        self.suspects.push(suspect);
    }

    fn report(&mut self, frames: Range<usize>, kind: Kind) {
        if self
            .flashes
            .last()
            .is_none_or(|flash| flash.frames.end <= frames.start)
        {
            self.flashes.push(Flash { frames, kind });
        }
    }

    /// The last frame so far that may begin a shot.
    #[must_use]
    pub fn last(&self) -> Option<usize> {
        self.suspects.last().map(|suspect| suspect.index)
    }

    /// The flashes and stray shots among the frames examined so far.
    #[must_use]
    pub fn flashes(&self) -> &[Flash] {
        &self.flashes
    }

    /// The cuts among the frames examined so far: of suspects that are nearer than three frames,
    /// the one with the greatest change, unless there is a shot between them.
    #[must_use]
    pub fn cuts(&self) -> Vec<usize> {
        let suspects = &self.suspects;
        let groups = suspects.chunk_by(|a, b| b.index - a.index < NEAREST && !b.is_apart);
        let greatest = |group: &[Suspect]| {
            let greatest = group
                .iter()
                .rev()
                .max_by(|a, b| a.change.total_cmp(&b.change));
            greatest.map(|suspect| suspect.index)
        };
        groups.filter_map(greatest).collect()
    }
}

/// The change that a frame has to exceed in order to begin a shot: that of the 8 frames before it
/// and that of the 8 after it, whichever is greater.
#[must_use]
pub fn threshold(changes: &[f32], index: usize) -> f32 {
    let before = index.saturating_sub(AROUND).max(1)..index;
    let after = index + 1..(index + AROUND + 1).min(changes.len());
    [before, after]
        .into_iter()
        .map(|frames| exceptional(changes.get(frames).unwrap_or_default()))
        .fold(LEAST, f32::max)
}

/// The change that is exceptional beside others: three times the usual one; where changes are
/// steady, as noise makes them, less is enough.
pub(crate) fn exceptional(changes: &[f32]) -> f32 {
    let middle = usual(changes.to_vec());
    let spread = usual(
        changes
            .iter()
            .map(|change| (change - middle).abs())
            .collect(),
    );
    (RATIO * (middle + STILL)).min(middle + SPREADS * spread + STEADY)
}

/// The median; 0 of no values.
pub(super) fn usual(mut values: Vec<f32>) -> f32 {
    median(&mut values).unwrap_or(0.0)
}
