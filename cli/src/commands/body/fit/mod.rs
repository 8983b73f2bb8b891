//! `nullcone body fit`: a character in the pose of a person in views.

mod arguments;
mod cameras;
mod matched;
mod report;

pub(crate) use arguments::Arguments;

use std::path::{Path, PathBuf};
use std::time::Instant;

use anyhow::{Context as _, Result, ensure};
use ga_anim::clip::Clip;
use ga_anim::gltf::{Rigged, character};
use ga_anim::pose::Pose;
use ga_body::agreement::Agreement;
use ga_body::format::{DetectorOptions, JointViews};
use ga_body::{BodyFit, BodyModel, FittedPose, Observation};
use ga_camera::Camera;
use ga_mannequin::Human;
use ga_mesh::gltf;

use crate::figure::Figure;
use crate::files::expanded;
use crate::format::Format;
use crate::frame::{Command, Context, Progress};
use crate::{model, output};
use arguments::MANNEQUIN;
use matched::Matched;
use report::Report;

const DEFAULT_RATE: f64 = 30.0;

impl Command for Arguments {
    type Report = Report;

    fn is_check(&self) -> bool {
        self.check.check
    }

    fn run(&self, context: &Context) -> Result<Report> {
        let arguments = Self {
            joints: expanded("--joints", &self.joints)?,
            ..self.clone()
        };
        fit_character(&arguments, context)
    }
}

fn fit_character(arguments: &Arguments, context: &Context) -> Result<Report> {
    let inputs = arguments.joints.iter().chain(arguments.cameras.path());
    let mut files = context.files(inputs)?;
    if !is_mannequin(&arguments.character) {
        files = files.and_reading([&arguments.character]);
    }
    files.write("--out", &arguments.out, &[Format::Glb])?;
    let deviation = arguments.deviation;
    ensure!(
        deviation > 0.0 && deviation.is_finite(),
        "--deviation {deviation}: a standard deviation in pixels is greater than 0 and finite"
    );
    let progress = context.progress(5);
    progress.step("reading");
    let options = DetectorOptions {
        deviation_px: deviation,
        person: arguments.person,
        ..DetectorOptions::default()
    };
    let joints = JointViews::read(&arguments.joints, &options)?;
    let cameras = arguments.cameras.read(&joints)?;
    let mut body = read_character(&arguments.character)?;
    let rate = arguments
        .fps
        .or(joints.frames_per_second())
        .unwrap_or(DEFAULT_RATE);
    ensure!(
        rate > 0.0 && rate.is_finite(),
        "--fps {rate}: the number of frames per second must be greater than 0 and finite"
    );
    let of_joints = || names(&arguments.joints);
    let mut matched = Matched::new(&joints, body.skeleton()).with_context(of_joints)?;
    let observations: Vec<Observation> = (0..joints.frame_count())
        .filter_map(|frame| joints.observation(frame, &matched.order))
        .collect();

    if let Some(lengths) = arguments.fit_lengths {
        progress.step("fitting lengths");
        let fitted = matched.fit_lengths(&body, &cameras, &observations, lengths);
        body = fitted.with_context(of_joints)?;
    }
    progress.step("fitting poses");
    let begin = Instant::now();
    let fitted = fit(
        &matched.model,
        &cameras,
        &observations,
        rate,
        arguments.independent,
        &progress,
    )
    .with_context(of_joints)?;
    let seconds = begin.elapsed().as_secs_f64();

    progress.step("writing");
    let poses = fitted.iter().map(|fit| fit.pose.clone()).collect();
    let clip = Clip::new(1.0 / rate, poses)?;
    let document = body.with_clip("fitted", &clip);
    let document = document.with_context(|| arguments.character.display().to_string())?;
    let contents = gltf::encode(&document).context("the fitted character cannot be written")?;
    output::write(&arguments.out, &contents)?;
    let agreement = Agreement::new(&fitted, &observations);
    let report = Report::new(arguments, &joints, &matched, &fitted, [rate, seconds]);
    Ok(report.with_warnings(&agreement))
}

fn names(paths: &[PathBuf]) -> String {
    let names: Vec<String> = paths
        .iter()
        .map(|path| path.display().to_string())
        .collect();
    names.join(", ")
}

/// Whether a character is the one that the program makes itself. A file of that name is written
/// with its folder, as in `./mannequin`.
fn is_mannequin(path: &Path) -> bool {
    path.as_os_str() == MANNEQUIN
}

/// The character that is fitted.
fn read_character(path: &Path) -> Result<Rigged> {
    if is_mannequin(path) {
        return mannequin();
    }
    let shown = || path.display().to_string();
    let document = gltf::read(path)?;
    // Without a skin there is no body to be posed.
    character(&document).with_context(shown)?;
    Rigged::new(&document).with_context(shown)
}

/// The person that the program makes itself, as one from a file.
fn mannequin() -> Result<Rigged> {
    let Human {
        mesh,
        skeleton,
        weights,
    } = Human::new();
    let rest = Clip::new(1.0, vec![Pose::rest(skeleton.len())])?;
    let figure = Figure {
        name: MANNEQUIN.to_owned(),
        mesh,
        skeleton,
        weights,
        paint: None,
    };
    let document = gltf::decode(&model::glb(&figure, &rest, MANNEQUIN, None)?)?;
    Ok(Rigged::new(&document)?)
}

fn fit(
    model: &BodyModel,
    cameras: &[Camera],
    observations: &[Observation],
    rate: f64,
    independent: bool,
    progress: &Progress,
) -> Result<Vec<FittedPose>> {
    let fit = BodyFit::new(model, cameras)?;
    if !independent {
        return Ok(fit.clip(observations, rate)?);
    }
    let count = observations.len() as u64;
    let frames = observations.iter().enumerate().map(|(frame, observation)| {
        progress.at(frame as u64, count);
        fit.frame(observation)
            .with_context(|| format!("frame {frame}"))
    });
    frames.collect()
}
