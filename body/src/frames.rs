//! Fits of the poses of a clip, in which frames follow one another.

use rayon::prelude::*;

use super::chain::State;
use super::clip::{self, tracks};
use super::descent::{Found, descend};
use super::fit::{BodyFit, Candidate, FittedPose, NEAR};
use super::ground::Anchor;
use super::likelihood::Likelihood;
use super::one_view;
use super::{BodyError, Observation};

/// Frames of a clip within this time, in seconds, show one pose, for which rest counts once.
const ONE_POSE: f64 = 0.15;
/// Frames that follow one another.
struct Stretch {
    /// `None` before the first frame that has a pose.
    states: Vec<Option<State>>,
    /// Why the first frame has no pose by itself that has none.
    error: Option<BodyError>,
}

impl BodyFit<'_> {
    /// The most likely poses for what the views show in a clip, as a whole: joints and body move
    /// with accelerations of a size that the clip itself shows.
    ///
    /// Between frames the second differences of every joint's rotation vector and of the
    /// translation are Gaussian, each with a covariance of its own (a discrete white noise of
    /// accelerations; the most likely motion is a smoothing spline: G. Wahba, 1978). Those of
    /// joints are in the axes of the parent. The covariances follow from how second differences
    /// over more than one frame grow beyond those over one, which are mostly noise, so there is
    /// nothing to tune; the fewer differences are independent, the more alike are all directions.
    /// Long clips are fitted in stretches that overlap.
    ///
    /// The search begins at poses of the frames for pixels that are smoothed over time. With two
    /// views or more, these are near to the pose of the frame before. One view leaves several poses
    /// open: a bone that points towards the camera is seen almost as one that points away from it.
    /// There, one frame in each tenth of a second is searched from rest and with bones mirrored,
    /// the poses that are found are carried to all frames before and after, and each frame begins
    /// at the likeliest of those that it has. Where two poses explain the view equally well, it may
    /// be the wrong one, and neighbours may differ.
    ///
    /// Frames may show fewer points than a pose needs, or none: they follow from those around. The
    /// frame rate says which frames of one view are searched, and how many frames show one pose,
    /// for which rest counts once: those within 0.15 s. Clips of less than eight frames do not show
    /// how large accelerations are: then they are those of a human who moves without haste.
    ///
    /// # Errors
    /// [`BodyError::Frame`] with the first frame that does not fit the cameras and the model, or
    /// with the first one of all, where no frame by itself has a pose; [`BodyError::FrameRate`] for
    /// a rate that is not positive and finite.
    pub fn clip(
        &self,
        observations: &[Observation],
        frames_per_second: f64,
    ) -> Result<Vec<FittedPose>, BodyError> {
        let states = self.begin(observations, frames_per_second)?;
        let states = self.smooth(observations, states, frames_per_second, &[]);
        self.poses(observations, &states)
    }

    /// States that are near to those of a clip: of each frame, by pixels that are smoothed over
    /// time, and near to the frame before, or with one view the likeliest of all that are found.
    ///
    /// # Errors
    /// Those of [`clip`](Self::clip).
    pub(crate) fn begin(
        &self,
        observations: &[Observation],
        frames_per_second: f64,
    ) -> Result<Vec<State>, BodyError> {
        if !(frames_per_second > 0.0 && frames_per_second.is_finite()) {
            return Err(BodyError::FrameRate(frames_per_second).of_frame(0));
        }
        for (frame, observation) in observations.iter().enumerate() {
            let checked = self.check(observation);
            checked.map_err(|error| error.of_frame(frame))?;
        }
        let smoothed = tracks::smoothed(observations);
        match self.likelihood().cameras.len() {
            1 => one_view::states(self, &smoothed, frames_per_second),
            _ => self.one_by_one(&smoothed),
        }
    }

    /// The most likely states of a clip, from states that are near, with points that are held.
    pub(crate) fn smooth(
        &self,
        observations: &[Observation],
        states: Vec<State>,
        frames_per_second: f64,
        anchors: &[Vec<Anchor>],
    ) -> Vec<State> {
        let single = self.by_themselves(observations, &states);
        let likelihood = Likelihood {
            rest: 1.0 / (ONE_POSE * frames_per_second).max(1.0),
            ..self.likelihood().clone()
        };
        clip::smooth(
            &likelihood,
            observations,
            states,
            &single,
            frames_per_second,
            anchors,
        )
    }

    /// States as poses, with what remains in the pictures.
    ///
    /// # Errors
    /// [`BodyError::Frame`] where a camera does not see a point that it observes.
    pub(crate) fn poses(
        &self,
        observations: &[Observation],
        states: &[State],
    ) -> Result<Vec<FittedPose>, BodyError> {
        let frames = observations.iter().zip(states).enumerate();
        frames
            .map(|(frame, (observation, state))| {
                let fitted = self.fitted(observation, state);
                fitted.map_err(|error| error.of_frame(frame))
            })
            .collect()
    }

    /// The states of all frames by themselves.
    fn one_by_one(&self, observations: &[Observation]) -> Result<Vec<State>, BodyError> {
        /// How many frames follow one another; stretches are independent.
        const STRETCH: usize = 96;
        let stretches = observations.par_chunks(STRETCH).enumerate();
        let found: Vec<Stretch> = stretches
            .map(|(index, frames)| self.stretch(index * STRETCH, frames))
            .collect();
        let states = || found.iter().flat_map(|stretch| &stretch.states);
        let Some(first) = states().flatten().next() else {
            let error = found.iter().find_map(|stretch| stretch.error.clone());
            return error.map_or(Ok(Vec::new()), Err);
        };
        // Frames before the first pose begin with that, and others with the one before.
        let filled = states().scan(first, |last, state| {
            *last = state.as_ref().unwrap_or(*last);
            Some((*last).clone())
        });
        Ok(filled.collect())
    }

    /// The states that explain each frame best near to given ones.
    fn by_themselves(&self, observations: &[Observation], states: &[State]) -> Vec<State> {
        let frames = observations.par_iter().zip(states);
        let found = frames.map_init(
            || self.normal(),
            |normal, (observation, state)| {
                let found = descend(&self.observed(observation), state.clone(), NEAR, normal);
                found.map_or_else(|| state.clone(), |found| found.state)
            },
        );
        found.collect()
    }

    /// Frames one after the other, each near to the one before where that is as good. Frames
    /// without a pose of their own have that of the one before.
    fn stretch(&self, first: usize, observations: &[Observation]) -> Stretch {
        /// A cost for each coordinate of a pixel that is no longer that of noise.
        const BAD: f64 = 3.0;
        /// How often all poses are searched.
        const SEARCHED: usize = 8;
        let normal = &mut self.normal();
        let mut states: Vec<Option<State>> = Vec::with_capacity(observations.len());
        let mut last: Option<State> = None;
        let mut first_error = None;
        for (index, observation) in observations.iter().enumerate() {
            let near = last
                .clone()
                .and_then(|last| descend(&self.observed(observation), last, NEAR, normal));
            let count = observation.views.iter().flatten().flatten().count();
            let is_search = index % SEARCHED == 0;
            let is_good = |found: &Found| !is_search && found.cost <= BAD * (2 * count) as f64;
            let found = match near {
                Some(near) if is_good(&near) => Some(near),
                near => match (self.search(observation, 0, normal).map(least), near) {
                    (Ok(found), Some(near)) if near.cost <= found.cost => Some(near),
                    (Ok(found), _) => Some(found),
                    (Err(error), near) => {
                        let frame = first + index;
                        first_error.get_or_insert(error.of_frame(frame));
                        near
                    }
                },
            };
            last = found.map(|found| found.state).or(last);
            states.push(last.clone());
        }
        Stretch {
            states,
            error: first_error,
        }
    }
}

fn least(mut found: Vec<Candidate>) -> Found {
    found.swap_remove(0).found
}
