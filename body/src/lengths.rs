//! Lengths of bones from what views show.

use ga_anim::clip::opposite_name;
use ga_anim::skeleton::{Joint, Skeleton, SkeletonError};
use ga_runtime::vga3::Vector;

use super::chain::{Chain, State};
use super::likelihood::Likelihood;
use super::model::{BodyModel, BodyPoint};
use super::{BodyFit, Observation};
use crate::BodyError;
use ga_camera::Camera;
use ga_numerics::least_squares::{Columns, Equations, Loss, Options, Problem, minimise};

/// Which lengths are unknown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Lengths {
    /// The size of the whole body: one factor for all bones.
    #[default]
    OneFactor,
    /// A factor for each bone, that is for the way from a joint to the one above it. The factors
    /// are near to each other as a person's proportions are: within a standard deviation of 10 %.
    EachBone,
}

/// A body whose bones were fitted.
#[derive(Clone, Debug, PartialEq)]
pub struct FittedLengths {
    /// The body with its new lengths.
    pub model: BodyModel,
    /// For each joint by how much longer the way from the joint above it is than it was. For a
    /// joint without one above it, and for joints in one place, the factor of the whole body.
    pub factors: Vec<f64>,
}

/// The standard deviation of the logarithm of a bone's factor.
const PROPORTIONS: f64 = 0.1;
/// That of the difference between the two sides of a person.
const SYMMETRY: f64 = 0.02;
/// The search ends with a step that changes the residuals by no more than this in the mean. They
/// are in standard deviations, so that such a step says nothing, even where residuals are small.
const INSIGNIFICANT: f64 = 1e-4;
/// How many frames are used, spread over all of them.
const FRAMES: usize = 32;

/// The body with the most likely lengths of its bones for what two views or more show, together
/// with the poses of the frames: rotations and lengths are unknowns of one least sum, in which the
/// pose of each frame is eliminated. Of many frames, 32 are used.
///
/// # Errors
/// [`BodyError::OneView`], [`BodyError::NoBone`], [`BodyError::Frame`], [`BodyError::LeastSquares`]
/// and [`BodyError::Skeleton`].
///
/// ```
/// use ga_anim::skeleton::{Joint, Skeleton};
/// use ga_runtime::cga3::Point;
/// use ga_body::{BodyModel, JointPixel, Lengths, Observation, fit_lengths};
/// use ga_camera::{Camera, Intrinsics};
///
/// let joint = |name: &str, parent, y: f64, tail: f64| Joint {
///     name: name.into(),
///     parent,
///     head: [0.0, y, 0.0],
///     tail: [0.0, tail, 0.0],
/// };
/// let arm = Skeleton::new(vec![
///     joint("shoulder", None, 0.0, 0.3),
///     joint("elbow", Some(0), 0.3, 0.55),
///     joint("wrist", Some(1), 0.55, 0.55),
/// ])?;
/// let model = BodyModel::of_distinct_joints(arm)?;
///
/// let intrinsics = Intrinsics::new([1000.0, 1000.0], [640.0, 360.0])?;
/// let up = [0.0, 1.0, 0.0];
/// let camera = |x| Camera::look_at(intrinsics, [x, 0.0, 4.0].into(), Point::default(), up);
/// let cameras = [-0.5, 0.5].map(camera).into_iter().flatten().collect::<Vec<_>>();
/// // An arm that is larger by a tenth: bones of 33 and 27.5 cm.
/// let truth = [[0.0, 0.0, 0.0], [0.33, 0.0, 0.0], [0.33, 0.275, 0.0]].map(Point::from);
/// let mut seen = Observation::unseen(cameras.len(), truth.len());
/// for (camera, view) in cameras.iter().zip(&mut seen.views) {
///     for (point, pixel) in truth.iter().zip(view) {
///         *pixel = Some(JointPixel { position: camera.project(*point)?, deviation: 0.1 });
///     }
/// }
/// let fitted = fit_lengths(&model, &cameras, &[seen], Lengths::OneFactor)?;
/// assert!((fitted.factors[1] - 1.1).abs() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn fit_lengths(
    model: &BodyModel,
    cameras: &[Camera],
    observations: &[Observation],
    lengths: Lengths,
) -> Result<FittedLengths, BodyError> {
    let proportions = Proportions::of_frames(model, cameras, observations, lengths)?;
    Ok(FittedLengths {
        model: proportions.of(model)?,
        factors: proportions.factors(),
    })
}

/// Every which frame of a clip is used, so that there are not too many.
pub(crate) fn spread(frames: usize) -> usize {
    frames.div_ceil(FRAMES).max(1)
}

/// A point that may lie beside its place at rest.
#[derive(Clone, Debug)]
pub(crate) struct Beside {
    /// Which displacement it has; the points of the two sides share one.
    pub(crate) shared: usize,
    /// The directions of the three coordinates of the displacement: on the right side the mirror
    /// images of those on the left.
    pub(crate) axes: [Vector<f64>; 3],
    /// The standard deviation of each coordinate.
    pub(crate) deviation: f64,
}

/// How a person differs from a model.
#[derive(Clone, Debug)]
pub(crate) struct Proportions {
    /// How much larger the person is.
    size: f64,
    /// For each joint the logarithm of the factor of the way to it, beside the size.
    logarithms: Vec<f64>,
    /// For each point whether it may be displaced.
    beside: Vec<Option<Beside>>,
    /// The displacements.
    displacements: Vec<[f64; 3]>,
    /// For each joint the standard deviation of the logarithm of the factor of the way to it; empty
    /// where lengths are not estimated.
    deviations: Vec<Option<f64>>,
}

impl Proportions {
    /// The most likely ones for what two views or more show, with the poses of frames by
    /// themselves, as [`fit_lengths`] finds them.
    pub(crate) fn of_frames(
        model: &BodyModel,
        cameras: &[Camera],
        observations: &[Observation],
        lengths: Lengths,
    ) -> Result<Self, BodyError> {
        if cameras.len() < 2 {
            return Err(BodyError::OneView(cameras.len()));
        }
        let spread = spread(observations.len());
        let frames = observations.iter().enumerate().step_by(spread);
        let mut proportions = Self::of_size(model, cameras, frames.clone().map(|(_, o)| o))?;
        let scaled = proportions.of(model)?;
        let fit = BodyFit::new(&scaled, cameras)?;
        let (mut poses, mut used) = (Vec::new(), Vec::new());
        for (frame, observation) in frames {
            match fit.state(observation) {
                Ok(state) => {
                    poses.push(state);
                    used.push(observation);
                }
                // A frame that shows too little says nothing about lengths.
                Err(BodyError::TooFewPoints { .. }) => {}
                Err(error) => return Err(error.of_frame(frame)),
            }
        }
        proportions.fit(model, cameras, &used, poses, lengths, fit.likelihood().loss)?;
        Ok(proportions)
    }

    /// Those of the model, in the size that observations show.
    ///
    /// # Errors
    /// [`BodyError::NoBone`] where they do not show it.
    pub(crate) fn of_size<'o>(
        model: &BodyModel,
        cameras: &[Camera],
        observations: impl Iterator<Item = &'o Observation>,
    ) -> Result<Self, BodyError> {
        let size = super::start::size(&Chain::new(model), cameras, observations);
        Ok(Self {
            size: size.ok_or(BodyError::NoBone)?,
            logarithms: vec![0.0; model.skeleton().len()],
            beside: vec![None; model.points().len()],
            displacements: Vec::new(),
            deviations: Vec::new(),
        })
    }

    /// How much larger the person is than the model.
    pub(crate) fn size(&self) -> f64 {
        self.size
    }

    /// The same where points may lie beside their places, with deviations in the unit of the model.
    pub(crate) fn with_points_beside(mut self, mut beside: Vec<Option<Beside>>) -> Self {
        for beside in beside.iter_mut().flatten() {
            beside.deviation *= self.size;
        }
        let shared = beside.iter().flatten().map(|beside| beside.shared + 1);
        self.displacements = vec![[0.0; 3]; shared.max().unwrap_or(0)];
        self.beside = beside;
        self
    }

    /// Whether there are points that may lie beside their places.
    pub(crate) fn has_points_beside(&self) -> bool {
        !self.displacements.is_empty()
    }

    /// For each joint the factor of the way to it.
    pub(crate) fn factors(&self) -> Vec<f64> {
        let logarithms = self.logarithms.iter();
        logarithms
            .map(|logarithm| self.size * logarithm.exp())
            .collect()
    }

    /// The standard deviation of the length of the way to a joint, as a part of that length.
    pub(crate) fn deviation(&self, joint: usize) -> Option<f64> {
        *self.deviations.get(joint)?
    }

    /// How far points lie beside their places.
    pub(crate) fn displacement(&self, point: usize) -> Vector<f64> {
        let Some(beside) = &self.beside[point] else {
            return Vector::default();
        };
        let along = beside.axes.iter().zip(self.displacements[beside.shared]);
        along.fold(Vector::default(), |sum, (axis, part)| sum + *axis * part)
    }

    /// A model with these proportions.
    pub(crate) fn of(&self, model: &BodyModel) -> Result<BodyModel, SkeletonError> {
        let scaled = with_factors(model, &self.factors(), self.size)?;
        let points = scaled.points().iter().enumerate().map(|(index, point)| {
            let displacement = self.displacement(index);
            match self.beside[index] {
                // Points at joints stay there to the last digit.
                None => point.clone(),
                Some(_) => BodyPoint {
                    at_rest: (Vector::from(point.at_rest) + displacement).into(),
                    ..point.clone()
                },
            }
        });
        let points = points.collect();
        Ok(scaled.with_skeleton(scaled.skeleton().clone(), points))
    }

    /// Finds the most likely lengths and displacements together with the poses of frames, from
    /// states that are near; returns the poses.
    ///
    /// # Errors
    /// [`BodyError::NoBone`] where there is no frame, [`BodyError::LeastSquares`] and
    /// [`BodyError::Skeleton`].
    pub(crate) fn fit(
        &mut self,
        model: &BodyModel,
        cameras: &[Camera],
        observations: &[&Observation],
        poses: Vec<State>,
        lengths: Lengths,
        loss: Loss,
    ) -> Result<Vec<State>, BodyError> {
        if poses.is_empty() {
            return Err(BodyError::NoBone);
        }
        let of_one_size = Self {
            logarithms: vec![0.0; self.logarithms.len()],
            beside: vec![None; self.beside.len()],
            ..self.clone()
        };
        let scaled = of_one_size.of(model)?;
        let fit = BodyFit::new(&scaled, cameras)?;
        let bones = Bones::new(&scaled, lengths);
        let problem = LengthProblem {
            likelihood: fit.likelihood(),
            observations,
            bones: &bones,
            beside: &self.beside,
            lengths,
        };
        let options = Options {
            steps: 300,
            relative_tolerance: 1e-6,
            absolute_tolerance: INSIGNIFICANT,
            loss,
        };
        let mut logarithms = vec![0.0; bones.count];
        for (bone, logarithm) in bones.of_joint.iter().zip(&self.logarithms) {
            if let Some(bone) = *bone {
                logarithms[bone] = *logarithm;
            }
        }
        let start = Unknowns {
            logarithms,
            displacements: self.displacements.clone(),
            poses,
        };
        let minimum = minimise(&problem, start, &options)?;
        let covariance = minimum.covariance(1.0);
        let deviations = bones.of_joint.iter().map(|bone| {
            let bone = (*bone)?;
            covariance
                .as_ref()
                .map(|known| known.standard_deviation(bone))
        });
        self.deviations = deviations.collect();
        let found = minimum.state;
        let own = bones.of_joint.iter();
        let own = own.map(|bone| bone.map_or(0.0, |bone| found.logarithms[bone]));
        self.logarithms = own.collect();
        self.displacements = found.displacements;
        if lengths == Lengths::OneFactor {
            self.size *= found.logarithms[0].exp();
            self.logarithms.fill(0.0);
        }
        Ok(found.poses)
    }
}

/// Which unknown the way to each joint has.
struct Bones {
    of_joint: Vec<Option<usize>>,
    count: usize,
    /// Bones of the left and of the right side.
    pairs: Vec<[usize; 2]>,
}

impl Bones {
    fn new(model: &BodyModel, lengths: Lengths) -> Self {
        let joints = model.skeleton().joints();
        if lengths == Lengths::OneFactor {
            return Self {
                of_joint: vec![Some(0); joints.len()],
                count: 1,
                pairs: Vec::new(),
            };
        }
        let mut count = 0;
        let of_joint = joints.iter().map(|joint| {
            let parent = joint.parent?;
            (joints[parent].head != joint.head).then(|| {
                count += 1;
                count - 1
            })
        });
        let of_joint: Vec<Option<usize>> = of_joint.collect();
        let pairs = joints.iter().enumerate().filter_map(|(one, joint)| {
            let other = model.skeleton().index(&opposite_name(&joint.name)?)?;
            (one < other).then_some([of_joint[one]?, of_joint[other]?])
        });
        Self {
            pairs: pairs.collect(),
            of_joint,
            count,
        }
    }
}

/// The logarithms of factors, displacements of points, and the poses of all frames.
#[derive(Clone)]
struct Unknowns {
    logarithms: Vec<f64>,
    displacements: Vec<[f64; 3]>,
    poses: Vec<State>,
}

impl Unknowns {
    fn factor(&self, bone: Option<usize>) -> f64 {
        bone.map_or(1.0, |bone| self.logarithms[bone].exp())
    }
}

struct LengthProblem<'a> {
    likelihood: &'a Likelihood<'a>,
    observations: &'a [&'a Observation],
    bones: &'a Bones,
    beside: &'a [Option<Beside>],
    lengths: Lengths,
}

impl LengthProblem<'_> {
    /// The chain with the lengths of a state.
    fn chain(&self, state: &Unknowns) -> Chain<'_> {
        let factors = self.bones.of_joint.iter().map(|bone| state.factor(*bone));
        let levers = match self.lengths {
            Lengths::OneFactor => state.factor(Some(0)),
            Lengths::EachBone => 1.0,
        };
        let factors: Vec<f64> = factors.collect();
        let chain = self.likelihood.chain.with_factors(&factors, levers);
        let displacements = self.beside.iter().map(|beside| {
            let beside = beside.as_ref()?;
            let along = beside.axes.iter().zip(state.displacements[beside.shared]);
            Some(along.fold(Vector::default(), |sum, (axis, part)| sum + *axis * part))
        });
        chain.with_displacements(displacements)
    }

    /// The number of unknowns that all frames share.
    fn shared(&self) -> usize {
        self.bones.count + 3 * self.displacement_count()
    }

    fn displacement_count(&self) -> usize {
        let shared = self.beside.iter().flatten();
        shared.map(|beside| beside.shared + 1).max().unwrap_or(0)
    }

    /// What is known of people beside the pictures.
    fn add_prior(&self, state: &Unknowns, equations: &mut Equations) {
        if self.lengths == Lengths::EachBone {
            for (bone, logarithm) in state.logarithms.iter().enumerate() {
                equations.add([logarithm / PROPORTIONS], &[(bone, [1.0 / PROPORTIONS])]);
            }
        }
        for &[left, right] in &self.bones.pairs {
            let difference = state.logarithms[left] - state.logarithms[right];
            let slope = 1.0 / SYMMETRY;
            equations.add([difference * slope], &[(left, [slope]), (right, [-slope])]);
        }
        let mut is_done = vec![false; self.displacement_count()];
        for beside in self.beside.iter().flatten() {
            if std::mem::replace(&mut is_done[beside.shared], true) {
                continue;
            }
            let slope = 1.0 / beside.deviation;
            for (k, part) in state.displacements[beside.shared].iter().enumerate() {
                let column = self.bones.count + 3 * beside.shared + k;
                equations.add([part * slope], &[(column, [slope])]);
            }
        }
    }
}

impl Problem for LengthProblem<'_> {
    type State = Unknowns;

    fn columns(&self) -> Columns {
        let size = self.likelihood.chain.count;
        Columns::grouped(self.shared(), self.observations.len(), size)
    }

    fn evaluate(&self, state: &Unknowns, equations: &mut Equations) -> Option<()> {
        let chain = self.chain(state);
        let (mut rows, mut derivatives) = (Vec::new(), Vec::new());
        let (shared, size) = (self.shared(), self.likelihood.chain.count);
        for (frame, (pose, observation)) in state.poses.iter().zip(self.observations).enumerate() {
            let places = chain.places(pose);
            for point in 0..places.points.len() {
                chain.derivatives(&places, point, &mut rows);
                let mut by_unknown: Vec<(usize, Vector<f64>)> = rows
                    .iter()
                    .map(|(column, row)| (shared + frame * size + column, *row))
                    .collect();
                match self.lengths {
                    Lengths::OneFactor => {
                        by_unknown.push((0, places.points[point] - pose.translation));
                    }
                    Lengths::EachBone => {
                        chain.derivatives_by_bones(&places, point, |joint, row| {
                            if let Some(bone) = self.bones.of_joint[joint] {
                                by_unknown.push((bone, row));
                            }
                        });
                    }
                }
                if let Some(beside) = &self.beside[point] {
                    let first = self.bones.count + 3 * beside.shared;
                    let axes = beside.axes.iter().enumerate();
                    by_unknown.extend(
                        axes.map(|(k, axis)| {
                            (first + k, chain.rotated_with(&places, point, *axis))
                        }),
                    );
                }
                for (camera, pixels) in self.likelihood.cameras.iter().zip(&observation.views) {
                    let Some(pixel) = pixels[point] else { continue };
                    let seen = camera
                        .project_with_derivatives(places.points[point].into())
                        .ok()?;
                    let residual =
                        [0, 1].map(|k| (seen.pixel[k] - pixel.position[k]) / pixel.deviation);
                    let slopes = seen.by_point.map(|row| Vector::from(row) / pixel.deviation);
                    derivatives.clear();
                    derivatives.extend(
                        by_unknown
                            .iter()
                            .map(|(column, row)| (*column, slopes.map(|slope| slope.dot(*row)))),
                    );
                    equations.add(residual, &derivatives);
                }
            }
            self.likelihood
                .rest_residuals(pose, |column, residual, slope| {
                    equations.add([residual], &[(shared + frame * size + column, [slope])]);
                });
        }
        self.add_prior(state, equations);
        Some(())
    }

    fn stepped(&self, state: &Unknowns, step: &[f64]) -> Option<Unknowns> {
        let (shared, size) = (self.shared(), self.likelihood.chain.count);
        let (own, of_poses) = step.split_at(shared);
        let (of_bones, of_displacements) = own.split_at(self.bones.count);
        let poses = state.poses.iter().zip(of_poses.chunks_exact(size));
        let poses = poses.map(|(pose, step)| self.likelihood.chain.stepped(pose, step));
        let logarithms = state.logarithms.iter().zip(of_bones).map(|(a, b)| a + b);
        let displacements = state
            .displacements
            .iter()
            .zip(of_displacements.chunks_exact(3));
        let displacements = displacements.map(|(own, step)| [0, 1, 2].map(|k| own[k] + step[k]));
        Some(Unknowns {
            logarithms: logarithms.collect(),
            displacements: displacements.collect(),
            poses: poses.collect::<Option<_>>()?,
        })
    }
}

/// The body with the way to each joint times a factor, and what lies beside the bones times
/// another.
fn with_factors(
    model: &BodyModel,
    factors: &[f64],
    beside: f64,
) -> Result<BodyModel, SkeletonError> {
    let old = model.skeleton().joints();
    let mut joints: Vec<Joint> = Vec::with_capacity(old.len());
    for (joint, factor) in old.iter().zip(factors) {
        let above = joint
            .parent
            .map(|parent| (old[parent].head, joints[parent].head));
        let (from, to) = above.unwrap_or_default();
        let way = Vector::from(joint.head) - Vector::from(from);
        let head = Vector::from(to) + way * *factor;
        // A bone that ends at the joint below is as long as the way there.
        let below = old.iter().position(|other| {
            other.parent.is_some_and(|parent| old[parent] == *joint) && other.head == joint.tail
        });
        let own = below.map_or(beside, |below| factors[below]);
        let tail = head + (Vector::from(joint.tail) - Vector::from(joint.head)) * own;
        joints.push(Joint {
            head: head.into(),
            tail: tail.into(),
            ..joint.clone()
        });
    }
    let points = model.points().iter().map(|point| {
        let strongest = point.joints.iter().max_by(|a, b| a.1.total_cmp(&b.1));
        let joint = strongest.map_or(0, |(joint, _)| *joint);
        let lever = Vector::from(point.at_rest) - Vector::from(old[joint].head);
        BodyPoint {
            at_rest: (Vector::from(joints[joint].head) + lever * beside).into(),
            ..point.clone()
        }
    });
    let points = points.collect();
    Ok(model.with_skeleton(Skeleton::new(joints)?, points))
}
