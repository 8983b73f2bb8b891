//! The contours of one picture.

use std::fmt::Write as _;
use std::path::Path;

use anyhow::{Context as _, Result};
use ga_image::grey::Luma;
use ga_image::plane::Plane;
use ga_image::{file, threshold};
use ga_runtime::cga2::{self, Point};
use ga_vision::contour::{Contour, ContourError, borders, fit, perimeter, signed_area};
use serde::Serialize;

use super::arguments::check_out;
use super::settling::Settled;
use super::{Arguments, drawing};
use crate::format::Format;
use crate::frame::{Context, Progress, Warning};
use crate::output;

#[derive(Serialize)]
pub(crate) struct Report {
    #[serde(skip)]
    pub(super) warnings: Vec<Warning>,
    width_px: usize,
    height_px: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    threshold: Option<u8>,
    #[serde(skip_serializing_if = "Option::is_none")]
    snake: Option<Settled>,
    contours: Vec<Curve>,
}

#[derive(Serialize)]
struct Curve {
    hole: bool,
    parent: Option<usize>,
    area_px2: f64,
    perimeter_px: f64,
    /// The circle and the ellipse nearest to the points, where these determine them.
    circle: Option<Circle>,
    ellipse: Option<Ellipse>,
    points_px: Vec<[f64; 2]>,
}

#[derive(Serialize)]
struct Circle {
    centre_px: [f64; 2],
    radius_px: f64,
}

#[derive(Serialize)]
struct Ellipse {
    centre_px: [f64; 2],
    semi_axes_px: [f64; 2],
    angle_rad: f64,
}

pub(super) fn run(arguments: &Arguments, image: &Path, context: &Context) -> Result<Report> {
    let Arguments { out, .. } = arguments;
    check_out(arguments, context, Format::Svg)?;
    let progress = context.progress(1);
    progress.step("finding the contours");
    let colours: Plane<[u8; 3]> = file::read(image)?.to_rgb();
    let picture: Plane<u8> = Luma::Bt601.plane(&colours);
    let named = || image.display().to_string();
    let report = if arguments.snake {
        settled(&picture, image, arguments, &progress).with_context(named)?
    } else {
        regions(&picture, arguments).with_context(named)?
    };
    if let Some(out) = out {
        let curves = report.contours.iter();
        let drawn = curves.map(|curve| (&curve.points_px[..], curve.hole));
        output::write(out, drawing::svg(&colours, drawn)?.as_bytes())?;
    }
    Ok(report)
}

/// The borders of regions above a threshold.
fn regions(picture: &Plane<u8>, arguments: &Arguments) -> Result<Report> {
    let given = arguments.threshold.or_else(|| threshold::otsu(picture));
    let level = given.ok_or(ContourError::OneLevel)?;
    let all = borders(&threshold::above(picture, level));
    let is_kept: Vec<bool> = all
        .iter()
        .map(|c| c.area() >= arguments.least_area)
        .collect();
    // A parent that is left out is replaced by its own.
    let parent = |contour: &Contour| {
        let mut parent = contour.parent;
        while let Some(index) = parent.filter(|index| !is_kept[*index]) {
            parent = all[index].parent;
        }
        parent.map(|index| is_kept[..index].iter().filter(|kept| **kept).count())
    };
    let kept = all.iter().zip(&is_kept).filter(|(_, kept)| **kept);
    let contours: Vec<Curve> = kept
        .map(|(contour, _)| curve(contour.points(), contour.is_hole, parent(contour)))
        .collect();
    if contours.is_empty() {
        let least_area = arguments.least_area;
        return Err(ContourError::NoBorder { least_area }.into());
    }
    Ok(Report {
        width_px: picture.width(),
        height_px: picture.height(),
        threshold: Some(level),
        snake: None,
        contours,
        warnings: Vec::new(),
    })
}

/// The snake.
fn settled(
    picture: &Plane<u8>,
    image: &Path,
    arguments: &Arguments,
    progress: &Progress,
) -> Result<Report> {
    progress.step("moving the snake");
    let settings = &arguments.settings;
    let circle = settings.circle(false)?;
    let settled = settings.settle(picture, circle, arguments.least_area, progress)?;
    Ok(Report {
        width_px: picture.width(),
        height_px: picture.height(),
        threshold: None,
        contours: vec![curve(settled.points.clone(), false, None)],
        warnings: settled.warning(image).into_iter().collect(),
        snake: Some(settled),
    })
}

fn curve(points_px: Vec<[f64; 2]>, hole: bool, parent: Option<usize>) -> Curve {
    let places: Vec<_> = points_px.iter().copied().map(Point::from).collect();
    let circle = cga2::Circle::fit(&places).ok().map(|fit| {
        let [u, v, _] = fit.origin().coordinates();
        Circle {
            centre_px: [u, v],
            radius_px: fit.radius(),
        }
    });
    let ellipse = fit::ellipse(&points_px).ok().map(|ellipse| Ellipse {
        centre_px: ellipse.centre,
        semi_axes_px: ellipse.semi_axes,
        angle_rad: ellipse.angle,
    });
    Curve {
        hole,
        parent,
        area_px2: signed_area(&points_px).abs(),
        perimeter_px: perimeter(&points_px),
        circle,
        ellipse,
        points_px,
    }
}

impl Report {
    pub(super) fn text(&self) -> String {
        let report = self;
        let mut text = String::new();
        if let Some(level) = report.threshold {
            let _ = writeln!(text, "threshold {level}");
        }
        if let Some(snake) = &report.snake {
            let _ = writeln!(text, "snake {}", snake.text());
        }
        for (index, curve) in report.contours.iter().enumerate() {
            let kind = match (&report.snake, curve.hole) {
                (Some(_), _) => "snake",
                (None, false) => "region",
                (None, true) => "hole",
            };
            let _ = write!(
                text,
                "contour {index}: {kind}, area {:.1} px², perimeter {:.1} px",
                curve.area_px2, curve.perimeter_px
            );
            match curve.parent {
                Some(parent) => {
                    let _ = writeln!(text, ", in contour {parent}");
                }
                None => text.push('\n'),
            }
        }
        text
    }
}
