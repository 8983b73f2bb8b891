//! A motion of a file on a figure.

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result, bail, ensure};
use ga_anim::character::Character;
use ga_anim::motion_file::Options;
use ga_anim::recording::Recording;
use ga_anim::retarget::{Soles, Transfer, begins_with_calibration};
use ga_character::{Animation, Figure, Storyboard};

use crate::frame::Warning;
use crate::motion_file;
use crate::pipeline::Performance;
use crate::report::{Input, MotionInput};
use crate::transfer::{Body, Motion, TransferArguments};

/// How a motion is read, where it begins, and how it is transferred.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct RetargetedArguments {
    /// The length of one unit of the motion in metres [default: of BVH found from the length of the
    /// legs, of glTF 1]. A compressed clip is in metres.
    #[arg(long, value_name = "METRES", requires = "motion")]
    pub(crate) motion_metres_per_unit: Option<f64>,
    #[command(flatten)]
    transfer: TransferArguments,
    /// The first frame of the motion, counted from 0.
    ///
    /// The default is 0, or 1 where frame 0 is a calibration pose (such as a T): a joint then moves
    /// more than three times as far from frame 0 to frame 1 as between any two later frames. The
    /// summary and the report say when that is so.
    #[arg(long, value_name = "F", requires = "motion")]
    pub(crate) from: Option<usize>,
}

/// Where a motion ends.
#[derive(Clone, Copy, Debug)]
pub(crate) enum End {
    /// After this frame, or the last one.
    Frame(Option<usize>),
    /// After this many seconds, or the last frame.
    Seconds(f64),
}

/// A range of frames of the motion, both ends included.
#[derive(Clone, Copy)]
struct Range {
    from: usize,
    to: usize,
    calibration_left_out: bool,
}

/// A motion on a character.
pub(crate) struct Retargeted {
    name: String,
    stem: String,
    range: Range,
    input: MotionInput,
    pub(crate) transfer: Transfer,
}

impl RetargetedArguments {
    /// The files that are read beside the motion.
    pub(crate) fn inputs(&self) -> impl Iterator<Item = &PathBuf> {
        self.transfer.inputs()
    }

    /// Reads a motion and transfers it to a character, which messages call by a name.
    pub(crate) fn retarget(
        &self,
        file: &Path,
        end: End,
        onto: (&Character, &str),
        warnings: &mut Vec<Warning>,
    ) -> Result<Retargeted> {
        let option = "--motion-metres-per-unit";
        let options = Options {
            metres_per_unit: motion_file::checked_unit(option, self.motion_metres_per_unit)?,
            ..Options::default()
        };
        let read = motion_file::read_any(file, options, option, warnings)?;
        let motion = read.recording_in_units();
        let motion = motion.with_context(|| file.display().to_string())?;
        self.retarget_recording(file, (&motion, read.metres_per_unit()), end, onto, warnings)
    }

    /// Transfers a motion that was read, whose unit has a length.
    pub(crate) fn retarget_recording(
        &self,
        file: &Path,
        (motion, metres_per_unit): (&Recording, f64),
        end: End,
        (character, rig): (&Character, &str),
        warnings: &mut Vec<Warning>,
    ) -> Result<Retargeted> {
        let range = self.frames(file, end, motion)?;
        let onto = || format!("{} cannot move {rig}", file.display());
        let soles = Soles::of_mesh(character.mesh.positions(), &character.weights);
        let soles = soles.with_context(onto)?;
        let source = Motion {
            file,
            source: motion,
            metres_per_unit,
            frames: Some([range.from, range.to]),
        };
        let body = Body {
            skeleton: &character.skeleton,
            soles: Some(&soles),
            motion: None,
            metres_per_unit: 1.0,
        };
        let transfer = self.transfer.transfer(&source, &body, warnings);
        let transfer = transfer.with_context(onto)?;
        let name = ga_files::name(file);
        Ok(Retargeted {
            input: MotionInput {
                name: name.clone(),
                joints: motion.joints().len(),
                frames: motion.frame_count(),
                frames_per_second: 1.0 / motion.frame_time(),
                first_frame: range.from,
                last_frame: range.to,
                calibration_frame_left_out: range.calibration_left_out,
                joints_without_counterpart: transfer.joints_without_counterpart.clone(),
                metres_per_unit: transfer.target_units_per_unit,
            },
            name,
            stem: ga_files::stem(file),
            range,
            transfer,
        })
    }

    fn frames(&self, file: &Path, end: End, motion: &Recording) -> Result<Range> {
        let (count, path) = (motion.frame_count(), file.display());
        ensure!(count > 0, "{path}: the motion has no frames");
        let last = count - 1;
        let to = match end {
            End::Frame(to) => to,
            End::Seconds(_) => None,
        };
        for (option, frame) in [("--from", self.from), ("--to", to)] {
            if let Some(frame) = frame.filter(|&frame| frame > last) {
                bail!("{option} {frame}: the frames of {path} are 0 to {last}");
            }
        }
        let to = to.unwrap_or(last);
        let calibration_left_out = self.from.is_none() && to > 0 && begins_with_calibration(motion);
        let from = self.from.unwrap_or(calibration_left_out.into());
        let to = match end {
            End::Frame(_) => to,
            End::Seconds(seconds) => {
                let frames = (seconds / motion.frame_time()).ceil() as usize;
                to.min(from.saturating_add(frames))
            }
        };
        Ok(Range {
            from,
            to,
            calibration_left_out,
        })
    }
}

/// The files of a figure, without their folders.
pub(crate) struct FigureFiles {
    pub(crate) mesh: String,
    pub(crate) rig: String,
    pub(crate) weights: String,
}

impl Retargeted {
    /// The figure with the motion at a rate.
    pub(crate) fn performance(
        self,
        command: &'static str,
        files: FigureFiles,
        figure: Figure,
        frames_per_second: f64,
    ) -> Result<Performance> {
        let Self {
            name,
            stem,
            range,
            input,
            transfer,
        } = self;
        let clip = transfer.clip.resampled(frames_per_second);
        let clip = clip.with_context(|| format!("{name} at {frames_per_second} Hz"))?;
        let storyboard = Storyboard::of_recording(&transfer.clip, range.from);
        let deviation = storyboard.deviation(&figure.character, &transfer.clip)?;
        let FigureFiles { mesh, rig, weights } = files;
        Ok(Performance {
            command,
            input: Input {
                mesh,
                rig,
                weights,
                motion: input,
            },
            figure,
            animation: Animation {
                name: stem,
                clip,
                storyboard,
                title: format!(
                    "{name}, frames {} to {}: keys and 3 in-betweens after each by screw motion",
                    range.from, range.to
                ),
                in_between_deviation: Some(deviation),
            },
            checks: Some(transfer.checks),
        })
    }
}
