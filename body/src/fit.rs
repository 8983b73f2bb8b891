//! Fits of poses to what views show.

use crate::BodyError;
use crate::normal::Normal;
use ga_anim::pose::Pose;
use ga_runtime::cga3::Point;
use ga_runtime::vga3::Vector;

use super::chain::{Chain, State};
use super::descent::{Found, Search, descend, log_determinant};
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
pub(super) const NEAR: Search = Search { steps: 10, ..FAR };
/// From drawn places of the points to a pose that is about as likely as any around it: farther
/// searches make the mean of such poses no better.
const DRAWN: Search = Search {
    steps: 5,
    tolerance: 0.1,
};
const TO_PLACES: Search = Search { steps: 2, ..DRAWN };
/// How many places of the points are drawn from which a fit begins.
const SAMPLES: usize = 12;
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
pub(super) struct Candidate {
    pub(super) found: Found,
    points: Vec<Vector<f64>>,
    /// The logarithm of the determinant of the equations there.
    determinant: f64,
    /// The views that are wrong, each with a point.
    wrong: Vec<(usize, usize)>,
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
    /// do not determine from the usual posture and, in a clip, from the frames before and after.
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
    /// With one view it begins in the usual posture, in the orientations in which that explains the
    /// view best, and takes the best of what it finds.
    ///
    /// Rotations of joints are spread about rest with a standard deviation of 0.7 rad, and of
    /// 0.2 rad in the trunk and between bones that begin in one place. Where the skeleton is that
    /// of a person who stands at rest, known by the names or the structure of its joints, those of
    /// limbs are spread about a usual posture: thighs and upper arms hang a little to the front,
    /// and knees and elbows bend one way, by 40° and 50° in the mean. What the pixels leave open is
    /// as there: the twist of a bone with nothing beside it, the side to which a knee bends that no
    /// view shows.
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

    pub(super) fn links(&self) -> &Links {
        &self.links
    }

    pub(super) fn normal(&self) -> Normal {
        Normal::new(self.likelihood.chain.count)
    }

    pub(super) fn observed<'o>(&'o self, observation: &'o Observation) -> Observed<'o, 'a> {
        Observed {
            likelihood: &self.likelihood,
            observation,
        }
    }

    /// The best states that are found from all starts, first the one of the least cost.
    pub(super) fn search(
        &self,
        observation: &Observation,
        samples: usize,
        normal: &mut Normal,
    ) -> Result<Vec<Candidate>, BodyError> {
        let (mut all, is_sampled) = self.minima(observation, samples, normal)?;
        // Samples stand for all poses, others only for the best one.
        if !is_sampled {
            all.truncate(1);
        }
        Ok(all)
    }

    /// All states that are found, first the one of the least cost, and whether their starts were
    /// drawn.
    ///
    /// # Errors
    /// Those of [`frame`](Self::frame).
    pub(super) fn minima(
        &self,
        observation: &Observation,
        samples: usize,
        normal: &mut Normal,
    ) -> Result<(Vec<Candidate>, bool), BodyError> {
        let Likelihood { chain, cameras, .. } = &self.likelihood;
        let starts = starts(chain, &self.links, cameras, observation, samples)?;
        let mut all: Vec<Candidate> = Vec::with_capacity(starts.len());
        let mut error = BodyError::NoPose;
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
        Ok((all, is_sampled))
    }

    /// The best state near to a start: first one whose points are at their places, and from there
    /// the most likely one, without views that are wrong.
    pub(super) fn descend_from(
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

    /// Whether an observation fits the cameras and the model, with finite pixels.
    pub(super) fn check(&self, observation: &Observation) -> Result<(), BodyError> {
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
    pub(super) fn fitted(
        &self,
        observation: &Observation,
        state: &State,
    ) -> Result<FittedPose, BodyError> {
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

fn is_same(a: &[Vector<f64>], b: &[Vector<f64>]) -> bool {
    a.iter().zip(b).all(|(a, b)| a.distance(*b) < SAME)
}
