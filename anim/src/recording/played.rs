//! Recordings on a clock: again and again, faster and slower, elsewhere.

use ga_runtime::cga3::Motor;

use super::cycle::Cycle;
use super::{Recording, ScalarTrack};
use crate::clip::TimeWarp;
use crate::transform::Transform;

/// A recording as it is played in a [blend](super::blend_played). What is not said is as it was
/// recorded, and after its end it stays at its last frame.
#[derive(Clone, Debug)]
pub struct Played<'a> {
    recording: &'a Recording,
    cycle: Option<Cycle>,
    warp: Option<TimeWarp>,
    placed: Motor<f64>,
}

impl<'a> Played<'a> {
    /// A recording as it is.
    #[must_use]
    pub fn new(recording: &'a Recording) -> Self {
        Self {
            recording,
            cycle: None,
            warp: None,
            placed: Motor::default(),
        }
    }

    /// The recording that repeats a cycle of it from its end on.
    #[must_use]
    pub fn in_cycles(self, cycle: Cycle) -> Self {
        Self {
            cycle: Some(cycle),
            ..self
        }
    }

    /// The recording whose time is shown by a clock.
    #[must_use]
    pub fn by_clock(self, warp: TimeWarp) -> Self {
        Self {
            warp: Some(warp),
            ..self
        }
    }

    /// The recording moved as a whole.
    #[must_use]
    pub fn placed(self, placed: Motor<f64>) -> Self {
        Self { placed, ..self }
    }

    /// The recording.
    #[must_use]
    pub fn recording(&self) -> &'a Recording {
        self.recording
    }

    /// The time of the recording at a time.
    fn time(&self, time: f64) -> f64 {
        self.warp.as_ref().map_or(time, |warp| warp.clip_time(time))
    }

    /// The local transforms at a time, into one place for each joint.
    pub(super) fn fill(&self, time: f64, locals: &mut [Transform<f64>]) {
        let time = self.time(time);
        match &self.cycle {
            Some(cycle) => cycle.fill(self.recording, time, locals),
            None => self.recording.fill(self.recording.position(time), locals),
        }
        if self.placed != Motor::default() {
            let roots = locals.iter_mut().zip(&self.recording.parents);
            for (local, _) in roots.filter(|(_, parent)| parent.is_none()) {
                local.motor = self.placed * local.motor;
            }
        }
    }

    /// The value of a track of the recording at a time.
    pub(super) fn track_at(&self, track: &ScalarTrack, time: f64) -> f64 {
        let time = self.time(time);
        let time = self
            .cycle
            .as_ref()
            .map_or(time, |cycle| cycle.within(time).1);
        let position = self.recording.position(time);
        self.recording.track_at(track, position)
    }
}
