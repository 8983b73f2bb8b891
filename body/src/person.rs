//! The motion of a person in a clip, step by step.
//!
//! What detectors say of real films is wrong in ways that noise does not explain: sides are
//! exchanged for a while, joints lie beside those of a skeleton, some are far off. So a motion is
//! found in rounds, each of which begins where the one before ended: the sides, the proportions,
//! the poses, and from these the sides again.

use ga_anim::clip::opposite_name;
use ga_camera::Camera;
use ga_numerics::least_squares::Loss;
use ga_numerics::order_statistics::{Sorted, median};
use ga_runtime::cga3::Point;
use ga_runtime::vga3::Vector;
use rayon::prelude::*;

use crate::chain::{Chain, State};
use crate::ground::{
    Anchor, Contact, Ground, GroundOptions, Leaning, Stance, Upright, anchors, diameter, stances,
};
use crate::landmarks::{Anatomy, SkinPoint};
use crate::lengths::{Beside, Lengths, Proportions, spread};
use crate::likelihood::OUTLIER;
use crate::sides::{Exchanged, pairs};
use crate::{BodyError, BodyFit, BodyModel, FittedPose, JointPixel, Observation};

/// How often feet that stand are found, and held between two times.
const HOLDS: usize = 4;
/// How often the sides are asked again with the body that was found.
const ROUNDS: usize = 2;
/// The median of the length of a vector of two coordinates of Gaussian noise, in standard
/// deviations.
const MEDIAN: f64 = 1.177_410_022_515_474_7;
/// Noise is not Gaussian where more than this part of all pixels are farther off than
/// [`OUTLIER`] deviations: 1.1 % are in Gaussian noise.
const TAIL: f64 = 0.03;
/// What is farther off than this, in standard deviations, counts less than in proportion, where
/// noise is not Gaussian.
const HEAVY: f64 = 2.0;
/// The search begins with a loss that is wider by this factor at least, or as wide as this part of
/// all pixels is near, and becomes narrower by the other factor.
const WIDEST: f64 = 4.0;
const FAR: f64 = 0.98;
const NARROWER: f64 = 2.5;

/// A person as several views show it.
pub(crate) struct Person<'a> {
    /// The model as it was given.
    original: &'a BodyModel,
    cameras: &'a [Camera],
    observations: &'a [Observation],
    frames_per_second: f64,
    pairs: Vec<[usize; 2]>,
    /// For each point how far it may be from where the model has it; `None` for joints.
    beside: Vec<Option<Beside>>,
}

/// The motion of a person.
pub(crate) struct FittedPerson {
    /// The body with its proportions.
    pub(crate) model: BodyModel,
    pub(crate) proportions: Option<Proportions>,
    pub(crate) poses: Vec<FittedPose>,
    /// What views show, with sides put right and with deviations as they are.
    pub(crate) observations: Vec<Observation>,
    pub(crate) exchanged: Exchanged,
    pub(crate) ground: Option<Ground>,
    /// How much larger the deviations of pixels are than they were given.
    pub(crate) noise: f64,
}

/// What is known after a step.
struct Known {
    model: BodyModel,
    proportions: Option<Proportions>,
    states: Vec<State>,
    exchanged: Exchanged,
    /// With sides put right.
    observations: Vec<Observation>,
    noise: f64,
    /// How far the farthest pixels are from where the body has them, in these deviations.
    farthest: f64,
    loss: Loss,
    /// For each frame the points of feet that stand; empty where none is known.
    anchors: Vec<Vec<Anchor>>,
    ground: Option<Ground>,
}

impl<'a> Person<'a> {
    pub(crate) fn new(
        model: &'a BodyModel,
        skin: &[Option<SkinPoint>],
        cameras: &'a [Camera],
        observations: &'a [Observation],
        frames_per_second: f64,
    ) -> Self {
        Self {
            pairs: pairs(model.points()),
            beside: beside(model, skin),
            original: model,
            cameras,
            observations,
            frames_per_second,
        }
    }

    /// The most likely motion; with the proportions of the person, and with the ground on which
    /// feet stand, where these are asked for.
    ///
    /// # Errors
    /// Those of [`BodyFit::clip`] and [`fit_lengths`](crate::fit_lengths).
    pub(crate) fn fit(
        &self,
        lengths: Option<Lengths>,
        ground: Option<&GroundOptions>,
    ) -> Result<FittedPerson, BodyError> {
        let mut known = self.begin(lengths)?;
        self.measure_noise(&mut known)?;
        self.fit_proportions(&mut known, lengths)?;
        self.smooth(&mut known)?;
        for _ in 0..ROUNDS {
            self.measure_noise(&mut known)?;
            let is_right = !self.put_sides_right(&mut known)?;
            if is_right && matches!(known.loss, Loss::Huber(_)) {
                break;
            }
            self.fit_proportions(&mut known, lengths)?;
            self.smooth(&mut known)?;
            if is_right {
                break;
            }
        }
        if let Some(options) = ground {
            self.stand(&mut known, options)?;
        }
        let seen = self.seen(&known);
        let fit = BodyFit::new(&known.model, self.cameras)?;
        Ok(FittedPerson {
            poses: fit.poses(&seen, &known.states)?,
            ground: known.ground,
            model: known.model,
            proportions: known.proportions,
            observations: seen,
            exchanged: known.exchanged,
            noise: known.noise,
        })
    }

    /// The expected pose of each frame by itself; `done` is told how many frames of how many are
    /// fitted.
    ///
    /// # Errors
    /// [`BodyError::Frame`] with the first frame that has no pose, and those of
    /// [`fit_lengths`](crate::fit_lengths).
    pub(crate) fn fit_frames(
        &self,
        lengths: Option<Lengths>,
        done: &mut impl FnMut(usize, usize),
    ) -> Result<FittedPerson, BodyError> {
        let joints = self
            .observations
            .iter()
            .map(|observation| self.of_joints(observation));
        let observations: Vec<Observation> = joints.collect();
        let proportions = match lengths {
            Some(lengths) => Some(Proportions::of_frames(
                self.original,
                self.cameras,
                &observations,
                lengths,
            )?),
            None => None,
        };
        let model = match &proportions {
            Some(proportions) => proportions.of(self.original)?,
            None => self.original.clone(),
        };
        let fit = BodyFit::new(&model, self.cameras)?;
        let count = observations.len();
        let frames = observations.iter().enumerate();
        let poses = frames.map(|(frame, observation)| {
            done(frame, count);
            fit.frame(observation)
                .map_err(|error| error.of_frame(frame))
        });
        Ok(FittedPerson {
            poses: poses.collect::<Result<_, _>>()?,
            exchanged: Exchanged::none(&observations),
            ground: None,
            proportions,
            observations,
            noise: 1.0,
            model,
        })
    }

    /// Sides by the views alone, the size of the person, and states by the joints.
    fn begin(&self, lengths: Option<Lengths>) -> Result<Known, BodyError> {
        let joints = self
            .observations
            .iter()
            .map(|observation| self.of_joints(observation));
        let joints: Vec<Observation> = joints.collect();
        let proportions = match lengths {
            None => None,
            Some(_) if self.cameras.len() < 2 => {
                return Err(BodyError::OneView(self.cameras.len()));
            }
            Some(_) => {
                let every = spread(joints.len());
                let some = joints.iter().step_by(every);
                let size = Proportions::of_size(self.original, self.cameras, some)?;
                Some(size.with_points_beside(match lengths {
                    Some(Lengths::EachBone) => self.beside.clone(),
                    _ => vec![None; self.beside.len()],
                }))
            }
        };
        let model = match &proportions {
            Some(proportions) => proportions.of(self.original)?,
            None => self.original.clone(),
        };
        let fit = BodyFit::new(&model, self.cameras)?;
        let states = fit.begin(&joints, self.frames_per_second)?;
        Ok(Known {
            states,
            proportions,
            exchanged: Exchanged::none(self.observations),
            observations: self.observations.to_vec(),
            noise: 1.0,
            farthest: 0.0,
            loss: Loss::Huber(OUTLIER),
            anchors: Vec::new(),
            ground: None,
            model,
        })
    }

    /// What a view shows of the joints.
    fn of_joints(&self, observation: &Observation) -> Observation {
        let mut own = observation.clone();
        for view in &mut own.views {
            for (pixel, beside) in view.iter_mut().zip(&self.beside) {
                *pixel = pixel.filter(|_| beside.is_none());
            }
        }
        own
    }

    /// What views show, with the deviations that the residuals have shown. Points of the skin that
    /// may lie beside their places have larger ones where these places are not estimated.
    fn seen(&self, known: &Known) -> Vec<Observation> {
        let is_estimated = known
            .proportions
            .as_ref()
            .is_some_and(Proportions::has_points_beside);
        let larger = known.proportions.as_ref().map_or(1.0, Proportions::size);
        let chain = Chain::new(&known.model);
        let of_frame = |(observation, state): (&Observation, &State)| {
            let mut own = observation.clone();
            let places = (!is_estimated).then(|| chain.places(state).points);
            for (camera, view) in self.cameras.iter().zip(&mut own.views) {
                for (point, pixel) in view.iter_mut().enumerate() {
                    let Some(pixel) = pixel else { continue };
                    pixel.deviation *= known.noise;
                    let beside = self.beside[point].as_ref();
                    if let (Some(places), Some(beside)) = (&places, beside) {
                        let place = Point::from(places[point]);
                        let [.., depth] = camera.world_to_camera.transform(place).coordinates();
                        let [x, y] = camera.intrinsics.focal();
                        let size = 0.5 * (x + y) / depth.abs();
                        pixel.deviation = pixel.deviation.hypot(size * larger * beside.deviation);
                    }
                }
            }
            own
        };
        let frames = known.observations.par_iter().zip(&known.states);
        frames.map(of_frame).collect()
    }

    /// Finds the ground, and holds feet that stand on it.
    fn stand(&self, known: &mut Known, options: &GroundOptions) -> Result<(), BodyError> {
        let Some(anatomy) = Anatomy::new(known.model.skeleton()) else {
            return Ok(());
        };
        let feet = anatomy.points_of_feet(known.model.points());
        let model = known.model.clone();
        for round in 0..HOLDS {
            let chain = Chain::new(&model);
            let places: Vec<_> = known
                .states
                .iter()
                .map(|s| chain.places(s).points)
                .collect();
            let heads: Vec<_> = known.states.iter().map(|s| chain.heads(s)).collect();
            let Some(leaning) = Leaning::of(heads.iter().map(|heads| anatomy.ends(heads))) else {
                return Ok(());
            };
            let upright = |stances: &[Stance]| match options.up.and_then(Upright::given) {
                Some(given) => given,
                None => {
                    let groups = feet.iter().map(|&point| {
                        let own = stances.iter().filter(|stance| stance.point == point);
                        own.map(|stance| stance.place).collect()
                    });
                    let groups: Vec<Vec<_>> = groups.collect();
                    Upright::new(&leaning, &groups, options.has_upright_axis)
                }
            };
            let rate = self.frames_per_second;
            let first = stances(&places, &feet, upright(&[]).up, rate);
            let found = upright(&first);
            let standing = stances(&places, &feet, found.up, rate);
            if round + 1 == HOLDS {
                known.ground = Some(ground(&model, &anatomy, &standing, &heads, found, options));
                break;
            }
            known.anchors = anchors(&standing, known.states.len());
            let seen = self.seen(known);
            let fit = BodyFit::new(&model, self.cameras)?.with_loss(known.loss);
            let states = std::mem::take(&mut known.states);
            known.states = fit.smooth(&seen, states, rate, &known.anchors);
        }
        Ok(())
    }

    /// Where the points of the body are seen: for each view, frame and point.
    fn expected(&self, known: &Known) -> Vec<Vec<Vec<Option<[f64; 2]>>>> {
        let chain = Chain::new(&known.model);
        let places = known
            .states
            .par_iter()
            .map(|state| chain.places(state).points);
        let places: Vec<_> = places.collect();
        let of_view = |camera: &Camera| {
            let project = |points: &Vec<Vector<f64>>| {
                points
                    .iter()
                    .map(|point| camera.project((*point).into()).ok())
                    .collect()
            };
            places.iter().map(project).collect()
        };
        self.cameras.iter().map(of_view).collect()
    }

    /// By how much the deviations of pixels are larger than was said, and whether many of them are
    /// far off. Deviations that are smaller stay as they are.
    fn measure_noise(&self, known: &mut Known) -> Result<(), BodyError> {
        let expected = self.expected(known);
        let mut distances: Vec<f64> = Vec::new();
        for (view, frames) in expected.iter().enumerate() {
            for (observation, points) in known.observations.iter().zip(frames) {
                let pixels = observation.views[view].iter().zip(points).zip(&self.beside);
                for ((pixel, at), beside) in pixels {
                    let is_joint = beside.is_none();
                    if let (
                        Some(JointPixel {
                            position,
                            deviation,
                        }),
                        Some(at),
                        true,
                    ) = (pixel, at, is_joint)
                    {
                        let distance = (position[0] - at[0]).hypot(position[1] - at[1]);
                        distances.push(distance / deviation);
                    }
                }
            }
        }
        let Some(sorted) = Sorted::new(&mut distances) else {
            return Ok(());
        };
        known.noise = (sorted.median() / MEDIAN).max(1.0);
        known.farthest = sorted.quantile(FAR) / known.noise;
        let far = distances
            .iter()
            .filter(|d| **d > OUTLIER * known.noise)
            .count();
        known.loss = match far as f64 > TAIL * distances.len() as f64 {
            true => Loss::Cauchy(HEAVY),
            false => Loss::Huber(OUTLIER),
        };
        Ok(())
    }

    /// Sides by the body; whether this changes any.
    fn put_sides_right(&self, known: &mut Known) -> Result<bool, BodyError> {
        let expected = self.expected(known);
        let scaled = scaled(self.observations, known.noise);
        let found = Exchanged::by_body(&scaled, &expected, &self.pairs);
        let is_changed = found != known.exchanged;
        known.observations = found.put_right(self.observations, &self.pairs);
        known.exchanged = found;
        Ok(is_changed)
    }

    /// The proportions, from some frames.
    fn fit_proportions(
        &self,
        known: &mut Known,
        lengths: Option<Lengths>,
    ) -> Result<(), BodyError> {
        let (Some(lengths), Some(proportions)) = (lengths, &mut known.proportions) else {
            return Ok(());
        };
        let every = spread(known.states.len());
        let seen = scaled(&known.observations, known.noise);
        let (some, states): (Vec<&Observation>, Vec<State>) = seen
            .iter()
            .zip(&known.states)
            .step_by(every)
            .map(|(seen, state)| (seen, state.clone()))
            .unzip();
        proportions.fit(
            self.original,
            self.cameras,
            &some,
            states,
            lengths,
            known.loss,
        )?;
        known.model = proportions.of(self.original)?;
        Ok(())
    }

    /// The poses of all frames.
    fn smooth(&self, known: &mut Known) -> Result<(), BodyError> {
        let seen = self.seen(known);
        let states = std::mem::take(&mut known.states);
        let fit = BodyFit::new(&known.model, self.cameras)?;
        // A loss that hardly counts what is far off begins as wide as what is off, so that it ends
        // where most pixels agree.
        let widths = match known.loss {
            Loss::Cauchy(scale) => {
                let first = known.farthest.max(WIDEST * scale);
                let wider = std::iter::successors(Some(first), |width| Some(width / NARROWER));
                wider.take_while(|width| *width > 1.2 * scale).collect()
            }
            _ => Vec::new(),
        };
        let losses = widths.into_iter().map(Loss::Cauchy).chain([known.loss]);
        known.states = losses.fold(states, |states, loss| {
            let fit = fit.clone().with_loss(loss);
            fit.smooth(&seen, states, self.frames_per_second, &known.anchors)
        });
        Ok(())
    }
}

/// The ground on which joints of feet stand.
fn ground(
    model: &BodyModel,
    anatomy: &Anatomy<'_>,
    standing: &[Stance],
    heads: &[Vec<Vector<f64>>],
    upright: Upright,
    options: &GroundOptions,
) -> Ground {
    let joints = model.skeleton().joints();
    let up = upright.up;
    let mut heights: Vec<f64> = standing
        .iter()
        .map(|stance| {
            let at_rest = Vector::from(model.points()[stance.point].at_rest);
            stance.place.dot(up) - anatomy.height_at_rest(at_rest)
        })
        .collect();
    let found = median(&mut heights);
    let contacts = standing.iter().filter_map(|stance| {
        let joint = anatomy.standing_joint(&model.points()[stance.point])?;
        let of_joint = heads[stance.frames.clone()]
            .iter()
            .map(|heads| heads[joint]);
        let of_joint: Vec<Vector<f64>> = of_joint.collect();
        Some(Contact {
            joint: joints[joint].name.clone(),
            start: *stance.frames.start(),
            end: *stance.frames.end(),
            slide_metres: diameter(&of_joint),
        })
    });
    Ground {
        up: up.into(),
        up_is: upright.source,
        up_deviation_degrees: upright.deviation.to_degrees(),
        floor: options.floor.or(found),
        contacts: contacts.collect(),
    }
}

/// Observations with larger deviations.
fn scaled(observations: &[Observation], factor: f64) -> Vec<Observation> {
    let mut scaled = observations.to_vec();
    let pixels = scaled.iter_mut().flat_map(|o| o.views.iter_mut().flatten());
    for pixel in pixels.flatten() {
        pixel.deviation *= factor;
    }
    scaled
}

/// Which points may lie beside their places, with one displacement for both sides.
fn beside(model: &BodyModel, skin: &[Option<SkinPoint>]) -> Vec<Option<Beside>> {
    let Some(anatomy) = Anatomy::new(model.skeleton()) else {
        return vec![None; model.points().len()];
    };
    let points = model.points();
    let mut found: Vec<Option<Beside>> = Vec::with_capacity(points.len());
    let mut count = 0;
    for (point, skin) in points.iter().zip(skin) {
        let Some(skin) = skin else {
            found.push(None);
            continue;
        };
        let other = opposite_name(&point.name);
        let other = other.and_then(|other| points.iter().position(|point| point.name == other));
        let before = other.and_then(|other| found.get(other).cloned().flatten());
        let [left, up, forward] = anatomy.axes;
        let (shared, axes) = match before {
            Some(other) => (other.shared, [-left, up, forward]),
            None => (count, anatomy.axes),
        };
        count = count.max(shared + 1);
        found.push(Some(Beside {
            shared,
            axes,
            deviation: skin.deviation,
        }));
    }
    found
}
