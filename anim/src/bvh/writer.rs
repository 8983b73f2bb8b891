//! Recordings as BVH files.

use std::fmt::Write as _;

use ga_runtime::cga3::{Motor, Translator};
use ga_runtime::geometry::EulerOrder;

use super::channels::{ORDER, order_of};
use super::{Bvh, BvhJoint, Channel};
use crate::clip::Clip;
use crate::file_error::MotionFileError;
use crate::pose::Pose;
use crate::skeleton::{Skeleton, SkeletonError};

impl Bvh {
    /// A clip as a recording: roots have positions and angles, and so have joints that do not stay
    /// in their places; all others have angles. Joints without others below have an End Site at
    /// their tail. A line break or a brace in a name becomes `_`.
    ///
    /// # Errors
    ///
    /// [`MotionFileError::Skeleton`] and [`MotionFileError::DuplicateName`].
    ///
    /// ```
    /// use ga_anim::bvh::{self, Bvh};
    /// use ga_anim::{clip::Clip, pose::Pose, skeleton::{Joint, Skeleton}};
    /// use ga_runtime::cga3::{Motor, Rotor};
    ///
    /// let hip = Joint { name: "hip".into(), parent: None, head: [0.0, 1.0, 0.0], tail: [0.0; 3] };
    /// let leg = Skeleton::new(vec![hip])?;
    /// let quarter = Rotor::from_axis_angle([0.0, 0.0, 1.0], 1.5).ok_or("no axis")?;
    /// let pose = Pose::from_rotors(&leg, Motor::default(), &[quarter])?;
    /// let motion = Bvh::from_clip(&leg, &Clip::new(0.01, vec![pose])?)?;
    /// let again = bvh::decode(motion.encode().as_bytes())?;
    /// assert_eq!(again, motion);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_clip(skeleton: &Skeleton, clip: &Clip) -> Result<Self, MotionFileError> {
        let joints = skeleton.joints();
        let parents: Vec<Option<usize>> = joints.iter().map(|joint| joint.parent).collect();
        let order = depth_first(&parents);
        let mut place = vec![0; joints.len()];
        for (new, &old) in order.iter().enumerate() {
            place[old] = new;
        }
        let mut written: Vec<BvhJoint> = Vec::with_capacity(joints.len());
        let mut names = std::collections::HashSet::new();
        let mut first_channel = 0;
        for &old in &order {
            let joint = &joints[old];
            let is_leaf = skeleton.children(old).next().is_none();
            let above = joint.parent.map_or([0.0; 3], |parent| joints[parent].head);
            let between = |from: [f64; 3], to: [f64; 3]| [0, 1, 2].map(|k| to[k] - from[k]);
            let positions = (0..3).map(Channel::Position);
            let positions = positions.take(if joint.parent.is_none() { 3 } else { 0 });
            let channels: Vec<Channel> = positions.chain(ORDER.map(Channel::Rotation)).collect();
            let count = channels.len();
            let name = plain(&joint.name);
            if !names.insert(name.clone()) {
                return Err(MotionFileError::DuplicateName { name });
            }
            written.push(BvhJoint {
                name,
                parent: joint.parent.map(|parent| place[parent]),
                offset: between(above, joint.head),
                channels,
                first_channel,
                end_site: is_leaf.then(|| between(joint.head, joint.tail)),
            });
            first_channel += count;
        }
        let frames = motions(skeleton, &order, clip)?;
        Ok(Self::of_motions(written, clip.frame_time(), &frames))
    }

    /// The joints of this recording with the motion of a clip of [`Bvh::skeleton`]. Angles keep
    /// their order where a joint has all three; joints below the root have angles only, unless they
    /// do not stay in their places.
    ///
    /// # Errors
    ///
    /// [`MotionFileError::Skeleton`].
    pub fn with_clip(&self, skeleton: &Skeleton, clip: &Clip) -> Result<Self, MotionFileError> {
        let mut joints = self.joints.clone();
        for joint in &mut joints {
            let positions = (0..3).map(Channel::Position);
            let positions = positions.take(if joint.parent.is_none() { 3 } else { 0 });
            let angles = order_of(joint).map_or(ORDER, EulerOrder::axes);
            joint.channels = positions.chain(angles.map(Channel::Rotation)).collect();
        }
        let order: Vec<usize> = (0..joints.len()).collect();
        let frames = motions(skeleton, &order, clip)?;
        Ok(Self::of_motions(joints, clip.frame_time(), &frames))
    }

    /// The text of the file. Numbers are written so that they read back exactly.
    #[must_use]
    pub fn encode(&self) -> String {
        let mut text = "HIERARCHY\n".to_owned();
        let mut open: Vec<usize> = Vec::new();
        let close = |text: &mut String, open: &mut Vec<usize>| {
            open.pop();
            *text += &format!("{}}}\n", "\t".repeat(open.len()));
        };
        for (index, joint) in self.joints.iter().enumerate() {
            while open.last().copied() != joint.parent && !open.is_empty() {
                close(&mut text, &mut open);
            }
            let indent = "\t".repeat(open.len());
            let keyword = if joint.parent.is_none() {
                "ROOT"
            } else {
                "JOINT"
            };
            let [x, y, z] = joint.offset;
            let channels: Vec<&str> = joint.channels.iter().map(word).collect();
            // Writing to a String cannot fail.
            let _ = writeln!(
                text,
                "{indent}{keyword} {}\n{indent}{{\n{indent}\tOFFSET {x} {y} {z}\n\
                 {indent}\tCHANNELS {} {}",
                joint.name,
                channels.len(),
                channels.join(" ")
            );
            if let Some([x, y, z]) = joint.end_site {
                let _ = writeln!(
                    text,
                    "{indent}\tEnd Site\n{indent}\t{{\n{indent}\t\tOFFSET {x} {y} {z}\n\
                     {indent}\t}}"
                );
            }
            open.push(index);
        }
        while !open.is_empty() {
            close(&mut text, &mut open);
        }
        let _ = writeln!(
            text,
            "MOTION\nFrames: {}\nFrame Time: {}",
            self.frame_count, self.frame_time
        );
        for frame in 0..self.frame_count {
            let values = self.frame(frame).unwrap_or_default().iter();
            let words: Vec<String> = values.map(f64::to_string).collect();
            text += &words.join(" ");
            text.push('\n');
        }
        text
    }
}

/// The motion of a joint's frame relative to its parent's: T(−p) L T(h).
fn local(skeleton: &Skeleton, pose: &Pose, joint: usize) -> Motor<f64> {
    let described = &skeleton.joints()[joint];
    let to_parent = |parent: usize| {
        let back = skeleton.joints()[parent].head.map(|x| -x);
        Motor::from(Translator::from_displacement(back))
    };
    let above = described.parent.map_or(pose.root, to_parent);
    above * pose.joints[joint] * Translator::from_displacement(described.head)
}

/// The motions of the joints relative to their parents in every frame of a clip; `order` has the
/// joint of the skeleton for each.
fn motions(
    skeleton: &Skeleton,
    order: &[usize],
    clip: &Clip,
) -> Result<Vec<Vec<Motor<f64>>>, MotionFileError> {
    let (expected, found) = (skeleton.len(), clip.joint_count());
    if expected != found || order.len() != expected {
        return Err(SkeletonError::PoseLength { expected, found }.into());
    }
    let of_pose = |pose: &Pose| {
        let joints = order.iter().map(|&joint| local(skeleton, pose, joint));
        joints.collect()
    };
    Ok(clip.frames().iter().map(of_pose).collect())
}

/// The joints in an order in which what is below a joint follows it.
pub(super) fn depth_first(parents: &[Option<usize>]) -> Vec<usize> {
    let mut children: Vec<Vec<usize>> = vec![Vec::new(); parents.len()];
    let mut to_visit = Vec::new();
    for (joint, parent) in parents.iter().enumerate().rev() {
        match *parent {
            Some(parent) => children[parent].push(joint),
            None => to_visit.push(joint),
        }
    }
    let mut order = Vec::with_capacity(parents.len());
    while let Some(joint) = to_visit.pop() {
        order.push(joint);
        to_visit.append(&mut children[joint]);
    }
    order
}

fn word(channel: &Channel) -> &'static str {
    match *channel {
        Channel::Position(0) => "Xposition",
        Channel::Position(1) => "Yposition",
        Channel::Position(_) => "Zposition",
        Channel::Rotation(0) => "Xrotation",
        Channel::Rotation(1) => "Yrotation",
        Channel::Rotation(_) => "Zrotation",
    }
}

/// A name that stands on one line, up to a brace.
pub(super) fn plain(name: &str) -> String {
    let is_strange = |c: char| c.is_control() || matches!(c, '{' | '}');
    let words = name.split_whitespace();
    let name = words.collect::<Vec<_>>().join(" ").replace(is_strange, "_");
    if name.is_empty() {
        "_".to_owned()
    } else {
        name
    }
}
