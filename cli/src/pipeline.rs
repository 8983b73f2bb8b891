//! From a figure and its motion to the files, the same for every command.

use std::path::PathBuf;
use std::time::Instant;

use anyhow::{Context, Result};
use ga_anim::clip::Clip;

use crate::checks::Checks;
use crate::figure::Figure;
use crate::output::{self, File};
use crate::progress::Progress;
use crate::report::{AnimationReport, FigureReport, FileReport, Input, Report, Tool};
use crate::storyboard::Storyboard;
use crate::two_views::TwoViews;
use crate::{model, sheet, summary};

/// How many steps [`perform`] reports as progress.
pub(crate) const STEPS: u64 = 5;

const OBJ: &str = "model.obj";
const GLB: &str = "model.glb";
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
}

impl OutputArguments {
    /// Fails early where the files could not be written in the end.
    pub(crate) fn check(&self) -> Result<()> {
        output::check_place(&self.out, &[OBJ, GLB, SHEET, REPORT])
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

/// Computes everything, then writes everything, then prints a summary.
pub(crate) fn perform(
    performance: &Performance,
    arguments: &OutputArguments,
    progress: Progress,
    begin: Instant,
    quiet: bool,
) -> Result<()> {
    let Performance { figure, clip, .. } = performance;
    progress.step("measuring the motion");
    let checks = Checks::new(figure, clip).context("the motion cannot be measured")?;
    progress.step("looking from two sides");
    let two_views =
        TwoViews::new(figure, clip, arguments.seed).context("two cameras cannot see the motion")?;
    progress.step("drawing the contact sheet");
    let sheet = sheet::draw(figure, &performance.storyboard, &performance.title)?;
    progress.step("making the model");
    let mut files = vec![
        File {
            name: OBJ,
            contents: model::obj(figure),
        },
        File {
            name: GLB,
            contents: model::glb(figure, clip, &performance.clip_name)?,
        },
    ];
    let vertices = figure.mesh.vertex_count();
    let mut listed: Vec<FileReport> = files
        .iter()
        .map(|file| FileReport::new(file, Some(vertices), None))
        .collect();
    let pixels = [sheet.width, sheet.height];
    files.push(File {
        name: SHEET,
        contents: sheet.png,
    });
    listed.extend(
        files
            .last()
            .map(|file| FileReport::new(file, None, Some(pixels))),
    );

    let report = report(performance, checks, two_views, listed);
    let mut text =
        serde_json::to_string_pretty(&report).context("the report cannot be written as JSON")?;
    text.push('\n');
    files.push(File {
        name: REPORT,
        contents: text.into_bytes(),
    });
    progress.step("writing");
    output::write_all(&arguments.out, &files)?;
    drop(progress);
    if !quiet {
        summary::print(&report, &arguments.out, &files, begin.elapsed())?;
    }
    Ok(())
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
