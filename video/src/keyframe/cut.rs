//! Hard cuts, by a rule that adapts to what is usual around each frame.

use super::difference::after_motion;
use super::layout::Layout;
use super::window::Window;
use ga_numerics::order_statistics::median;

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

/// The least number of frames of the first and of the last shot: fewer cannot be told from a flash.
const ENDS: usize = 2;

/// The least change of a cut.
const LEAST: f32 = 0.3;

/// The greatest number of frames of a flash.
const FLASH: usize = 3;

/// The nearest that two cuts may be, in frames.
const NEAREST: usize = 3;

/// The frames at which a new shot begins, found while changes come in.
///
/// The change of a frame is its [typical](super::difference::Difference::typical) difference from
/// the frame before it, after the motion of the camera and after the factor of brightness between
/// them: independent of contrast and brightness, of flicker, of bars, and of a caption or an object
/// in less than half of the blocks. A cut is a change of at least 0.3 that is three times the
/// median of the changes of the 8 frames before it and of the 8 after it, or by far outside of
/// their spread, and the greatest within two frames. Where a frame after it looks like one before
/// it, it is a flash. Measured settings of our own; Cui, §3.1.2, states a fixed threshold without
/// its value.
#[derive(Clone, Debug, Default)]
pub struct CutDetector {
    next: usize,
    suspects: Vec<(usize, f32)>,
    flashes: Vec<usize>,
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
            if changes[index] <= threshold(changes, index) {
                continue;
            }
            if is_flash(window, index, changes[index], layout) {
                self.flashes.push(index);
            } else if (ENDS..(changes.len() + 1).saturating_sub(ENDS)).contains(&index) {
                self.suspects.push((index, changes[index]));
            }
        }
        self.next = self.next.max(end);
    }

    /// The last frame so far that may begin a shot.
    #[must_use]
    pub fn last(&self) -> Option<usize> {
        self.suspects.last().map(|(index, _)| *index)
    }

    /// The frames with which a flash begins or ends.
    #[must_use]
    pub fn flashes(&self) -> &[usize] {
        &self.flashes
    }

    /// The cuts among the frames examined so far: of suspects that are nearer than three frames,
    /// the one with the greatest change.
    #[must_use]
    pub fn cuts(&self) -> Vec<usize> {
        let suspects = &self.suspects;
        let greatest = |(index, change): &&(usize, f32)| {
            let mut near = suspects
                .iter()
                .filter(|(other, _)| other.abs_diff(*index) < NEAREST && other != index);
            !near.any(|(other, more)| more > change || (more == change && other < index))
        };
        suspects
            .iter()
            .filter(greatest)
            .map(|(index, _)| *index)
            .collect()
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

/// Whether a frame after the change looks like one before it.
fn is_flash(window: &Window, index: usize, change: f32, layout: Layout) -> bool {
    let before = (1..=FLASH).filter_map(|back| window.get(index.checked_sub(back)?));
    for (back, a) in before.enumerate() {
        for forth in 0..FLASH {
            let Some(b) = window.get(index + forth) else {
                break;
            };
            let apart = back + forth;
            if (1..=FLASH).contains(&apart) && after_motion(a, b, layout).typical() < 0.4 * change {
                return true;
            }
        }
    }
    false
}
