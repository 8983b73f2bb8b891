//! The moments of a motion that are shown: key frames, and three in-betweens from each to the next,
//! as in Cui, figs 7 and 8.

use ga_anim::character::Character;
use ga_anim::clip::Clip;
use ga_anim::pose::Pose;
use ga_anim::skeleton::SkeletonError;
use ga_render::sheet::Kind;
use ga_runtime::vga3::Vector;

/// Rows of the sheet of a recording, each from one key frame to the next.
const ROWS: usize = 4;

/// Steps from a key frame to the next, one more than there are in-betweens.
pub const STEPS: usize = 4;

/// The usual time between the key poses of a walk in seconds, also used between recorded frames
/// taken as keys.
const KEY_INTERVAL: f64 = 0.135;

/// A moment to be shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Moment {
    /// The number that stands in its caption.
    pub number: usize,
    /// Seconds from the beginning of the clip.
    pub time: f64,
    /// Whether it is a frame of the clip or between two of them.
    pub kind: Kind,
    /// The pose at that moment.
    pub pose: Pose,
}

/// The moments in rows of `columns`.
#[derive(Clone, Debug, PartialEq)]
pub struct Storyboard {
    /// Row by row.
    pub moments: Vec<Moment>,
    /// How many moments a row has.
    pub columns: usize,
}

/// How the captions number the frames of a clip.
#[derive(Clone, Copy)]
struct Numbering {
    /// The number of the clip's first frame.
    first: usize,
    /// What is counted from one frame of the clip to the next.
    per_frame: usize,
}

impl Storyboard {
    /// The first rows of a clip whose frames are all key frames, at most this many. In-betweens are
    /// counted as frames: the second key frame has the number [`STEPS`].
    #[must_use]
    pub fn of_keys(clip: &Clip, rows: usize) -> Self {
        let numbering = Numbering {
            first: 0,
            per_frame: STEPS,
        };
        Self::new(clip, &spans_of_keys(clip, rows), numbering)
    }

    /// Four rows of a recording whose first frame has this number, fewer of one with few frames:
    /// one after the other where they fill it, else evenly spread over it. Their length is a
    /// multiple of four frames where it can be, so that in-betweens fall on recorded frames.
    #[must_use]
    pub fn of_recording(clip: &Clip, first: usize) -> Self {
        let numbering = Numbering {
            first,
            per_frame: 1,
        };
        Self::new(clip, &spans_of_recording(clip), numbering)
    }

    /// The rows of a clip for `spans` of its frames, each the first and the last of a row.
    /// In-betweens are found from these two alone, along the screw from one to the other.
    fn new(clip: &Clip, spans: &[[usize; 2]], numbering: Numbering) -> Self {
        let frames = clip.frames();
        let mut moments = Vec::new();
        let mut columns = 1;
        for &[from, to] in spans {
            let last = if from == to { 0 } else { STEPS };
            columns = last + 1;
            for step in 0..=last {
                let part = step as f64 / STEPS as f64;
                let frame = from as f64 + part * (to - from) as f64;
                let (kind, pose) = match step {
                    0 => (Kind::Key, frames[from].clone()),
                    STEPS => (Kind::Key, frames[to].clone()),
                    _ => (
                        Kind::InBetween { step, steps: STEPS },
                        frames[from].interpolate(&frames[to], part),
                    ),
                };
                moments.push(Moment {
                    number: numbering.first + (frame * numbering.per_frame as f64).round() as usize,
                    time: frame * clip.frame_time(),
                    kind,
                    pose,
                });
            }
        }
        Self { moments, columns }
    }

    /// The greatest distance of a joint at any moment from its position in the recording at that
    /// time.
    ///
    /// # Errors
    ///
    /// [`SkeletonError`] for a recording of another skeleton.
    pub fn deviation(&self, character: &Character, recorded: &Clip) -> Result<f64, SkeletonError> {
        let mut greatest = 0.0f64;
        for moment in &self.moments {
            let found = character.joints(&moment.pose)?;
            let truth = character.joints(&recorded.sample(moment.time))?;
            let pairs = found.into_iter().zip(truth);
            let distances = pairs.map(|(a, b)| Vector::from(a).distance(b.into()));
            greatest = distances.fold(greatest, f64::max);
        }
        Ok(greatest)
    }
}

/// The rows from key frame to key frame, at most this many.
fn spans_of_keys(clip: &Clip, rows: usize) -> Vec<[usize; 2]> {
    let last = clip.frames().len() - 1;
    match last {
        0 => vec![[0, 0]],
        _ => (0..last.min(rows)).map(|key| [key, key + 1]).collect(),
    }
}

/// The rows of [`Storyboard::of_recording`].
fn spans_of_recording(clip: &Clip) -> Vec<[usize; 2]> {
    let last = clip.frames().len() - 1;
    let fours = (KEY_INTERVAL / clip.frame_time() / STEPS as f64).round();
    let long = (fours as usize).clamp(1, last.max(STEPS)) * STEPS;
    if last == 0 {
        vec![[0, 0]]
    } else if last < ROWS * long {
        let rows = last.min(ROWS);
        let length = last / rows;
        (0..rows)
            .map(|row| [row * length, (row + 1) * length])
            .collect()
    } else {
        let begin = |row: usize| row * (last - long) / (ROWS - 1);
        (0..ROWS)
            .map(|row| [begin(row), begin(row) + long])
            .collect()
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test may panic")]
mod tests {
    use super::*;

    fn still(frames: usize, rate: f64) -> Clip {
        Clip::new(1.0 / rate, vec![Pose::rest(1); frames]).unwrap()
    }

    #[test]
    fn a_long_recording_is_shown_at_its_beginning_and_its_end() {
        assert_eq!(
            spans_of_recording(&still(1001, 120.0)),
            [[0, 16], [328, 344], [656, 672], [984, 1000]]
        );
    }

    #[test]
    fn a_short_recording_is_shown_whole() {
        assert_eq!(
            spans_of_recording(&still(41, 120.0)),
            [[0, 10], [10, 20], [20, 30], [30, 40]]
        );
        assert_eq!(spans_of_recording(&still(3, 120.0)), [[0, 1], [1, 2]]);
        assert_eq!(spans_of_recording(&still(1, 120.0)), [[0, 0]]);
    }

    #[test]
    fn rows_stay_inside_at_any_rate_and_length() {
        for rate in [1e-3, 1.0, 24.0, 30.0, 59.94, 120.0, 1e9] {
            for frames in 1..200 {
                for [from, to] in spans_of_recording(&still(frames, rate)) {
                    assert!(from <= to && to < frames, "{frames} frames at {rate} Hz");
                    assert!(from < to || frames == 1);
                }
            }
        }
    }

    #[test]
    fn in_betweens_are_counted_between_their_keys() {
        let clip = still(5, 10.0);
        let board = Storyboard::of_keys(&clip, 3);
        let numbers: Vec<usize> = board.moments.iter().map(|moment| moment.number).collect();
        assert_eq!(numbers[..10], [0, 1, 2, 3, 4, 4, 5, 6, 7, 8]);
        assert_eq!(numbers.len(), 15);
        assert_eq!(board.moments[3].kind, Kind::InBetween { step: 3, steps: 4 });
        assert!((board.moments[3].time - 0.075).abs() < 1e-15);
    }
}
