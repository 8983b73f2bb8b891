//! Which channels the joints of a recording need, and their numbers.

use ga_runtime::cga3::{Motor, Rotor};
use ga_runtime::geometry::EulerOrder;
use ga_runtime::vga3::Vector;

use super::root_offset::root_positions;
use super::warning::position_channels;
use super::{Bvh, BvhJoint, Channel, PositionChannels};

/// The order of the angles where there is no other: the usual one of these files.
pub(super) const ORDER: [usize; 3] = [2, 0, 1];

/// As a part of the body's reach, how far a joint may be from its place without moving: below what
/// single precision says.
const STAYS: f64 = 5e-8;
/// As a part of the body's reach, how far the place in which a joint stays may be from that at rest
/// to take its place.
const SAME_PLACE: f64 = 1e-4;
/// The sine of half the angle below which there is no rotation.
const NO_ROTATION: f64 = 1e-12;

impl Bvh {
    /// The recording of joints, depth first, with the motions of each relative to its parent in
    /// every frame. Joints keep their channels where these can say the motion. Otherwise they get
    /// all three angles, and where they do not stay in one place, all three positions.
    pub(super) fn of_motions(
        mut joints: Vec<BvhJoint>,
        frame_time: f64,
        frames: &[Vec<Motor<f64>>],
    ) -> Self {
        let reach = reach(&joints);
        let mut first_channel = 0;
        for (index, joint) in joints.iter_mut().enumerate() {
            let own = frames.iter().map(|frame| &frame[index]);
            settle(joint, own, reach);
            joint.first_channel = first_channel;
            first_channel += joint.channels.len();
        }
        let mut motion = Self {
            joints,
            frame_time,
            frame_count: frames.len(),
            values: Vec::new(),
            root_positions: PositionChannels::InPlace,
            positions: PositionChannels::InPlace,
            warnings: Vec::new(),
        };
        motion.fill(frames);
        // The numbers must be understood as they are meant: in place of the offsets, or else added
        // to them, or else without offsets.
        if !motion.reads_back() {
            motion.positions = PositionChannels::Added;
            motion.fill(frames);
        }
        if !motion.reads_back() {
            for joint in &mut motion.joints {
                if joint.parent.is_some() && has_positions(joint) {
                    joint.offset = [0.0; 3];
                }
            }
            motion.fill(frames);
            motion.positions = motion.positions_as_read();
        }
        if root_positions(&motion) == PositionChannels::Added {
            let roots = motion.joints.iter_mut();
            let roots = roots.filter(|joint| joint.parent.is_none());
            roots.for_each(|joint| joint.offset = [0.0; 3]);
        }
        motion
    }

    /// Whether the positions of joints below the roots are read as they are meant.
    fn reads_back(&self) -> bool {
        self.positions_as_read() == self.positions
    }

    fn positions_as_read(&self) -> PositionChannels {
        position_channels(&self.joints, &self.values, self.channel_count()).0
    }

    /// The numbers of all frames.
    fn fill(&mut self, frames: &[Vec<Motor<f64>>]) {
        self.values.clear();
        for frame in frames {
            for (joint, own) in self.joints.iter().zip(frame) {
                let place = Vector::from(own.translator().displacement());
                let is_added = joint.parent.is_some() && self.positions == PositionChannels::Added;
                let offset = match is_added {
                    true => joint.offset.into(),
                    false => Vector::default(),
                };
                let positions = (place - offset).coordinates();
                let order = order_of(joint).unwrap_or(EulerOrder::Zxy);
                let mut angles = own.rotor().to_euler(order).into_iter();
                self.values.extend(joint.channels.iter().map(|channel| {
                    match *channel {
                        Channel::Position(axis) => positions[axis],
                        // Angles come in the order of their channels.
                        Channel::Rotation(_) => angles.next().unwrap_or(0.0).to_degrees(),
                    }
                }));
            }
        }
    }
}

/// Gives a joint the channels that it needs for its motions.
fn settle<'a>(
    joint: &mut BvhJoint,
    motions: impl Iterator<Item = &'a Motor<f64>> + Clone,
    reach: f64,
) {
    let places = || {
        let motions = motions.clone();
        motions.map(|motion| Vector::from(motion.translator().displacement()))
    };
    let offset = Vector::from(joint.offset);
    let is_near = |to: Vector<f64>, part: f64| {
        let near = move |place: Vector<f64>| place.distance(to) <= part * reach;
        places().all(near)
    };
    let stays_elsewhere = places()
        .next()
        .filter(|&place| !is_near(offset, STAYS) && is_near(place, STAYS));
    if let Some(place) =
        stays_elsewhere.filter(|place| place.distance(offset) <= SAME_PLACE * reach)
    {
        joint.offset = place.coordinates();
    }
    let stays = is_near(joint.offset.into(), STAYS);
    let rotates = |rotor: Rotor<f64>| {
        let part = [rotor.e12(), rotor.e13(), rotor.e23()];
        part.iter().any(|x| x.abs() > NO_ROTATION)
    };
    let rotates = motions.clone().any(|motion| rotates(motion.rotor()));

    let has = |is_position: bool| {
        let channels = joint.channels.iter();
        channels
            .filter(|channel| matches!(channel, Channel::Position(_)) == is_position)
            .count()
    };
    let positions_fit = has(true) == 3 || (has(true) == 0 && stays);
    let angles_fit = order_of(joint).is_some() || (has(false) == 0 && !rotates);
    if positions_fit && angles_fit {
        return;
    }
    let is_root = joint.parent.is_none();
    let count = if has(true) > 0 || is_root || !stays {
        3
    } else {
        0
    };
    let angles = order_of(joint).map_or(ORDER, EulerOrder::axes);
    let positions = (0..count).map(Channel::Position);
    joint.channels = positions.chain(angles.map(Channel::Rotation)).collect();
}

/// The channels of a joint in a file that is made anew.
pub(super) fn usual(is_root: bool) -> Vec<Channel> {
    let positions = (0..3).map(Channel::Position);
    let positions = positions.take(if is_root { 3 } else { 0 });
    positions.chain(ORDER.map(Channel::Rotation)).collect()
}

/// The greatest distance of a joint from the root along its bones at rest.
fn reach(joints: &[BvhJoint]) -> f64 {
    let mut ways: Vec<f64> = Vec::with_capacity(joints.len());
    for joint in joints {
        let own = Vector::from(joint.offset).length();
        ways.push(joint.parent.map_or(0.0, |parent| ways[parent] + own));
    }
    ways.into_iter().fold(0.0, f64::max)
}

fn has_positions(joint: &BvhJoint) -> bool {
    let mut channels = joint.channels.iter();
    channels.any(|channel| matches!(channel, Channel::Position(_)))
}

/// The order of a joint's angles, where it has all three.
pub(super) fn order_of(joint: &BvhJoint) -> Option<EulerOrder> {
    let axes: Vec<usize> = joint
        .channels
        .iter()
        .filter_map(|channel| match *channel {
            Channel::Rotation(axis) => Some(axis),
            Channel::Position(_) => None,
        })
        .collect();
    let is_it = |order: &&EulerOrder| order.axes().as_slice() == axes;
    EulerOrder::ALL.iter().find(is_it).copied()
}
