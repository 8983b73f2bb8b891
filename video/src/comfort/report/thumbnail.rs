//! Pictures of the worst moments with what is wrong drawn into them.

mod depth;
mod picture;

use crate::comfort::Dimension;
use crate::comfort::stereoscopy::Stereoscopy;
use ga_image::file::FormatError;
use ga_image::plane::Plane;
use ga_image::png;
pub(super) use picture::{Thumbnail, Video};

use picture::{GAP, HALF, THIRD, TITLE, WIDTH, put, put_title, some};

use super::axis::INK;
use super::kept::Kept;
use super::moments::Moment;
use super::words;
use ga_draw::document::{Anchor, Svg};

/// Draws what is wrong in the row of a moment.
pub(super) fn draw(
    moment: &Moment,
    dimension: Dimension,
    video: Video<'_>,
) -> Result<Thumbnail, FormatError> {
    match dimension {
        Dimension::Brightness | Dimension::Colour => checks(moment, video),
        Dimension::Vertical => heights(moment, video),
        Dimension::FocalGap if words::is_gap_of_size(&moment.record, video.viewing) => {
            heights(moment, video)
        }
        Dimension::FocalGap => details(moment, video),
        Dimension::Asynchrony => times(moment, video),
        Dimension::Stereoscopy => eyes(moment, video),
        Dimension::ParallaxDeviation
        | Dimension::WeakDepth
        | Dimension::RichDepth
        | Dimension::OverConvergence
        | Dimension::OverDivergence => depth::draw(moment, dimension, video),
    }
}

/// Both views beside each other; points joined by level lines, and how much higher or lower they
/// are in the right view, exaggerated.
fn heights(moment: &Moment, video: Video<'_>) -> Result<Thumbnail, FormatError> {
    const POINTS: usize = 30;
    /// The length that the largest differences have in the picture.
    const LONG: f64 = 40.0;
    let kept = &moment.pictures;
    let height = kept.height(HALF);
    let mut svg = Svg::new([WIDTH, TITLE + height], "Both views with matched points");
    let right = WIDTH - HALF;
    let views = kept.views(video.colours);
    for (x, title, view) in [
        (0.0, "left view", &views[0]),
        (right, "right view", &views[1]),
    ] {
        put(&mut svg, [x, TITLE], [HALF, height], title, view)?;
    }
    let matches = &moment.record.measures.matches;
    let deviation = moment
        .record
        .measures
        .geometry
        .map_or(0.0, |found| found.deviation_px);
    let factor = exaggeration(deviation * kept.pixel_height() * kept.scale(HALF), LONG);
    for found in some(matches, POINTS) {
        let [x, y] = kept.place(found.left, HALF);
        let [u, v] = kept.place(found.right, HALF);
        let (left, level) = ([x, TITLE + y], [right + u, TITLE + y]);
        let end = (TITLE + y + factor * (v - y)).clamp(TITLE, TITLE + height);
        svg.line(
            left,
            level,
            "stroke=\"#fff\" stroke-width=\"1.2\" stroke-opacity=\"0.75\"",
        );
        svg.circle(
            left,
            3.5,
            "fill=\"#56b4e9\" stroke=\"#000\" stroke-width=\"0.8\"",
        );
        arrow(&mut svg, level, [level[0], end]);
        svg.circle(
            level,
            2.5,
            "fill=\"#fff\" stroke=\"#000\" stroke-width=\"0.8\"",
        );
    }
    Ok(Thumbnail {
        svg: svg.into_text(),
        words: format!(
            "Points of the left view (blue) are joined by level lines to where the right view \
             should show them. Arrows lead from there towards where it does; they are {factor} \
             times as long as the difference of height."
        ),
    })
}

/// The factor of a round number by which a length becomes about `long`.
fn exaggeration(length: f64, long: f64) -> f64 {
    const FACTORS: [f64; 9] = [1.0, 2.0, 3.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0];
    let least = FACTORS
        .into_iter()
        .rev()
        .find(|factor| factor * length <= long);
    least.unwrap_or(1.0)
}

/// An arrow with a white border, so that it is seen on any picture.
fn arrow(svg: &mut Svg, from: [f64; 2], to: [f64; 2]) {
    let down = if to[1] >= from[1] { 1.0 } else { -1.0 };
    let length = (to[1] - from[1]).abs();
    if length < 2.0 {
        return;
    }
    let head = 7.0_f64.min(length);
    let neck = [to[0], to[1] - down * head];
    svg.line(from, neck, "stroke=\"#fff\" stroke-width=\"5\"");
    svg.line(from, neck, "stroke=\"#d55e00\" stroke-width=\"2.6\"");
    let corners = [to, [to[0] - 5.0, neck[1]], [to[0] + 5.0, neck[1]], to];
    svg.path(
        corners,
        "fill=\"#d55e00\" stroke=\"#fff\" stroke-width=\"1\"",
    );
}

/// Squares of the left and of the right view in turn, in one picture.
fn checks(moment: &Moment, video: Video<'_>) -> Result<Thumbnail, FormatError> {
    const ACROSS: usize = 8;
    /// For what the right view does not show.
    const HIDDEN: [u8; 3] = [128; 3];
    const WIDE: f64 = 720.0;
    let kept = &moment.pictures;
    let [left, right] = kept.views(video.colours);
    let height = kept.height(WIDE);
    let side = left.width().div_ceil(ACROSS).max(1);
    // The right view is moved by the median parallax, so that most of it fits.
    let parallax = moment.record.measures.parallax.as_ref();
    let moved = parallax.map_or(0.0, |found| found.median_px) * kept.scale(left.width() as f64);
    let moved = moved.round() as i64;
    // The rows of a square that is shown.
    let rows = ((side as f64 / kept.pixel_height()).round() as usize).max(1);
    let is_right = |column: usize, row: usize| (column / side + row / rows) % 2 == 1;
    let mixed = Plane::from_fn(left.width(), left.height(), |column, row| {
        match is_right(column, row) {
            true => {
                let place = usize::try_from(column as i64 + moved).ok();
                let seen = place.and_then(|place| right.get(place, row));
                seen.unwrap_or(HIDDEN)
            }
            false => left.row(row)[column],
        }
    });
    let mut svg = Svg::new([WIDTH, TITLE + height], "Squares of both views in turn");
    put(
        &mut svg,
        [0.0, TITLE],
        [WIDE, height],
        "squares of both views in turn",
        &mixed,
    )?;
    let shown = [
        WIDE * side as f64 / left.width() as f64,
        height * rows as f64 / left.height() as f64,
    ];
    for row in 0..left.height().div_ceil(rows) {
        for column in 0..left.width().div_ceil(side) {
            let corner = [column as f64 * shown[0], TITLE + row as f64 * shown[1]];
            let name = if (column + row) % 2 == 1 { "R" } else { "L" };
            let style = "fill=\"#fff\" stroke=\"#000\" stroke-width=\"2.5\" paint-order=\"stroke\"";
            let place = [corner[0] + 5.0, corner[1] + 15.0];
            if place[1] < TITLE + height {
                svg.text(place, 12.0, Anchor::Start, style, name);
            }
        }
    }
    // Mean colours where both views show the same points.
    let means = mean_colours(moment, [&left, &right]);
    let x = WIDE + 30.0;
    let tall = (0.36 * height).min(150.0);
    for (k, (name, mean)) in ["left", "right"].into_iter().zip(means).enumerate() {
        let [r, g, b] = mean.map(|code| code.round() as u8);
        let y = TITLE + tall * k as f64;
        svg.rectangle([x, y], [130.0, tall], &format!("fill=\"rgb({r},{g},{b})\""));
        let ink = format!("fill=\"{INK}\"");
        svg.text(
            [x + 140.0, y + 0.5 * tall - 8.0],
            13.0,
            Anchor::Start,
            &ink,
            name,
        );
        for (line, (letter, code)) in ["R", "G", "B"].into_iter().zip([r, g, b]).enumerate() {
            let place = [x + 140.0, y + 0.5 * tall + 9.0 + 15.0 * line as f64];
            svg.text(
                place,
                12.0,
                Anchor::Start,
                &ink,
                &format!("{letter} {code}"),
            );
        }
    }
    put_title(&mut svg, [x, TITLE], "mean colours");
    Ok(Thumbnail {
        svg: svg.into_text(),
        words:
            "Squares come from the left view (L) and from the right one (R) in turn: where they \
             stand out, brightness or colour differ. Grey is what the right view does not show. At \
             the right, the mean colours of points that both views show, in codes from 0 to 255."
                .into(),
    })
}

/// The mean colours of the matched points in both reduced views.
fn mean_colours(moment: &Moment, views: [&Plane<[u8; 3]>; 2]) -> [[f64; 3]; 2] {
    let matches = &moment.record.measures.matches;
    let mut means = [[0.0; 3]; 2];
    for found in matches {
        for (side, place) in [found.left, found.right].into_iter().enumerate() {
            let view = views[side];
            let [column, row] = moment.pictures.reduced(place);
            for (mean, code) in means[side].iter_mut().zip(view.row(row)[column]) {
                *mean += f64::from(code) / matches.len() as f64;
            }
        }
    }
    means
}

/// The surroundings of a point in both views at full size, and where they are.
fn details(moment: &Moment, video: Video<'_>) -> Result<Thumbnail, FormatError> {
    let kept = &moment.pictures;
    let Some((place, details)) = kept.detail(video.colours) else {
        return both(kept, video, ["left view", "right view"]);
    };
    let [columns, rows] = [details[0].width() as f64, details[0].height() as f64];
    let height = kept.height(THIRD);
    let tall = THIRD * kept.pixel_height() * rows / columns;
    let mut svg = Svg::new(
        [WIDTH, TITLE + height.max(tall)],
        "A part of both views, enlarged",
    );
    let [left, _] = kept.views(video.colours);
    put(&mut svg, [0.0, TITLE], [THIRD, height], "left view", &left)?;
    let scale = kept.scale(THIRD);
    let [x, y] = kept.place(place, THIRD);
    let size = [columns * scale, kept.pixel_height() * rows * scale];
    let corner = [x - 0.5 * size[0], TITLE + y - 0.5 * size[1]];
    svg.rectangle(
        corner,
        size,
        "fill=\"none\" stroke=\"#fff\" stroke-width=\"4\"",
    );
    svg.rectangle(
        corner,
        size,
        "fill=\"none\" stroke=\"#d55e00\" stroke-width=\"2\"",
    );
    for (k, (title, detail)) in ["this part of the left view", "of the right view"]
        .into_iter()
        .zip(&details)
        .enumerate()
    {
        let x = (THIRD + GAP) * (k + 1) as f64;
        // Without loss, since sharpness is to be judged.
        let bytes = png::encode(detail)?;
        svg.picture([x, TITLE], [THIRD, tall], ("png", &bytes), "");
        put_title(&mut svg, [x, TITLE], title);
    }
    Ok(Thumbnail {
        svg: svg.into_text(),
        words: format!(
            "The framed part around column {:.0}, row {:.0} in both views, pixel by pixel and \
             enlarged: edges are wider in the view that is less sharp.",
            place[0], place[1]
        ),
    })
}

/// What both eyes see at the same time, and the right view that belongs to the left one.
fn times(moment: &Moment, video: Video<'_>) -> Result<Thumbnail, FormatError> {
    let kept = &moment.pictures;
    let frame = kept.frame;
    let delay = moment
        .record
        .asynchrony
        .delay()
        .map_or(0.0, |delay| delay.frames);
    let Some(partner) = &moment.partner else {
        return both(kept, video, ["left eye", "right eye at the same time"]);
    };
    let height = kept.height(THIRD);
    let mut svg = Svg::new([WIDTH, TITLE + height], "Frames of both eyes");
    let [left, right] = kept.views(video.colours);
    let [_, later] = partner.views(video.colours);
    for (k, (title, picture)) in [
        (format!("left, frame {frame}"), left),
        (
            format!("right, frame {frame}: {delay:+.1} frames late"),
            right,
        ),
        (
            format!("right, frame {}: belongs to the left", partner.frame),
            later,
        ),
    ]
    .iter()
    .enumerate()
    {
        let x = (THIRD + GAP) * k as f64;
        put(&mut svg, [x, TITLE], [THIRD, height], title, picture)?;
    }
    Ok(Thumbnail {
        svg: svg.into_text(),
        words: format!(
            "What the left and the right eye see in frame {frame}, and the frame of the right eye \
             whose action is that of the left one."
        ),
    })
}

/// Both views with the eyes that see them.
fn eyes(moment: &Moment, video: Video<'_>) -> Result<Thumbnail, FormatError> {
    let titles = match moment.record.stereoscopy {
        Stereoscopy::Exchanged => [
            "shown to the left eye; belongs to the right one",
            "shown to the right eye; belongs to the left one",
        ],
        Stereoscopy::Identical => ["shown to the left eye", "shown to the right eye: the same"],
        _ => ["shown to the left eye", "shown to the right eye"],
    };
    both(&moment.pictures, video, titles)
}

fn both(kept: &Kept, video: Video<'_>, titles: [&str; 2]) -> Result<Thumbnail, FormatError> {
    let height = kept.height(HALF);
    let mut svg = Svg::new([WIDTH, TITLE + height], "Both views");
    let views = kept.views(video.colours);
    for ((x, title), view) in [0.0, WIDTH - HALF].into_iter().zip(titles).zip(&views) {
        put(&mut svg, [x, TITLE], [HALF, height], title, view)?;
    }
    Ok(Thumbnail {
        svg: svg.into_text(),
        words: "Both views as the video has them.".into(),
    })
}

#[cfg(test)]
mod tests {
    use super::exaggeration;

    #[test]
    fn lengths_are_exaggerated_by_round_numbers() {
        assert_eq!(exaggeration(3.0, 34.0), 10.0);
        assert_eq!(exaggeration(40.0, 34.0), 1.0);
        assert_eq!(exaggeration(0.0, 34.0), 200.0);
    }
}
