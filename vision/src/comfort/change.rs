//! Where a view changes abruptly.

use std::collections::VecDeque;

use ga_image::plane::Plane;
use ga_image::ycbcr::YCbCr;

use crate::keyframe::difference::{after_motion, at_rest};
use crate::keyframe::layout::Layout;
use crate::keyframe::signature;
use crate::video::Samples;

/// So many frames before a frame say what change is usual.
const BEFORE: usize = 8;

/// An abrupt change is so many times the usual one, to which the change of a still picture is
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

/// Compares each frame of one view with the frame before it.
///
/// The differences are those by which [key frames](crate::keyframe) are found. In contrast to cuts
/// found there, no later frames are needed, so that a flash counts as two cuts.
#[derive(Debug, Default)]
pub(super) struct ChangeDetector {
    previous: Option<Plane<f32>>,
    /// Changes at rest and after motion of the last frames.
    usual: VecDeque<[f32; 2]>,
}

impl ChangeDetector {
    pub(super) fn push(&mut self, samples: &Samples, colours: YCbCr) -> Change {
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
