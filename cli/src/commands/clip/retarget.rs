//! `nullcone clip retarget`: a motion on another skeleton.

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result, ensure};
use ga_anim::clip::compressed;
use ga_anim::motion_file::{
    Animations, Format as MotionFormat, Loss, Options, WriteOptions, Written,
};
use ga_anim::recording::{Recording, ScalarTrack};
use ga_anim::retarget::{MapOrigin, Target, Transfer};
use ga_files::is_same_file;
use serde::Serialize;

use super::input::MotionArguments;
use super::target::{FORMATS, put, written};
use crate::format::Format;
use crate::frame::{self, Check, Command, Context, Progress, Verdict, Warning};
use crate::motion_file;
use crate::shell::quoted;
use crate::transfer::{Body, Motion, TransferArguments};

/// Transfer a motion to another skeleton.
///
/// Joints are matched by the usual names (Mixamo, MakeHuman, CMU, 3ds Max Biped, UpperLeg_L), by
/// the shape of the hierarchy where the names say nothing, or by a file given with --map. By its
/// shape, only a body that stands on two legs is taken for a person. "mapping" has a "confidence"
/// from 0 to 1, with a warning below 0.7, and "parts_missing", such as "left hand". Matched
/// bones become parallel to those of the motion and keep their lengths; other joints move with the
/// ones above them. The scale is the ratio of the lengths of the legs, and the feet are put on the
/// ground at y = 0, unless --keep-height is given.
///
/// What the rotations of the motion mean is found from the pose in which they are zero, where that
/// is a person who stands, and otherwise from what the joints do during the motion, so that it does
/// not depend on the axes in which they are written. --reference-frame and --reference-pose give a
/// pose that is like the target at rest. The vertical of the motion is found, or given with --up.
/// The rest of a character is the pose in which its skin was bound.
///
/// "checks" are measures of the motion as it is written, each the worst of all frames, with the
/// frame and the joint in "worst". Warnings name what a person does not do: a head more than 60°
/// from the trunk, bones longer or shorter by 1e-6, feet that are more than 0.05 legs above the
/// ground or below it in three quarters of the frames, a knee that bends backwards in more than 5 %
/// of the frames, a standing foot whose sole is more than 15° from flat or that points more than
/// 90° away from where the pelvis looks, in the median, and a joint that rotates by over 60° more
/// than the one that moves it from one frame to the next.
///
/// With --foot-locking, a foot whose ankle is slower than 0.05 m/s in the motion stays in one
/// place, and only thighs and shins deviate for that. A leg that is too short is reported. Where
/// the unit of a .bvh is not given, it is found from the length of the legs.
///
/// For instance
///
///   nullcone clip retarget 01_01.bvh --metres-per-unit 0.056444 --target hero.glb --foot-locking
///   --out hero-jumps.glb --json
///
/// writes hero-jumps.glb, which is hero.glb with the motion as its first animation and those that
/// it has behind that, unless --replace is given, and prints {"frames": 2752, "joints": …,
/// "map_by": "names", "map": {"LeftUpLeg": "thigh_l", …}, "slide_metres": …, "feet": […], …}. A map
/// that is printed is of the form that --map reads: the joint of the motion first, and the joint of
/// the target, or a list of them. slide_metres is how far apart two places of an ankle are at most
/// while it stands, in what is written; slide_free_metres is the same without --foot-locking. The
/// verdict is doubtful where there is a warning but for what the format of the output does not
/// hold, which is listed in warnings too, and otherwise good.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    #[command(flatten)]
    motion: MotionArguments,
    /// The skeleton: that of a BVH file or of a compressed clip at rest, or the joints of a glTF
    /// file in the pose in which its skin was bound.
    #[arg(long, value_name = "FILE.bvh|FILE.glb|FILE.clip")]
    target: PathBuf,
    /// The length of one unit of a target of the kind .bvh in metres [default: found from the
    /// length of the legs].
    #[arg(long, value_name = "METRES")]
    target_metres_per_unit: Option<f64>,
    #[command(flatten)]
    transfer: TransferArguments,
    /// The greatest error of a joint by compression, for .clip; by default that of a target that is
    /// a clip, otherwise 0.0001.
    #[arg(long, value_name = "METRES")]
    tolerance: Option<f64>,
    /// The motion to be written, in the format that its name says.
    ///
    /// A .glb or .gltf keeps all that a target of that kind has, with the motion as the first
    /// animation; a .bvh the unit, channels, offsets and End Sites of a target of that kind. What a
    /// format does not hold is listed in warnings.
    #[arg(long, value_name = "OUT.bvh|OUT.glb|OUT.clip")]
    out: PathBuf,
    /// Drop the animations that a target of the kind .glb or .gltf has.
    #[arg(long)]
    replace: bool,
    #[command(flatten)]
    check: Check,
}

impl Command for Arguments {
    type Report = Report;

    fn is_check(&self) -> bool {
        self.check.check
    }

    fn run(&self, context: &Context) -> Result<Report> {
        let inputs = [&self.motion.motion, &self.target].into_iter();
        let mut files = context.files(inputs.chain(self.transfer.inputs()))?;
        let format = files.write("--out", &self.out, &FORMATS)?;
        self.check_options(format)?;
        let progress = context.progress(5);
        let mut warnings = Vec::new();
        progress.step("reading the target");
        let target = self.target(&mut warnings)?;
        progress.step("reading the motion");
        let (file, target_file) = (self.motion.file(), self.target.display().to_string());
        let read = self.motion.read(&mut warnings)?;
        let source = read.recording_in_units().with_context(|| file.clone())?;
        progress.step("transferring the motion");
        let body = Body {
            skeleton: target.skeleton(),
            soles: target.soles(),
            motion: target.motion(),
            metres_per_unit: target.metres_per_unit(),
        };
        let motion = Motion {
            file: &self.motion.motion,
            source: &source,
            metres_per_unit: read.metres_per_unit(),
            frames: None,
        };
        let transfer = self.transfer.transfer(&motion, &body, &mut warnings);
        let transfer = transfer.with_context(|| format!("{file} cannot move {target_file}"))?;
        let verdict = Verdict::of(&warnings);
        let recording = target.recording(&transfer.clip);
        let tracks = self.tracks(&source, &mut warnings);
        let recording = recording.and_then(|it| Ok(it.with_tracks(tracks)?));
        let recording = recording.with_context(|| target_file.clone())?;
        let written = self.written(format, &target, &recording, &progress)?;
        let outputs = context.outputs();
        put(
            &self.out,
            format,
            written,
            &self.target,
            outputs,
            &mut warnings,
        )?;
        Ok(Report {
            file,
            target: target_file,
            out: self.out.display().to_string(),
            metres_per_unit: read.metres_per_unit(),
            transfer,
            verdict,
            warnings,
        })
    }
}

impl Arguments {
    /// Fails where an option would have no effect.
    fn check_options(&self, format: Format) -> Result<()> {
        let target = MotionFormat::of_path(&self.target).context("--target")?;
        let (is_bvh, is_gltf) = (target == MotionFormat::Bvh, target == MotionFormat::Gltf);
        let (unit, tolerance) = (self.target_metres_per_unit, self.tolerance);
        for (option, is_given, applies, file) in [
            (
                "--target-metres-per-unit",
                unit.is_some(),
                is_bvh,
                &self.target,
            ),
            ("--replace", self.replace, is_gltf, &self.target),
            (
                "--tolerance",
                tolerance.is_some(),
                format == Format::Clip,
                &self.out,
            ),
        ] {
            let file = file.display();
            ensure!(applies || !is_given, "{option} does not apply to {file}");
        }
        Ok(())
    }

    fn target(&self, warnings: &mut Vec<Warning>) -> Result<Target> {
        let (path, option) = (&self.target, "--target-metres-per-unit");
        let options = Options {
            metres_per_unit: motion_file::checked_unit(option, self.target_metres_per_unit)?,
            ..Options::default()
        };
        let file = motion_file::read_any(path, options, option, warnings)?;
        Target::new(file).with_context(|| path.display().to_string())
    }

    /// The scalar tracks that mean the same for the target; others are listed.
    fn tracks(&self, source: &Recording, warnings: &mut Vec<Warning>) -> Vec<ScalarTrack> {
        let is_own = is_same_file(&self.motion.motion, &self.target);
        let tracks = source.tracks().iter().cloned();
        let (kept, left): (Vec<_>, Vec<_>) =
            tracks.partition(|track| is_own || !track.is_of_numbered_target());
        if !left.is_empty() {
            let tracks = left.into_iter().map(|track| track.name).collect();
            warnings.push(motion_file::lost(&Loss::Tracks { tracks }, &self.out));
        }
        kept
    }

    /// A motion of the target in a format.
    fn written(
        &self,
        format: Format,
        target: &Target,
        recording: &Recording,
        progress: &Progress,
    ) -> Result<Written> {
        let defaults = target.file().compression();
        let options = WriteOptions {
            name: &ga_files::stem(&self.motion.motion),
            like: Some(target.file()),
            animations: match self.replace {
                true => Animations::Alone,
                false => Animations::First,
            },
            compression: compressed::Options {
                tolerance: self.tolerance.unwrap_or(defaults.tolerance),
                ..defaults
            },
            ..WriteOptions::default()
        };
        let written = written(recording, format, &options, progress);
        written.with_context(|| format!("{} cannot be written", self.out.display()))
    }
}

/// What was written, with which joints, and how feet stand.
#[derive(Debug, Serialize)]
pub(crate) struct Report {
    file: String,
    target: String,
    out: String,
    metres_per_unit: f64,
    #[serde(flatten)]
    transfer: Transfer,
    /// Of what is seen in the motion, whatever the format leaves out.
    #[serde(skip)]
    verdict: Verdict,
    #[serde(skip)]
    warnings: Vec<Warning>,
}

impl frame::Report for Report {
    fn warnings(&self) -> Option<&[Warning]> {
        Some(&self.warnings)
    }

    fn verdict(&self) -> Option<Verdict> {
        Some(self.verdict)
    }

    fn next(&self) -> Option<String> {
        let is_clip = Format::Clip.fits(Path::new(&self.out));
        is_clip.then(|| format!("nullcone clip info {}", quoted(&self.out)))
    }

    fn text(&self) -> String {
        let (out, target, transfer) = (&self.out, &self.target, &self.transfer);
        let (frames, joints) = (transfer.frames, transfer.joints);
        let matched = joints - transfer.joints_without_counterpart.len();
        let by = match transfer.map_by {
            MapOrigin::Names => "names",
            MapOrigin::Structure => "structure",
            MapOrigin::File => "the map",
        };
        let mut lines = format!(
            "{out}: {frames} frames on {matched} of {joints} joints of {target}, matched by {by}\n\
             a unit of the motion is {} m\n",
            transfer.motion_metres_per_unit
        );
        for foot in &transfer.feet {
            let free = match transfer.foot_locking {
                true => format!(
                    ", {:.2} mm without foot locking",
                    1e3 * foot.slide_free_metres
                ),
                false => String::new(),
            };
            lines += &format!(
                "{:10} stands {} times, in {} frames; slides {:.2} mm at most{free}\n",
                foot.joint,
                foot.contacts,
                foot.standing_frames,
                1e3 * foot.slide_metres,
            );
        }
        lines
    }
}
