//! The curves of a video as an SVG picture, in the shape of Cui's fig. 6.

use ga_draw::document::chart::{self, Area, COLOURS, ChartError, FINE, font};
use plotters::prelude::*;

use super::analysis::Analysis;

/// The size of the picture as it is shown.
const SIZE: (u32, u32) = (1000, 680);
const LIGHT: RGBColor = RGBColor(225, 225, 225);
const SHADE: RGBColor = RGBColor(240, 228, 200);

impl Analysis {
    /// The curves as SVG: above, the difference of each frame from the one before it, with the
    /// threshold of cuts and the cuts; below, their mutual information. Dissolves, fades and
    /// flashes are shaded.
    ///
    /// # Errors
    ///
    /// Those of the drawing.
    pub fn svg(&self, title: &str) -> Result<String, ChartError> {
        let frames = &self.frames;
        let series = |value: &dyn Fn(usize) -> Option<f64>| -> Vec<(f64, f64)> {
            (0..frames.len())
                .filter_map(|index| Some((index as f64, value(index)?)))
                .collect()
        };
        let change = series(&|index| Some(f64::from(frames[index].change)));
        let background = series(&|index| Some(f64::from(frames[index].background)));
        let threshold = series(&|index| Some(f64::from(self.thresholds[index])));
        let information = series(&|index| frames[index].mutual_information_bits);
        let name = format!("(a) {title}: difference of R from the frame before");
        let differences = [
            ("after camera motion", 0, change),
            ("background at rest", 4, background),
            ("threshold of cuts", 1, threshold),
        ];
        chart::svg(SIZE, |area| {
            let (above, below) = area.split_vertically(SIZE.1 / 2 * FINE);
            panel(&above, (&name, "difference / contrast"), self, &differences)?;
            panel(
                &below,
                ("(b) mutual information with the frame before", "bits"),
                self,
                &[("mutual information", 2, information)],
            )
        })
    }
}

/// A name, the number of a colour, and places.
type Series = (&'static str, usize, Vec<(f64, f64)>);

fn panel(
    area: &Area<'_>,
    (caption, unit): (&str, &str),
    analysis: &Analysis,
    series: &[Series],
) -> Result<(), ChartError> {
    let values = series
        .iter()
        .flat_map(|(_, _, line)| line)
        .map(|(_, value)| *value);
    let top = 1.08 * values.fold(0.1, f64::max);
    let end = analysis.frames.len().max(2) as f64;
    let mut chart = ChartBuilder::on(area)
        .caption(caption, font(16))
        .margin(12 * FINE)
        .x_label_area_size(40 * FINE)
        .y_label_area_size(64 * FINE)
        .build_cartesian_2d(0.0..end, 0.0..top)?;
    let transitions = &analysis.transitions;
    let dissolves = transitions.dissolves.iter().map(|other| &other.frames);
    let fades = transitions.fades.iter().map(|other| &other.frames);
    let flashes = transitions.flashes.iter().map(|other| &other.frames);
    for frames in dissolves.chain(fades).chain(flashes) {
        let corners = [(frames.start as f64, 0.0), (frames.end as f64, top)];
        chart.draw_series([Rectangle::new(corners, SHADE.filled())])?;
    }
    chart
        .configure_mesh()
        .x_desc("frame")
        .y_desc(unit)
        .axis_desc_style(font(14))
        .label_style(font(12))
        .light_line_style(WHITE.mix(0.0))
        .bold_line_style(LIGHT.stroke_width(FINE))
        .axis_style(BLACK.stroke_width(FINE))
        .set_all_tick_mark_size(5 * FINE)
        .x_label_formatter(&|frame| format!("{frame:.0}"))
        .draw()?;
    for cut in &transitions.cuts {
        let line = vec![(*cut as f64, 0.0), (*cut as f64, top)];
        let style = COLOURS[6].mix(0.6).stroke_width(FINE);
        chart.draw_series([PathElement::new(line, style)])?;
    }
    for (name, colour, line) in series {
        let style = COLOURS[*colour].stroke_width(3 * FINE / 2);
        let drawn = chart.draw_series(LineSeries::new(line.iter().copied(), style))?;
        drawn
            .label(*name)
            .legend(move |(x, y)| PathElement::new(vec![(x, y), (x + 20 * FINE as i32, y)], style));
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperRight)
        .label_font(font(12))
        .legend_area_size(26 * FINE)
        .margin(6 * FINE)
        .background_style(WHITE.mix(0.85))
        .draw()?;
    Ok(())
}
