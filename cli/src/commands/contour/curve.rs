//! The closed curve in space that two views show.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result};
use ga_mesh::format::{Format as MeshFormat, Options};
use ga_vision::contour::space_curve::{
    NearestSpaceCircle, NearestSpaceLine, SpaceCurveMeasures, SpaceCurveOptions, SpaceCurvePoint,
    space_curve,
};
use serde::Serialize;

use super::Arguments;
use super::arguments::{Figure, check_out};
use super::settling::Settled;
use crate::commands::stereo::views;
use crate::frame::{Context, Warning, keep_for_failure};
use crate::mesh_file;

#[derive(Serialize)]
pub(crate) struct Report {
    #[serde(skip)]
    pub(super) warnings: Vec<Warning>,
    width_px: usize,
    height_px: usize,
    baseline_metres: f64,
    left_snake: Settled,
    right_snake: Settled,
    #[serde(flatten)]
    measures: SpaceCurveMeasures,
    #[serde(skip_serializing_if = "Option::is_none")]
    circle: Option<NearestSpaceCircle>,
    #[serde(skip_serializing_if = "Option::is_none")]
    line: Option<NearestSpaceLine>,
    points: Vec<SpaceCurvePoint>,
}

pub(super) fn run(
    arguments: &Arguments,
    paths: [&PathBuf; 2],
    rig_path: &Path,
    context: &Context,
) -> Result<Report> {
    let format = check_out(arguments, context, &mesh_file::all_formats(MeshFormat::Obj))?;
    let [left, right] = paths;
    let progress = context.progress(4);
    progress.step("reading the views");
    let pictures = views::read_pair(left, right)?;
    let size = [pictures[0].width(), pictures[0].height()];
    let file = arguments.chosen.read(rig_path)?;
    file.check_sizes(size, paths.map(PathBuf::as_path), rig_path)?;
    let rig = file.rig;
    progress.step("moving the left snake");
    let settle = |side: usize| {
        let (snake, least_area) = (&arguments.snake_arguments, arguments.least_area);
        let settled = snake.settle(&pictures[side], side == 1, least_area, &progress);
        settled.with_context(|| paths[side].display().to_string())
    };
    let left_snake = settle(0)?;
    progress.step("moving the right snake");
    let right_snake = settle(1)?;
    let warnings = [left_snake.warnings(left), right_snake.warnings(right)].concat();
    keep_for_failure(&warnings);
    progress.step("matching the contours");
    let options = SpaceCurveOptions::default();
    let found = space_curve(&rig, &left_snake.points, &right_snake.points, &options);
    let found = found.with_context(|| format!("{} and {}", left.display(), right.display()))?;
    let curve = found.moved(&arguments.axes.motor());
    let (mut circle, mut line) = (None, None);
    match arguments.fit {
        Some(Figure::Circle) => circle = Some(curve.nearest_circle()?),
        Some(Figure::Line) => line = Some(curve.nearest_line()?),
        None => {}
    }
    if let (Some(out), Some(format)) = (&arguments.out, format) {
        let files = mesh_file::files(out, format, &curve.to_mesh()?, &Options::default())?;
        context.outputs().write_all(&files)?;
    }
    Ok(Report {
        warnings,
        width_px: size[0],
        height_px: size[1],
        baseline_metres: rig.baseline(),
        left_snake,
        right_snake,
        measures: curve.measures(),
        circle,
        line,
        points: curve.points,
    })
}

impl Report {
    pub(super) fn text(&self) -> String {
        let measures = &self.measures;
        let mut text = format!(
            "left snake {}\nright snake {}\n\
             curve of {} points, {} of them bridged: length {:.5} m\n\
             gaps up to {:.2e} m, deviations {:.3} px (root mean square), up to {:.3} px\n",
            self.left_snake.text(),
            self.right_snake.text(),
            self.points.len(),
            measures.bridged,
            measures.length,
            measures.gap_max,
            measures.deviation_rms,
            measures.deviation_max
        );
        if let Some(circle) = &self.circle {
            let ([x, y, z], radius, rms) = (circle.centre, circle.radius, circle.rms);
            let _ = writeln!(
                text,
                "circle about ({x:.5}, {y:.5}, {z:.5}) m of radius {radius:.5} m, distances \
                 {rms:.2e} m"
            );
        }
        if let Some(line) = &self.line {
            let ([x, y, z], [a, b, c], rms) = (line.point, line.direction, line.rms);
            let _ = writeln!(
                text,
                "line through ({x:.5}, {y:.5}, {z:.5}) m along ({a:.5}, {b:.5}, {c:.5}), \
                 distances {rms:.2e} m"
            );
        }
        text
    }
}
