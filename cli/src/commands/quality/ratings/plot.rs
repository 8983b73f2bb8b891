//! Ratings as a picture, in the shape of Cui's fig. 11: opinions with intervals for each question,
//! and how many people gave which rating.

use anyhow::Result;
use ga_vision::opinion::ratings::Ratings;
use plotters::coord::Shift;
use plotters::prelude::*;

use crate::chart::{COLOURS, FINE, shown_small};

const SIZE: (u32, u32) = (820, 640);
/// Half the width of a bar, where questions are 1 apart.
const HALF_BAR: f64 = 0.32;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

pub(super) fn svg(ratings: &Ratings, confidence: f64) -> Result<String> {
    let mut text = String::new();
    {
        let root = SVGBackend::with_string(&mut text, (SIZE.0 * FINE, SIZE.1 * FINE));
        let root = root.into_drawing_area();
        root.fill(&WHITE)?;
        let (above, below) = root.split_vertically(SIZE.1 * FINE / 2);
        draw_opinions(&above, ratings, confidence)?;
        draw_counts(&below, ratings)?;
        root.present()?;
    }
    Ok(shown_small(&text, SIZE))
}

fn font<'a>(size: u32) -> FontDesc<'a> {
    ("sans-serif", size * FINE).into_font()
}

/// The values of the ratings that occur, in rising order.
fn scale(ratings: &Ratings) -> Vec<f64> {
    let raters = ratings.raters().iter();
    let mut values: Vec<f64> = raters
        .flat_map(|r| r.ratings.iter().flatten().copied())
        .collect();
    values.sort_by(f64::total_cmp);
    values.dedup();
    values
}

/// The names of questions under their places.
fn label(ratings: &Ratings) -> impl Fn(&f64) -> String {
    |place| {
        let question = place.round();
        let is_place = (place - question).abs() < 1e-9 && question >= 0.0;
        let name = is_place.then(|| ratings.questions().get(question as usize));
        name.flatten().cloned().unwrap_or_default()
    }
}

/// A dot with its interval for each question and group.
fn draw_opinions(area: &Area<'_>, ratings: &Ratings, confidence: f64) -> Result<()> {
    let scale = scale(ratings);
    let (least, greatest) = (scale[0], scale[scale.len() - 1]);
    let margin = 0.08 * (greatest - least).max(1.0);
    let count = ratings.questions().len();
    let caption = format!(
        "Mean opinion scores with {} % intervals",
        100.0 * confidence
    );
    let mut chart = ChartBuilder::on(area)
        .caption(caption, font(17))
        .margin(12 * FINE)
        .x_label_area_size(26 * FINE)
        .y_label_area_size(48 * FINE)
        .build_cartesian_2d(-0.5..count as f64 - 0.5, least - margin..greatest + margin)?;
    chart
        .configure_mesh()
        .disable_x_mesh()
        .x_labels(2 * count + 1)
        .x_label_formatter(&label(ratings))
        .light_line_style(TRANSPARENT)
        .bold_line_style(RGBColor(225, 225, 225).stroke_width(FINE))
        .axis_style(RGBColor(90, 90, 90).stroke_width(FINE))
        .label_style(font(13))
        .axis_desc_style(font(14))
        .y_desc("rating")
        .draw()?;
    let groups = ratings.groups();
    let shown: Vec<Option<&str>> = std::iter::once(None)
        .chain(groups.iter().map(|group| Some(*group)))
        .collect();
    for (place, group) in shown.iter().enumerate() {
        let colour = COLOURS[place % COLOURS.len()];
        let offset = HALF_BAR * (2.0 * (place as f64 + 0.5) / shown.len() as f64 - 1.0);
        let found: Vec<(f64, f64, f64)> = (0..count)
            .filter_map(|question| {
                let opinion = ratings.mean_opinion(question, *group, confidence).ok()?;
                let half = opinion.half_width.unwrap_or(0.0);
                Some((question as f64 + offset, opinion.mean, half))
            })
            .collect();
        chart.draw_series(found.iter().map(|(x, mean, half)| {
            let ends =
                [mean - half, mean + half].map(|y| y.clamp(least - margin, greatest + margin));
            PathElement::new(
                [(*x, ends[0]), (*x, ends[1])],
                colour.stroke_width(2 * FINE),
            )
        }))?;
        chart
            .draw_series(
                found
                    .iter()
                    .map(|(x, mean, _)| Circle::new((*x, *mean), 4 * FINE as i32, colour.filled())),
            )?
            .label(group.unwrap_or("all"))
            .legend(move |(x, y)| {
                Circle::new((x + 11 * FINE as i32, y), 4 * FINE as i32, colour.filled())
            });
    }
    if !groups.is_empty() {
        legend(&mut chart)?;
    }
    Ok(())
}

/// A bar for each question, with a part for each rating.
fn draw_counts(area: &Area<'_>, ratings: &Ratings) -> Result<()> {
    let scale = scale(ratings);
    let count = ratings.questions().len();
    let people = ratings.raters().len() as f64;
    let mut chart = ChartBuilder::on(area)
        .caption("Raters by rating", font(17))
        .margin(12 * FINE)
        .x_label_area_size(26 * FINE)
        .y_label_area_size(48 * FINE)
        .build_cartesian_2d(-0.5..count as f64 + 0.2, 0.0..1.05 * people)?;
    chart
        .configure_mesh()
        .disable_x_mesh()
        .x_labels(2 * count + 1)
        .x_label_formatter(&label(ratings))
        .light_line_style(TRANSPARENT)
        .bold_line_style(RGBColor(225, 225, 225).stroke_width(FINE))
        .axis_style(RGBColor(90, 90, 90).stroke_width(FINE))
        .label_style(font(13))
        .axis_desc_style(font(14))
        .y_desc("raters")
        .draw()?;
    let mut tops = vec![0.0; count];
    for (place, value) in scale.iter().enumerate() {
        let part = place as f64 / (scale.len() - 1).max(1) as f64;
        let colour = shade(part);
        let bars: Vec<[(f64, f64); 2]> = (0..count)
            .map(|question| {
                let given = ratings.of_question(question, None);
                let found = given.iter().filter(|rating| *rating == value).count() as f64;
                let (x, bottom) = (question as f64, tops[question]);
                tops[question] += found;
                [(x - HALF_BAR, bottom), (x + HALF_BAR, bottom + found)]
            })
            .collect();
        let bars = bars
            .into_iter()
            .map(|bar| Rectangle::new(bar, colour.filled()));
        let series = chart.draw_series(bars)?;
        series.label(value.to_string()).legend(move |(x, y)| {
            let half = 5 * FINE as i32;
            let right = x + 16 * FINE as i32;
            Rectangle::new([(x + half, y - half), (right, y + half)], colour.filled())
        });
    }
    legend(&mut chart)
}

/// From the colour of the least rating to that of the greatest, through a light grey.
fn shade(part: f64) -> RGBColor {
    let (end, strength) = match part < 0.5 {
        true => (COLOURS[1], 1.0 - 2.0 * part),
        false => (COLOURS[0], 2.0 * part - 1.0),
    };
    let mix = |channel: u8| (224.0 + (f64::from(channel) - 224.0) * strength).round() as u8;
    RGBColor(mix(end.0), mix(end.1), mix(end.2))
}

fn legend<'a>(
    chart: &mut ChartContext<
        'a,
        SVGBackend<'a>,
        Cartesian2d<plotters::coord::types::RangedCoordf64, plotters::coord::types::RangedCoordf64>,
    >,
) -> Result<()> {
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperRight)
        .margin(6 * FINE)
        .legend_area_size(22 * FINE)
        .label_font(font(13))
        .background_style(WHITE.mix(0.85))
        .draw()?;
    Ok(())
}
