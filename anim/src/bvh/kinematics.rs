use ga_runtime::cga3::{Motor, Point, Rotor, Translator};

use super::{Bvh, BvhJoint, Channel, PositionChannels};
use crate::pose::moved;

impl BvhJoint {
    /// The motion of the joint's frame relative to its parent's at rest, when all channels are 0.
    pub(crate) fn rest(&self) -> Motor<f64> {
        Translator::from_displacement(self.offset).into()
    }
}

impl Bvh {
    /// The motion of each joint's frame in one frame of time: it takes a place given relative to
    /// the joint, in axes that are the file's at rest, to the file's coordinates. `None` when there
    /// is no such frame.
    ///
    /// ```text
    /// F = F_parent T(offset + position) R₁ R₂ R₃
    /// ```
    ///
    /// Where the position channels [take the place](super::PositionChannels::InPlace) of the
    /// offset, it is T(position).
    #[must_use]
    pub fn frames_of_joints(&self, frame: usize) -> Option<Vec<Motor<f64>>> {
        let mut frames: Vec<Motor<f64>> = Vec::with_capacity(self.joints().len());
        for (joint, own) in self.joints().iter().zip(self.own_motions(frame)?) {
            frames.push(joint.parent.map_or(own, |parent| frames[parent] * own));
        }
        Some(frames)
    }

    /// The motion of each joint's frame relative to its parent's in one frame of time, T(offset +
    /// position) R₁ R₂ R₃. `None` when there is no such frame.
    pub(crate) fn own_motions(&self, frame: usize) -> Option<impl Iterator<Item = Motor<f64>>> {
        let values = self.frame(frame)?;
        Some(self.joints().iter().map(move |joint| {
            let mut displacement = joint.offset;
            let mut rotor = Rotor::default();
            let positions = match joint.parent {
                None => self.root_position_channels(),
                Some(_) => self.position_channels(),
            };
            for (channel, &value) in joint.channels.iter().zip(&values[joint.first_channel..]) {
                match *channel {
                    Channel::Position(axis) => match positions {
                        PositionChannels::Added => displacement[axis] += value,
                        PositionChannels::InPlace => displacement[axis] = value,
                    },
                    Channel::Rotation(axis) => rotor *= about_axis(axis, value.to_radians()),
                }
            }
            Translator::from_displacement(displacement) * rotor
        }))
    }

    /// Where each joint is in a frame, or `None` when there is no such frame.
    #[must_use]
    pub fn joint_positions(&self, frame: usize) -> Option<Vec<[f64; 3]>> {
        let origin = Point::new(0.0, 0.0, 0.0);
        let frames = self.frames_of_joints(frame)?;
        Some(
            frames
                .into_iter()
                .map(|motor| motor.transform(origin).coordinates())
                .collect(),
        )
    }

    /// Where the End Site of each joint is in a frame, for those that have one, or `None` when
    /// there is no such frame.
    #[must_use]
    pub fn end_site_positions(&self, frame: usize) -> Option<Vec<Option<[f64; 3]>>> {
        let frames = self.frames_of_joints(frame)?;
        let ends = self.joints().iter().zip(frames);
        Some(
            ends.map(|(joint, motor)| Some(moved(motor, joint.end_site?)))
                .collect(),
        )
    }

    /// Where each joint is at rest, when all channels are 0.
    #[must_use]
    pub fn rest_positions(&self) -> Vec<[f64; 3]> {
        let mut positions: Vec<[f64; 3]> = Vec::with_capacity(self.joints().len());
        for joint in self.joints() {
            let above = joint.parent.map_or([0.0; 3], |parent| positions[parent]);
            positions.push(std::array::from_fn(|axis| above[axis] + joint.offset[axis]));
        }
        positions
    }
}

fn about_axis(axis: usize, angle: f64) -> Rotor<f64> {
    let mut direction = [0.0; 3];
    direction[axis] = 1.0;
    // An axis of length 1 and a finite angle always give a rotor.
    Rotor::from_axis_angle(direction, angle).unwrap_or_default()
}
