//! The curves of a video as an SVG picture, in the shape of Cui's fig. 6.

use anyhow::Result;
use ga_video::keyframe::Analysis;
use plotters::coord::Shift;
use plotters::prelude::*;

use crate::chart::{COLOURS, FINE, shown_small};

/// The size of the picture as it is shown.
const SIZE: (u32, u32) = (1000, 680);
const LIGHT: RGBColor = RGBColor(225, 225, 225);
const SHADE: RGBColor = RGBColor(240, 228, 200);

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Above, the difference of each frame from the one before it, with the threshold of cuts and the
/// cuts; below, their mutual information. Dissolves and fades are shaded.
pub(super) fn svg(analysis: &Analysis, title: &str) -> Result<String> {
    let mut text = String::new();
    {
        let root = SVGBackend::with_string(&mut text, (SIZE.0 * FINE, SIZE.1 * FINE));
        let root = root.into_drawing_area();
        root.fill(&WHITE)?;
        let (above, below) = root.split_vertically(SIZE.1 / 2 * FINE);
        let series = |value: &dyn Fn(usize) -> Option<f64>| -> Vec<(f64, f64)> {
            let frames = 0..analysis.frames.len();
            frames
                .filter_map(|index| Some((index as f64, value(index)?)))
                .collect()
        };
        let frames = &analysis.frames;
        let change = series(&|index| Some(f64::from(frames[index].change)));
        let background = series(&|index| Some(f64::from(frames[index].background)));
        let threshold = series(&|index| Some(f64::from(analysis.thresholds[index])));
        let name = format!("(a) {title}: difference of R from the frame before");
        panel(
            &above,
            (name.as_str(), "difference / contrast"),
            analysis,
            &[
                ("after camera motion", 0, change),
                ("background at rest", 4, background),
                ("threshold of cuts", 1, threshold),
            ],
        )?;
        let information = series(&|index| frames[index].mutual_information_bits);
        panel(
            &below,
            ("(b) mutual information with the frame before", "bits"),
            analysis,
            &[("mutual information", 2, information)],
        )?;
        root.present()?;
    }
    Ok(shown_small(&text, SIZE))
}

type Series = (&'static str, usize, Vec<(f64, f64)>);

fn panel(
    area: &Area<'_>,
    (caption, unit): (&str, &str),
    analysis: &Analysis,
    series: &[Series],
) -> Result<()> {
    let values = series
        .iter()
        .flat_map(|(_, _, line)| line)
        .map(|(_, value)| *value);
    let top = 1.08 * values.fold(0.1, f64::max);
    let end = analysis.frames.len().max(2) as f64;
    let mut chart = ChartBuilder::on(area)
        .caption(caption, ("sans-serif", 16 * FINE))
        .margin(12 * FINE)
        .x_label_area_size(40 * FINE)
        .y_label_area_size(64 * FINE)
        .build_cartesian_2d(0.0..end, 0.0..top)?;
    let transitions = &analysis.transitions;
    let dissolves = transitions
        .dissolves
        .iter()
        .map(|dissolve| &dissolve.frames);
    for frames in dissolves.chain(transitions.fades.iter().map(|fade| &fade.frames)) {
        let corners = [(frames.start as f64, 0.0), (frames.end as f64, top)];
        chart.draw_series([Rectangle::new(corners, SHADE.filled())])?;
    }
    chart
        .configure_mesh()
        .x_desc("frame")
        .y_desc(unit)
        .axis_desc_style(("sans-serif", 14 * FINE))
        .label_style(("sans-serif", 12 * FINE))
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
        .label_font(("sans-serif", 12 * FINE))
        .legend_area_size(26 * FINE)
        .margin(6 * FINE)
        .background_style(WHITE.mix(0.85))
        .draw()?;
    Ok(())
}
