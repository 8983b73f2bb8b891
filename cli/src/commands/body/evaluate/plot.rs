//! The errors and times as a picture, in the shape of Cui's figs 9 and 10.

use std::path::Path;

use anyhow::Result;
use plotters::coord::Shift;
use plotters::prelude::*;

use super::rows::{Method, Row};
use crate::chart::{COLOURS, FINE, shown_small};

/// The size of the bars above, and of the curves below them.
const BARS: (u32, u32) = (520, 22);
const CURVES: (u32, u32) = (1040, 420);
/// Heights of the captions, and the widths of names beside bars and of the legend.
const CAPTION: u32 = 66;
const NAMES: u32 = 150;
const LEGEND: u32 = 210;
/// The noise of the bars in pixels, or the nearest there is.
const NOISE: f64 = 2.0;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Bars with the 2-D joint errors and the times of all methods at one noise, and below them the
/// mean per joint position errors over the noise.
pub(super) fn svg(rows: &[Row], motion: &Path) -> Result<String> {
    let least_missing = rows.iter().map(|row| row.missing).fold(1.0, f64::min);
    let rows: Vec<&Row> = rows
        .iter()
        .filter(|row| row.missing == least_missing)
        .collect();
    let noises = rows.iter().map(|row| row.noise_px);
    let noise = noises.min_by(|a, b| (a - NOISE).abs().total_cmp(&(b - NOISE).abs()));
    let noise = noise.unwrap_or(NOISE);
    let at_noise: Vec<&Row> = rows
        .iter()
        .copied()
        .filter(|row| row.noise_px == noise)
        .collect();

    let bars = CAPTION + BARS.1 * at_noise.len() as u32 + 16;
    let size = (CURVES.0, bars + CURVES.1);
    let name = motion
        .file_name()
        .unwrap_or(motion.as_os_str())
        .to_string_lossy();
    let missing = match least_missing {
        0.0 => String::new(),
        missing => format!(", {} % of the joints missing", 100.0 * missing),
    };
    let under = format!("{name}, {noise} px of noise{missing}; not Human3.6M");
    let mut text = String::new();
    {
        let root = SVGBackend::with_string(&mut text, (size.0 * FINE, size.1 * FINE));
        let root = root.into_drawing_area();
        root.fill(&WHITE)?;
        let (above, below) = root.split_vertically(bars * FINE);
        let (left, right) = above.split_horizontally(BARS.0 * FINE);
        draw_bars(
            &left,
            "2-D joint error in pixels",
            &under,
            &at_noise,
            |row| row.joint_error_px,
        )?;
        draw_bars(
            &right,
            "Time in milliseconds a frame",
            &under,
            &at_noise,
            |row| row.milliseconds_per_frame,
        )?;
        draw_curves(&below, &format!("{name}{missing}"), &rows)?;
        root.present()?;
    }
    Ok(shown_small(&text, size))
}

fn views(row: &Row) -> String {
    match row.views {
        1 => "1 view".to_owned(),
        views => format!("{views} views"),
    }
}

fn colour(method: Method) -> RGBColor {
    COLOURS[Method::ALL
        .iter()
        .position(|other| *other == method)
        .unwrap_or(0)]
}

fn fine(pixels: u32) -> i32 {
    (pixels * FINE) as i32
}

/// A bar for each row, with its name on the left and its value on the right.
fn draw_bars(
    area: &Area<'_>,
    title: &str,
    under: &str,
    rows: &[&Row],
    value: impl Fn(&Row) -> f64,
) -> Result<()> {
    let most = rows
        .iter()
        .map(|row| value(row))
        .fold(f64::MIN_POSITIVE, f64::max);
    let font = |size: u32| ("sans-serif", size * FINE).into_font();
    area.draw(&Text::new(title.to_owned(), (fine(16), fine(14)), font(18)))?;
    area.draw(&Text::new(under.to_owned(), (fine(16), fine(38)), font(12)))?;
    let room = f64::from((BARS.0 - NAMES - 90) * FINE);
    for (index, row) in rows.iter().enumerate() {
        let top = fine(CAPTION + BARS.1 * index as u32);
        let name = format!("{}, {}", row.method.name(), views(row));
        area.draw(&Text::new(name, (fine(16), top + fine(3)), font(13)))?;
        let left = fine(NAMES + 10);
        let right = left + (room * value(row) / most).round() as i32;
        area.draw(&Rectangle::new(
            [(left, top), (right.max(left + 1), top + fine(BARS.1 - 5))],
            colour(row.method).filled(),
        ))?;
        let number = format!("{:.2}", value(row));
        area.draw(&Text::new(
            number,
            (right + fine(6), top + fine(3)),
            font(13),
        ))?;
    }
    Ok(())
}

/// The rows of a method with a number of views, as a line over the noise.
struct Line<'a> {
    method: Method,
    views: usize,
    rows: Vec<&'a Row>,
}

fn lines<'a>(rows: &[&'a Row]) -> Vec<Line<'a>> {
    let mut lines: Vec<Line<'a>> = Vec::new();
    for row in rows {
        let same = |line: &&mut Line| line.method == row.method && line.views == row.views;
        match lines.iter_mut().find(same) {
            Some(line) => line.rows.push(row),
            None => lines.push(Line {
                method: row.method,
                views: row.views,
                rows: vec![row],
            }),
        }
    }
    for line in &mut lines {
        line.rows.sort_by(|a, b| a.noise_px.total_cmp(&b.noise_px));
    }
    lines
}

/// Errors over the noise; numbers of views are told apart by marks.
fn draw_curves(area: &Area<'_>, under: &str, rows: &[&Row]) -> Result<()> {
    let (left, right) = area.split_horizontally((CURVES.0 - LEGEND) * FINE);
    let most = |value: fn(&Row) -> f64| rows.iter().map(|row| value(row)).fold(0.0, f64::max);
    let noise = most(|row| row.noise_px).max(1.0);
    let error = most(|row| row.mpjpe_mm).max(1e-3);
    let mut chart = ChartBuilder::on(&left)
        .caption(
            format!("Mean per joint position error over the noise: {under}"),
            ("sans-serif", 16 * FINE),
        )
        .margin(14 * FINE)
        .x_label_area_size(44 * FINE)
        .y_label_area_size(64 * FINE)
        .build_cartesian_2d(0.0..1.03 * noise, 0.0..1.06 * error)?;
    chart
        .configure_mesh()
        .x_desc("standard deviation of the noise (px)")
        .y_desc("MPJPE (mm)")
        .axis_desc_style(("sans-serif", 14 * FINE))
        .label_style(("sans-serif", 13 * FINE))
        .light_line_style(WHITE)
        .bold_line_style(RGBColor(225, 225, 225).stroke_width(FINE))
        .axis_style(BLACK.stroke_width(FINE))
        .set_all_tick_mark_size(5 * FINE)
        .draw()?;
    let lines = lines(rows);
    let mut views: Vec<usize> = lines.iter().map(|line| line.views).collect();
    views.sort_unstable();
    views.dedup();
    let font = || ("sans-serif", 13 * FINE).into_font();
    for (index, line) in lines.iter().enumerate() {
        let shape = views
            .iter()
            .position(|views| *views == line.views)
            .unwrap_or(0);
        let colour = colour(line.method);
        let points = line.rows.iter().map(|row| (row.noise_px, row.mpjpe_mm));
        chart.draw_series(LineSeries::new(
            points.clone(),
            colour.stroke_width(2 * FINE),
        ))?;
        chart.draw_series(points.map(|point| EmptyElement::at(point) + mark(shape, colour)))?;
        let y = fine(60) + fine(24) * index as i32;
        let ends = vec![(fine(4), y), (fine(36), y)];
        right.draw(&PathElement::new(ends, colour.stroke_width(2 * FINE)))?;
        right.draw(&(EmptyElement::at((fine(20), y)) + mark(shape, colour)))?;
        let name = format!("{}, {}", line.method.name(), self::views(line.rows[0]));
        right.draw(&Text::new(name, (fine(46), y - fine(7)), font()))?;
    }
    Ok(())
}

/// A triangle, a square, and polygons of more corners.
fn mark(shape: usize, colour: RGBColor) -> Polygon<(i32, i32)> {
    let corners = 3 + shape;
    let radius = f64::from(6 * FINE);
    let turn = if shape == 1 {
        0.25 * std::f64::consts::PI
    } else {
        0.0
    };
    let corner = |index: usize| {
        let angle = std::f64::consts::TAU * index as f64 / corners as f64 + turn;
        let (sin, cos) = angle.sin_cos();
        (
            (radius * sin).round() as i32,
            (-radius * cos).round() as i32,
        )
    };
    Polygon::new(
        (0..corners).map(corner).collect::<Vec<_>>(),
        colour.filled(),
    )
}
