//! A whole pose from the places of markers: least squares over the motors of all joints.

mod alignment;
mod levers;
mod marker;
mod options;

use super::check::{check_tolerance, exists, finite, fits};
use super::motion::with_rotation;
use super::rotation::rotated;
use ga_numerics::least_squares::{Attempt, Damping, Descent, Search};
use ga_runtime::cga3::{Motor, Rotor, Translator};
use ga_runtime::geometry::RotationPath;
use ga_runtime::vga3::Vector;

use super::normal_equations::{Blocked, NormalEquations};

use crate::kinematics::KinematicsError;
use crate::pose::{Pose, moved};
use crate::skeleton::{JointLimits, Skeleton};
use levers::{Levers, extent, levers, movers};
pub use marker::{Marker, Target};
pub use options::PoseFitOptions;

/// How well a pose fits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoseFitReport {
    /// How many steps were tried.
    pub iterations: usize,
    /// Whether the last step was within the tolerance, so that more would not help.
    pub converged: bool,
    /// The root of the weighted mean of the squared distances between markers and targets.
    pub root_mean_square_error: f64,
    /// The greatest distance of a marker whose weight is not 0.
    pub greatest_error: f64,
}

/// A fit of a skeleton's poses to the places of markers, prepared for many frames.
///
/// The sum `Σ w |G m ~G − t|²` over all markers m with their targets t is made least over the
/// translation of the body and the rotation of every joint that carries a marker, by damped
/// Gauss–Newton steps (Levenberg, 1944; Marquardt, 1963). The unknowns of a step are the generators
/// of the joints' rotations: with the joint in the place h, a rotation about the line through h
/// along a moves a marker in the place p at the velocity `a × (p − h)`, and
///
/// ```text
/// R ← exp(−½ δ·B) R
/// ```
///
/// A joint whose step would leave its limits is clamped, and the step is computed anew without what
/// took it there. The result keeps to the limits and is never worse than the start. Where joints
/// end at their limits, it may stop short of the least sum.
///
/// What the places do not determine, such as the twist of a bone with nothing beside it, stays as
/// in the pose that the search starts from: no step has a part in such a direction.
///
/// ```
/// use ga_anim::inverse_kinematics::{Marker, PoseFit, PoseFitOptions, Target};
/// use ga_anim::pose::Pose;
/// use ga_anim::skeleton::{Joint, Skeleton};
/// use ga_runtime::cga3::{Motor, Point, Rotor};
///
/// let joint = |name: &str, parent, y: f64| Joint {
///     name: name.into(),
///     parent,
///     head: [0.0, y, 0.0],
///     tail: [0.0, y + 1.0, 0.0],
/// };
/// let arm = Skeleton::new(vec![joint("upper", None, 0.0), joint("lower", Some(0), 1.0)])?;
/// let bend = Rotor::from_axis_angle([1.0, 0.0, 0.0], 1.2).ok_or("no axis")?;
/// let truth = Pose::from_rotors(&arm, Motor::default(), &[bend, bend])?;
///
/// let markers = [(0, [0.0; 3]), (1, [0.0, 1.0, 0.0]), (1, [0.0, 2.0, 0.0])];
/// let markers = markers.map(|(joint, at_rest)| Marker { joint, at_rest });
/// let mut fit = PoseFit::new(&arm, None, markers.to_vec())?;
/// let motions = truth.motions(&arm)?;
/// let targets = markers.map(|marker| Target {
///     position: motions[marker.joint].transform(Point::from(marker.at_rest)),
///     weight: 1.0,
/// });
/// let mut pose = Pose::rest(2);
/// let report = fit.solve(&targets, &mut pose, &PoseFitOptions::default())?;
/// assert!(report.greatest_error < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct PoseFit<'a> {
    skeleton: &'a Skeleton,
    limits: Option<&'a JointLimits>,
    markers: Vec<Marker>,
    /// For each joint, its first column and how many it has: 3 for a free joint, 1 for a hinge, 0
    /// for one that is fixed or carries no marker.
    columns: Vec<(usize, usize)>,
    /// For each marker, the joints that move it, from the root on.
    movers: Vec<Vec<usize>>,
    /// For each joint, the markers at a fixed distance from it, and the marker at its head.
    levers: Vec<Levers>,
    /// The extent of the skeleton, the unit of the translation.
    extent: f64,
    motions: Vec<Motor<f64>>,
    trial: Pose,
    candidate: Pose,
    blocked: Vec<Blocked>,
    rows: Vec<(usize, Vector<f64>)>,
    pairs: Vec<(f64, [f64; 3], [f64; 3])>,
    equations: NormalEquations,
}

/// The columns of the translation.
const TRANSLATION: usize = 3;
const DAMPING: Damping = Damping {
    first: 1e-3,
    least: 1e-11,
    greatest: 1e12,
};
/// The angle in radians from which on a rotation is beyond a joint's limits.
const BEYOND: f64 = 1e-12;

impl<'a> PoseFit<'a> {
    /// Prepares fits of a skeleton, whose joints keep to limits, to markers.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::NoMarkers`], [`KinematicsError::NoJoint`],
    /// [`KinematicsError::NotFinite`], [`KinematicsError::Limits`].
    pub fn new(
        skeleton: &'a Skeleton,
        limits: Option<&'a JointLimits>,
        markers: Vec<Marker>,
    ) -> Result<Self, KinematicsError> {
        if markers.is_empty() {
            return Err(KinematicsError::NoMarkers);
        }
        for marker in &markers {
            exists(skeleton, marker.joint)?;
            finite("a marker", marker.at_rest)?;
        }
        let trial = Pose::rest(skeleton.len());
        fits(skeleton, limits, &trial)?;
        let movers: Vec<Vec<usize>> = markers
            .iter()
            .map(|marker| movers(skeleton, marker))
            .collect();
        let mut moves = vec![false; skeleton.len()];
        for &joint in movers.iter().flatten() {
            moves[joint] = true;
        }
        let mut count = TRANSLATION;
        let columns = moves.into_iter().enumerate().map(|(joint, moves)| {
            let is_hinge = limits.is_some_and(|limits| limits.hinge_axis(joint).is_some());
            let is_fixed = limits.is_some_and(|limits| limits.is_fixed(joint));
            let own = match (moves && !is_fixed, is_hinge) {
                (false, _) => 0,
                (true, true) => 1,
                (true, false) => 3,
            };
            count += own;
            (count - own, own)
        });
        let columns: Vec<(usize, usize)> = columns.collect();
        Ok(Self {
            levers: levers(skeleton, &markers),
            movers,
            columns,
            extent: extent(&markers),
            motions: vec![Motor::default(); skeleton.len()],
            candidate: trial.clone(),
            blocked: Vec::new(),
            rows: Vec::new(),
            pairs: Vec::new(),
            equations: NormalEquations::new(count),
            trial,
            skeleton,
            limits,
            markers,
        })
    }

    /// The markers.
    #[must_use]
    pub fn markers(&self) -> &[Marker] {
        &self.markers
    }

    /// Moves a pose so that the markers come as near to their targets as they can, from the pose
    /// given.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Targets`], [`KinematicsError::NotFinite`], [`KinematicsError::Weight`],
    /// [`KinematicsError::Skeleton`], [`KinematicsError::Tolerance`]. The pose is then as it was.
    pub fn solve(
        &mut self,
        targets: &[Target],
        pose: &mut Pose,
        options: &PoseFitOptions,
    ) -> Result<PoseFitReport, KinematicsError> {
        check_tolerance(options.tolerance)?;
        self.check(targets, pose)?;
        let mut best = pose.clone();
        self.clamp(&mut best);
        let mut cost = self.cost(&best, targets);
        if options.align_first {
            let mut aligned = best.clone();
            self.align(&mut aligned, targets, options.root_motion);
            let found = self.cost(&aligned, targets);
            if found < cost {
                (best, cost) = (aligned, found);
            }
        }
        self.linearise(&best, targets, options.root_motion);
        let mut descent = Descending {
            fit: self,
            targets,
            options,
            best,
        };
        let mut search = Search::new(cost, DAMPING);
        let found = search.run(&mut descent, options.iterations);
        let (best, iterations) = (descent.best, found.steps);
        let converged = found.has_converged || search.is_exhausted();
        let report = self.report(&best, targets, iterations, converged);
        *pose = best;
        Ok(report)
    }

    fn check(&self, targets: &[Target], pose: &Pose) -> Result<(), KinematicsError> {
        let (expected, found) = (self.markers.len(), targets.len());
        if expected != found {
            return Err(KinematicsError::Targets { expected, found });
        }
        fits(self.skeleton, self.limits, pose)?;
        let mut greatest = 0.0_f64;
        for (index, &Target { position, weight }) in targets.iter().enumerate() {
            if !weight.is_finite() || weight < 0.0 {
                return Err(KinematicsError::Weight { index, weight });
            }
            if weight > 0.0 {
                finite("a target", position)?;
            }
            greatest = greatest.max(weight);
        }
        if greatest > 0.0 {
            return Ok(());
        }
        let (index, weight) = (0, 0.0);
        Err(KinematicsError::Weight { index, weight })
    }

    /// The total motions of all joints in a pose.
    fn update_motions(&mut self, pose: &Pose) {
        for (index, joint) in self.skeleton.joints().iter().enumerate() {
            let above = joint
                .parent
                .map_or(pose.root, |parent| self.motions[parent]);
            self.motions[index] = above * pose.joints[index];
        }
    }

    fn place(&self, marker: usize) -> Vector<f64> {
        let Marker { joint, at_rest } = self.markers[marker];
        moved(self.motions[joint], at_rest).into()
    }

    fn head(&self, joint: usize) -> Vector<f64> {
        moved(self.motions[joint], self.skeleton.joints()[joint].head).into()
    }

    /// The weighted sum of squared distances; infinite where it is not a number.
    fn cost(&mut self, pose: &Pose, targets: &[Target]) -> f64 {
        self.update_motions(pose);
        let mut sum = 0.0;
        for (marker, target) in targets.iter().enumerate() {
            if target.weight > 0.0 {
                let residual = self.place(marker) - Vector::from(target.position);
                sum += target.weight * residual.length_squared();
            }
        }
        if sum.is_finite() { sum } else { f64::INFINITY }
    }

    /// The normal equations at a pose.
    fn linearise(&mut self, pose: &Pose, targets: &[Target], root_motion: bool) {
        self.update_motions(pose);
        self.equations.clear();
        let axes =
            [0, 1, 2].map(|k| Vector::from(std::array::from_fn(|i| f64::from(u8::from(i == k)))));
        for (marker, target) in targets.iter().enumerate() {
            if target.weight == 0.0 {
                continue;
            }
            let place = self.place(marker);
            self.rows.clear();
            if root_motion {
                let unit = self.extent;
                self.rows.extend(
                    axes.into_iter()
                        .enumerate()
                        .map(|(k, axis)| (k, axis * unit)),
                );
            }
            for &joint in &self.movers[marker] {
                let (first, count) = self.columns[joint];
                let lever = place - self.head(joint);
                match count {
                    0 => {}
                    1 => self
                        .rows
                        .push((first, self.hinge(pose, joint).cross(lever))),
                    _ => {
                        let derivatives = axes.map(|axis| axis.cross(lever));
                        let rows = derivatives.into_iter().enumerate();
                        self.rows
                            .extend(rows.map(|(k, derivative)| (first + k, derivative)));
                    }
                }
            }
            let residual = place - Vector::from(target.position);
            self.equations.add(&self.rows, residual, target.weight);
        }
    }

    /// The axis of a hinge in the coordinates of the world.
    fn hinge(&self, pose: &Pose, joint: usize) -> Vector<f64> {
        let axis = self.limits.and_then(|limits| limits.hinge_axis(joint));
        rotated(self.above(pose, joint).rotor(), axis.unwrap_or_default())
    }

    /// The total motion above a joint.
    fn above(&self, pose: &Pose, joint: usize) -> Motor<f64> {
        let parent = self.skeleton.joints()[joint].parent;
        parent.map_or(pose.root, |parent| self.motions[parent])
    }

    /// The candidate: the best of a few trial poses, each after a step that leaves out what took
    /// joints beyond their limits in the steps before. The size of the first step, and the cost of
    /// the candidate.
    fn search(&mut self, pose: &Pose, targets: &[Target], damping: f64) -> Attempt {
        const ROUNDS: usize = 4;
        self.blocked.clear();
        let mut attempt = Attempt::NONE;
        for round in 0..ROUNDS {
            let known = self.blocked.len();
            let Some(found) = self.step(pose, damping) else {
                break;
            };
            if round == 0 {
                attempt.size = found;
            }
            let predicted = self.equations.predicted(damping);
            let trial = std::mem::replace(&mut self.trial, Pose::rest(0));
            let cost = self.cost(&trial, targets);
            self.trial = trial;
            if cost < attempt.cost {
                (attempt.cost, attempt.predicted) = (cost, predicted);
                std::mem::swap(&mut self.trial, &mut self.candidate);
            }
            if self.blocked.len() == known {
                break;
            }
        }
        attempt
    }

    /// The trial pose: a pose after a step with this damping, without blocked directions. The size
    /// of the step.
    fn step(&mut self, pose: &Pose, damping: f64) -> Option<f64> {
        // The motions may be those of a trial that was refused.
        self.update_motions(pose);
        self.equations.solve(damping, &self.blocked)?;
        let step = self.equations.step();
        let size = step.norm();
        let displacement = [0, 1, 2].map(|k| step[k] * self.extent);
        self.trial.root = Translator::from_displacement(displacement) * pose.root;
        self.trial.joints.clear();
        self.trial.joints.extend_from_slice(&pose.joints);
        for (joint, &(first, count)) in self.columns.iter().enumerate() {
            let limits = self.limits;
            if count == 0 {
                continue;
            }
            let parent = self.skeleton.joints()[joint].parent;
            let above = parent
                .map_or(pose.root, |parent| self.motions[parent])
                .rotor();
            let hinge = limits.and_then(|limits| limits.hinge_axis(joint));
            let axis = match hinge {
                Some(axis) => axis * step[first],
                None => {
                    let world = Vector::from([0, 1, 2].map(|k| step[first + k]));
                    rotated(above.reverse(), world)
                }
            };
            let rotor = Rotor::from_rotation_vector(axis.into())?;
            let (own, head) = (pose.joints[joint], self.skeleton.joints()[joint].head);
            let clamped = with_rotation(limits, joint, head, own, rotor);
            self.trial.joints[joint] = clamped;
            if limits.is_none() {
                continue;
            }
            let beyond = rotor * own.rotor() * clamped.rotor().reverse();
            let beyond = Vector::from(beyond.along(RotationPath::Short).to_rotation_vector());
            let direction = match hinge {
                Some(axis) => Vector::new(beyond.dot(axis).signum(), 0.0, 0.0),
                None => rotated(above, beyond.normalized().unwrap_or_default()),
            };
            let blocked = Blocked {
                first,
                count,
                direction,
            };
            // A joint that would come back from its limit by itself is not held there.
            if beyond.length() > BEYOND && self.equations.falls(&blocked) {
                self.blocked.push(blocked);
            }
        }
        Some(size)
    }

    /// Every joint of a pose within its limits.
    fn clamp(&self, pose: &mut Pose) {
        if self.limits.is_some() {
            for (joint, own) in pose.joints.iter_mut().enumerate() {
                let head = self.skeleton.joints()[joint].head;
                *own = with_rotation(self.limits, joint, head, *own, Rotor::default());
            }
        }
    }

    fn report(
        &mut self,
        pose: &Pose,
        targets: &[Target],
        iterations: usize,
        converged: bool,
    ) -> PoseFitReport {
        self.update_motions(pose);
        let (mut sum, mut total, mut greatest_error) = (0.0, 0.0, 0.0_f64);
        for (marker, target) in targets.iter().enumerate() {
            if target.weight > 0.0 {
                let distance = self.place(marker).distance(target.position.into());
                sum += target.weight * distance * distance;
                total += target.weight;
                greatest_error = greatest_error.max(distance);
            }
        }
        PoseFitReport {
            iterations,
            converged,
            root_mean_square_error: (sum / total).sqrt(),
            greatest_error,
        }
    }
}

/// A pose on its way to the least sum.
struct Descending<'f, 'a> {
    fit: &'f mut PoseFit<'a>,
    targets: &'f [Target],
    options: &'f PoseFitOptions,
    best: Pose,
}

impl Descent for Descending<'_, '_> {
    fn attempt(&mut self, damping: f64) -> Attempt {
        let attempt = self.fit.search(&self.best, self.targets, damping);
        Attempt {
            is_small: attempt.size <= self.options.tolerance,
            ..attempt
        }
    }

    fn accept(&mut self) {
        self.best.root = self.fit.candidate.root;
        self.best.joints.copy_from_slice(&self.fit.candidate.joints);
        self.fit
            .linearise(&self.best, self.targets, self.options.root_motion);
    }
}
