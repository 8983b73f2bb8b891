//! Points of a frame in the colours of their parallax.

use crate::comfort::{Dimension, Match, Record, Scale};
use ga_image::file::FormatError;
use ga_image::plane::Plane;

use super::picture::{GAP, HALF, TITLE, Thumbnail, Video, WIDTH, put, some};
use crate::comfort::report::axis::INK;
use crate::comfort::report::kept::Kept;
use crate::comfort::report::moments::Moment;
use crate::comfort::report::words::signed_percent;
use ga_draw::document::{Anchor, Svg, ticks};

/// Room for the scale at the right.
const SCALE: f64 = 110.0;

const POINTS: usize = 400;

/// In front of the screen, on it and behind it.
const COLOURS: [[f64; 3]; 3] = [
    [213.0, 94.0, 0.0],
    [250.0, 250.0, 250.0],
    [0.0, 90.0, 181.0],
];

pub(super) fn draw(
    moment: &Moment,
    dimension: Dimension,
    video: Video<'_>,
) -> Result<Thumbnail, FormatError> {
    let record = &moment.record;
    let before = moment.before.as_ref();
    let records = [before.map(|(record, _)| &**record), Some(&**record)];
    let ends = records.into_iter().flatten().flat_map(|record| {
        let parallax = record.measures.parallax.as_ref();
        parallax.map_or([0.0; 2], |found| {
            [found.near_px, found.far_px].map(|px| found.percent(px))
        })
    });
    let most = ends.fold(0.5, |most: f64, percent| most.max(percent.abs()));
    let ringed = ringed(record, dimension, video);
    let (frame, is_ringed) = match &ringed {
        Some((_, is_ringed)) => (record.frame, is_ringed.as_ref()),
        None => (record.frame, &(|_: f64| false) as &dyn Fn(f64) -> bool),
    };
    let (height, mut svg);
    match before {
        Some((earlier, kept)) => {
            let wide = HALF - 0.5 * SCALE;
            height = kept.height(wide);
            svg = Svg::new([WIDTH, TITLE + height], "Depth of two frames");
            for (x, record, kept) in [
                (0.0, earlier, kept),
                (wide + GAP, &moment.record, &moment.pictures),
            ] {
                let title = format!("frame {}: median {}", record.frame, median(record));
                panel(
                    &mut svg,
                    [x, wide],
                    &title,
                    (record, kept),
                    video,
                    (most, is_ringed),
                )?;
            }
        }
        None => {
            let wide = 620.0;
            height = moment.pictures.height(wide);
            svg = Svg::new(
                [WIDTH, TITLE + height],
                "Points in the colours of their parallax",
            );
            let title = format!("left view of frame {frame}: median {}", median(record));
            let of = (&**record, &*moment.pictures);
            panel(&mut svg, [0.0, wide], &title, of, video, (most, is_ringed))?;
        }
    }
    let x = match before {
        Some(_) => WIDTH - SCALE + 18.0,
        None => 640.0,
    };
    draw_scale(&mut svg, [x, height], most);
    let rings = ringed.map_or(String::new(), |(words, _)| format!(" Ringed: {words}."));
    Ok(Thumbnail {
        svg: svg.into_text(),
        words: format!(
            "Points that both views show, orange in front of the screen and blue behind it; \
             numbers are parallax in per cent of the picture's width.{rings}"
        ),
    })
}

type Condition<'a> = Box<dyn Fn(f64) -> bool + 'a>;

/// The points that are marked, in words, and whether a parallax in per cent is one of them.
fn ringed<'a>(
    record: &'a Record,
    dimension: Dimension,
    video: Video<'a>,
) -> Option<(String, Condition<'a>)> {
    let limit = |sign: f64| {
        let scale = Scale::of(dimension, video.viewing)?;
        Some(
            video
                .viewing
                .parallax_of_degrees(sign * scale.comfortable()),
        )
    };
    let parallax = record.measures.parallax.as_ref()?;
    match dimension {
        Dimension::OverConvergence => {
            let limit = limit(-1.0)?;
            let words = format!(
                "points in front of the limit of comfort, {}",
                signed_percent(limit)
            );
            Some((words, Box::new(move |percent| percent < limit)))
        }
        Dimension::OverDivergence => {
            let limit = limit(1.0)?;
            let words = format!(
                "points behind the limit of comfort, {}",
                signed_percent(limit)
            );
            Some((words, Box::new(move |percent| percent > limit)))
        }
        Dimension::RichDepth => {
            let [near, far] = [parallax.near_px, parallax.far_px].map(|px| parallax.percent(px));
            let words = "the nearest and the farthest 2 % of the points".into();
            Some((
                words,
                Box::new(move |percent| percent <= near || percent >= far),
            ))
        }
        _ => None,
    }
}

fn median(record: &Record) -> String {
    let parallax = record.measures.parallax.as_ref();
    parallax.map_or("not known".into(), |found| {
        signed_percent(found.percent(found.median_px))
    })
}

/// A view in grey with its points.
fn panel(
    svg: &mut Svg,
    [left, wide]: [f64; 2],
    title: &str,
    (record, kept): (&Record, &Kept),
    video: Video<'_>,
    (most, is_ringed): (f64, &dyn Fn(f64) -> bool),
) -> Result<(), FormatError> {
    let [view, _] = kept.views(video.colours);
    // Light grey, so that the colours of points stand out.
    let grey = |[r, g, b]: [u8; 3]| {
        let sum = 2 * u16::from(r) + 5 * u16::from(g) + u16::from(b);
        [(60 + sum / 8 * 5 / 8) as u8; 3]
    };
    let grey: Plane<[u8; 3]> = view.map(grey);
    put(svg, [left, TITLE], [wide, kept.height(wide)], title, &grey)?;
    let percent = |found: &Match| 100.0 * (found.right[0] - found.left[0]) / kept.size[0] as f64;
    let place = |found: &Match| {
        let [x, y] = kept.place(found.left, wide);
        [left + x, TITLE + y]
    };
    let matches = &record.measures.matches;
    for found in some(matches, POINTS) {
        let style = format!(
            "fill=\"{}\" stroke=\"#222\" stroke-width=\"0.7\"",
            colour(percent(found) / most)
        );
        svg.circle(place(found), 4.0, &style);
    }
    for found in matches.iter().filter(|found| is_ringed(percent(found))) {
        svg.circle(
            place(found),
            7.0,
            "fill=\"none\" stroke=\"#fff\" stroke-width=\"3.6\"",
        );
        svg.circle(
            place(found),
            7.0,
            "fill=\"none\" stroke=\"#000\" stroke-width=\"1.8\"",
        );
    }
    Ok(())
}

/// The bar of colours: behind the screen above, in front of it below.
fn draw_scale(svg: &mut Svg, [x, height]: [f64; 2], most: f64) {
    const STEPS: usize = 40;
    const WIDE: f64 = 18.0;
    let (top, tall) = (TITLE + 22.0, height - 44.0);
    for step in 0..STEPS {
        let share = 1.0 - 2.0 * (step as f64 + 0.5) / STEPS as f64;
        let y = top + tall * step as f64 / STEPS as f64;
        let fill = format!("fill=\"{}\"", colour(share));
        svg.rectangle([x, y], [WIDE, tall / STEPS as f64 + 0.5], &fill);
    }
    let ink = format!("fill=\"{INK}\"");
    for percent in ticks([-most, most], 6) {
        let y = top + 0.5 * tall * (1.0 - percent / most);
        svg.line(
            [x + WIDE, y],
            [x + WIDE + 4.0, y],
            &format!("stroke=\"{INK}\""),
        );
        let text = match percent.abs() < 1e-9 {
            true => "screen".into(),
            false => signed_percent(percent),
        };
        svg.text([x + WIDE + 8.0, y + 4.0], 12.0, Anchor::Start, &ink, &text);
    }
    svg.text([x, top - 8.0], 12.0, Anchor::Start, &ink, "behind");
    svg.text(
        [x, top + tall + 16.0],
        12.0,
        Anchor::Start,
        &ink,
        "in front",
    );
}

/// The colour of a parallax as a share of the greatest one.
fn colour(share: f64) -> String {
    let [near, screen, far] = COLOURS;
    let end = if share < 0.0 { near } else { far };
    let share = share.abs().min(1.0);
    let [r, g, b]: [u8; 3] =
        std::array::from_fn(|k| (screen[k] + share * (end[k] - screen[k])).round() as u8);
    format!("#{r:02x}{g:02x}{b:02x}")
}
