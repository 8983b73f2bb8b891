//! Motions in step.

use ga_runtime::cga3::{Motor, Rotor, Translator};
use ga_runtime::vga3::Vector;

use super::error::{GaitError, GaitProblem};
use super::footfalls::{Footfall, Paths, footfalls};
use crate::clip::TimeWarp;
use crate::recording::{Cycle, Played, Recording, Seam};

/// Motions whose footfalls coincide, from the first that all of them have.
///
/// The first footfall of the first motion begins; every other motion begins with its first footfall
/// of the same foot, at the same place and in the same direction on the ground. A step lasts the
/// mean by weights of what it lasts in the motions, and within it each motion runs on a clock of
/// its own ([`TimeWarp`]).
#[derive(Clone, Debug)]
pub struct Aligned<'a> {
    /// The motions as they are played, with their weights.
    pub played: Vec<(Played<'a>, f64)>,
    /// From the first footfall to the last, in seconds.
    pub duration_seconds: f64,
    /// When feet come down.
    pub footfalls: Vec<Footfall>,
    /// What was done with each motion; `None` for one with a weight of 0.
    pub in_step: Vec<Option<InStep>>,
}

/// How a motion was brought in step.
#[derive(Clone, Debug, PartialEq)]
pub struct InStep {
    /// Its footfalls, in its own time.
    pub footfalls: Vec<Footfall>,
    /// Its first and its last moment that are played, in its own time.
    pub times: [f64; 2],
    /// What is left between the end and the begin of what is repeated; `None` where nothing is.
    pub seam: Option<Seam>,
}

impl<'a> Aligned<'a> {
    /// Brings motions in step. Those with a weight of 0 are not looked at. Where `is_looped`, those
    /// with fewer steps than another repeat their whole strides; otherwise there are as many steps
    /// as all of them have.
    ///
    /// # Errors
    ///
    /// [`GaitError`] for the motion whose steps are not known, are too few, or are not made with
    /// the feet in the order of the first motion.
    pub fn new(motions: &[(&'a Recording, f64)], is_looped: bool) -> Result<Self, GaitError> {
        let mut steps: Vec<Steps> = Vec::new();
        for (motion, &(recording, weight)) in motions.iter().enumerate() {
            if weight > 0.0 {
                let found = Steps::new(recording, weight, steps.first(), is_looped);
                steps.push(found.map_err(|problem| GaitError { motion, problem })?);
            }
        }
        let counts = steps.iter().map(Steps::available);
        let count = match is_looped {
            true => counts.max(),
            false => counts.min(),
        };
        let count = count.unwrap_or(0);
        let sum: f64 = steps.iter().map(|steps| steps.weight).sum();
        let seen = |index: usize| -> f64 {
            let times = steps.iter().map(|steps| {
                let time = |index| steps.at(index, count).time_seconds;
                steps.weight / sum * (time(index) - time(0))
            });
            times.sum()
        };
        let seen: Vec<f64> = (0..count).map(seen).collect();
        let (mut played, mut in_step) = (Vec::new(), Vec::new());
        let mut known = steps.iter();
        for (motion, &(recording, weight)) in motions.iter().enumerate() {
            if weight > 0.0
                && let (Some(steps), Some(first)) = (known.next(), steps.first())
            {
                let found = steps.played(recording, &seen, first);
                let (on_clock, found) = found.map_err(|problem| GaitError { motion, problem })?;
                played.push((on_clock, weight));
                in_step.push(Some(found));
            } else {
                played.push((Played::new(recording), weight));
                in_step.push(None);
            }
        }
        let foot = |index: usize| steps.first().map(|steps| steps.at(index, count).foot);
        let footfalls = seen.iter().enumerate();
        let footfalls = footfalls.filter_map(|(index, &time_seconds)| {
            Some(Footfall {
                foot: foot(index)?,
                time_seconds,
            })
        });
        Ok(Self {
            footfalls: footfalls.collect(),
            duration_seconds: seen.last().copied().unwrap_or(0.0),
            played,
            in_step,
        })
    }
}

/// The steps of a motion from the first that counts.
struct Steps {
    footfalls: Vec<Footfall>,
    paths: Paths,
    weight: f64,
    /// Where in the list the first one is.
    first: usize,
    /// How many steps are repeated: from a foot to the last footfall of the same one.
    cycle: usize,
}

impl Steps {
    fn new(
        recording: &Recording,
        weight: f64,
        of_first: Option<&Self>,
        is_looped: bool,
    ) -> Result<Self, GaitProblem> {
        let footfalls = footfalls(recording)?;
        let paths = Paths::new(recording)?;
        if of_first.is_some_and(|first| first.paths.upright != paths.upright) {
            return Err(GaitProblem::Vertical);
        }
        let foot = match of_first {
            Some(first) => Some(first.footfalls[first.first].foot),
            None => footfalls.first().map(|footfall| footfall.foot),
        };
        let is_it = |footfall: &Footfall| Some(footfall.foot) == foot;
        let first = footfalls.iter().position(is_it).unwrap_or(footfalls.len());
        let last = footfalls.iter().rposition(is_it).unwrap_or(first);
        let (found, needed) = (footfalls.len() - first, if is_looped { 3 } else { 2 });
        let cycle = last - first;
        if found < needed || (is_looped && cycle < 2) {
            return Err(GaitProblem::TooFewSteps { found, needed });
        }
        Ok(Self {
            footfalls,
            paths,
            weight,
            first,
            cycle,
        })
    }

    /// How many steps there are without a repetition.
    fn available(&self) -> usize {
        self.footfalls.len() - self.first
    }

    /// How long a repetition is, in seconds.
    fn period(&self) -> f64 {
        let time = |index: usize| self.footfalls[self.first + index].time_seconds;
        time(self.cycle) - time(0)
    }

    /// The step of a number, of `count` that are needed, as it is in the motion, and how often the
    /// motion was repeated before.
    fn recorded(&self, index: usize, count: usize) -> (Footfall, usize) {
        let (repetition, index) = match count > self.available() {
            true => (index / self.cycle, index % self.cycle),
            false => (0, index),
        };
        (self.footfalls[self.first + index], repetition)
    }

    /// The same step; its time goes on in repetitions.
    fn at(&self, index: usize, count: usize) -> Footfall {
        let (footfall, repetition) = self.recorded(index, count);
        Footfall {
            time_seconds: footfall.time_seconds + repetition as f64 * self.period(),
            ..footfall
        }
    }

    /// The motion with its steps at the times that are seen, where the first motion is.
    fn played<'a>(
        &self,
        recording: &'a Recording,
        seen: &[f64],
        first: &Self,
    ) -> Result<(Played<'a>, InStep), GaitProblem> {
        let count = seen.len();
        let mut times = Vec::with_capacity(count);
        for index in 0..count {
            let (own, repetition) = self.recorded(index, count);
            let expected = first.at(index, count).foot;
            if own.foot != expected {
                return Err(GaitProblem::Order {
                    seconds: own.time_seconds,
                    is_repeated: repetition > 0,
                    found: own.foot,
                    expected,
                });
            }
            times.push(self.at(index, count).time_seconds);
        }
        let mut played = Played::new(recording)
            .by_clock(TimeWarp::through(seen, &times)?)
            .placed(self.to(first));
        let [begin, mut end] = [0, count - 1].map(|index| times[index]);
        let mut seam = None;
        if count > self.available() {
            end = begin + self.period();
            let cycle = Cycle::between(recording, [begin, end], self.paths.up())?;
            seam = Some(cycle.seam().clone());
            played = played.in_cycles(cycle);
        }
        let in_step = InStep {
            footfalls: self.footfalls.clone(),
            times: [begin, end],
            seam,
        };
        Ok((played, in_step))
    }

    /// What takes the body at its first step to the place and the direction on the ground of
    /// another at its own.
    fn to(&self, other: &Self) -> Motor<f64> {
        if std::ptr::eq(self, other) {
            return Motor::default();
        }
        let [own, there] = [self, other].map(Self::start);
        let turn = Rotor::from_axis_angle([0.0, 1.0, 0.0], there.1 - own.1).unwrap_or_default();
        let translator = |v: Vector<f64>| Translator::from_displacement(v.coordinates());
        let way = translator(there.0) * turn * translator(-own.0);
        self.paths.upright.reverse() * way * self.paths.upright
    }

    /// Where on the ground the hips are at the first step, and the angle about the vertical of the
    /// mean direction of the body during the first stride.
    fn start(&self) -> (Vector<f64>, f64) {
        let last = self.footfalls.len() - 1;
        let frame = |index: usize| {
            let time = self.footfalls[index.min(last)].time_seconds;
            let frames = self.paths.middle.len();
            ((time / self.paths.frame_time).round() as usize).min(frames - 1)
        };
        let [begin, end] = [self.first, self.first + 2].map(frame);
        let place = self.paths.middle[begin];
        let directions = self.paths.forwards[begin..=end].iter();
        let mean = directions.fold(Vector::ZERO, |sum, &direction| sum + direction);
        let angle = mean.e1.atan2(mean.e3);
        (Vector::new(place.e1, 0.0, place.e3), angle)
    }
}
