//! Fits of poses to what views show.

use crate::BodyError;
use crate::normal::Normal;
use ga_anim::pose::Pose;
use ga_runtime::cga3::Point;
use ga_runtime::vga3::Vector;
use rayon::prelude::*;

use super::chain::{Chain, State};
use super::clip::{self, tracks};
use super::descent::{Found, Search, descend, log_determinant};
use super::ground::Anchor;
use super::likelihood::{Likelihood, Near, OUTLIER, Observed};
use super::start::{Links, Start, WRONG, starts};
use super::{BodyModel, Observation};
use ga_camera::Camera;
use ga_numerics::least_squares::Loss;

/// From a start to the most likely pose, whose likelihood then is within a thousandth of the
/// greatest; and from one that is near.
const FAR: Search = Search {
    steps: 100,
    tolerance: 1e-6,
};
const NEAR: Search = Search { steps: 10, ..FAR };
/// From drawn places of the points to a pose that is about as likely as any around it: farther
/// searches make the mean of such poses no better.
const DRAWN: Search = Search {
    steps: 5,
    tolerance: 0.1,
};
const TO_PLACES: Search = Search { steps: 2, ..DRAWN };
/// How many places of the points are drawn from which a fit begins.
const SAMPLES: usize = 12;
/// Frames of a clip within this time, in seconds, show one pose, for which rest counts once.
const ONE_POSE: f64 = 0.15;
/// Poses are the same whose points are nowhere farther apart, in metres.
const SAME: f64 = 0.01;
/// A probability that does not matter.
const NEGLIGIBLE: f64 = 1e-3;

/// Fits of the poses of a body to what views show, prepared for many frames.
#[derive(Clone, Debug)]
pub struct BodyFit<'a> {
    likelihood: Likelihood<'a>,
    links: Links,
}

/// A state that was found from a start.
struct Candidate {
    found: Found,
    points: Vec<Vector<f64>>,
    /// The logarithm of the determinant of the equations there.
    determinant: f64,
    /// The views that are wrong, each with a point.
    wrong: Vec<(usize, usize)>,
}

/// Frames that follow one another.
struct Stretch {
    /// `None` before the first frame that has a pose.
    states: Vec<Option<State>>,
    /// Why the first frame has no pose by itself that has none.
    error: Option<BodyError>,
}

/// A pose that was fitted.
#[derive(Clone, Debug, PartialEq)]
pub struct FittedPose {
    /// The motors of the joints and of the whole body, for the skeleton of the model.
    pub pose: Pose,
    /// Where the points of the model are, in the order of [`BodyModel::points`], in metres.
    pub points: Vec<Point<f64>>,
    /// For each view and each point how far its projection is from its pixel, in pixels; `None`
    /// where the view does not show it.
    pub residuals_px: Vec<Vec<Option<f64>>>,
    /// The root mean square of these distances.
    pub root_mean_square_px: f64,
    /// The points that no view shows: where they are follows from the other points, and what these
    /// do not determine from rest and, in a clip, from the frames before and after.
    pub unseen: Vec<usize>,
}

impl<'a> BodyFit<'a> {
    /// Prepares fits of a body that these cameras see.
    ///
    /// # Errors
    /// [`BodyError::NoViews`] where there is no camera.
    pub fn new(model: &'a BodyModel, cameras: &'a [Camera]) -> Result<Self, BodyError> {
        if cameras.is_empty() {
            return Err(BodyError::NoViews);
        }
        let likelihood = Likelihood {
            chain: Chain::new(model),
            cameras,
            loss: Loss::Huber(OUTLIER),
            rest: 1.0,
        };
        let links = Links::new(&likelihood.chain);
        Ok(Self { likelihood, links })
    }

    /// The same with another loss of the distances from the pixels, which are in standard
    /// deviations; [`Loss::Huber`] of 3 at first.
    #[must_use]
    pub fn with_loss(mut self, loss: Loss) -> Self {
        self.likelihood.loss = loss;
        self
    }

    /// The pose for what the views show at one time.
    ///
    /// It begins at places of the points that fit the pixels and the lengths of bones together: the
    /// most likely ones, and others drawn as likely as they are, since a bone that points towards
    /// the views is seen almost as one that points away from them. From each it descends by damped
    /// Gauss–Newton steps. The pose found is the one nearest to the mean of these poses, each as
    /// likely as it is: its points have the least expected squared error. Where the views do not
    /// agree on a point and the lengths of bones say which is wrong, that one is left out.
    ///
    /// With one view it begins at rest, in the orientations in which rest explains the view best,
    /// and takes the best of what it finds.
    ///
    /// Joints rotate from rest with a standard deviation of 0.7 rad, as a human's limbs do, and of
    /// 0.2 rad in the trunk and between bones that begin in one place: where the pixels leave a
    /// rotation open, such as the twist of a bone with nothing beside it, it stays at rest.
    ///
    /// # Errors
    /// [`BodyError::Views`], [`BodyError::Points`], [`BodyError::Pixel`], [`BodyError::Deviation`],
    /// [`BodyError::TooFewPoints`], [`BodyError::Behind`], [`BodyError::Camera`] and
    /// [`BodyError::NoPose`].
    pub fn frame(&self, observation: &Observation) -> Result<FittedPose, BodyError> {
        self.fitted(observation, &self.state(observation)?)
    }

    /// The state of [`frame`](Self::frame).
    pub(super) fn state(&self, observation: &Observation) -> Result<State, BodyError> {
        self.check(observation)?;
        let normal = &mut self.normal();
        let found = self.search(observation, SAMPLES, normal)?;
        Ok(self.expected(&found, observation, normal))
    }

    pub(super) fn likelihood(&self) -> &Likelihood<'a> {
        &self.likelihood
    }

    /// The most likely poses for what the views show in a clip, as a whole: joints and body move
    /// with accelerations of a size that the clip itself shows.
    ///
    /// Between frames the second differences of every joint's rotation vector and of the
    /// translation are Gaussian, each with a variance of its own (a discrete white noise of
    /// accelerations; the most likely motion is a smoothing spline: G. Wahba, 1978). The variances
    /// follow from how second differences over more than one frame grow beyond those over one,
    /// which are mostly noise, so there is nothing to tune. Long clips are fitted in stretches that
    /// overlap.
    ///
    /// Frames may show fewer points than a pose needs, or none: they follow from those around. The
    /// frame rate only matters for clips of less than eight frames, which do not show how large
    /// accelerations are: then they are those of a human who moves without haste.
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
    /// time, and near to the frame before.
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
        self.one_by_one(&tracks::smoothed(observations))
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
            ..self.likelihood.clone()
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

    fn normal(&self) -> Normal {
        Normal::new(self.likelihood.chain.count)
    }

    fn observed<'o>(&'o self, observation: &'o Observation) -> Observed<'o, 'a> {
        Observed {
            likelihood: &self.likelihood,
            observation,
        }
    }

    /// The best states that are found from all starts, first the one of the least cost.
    fn search(
        &self,
        observation: &Observation,
        samples: usize,
        normal: &mut Normal,
    ) -> Result<Vec<Candidate>, BodyError> {
        let Likelihood { chain, cameras, .. } = &self.likelihood;
        let starts = starts(chain, &self.links, cameras, observation, samples)?;
        let mut all: Vec<Candidate> = Vec::with_capacity(starts.len());
        let mut error = BodyError::NoPose;
        // Samples stand for all poses, others only for the best one.
        let is_sampled = starts.iter().all(|start| start.places.is_some());
        for start in starts {
            let Some(found) = self.descend_from(&start, observation, normal) else {
                error = self.likelihood.unseen(&start.state, observation);
                continue;
            };
            let candidate = Candidate {
                points: chain.places(&found.state).points,
                determinant: log_determinant(chain, normal),
                wrong: start.places.map_or_else(Vec::new, |places| places.wrong),
                found,
            };
            let same = |other: &&mut Candidate| is_same(&other.points, &candidate.points);
            match all.iter_mut().find(same) {
                Some(same) if candidate.found.cost < same.found.cost => *same = candidate,
                Some(_) => {}
                None => all.push(candidate),
            }
        }
        all.sort_by(|a, b| a.found.cost.total_cmp(&b.found.cost));
        if all.is_empty() {
            return Err(error);
        }
        if !is_sampled {
            all.truncate(1);
        }
        Ok(all)
    }

    /// The best state near to a start: first one whose points are at their places, and from there
    /// the most likely one, without views that are wrong.
    fn descend_from(
        &self,
        start: &Start,
        observation: &Observation,
        normal: &mut Normal,
    ) -> Option<Found> {
        let state = start.state.clone();
        let Some(places) = &start.places else {
            return descend(&self.observed(observation), state, FAR, normal);
        };
        let near = Near {
            likelihood: &self.likelihood,
            places: &places.points,
        };
        let near = descend(&near, state, TO_PLACES, normal)?.state;
        if places.wrong.is_empty() {
            return descend(&self.observed(observation), near, DRAWN, normal);
        }
        let right = observation.without(&places.wrong);
        let mut found = descend(&self.observed(&right), near, DRAWN, normal)?;
        found.cost += WRONG * places.wrong.len() as f64;
        Some(found)
    }

    /// The state whose points are nearest to their means over several states, each as likely as it
    /// is with those around it: integrals of Gaussians (P. Laplace). Where there is only one, it is
    /// the most likely state.
    fn expected(
        &self,
        found: &[Candidate],
        observation: &Observation,
        normal: &mut Normal,
    ) -> State {
        let chain = &self.likelihood.chain;
        let best = &found[0].found;
        let logarithm = |c: &Candidate| -0.5 * (c.found.cost + c.determinant);
        let greatest = found
            .iter()
            .map(logarithm)
            .fold(f64::NEG_INFINITY, f64::max);
        let weights: Vec<f64> = found
            .iter()
            .map(|f| (logarithm(f) - greatest).exp())
            .collect();
        let total: f64 = weights.iter().sum();
        let main = weights
            .iter()
            .position(|weight| *weight > (1.0 - NEGLIGIBLE) * total);
        if let Some(Candidate { found, wrong, .. }) = main.map(|main| &found[main]) {
            let right = observation.without(wrong);
            let nearest = descend(&self.observed(&right), found.state.clone(), FAR, normal);
            return nearest.map_or_else(|| found.state.clone(), |found| found.state);
        }
        let mut means = vec![Some(Vector::default()); chain.model.points().len()];
        for (candidate, weight) in found.iter().zip(&weights) {
            for (mean, place) in means.iter_mut().zip(&candidate.points) {
                *mean = mean.map(|mean| mean + *place * (weight / total));
            }
        }
        let near = Near {
            likelihood: &self.likelihood,
            places: &means,
        };
        let found = descend(&near, best.state.clone(), NEAR, normal);
        found.map_or_else(|| best.state.clone(), |found| found.state)
    }

    /// The states of all frames by themselves.
    fn one_by_one(&self, observations: &[Observation]) -> Result<Vec<State>, BodyError> {
        /// How many frames follow one another; stretches are independent.
        const STRETCH: usize = 96;
        // One view leaves several poses open, of which a clip has one.
        let stretch = match self.likelihood.cameras.len() {
            1 => observations.len().max(1),
            _ => STRETCH,
        };
        let stretches = observations.par_chunks(stretch).enumerate();
        let found: Vec<Stretch> = stretches
            .map(|(index, frames)| self.stretch(index * stretch, frames))
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
            // With one view the frame before decides between poses that explain a view equally
            // well.
            let is_search = index % SEARCHED == 0 && self.likelihood.cameras.len() > 1;
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

    /// Whether an observation fits the cameras and the model, with finite pixels.
    fn check(&self, observation: &Observation) -> Result<(), BodyError> {
        let (expected, found) = (self.likelihood.cameras.len(), observation.views.len());
        if expected != found {
            return Err(BodyError::Views { expected, found });
        }
        let points = self.likelihood.chain.model.points();
        for (view, pixels) in observation.views.iter().enumerate() {
            let (expected, found) = (points.len(), pixels.len());
            if expected != found {
                return Err(BodyError::Points {
                    view,
                    expected,
                    found,
                });
            }
            for (pixel, point) in pixels.iter().zip(points) {
                let Some(pixel) = pixel else { continue };
                let point = || point.name.clone();
                if !pixel.position.iter().all(|x| x.is_finite()) {
                    return Err(BodyError::Pixel {
                        view,
                        point: point(),
                        pixel: pixel.position,
                    });
                }
                if !(pixel.deviation > 0.0 && pixel.deviation.is_finite()) {
                    return Err(BodyError::Deviation {
                        view,
                        point: point(),
                        deviation: pixel.deviation,
                    });
                }
            }
        }
        Ok(())
    }

    /// A state as a pose, with what remains in the pictures.
    fn fitted(&self, observation: &Observation, state: &State) -> Result<FittedPose, BodyError> {
        let Likelihood { chain, cameras, .. } = &self.likelihood;
        let points: Vec<Point<f64>> = {
            let places = chain.places(state);
            places.points.into_iter().map(Point::from).collect()
        };
        let mut residuals_px = Vec::with_capacity(cameras.len());
        let (mut sum, mut count) = (0.0, 0_u32);
        let name = |index: usize| chain.model.points()[index].name.as_str();
        for (view, (camera, pixels)) in cameras.iter().zip(&observation.views).enumerate() {
            let mut row = Vec::with_capacity(points.len());
            for (index, (pixel, place)) in pixels.iter().zip(&points).enumerate() {
                let Some(pixel) = pixel else {
                    row.push(None);
                    continue;
                };
                let [u, v] = camera
                    .project(*place)
                    .map_err(|error| BodyError::of_point(view, name(index), error))?;
                let distance = (u - pixel.position[0]).hypot(v - pixel.position[1]);
                sum += distance * distance;
                count += 1;
                row.push(Some(distance));
            }
            residuals_px.push(row);
        }
        let is_unseen = |point: &usize| observation.views.iter().all(|view| view[*point].is_none());
        Ok(FittedPose {
            pose: chain.pose_of(state),
            unseen: (0..points.len()).filter(is_unseen).collect(),
            points,
            residuals_px,
            root_mean_square_px: (sum / f64::from(count.max(1))).sqrt(),
        })
    }
}

fn least(mut found: Vec<Candidate>) -> Found {
    found.swap_remove(0).found
}

fn is_same(a: &[Vector<f64>], b: &[Vector<f64>]) -> bool {
    a.iter().zip(b).all(|(a, b)| a.distance(*b) < SAME)
}
