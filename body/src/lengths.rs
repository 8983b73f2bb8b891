//! Lengths of bones from what views show.

use ga_anim::skeleton::{Joint, Skeleton, SkeletonError};
use ga_runtime::vga3::Vector;

use super::chain::{Chain, State};
use super::likelihood::Likelihood;
use super::model::{BodyModel, BodyPoint};
use super::{BodyFit, Observation};
use crate::BodyError;
use ga_camera::Camera;
use ga_numerics::least_squares::{Columns, Equations, Options, Problem, minimise};

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
    if cameras.len() < 2 {
        return Err(BodyError::OneView(cameras.len()));
    }
    let spread = observations.len().div_ceil(FRAMES).max(1);
    let frames: Vec<(usize, &Observation)> =
        observations.iter().enumerate().step_by(spread).collect();
    let size = super::start::size(&Chain::new(model), cameras, frames.iter().map(|(_, o)| *o));
    let size = size.ok_or(BodyError::NoBone)?;
    let joints = model.skeleton().len();
    let scaled = with_factors(model, &vec![size; joints], size)?;
    let of_camera = |error| BodyError::Frame {
        frame: 0,
        error: Box::new(error),
    };
    let fit = BodyFit::new(&scaled, cameras).map_err(of_camera)?;
    let (mut poses, mut used) = (Vec::new(), Vec::new());
    for (frame, observation) in frames {
        match fit.state(observation) {
            Ok(state) => {
                poses.push(state);
                used.push(observation);
            }
            // A frame that shows too little says nothing about lengths.
            Err(BodyError::TooFewPoints { .. }) => {}
            Err(error) => {
                return Err(BodyError::Frame {
                    frame,
                    error: Box::new(error),
                });
            }
        }
    }
    if poses.is_empty() {
        return Err(BodyError::NoBone);
    }
    let bones = Bones::new(&scaled, lengths);
    let logarithms = vec![0.0; bones.count];
    let problem = LengthProblem {
        likelihood: fit.likelihood(),
        observations: &used,
        bones: &bones,
        lengths,
    };
    let options = Options {
        steps: 300,
        relative_tolerance: 1e-6,
        absolute_tolerance: INSIGNIFICANT,
        loss: fit.likelihood().loss,
    };
    let start = Unknowns { logarithms, poses };
    let found = minimise(&problem, start, &options)?.state;
    let own: Vec<f64> = bones
        .of_joint
        .iter()
        .map(|bone| found.factor(*bone))
        .collect();
    let all = match lengths {
        Lengths::OneFactor => found.factor(Some(0)),
        Lengths::EachBone => 1.0,
    };
    let factors: Vec<f64> = own.iter().map(|own| own * size).collect();
    Ok(FittedLengths {
        model: with_factors(model, &factors, all * size)?,
        factors,
    })
}

/// Which unknown the way to each joint has.
struct Bones {
    of_joint: Vec<Option<usize>>,
    count: usize,
}

impl Bones {
    fn new(model: &BodyModel, lengths: Lengths) -> Self {
        let joints = model.skeleton().joints();
        if lengths == Lengths::OneFactor {
            let of_joint = vec![Some(0); joints.len()];
            return Self { of_joint, count: 1 };
        }
        let mut count = 0;
        let of_joint = joints.iter().map(|joint| {
            let parent = joint.parent?;
            (joints[parent].head != joint.head).then(|| {
                count += 1;
                count - 1
            })
        });
        Self {
            of_joint: of_joint.collect(),
            count,
        }
    }
}

/// The logarithms of factors, and the poses of all frames.
#[derive(Clone)]
struct Unknowns {
    logarithms: Vec<f64>,
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
        self.likelihood.chain.with_factors(&factors, levers)
    }
}

impl Problem for LengthProblem<'_> {
    type State = Unknowns;

    fn columns(&self) -> Columns {
        let (shared, size) = (self.bones.count, self.likelihood.chain.count);
        Columns::grouped(shared, self.observations.len(), size)
    }

    fn evaluate(&self, state: &Unknowns, equations: &mut Equations) -> Option<()> {
        let chain = self.chain(state);
        let (mut rows, mut derivatives) = (Vec::new(), Vec::new());
        let (shared, size) = (self.bones.count, self.likelihood.chain.count);
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
        if self.lengths == Lengths::EachBone {
            for (bone, logarithm) in state.logarithms.iter().enumerate() {
                equations.add([logarithm / PROPORTIONS], &[(bone, [1.0 / PROPORTIONS])]);
            }
        }
        Some(())
    }

    fn stepped(&self, state: &Unknowns, step: &[f64]) -> Option<Unknowns> {
        let (shared, size) = (self.bones.count, self.likelihood.chain.count);
        let (of_bones, of_poses) = step.split_at(shared);
        let poses = state.poses.iter().zip(of_poses.chunks_exact(size));
        let poses = poses.map(|(pose, step)| self.likelihood.chain.stepped(pose, step));
        let logarithms = state.logarithms.iter().zip(of_bones).map(|(a, b)| a + b);
        Some(Unknowns {
            logarithms: logarithms.collect(),
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
