//! When the feet of a motion come down to the ground.

use ga_numerics::order_statistics::Sorted;
use ga_runtime::cga3::{Direction, Point, Rotor};
use ga_runtime::vga3::Vector;
use serde::Serialize;

use super::error::GaitProblem;
use super::foot::Foot;
use crate::recording::Recording;
use crate::retarget::Source;
use crate::retarget::body::Body;

/// As a part of the leg's length, how far a foot swings at least in a step.
const LEAST_SWING: f64 = 0.1;
/// As a part of the whole swing of a foot, by how much it swings back at least between two steps.
const TURN: f64 = 0.25;
/// As a part of the height to which an ankle is lifted in a step, how high above the ground it
/// comes down at most, and as a part of the greatest speed at which it sinks, how fast at most.
const DOWN: f64 = 0.15;
const STILL: f64 = 0.2;
/// Feet that come down within this time, in seconds, do so at once: no person runs faster.
const AT_ONCE: f64 = 0.1;
/// The time over which the speed of an ankle is measured, in seconds: a recording is noisy from
/// frame to frame.
const SPAN: f64 = 1.0 / 30.0;
/// As a part of the leg's length, how high an ankle is lifted at least for that to say when it
/// comes down.
const LEAST_LIFT: f64 = 0.02;

/// A foot comes down to the ground.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Footfall {
    /// Which foot.
    pub foot: Foot,
    /// When.
    pub time_seconds: f64,
}

/// The footfalls of a person's motion, in rising time.
///
/// In a step the ankle swings forwards relative to the hips and then stays behind (J. A. Zeni, J.
/// G. Richards and J. S. Higginson, "Two simple methods for determining gait events during
/// treadmill and overground walking using kinematic data", Gait & Posture 27, 2008); forwards is
/// across the line of the hips. So every step has one greatest swing forwards, on a treadmill too.
/// The foot comes down when the ankle, after it was lifted for that step, is near its lowest place
/// until it swings forwards again and sinks at less than a fifth of the greatest speed at which it
/// did.
///
/// A foot that is on the ground from the first frame on has not come down. Feet that come down
/// within a tenth of a second do so at once.
///
/// # Errors
///
/// [`GaitProblem::NoLegs`].
pub fn footfalls(recording: &Recording) -> Result<Vec<Footfall>, GaitProblem> {
    let paths = Paths::new(recording)?;
    let mut footfalls = Vec::new();
    for (side, foot) in [Foot::Left, Foot::Right].into_iter().enumerate() {
        let frames = paths.down(side).into_iter();
        footfalls.extend(frames.map(|frame| Footfall {
            foot,
            time_seconds: frame * recording.frame_time(),
        }));
    }
    footfalls.sort_by(|a, b| a.time_seconds.total_cmp(&b.time_seconds));
    Ok(at_once(&footfalls))
}

/// The footfalls in rising time, in which those of two feet that are close together are one.
fn at_once(footfalls: &[Footfall]) -> Vec<Footfall> {
    let mut all: Vec<Footfall> = Vec::with_capacity(footfalls.len());
    for &footfall in footfalls {
        match all.last_mut() {
            Some(last) if footfall.time_seconds - last.time_seconds < AT_ONCE => {
                if last.foot != footfall.foot {
                    last.foot = Foot::Both;
                }
            }
            _ => all.push(footfall),
        }
    }
    all
}

/// The vertical of a motion: the axis along which the head is above the feet, or y where no person
/// is known.
#[must_use]
pub fn vertical(recording: &Recording) -> Vector<f64> {
    let upright = Body::of(recording).map(|body| body.to_y_up(recording));
    direction_up(upright.unwrap_or_default())
}

/// What a rotation makes the y axis.
fn direction_up(upright: Rotor<f64>) -> Vector<f64> {
    let up = Direction::from(Vector::new(0.0, 1.0, 0.0));
    upright.reverse().transform(up).into()
}

/// Where hips and ankles are, with y up.
pub(super) struct Paths {
    /// The rotation that makes the vertical the y axis.
    pub(super) upright: Rotor<f64>,
    /// The middle of the hips in every frame.
    pub(super) middle: Vec<Vector<f64>>,
    /// The direction forwards in every frame, horizontal and of length 1 where it has one.
    pub(super) forwards: Vec<Vector<f64>>,
    /// The time from one frame to the next, in seconds.
    pub(super) frame_time: f64,
    ankles: [Vec<Vector<f64>>; 2],
    leg: f64,
}

impl Paths {
    pub(super) fn new(recording: &Recording) -> Result<Self, GaitProblem> {
        let body = Body::of(recording).ok_or(GaitProblem::NoLegs)?;
        let leg = body.leg_length(recording).ok_or(GaitProblem::NoLegs)?;
        let upright = body.to_y_up(recording);
        let mut paths = Self {
            upright,
            middle: Vec::new(),
            forwards: Vec::new(),
            frame_time: recording.frame_time(),
            ankles: [Vec::new(), Vec::new()],
            leg,
        };
        let up = Vector::new(0.0, 1.0, 0.0);
        for frame in 0..recording.frame_count() {
            let Some(frames) = recording.frames_of_joints(frame) else {
                break;
            };
            let place = |joint: usize| -> Vector<f64> {
                let place = frames[joint].transform(Point::default());
                upright.transform(place).into()
            };
            let [left, right] = body.legs.map(|[hip, _, _]| place(hip));
            let across = left - right;
            let across = Vector::new(across.e1, 0.0, across.e3);
            paths.middle.push((left + right) * 0.5);
            let forwards = across.cross(up).normalized();
            paths.forwards.push(forwards.unwrap_or_default());
            for (list, [_, _, ankle]) in paths.ankles.iter_mut().zip(body.legs) {
                list.push(place(ankle));
            }
        }
        Ok(paths)
    }

    /// The vertical of the recording.
    pub(super) fn up(&self) -> Vector<f64> {
        direction_up(self.upright)
    }

    /// When a foot comes down, in frames.
    fn down(&self, side: usize) -> Vec<f64> {
        let ankles = &self.ankles[side];
        let swing: Vec<f64> = (0..ankles.len())
            .map(|frame| (ankles[frame] - self.middle[frame]).dot(self.forwards[frame]))
            .collect();
        let sorted = &mut swing.clone();
        let Some(range) =
            Sorted::new(sorted).map(|sorted| sorted.quantile(0.95) - sorted.quantile(0.05))
        else {
            return Vec::new();
        };
        if range < LEAST_SWING * self.leg {
            return Vec::new();
        }
        let turns = turns(&swing, TURN * range);
        let height = |frame: usize| ankles[frame].e2;
        let half = (0.5 * SPAN / self.frame_time).round().max(1.0) as usize;
        let sinks = |frame: usize| {
            let (begin, end) = (frame.saturating_sub(half), frame + half);
            let end = end.min(ankles.len() - 1);
            (height(begin) - height(end)) / (end - begin).max(1) as f64
        };
        let lowest = |frames: std::ops::RangeInclusive<usize>| {
            frames.map(height).fold(f64::INFINITY, f64::min)
        };
        let mut down = Vec::new();
        for (place, turn) in turns.iter().enumerate() {
            let Turn::Forwards(front) = *turn else {
                continue;
            };
            let before = place.checked_sub(1).map_or(0, |place| turns[place].frame());
            let after = turns.get(place + 1).map_or(ankles.len() - 1, Turn::frame);
            let by_height = |a: &usize, b: &usize| height(*a).total_cmp(&height(*b));
            let Some(top) = (before..=front).max_by(by_height) else {
                continue;
            };
            let ground = lowest(front..=after);
            let lift = height(top) - ground;
            if lift < LEAST_LIFT * self.leg {
                // Without a swing before it, the foot was in front from the beginning.
                if place > 0 {
                    down.push(front as f64);
                }
                continue;
            }
            let sinking: Vec<f64> = (top..=after).map(sinks).collect();
            let fastest = sinking.iter().copied().fold(0.0, f64::max);
            let slow = STILL * fastest;
            let is_down =
                |&k: &usize| height(top + k) <= ground + DOWN * lift && sinking[k] <= slow;
            let first = (1..sinking.len()).find(is_down);
            down.extend(first.map(|k| {
                let [before, now] = [sinking[k - 1], sinking[k]];
                let part = match before > slow {
                    true => (before - slow) / (before - now),
                    false => 1.0,
                };
                (top + k - 1) as f64 + part
            }));
        }
        down
    }
}

/// Where a swing turns.
#[derive(Clone, Copy, Debug)]
enum Turn {
    /// From forwards to backwards, at a greatest value.
    Forwards(usize),
    /// From backwards to forwards, at a least one.
    Backwards(usize),
}

impl Turn {
    fn frame(&self) -> usize {
        match *self {
            Self::Forwards(frame) | Self::Backwards(frame) => frame,
        }
    }
}

/// Where numbers turn by at least `least`; one after the other is of the other kind.
fn turns(numbers: &[f64], least: f64) -> Vec<Turn> {
    let mut turns = Vec::new();
    let (mut highest, mut lowest) = (0, 0);
    // Whether the way since the last turn goes up; unknown at the beginning.
    let mut goes_up = None;
    for (index, &number) in numbers.iter().enumerate() {
        if number > numbers[highest] {
            highest = index;
        }
        if number < numbers[lowest] {
            lowest = index;
        }
        if goes_up != Some(false) && numbers[highest] - number >= least {
            // What begins with its greatest value has not turned there.
            if highest > 0 {
                turns.push(Turn::Forwards(highest));
            }
            goes_up = Some(false);
            lowest = index;
        } else if goes_up != Some(true) && number - numbers[lowest] >= least {
            if lowest > 0 {
                turns.push(Turn::Backwards(lowest));
            }
            goes_up = Some(true);
            highest = index;
        }
    }
    turns
}

#[cfg(test)]
mod tests {
    use super::{Turn, turns};

    #[test]
    fn turns_are_greatest_and_least_values_without_noise() {
        let numbers = [0.0, 1.0, 0.9, 2.0, 1.0, -1.0, -0.9, -1.1, 0.0, 1.0];
        let found = turns(&numbers, 0.5);
        assert!(
            matches!(found[..], [Turn::Forwards(3), Turn::Backwards(7)]),
            "{found:?}"
        );
    }
}
