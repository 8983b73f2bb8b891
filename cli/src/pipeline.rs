//! From a figure and its motion to the files, the same for every command.

use std::path::PathBuf;
use std::time::Instant;

use anyhow::{Context, Result};
use ga_character::report::{AnimationReport, FigureReport};
use ga_character::{Animation, Figure, Overlay, TwoViews, model, pictures};
use ga_files::Staged;

use crate::files::Files;
use crate::film_file;
use crate::format::Format;
use crate::frame::Progress;
use crate::output;
use crate::report::{Input, Performed, Report, Tool, Written};

/// How many steps [`perform`] reports as progress.
pub(crate) const STEPS: u64 = 5;

/// The name of the file that holds the report.
const REPORT: &str = "report.json";

/// Where the files are written, what is drawn over the pictures, and the seed of the random
/// numbers.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct OutputArguments {
    /// The folder that the files are written to; it is created where it is missing.
    #[arg(long, value_name = "DIR", default_value = "out")]
    out: PathBuf,
    /// The seed of the noise in the pictures of the two cameras.
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// Draw the bones over the skin.
    #[arg(long)]
    bones: bool,
    /// Draw the paths of these joints during the last second over the picture; `all` for every
    /// joint.
    ///
    /// Example: --trails LeftHand,RightFoot
    #[arg(long, value_name = "JOINT,…", value_delimiter = ',')]
    trails: Vec<String>,
    /// Also write the motion as a film: an animated PNG if its name ends in .png, or without
    /// compression if it ends in .y4m.
    #[arg(long, value_name = "FILE.png|FILE.y4m")]
    film: Option<PathBuf>,
}

impl OutputArguments {
    /// Fails early where the files could not be written in the end, or would replace one of those
    /// that are read.
    pub(crate) fn check(&self, mut files: Files) -> Result<()> {
        let names = model::NAMES.iter().chain(&[pictures::SHEET, REPORT]);
        files.write_folder("--out", &self.out, names)?;
        files.write_if_given("--film", self.film.as_ref(), &film_file::FORMATS)?;
        Ok(())
    }

    /// The path of the model with its motion.
    pub(crate) fn model(&self) -> PathBuf {
        self.out.join(model::GLB)
    }

    fn overlay<'a>(&self, figure: &'a Figure, animation: &'a Animation) -> Result<Overlay<'a>> {
        let mut joints = Vec::new();
        for name in &self.trails {
            let named = figure.joints_named(name);
            joints.extend(named.with_context(|| format!("--trails {name}"))?);
        }
        Ok(Overlay {
            character: &figure.character,
            clip: &animation.clip,
            bones: self.bones,
            joints,
        })
    }
}

/// A figure with its motion, and where both come from.
pub(crate) struct Performance {
    pub(crate) command: &'static str,
    pub(crate) input: Input,
    pub(crate) figure: Figure,
    pub(crate) animation: Animation,
}

/// Computes everything, then writes everything.
pub(crate) fn perform(
    performance: Performance,
    arguments: &OutputArguments,
    progress: &Progress,
    begin: Instant,
) -> Result<Performed> {
    let Performance {
        command,
        input,
        figure,
        animation,
    } = performance;
    let overlay = arguments.overlay(&figure, &animation)?;
    progress.step("measuring the motion");
    let measured = AnimationReport::new(&figure, &animation);
    let measured = measured.context("the motion cannot be measured")?;
    progress.step("looking from two sides");
    let two_views = TwoViews::new(&figure.character, &animation.clip, arguments.seed)
        .context("two cameras cannot see the motion")?;
    progress.step("drawing the contact sheet");
    let sheet = pictures::sheet(&figure, &animation, &overlay)?;
    let mut staged = Staged::default();
    let mut written = Vec::new();
    if let Some(path) = &arguments.film {
        progress.step("drawing the film");
        let format = Format::of(path, &film_file::FORMATS).unwrap_or(Format::Png);
        let frames = animation.clip.frames().len() as u64;
        let mut bytes = 0;
        output::stage_with(&mut staged, path, |file| {
            bytes = film_file::write(file, |file| {
                let format = film_file::encoding(format);
                let mut done = |done| progress.at(done as u64, frames);
                let film =
                    pictures::write_film(&figure, &animation, &overlay, file, format, &mut done);
                Ok(film?)
            })?;
            Ok(())
        })?;
        written.push(Written {
            file: path.display().to_string(),
            bytes,
        });
    }
    progress.step("making the model");
    let mut files = model::files(&figure, &animation.clip, &animation.name)?;
    files.insert(2, sheet);

    let report = Report {
        tool: Tool::NULLCONE,
        command,
        input,
        figure: FigureReport::new(&figure),
        animation: measured,
        two_views,
        files,
    };
    let mut text =
        serde_json::to_string_pretty(&report).context("the report cannot be written as JSON")?;
    text.push('\n');
    progress.step("writing");
    let files = report.files.iter();
    let files = files.map(|file| (arguments.out.join(file.name), file.contents.as_slice()));
    let contents = files.chain([(arguments.out.join(REPORT), text.as_bytes())]);
    let mut others = Vec::new();
    for (path, contents) in contents {
        output::stage(&mut staged, &path, contents)?;
        others.push(Written {
            file: path.display().to_string(),
            bytes: contents.len(),
        });
    }
    staged.finish()?;
    written.splice(0..0, others);
    Ok(Performed {
        report,
        written,
        seconds: begin.elapsed().as_secs_f64(),
        warnings: Vec::new(),
    })
}
