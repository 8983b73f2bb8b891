//! Where a view changes abruptly.

use std::collections::VecDeque;

use ga_image::plane::Plane;
use ga_image::ycbcr::YCbCr;

use crate::Samples;
use crate::keyframe::difference::{after_motion, at_rest};
use crate::keyframe::layout::Layout;
use crate::keyframe::signature;

/// The number of frames before a frame that say what change is usual.
const BEFORE: usize = 8;

/// An abrupt change is this multiple of the usual one, to which the change of a still picture is
/// added.
const RATIO: f32 = 3.0;
const STILL: f32 = 0.02;

/// The least change that is abrupt, and the least one after the motion of the camera that begins a
/// shot.
const LEAST_ABRUPT: f32 = 0.06;
const LEAST_CUT: f32 = 0.3;

/// How a view changed from the frame before.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Change {
    /// Another picture begins, or the same one in another place.
    pub(super) is_abrupt: bool,
    /// A new shot begins.
    pub(super) is_cut: bool,
}

/// How much less the views of a frame differ from those of the frame before if they are exchanged
/// than if they are not, at least.
const EXCHANGED: f32 = 0.5;

/// How both views changed from the frame before.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Changes {
    pub(super) views: [Change; 2],
    /// Each view continues what the other one showed. It is examined at cuts only, for which great
    /// parallax is mistaken.
    pub(super) is_exchange: bool,
}

/// Compares both views of each frame with those of the frame before it.
#[derive(Debug, Default)]
pub(super) struct PairDetector {
    views: [ChangeDetector; 2],
}

impl PairDetector {
    pub(super) fn push(&mut self, views: [&Samples; 2], colours: YCbCr) -> Changes {
        let before = self.views.each_ref().map(|view| view.previous.clone());
        let [left, right] = &mut self.views;
        let changes = [left.push(views[0], colours), right.push(views[1], colours)];
        let now = self.views.each_ref().map(|view| view.previous.as_ref());
        let is_exchange = match (before, now) {
            ([Some(a), Some(b)], [Some(left), Some(right)])
                if changes.iter().any(|change| change.is_cut) =>
            {
                let change = |a, b| at_rest(a, b, Layout::Five).typical();
                change(&b, left) < EXCHANGED * change(&a, left)
                    && change(&a, right) < EXCHANGED * change(&b, right)
            }
            _ => false,
        };
        Changes {
            views: changes,
            is_exchange,
        }
    }
}

/// Compares each frame of one view with the frame before it.
///
/// The differences are those by which [key frames](crate::keyframe) are found. In contrast to cuts
/// found there, no later frames are needed, so that a flash counts as two cuts.
#[derive(Debug, Default)]
struct ChangeDetector {
    previous: Option<Plane<f32>>,
    /// Changes at rest and after motion of the last frames.
    usual: VecDeque<[f32; 2]>,
}

impl ChangeDetector {
    fn push(&mut self, samples: &Samples, colours: YCbCr) -> Change {
        let now = signature::red(samples, colours);
        let Some(before) = self.previous.replace(now.clone()) else {
            return Change::default();
        };
        let rest = at_rest(&before, &now, Layout::Five).typical();
        let moved = after_motion(&before, &now, Layout::Five).typical();
        let exceeds = |index: usize, change: f32, least: f32| {
            let mut usual: Vec<f32> = self.usual.iter().map(|changes| changes[index]).collect();
            usual.sort_unstable_by(f32::total_cmp);
            let usual = usual
                .get(usual.len().saturating_sub(1) / 2)
                .copied()
                .unwrap_or(0.0);
            change > least.max(RATIO * (usual + STILL))
        };
        let change = Change {
            is_abrupt: exceeds(0, rest, LEAST_ABRUPT),
            is_cut: exceeds(1, moved, LEAST_CUT),
        };
        if self.usual.len() == BEFORE {
            self.usual.pop_front();
        }
        self.usual.push_back([rest, moved]);
        change
    }
}
