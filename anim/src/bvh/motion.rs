//! A skeleton and its motion.

use super::joint::BvhJoint;
use crate::bvh::BvhWarning;
use crate::bvh::PositionChannels;

/// A skeleton and its motion in the form of a BVH file.
#[derive(Clone, Debug, PartialEq)]
pub struct Bvh {
    pub(super) joints: Vec<BvhJoint>,
    pub(super) frame_time: f64,
    pub(super) frame_count: usize,
    /// Frame by frame, within a frame in the order of the joints and their channels.
    pub(super) values: Vec<f64>,
    /// Those of roots, and those of other joints.
    pub(super) root_positions: PositionChannels,
    pub(super) positions: PositionChannels,
    pub(super) warnings: Vec<BvhWarning>,
}

impl Bvh {
    /// The joints, parents before children, in the order of the file.
    #[must_use]
    pub fn joints(&self) -> &[BvhJoint] {
        &self.joints
    }

    /// The index of the joint of this name.
    #[must_use]
    pub fn index(&self, name: &str) -> Option<usize> {
        self.joints.iter().position(|joint| joint.name == name)
    }

    /// The time from one frame to the next, in seconds.
    #[must_use]
    pub fn frame_time(&self) -> f64 {
        self.frame_time
    }

    /// How many frames there are; may be 0.
    #[must_use]
    pub fn frame_count(&self) -> usize {
        self.frame_count
    }

    /// The numbers of a frame, in the order of the joints and their channels.
    #[must_use]
    pub fn frame(&self, frame: usize) -> Option<&[f64]> {
        let channels = self.channel_count();
        (frame < self.frame_count).then(|| &self.values[frame * channels..(frame + 1) * channels])
    }

    /// What in the file deviates from the format and was read nevertheless; each kind once.
    #[must_use]
    pub fn warnings(&self) -> &[BvhWarning] {
        &self.warnings
    }

    /// How the position channels of roots are meant.
    #[must_use]
    pub fn root_position_channels(&self) -> PositionChannels {
        self.root_positions
    }

    /// How the position channels of joints below the roots are meant.
    #[must_use]
    pub fn position_channels(&self) -> PositionChannels {
        self.positions
    }

    /// How many numbers a frame has.
    #[must_use]
    pub fn channel_count(&self) -> usize {
        self.joints.iter().map(|joint| joint.channels.len()).sum()
    }
}
