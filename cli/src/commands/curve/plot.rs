//! Curves over time as an SVG picture.

use anyhow::{Result, ensure};
use ga_anim::curve::table::KeyTable;
use ga_anim::curve::{Curve, Distance, Outside};
use plotters::coord::Shift;
use plotters::prelude::*;

use super::Rows;
use crate::chart::{COLOURS, FINE, shown_small};

/// The size of the picture as it is shown.
const SIZE: (u32, u32) = (1000, 560);
/// The width of the strip with the names of the channels.
const NAMES: u32 = 180;
/// So many names fit into it.
const MOST_NAMES: usize = 20;
/// More vertices of a polyline than this would hide the curve.
const MOST_MARKS: usize = 400;
type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// A picture of curves with their keys as dots, and the vertices of a polyline as small rings.
pub(super) fn svg(
    title: &str,
    table: &KeyTable,
    curves: &[Curve<f64>],
    rows: &Rows,
) -> Result<String> {
    let is_polyline = rows.max_deviation.is_some() && rows.times.len() <= MOST_MARKS;
    let marks = is_polyline.then_some(rows);
    let lines: Vec<Vec<(f64, f64)>> = curves.iter().map(line).collect();
    let ys = lines.iter().flatten().map(|&(_, y)| y);
    let [low, high] = padded(
        ys.clone().fold(f64::INFINITY, f64::min),
        ys.fold(f64::NEG_INFINITY, f64::max),
        0.05,
    );
    let [start, end] = padded(curves[0].start(), curves[0].end(), 0.02);
    ensure!(
        [low, high, start, end, high - low, end - start]
            .iter()
            .all(|x| x.is_finite()),
        "the numbers are too large for a picture"
    );

    let mut text = String::new();
    {
        let root = SVGBackend::with_string(&mut text, (SIZE.0 * FINE, SIZE.1 * FINE));
        let root = root.into_drawing_area();
        root.fill(&WHITE)?;
        let (left, right) = root.split_horizontally((SIZE.0 - NAMES) * FINE);
        let mut chart = ChartBuilder::on(&left)
            .caption(title, ("sans-serif", 18 * FINE))
            .margin(14 * FINE)
            .x_label_area_size(46 * FINE)
            .y_label_area_size(76 * FINE)
            .build_cartesian_2d(start..end, low..high)?;
        let value = if curves.len() == 1 {
            &table.names[1]
        } else {
            "value"
        };
        chart
            .configure_mesh()
            .x_desc(&table.names[0])
            .y_desc(value)
            .axis_desc_style(("sans-serif", 16 * FINE))
            .label_style(("sans-serif", 13 * FINE))
            .light_line_style(WHITE)
            .bold_line_style(RGBColor(225, 225, 225).stroke_width(FINE))
            .axis_style(BLACK.stroke_width(FINE))
            .set_all_tick_mark_size(5 * FINE)
            .draw()?;
        for (channel, line) in lines.iter().enumerate() {
            let colour = colour(channel);
            chart.draw_series(LineSeries::new(
                line.iter().copied(),
                colour.stroke_width(2 * FINE),
            ))?;
            if let Some(marks) = marks {
                let places = marks.times.iter().zip(&marks.values);
                let ring = |(&t, values): (&f64, &Vec<f64>)| {
                    Circle::new((t, values[channel]), 3 * FINE, colour.stroke_width(FINE))
                };
                chart.draw_series(places.map(ring))?;
            }
            let keys = table
                .times
                .iter()
                .copied()
                .zip(table.channels[channel].iter().copied());
            chart.draw_series(keys.map(|key| Circle::new(key, 5 * FINE, colour.filled())))?;
        }
        name_channels(&right, &table.names[1..], is_polyline)?;
        root.present()?;
    }
    Ok(shown_small(&text, SIZE))
}

/// The names of the channels beside samples of their lines, and what the marks are.
fn name_channels(area: &Area<'_>, names: &[String], with_rings: bool) -> Result<()> {
    let style = ("sans-serif", 14 * FINE).into_font();
    let unit = FINE as i32;
    let mut y = 60 * unit;
    let mut say = |mark: &dyn Fn(i32) -> Result<()>, text: &str| -> Result<()> {
        mark(y)?;
        area.draw(&Text::new(
            shortened(text),
            (40 * unit, y - 7 * unit),
            style.clone(),
        ))?;
        y += 22 * unit;
        Ok(())
    };
    for (channel, name) in names.iter().take(MOST_NAMES).enumerate() {
        let line = |y: i32| -> Result<()> {
            let ends = vec![(4 * unit, y), (32 * unit, y)];
            Ok(area.draw(&PathElement::new(
                ends,
                colour(channel).stroke_width(3 * FINE),
            ))?)
        };
        say(&line, name)?;
    }
    if names.len() > MOST_NAMES {
        say(
            &|_| Ok(()),
            &format!("and {} more", names.len() - MOST_NAMES),
        )?;
    }
    let dot = |y: i32| -> Result<()> {
        Ok(area.draw(&Circle::new((18 * unit, y), 5 * FINE, BLACK.filled()))?)
    };
    say(&dot, "key")?;
    if with_rings {
        let ring = |y: i32| -> Result<()> {
            Ok(area.draw(&Circle::new(
                (18 * unit, y),
                3 * FINE,
                BLACK.stroke_width(FINE),
            ))?)
        };
        say(&ring, "vertex")?;
    }
    Ok(())
}

fn colour(channel: usize) -> RGBColor {
    COLOURS[channel % COLOURS.len()]
}

/// A name that fits beside the chart.
fn shortened(name: &str) -> String {
    const MOST: usize = 18;
    if name.chars().count() <= MOST {
        return name.to_string();
    }
    name.chars()
        .take(MOST - 1)
        .chain(std::iter::once('…'))
        .collect()
}

/// Points of a curve that look like the curve: within a tenth of a pixel of it where that can be
/// had with few points.
fn line(curve: &Curve<f64>) -> Vec<(f64, f64)> {
    const MOST: usize = 20_000;
    let values = curve.pieces().iter().map(|piece| piece[0]);
    let [low, high] = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], y| {
        [low.min(y), high.max(y)]
    });
    let tolerance = (high - low) / (10.0 * f64::from(SIZE.1));
    let points = curve.resampled_within(tolerance, Distance::EqualTime, MOST);
    if let Ok(points) = points {
        return points.times.into_iter().zip(points.values).collect();
    }
    let held = curve.clone().with_outside(Outside::Hold);
    let (start, end) = (curve.start(), curve.end());
    let steps = 2000;
    let times = (0..=steps).map(|step| start + (end - start) * f64::from(step) / f64::from(steps));
    times.map(|time| (time, held.value(time))).collect()
}

/// A range with a margin, and not so narrow that numbers on its axis could not be told apart.
fn padded(low: f64, high: f64, share: f64) -> [f64; 2] {
    let size = low.abs().max(high.abs());
    let least = if size > 0.0 { 1e-6 * size } else { 1.0 };
    let margin = (share * (high - low)).max(least);
    [low - margin, high + margin]
}
