//! `nullcone body fit`: a character in the pose of a person in views.

mod arguments;
mod report;

pub(crate) use arguments::Arguments;

use anyhow::{Context as _, Result};
use ga_body::character::CharacterFit;
use ga_mesh::gltf;

use crate::format::Format;
use crate::frame::{Command, Context};
use crate::person::CharacterFile;
use report::Report;

impl Command for Arguments {
    type Report = Report;

    fn is_check(&self) -> bool {
        self.check.check
    }

    fn run(&self, context: &Context) -> Result<Report> {
        let arguments = Self {
            joints: self.joints.expanded()?,
            ..self.clone()
        };
        fit_character(&arguments, context)
    }
}

fn fit_character(arguments: &Arguments, context: &Context) -> Result<Report> {
    let file = CharacterFile(&arguments.character);
    let inputs = arguments.joints.paths().iter();
    let mut files = context
        .files(inputs.chain(arguments.cameras.path()))?
        .and_reading(file.path());
    files.write("--out", &arguments.out, &[Format::Glb])?;
    let progress = context.progress(3);
    progress.step("reading");
    let joints = arguments.joints.read()?;
    let cameras = arguments.cameras.read(&joints.view_names())?;
    let cameras: Vec<_> = cameras.into_iter().map(|view| view.camera).collect();
    let character = file.read()?;
    let rate = arguments.joints.rate(&joints, None)?;
    let of_joints = || arguments.joints.names();
    let fit = CharacterFit::new(character, &joints, &cameras).with_context(of_joints)?;
    let fit = fit.with_lengths(arguments.fit_lengths.and_then(Into::into));
    progress.step("fitting poses");
    let done = |done, of| progress.at(done as u64, of as u64);
    let fitted = fit.fit(rate, arguments.independent, done);
    let fitted = fitted.with_context(of_joints)?;

    progress.step("writing");
    let document = fitted.to_document("fitted");
    let (document, losses) = document.with_context(|| arguments.character.display().to_string())?;
    let contents = gltf::encode(&document).context("the fitted character cannot be written")?;
    context.outputs().write(&arguments.out, &contents)?;
    Ok(Report::new(arguments, fitted, joints.notes(), &losses))
}
