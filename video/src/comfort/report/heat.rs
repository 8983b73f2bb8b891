//! The scores of all rows over time as colours.

use crate::comfort::{Dimension, Level, RowSummary, Score, Summary, Timeline};

use super::axis::{FAINT, INK, LEFT, RIGHT, TimeAxis, WIDTH};
use ga_draw::document::Tint;
use ga_draw::document::{Anchor, Svg};

/// The height of a row, and of its upper part, which shows the worst frame.
const ROW: f64 = 28.0;
const UPPER: f64 = 9.0;
const TOP: f64 = 34.0;

/// What the rows show over an interval.
#[derive(Clone, Copy, PartialEq)]
enum Cell {
    /// The mean score, rounded, and the worst one.
    Scores(u8, u8),
    NotMeasurable,
    Unknown,
}

impl Cell {
    fn of(row: &RowSummary) -> Self {
        match (row.mean_score(), row.worst) {
            // A cast from float saturates.
            (Some(mean), Some((worst, _))) => Self::Scores(mean.round() as u8, worst),
            _ if row.unknown() > row.not_measurable() => Self::Unknown,
            _ => Self::NotMeasurable,
        }
    }
}

/// The picture: a row for each quantity, time to the right.
pub(super) fn svg(timeline: &Timeline, summary: &Summary) -> String {
    let axis = TimeAxis::new(timeline);
    let bottom = TOP + ROW * Dimension::ALL.len() as f64;
    let mut svg = Svg::new([WIDTH, bottom + 84.0], "Scores of all checks over time");
    svg.raw(
        "<defs><pattern id=\"unknown\" width=\"6\" height=\"6\" patternUnits=\"userSpaceOnUse\" \
         patternTransform=\"rotate(45)\"><rect width=\"6\" height=\"6\" fill=\"#fff\"/>\
         <rect width=\"2\" height=\"6\" fill=\"#8a93a0\"/></pattern></defs>\n",
    );
    let ink = format!("fill=\"{INK}\"");
    let faint = format!("fill=\"{FAINT}\"");
    for (x, anchor, text) in [
        (LEFT, Anchor::Start, "shots begin at the dashed lines"),
        (RIGHT + 38.0, Anchor::Middle, "mean"),
        (RIGHT + 92.0, Anchor::Middle, "worst"),
    ] {
        if !(anchor == Anchor::Start && axis.cuts().is_empty()) {
            svg.text([x, TOP - 12.0], 12.0, anchor, &faint, text);
        }
    }
    for (number, dimension) in Dimension::ALL.into_iter().enumerate() {
        let top = TOP + ROW * number as f64;
        let middle = top + 0.5 * ROW + 4.5;
        svg.text(
            [LEFT - 10.0, middle],
            13.0,
            Anchor::End,
            &ink,
            dimension.in_words(),
        );
        let cells: Vec<Cell> = timeline
            .intervals()
            .iter()
            .map(|interval| Cell::of(interval.summary.row(dimension)))
            .collect();
        draw_row(&mut svg, axis, top, &cells);
        draw_totals(&mut svg, summary.row(dimension), middle);
    }
    axis.draw_cuts(&mut svg, [TOP - 8.0, bottom]);
    axis.draw(&mut svg, bottom);
    draw_key(&mut svg, bottom + 54.0);
    svg.into_text()
}

/// Equal neighbours are one rectangle, with the number in it where there is room.
fn draw_row(svg: &mut Svg, axis: TimeAxis<'_>, top: f64, cells: &[Cell]) {
    let mut start = 0;
    for run in cells.chunk_by(|a, b| a == b) {
        let end = start + run.len();
        let (x, width) = (axis.start(start), axis.start(end) - axis.start(start));
        start = end;
        let size = [width, ROW - 2.0];
        match run[0] {
            Cell::Scores(mean, worst) => {
                draw_score(svg, [x, top + 1.0], size, mean);
                if worst != mean {
                    let fill = format!("fill=\"{}\"", colour(f64::from(worst)));
                    svg.rectangle([x, top + 1.0], [width, UPPER], &fill);
                }
                if width >= 16.0 {
                    let y = top + if worst == mean { 18.5 } else { 22.5 };
                    let fill = format!("fill=\"{}\"", ink_on(mean));
                    let place = [x + 0.5 * width, y];
                    svg.text(place, 12.0, Anchor::Middle, &fill, &mean.to_string());
                }
            }
            Cell::NotMeasurable => svg.rectangle([x, top + 1.0], size, "fill=\"#dcdee4\""),
            Cell::Unknown => svg.rectangle([x, top + 1.0], size, "fill=\"url(#unknown)\""),
        }
    }
}

/// The mean and the worst score of the whole video.
fn draw_totals(svg: &mut Svg, row: &RowSummary, y: f64) {
    let mean = row.mean_score();
    let texts = [
        mean.map_or("–".into(), |mean| format!("{mean:.1}")),
        row.worst.map_or("–".into(), |(worst, _)| worst.to_string()),
    ];
    let fill = format!("fill=\"{INK}\"");
    for (x, text) in [RIGHT + 38.0, RIGHT + 92.0].into_iter().zip(texts) {
        svg.text([x, y], 13.0, Anchor::Middle, &fill, &text);
    }
}

fn draw_score(svg: &mut Svg, place: [f64; 2], size: [f64; 2], score: u8) {
    let fill = format!("fill=\"{}\"", colour(f64::from(score)));
    svg.rectangle(place, size, &fill);
}

/// What the colours mean.
fn draw_key(svg: &mut Svg, y: f64) {
    const SIDE: f64 = 22.0;
    let ink = format!("fill=\"{INK}\"");
    for score in 0..=15_u8 {
        let x = LEFT + SIDE * f64::from(score);
        draw_score(svg, [x, y], [SIDE, 16.0], score);
        let fill = format!("fill=\"{}\"", ink_on(score));
        let place = [x + 0.5 * SIDE, y + 12.0];
        svg.text(place, 11.0, Anchor::Middle, &fill, &score.to_string());
    }
    svg.text([LEFT - 10.0, y + 12.0], 12.0, Anchor::End, &ink, "score");
    for (scores, text) in [
        (0..=7, "comfortable"),
        (8..=13, "strains"),
        (14..=15, "severe"),
    ] {
        let middle = 0.5 * f64::from(scores.start() + scores.end() + 1);
        let place = [LEFT + SIDE * middle, y + 29.0];
        svg.text(place, 12.0, Anchor::Middle, &ink, text);
    }
    for (x, fill, text) in [
        (565.0, "#dcdee4", "not measurable"),
        (700.0, "url(#unknown)", "unknown"),
    ] {
        svg.rectangle(
            [x, y],
            [SIDE, 16.0],
            &format!("fill=\"{fill}\" stroke=\"#8a93a0\" stroke-width=\"0.5\""),
        );
        svg.text([x + SIDE + 6.0, y + 12.5], 12.0, Anchor::Start, &ink, text);
    }
}

/// The colour of a score: bluish greens, oranges and dark reds, darker from level to level, so that
/// the levels differ in lightness too.
pub(super) fn colour(score: f64) -> String {
    const GREEN: [[f64; 3]; 2] = [[233.0, 247.0, 240.0], [150.0, 214.0, 187.0]];
    const ORANGE: [[f64; 3]; 2] = [[255.0, 205.0, 105.0], [232.0, 134.0, 0.0]];
    const RED: [[f64; 3]; 2] = [[163.0, 38.0, 27.0], [96.0, 12.0, 10.0]];
    let ([from, to], share) = if score < 7.5 {
        (GREEN, score / 7.0)
    } else if score < 13.5 {
        (ORANGE, (score - 8.0) / 5.0)
    } else {
        (RED, score - 14.0)
    };
    let share = share.clamp(0.0, 1.0);
    let mixed: [u8; 3] =
        std::array::from_fn(|k| (from[k] + share * (to[k] - from[k])).round() as u8);
    format!("#{:02x}{:02x}{:02x}", mixed[0], mixed[1], mixed[2])
}

fn ink_on(score: u8) -> &'static str {
    match Score::new(score).level() {
        Level::Green | Level::Orange => "#1d232b",
        Level::Red => "#fff",
    }
}

/// The colour of a mean score in a table.
pub(super) fn tint(level: Level) -> Tint {
    match level {
        Level::Green => Tint::Green,
        Level::Orange => Tint::Orange,
        Level::Red => Tint::Red,
    }
}
