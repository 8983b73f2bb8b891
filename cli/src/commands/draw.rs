//! `nullcone draw`: a scene of geometric elements as a picture or a page.

use std::path::PathBuf;

use anyhow::Result;
use ga_draw::Scene;
use serde::Serialize;

use crate::format::Format;
use crate::frame::{self, Command, Context};

/// Draw a scene of points, spheres, circles, lines, planes and motions.
///
/// The scene is JSON with a list of elements, each of one kind: point, flat_point, point_pair,
/// circle, sphere, line, plane, direction, motor, trajectory, blade (coefficients by the names of
/// blades), meet or join (the names of two earlier elements) or moved. For instance
///
/// {"title": "A line meets a sphere", "elements": [
///   {"name": "S", "sphere": {"centre": [0, 0, 0], "radius": 1}},
///   {"name": "l", "line": {"through": [[-2, 0, 0], [2, 0, 0.5]]}},
///   {"name": "S ∨ l", "meet": ["S", "l"]}]}
///
/// The documentation of ga-draw describes the format in full. --json prints {"out": …,
/// "shapes": …}, where shapes counts what is drawn.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The scene, as JSON.
    #[arg(value_name = "FILE.json")]
    file: PathBuf,
    /// The file to be written: a picture if its name ends in .svg, a page in which the mouse
    /// rotates the scene if it ends in .html or .htm.
    #[arg(long, value_name = "FILE.html or FILE.svg")]
    out: PathBuf,
}

/// What is printed.
#[derive(Serialize)]
pub(crate) struct Report {
    out: String,
    shapes: usize,
}

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        let Self { file, out } = self;
        let formats = [Format::Svg, Format::Html];
        let write = match context.files([file])?.write("--out", out, &formats)? {
            Format::Html => Scene::to_html,
            _ => Scene::to_svg,
        };
        let scene = ga_files::read(file, Scene::decode)?;
        context.outputs().write(out, write(&scene))?;
        Ok(Report {
            out: out.display().to_string(),
            shapes: scene.shapes().count(),
        })
    }
}

impl frame::Report for Report {
    fn text(&self) -> String {
        format!("wrote {}\n", self.out)
    }
}
