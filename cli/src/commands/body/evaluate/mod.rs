//! `nullcone body evaluate`: how accurately bodies are reconstructed.

use std::path::PathBuf;

use anyhow::{Context as _, Result, ensure};
use ga_body::evaluation::{Case, Evaluation, Motion, MotionOptions};
use serde::Serialize;

use crate::format::Format;
use crate::frame::{self, Command, Context, Warning};
use crate::motion_file;
use ga_anim::retarget::begins_with_calibration;
use ga_anim::unit::likely_unit;

/// Measure how accurately bodies are reconstructed from their joints in pictures.
///
/// A motion is seen by synthetic cameras with f = 1000 px, 4 m from the body: by one; by a rig of
/// two with a baseline of 1 m; or by three and more in a circle around it. Their pixels get
/// Gaussian noise in both coordinates, and joints are missing by chance. From what is left the body
/// is found in three ways: by triangulation of each joint by itself (triangulation), by the fit of
/// a pose to each frame (single_frame), and by the fit of poses to a clip, which are smooth over
/// time (clip).
///
/// The bones have the lengths of the motion. Joints that are in one place at rest count once. For
/// instance
///
///   nullcone body evaluate --motion walk.bvh --noise 0,1,2,4 --views 1,2,4 --json --plot p.svg
///
/// prints {"motion": …, "data": …, "joints": …, "frames": …, "rows": [{"method": …, "noise_px": …,
/// "views": …, "missing": …, "mpjpe_mm": …, "root_relative_mm": …, "aligned_mm": …,
/// "joint_error_px": …, "milliseconds_per_frame": …, "joints_found": …}, …], …}. Errors are means
/// over all joints that were found, whose share is joints_found: triangulation needs two views that
/// show a joint, and a single frame needs three joints. joint_error_px is the distance in the
/// pictures from where the joint truly is, and times are those of one thread.
///
/// The lines that are printed without --json have the shape of tables 2 and 3 of Cui, with the
/// numbers printed there; those were measured on Human3.6M, and these on this motion, so that they
/// cannot be compared one by one.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The motion, BVH.
    #[arg(long, value_name = "F.bvh")]
    motion: PathBuf,
    /// The length of one unit of the motion in metres [default: found from the length of the legs].
    #[arg(long, value_name = "METRES")]
    metres_per_unit: Option<f64>,
    /// Standard deviations of the noise in pixels.
    #[arg(
        long,
        value_name = "PX,…",
        value_delimiter = ',',
        default_value = "0,1,2,4"
    )]
    noise: Vec<f64>,
    /// Numbers of cameras.
    #[arg(
        long,
        value_name = "N,…",
        value_delimiter = ',',
        default_value = "1,2,4"
    )]
    views: Vec<usize>,
    /// Probabilities that a view does not show a joint.
    #[arg(long, value_name = "P,…", value_delimiter = ',', default_value = "0")]
    missing: Vec<f64>,
    /// What noise and missing joints are made from.
    #[arg(long, value_name = "S", default_value_t = 1)]
    seed: u64,
    /// Take every Nth frame of the motion only; the frame rate is lower by that.
    #[arg(long, value_name = "N", default_value_t = 1)]
    every: usize,
    /// The greatest number of frames, in stretches of 120 that are evenly spread over the motion; 0
    /// for all.
    #[arg(long, value_name = "N", default_value_t = 240)]
    frames: usize,
    /// Draw 2-D joint errors, times and the errors over the noise as a picture.
    #[arg(long, value_name = "FILE.svg")]
    plot: Option<PathBuf>,
}

/// Greater numbers of cameras say nothing new and take long.
const MOST_VIEWS: usize = 32;

/// What is reported of an evaluation.
#[derive(Serialize)]
pub(crate) struct Report {
    motion: String,
    #[serde(flatten)]
    evaluation: Evaluation,
    #[serde(skip)]
    warnings: Vec<Warning>,
}

impl frame::Report for Report {
    fn warnings(&self) -> Option<&[Warning]> {
        Some(&self.warnings)
    }

    fn text(&self) -> String {
        format!("{}: {}", self.motion, self.evaluation.tables())
    }
}

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        check(self, context)?;
        let file = self.motion.display().to_string();
        let mut warnings = Vec::new();
        let recorded = motion_file::read(&self.motion, &mut warnings)?;
        let likely = likely_unit(&recorded);
        if self.metres_per_unit.is_none() {
            motion_file::warn_of_unit(&self.motion, likely, "--metres-per-unit", &mut warnings);
        }
        let options = MotionOptions {
            metres_per_unit: Some(self.metres_per_unit.unwrap_or(likely.metres)),
            first: usize::from(begins_with_calibration(&recorded)),
            every: self.every,
            most: self.frames,
        };
        let motion = Motion::new(&recorded, &options).with_context(|| file.clone())?;

        let cases = Case::combinations(&self.noise, &self.views, &self.missing);
        let progress = context.progress(cases.len() as u64);
        progress.step("reconstructing");
        let done = |done: usize, of: usize| progress.at(done as u64, of as u64);
        let evaluation = Evaluation::new(&motion, &cases, self.seed, done);
        let evaluation = evaluation.with_context(|| file.clone())?;
        drop(progress);
        if let Some(path) = &self.plot {
            let svg = evaluation.plot(&ga_files::name(&self.motion));
            let svg = svg.with_context(|| format!("cannot draw {}", path.display()))?;
            context.outputs().write(path, svg)?;
        }
        Ok(Report {
            motion: file,
            evaluation,
            warnings,
        })
    }
}

fn check(arguments: &Arguments, context: &Context) -> Result<()> {
    let lists = [
        ("--noise", arguments.noise.is_empty()),
        ("--views", arguments.views.is_empty()),
        ("--missing", arguments.missing.is_empty()),
    ];
    for (option, is_empty) in lists {
        ensure!(!is_empty, "{option} needs a number or several");
    }
    for noise in &arguments.noise {
        ensure!(
            *noise >= 0.0 && noise.is_finite(),
            "--noise {noise}: a standard deviation in pixels is 0 or greater, and finite"
        );
    }
    for missing in &arguments.missing {
        ensure!(
            (0.0..1.0).contains(missing),
            "--missing {missing}: a probability from 0 to below 1 is needed"
        );
    }
    for views in &arguments.views {
        ensure!(
            (1..=MOST_VIEWS).contains(views),
            "--views {views}: a number from 1 to {MOST_VIEWS} is needed"
        );
    }
    ensure!(arguments.every > 0, "--every 0: there is no such frame");
    if let Some(unit) = arguments.metres_per_unit {
        ensure!(
            unit > 0.0 && unit.is_finite(),
            "--metres-per-unit {unit}: the length of a unit must be greater than 0 and finite"
        );
    }
    let mut files = context.files([&arguments.motion])?;
    files.write_if_given("--plot", arguments.plot.as_ref(), &[Format::Svg])?;
    Ok(())
}
