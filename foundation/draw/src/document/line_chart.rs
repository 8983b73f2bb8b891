//! Lines over a common axis with points on them.

use plotters::prelude::*;

use super::chart::{self, Area, COLOURS, ChartError, FINE, font, shortened};

/// The size of the picture as it is shown.
const SIZE: (u32, u32) = (1000, 560);
/// The width of the strip with the names of the series.
const NAMES: u32 = 180;
/// How many names fit into it.
const MOST_NAMES: usize = 20;
/// A longer name does not fit beside its line.
const MOST_LETTERS: usize = 18;

/// A chart of lines in several colours, with dots and rings on them and their names beside.
///
/// ```
/// use ga_draw::document::{LineChart, Series};
///
/// let height = Series {
///     name: "height".into(),
///     line: vec![(0.0, 1.0), (1.0, 3.0), (2.0, 2.0)],
///     dots: vec![(1.0, 3.0)],
///     rings: vec![],
/// };
/// let chart = LineChart {
///     title: "a jump",
///     horizontal: "seconds",
///     vertical: "metres",
///     series: &[height],
///     dots: "key",
///     rings: "vertex",
/// };
/// let svg = chart.to_svg()?;
/// assert!(svg.contains("height") && svg.contains("key") && !svg.contains("vertex"));
/// # Ok::<(), ga_draw::document::chart::ChartError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct LineChart<'a> {
    /// What stands above it.
    pub title: &'a str,
    /// The name of the horizontal axis.
    pub horizontal: &'a str,
    /// The name of the vertical axis.
    pub vertical: &'a str,
    /// The lines, the last one on top. Their extent is that of the chart.
    pub series: &'a [Series],
    /// What the dots are.
    pub dots: &'a str,
    /// What the rings are.
    pub rings: &'a str,
}

/// A line of a [`LineChart`]. Points are horizontal and vertical coordinates.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Series {
    /// The name.
    pub name: String,
    /// Points that straight lines join.
    pub line: Vec<(f64, f64)>,
    /// Points with a dot.
    pub dots: Vec<(f64, f64)>,
    /// Points with a small ring.
    pub rings: Vec<(f64, f64)>,
}

impl LineChart<'_> {
    /// The chart as SVG, 1000 by 560 pixels.
    ///
    /// # Errors
    ///
    /// [`ChartError`].
    pub fn to_svg(&self) -> Result<String, ChartError> {
        let points = || self.series.iter().flat_map(|series| &series.line);
        let [start, end] = padded(points().map(|point| point.0), 0.02);
        let [low, high] = padded(points().map(|point| point.1), 0.05);
        let numbers = [low, high, start, end, high - low, end - start];
        if !numbers.iter().all(|x| x.is_finite()) {
            return Err(ChartError::TooLarge);
        }
        chart::svg(SIZE, |root| {
            let (left, right) = root.split_horizontally((SIZE.0 - NAMES) * FINE);
            self.draw_lines(&left, [start, end], [low, high])?;
            self.draw_names(&right)
        })
    }

    fn draw_lines(
        &self,
        area: &Area<'_>,
        [start, end]: [f64; 2],
        [low, high]: [f64; 2],
    ) -> Result<(), ChartError> {
        let mut chart = ChartBuilder::on(area)
            .caption(self.title, font(18))
            .margin(14 * FINE)
            .x_label_area_size(46 * FINE)
            .y_label_area_size(76 * FINE)
            .build_cartesian_2d(start..end, low..high)?;
        chart
            .configure_mesh()
            .x_label_formatter(&|x| format!("{x:.0$}", decimals(end - start)))
            .x_desc(self.horizontal)
            .y_desc(self.vertical)
            .axis_desc_style(font(16))
            .label_style(font(13))
            .light_line_style(WHITE)
            .bold_line_style(RGBColor(225, 225, 225).stroke_width(FINE))
            .axis_style(BLACK.stroke_width(FINE))
            .set_all_tick_mark_size(5 * FINE)
            .draw()?;
        for (index, series) in self.series.iter().enumerate() {
            let colour = colour(index);
            let line = series.line.iter().copied();
            chart.draw_series(LineSeries::new(line, colour.stroke_width(2 * FINE)))?;
            let ring = |&place: &_| Circle::new(place, 3 * FINE, colour.stroke_width(FINE));
            chart.draw_series(series.rings.iter().map(ring))?;
            let dot = |&place: &_| Circle::new(place, 5 * FINE, colour.filled());
            chart.draw_series(series.dots.iter().map(dot))?;
        }
        Ok(())
    }

    /// The names of the series beside samples of their lines, and what dots and rings are.
    fn draw_names(&self, area: &Area<'_>) -> Result<(), ChartError> {
        let unit = FINE as i32;
        let mut y = 60 * unit;
        let mut say = |text: &str, mark: &dyn Fn(i32) -> Result<(), ChartError>| {
            mark(y)?;
            let text = shortened(text, MOST_LETTERS);
            area.draw(&Text::new(text, (40 * unit, y - 7 * unit), font(14)))?;
            y += 22 * unit;
            Ok::<(), ChartError>(())
        };
        for (index, series) in self.series.iter().take(MOST_NAMES).enumerate() {
            say(&series.name, &|y| {
                let ends = vec![(4 * unit, y), (32 * unit, y)];
                let style = colour(index).stroke_width(3 * FINE);
                Ok(area.draw(&PathElement::new(ends, style))?)
            })?;
        }
        if let more @ 1.. = self.series.len().saturating_sub(MOST_NAMES) {
            say(&format!("and {more} more"), &|_| Ok(()))?;
        }
        if self.series.iter().any(|series| !series.dots.is_empty()) {
            say(self.dots, &|y| {
                let dot = Circle::new((18 * unit, y), 5 * FINE, BLACK.filled());
                Ok(area.draw(&dot)?)
            })?;
        }
        if self.series.iter().any(|series| !series.rings.is_empty()) {
            say(self.rings, &|y| {
                let ring = Circle::new((18 * unit, y), 3 * FINE, BLACK.stroke_width(FINE));
                Ok(area.draw(&ring)?)
            })?;
        }
        Ok(())
    }
}

fn colour(series: usize) -> RGBColor {
    COLOURS[series % COLOURS.len()]
}

/// The decimals of numbers on an axis of a length, of which there are about ten.
fn decimals(length: f64) -> usize {
    (-(0.1 * length).log10().floor()).clamp(0.0, 9.0) as usize
}

/// The range of numbers with a margin, and not so narrow that numbers on its axis could not be told
/// apart.
fn padded(numbers: impl Iterator<Item = f64>, share: f64) -> [f64; 2] {
    let start = [f64::INFINITY, f64::NEG_INFINITY];
    let [low, high] = numbers.fold(start, |[low, high], x| [low.min(x), high.max(x)]);
    let size = low.abs().max(high.abs());
    let least = if size > 0.0 { 1e-6 * size } else { 1.0 };
    let margin = (share * (high - low)).max(least);
    [low - margin, high + margin]
}
