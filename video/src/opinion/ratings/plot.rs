//! Ratings as a picture, in the shape of Cui's fig. 11: opinions with intervals for each question,
//! and how many people gave which rating.

use ga_draw::document::chart::{
    self, Area, COLOURS, ChartError, FINE, Mark, draw_legend, font, shortened, shortened_between,
};
use ga_draw::document::percent;
use plotters::prelude::*;
use plotters::style::FontTransform;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::classes::{classes, scale};
use super::{Evaluation, Ratings};

/// The size of the picture as it is shown, without the names of the questions. Many questions make
/// it wider.
const SIZE: (u32, u32) = (900, 600);
/// The least width of a question, in which upright names do not touch, and that of each of its
/// dots.
const PITCH: u32 = 16;
const DOT_PITCH: u32 = 7;
const LEGEND: u32 = 170;
/// The space beside the charts that no question takes.
const BESIDE: u32 = 80;
/// About the width of a letter.
const LETTER: u32 = 7;
/// Half the width of a bar, where questions are 1 apart.
const HALF_BAR: f64 = 0.32;
/// The most letters of a name that are shown. Names of clips often differ at their ends.
const QUESTION: usize = 26;
const GROUP: usize = 18;

impl Evaluation {
    /// The opinions and the counts of ratings as SVG.
    ///
    /// # Errors
    ///
    /// Those of the drawing.
    pub fn svg(&self) -> Result<String, ChartError> {
        let ratings = &self.ratings;
        let names = Names::new(ratings);
        let size = (names.width + LEGEND, SIZE.1 + 2 * names.height);
        chart::svg(size, |area| {
            let (above, below) = area.split_vertically(size.1 * FINE / 2);
            draw_opinions(&above, ratings, &names, self.confidence)?;
            draw_counts(&below, ratings, &names)
        })
    }
}

/// The names of the questions as they are shown under their places.
struct Names {
    names: Vec<String>,
    /// Whether they stand upright, as they are too long to lie beside each other.
    upright: bool,
    /// The height that they take.
    height: u32,
    /// The width of the charts.
    width: u32,
}

impl Names {
    fn new(ratings: &Ratings) -> Self {
        let questions = ratings.questions();
        let names = questions.iter().map(|q| shortened_between(q, QUESTION));
        let names: Vec<String> = names.collect();
        let longest = names.iter().map(|name| name.chars().count()).max();
        let longest = LETTER * longest.unwrap_or(0) as u32;
        let count = names.len() as u32;
        let upright = longest * count > SIZE.0 - LEGEND - BESIDE;
        let dots = 1 + ratings.groups().len() as u32;
        let pitch = PITCH.max(DOT_PITCH * dots);
        let width = (SIZE.0 - LEGEND).max(BESIDE + pitch * count);
        Self {
            names,
            width,
            upright,
            height: if upright { longest + 12 } else { 26 },
        }
    }

    fn style(&self) -> TextStyle<'static> {
        let (font, place) = match self.upright {
            true => (
                font(13).transform(FontTransform::Rotate90),
                Pos::new(HPos::Left, VPos::Center),
            ),
            false => (font(13), Pos::new(HPos::Center, VPos::Top)),
        };
        TextStyle::from(font).pos(place)
    }
}

/// A chart over the questions, with its axes.
struct Chart<'a> {
    caption: String,
    unit: &'a str,
    range: [f64; 2],
    /// The most numbers beside the axis.
    numbers: usize,
}

type Context<'a> = ChartContext<
    'a,
    SVGBackend<'a>,
    Cartesian2d<plotters::coord::types::RangedCoordf64, plotters::coord::types::RangedCoordf64>,
>;

impl Chart<'_> {
    fn draw<'a>(&self, area: &Area<'a>, names: &Names) -> Result<Context<'a>, ChartError> {
        let count = names.names.len();
        let [low, high] = self.range;
        let mut chart = ChartBuilder::on(area)
            .caption(&self.caption, font(17))
            .margin(12 * FINE)
            .x_label_area_size(names.height * FINE)
            .y_label_area_size(52 * FINE)
            .build_cartesian_2d(-0.5..count as f64 - 0.5, low..high)?;
        chart
            .configure_mesh()
            .disable_x_mesh()
            .x_labels(0)
            .y_labels(self.numbers)
            .y_label_formatter(&|value| ((value * 1e6).round() / 1e6).to_string())
            .light_line_style(TRANSPARENT)
            .bold_line_style(RGBColor(225, 225, 225).stroke_width(FINE))
            .axis_style(RGBColor(90, 90, 90).stroke_width(FINE))
            .label_style(font(13))
            .axis_desc_style(font(14))
            .y_desc(self.unit)
            .set_tick_mark_size(LabelAreaPosition::Left, 5 * FINE)
            .draw()?;
        // The labels of the library cannot begin at the axis when they are upright.
        let style = names.style();
        let labels = names.names.iter().enumerate().map(|(question, name)| {
            let below = (0, 8 * FINE as i32);
            let text = Text::new(name.clone(), below, style.clone());
            EmptyElement::at((question as f64, low)) + text
        });
        chart.draw_series(labels)?;
        Ok(chart)
    }
}

/// A dot with its interval for each question and group.
fn draw_opinions(
    area: &Area<'_>,
    ratings: &Ratings,
    names: &Names,
    confidence: f64,
) -> Result<(), ChartError> {
    let scale = scale(ratings);
    let (least, greatest) = (scale[0], scale[scale.len() - 1]);
    let margin = 0.08 * (greatest - least).max(1.0);
    let (legend_area, charts) = area.split_horizontally(LEGEND * FINE);
    let chart = Chart {
        caption: format!(
            "Mean opinion scores with {} % intervals",
            percent(confidence)
        ),
        unit: "rating",
        range: [least - margin, greatest + margin],
        numbers: 8,
    };
    let mut chart = chart.draw(&charts, names)?;
    let groups = ratings.groups();
    let shown: Vec<Option<&str>> = std::iter::once(None)
        .chain(groups.iter().map(|group| Some(*group)))
        .collect();
    let mut legend = Vec::new();
    for (place, group) in shown.iter().enumerate() {
        let colour = COLOURS[place % COLOURS.len()];
        let offset = HALF_BAR * (2.0 * (place as f64 + 0.5) / shown.len() as f64 - 1.0);
        let found: Vec<(f64, f64, f64)> = (0..ratings.questions().len())
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
        let dots = found.iter();
        let dots =
            dots.map(|(x, mean, _)| Circle::new((*x, *mean), 3 * FINE as i32, colour.filled()));
        chart.draw_series(dots)?;
        legend.push((Mark::Dot, colour, shortened(group.unwrap_or("all"), GROUP)));
    }
    if !groups.is_empty() {
        draw_legend(&legend_area, &legend)?;
    }
    Ok(())
}

/// A bar for each question, with a part for each rating, or each class of ratings.
fn draw_counts(area: &Area<'_>, ratings: &Ratings, names: &Names) -> Result<(), ChartError> {
    let classes = classes(&scale(ratings));
    let count = ratings.questions().len();
    let people = ratings.raters().len();
    let (legend_area, charts) = area.split_horizontally(LEGEND * FINE);
    let chart = Chart {
        caption: "Raters by rating".to_owned(),
        unit: "raters",
        range: [0.0, 1.05 * people as f64],
        // People are counted in whole numbers.
        numbers: (people + 1).min(11),
    };
    let mut chart = chart.draw(&charts, names)?;
    let mut tops = vec![0.0; count];
    let mut legend = Vec::new();
    for (place, class) in classes.iter().enumerate() {
        let part = place as f64 / (classes.len() - 1).max(1) as f64;
        let colour = shade(part);
        let bars = (0..count).map(|question| {
            let found = class.count(&ratings.of_question(question, None)) as f64;
            let (x, bottom) = (question as f64, tops[question]);
            tops[question] += found;
            let corners = [(x - HALF_BAR, bottom), (x + HALF_BAR, bottom + found)];
            Rectangle::new(corners, colour.filled())
        });
        let bars: Vec<_> = bars.collect();
        chart.draw_series(bars)?;
        legend.push((Mark::Bar, colour, class.name()));
    }
    // The greatest rating on top, as in the bars.
    legend.reverse();
    draw_legend(&legend_area, &legend)
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
