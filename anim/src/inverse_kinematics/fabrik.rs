//! FABRIK: forward and backward reaching (Aristidou and Lasenby, FABRIK: a fast, iterative solver
//! for the inverse kinematics problem, Graphical Models 73, 2011).

use super::check::{below, check_tolerance, exists, finite, fits};
use super::motion::{own_motion, total_motion, with_rotation};
use ga_runtime::cga3::{Line, Point, Rotor};
use ga_runtime::ga;
use ga_runtime::vga3::Vector;

use super::two_bone::displaced;
use crate::kinematics::KinematicsError;
use crate::pose::{Pose, moved};
use crate::skeleton::{JointLimits, Skeleton};

ga! { ga_runtime::cga3;
    /// The point of the sphere about a centre that is nearest to another point p: the centre,
    /// displaced along the line to p by the radius.
    fn drawn(centre: Point, p: Point, radius: Scalar) -> Point {
        let displacement = (radius / sqrt(-2 * (centre | p))) * ((p - centre) ^ ei);
        sandwich(1 - displacement / 2, centre)
    }
}

/// A chain of bones, by their lengths.
///
/// One iteration draws the chain to the target and back to its root: from the end to the root each
/// joint goes to the nearest point of the sphere about the joint after it, with the bone between as
/// the radius, and then from the root to the end in the same way.
///
/// ```
/// use ga_anim::inverse_kinematics::{Fabrik, FabrikOptions};
/// use ga_runtime::cga3::Point;
///
/// let chain = Fabrik::new(vec![1.0, 1.0, 1.0])?;
/// let mut joints = [0.0, 1.0, 2.0, 3.0].map(|x| Point::new(x, 0.0, 0.0));
/// let target = Point::new(1.0, 1.5, 0.5);
/// let report = chain.solve(&mut joints, target, &FabrikOptions::default())?;
/// assert!(report.distance <= 1e-6 && joints[3].distance(target) <= 1e-6);
/// assert!((joints[1].distance(joints[2]) - 1.0).abs() < 1e-15);
/// # Ok::<(), ga_anim::kinematics::KinematicsError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Fabrik {
    lengths: Vec<f64>,
    total: f64,
}

/// When an iteration ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FabrikOptions {
    /// The end is at the target when it is no farther away than this.
    pub tolerance: f64,
    /// The greatest number of iterations.
    pub iterations: usize,
}

impl Default for FabrikOptions {
    /// 1e-6 and 100 iterations.
    fn default() -> Self {
        Self {
            tolerance: 1e-6,
            iterations: 100,
        }
    }
}

/// How near a chain came.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FabrikReport {
    /// How many iterations were done.
    pub iterations: usize,
    /// The distance of the end from the target.
    pub distance: f64,
}

impl Fabrik {
    /// A chain with bones of these lengths, from the root.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Chain`] for no bones and [`KinematicsError::Length`] for a length that is
    /// not positive and finite.
    pub fn new(lengths: Vec<f64>) -> Result<Self, KinematicsError> {
        if lengths.is_empty() {
            let (bones, points) = (0, 1);
            return Err(KinematicsError::Chain { bones, points });
        }
        let wrong = |length: f64| !length.is_finite() || length <= 0.0;
        if let Some(bone) = lengths.iter().position(|&length| wrong(length)) {
            let length = lengths[bone];
            return Err(KinematicsError::Length { bone, length });
        }
        let total = lengths.iter().sum();
        Ok(Self { lengths, total })
    }

    /// The lengths of the bones.
    #[must_use]
    pub fn lengths(&self) -> &[f64] {
        &self.lengths
    }

    /// Moves the joints of the chain, one more than bones, so that the last one comes to a target;
    /// the first one stays. The bones have their lengths afterwards, also where the joints given
    /// are farther apart or nearer together.
    ///
    /// A target beyond the length of the chain gives the straight chain that points to it, which is
    /// the nearest. Where one bone is longer than all others together and the target is too near
    /// the root, the iterations go on to their limit. A straight chain whose target is on its line
    /// is bent a little first, to an arbitrary side, since the spheres would not leave the line.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Chain`] for another number of joints, [`KinematicsError::NotFinite`], and
    /// [`KinematicsError::Tolerance`].
    pub fn solve(
        &self,
        joints: &mut [Point<f64>],
        target: Point<f64>,
        options: &FabrikOptions,
    ) -> Result<FabrikReport, KinematicsError> {
        check_tolerance(options.tolerance)?;
        self.check(joints, target)?;
        let last = self.lengths.len();
        if joints[0].distance(target) >= self.total {
            self.straighten(joints, target);
            let distance = joints[last].distance(target);
            return Ok(FabrikReport {
                iterations: 0,
                distance,
            });
        }
        self.leave_line(joints, target, 0);
        let mut iterations = 0;
        let mut distance = self.restore(joints, target);
        while distance > options.tolerance && iterations < options.iterations {
            self.iterate(joints, target);
            distance = joints[last].distance(target);
            iterations += 1;
        }
        Ok(FabrikReport {
            iterations,
            distance,
        })
    }

    /// One iteration, without any checks: from the end to the root and back. For loops that decide
    /// themselves when to stop. Joints beyond the chain's are left alone, and so are fewer joints.
    #[inline]
    pub fn iterate(&self, joints: &mut [Point<f64>], target: Point<f64>) {
        if joints.len() <= self.lengths.len() {
            return;
        }
        let root = joints[0];
        self.reach_backward(joints, target);
        joints[0] = root;
        self.reach_forward(joints);
    }

    /// The end to the target, and every other joint to the sphere about the next one.
    #[inline]
    fn reach_backward(&self, joints: &mut [Point<f64>], target: Point<f64>) {
        let mut next = target;
        joints[self.lengths.len()] = target;
        for (joint, &length) in joints.iter_mut().zip(&self.lengths).rev() {
            *joint = towards(next, *joint, length);
            next = *joint;
        }
    }

    /// Every joint but the root to the sphere about the one before it.
    #[inline]
    fn reach_forward(&self, joints: &mut [Point<f64>]) {
        let mut before = joints[0];
        for (joint, &length) in joints[1..].iter_mut().zip(&self.lengths) {
            *joint = towards(before, *joint, length);
            before = *joint;
        }
    }

    /// Gives the bones their lengths; how far the end is from the target then.
    fn restore(&self, joints: &mut [Point<f64>], target: Point<f64>) -> f64 {
        let away = |(ends, &length): (&[Point<f64>], &f64)| {
            (ends[0].distance(ends[1]) - length).abs() > 1e-12 * self.total
        };
        if joints.windows(2).zip(&self.lengths).any(away) {
            self.reach_forward(joints);
        }
        joints[self.lengths.len()].distance(target)
    }

    fn straighten(&self, joints: &mut [Point<f64>], target: Point<f64>) {
        let root = joints[0];
        let mut along = 0.0;
        for (joint, &length) in joints[1..].iter_mut().zip(&self.lengths) {
            along += length;
            *joint = towards(root, target, along);
        }
    }

    /// Bends a chain that is on the line to its target, to one of four sides. Whether it was there.
    fn leave_line(&self, joints: &mut [Point<f64>], target: Point<f64>, side: usize) -> bool {
        const ON_LINE: f64 = 1e-9;
        const ASIDE: f64 = 1e-2;
        let (root, last) = (joints[0], self.lengths.len());
        let Some(towards) = root.vector_to(target).normalized() else {
            return false;
        };
        let line = Line::from_point_direction(root, towards.into());
        let near = ON_LINE * self.total;
        let is_on = |joint: &Point<f64>| line.distance(*joint).is_some_and(|away| away <= near);
        if joints[last].distance(target) <= near || !joints.iter().all(is_on) {
            return false;
        }
        let [first, second] = towards.orthonormal_pair();
        let aside = [first, -first, second, -second][side % 4];
        // The end remains on the line.
        for (joint, &length) in joints[1..last].iter_mut().zip(&self.lengths) {
            *joint = displaced(*joint, aside * (ASIDE * length));
        }
        true
    }

    fn check(&self, joints: &[Point<f64>], target: Point<f64>) -> Result<(), KinematicsError> {
        let (bones, points) = (self.lengths.len(), joints.len());
        if points != bones + 1 {
            return Err(KinematicsError::Chain { bones, points });
        }
        finite("the target", target)?;
        joints
            .iter()
            .try_for_each(|&joint| finite("a joint", joint))
    }
}

/// The point at a distance from a centre towards another point; where that is the centre itself,
/// in some direction.
#[inline]
fn towards(centre: Point<f64>, point: Point<f64>, length: f64) -> Point<f64> {
    if centre == point {
        return displaced(centre, Vector::new(0.0, length, 0.0));
    }
    drawn(centre, point, length)
}

/// Moves a chain of joints of a pose so that the head of the last one comes to a target, with every
/// joint but the last rotating, within its limits. Each joint must be below the one before; joints
/// in between move with the one above them.
///
/// The chain is solved by [`Fabrik`], and on the way from the root to the end each bone is rotated
/// by the shortest rotation, which adds no twist, and that rotation is clamped. Where that leads
/// hardly nearer, each joint in turn, from the end to the root, rotates the end towards the target
/// as far as its limits admit. With limits this is a search that may end beside the target; the
/// report says how far, and [`PoseFit`](super::PoseFit) may come nearer.
///
/// # Errors
///
/// [`KinematicsError::NoJoint`], [`KinematicsError::NotBelow`], [`KinematicsError::Skeleton`],
/// [`KinematicsError::Limits`], [`KinematicsError::NotFinite`], [`KinematicsError::Chain`] for
/// fewer than two joints, [`KinematicsError::ZeroLengthBone`] with the joint's name,
/// [`KinematicsError::Tolerance`].
///
/// ```
/// use ga_anim::inverse_kinematics::{FabrikOptions, reach_with_chain};
/// use ga_anim::pose::Pose;
/// use ga_anim::skeleton::{Joint, Skeleton};
/// use ga_runtime::cga3::Point;
///
/// let joint = |name: &str, parent, x: f64| Joint {
///     name: name.into(),
///     parent,
///     head: [x, 0.0, 0.0],
///     tail: [x + 1.0, 0.0, 0.0],
/// };
/// let tail = Skeleton::new(vec![
///     joint("a", None, 0.0),
///     joint("b", Some(0), 1.0),
///     joint("c", Some(1), 2.0),
///     joint("tip", Some(2), 3.0),
/// ])?;
/// let mut pose = Pose::rest(4);
/// let target = Point::new(1.0, 1.0, 1.0);
/// let options = FabrikOptions::default();
/// reach_with_chain(&tail, None, &mut pose, &[0, 1, 2, 3], target, &options)?;
/// assert!(target.distance(pose.bones(&tail)?[3][0].into()) <= 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn reach_with_chain(
    skeleton: &Skeleton,
    limits: Option<&JointLimits>,
    pose: &mut Pose,
    chain: &[usize],
    target: Point<f64>,
    options: &FabrikOptions,
) -> Result<FabrikReport, KinematicsError> {
    check_tolerance(options.tolerance)?;
    for &joint in chain {
        exists(skeleton, joint)?;
    }
    fits(skeleton, limits, pose)?;
    for pair in chain.windows(2) {
        below(skeleton, pair[0], pair[1])?;
    }
    let mut joints = heads(skeleton, pose, chain);
    let lengths: Vec<f64> = joints.windows(2).map(|p| p[0].distance(p[1])).collect();
    if let Some(bone) = lengths.iter().position(|&length| length == 0.0) {
        let joint = skeleton.joints()[chain[bone]].name.clone();
        return Err(KinematicsError::ZeroLengthBone { joint });
    }
    let fabrik = Fabrik::new(lengths)?;
    let Some(limits) = limits else {
        let report = fabrik.solve(&mut joints, target, options)?;
        let start = pose.clone();
        rotate_bones(skeleton, None, pose, &start, chain, &joints);
        return Ok(report);
    };
    fabrik.check(&joints, target)?;
    let mut best: Option<Search> = None;
    for side in 0..4 {
        let mut places = joints.clone();
        let was_on_line = fabrik.leave_line(&mut places, target, side);
        let found = limited(
            &fabrik,
            (skeleton, limits),
            pose,
            chain,
            places,
            target,
            options,
        );
        let distance = found.report.distance;
        if best
            .as_ref()
            .is_none_or(|best| distance < best.report.distance)
        {
            best = Some(found);
        }
        if !was_on_line || distance <= options.tolerance {
            break;
        }
    }
    let distance = joints[chain.len() - 1].distance(target);
    Ok(best.map_or(
        FabrikReport {
            iterations: 0,
            distance,
        },
        |best| {
            *pose = best.pose;
            best.report
        },
    ))
}

/// A pose with how near its chain is.
struct Search {
    pose: Pose,
    report: FabrikReport,
}

/// Iterations within the limits, from these places of the joints: the nearest pose on the way.
fn limited(
    fabrik: &Fabrik,
    (skeleton, limits): (&Skeleton, &JointLimits),
    start: &Pose,
    chain: &[usize],
    mut joints: Vec<Point<f64>>,
    target: Point<f64>,
    options: &FabrikOptions,
) -> Search {
    let last = chain.len() - 1;
    let mut trial = start.clone();
    let reach = |joints: &mut Vec<Point<f64>>, trial: &mut Pose| {
        rotate_bones(skeleton, Some(limits), trial, start, chain, joints);
        *joints = heads(skeleton, trial, chain);
        joints[last].distance(target)
    };
    let mut distance = reach(&mut joints, &mut trial);
    let mut best = trial.clone();
    let mut iterations = 0;
    while distance > options.tolerance && iterations < options.iterations {
        fabrik.reach_backward(&mut joints, target);
        let mut found = reach(&mut joints, &mut trial);
        iterations += 1;
        if found > STALLED * distance {
            trial.joints.clone_from(&best.joints);
            found = sweep(skeleton, limits, &mut trial, chain, target);
            joints = heads(skeleton, &trial, chain);
        }
        if found >= distance {
            break;
        }
        distance = found;
        best.joints.clone_from(&trial.joints);
    }
    let report = FabrikReport {
        iterations,
        distance,
    };
    Search { pose: best, report }
}

/// An iteration that leaves more than this part of the distance is followed by a sweep.
const STALLED: f64 = 0.9;

/// Each joint in turn, from the end to the root, rotates the end of the chain towards the target as
/// far as its limits admit, if that brings it nearer (cyclic coordinate descent). The distance that
/// remains.
fn sweep(
    skeleton: &Skeleton,
    limits: &JointLimits,
    pose: &mut Pose,
    chain: &[usize],
    target: Point<f64>,
) -> f64 {
    let last = chain[chain.len() - 1];
    let end = |pose: &Pose| heads(skeleton, pose, &[last])[0];
    let mut distance = end(pose).distance(target);
    for &joint in chain[..chain.len() - 1].iter().rev() {
        let rest = skeleton.joints()[joint].head;
        let total = total_motion(skeleton, pose, joint);
        let head = Point::from(moved(total, rest));
        let [now, goal] = [end(pose), target].map(|place| head.vector_to(place).into());
        let Some(rotation) = Rotor::between(now, goal) else {
            continue;
        };
        let before = pose.joints[joint];
        let above = before.rotor() * total.rotor().reverse();
        let local = above * rotation * above.reverse();
        pose.joints[joint] = with_rotation(Some(limits), joint, rest, before, local);
        let found = end(pose).distance(target);
        if found < distance {
            distance = found;
        } else {
            pose.joints[joint] = before;
        }
    }
    distance
}

/// Where the heads of joints are in a pose.
fn heads(skeleton: &Skeleton, pose: &Pose, chain: &[usize]) -> Vec<Point<f64>> {
    let head = |&joint: &usize| {
        let motion = total_motion(skeleton, pose, joint);
        Point::from(moved(motion, skeleton.joints()[joint].head))
    };
    chain.iter().map(head).collect()
}

/// Rotates each joint of a chain but the last, from the root on, so that its bone points to the
/// place of the next joint, as far as the limits admit. Where a joint displaces its head, it does
/// so as in the start.
fn rotate_bones(
    skeleton: &Skeleton,
    limits: Option<&JointLimits>,
    pose: &mut Pose,
    start: &Pose,
    chain: &[usize],
    places: &[Point<f64>],
) {
    for (pair, &place) in chain.windows(2).zip(&places[1..]) {
        let [joint, next] = [pair[0], pair[1]];
        let rest = &skeleton.joints()[joint];
        let above = rest
            .parent
            .map_or(pose.root, |parent| total_motion(skeleton, pose, parent));
        let total = above * pose.joints[joint];
        let head = Point::from(moved(total, rest.head));
        let tail =
            total_motion(skeleton, pose, next).transform(Point::from(skeleton.joints()[next].head));
        let [now, goal] = [head.vector_to(tail), head.vector_to(place)];
        let Some(rotation) = Rotor::between(now.into(), goal.into()) else {
            continue;
        };
        let own = above.rotor().reverse() * rotation * total.rotor();
        let own = limits.map_or(own, |limits| limits.clamp(joint, own));
        let place = moved(start.joints[joint], rest.head);
        pose.joints[joint] = own_motion(rest.head, own, place);
    }
}
