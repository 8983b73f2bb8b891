//! Scores with fitted curves as a picture, in the shape of Cui's fig. 12.

use ga_draw::document::chart::{self, COLOURS, ChartError, FINE, Mark, draw_legend, font};
use plotters::prelude::*;

use super::super::logistic::Curve;
use super::super::performance::{Interval, Performance};
use super::Fitted;

const SIZE: (u32, u32) = (900, 520);
const LEGEND: u32 = 190;
/// Straight lines that make a curve.
const PIECES: usize = 400;

impl Fitted {
    /// The scores with both curves as SVG, and what was found in words above.
    ///
    /// # Errors
    ///
    /// Those of the drawing.
    pub fn svg(&self, found: &Performance<Interval>) -> Result<String, ChartError> {
        let x = range(self.scores.objective());
        let y = range(self.scores.subjective());
        chart::svg(SIZE, |area| {
            let caption = format!(
                "SROCC {:.4}, fitted PLCC {:.4}, RMSE {:.4}, {} scores",
                found.spearman.value,
                found.linear_correlation.value,
                found.root_mean_square_error.value,
                self.scores.len()
            );
            let (left, right) = area.split_horizontally((SIZE.0 - LEGEND) * FINE);
            let mut chart = ChartBuilder::on(&left)
                .caption(caption, font(17))
                .margin(14 * FINE)
                .x_label_area_size(44 * FINE)
                .y_label_area_size(54 * FINE)
                .build_cartesian_2d(x[0]..x[1], y[0]..y[1])?;
            chart
                .configure_mesh()
                .light_line_style(TRANSPARENT)
                .bold_line_style(RGBColor(225, 225, 225).stroke_width(FINE))
                .axis_style(RGBColor(90, 90, 90).stroke_width(FINE))
                .label_style(font(13))
                .axis_desc_style(font(14))
                .set_all_tick_mark_size(5 * FINE)
                .x_desc("objective score")
                .y_desc("mean opinion score")
                .draw()?;
            let pairs = self.scores.objective().iter().zip(self.scores.subjective());
            chart.draw_series(pairs.map(|(x, y)| {
                Circle::new((*x, *y), 3 * FINE as i32, COLOURS[0].mix(0.7).filled())
            }))?;
            let places = (0..=PIECES).map(|k| x[0] + (x[1] - x[0]) * k as f64 / PIECES as f64);
            let places: Vec<f64> = places.collect();
            let by_four: Vec<f64> = places.iter().map(|x| self.four.curve.at(*x)).collect();
            let by_five: Vec<f64> = places.iter().map(|x| self.five.curve.at(*x)).collect();
            let mut legend = vec![(Mark::Dot, COLOURS[0], "scores".to_owned())];
            for (name, colour, values) in [
                ("logistic, 4 parameters", COLOURS[2], by_four),
                ("logistic, 5 parameters", COLOURS[1], by_five),
            ] {
                let shown = values.into_iter().map(|value| value.clamp(y[0], y[1]));
                let points = places.iter().copied().zip(shown);
                chart.draw_series(LineSeries::new(points, colour.stroke_width(2 * FINE)))?;
                legend.push((Mark::Line, colour, name.to_owned()));
            }
            draw_legend(&right, &legend)
        })
    }
}

/// The range of an axis: that of the numbers and a twentieth more on both sides.
fn range(values: &[f64]) -> [f64; 2] {
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    let greatest = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let margin = 0.05 * (greatest - least);
    [least - margin, greatest + margin]
}
