//! The measures over time as an SVG picture: decibels above, indices below.

use ga_draw::document::chart::{self, Area, COLOURS, ChartError, FINE, Mark, draw_legend, font};
use plotters::prelude::*;

use super::measure::{MEASURES, Measure, Part, Scale};
use super::video::FrameQuality;

/// The size of the picture as it is shown, and the width of the legend.
const SIZE: (u32, u32) = (1000, 640);
const LEGEND: u32 = 150;
const TITLE: u32 = 40;

/// The value of a measure at a frame where it is finite.
fn finite(measure: &Measure, frame: &FrameQuality) -> Option<f64> {
    (measure.value)(frame).filter(|value| value.is_finite())
}

/// A chart of the measures over time as SVG: decibels above, indices below. Lines are interrupted
/// at frames whose luma is identical. `name` is that of the video.
///
/// # Errors
///
/// Those of the drawing.
pub fn svg(frames: &[FrameQuality], name: &str) -> Result<String, ChartError> {
    let title = format!("Quality of {name} over time");
    chart::svg(SIZE, |area| {
        area.draw(&Text::new(title, (fine(16), fine(14)), font(18)))?;
        let (_, charts) = area.split_vertically(TITLE * FINE);
        let (above, below) = charts.split_vertically((SIZE.1 - TITLE) / 2 * FINE);
        draw(&above, "decibels", Scale::Decibels, frames)?;
        draw(&below, "index", Scale::Index, frames)
    })
}

/// The measures of luma on a scale.
fn draw(
    area: &Area<'_>,
    unit: &str,
    scale: Scale,
    frames: &[FrameQuality],
) -> Result<(), ChartError> {
    let measures: Vec<Measure> = MEASURES
        .into_iter()
        .filter(|measure| measure.part == Part::Luma && measure.scale == scale)
        .collect();
    let (left, right) = area.split_horizontally((SIZE.0 - LEGEND) * FINE);
    let values = measures
        .iter()
        .flat_map(|measure| frames.iter().filter_map(|frame| finite(measure, frame)));
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (low.min(value), high.max(value))
    });
    // Without a difference in any frame, a line is not drawn and needs no room.
    let (low, high) = if low <= high { (low, high) } else { (0.0, 1.0) };
    let margin = (0.06 * (high - low)).max(1e-3 * high.abs()).max(1e-6);
    let first = frames.first().map_or(0.0, |frame| frame.time_seconds);
    let last = frames.last().map_or(1.0, |frame| frame.time_seconds);
    let last = if last > first { last } else { first + 1.0 };
    let mut chart = ChartBuilder::on(&left)
        .margin(10 * FINE)
        .x_label_area_size(44 * FINE)
        .y_label_area_size(70 * FINE)
        .build_cartesian_2d(first..last, low - margin..high + margin)?;
    chart
        .configure_mesh()
        .x_desc("time (s)")
        .y_desc(unit)
        .axis_desc_style(("sans-serif", 14 * FINE))
        .label_style(("sans-serif", 13 * FINE))
        .light_line_style(WHITE)
        .bold_line_style(RGBColor(225, 225, 225).stroke_width(FINE))
        .axis_style(BLACK.stroke_width(FINE))
        .set_all_tick_mark_size(5 * FINE)
        .draw()?;
    let mut legend = Vec::new();
    for (measure, colour) in measures.iter().zip(COLOURS) {
        let value = |frame: &FrameQuality| finite(measure, frame);
        if !frames.iter().any(|frame| value(frame).is_some()) {
            continue;
        }
        for run in frames.chunk_by(|a, b| value(a).is_some() && value(b).is_some()) {
            let points: Vec<(f64, f64)> = run
                .iter()
                .filter_map(|frame| Some((frame.time_seconds, value(frame)?)))
                .collect();
            match points[..] {
                [] => {}
                [point] => {
                    let dot = Circle::new(point, 2 * FINE, colour.filled());
                    chart.draw_series(std::iter::once(dot))?;
                }
                _ => {
                    let style = colour.stroke_width(2 * FINE);
                    chart.draw_series(LineSeries::new(points, style))?;
                }
            }
        }
        legend.push((Mark::Line, colour, measure.name.to_owned()));
    }
    draw_legend(&right, &legend)
}

fn fine(pixels: u32) -> i32 {
    (pixels * FINE).cast_signed()
}
