//! What a person does not do.

use serde::Serialize;

/// Where something is largest.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Place {
    /// The frame of the recording.
    pub frame: usize,
    /// The joint of the target.
    pub joint: String,
}

/// Something that a person does not do and a body does not allow.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Fault {
    /// The head is tilted too far against the trunk.
    #[error("the head is {degrees:.0}° from the direction of the trunk in frame {}", .place.frame)]
    Head {
        /// By how much.
        degrees: f64,
        /// Where.
        place: Place,
    },
    /// A bone is longer or shorter than at rest.
    #[error(
        "{} is {part:.1e} of its distance at rest nearer to or farther from the joint above in \
         frame {}",
        .place.joint,
        .place.frame
    )]
    Stretch {
        /// By which part of its length.
        part: f64,
        /// Where.
        place: Place,
    },
    /// The feet are far above the ground or below it in the quarter of the frames in which they are
    /// lowest.
    #[error(
        "the feet are {:.3} m or more {} the ground in {} of the frames, and lowest in frame {}",
        metres.abs(),
        if *metres > 0.0 { "above" } else { "below" },
        if *metres > 0.0 { "three quarters" } else { "a quarter" },
        .place.frame
    )]
    Height {
        /// How far above, negative below.
        metres: f64,
        /// Where they are lowest.
        place: Place,
    },
    /// A knee bends backwards.
    #[error(
        "the knee {} bends backwards in {percent:.0} % of the frames, most in frame {}",
        .place.joint,
        .place.frame
    )]
    Knee {
        /// In how many.
        percent: f64,
        /// Where it does most.
        place: Place,
    },
    /// A foot that stands is not flat on the ground.
    #[error(
        "the sole of {} is {degrees:.0}° from flat in half of the frames in which it stands, and \
         farthest in frame {}",
        .place.joint,
        .place.frame
    )]
    Sole {
        /// By how much.
        degrees: f64,
        /// Where it is farthest.
        place: Place,
    },
    /// A foot that stands points elsewhere than the body.
    #[error(
        "{} points {degrees:.0}° away from where the pelvis looks in half of the frames in which it \
         stands, and farthest in frame {}",
        .place.joint,
        .place.frame
    )]
    Heading {
        /// By how much.
        degrees: f64,
        /// Where it is farthest.
        place: Place,
    },
    /// A joint rotates much faster than the one that moves it.
    #[error(
        "{} rotates by {degrees:.0}° more than the joint that moves it from frame {} to the next",
        .place.joint,
        .place.frame
    )]
    Rotation {
        /// By how much more.
        degrees: f64,
        /// Where.
        place: Place,
    },
}

impl Fault {
    /// What it is, as words for programs.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Head { .. } => "head_off_trunk",
            Self::Stretch { .. } => "bone_stretched",
            Self::Height { .. } => "feet_off_ground",
            Self::Knee { .. } => "knee_backwards",
            Self::Sole { .. } => "sole_not_flat",
            Self::Heading { .. } => "foot_turned_away",
            Self::Rotation { .. } => "rotation_too_fast",
        }
    }

    /// Where it is worst.
    #[must_use]
    pub fn place(&self) -> &Place {
        match self {
            Self::Head { place, .. }
            | Self::Stretch { place, .. }
            | Self::Height { place, .. }
            | Self::Knee { place, .. }
            | Self::Sole { place, .. }
            | Self::Heading { place, .. }
            | Self::Rotation { place, .. } => place,
        }
    }
}
