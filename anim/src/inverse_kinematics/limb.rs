//! Two bones of a skeleton.

use super::check::{below, exists, finite, fits};
use super::motion::total_motion;
use ga_runtime::cga3::{Motor, Point, Rotor, Translator};

use super::two_bone::{Bent, Reach, TwoBone};
use crate::kinematics::KinematicsError;
use crate::pose::{Pose, moved};
use crate::skeleton::Skeleton;

/// Bends a limb of a pose so that its end is at a target: `[thigh, shin, foot]`, for instance, by
/// their joints. Only the own motions of these three change. The limb stays in its plane or, with
/// a pole, bends to that side; the end keeps its rotation in the model, so that a foot stays flat.
/// Joints in between, such as those that spread a twist, move with the bone above them.
///
/// # Errors
///
/// [`KinematicsError::NoJoint`], [`KinematicsError::NotBelow`], [`KinematicsError::Skeleton`],
/// [`KinematicsError::NotFinite`], [`KinematicsError::ZeroLengthBone`] with the joint's name, and
/// those of [`TwoBone::solve`]; without a pole, a straight limb whose target is on its line gives
/// [`KinematicsError::Pole`].
///
/// ```
/// use ga_anim::inverse_kinematics::bend_limb;
/// use ga_anim::pose::Pose;
/// use ga_anim::skeleton::{Joint, Skeleton};
/// use ga_runtime::cga3::Point;
///
/// let joint = |name: &str, parent, y: f64, below: f64| Joint {
///     name: name.into(),
///     parent,
///     head: [0.0, y, 0.0],
///     tail: [0.0, below, 0.0],
/// };
/// let leg = Skeleton::new(vec![
///     joint("thigh", None, 0.9, 0.5),
///     joint("shin", Some(0), 0.5, 0.1),
///     joint("foot", Some(1), 0.1, 0.0),
/// ])?;
/// let mut pose = Pose::rest(3);
/// let target = Point::new(0.0, 0.3, 0.2);
/// bend_limb(&leg, &mut pose, [0, 1, 2], target, Some(Point::new(0.0, 0.5, 9.0)))?;
/// let [ankle, sole] = pose.bones(&leg)?[2];
/// assert!(target.distance(ankle.into()) < 1e-15 && (ankle[1] - sole[1] - 0.1).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn bend_limb(
    skeleton: &Skeleton,
    pose: &mut Pose,
    limb: [usize; 3],
    target: Point<f64>,
    pole: Option<Point<f64>>,
) -> Result<Reach, KinematicsError> {
    let [upper, lower, end] = limb;
    for joint in limb {
        exists(skeleton, joint)?;
    }
    fits(skeleton, None, pose)?;
    finite("the target", target)?;
    below(skeleton, upper, lower)?;
    below(skeleton, lower, end)?;

    let before = limb.map(|joint| total_motion(skeleton, pose, joint));
    let head = |k: usize| Point::from(moved(before[k], skeleton.joints()[limb[k]].head));
    let places = [head(0), head(1), head(2)];
    let lengths = [0, 1].map(|k| places[k].distance(places[k + 1]));
    if let Some(bone) = lengths.iter().position(|&length| length == 0.0) {
        let joint = skeleton.joints()[limb[bone]].name.clone();
        return Err(KinematicsError::ZeroLengthBone { joint });
    }
    let bones = TwoBone::new(lengths[0], lengths[1])?;
    let bent = bones.solve(places[0], target, pole.unwrap_or(places[1]))?;
    let rotors = bent.rotors_from(places).ok_or(KinematicsError::Folded)?;
    place_limb(skeleton, pose, limb, places, &bent, rotors);
    Ok(bent.reach)
}

/// Moves a limb of a pose from places of root, middle and end to others, with these rotations of
/// its bones in the coordinates of the model. The end keeps its rotation.
pub(crate) fn place_limb(
    skeleton: &Skeleton,
    pose: &mut Pose,
    limb: [usize; 3],
    places: [Point<f64>; 3],
    bent: &Bent,
    [upper, lower]: [Rotor<f64>; 2],
) {
    let before = limb.map(|joint| total_motion(skeleton, pose, joint));
    // Each joint's new total motion, and from it its own.
    let totals = [
        carried(before[0], upper, places[0], bent.root),
        carried(before[1], lower, places[1], bent.middle),
        carried(before[2], Rotor::default(), places[2], bent.end),
    ];
    for (joint, total) in limb.into_iter().zip(totals) {
        let parent = skeleton.joints()[joint].parent;
        let above = parent.map_or(pose.root, |parent| total_motion(skeleton, pose, parent));
        pose.joints[joint] = above.reverse() * total;
    }
}

/// A motion followed by a rotation about a place that it has, and by the translation from there to
/// another place.
fn carried(motion: Motor<f64>, rotor: Rotor<f64>, from: Point<f64>, to: Point<f64>) -> Motor<f64> {
    let away = Translator::from_displacement(to.coordinates());
    let back = Translator::from_displacement(from.coordinates().map(|x| -x));
    away * rotor * (back * motion)
}
