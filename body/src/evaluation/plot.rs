//! The errors and times as a picture, in the shape of Cui's figs 9 and 10.

use ga_draw::document::chart::{self, Area, COLOURS, ChartError, FINE, font};
use plotters::prelude::*;

use super::case::Case;
use super::evaluated::Evaluation;
use super::rows::{Method, Row};

/// The size of the bars above, and the width of all charts below them with the height of each.
const BARS: (u32, u32) = (520, 22);
const CURVES: (u32, u32) = (1040, 330);
/// The most charts beside each other.
const COLUMNS: usize = 3;
/// Names in a row of the legend, and the height of a row.
const LEGEND_COLUMNS: u32 = 3;
const LEGEND_ROW: u32 = 22;
/// The height of the captions, and the width of names beside bars.
const CAPTION: u32 = 66;
const NAMES: u32 = 150;
/// The noise of the bars in pixels, or the nearest there is.
const NOISE: f64 = 2.0;

impl Evaluation {
    /// A picture as SVG: bars with the 2-D joint errors and the times of all methods at one noise
    /// and with the fewest joints missing, and below them the mean per joint position errors over
    /// the noise. `name` is that of the motion.
    ///
    /// # Errors
    /// [`ChartError`].
    pub fn plot(&self, name: &str) -> Result<String, ChartError> {
        let rows: Vec<&Row> = self.rows.iter().collect();
        let least_missing = rows.iter().map(|row| row.case.missing).fold(1.0, f64::min);
        let noises = rows.iter().map(|row| row.case.noise_px);
        let noise = noises.min_by(|a, b| (a - NOISE).abs().total_cmp(&(b - NOISE).abs()));
        let noise = noise.unwrap_or(NOISE);
        let in_bars = |row: &&Row| row.case.missing == least_missing && row.case.noise_px == noise;
        let in_bars: Vec<&Row> = rows.iter().copied().filter(in_bars).collect();

        let bars = CAPTION + BARS.1 * in_bars.len() as u32 + 16;
        let charts = views_of(&rows).len().div_ceil(COLUMNS) as u32;
        let curves = CAPTION + legend_height(&rows) + CURVES.1 * charts;
        let missing = Case::missing_in_words(least_missing);
        let under = format!("{name}, {noise} px of noise{missing}; not Human3.6M");
        chart::svg((CURVES.0, bars + curves), |root| {
            let (above, below) = root.split_vertically(bars * FINE);
            let (left, right) = above.split_horizontally(BARS.0 * FINE);
            let errors = |row: &Row| row.joint_error_px;
            draw_bars(&left, "2-D joint error in pixels", &under, &in_bars, errors)?;
            let times = |row: &Row| row.milliseconds_per_frame;
            draw_bars(
                &right,
                "Time in milliseconds a frame",
                &under,
                &in_bars,
                times,
            )?;
            draw_curves(&below, &format!("{name}; not Human3.6M"), &rows)
        })
    }
}

fn number(method: Method) -> usize {
    let mut all = Method::ALL.iter();
    all.position(|other| *other == method).unwrap_or(0)
}

fn colour(method: Method) -> RGBColor {
    COLOURS[number(method)]
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
) -> Result<(), ChartError> {
    let most = rows
        .iter()
        .map(|row| value(row))
        .fold(f64::MIN_POSITIVE, f64::max);
    area.draw(&Text::new(title.to_owned(), (fine(16), fine(14)), font(18)))?;
    area.draw(&Text::new(under.to_owned(), (fine(16), fine(38)), font(12)))?;
    let room = f64::from((BARS.0 - NAMES - 90) * FINE);
    for (index, row) in rows.iter().enumerate() {
        let top = fine(CAPTION + BARS.1 * index as u32);
        let name = format!(
            "{}, {}",
            row.method.name(),
            Case::counted_views(row.case.views)
        );
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

/// The rows of a method with one part of the joints missing, as a line over the noise.
struct Line<'a> {
    method: Method,
    missing: f64,
    rows: Vec<&'a Row>,
}

impl Line<'_> {
    fn name(&self) -> String {
        self.method.name().to_owned() + &Case::missing_in_words(self.missing)
    }
}

fn lines<'a>(rows: &[&'a Row]) -> Vec<Line<'a>> {
    let mut lines: Vec<Line<'a>> = Vec::new();
    for row in rows {
        let same = |line: &&mut Line| line.method == row.method && line.missing == row.case.missing;
        match lines.iter_mut().find(same) {
            Some(line) => line.rows.push(row),
            None => lines.push(Line {
                method: row.method,
                missing: row.case.missing,
                rows: vec![row],
            }),
        }
    }
    for line in &mut lines {
        line.rows
            .sort_by(|a, b| a.case.noise_px.total_cmp(&b.case.noise_px));
    }
    lines.sort_by(|a, b| {
        let by_missing = a.missing.total_cmp(&b.missing);
        by_missing.then(number(a.method).cmp(&number(b.method)))
    });
    lines
}

/// Errors over the noise, in a chart of its own scale for each number of views; parts of the joints
/// that are missing are told apart by marks.
fn draw_curves(area: &Area<'_>, under: &str, rows: &[&Row]) -> Result<(), ChartError> {
    let title = "Mean per joint position error over the noise";
    area.draw(&Text::new(title, (fine(16), fine(14)), font(18)))?;
    area.draw(&Text::new(under.to_owned(), (fine(16), fine(38)), font(12)))?;
    let lines = lines(rows);
    let missing = sorted(rows.iter().map(|row| row.case.missing));
    let shape = |line: &Line| missing.iter().position(|m| *m == line.missing).unwrap_or(0);
    for (index, line) in lines.iter().enumerate() {
        let (column, row) = (index as u32 % LEGEND_COLUMNS, index as u32 / LEGEND_COLUMNS);
        let (x, y) = (
            16 + column * CURVES.0 / LEGEND_COLUMNS,
            68 + LEGEND_ROW * row,
        );
        let colour = colour(line.method);
        let ends = vec![(fine(x), fine(y)), (fine(x + 32), fine(y))];
        area.draw(&PathElement::new(ends, colour.stroke_width(2 * FINE)))?;
        area.draw(&(EmptyElement::at((fine(x + 16), fine(y))) + mark(shape(line), colour)))?;
        area.draw(&Text::new(
            line.name(),
            (fine(x + 42), fine(y - 7)),
            font(13),
        ))?;
    }
    let (_, charts) = area.split_vertically((CAPTION + legend_height(rows)) * FINE);
    let views = views_of(rows);
    let columns = views.len().min(COLUMNS);
    let charts = charts.split_evenly((views.len().div_ceil(columns.max(1)), columns));
    for (views, chart) in views.into_iter().zip(charts) {
        let of_views = lines.iter().map(|line| {
            let rows = line
                .rows
                .iter()
                .copied()
                .filter(|row| row.case.views == views);
            (line.method, shape(line), rows.collect())
        });
        draw_chart(&chart, views, &of_views.collect::<Vec<_>>())?;
    }
    Ok(())
}

/// The lines of a number of views: method, mark, and rows.
fn draw_chart(
    area: &Area<'_>,
    views: usize,
    lines: &[(Method, usize, Vec<&Row>)],
) -> Result<(), ChartError> {
    let rows = || lines.iter().flat_map(|(.., rows)| rows.iter());
    let noise = rows().map(|row| row.case.noise_px).fold(0.0, f64::max);
    let error = rows().map(|row| row.mpjpe_mm).fold(0.0, f64::max);
    let (noise, error) = (noise.max(1e-3), error.max(1e-3));
    let mut chart = ChartBuilder::on(area)
        .caption(Case::counted_views(views), font(14))
        .margin(12 * FINE)
        .x_label_area_size(44 * FINE)
        .y_label_area_size(60 * FINE)
        .build_cartesian_2d(0.0..1.04 * noise, 0.0..1.06 * error)?;
    chart
        .configure_mesh()
        .x_desc("standard deviation of the noise (px)")
        .y_desc("MPJPE (mm)")
        .x_labels(6)
        .y_labels(7)
        .x_label_formatter(&short)
        .y_label_formatter(&short)
        .axis_desc_style(font(13))
        .label_style(font(12))
        .light_line_style(WHITE)
        .bold_line_style(RGBColor(225, 225, 225).stroke_width(FINE))
        .axis_style(BLACK.stroke_width(FINE))
        .set_all_tick_mark_size(5 * FINE)
        .draw()?;
    for (method, shape, rows) in lines {
        let colour = colour(*method);
        let points = rows.iter().map(|row| (row.case.noise_px, row.mpjpe_mm));
        chart.draw_series(LineSeries::new(
            points.clone(),
            colour.stroke_width(2 * FINE),
        ))?;
        chart.draw_series(points.map(|point| EmptyElement::at(point) + mark(*shape, colour)))?;
    }
    Ok(())
}

/// A label of an axis, without digits that say nothing.
fn short(number: &f64) -> String {
    // Ticks are sums of steps, so that 0.3 may be 0.30000000000000004.
    format!("{}", (number * 1e6).round() / 1e6)
}

fn sorted(numbers: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut numbers: Vec<f64> = numbers.collect();
    numbers.sort_by(f64::total_cmp);
    numbers.dedup();
    numbers
}

fn views_of(rows: &[&Row]) -> Vec<usize> {
    let mut views: Vec<usize> = rows.iter().map(|row| row.case.views).collect();
    views.sort_unstable();
    views.dedup();
    views
}

fn legend_height(rows: &[&Row]) -> u32 {
    LEGEND_ROW * (lines(rows).len() as u32).div_ceil(LEGEND_COLUMNS)
}

/// A square, a triangle, and polygons of more corners.
fn mark(shape: usize, colour: RGBColor) -> Polygon<(i32, i32)> {
    let corners = [4, 3].get(shape).copied().unwrap_or(3 + shape);
    let radius = f64::from(5 * FINE);
    let start = if corners == 4 { 0.5 } else { 0.0 };
    let corner = |index: usize| {
        let angle = std::f64::consts::TAU * (index as f64 + start) / corners as f64;
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
