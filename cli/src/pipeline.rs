//! From a figure and its motion to the files, the same for every command.

use std::path::PathBuf;
use std::time::Instant;

use anyhow::{Context, Result};
use ga_anim::clip::Clip;

use crate::checks::Checks;
use crate::figure::Figure;
use crate::files::Files;
use crate::format::Format;
use crate::frame::Progress;
use crate::output::{self, File};
use crate::overlay::{Overlay, OverlayArguments};
use crate::report::{AnimationReport, FigureReport, FileReport, Input, Report, Tool};
use crate::storyboard::Storyboard;
use crate::summary::{Performed, Written};
use crate::two_views::TwoViews;
use crate::{model, sheet};

/// How many steps [`perform`] reports as progress.
pub(crate) const STEPS: u64 = 5;

const SHEET: &str = "sheet.png";
const REPORT: &str = "report.json";

/// Where the files are written, and the seed of the random numbers.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct OutputArguments {
    /// The folder that the files are written to; it is created where it is missing.
    #[arg(long, value_name = "DIR", default_value = "out")]
    pub(crate) out: PathBuf,
    /// The seed of the noise in the pictures of the two cameras.
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub(crate) seed: u64,
    #[command(flatten)]
    pub(crate) overlay: OverlayArguments,
    /// Also write the motion as an animated PNG, at most 1000 pictures.
    #[arg(long, value_name = "FILE.png")]
    pub(crate) film: Option<PathBuf>,
}

impl OutputArguments {
    /// Fails early where the files could not be written in the end, or would replace one of those
    /// that are read.
    pub(crate) fn check(&self, mut files: Files) -> Result<()> {
        let names = model::NAMES.iter().chain(&[SHEET, REPORT]);
        files.write_folder("--out", &self.out, names)?;
        files.write_if_given("--film", self.film.as_ref(), &[Format::Png])?;
        Ok(())
    }
}

/// A figure with its motion, and what is written about it.
pub(crate) struct Performance {
    pub(crate) command: &'static str,
    pub(crate) input: Input,
    pub(crate) figure: Figure,
    /// The group of the input mesh that the figure is, and the length of one unit of that mesh.
    pub(crate) group: Option<String>,
    pub(crate) metres_per_unit: f64,
    /// The motion as it is written.
    pub(crate) clip: Clip,
    pub(crate) clip_name: String,
    pub(crate) storyboard: Storyboard,
    pub(crate) title: String,
    pub(crate) in_between_deviation: Option<f64>,
}

/// Computes everything, then writes everything.
pub(crate) fn perform(
    performance: &Performance,
    arguments: &OutputArguments,
    progress: &Progress,
    begin: Instant,
) -> Result<Performed> {
    let Performance { figure, clip, .. } = performance;
    let overlay = Overlay::new(figure, clip, &arguments.overlay)?;
    progress.step("measuring the motion");
    let checks = Checks::new(figure, clip).context("the motion cannot be measured")?;
    progress.step("looking from two sides");
    let two_views =
        TwoViews::new(figure, clip, arguments.seed).context("two cameras cannot see the motion")?;
    progress.step("drawing the contact sheet");
    let storyboard = &performance.storyboard;
    let sheet = sheet::draw(figure, storyboard, &performance.title, &overlay)?;
    let film = match &arguments.film {
        Some(path) => {
            progress.step("drawing the film");
            Some((path, sheet::film(figure, storyboard, clip, &overlay)?))
        }
        None => None,
    };
    progress.step("making the model");
    let mut files = model::files(figure, clip, &performance.clip_name)?;
    let pixels = [sheet.width, sheet.height];
    files.insert(
        2,
        File {
            name: SHEET,
            contents: sheet.png,
        },
    );
    let vertices = figure.mesh.vertex_count();
    let paint = figure.paint.as_ref();
    let listed = files.iter().map(|file| match file.name {
        SHEET => FileReport::new(file, None, Some(pixels)),
        model::MTL => FileReport::new(file, None, None),
        model::SKIN => {
            let size = paint.map(|paint| [paint.width(), paint.height()].map(|side| side as u32));
            FileReport::new(file, None, size)
        }
        _ => FileReport::new(file, Some(vertices), None),
    });
    let listed = listed.collect();

    let report = report(performance, checks, two_views, listed);
    let mut text =
        serde_json::to_string_pretty(&report).context("the report cannot be written as JSON")?;
    text.push('\n');
    files.push(File {
        name: REPORT,
        contents: text.into_bytes(),
    });
    progress.step("writing");
    let in_folder = files
        .iter()
        .map(|file| (arguments.out.join(file.name), &file.contents));
    let beside = film
        .iter()
        .map(|(path, contents)| (path.to_path_buf(), contents));
    output::write_together(in_folder.chain(beside))?;
    let written = files
        .iter()
        .map(|file| Written::new(arguments.out.join(file.name), &file.contents));
    let film = film.map(|(path, contents)| Written::new(path.clone(), &contents));
    let written = written.chain(film).collect();
    Ok(Performed::new(report, written, begin.elapsed()))
}

fn report(
    performance: &Performance,
    checks: Checks,
    two_views: TwoViews,
    files: Vec<FileReport>,
) -> Report {
    let Performance { figure, clip, .. } = performance;
    Report {
        tool: Tool::NULLCONE,
        command: performance.command,
        input: performance.input.clone(),
        figure: FigureReport {
            name: figure.name.clone(),
            group: performance.group.clone(),
            metres_per_unit: performance.metres_per_unit,
            height_metres: figure.height(),
            vertices: figure.mesh.vertex_count(),
            faces: figure.mesh.faces().len(),
            triangles: figure.mesh.triangles().len(),
            joints: figure.skeleton.len(),
            influences_max: figure.weights.max_influences(),
        },
        animation: AnimationReport {
            name: performance.clip_name.clone(),
            frames: clip.frames().len(),
            frames_per_second: 1.0 / clip.frame_time(),
            duration_seconds: clip.duration(),
            checks,
            in_between_deviation_max_metres: performance.in_between_deviation,
        },
        two_views,
        files,
    }
}
