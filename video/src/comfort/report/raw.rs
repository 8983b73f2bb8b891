//! The measured numbers of one row over time.

use crate::comfort::{Dimension, Scale, Timeline, Viewing};

use super::axis::{self, FAINT, INK, LEFT, RIGHT, TimeAxis, WIDTH};
use super::words;
use ga_draw::document::{Anchor, Svg, ticks};

const TOP: f64 = 26.0;
const BOTTOM: f64 = 136.0;

/// The chart: the mean of each interval as a line, its range as a band, and the limits.
pub(super) fn svg(timeline: &Timeline, dimension: Dimension, viewing: &Viewing) -> String {
    let time = TimeAxis::new(timeline);
    let title = format!("{}, measured", dimension.in_words());
    let mut svg = Svg::new([WIDTH, BOTTOM + 38.0], &title);
    let rows = || {
        timeline
            .intervals()
            .iter()
            .map(|interval| interval.summary.row(dimension))
    };
    let mut range = [0.0_f64, 0.0_f64];
    for found in rows().filter_map(|row| row.raw_range) {
        range = [range[0].min(found[0]), range[1].max(found[1])];
    }
    let scale = Scale::of(dimension, viewing);
    let limits = scale.map_or([0.0; 2], |scale| [scale.comfortable(), scale.limit()]);
    let is_signed = range[0] < 0.0;
    if range[1] > 0.0 || !is_signed {
        range[1] = range[1].max(1.25 * limits[0]);
    }
    if is_signed {
        range[0] = range[0].min(-1.25 * limits[0]);
    }
    let margin = 0.06 * (range[1] - range[0]).max(1e-9);
    let range = [
        range[0] - if is_signed { margin } else { 0.0 },
        range[1] + margin,
    ];
    let y = |raw: f64| BOTTOM - (BOTTOM - TOP) * (raw - range[0]) / (range[1] - range[0]);
    let ink = format!("fill=\"{INK}\"");
    let faint = format!("fill=\"{FAINT}\"");
    svg.text(
        [LEFT, TOP - 10.0],
        13.0,
        Anchor::Start,
        &format!("{ink} font-weight=\"bold\""),
        dimension.in_words(),
    );
    for raw in ticks(range, 5) {
        let place = y(raw);
        svg.line([LEFT, place], [RIGHT, place], "stroke=\"#e4e6ec\"");
        let text = words::amount(dimension, raw);
        svg.text([LEFT - 8.0, place + 4.0], 12.0, Anchor::End, &ink, &text);
    }
    let inside = |raw: &f64| scale.is_some() && (range[0]..=range[1]).contains(raw);
    let mut labels = Vec::new();
    for (limit, colour, text) in [
        (limits[0], "#b36a00", "comfortable"),
        (limits[1], "#a3261b", "severe"),
    ] {
        let style = format!("stroke=\"{colour}\" stroke-width=\"1.4\" stroke-dasharray=\"7 4\"");
        for raw in [limit, -limit].into_iter().filter(inside) {
            svg.line([LEFT, y(raw)], [RIGHT, y(raw)], &style);
        }
        if inside(&limit) {
            labels.push((y(limit), text, colour));
        }
    }
    axis::draw_labels(&mut svg, labels);
    let mut bands = Vec::new();
    let mut line: Vec<[f64; 2]> = Vec::new();
    let half = 0.5 * time.step();
    let mut lines = Vec::new();
    for (index, row) in rows().enumerate() {
        let (Some(mean), Some([low, high])) = (row.mean_raw(), row.raw_range) else {
            lines.push(std::mem::take(&mut line));
            continue;
        };
        let x = time.middle(index);
        if high > low {
            bands.push(([x - half, y(high)], [2.0 * half, y(low) - y(high)]));
        }
        line.extend([[x - half, y(mean)], [x + half, y(mean)]]);
    }
    lines.push(line);
    for (place, size) in bands {
        svg.rectangle(place, size, "fill=\"#0072b2\" fill-opacity=\"0.22\"");
    }
    for line in lines.into_iter().filter(|line| !line.is_empty()) {
        svg.path(
            line,
            "fill=\"none\" stroke=\"#0072b2\" stroke-width=\"2\" stroke-linejoin=\"round\"",
        );
    }
    time.draw_cuts(&mut svg, [TOP, BOTTOM]);
    time.draw(&mut svg, BOTTOM);
    if timeline.seconds().is_some() {
        let text = "line: mean, band: least to greatest";
        svg.text([RIGHT, TOP - 10.0], 12.0, Anchor::End, &faint, text);
    }
    svg.into_text()
}
