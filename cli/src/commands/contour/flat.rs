//! The contours of one picture.

use std::fmt::Write as _;
use std::path::Path;

use anyhow::{Context as _, Result};
use ga_draw::document::{Outline, overlay};
use ga_image::grey::Luma;
use ga_image::picture::Picture;
use ga_image::plane::Plane;
use ga_image::png;
use ga_vision::contour::{MeasuredContour, Regions};
use serde::Serialize;

use super::Arguments;
use super::arguments::check_out;
use super::settling::Settled;
use crate::format::Format;
use crate::frame::{Context, Warning};
use crate::picture_file;

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
    contours: Vec<MeasuredContour>,
}

pub(super) fn run(arguments: &Arguments, image: &Path, context: &Context) -> Result<Report> {
    check_out(arguments, context, &[Format::Svg])?;
    let progress = context.progress(1);
    progress.step("finding the contours");
    let [read] = Picture::spread([picture_file::read(image)?]);
    let colours: Plane<[u8; 3]> = read.to_rgb();
    let picture: Plane<u8> = Luma::Bt601.plane(&colours);
    let size = [picture.width(), picture.height()];
    let least_area = arguments.least_area;
    let named = || image.display().to_string();
    let mut report = Report {
        width_px: size[0],
        height_px: size[1],
        threshold: None,
        snake: None,
        contours: Vec::new(),
        warnings: Vec::new(),
    };
    if arguments.snake {
        progress.step("moving the snake");
        let snake = &arguments.snake_arguments;
        let settled = snake.settle(&picture, false, least_area, &progress);
        let settled = settled.with_context(named)?;
        let points = settled.points.clone();
        report.contours = vec![MeasuredContour::of_snake(points, size)];
        report.warnings = settled.warnings(image);
        report.snake = Some(settled);
    } else {
        let regions = Regions::find(&picture, arguments.threshold, least_area);
        let regions = regions.with_context(named)?;
        report.threshold = Some(regions.threshold);
        let contours = regions.contours.iter();
        let measured =
            contours.map(|c| MeasuredContour::new(c.points(), c.is_hole, c.parent, size));
        report.contours = measured.collect();
    }
    if let Some(out) = &arguments.out {
        let outlines = report.contours.iter().map(|curve| Outline {
            points: &curve.points,
            colour: match curve.is_hole {
                true => "#2f7fd0",
                false => "#e8631a",
            },
        });
        let svg = overlay(&png::encode(&colours)?, size, outlines);
        context.outputs().write(out, svg)?;
    }
    Ok(report)
}

impl Report {
    pub(super) fn text(&self) -> String {
        let mut text = String::new();
        if let Some(level) = self.threshold {
            let _ = writeln!(text, "threshold {level}");
        }
        if let Some(snake) = &self.snake {
            let _ = writeln!(text, "snake {}", snake.text());
        }
        for (index, curve) in self.contours.iter().enumerate() {
            let kind = match (&self.snake, curve.is_hole) {
                (Some(_), _) => "snake",
                (None, false) => "region",
                (None, true) => "hole",
            };
            let _ = write!(
                text,
                "contour {index}: {kind}, area {:.1} px², perimeter {:.1} px",
                curve.area, curve.perimeter
            );
            if let Some(parent) = curve.parent {
                let _ = write!(text, ", in contour {parent}");
            }
            if curve.at_border > 0 {
                let (cut, count) = (curve.at_border, curve.points.len());
                let _ = write!(
                    text,
                    ", cut by the border of the picture at {cut} of {count} points"
                );
            }
            text.push('\n');
        }
        text
    }
}
