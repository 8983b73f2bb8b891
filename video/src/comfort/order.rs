//! The parts of a video in each of which the order of the eyes is the same.

use std::collections::VecDeque;

use super::change::Changes;
use super::depth::{Continuity, Depth};
use super::stereoscopy::{Stereoscopy, StereoscopyMeter};

/// The frames of a part at which the order of the eyes is examined, until it is known, counted from
/// its first one; then the interval in frames.
const EXAMINED: [usize; 4] = [0, 4, 10, 20];
const EXAMINED_LATER: usize = 96;

/// A part that begins because its depth does not clearly continue is examined at its first frame
/// once in this number of frames on average, and up to [`AT_ONCE`] times in close succession: views
/// without much depth would otherwise be examined at each frame.
const FRAMES_EACH: usize = 24;
const AT_ONCE: usize = 4;

/// As many parts are kept as frames can wait for their record.
const PARTS: usize = 64;

/// The order of the eyes in each part of a video.
///
/// A part ends where the left view changes abruptly, as it does when the eyes are exchanged, where
/// either view is cut, and where the depth of a frame does not clearly continue that of the frame
/// before: what was found out of one frame of a part then holds for all of them. Where a part ends
/// without a cut, and depth clearly continues, or is clearly the opposite, the next part has the
/// same order or the other one, unless its own frames show something else.
#[derive(Debug)]
pub(super) struct Order {
    /// The number of frames so far.
    frames: usize,
    /// The number of the current part, and of its frames so far.
    part: usize,
    age: usize,
    run: usize,
    current: StereoscopyMeter,
    /// What the last frame shows.
    last: Depth,
    /// The order of the part before, and what follows from it for the current one.
    previous: Stereoscopy,
    inherited: (Stereoscopy, f64),
    /// Verdicts and evidence of the parts before it, from the part `first` on.
    before: VecDeque<Verdict>,
    first: usize,
    /// Frames without an examination of a part that was not clearly continued.
    credit: usize,
}

/// What is known of a part.
#[derive(Clone, Copy, Debug)]
struct Verdict {
    stereoscopy: Stereoscopy,
    evidence: f64,
    /// The number of its frames that were examined.
    examined: usize,
}

/// A frame among the parts.
#[derive(Debug)]
pub(super) struct Place {
    part: usize,
    /// The number of the run of frames within which the eyes cannot have been exchanged.
    pub(super) run: usize,
    depth: Depth,
    /// Whether the order of the eyes has to be examined in it.
    pub(super) is_due: bool,
    /// Whether the depth shows that the eyes are exchanged from this frame on.
    pub(super) is_exchange: bool,
}

impl Default for Order {
    fn default() -> Self {
        Self {
            frames: 0,
            part: 0,
            age: 0,
            run: 0,
            current: StereoscopyMeter::default(),
            last: Depth::default(),
            previous: Stereoscopy::Unknown,
            inherited: (Stereoscopy::Unknown, 0.0),
            before: VecDeque::new(),
            first: 0,
            credit: AT_ONCE * FRAMES_EACH,
        }
    }
}

impl Order {
    /// The number of frames so far.
    pub(super) fn frames(&self) -> usize {
        self.frames
    }

    /// The meter of the current part.
    pub(super) fn meter(&mut self) -> &mut StereoscopyMeter {
        &mut self.current
    }

    /// Takes the next frame.
    pub(super) fn begin_frame(&mut self, changes: Changes, depth: Depth) -> Place {
        let continuity = self.last.continuity(&depth);
        // Exchanged views change the left picture as well as the right one, and so does a cut. What
        // happens to the right one alone leaves the order as it is, unless depth says otherwise.
        let is_cut = changes.views.iter().any(|change| change.is_cut);
        let changes_abruptly = changes.views[0].is_abrupt || is_cut;
        let continues = continuity == Continuity::Same && !changes_abruptly;
        // Exchanged views change the left picture, and they turn depth around.
        let (is_clear, was_clear) = (depth.is_clear(), self.last.is_clear());
        let is_one_run = match continuity {
            Continuity::Same if is_clear && was_clear => !is_cut,
            Continuity::Same | Continuity::Unclear => !changes_abruptly,
            Continuity::Exchanged => false,
        };
        self.run += usize::from(!is_one_run);
        let mut is_free = true;
        self.credit = (self.credit + 1).min(AT_ONCE * FRAMES_EACH);
        if self.frames > 0 && !continues {
            if !changes_abruptly && continuity == Continuity::Unclear {
                is_free = self.credit >= FRAMES_EACH;
                self.credit -= if is_free { FRAMES_EACH } else { 0 };
            }
            let is_exchange = changes.is_exchange && continuity == Continuity::Exchanged;
            let is_known = (!is_cut || is_exchange) && self.last.is_clear() && depth.is_clear();
            self.begin_part(if is_known {
                continuity
            } else {
                Continuity::Unclear
            });
        }
        self.last = depth.clone();
        let age = self.age;
        self.frames += 1;
        self.age += 1;
        let is_time = EXAMINED.contains(&age) || (age > 0 && age.is_multiple_of(EXAMINED_LATER));
        let is_open = age == 0
            || matches!(
                self.current().stereoscopy,
                Stereoscopy::Unknown | Stereoscopy::Unrelated
            );
        Place {
            part: self.part,
            run: self.run,
            depth,
            is_due: is_time && is_open && (age > 0 || is_free),
            is_exchange: continuity == Continuity::Exchanged,
        }
    }

    fn begin_part(&mut self, continuity: Continuity) {
        let verdict = self.current();
        self.previous = verdict.stereoscopy;
        self.inherited = match (continuity, verdict.stereoscopy) {
            (Continuity::Same, Stereoscopy::InOrder | Stereoscopy::Exchanged) => {
                (verdict.stereoscopy, verdict.evidence)
            }
            (Continuity::Exchanged, Stereoscopy::InOrder) => {
                (Stereoscopy::Exchanged, -verdict.evidence)
            }
            (Continuity::Exchanged, Stereoscopy::Exchanged) => {
                (Stereoscopy::InOrder, -verdict.evidence)
            }
            _ => (Stereoscopy::Unknown, 0.0),
        };
        self.before.push_back(verdict);
        if self.before.len() > PARTS {
            self.before.pop_front();
            self.first += 1;
        }
        self.current = StereoscopyMeter::default();
        self.part += 1;
        self.age = 0;
    }

    /// Whether the first frame of a part has the opposite order of the part before.
    pub(super) fn begins_opposite(&self) -> bool {
        let orders = [self.previous, self.current().stereoscopy];
        self.age == 1
            && matches!(
                orders,
                [Stereoscopy::InOrder, Stereoscopy::Exchanged]
                    | [Stereoscopy::Exchanged, Stereoscopy::InOrder]
            )
    }

    /// What is known of the current part.
    fn current(&self) -> Verdict {
        let own = self.current.verdict();
        let (stereoscopy, evidence) = match own {
            Stereoscopy::Unknown => self.inherited,
            _ => (own, self.current.evidence()),
        };
        Verdict {
            stereoscopy,
            evidence,
            examined: self.current.frames(),
        }
    }

    /// The verdict on a frame, and the evidence for it.
    pub(super) fn verdict(&self, place: &Place) -> (Stereoscopy, f64) {
        let before = place.part.checked_sub(self.first);
        let before = before.and_then(|index| self.before.get(index));
        let verdict = before.copied().unwrap_or_else(|| self.current());
        let holds = match verdict.stereoscopy {
            Stereoscopy::InOrder | Stereoscopy::Exchanged => {
                // Without depth an exchange would not be noticed within the part.
                place.depth.is_clear() || (place.is_due && verdict.examined == 1)
            }
            Stereoscopy::Identical | Stereoscopy::Unrelated | Stereoscopy::Unknown => true,
        };
        match holds {
            true => (verdict.stereoscopy, verdict.evidence),
            false => (Stereoscopy::Unknown, 0.0),
        }
    }
}
