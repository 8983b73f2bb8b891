//! The closed curve in space that two views show.

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result};
use ga_camera::rig::StereoRig;
use ga_mesh::format::Options;
use ga_mesh::{Faces, Mesh, Polylines};
use ga_runtime::cga3::{self, Motor, Point};
use ga_vision::contour::space_curve::{
    SpaceCurve, SpaceCurveOptions, SpaceCurvePoint, space_curve,
};
use serde::Serialize;

use super::Arguments;
use super::arguments::{Figure, check_out};
use super::settling::Settled;
use crate::commands::stereo::views;
use crate::format::Format;
use crate::frame::{Context, Warning};
use crate::mesh_file;
use crate::output;

#[derive(Serialize)]
pub(crate) struct Report {
    #[serde(skip)]
    pub(super) warnings: Vec<Warning>,
    width_px: usize,
    height_px: usize,
    baseline_metres: f64,
    left_snake: Settled,
    right_snake: Settled,
    length_metres: f64,
    /// How many points lie on planes through their neighbours, where epipolar lines touch.
    bridged: usize,
    gap_mean_metres: f64,
    gap_max_metres: f64,
    deviation_rms_px: f64,
    deviation_max_px: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    circle: Option<Circle>,
    #[serde(skip_serializing_if = "Option::is_none")]
    line: Option<Line>,
    points: Vec<Place>,
}

#[derive(Serialize)]
struct Circle {
    centre_metres: [f64; 3],
    normal: [f64; 3],
    radius_metres: f64,
    /// The root mean square of the distances of the triangulated points.
    rms_metres: f64,
}

#[derive(Serialize)]
struct Line {
    /// The point nearest to the left camera.
    point_metres: [f64; 3],
    direction: [f64; 3],
    rms_metres: f64,
}

#[derive(Serialize)]
struct Place {
    position_metres: [f64; 3],
    left_px: [f64; 2],
    right_px: [f64; 2],
    gap_metres: f64,
    deviation_px: f64,
    bridged: bool,
}

pub(super) fn run(
    arguments: &Arguments,
    paths: [&PathBuf; 2],
    rig_path: &Path,
    context: &Context,
) -> Result<Report> {
    check_out(arguments, context, Format::Obj)?;
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
        let settings = &arguments.settings;
        let circle = settings.circle(side == 1)?;
        let settled = settings.settle(&pictures[side], circle, arguments.least_area, &progress);
        settled.with_context(|| paths[side].display().to_string())
    };
    let left_snake = settle(0)?;
    progress.step("moving the right snake");
    let right_snake = settle(1)?;
    progress.step("matching the contours");
    let options = SpaceCurveOptions::default();
    let found = space_curve(&rig, &left_snake.points, &right_snake.points, &options);
    let found = found.with_context(|| format!("{} and {}", left.display(), right.display()))?;
    let curve = moved(&found, &arguments.axes.motor());
    let snakes = [left_snake, right_snake];
    let warnings = paths.iter().zip(&snakes);
    let warnings = warnings.filter_map(|(path, snake)| snake.warning(path));
    let warnings = warnings.collect();
    let report = report(&curve, size, &rig, snakes, arguments.fit)?;
    if let Some(out) = &arguments.out {
        let files = mesh_file::files(out, Format::Obj, &mesh(&curve)?, &Options::default())?;
        output::write_together(files)?;
    }
    Ok(Report { warnings, ..report })
}

fn moved(curve: &SpaceCurve, motor: &Motor<f64>) -> SpaceCurve {
    let points = curve.points.iter().map(|point| SpaceCurvePoint {
        position: motor.transform(point.position),
        ..*point
    });
    SpaceCurve {
        points: points.collect(),
    }
}

/// The curve as a chain of edges that ends where it begins.
fn mesh(curve: &SpaceCurve) -> Result<Mesh> {
    let places: Vec<[f64; 3]> = curve
        .positions()
        .iter()
        .map(|position| position.coordinates())
        .collect();
    let count = u32::try_from(places.len())?;
    let chain: Vec<u32> = (0..count).chain([0]).collect();
    let mesh = Mesh::new(places, Faces::default())?;
    Ok(mesh.with_polylines(Polylines::from_lines([chain])?)?)
}

fn report(
    curve: &SpaceCurve,
    [width_px, height_px]: [usize; 2],
    rig: &StereoRig,
    [left_snake, right_snake]: [Settled; 2],
    figure: Option<Figure>,
) -> Result<Report> {
    let points = &curve.points;
    let count = points.len() as f64;
    let greatest =
        |value: fn(&SpaceCurvePoint) -> f64| points.iter().map(value).fold(0.0, f64::max);
    let squares = points.iter().map(|point| point.deviation.powi(2));
    let triangulated = curve.triangulated();
    Ok(Report {
        warnings: Vec::new(),
        width_px,
        height_px,
        baseline_metres: rig.baseline(),
        left_snake,
        right_snake,
        length_metres: curve.length(),
        bridged: points.iter().filter(|point| point.is_bridged).count(),
        gap_mean_metres: points.iter().map(|point| point.gap).sum::<f64>() / count,
        gap_max_metres: greatest(|point| point.gap),
        deviation_rms_px: (squares.sum::<f64>() / count).sqrt(),
        deviation_max_px: greatest(|point| point.deviation),
        circle: match figure {
            Some(Figure::Circle) => Some(fitted_circle(&triangulated)?),
            _ => None,
        },
        line: match figure {
            Some(Figure::Line) => Some(fitted_line(&triangulated)?),
            _ => None,
        },
        points: points.iter().map(place).collect(),
    })
}

fn place(point: &SpaceCurvePoint) -> Place {
    Place {
        position_metres: point.position.coordinates(),
        left_px: point.left,
        right_px: point.right,
        gap_metres: point.gap,
        deviation_px: point.deviation,
        bridged: point.is_bridged,
    }
}

fn fitted_circle(points: &[Point<f64>]) -> Result<Circle> {
    let fit = cga3::Circle::fit(points).context("the circle through the curve")?;
    let [_, _, normal] = fit.axes();
    Ok(Circle {
        centre_metres: fit.origin().coordinates(),
        normal,
        radius_metres: fit.radius(),
        rms_metres: fit.rms(),
    })
}

fn fitted_line(points: &[Point<f64>]) -> Result<Line> {
    let fit = cga3::Line::fit(points).context("the line through the curve")?;
    let line = fit.primitive;
    let (nearest, direction) = line
        .support()
        .zip(line.unit_direction())
        .context("the line through the curve is beyond the range of numbers")?;
    Ok(Line {
        point_metres: nearest.coordinates(),
        direction,
        rms_metres: fit.rms(),
    })
}

impl Report {
    pub(super) fn text(&self) -> String {
        let mut text = format!(
            "left snake {}\nright snake {}\n\
             curve of {} points, {} of them bridged: length {:.5} m\n\
             gaps up to {:.2e} m, deviations {:.3} px (root mean square), up to {:.3} px\n",
            self.left_snake.text(),
            self.right_snake.text(),
            self.points.len(),
            self.bridged,
            self.length_metres,
            self.gap_max_metres,
            self.deviation_rms_px,
            self.deviation_max_px
        );
        if let Some(circle) = &self.circle {
            let [x, y, z] = circle.centre_metres;
            text += &format!(
                "circle about ({x:.5}, {y:.5}, {z:.5}) m of radius {:.5} m, distances {:.2e} m\n",
                circle.radius_metres, circle.rms_metres
            );
        }
        if let Some(line) = &self.line {
            let [[x, y, z], [a, b, c]] = [line.point_metres, line.direction];
            text += &format!(
                "line through ({x:.5}, {y:.5}, {z:.5}) m along ({a:.5}, {b:.5}, {c:.5}), \
                 distances {:.2e} m\n",
                line.rms_metres
            );
        }
        text
    }
}
