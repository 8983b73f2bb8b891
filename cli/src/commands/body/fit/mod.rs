//! `nullcone body fit`: a character in the pose of a person in views.

mod arguments;
mod cameras;
mod report;

pub(crate) use arguments::Arguments;

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result, ensure};
use ga_anim::clip::Clip;
use ga_anim::gltf::{Rigged, character};
use ga_anim::pose::Pose;
use ga_body::character::CharacterFit;
use ga_body::format::{DetectorOptions, JointViews};
use ga_character::Figure;
use ga_mannequin::Human;
use ga_mesh::gltf;

use crate::files::expanded;
use crate::format::Format;
use crate::frame::{Command, Context};
use crate::output;
use arguments::MANNEQUIN;
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
    let character = read_character(&arguments.character)?;
    let rate = arguments
        .fps
        .or(joints.frames_per_second())
        .unwrap_or(DEFAULT_RATE);
    ensure!(
        rate > 0.0 && rate.is_finite(),
        "--fps {rate}: the number of frames per second must be greater than 0 and finite"
    );
    let of_joints = || names(&arguments.joints);
    let mut fit = CharacterFit::new(character, &joints, &cameras).with_context(of_joints)?;
    if let Some(lengths) = arguments.fit_lengths {
        progress.step("fitting lengths");
        fit.fit_lengths(lengths.into()).with_context(of_joints)?;
    }
    progress.step("fitting poses");
    let done = |done, of| progress.at(done as u64, of as u64);
    let fitted = fit.fit(rate, arguments.independent, done);
    let fitted = fitted.with_context(of_joints)?;

    progress.step("writing");
    let document = fitted.to_document("fitted");
    let (document, losses) = document.with_context(|| arguments.character.display().to_string())?;
    let contents = gltf::encode(&document).context("the fitted character cannot be written")?;
    output::write(&arguments.out, &contents)?;
    Ok(Report::new(arguments, fitted, &losses))
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
    let figure = Figure::new(MANNEQUIN, Human::new().into());
    let rest = Pose::rest(figure.character.skeleton.len());
    let rest = Clip::new(1.0, vec![rest])?;
    let document = gltf::decode(&ga_character::gltf::encode(&figure, &rest, MANNEQUIN)?.0)?;
    Ok(Rigged::new(&document)?)
}
