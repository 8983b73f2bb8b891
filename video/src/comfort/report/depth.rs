//! The depth budget: how far in front of the screen and behind it points are, over time.

use crate::comfort::{Dimension, Histogram, Scale, Timeline, Viewing};
use ga_image::file::FormatError;
use ga_image::plane::Plane;
use ga_image::png;

use super::axis::{self, FAINT, INK, LEFT, RIGHT, TimeAxis, WIDTH};
use super::words::number;
use ga_draw::document::{Anchor, Svg, ticks};

const TOP: f64 = 16.0;
const BOTTOM: f64 = 400.0;

/// The budget of BSkyB's guidelines, in per cent of the picture's width.
const BUDGET: [f64; 2] = [-1.0, 2.0];

/// Lines of the nearest points, the median and the farthest points.
const LINES: [(&str, &str); 3] = [
    ("#d55e00", "farthest points (98 %)"),
    ("#000000", "median"),
    ("#0072b2", "nearest points (2 %)"),
];

/// The picture, and whether all points stay in the budget.
pub(super) fn svg(timeline: &Timeline, viewing: &Viewing) -> Result<String, FormatError> {
    let time = TimeAxis::new(timeline);
    let limits = limits(viewing);
    let range = range(timeline, &limits);
    let y = |percent: f64| {
        let share = (percent - range[0]) / (range[1] - range[0]);
        BOTTOM - (BOTTOM - TOP) * share.clamp(0.0, 1.0)
    };
    let mut svg = Svg::new(
        [WIDTH, BOTTOM + 62.0],
        "Depth over time, in per cent of the width",
    );
    draw_density(&mut svg, timeline, range)?;
    // Zones beyond the limits, darker beyond the outer ones.
    for (limit, _) in &limits {
        let (top, bottom) = match *limit > 0.0 {
            true => (TOP, y(*limit)),
            false => (y(*limit), BOTTOM),
        };
        let size = [RIGHT - LEFT, bottom - top];
        svg.rectangle([LEFT, top], size, "fill=\"#d55e00\" fill-opacity=\"0.10\"");
    }
    let ink = format!("fill=\"{INK}\"");
    let faint = format!("fill=\"{FAINT}\"");
    let marks = ticks(range, 12);
    let decimals = usize::from(marks.iter().any(|percent| percent.fract() != 0.0));
    for percent in marks {
        let place = y(percent);
        svg.line(
            [LEFT - 5.0, place],
            [LEFT, place],
            &format!("stroke=\"{INK}\""),
        );
        let sign = if percent > 0.0 { "+" } else { "" };
        let text = format!("{sign}{} %", number(percent, decimals));
        svg.text([LEFT - 9.0, place + 4.0], 12.0, Anchor::End, &ink, &text);
    }
    draw_lines(&mut svg, time, timeline, &y);
    time.draw_cuts(&mut svg, [TOP, BOTTOM]);
    let mut labels = Vec::new();
    for (percent, text) in &limits {
        let style = "stroke=\"#a3261b\" stroke-width=\"1.2\"";
        svg.line([LEFT, y(*percent)], [RIGHT, y(*percent)], style);
        labels.push((y(*percent), *text, "#a3261b"));
    }
    for percent in BUDGET {
        let style = "stroke=\"#00734f\" stroke-width=\"1.4\" stroke-dasharray=\"7 4\"";
        svg.line([LEFT, y(percent)], [RIGHT, y(percent)], style);
        let text = match percent > 0.0 {
            true => "broadcast budget +2 %",
            false => "broadcast budget −1 %",
        };
        labels.push((y(percent), text, "#00734f"));
    }
    svg.line(
        [LEFT, y(0.0)],
        [RIGHT, y(0.0)],
        &format!("stroke=\"{INK}\" stroke-width=\"1.6\""),
    );
    labels.push((y(0.0), "the screen", INK));
    axis::draw_labels(&mut svg, labels);
    for (place, text) in [
        (0.5 * (TOP + y(0.0)), "behind the screen"),
        (0.5 * (BOTTOM + y(0.0)), "in front of the screen"),
    ] {
        svg.raw(&format!(
            "<g transform=\"translate({:.1} {place:.1}) rotate(-90)\">\n",
            LEFT - 75.0
        ));
        svg.text([0.0, 0.0], 13.0, Anchor::Middle, &ink, text);
        svg.raw("</g>\n");
    }
    svg.raw(&format!(
        "<g transform=\"translate({:.1} {:.1}) rotate(-90)\">\n",
        LEFT - 100.0,
        0.5 * (TOP + BOTTOM)
    ));
    let text = "parallax in % of the picture's width";
    svg.text([0.0, 0.0], 12.0, Anchor::Middle, &faint, text);
    svg.raw("</g>\n");
    time.draw(&mut svg, BOTTOM);
    let mut x = LEFT;
    for (colour, text) in LINES {
        let place = BOTTOM + 52.0;
        let style = format!("stroke=\"{colour}\" stroke-width=\"3\"");
        svg.line([x, place - 4.0], [x + 24.0, place - 4.0], &style);
        svg.text([x + 30.0, place], 12.0, Anchor::Start, &ink, text);
        x += 195.0;
    }
    Ok(svg.into_text())
}

/// The limits of comfort and those of severe discomfort, in per cent of the width, with names.
fn limits(viewing: &Viewing) -> Vec<(f64, &'static str)> {
    let mut limits = Vec::new();
    for (dimension, sign) in [
        (Dimension::OverConvergence, -1.0),
        (Dimension::OverDivergence, 1.0),
    ] {
        if let Some(scale) = Scale::of(dimension, viewing) {
            let percent = |degrees: f64| viewing.parallax_of_degrees(sign * degrees);
            limits.push((percent(scale.comfortable()), "limit of comfort"));
            limits.push((percent(scale.limit()), "limit of severe strain"));
        }
    }
    limits
}

/// The range of parallax that is shown.
fn range(timeline: &Timeline, limits: &[(f64, &str)]) -> [f64; 2] {
    let depths = timeline
        .intervals()
        .iter()
        .filter_map(|interval| interval.depth);
    let ends = depths.flat_map(|depth| [depth.nearest, depth.farthest]);
    let limits = limits.iter().map(|(percent, _)| *percent);
    let (mut low, mut high) = (BUDGET[0], BUDGET[1]);
    for percent in ends.chain(limits) {
        low = low.min(percent);
        high = high.max(percent);
    }
    let margin = 0.06 * (high - low);
    let most = -Histogram::FIRST_PERCENT;
    [(low - margin).max(-most), (high + margin).min(most)]
}

/// A column of shades for each interval: the more points have a parallax, the darker.
fn draw_density(svg: &mut Svg, timeline: &Timeline, range: [f64; 2]) -> Result<(), FormatError> {
    let intervals = timeline.intervals();
    if intervals.is_empty() {
        return Ok(());
    }
    // Whole intervals of the histogram, which may begin beyond the range.
    let index = |percent: f64| (percent - Histogram::FIRST_PERCENT) / Histogram::INTERVAL_PERCENT;
    let first = index(range[0]).floor().max(0.0) as usize;
    let last = (index(range[1]).ceil() as usize).min(Histogram::INTERVALS);
    let shades = Plane::from_fn(intervals.len(), last - first, |column, row| {
        let counts = intervals[column].histogram.counts();
        let total: u64 = counts.iter().map(|count| u64::from(*count)).sum();
        let share = f64::from(counts[last - 1 - row]) / total.max(1) as f64;
        // A tenth of all points in one interval of the histogram is the darkest shade.
        let dark = (10.0 * share).min(1.0).sqrt();
        [255.0, 255.0, 255.0_f64].map(|white| (white - dark * 170.0).round() as u8)
    });
    let percent =
        |index: usize| Histogram::FIRST_PERCENT + index as f64 * Histogram::INTERVAL_PERCENT;
    let height = (BOTTOM - TOP) / (range[1] - range[0]);
    let top = TOP + (range[1] - percent(last)) * height;
    let tall = (last - first) as f64 * Histogram::INTERVAL_PERCENT * height;
    let bytes = png::encode(&shades)?;
    svg.raw(&format!(
        "<clipPath id=\"depth\"><rect x=\"{LEFT}\" y=\"{TOP}\" width=\"{}\" height=\"{}\"/></clipPath>\n",
        RIGHT - LEFT,
        BOTTOM - TOP
    ));
    svg.picture(
        [LEFT, top],
        [RIGHT - LEFT, tall],
        ("png", &bytes),
        "clip-path=\"url(#depth)\" style=\"image-rendering:pixelated\"",
    );
    Ok(())
}

/// The lines, which end where parallax is not known.
fn draw_lines(svg: &mut Svg, axis: TimeAxis<'_>, timeline: &Timeline, y: &impl Fn(f64) -> f64) {
    let half = 0.5 * axis.step();
    for (line, (colour, _)) in [2, 1, 0].into_iter().zip(LINES) {
        let mut places: Vec<[f64; 2]> = Vec::new();
        let style = format!(
            "fill=\"none\" stroke=\"{colour}\" stroke-width=\"2\" stroke-linejoin=\"round\""
        );
        for (index, interval) in timeline.intervals().iter().enumerate() {
            match interval.depth {
                Some(depth) => {
                    let (x, height) = (axis.middle(index), y(depth.means()[line]));
                    places.extend([[x - half, height], [x + half, height]]);
                }
                None if !places.is_empty() => svg.path(places.drain(..), &style),
                None => {}
            }
        }
        if !places.is_empty() {
            svg.path(places, &style);
        }
    }
}
