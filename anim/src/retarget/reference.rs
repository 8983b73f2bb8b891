//! Which pose of a motion is like the target's pose at rest.

use ga_runtime::cga3::{Direction, Motor, Rotor, Translator};
use ga_runtime::vga3::Vector;
use serde::Serialize;

use super::Source;
use super::calibration::{Calibration, Moment};
use super::human::{Human, Role};
use super::standing_pose::standing_orientation;
use super::up_axis::{self, FoundUpAxis, UpAxis};
use crate::recording::RecordingError;

/// Which pose of a recording corresponds to the target at rest.
#[derive(Clone, Copy, Debug, Default)]
pub enum Reference<'a> {
    /// It is found: the pose in which all rotations are zero, where that is a person who stands,
    /// and otherwise what the joints do during the motion.
    #[default]
    Found,
    /// The pose in a frame of the recording.
    Frame(usize),
    /// The pose in the first frame of another recording of the same joints, or in one without
    /// frames that at rest.
    Pose(&'a dyn Source),
}

/// What the rotations of the target were found from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum FoundReference {
    /// A pose that was given.
    Given,
    /// The pose in which all rotations are zero.
    Rest,
    /// What the joints do during the motion.
    Motion,
}

/// Frames that are looked at, evenly over a recording.
const MOMENTS: usize = 2000;

/// The moments of a recording, with its vertical along y.
pub(super) struct Motion {
    pub(super) moments: Vec<Moment>,
    pub(super) up: Option<FoundUpAxis>,
    /// The rotation that makes the vertical y.
    pub(super) upright: Rotor<f64>,
}

impl Motion {
    /// Reads a recording whose human joints are these, with the vertical that is given or found.
    pub(super) fn new(source: &dyn Source, human: Option<&Human>, given: Option<UpAxis>) -> Self {
        let count = source.frame_count();
        let step = count.div_ceil(MOMENTS).max(1);
        let motors = (0..count).step_by(step).filter_map(|frame| {
            let now = Moment::new(source.frames_of_joints(frame)?);
            let later = (frame + 1).min(count - 1).max(1);
            let pair = [later.checked_sub(1)?, later];
            let [before, after] = pair.map(|frame| source.frames_of_joints(frame));
            Some((now, before.zip(after)))
        });
        let mut moments = Vec::new();
        for (mut moment, pair) in motors {
            if let (Some(human), Some((before, after))) = (human, pair) {
                let [before, after] = [Moment::new(before), Moment::new(after)];
                moment.velocities = human.legs.map(|[_, _, ankle]| {
                    (after.places[ankle] - before.places[ankle]) / source.frame_time()
                });
            }
            moments.push(moment);
        }
        let places = moments.iter().map(|moment| moment.places.as_slice());
        let up = human.and_then(|human| up_axis::find(human, places));
        let axis = given.or(up.map(|up| up.axis)).unwrap_or_default();
        let upright = axis.to_y();
        if axis != UpAxis::Y {
            for moment in &mut moments {
                let motors = moment.motors.iter().map(|&motor| upright * motor).collect();
                let rotated = |v| upright.transform(Direction::from(v)).into();
                let velocities = moment.velocities.map(rotated);
                *moment = Moment {
                    velocities,
                    ..Moment::new(motors)
                };
            }
        }
        Self {
            moments,
            up,
            upright,
        }
    }
}

/// The moment of a body at rest, rotated as a whole.
pub(super) fn at_rest(places: &[Vector<f64>], rotor: Rotor<f64>) -> Moment {
    let motors = places.iter().map(|&place| {
        let place: Vector<f64> = rotor.transform(Direction::from(place)).into();
        Motor::from(Translator::from_displacement(place.coordinates())) * rotor
    });
    Moment::new(motors.collect())
}

/// The pose of the source that corresponds to the target at rest; `None` where only the motion says
/// it.
pub(super) fn pose(
    source: &dyn Source,
    human: Option<&Human>,
    motion: &Motion,
    reference: Reference,
) -> Result<Option<Moment>, RecordingError> {
    let upright = |motors: Vec<Motor<f64>>| {
        Moment::new(motors.into_iter().map(|m| motion.upright * m).collect())
    };
    match reference {
        Reference::Frame(frame) => {
            let frames = source.frame_count();
            let motors = source.frames_of_joints(frame);
            let motors = motors.ok_or(RecordingError::ReferenceFrame { frame, frames })?;
            Ok(Some(upright(motors)))
        }
        Reference::Pose(other) => {
            let names = other.names();
            let motors = match other.frames_of_joints(0) {
                Some(motors) => motors,
                None => at_rest(&rest_places(other), Rotor::default()).motors,
            };
            let motors = source.names().into_iter().map(|name| {
                let joint = names.iter().position(|other| *other == name);
                let joint = joint.ok_or_else(|| RecordingError::ReferenceJoint {
                    name: name.to_owned(),
                })?;
                Ok(motors[joint])
            });
            Ok(Some(upright(
                motors.collect::<Result<_, RecordingError>>()?,
            )))
        }
        Reference::Found => {
            let places = rest_places(source);
            let Some(human) = human else {
                return Ok(Some(at_rest(&places, motion.upright)));
            };
            let stands = standing_orientation(human, &places);
            Ok(stands.map(|rotor| at_rest(&places, rotor)))
        }
    }
}

pub(super) fn rest_places(source: &dyn Source) -> Vec<Vector<f64>> {
    source
        .rest_positions()
        .into_iter()
        .map(Vector::from)
        .collect()
}

/// For each joint of the target the rotor that takes left, up and forward to the axes of the joint
/// that `joint_of` gives, in the mean over the motion. A joint of which the places say nothing is,
/// in the mean, not rotated relative to the one above it.
pub(super) fn axes(
    calibration: &Calibration,
    roles: &[Option<Role>],
    joint_of: impl Fn(usize) -> Option<usize>,
    above: &[Option<usize>],
    order: &[usize],
) -> Vec<Rotor<f64>> {
    let mut axes = vec![Rotor::default(); roles.len()];
    for &joint in order {
        let Some(own) = joint_of(joint) else {
            continue;
        };
        let by_role = roles[joint].and_then(|role| calibration.axes_of(own, role));
        let by_parent = || {
            let parent = above[joint]?;
            let other = joint_of(parent)?;
            let axes = axes[parent];
            calibration.relative_to(own, |moment| moment.motors[other].rotor() * axes)
        };
        axes[joint] = by_role.or_else(by_parent).unwrap_or_default();
    }
    axes
}
