//! Motions on other skeletons: the arguments that say how, and warnings of what is doubtful.

use std::path::{Path, PathBuf};

use anyhow::{Error, Result};
use clap::ValueEnum;
use ga_anim::recording::RecordingError;
use ga_anim::retarget::{
    Alignment, FoundReference, JointMap, MapOrigin, Options, Reference, Soles, Source,
    StandingFoot, Transfer, TransferOptions, UpAxis,
};
use ga_anim::skeleton::Skeleton;

use crate::frame::Warning;
use crate::motion_file;

/// How a motion is transferred to a skeleton.
#[derive(Clone, Debug, clap::Args)]
#[group(requires = "motion")]
pub(crate) struct TransferArguments {
    /// Which joints belong together: JSON, as in {"LeftUpLeg": "thigh_l", "Spine": ["spine_01",
    /// "spine_02"]}, the joint of the motion first.
    #[arg(long, value_name = "FILE.json")]
    pub(crate) map: Option<PathBuf>,
    /// Keep standing feet in their places.
    #[arg(long)]
    pub(crate) foot_locking: bool,
    /// Keep the height of the motion above y = 0, in proportion, in place of putting the feet on
    /// the ground.
    #[arg(long)]
    keep_height: bool,
    /// The frame of the motion, from 0, in which it stands as the target does at rest.
    #[arg(long, value_name = "F", conflicts_with = "reference_pose")]
    reference_frame: Option<usize>,
    /// A motion of the same joints whose first frame stands as the target does at rest.
    #[arg(long, value_name = "FILE.bvh")]
    reference_pose: Option<PathBuf>,
    /// The axis of the motion that points up [default: found from the motion].
    #[arg(long, value_enum, allow_hyphen_values = true)]
    up: Option<Up>,
    /// Which bones become parallel to those of the motion.
    #[arg(long, value_enum, default_value_t = Bones::Limbs)]
    align: Bones,
}

/// A motion that is transferred.
pub(crate) struct Motion<'a> {
    pub(crate) file: &'a Path,
    pub(crate) source: &'a dyn Source,
    pub(crate) metres_per_unit: f64,
    /// The first and the last frame; `None` for all.
    pub(crate) frames: Option<[usize; 2]>,
}

/// What it is transferred to.
pub(crate) struct Body<'a> {
    pub(crate) skeleton: &'a Skeleton,
    pub(crate) soles: Option<&'a Soles>,
    pub(crate) motion: Option<&'a dyn Source>,
    pub(crate) metres_per_unit: f64,
}

/// Which bones become parallel.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Bones {
    /// One bone of every matched joint, feet included.
    All,
    /// Those of arms and legs, and the trunk as a whole, which keeps its form; soles lie on the
    /// ground.
    Limbs,
}

/// An axis.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Up {
    X,
    Y,
    Z,
    #[value(name = "-x")]
    NegativeX,
    #[value(name = "-y")]
    NegativeY,
    #[value(name = "-z")]
    NegativeZ,
}

impl From<Up> for UpAxis {
    fn from(axis: Up) -> Self {
        match axis {
            Up::X => Self::X,
            Up::Y => Self::Y,
            Up::Z => Self::Z,
            Up::NegativeX => Self::NegativeX,
            Up::NegativeY => Self::NegativeY,
            Up::NegativeZ => Self::NegativeZ,
        }
    }
}

impl TransferArguments {
    /// The files that are read.
    pub(crate) fn inputs(&self) -> impl Iterator<Item = &PathBuf> {
        self.map.iter().chain(&self.reference_pose)
    }

    /// Transfers a motion, and adds what is doubtful to the warnings.
    pub(crate) fn transfer(
        &self,
        motion: &Motion,
        body: &Body,
        warnings: &mut Vec<Warning>,
    ) -> Result<Transfer> {
        let (source, skeleton) = (motion.source, body.skeleton);
        let (map, map_by) = match &self.map {
            Some(path) => {
                let map = ga_files::read(path, |bytes| JointMap::decode(bytes, source, skeleton))?;
                (map, MapOrigin::File)
            }
            None => JointMap::found(source, skeleton)?,
        };
        let pose = match &self.reference_pose {
            Some(path) => Some(motion_file::read(path, warnings)?),
            None => None,
        };
        let retarget = Options {
            alignment: match self.align {
                Bones::All => Alignment::EveryBone,
                Bones::Limbs => Alignment::Limbs,
            },
            reference: match (&pose, self.reference_frame) {
                (Some(pose), _) => Reference::Pose(pose),
                (_, Some(frame)) => Reference::Frame(frame),
                _ => Reference::Found,
            },
            up: self.up.map(Into::into),
            keeps_height: self.keep_height,
            soles: body.soles,
            target_motion: body.motion,
            ..Options::default()
        };
        let options = TransferOptions {
            retarget,
            foot_locking: self.foot_locking,
            motion_metres_per_unit: motion.metres_per_unit,
            target_metres_per_unit: body.metres_per_unit,
            frames: motion.frames,
        };
        let transfer = Transfer::new(source, skeleton, (&map, map_by), &options);
        let transfer = transfer.map_err(|error| match (&error, &self.reference_pose) {
            (RecordingError::ReferenceJoint { .. }, Some(path)) => {
                Error::new(error).context(format!("--reference-pose {}", path.display()))
            }
            _ => error.into(),
        })?;
        warnings.extend(transfer.feet.iter().filter_map(too_short));
        warnings.extend(self.doubts(motion.file, &transfer));
        Ok(transfer)
    }
}

impl TransferArguments {
    /// Warnings of what is not clear, and of what a person does not do.
    fn doubts(&self, file: &Path, transfer: &Transfer) -> Vec<Warning> {
        /// The least confidence in a map of joints, and the greatest cost of standing.
        const SURE: f64 = 0.7;
        const STANDS: f64 = 5.0;
        let mut warnings = Vec::new();
        if let Some(up) = transfer.up.filter(|up| self.up.is_none() && !up.is_clear()) {
            let message = format!(
                "the vertical of the motion is not clear: {} is taken; --up gives it",
                up.axis
            );
            warnings.push(Warning::new("unclear_up", message).in_file(file));
        }
        let mapping = &transfer.mapping;
        if mapping.confidence < SURE {
            let missing = match mapping.parts_missing.as_slice() {
                [] => String::new(),
                parts => format!("; nothing moves {}", parts.join(", ")),
            };
            let message = format!(
                "it is not clear which joints belong together, with a confidence of {:.2}{missing}; \
                 --map gives them",
                mapping.confidence
            );
            warnings.push(Warning::new("unclear_mapping", message).in_file(file));
        }
        let cost = transfer.least_cost_of_standing.unwrap_or(0.0);
        if transfer.reference == FoundReference::Motion && cost > STANDS {
            let message = "the body stands upright in no frame, so that the rotations of trunk and \
                           head are not clear; --reference-pose gives them";
            warnings.push(Warning::new("never_upright", message).in_file(file));
        }
        warnings.extend(transfer.checks.faults.iter().map(|fault| Warning {
            joint: Some(fault.place().joint.clone()),
            frame: Some(fault.place().frame),
            ..Warning::new(fault.kind(), fault)
        }));
        warnings
    }
}

/// The warning of a leg that is too short.
fn too_short(foot: &StandingFoot) -> Option<Warning> {
    let frame = foot.is_short_from()?;
    let message = format!(
        "the leg above {} is too short: from frame {frame} on, the foot stands {:.1} cm from its \
         place",
        foot.joint,
        100.0 * foot.short_by_metres
    );
    Some(Warning {
        joint: Some(foot.joint.clone()),
        frame: Some(frame),
        ..Warning::new("leg_too_short", message)
    })
}
