//! The rows of the table in words for those who make a video.

use crate::comfort::stereoscopy::Stereoscopy;
use crate::comfort::{Dimension, Record, SIZE, Scale, Viewing, meaning};

/// What is wrong in a frame, as a name.
pub(super) fn trouble(record: &Record, dimension: Dimension, viewing: &Viewing) -> &'static str {
    match (dimension, record.stereoscopy) {
        (Dimension::Stereoscopy, Stereoscopy::Exchanged) => "Exchanged views",
        (Dimension::Stereoscopy, Stereoscopy::Identical) => "Views that are the same picture",
        (Dimension::Stereoscopy, Stereoscopy::Unrelated) => "Views of different scenes",
        (Dimension::FocalGap, _) if is_gap_of_size(record, viewing) => "Difference of size",
        _ => dimension.in_words(),
    }
}

/// What is good where a row is green.
pub(super) fn merit(dimension: Dimension) -> &'static str {
    match dimension {
        Dimension::Brightness => "equal brightness",
        Dimension::Colour => "equal colours",
        Dimension::Vertical => "level views",
        Dimension::Asynchrony => "both eyes at the same time",
        Dimension::ParallaxDeviation => "steady depth",
        Dimension::Stereoscopy => "left and right in order",
        Dimension::WeakDepth => "enough depth",
        Dimension::RichDepth => "not too much depth at once",
        Dimension::OverConvergence => "nothing too far in front",
        Dimension::OverDivergence => "nothing too far behind",
        Dimension::FocalGap => "equal sharpness and size",
    }
}

/// A number with this number of decimals and a minus sign, and without −0.
pub(super) fn number(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(zero) if zero.chars().all(|c| matches!(c, '0' | '.')) => zero.to_owned(),
        Some(positive) => format!("−{positive}"),
        None => text,
    }
}

/// A parallax in per cent with its sign.
pub(super) fn signed_percent(percent: f64) -> String {
    let text = number(percent, 1);
    let sign = if percent > 0.0 && text != "0.0" {
        "+"
    } else {
        ""
    };
    format!("{sign}{text} %")
}

/// What a row says, in a sentence.
pub(super) fn explanation(dimension: Dimension) -> &'static str {
    match dimension {
        Dimension::Brightness => {
            "One view is brighter than the other: the difference of luminance at mid grey."
        }
        Dimension::Colour => {
            "One view has another tint than the other: the distance of the colours in CIE L*a*b*, \
             without the difference of brightness."
        }
        Dimension::Vertical => {
            "Points are higher in one view than in the other, since it is shifted, rotated or \
             enlarged: an angle at the eye."
        }
        Dimension::Asynchrony => {
            "One eye sees the action later than the other. It can be measured where something \
             moves."
        }
        Dimension::ParallaxDeviation => {
            "The depth of the whole scene leaves that of the shot before it or around it, so that \
             the eyes have to move: an angle at the eyes."
        }
        Dimension::Stereoscopy => {
            "Each eye has its own view of the same scene. The views can also be exchanged, be the \
             same picture, or show different scenes."
        }
        Dimension::WeakDepth => {
            "Nearly everything has the same distance, so that the picture looks flat. The range \
             from the nearest to the farthest points is stated in per cent of the picture's width."
        }
        Dimension::RichDepth => {
            "The nearest and the farthest points are so far apart that they cannot be seen \
             together without strain: the same range, where too much of it is uncomfortable."
        }
        Dimension::OverConvergence => {
            "Points appear far in front of the screen, so that the eyes squint: the angle by which \
             they converge more than on the screen."
        }
        Dimension::OverDivergence => {
            "Points appear far behind the screen, so that the eyes look nearly parallel or \
             diverge: the angle by which they converge less than on the screen."
        }
        Dimension::FocalGap => {
            "One view is less sharp, or is enlarged, as if it were focused elsewhere: 1 is half \
             the sharpness (a binary logarithm)."
        }
    }
}

/// A raw number with its unit.
pub(super) fn amount(dimension: Dimension, raw: f64) -> String {
    let (decimals, unit) = match dimension {
        Dimension::Brightness => (0, " %"),
        Dimension::Colour => (1, " Δa*b*"),
        Dimension::Vertical => (1, "′"),
        Dimension::ParallaxDeviation => (0, "′"),
        Dimension::Asynchrony => (2, " frames"),
        Dimension::Stereoscopy => (2, ""),
        Dimension::WeakDepth | Dimension::RichDepth => (2, " % of width"),
        Dimension::OverConvergence | Dimension::OverDivergence => (2, "°"),
        Dimension::FocalGap => (2, " log2"),
    };
    number(raw, decimals) + unit
}

/// The limits of a row, as "comfortable up to 5.0′, severe above 20.0′".
pub(super) fn limits(dimension: Dimension, viewing: &Viewing) -> String {
    let Some(scale) = Scale::of(dimension, viewing) else {
        return "it is right or wrong".into();
    };
    let words = |raw: f64| match dimension {
        Dimension::OverConvergence | Dimension::OverDivergence => {
            let sign = if dimension == Dimension::OverConvergence {
                -1.0
            } else {
                1.0
            };
            let percent = sign * viewing.parallax_of_degrees(sign * raw);
            format!(
                "{} ({} % of the width)",
                amount(dimension, raw),
                number(percent, 1)
            )
        }
        Dimension::FocalGap => format!("{} times", number(raw.exp2(), 2)),
        _ => amount(dimension, raw),
    };
    let [comfortable, limit] = [scale.comfortable(), scale.limit()].map(words);
    let size = match dimension {
        Dimension::FocalGap => format!(
            "; difference of size: up to {} %, and above {} %",
            SIZE.comfortable(),
            SIZE.limit()
        ),
        _ => String::new(),
    };
    match scale.comfortable() > scale.limit() {
        true => format!("comfortable from {comfortable}, severe below {limit}"),
        false => format!("comfortable up to {comfortable}, severe above {limit}{size}"),
    }
}

/// "a, b and c".
pub(super) fn listed(names: &[String]) -> String {
    match names {
        [] => String::new(),
        [one] => one.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

/// Whether the focal gap of a frame is one of size rather than of sharpness.
pub(super) fn is_gap_of_size(record: &Record, viewing: &Viewing) -> bool {
    let sharpness = record.measures.sharpness_log2;
    let sharpness = sharpness.zip(Scale::of(Dimension::FocalGap, viewing));
    let sharpness = sharpness.map(|(raw, scale)| scale.score(raw));
    let geometry = record.measures.geometry;
    let size = geometry.map(|geometry| SIZE.score(geometry.zoom_percent));
    size > sharpness
}

/// What is wrong in a frame, in the words of a row.
pub(super) fn finding(record: &Record, dimension: Dimension, viewing: &Viewing) -> String {
    let raw = record.row(dimension).raw.unwrap_or(0.0);
    let measures = &record.measures;
    let amount = |raw: f64| amount(dimension, raw);
    let compared = |raw: f64, [more, less]: [&'static str; 2]| if raw < 0.0 { less } else { more };
    let percent = |pixels: fn(&crate::comfort::Parallax) -> f64| {
        let parallax = measures.parallax.as_ref();
        parallax.map_or(0.0, |found| found.percent(pixels(found)))
    };
    match dimension {
        Dimension::Brightness => {
            let offset = measures.photometry.map_or(0.0, |found| found.offset_codes);
            format!(
                "the right view is {} than the left one by {} ({:.0} of 255 codes)",
                compared(offset, ["brighter", "darker"]),
                amount(raw.abs()),
                offset.abs()
            )
        }
        Dimension::Colour => {
            let text = format!("the tint of the views differs by {}", amount(raw));
            let Some(photometry) = &measures.photometry else {
                return text;
            };
            let [red, green, blue] = photometry.channel_ratios.map(|ratio| 100.0 * ratio);
            format!(
                "{text}; red, green and blue of the right view are {red:.0} %, {green:.0} % and \
                 {blue:.0} % of those of the left one"
            )
        }
        Dimension::Vertical => {
            let Some(geometry) = measures.geometry else {
                return format!("rows differ by {}", amount(raw));
            };
            let parts = [
                (geometry.shift_px, 1, " pixels", ["lower", "higher"]),
                (
                    geometry.rotation_degrees,
                    2,
                    "°",
                    ["rotated counter-clockwise", "rotated clockwise"],
                ),
                (geometry.zoom_percent, 1, " %", ["larger", "smaller"]),
            ];
            let parts = parts
                .into_iter()
                .filter_map(|(value, decimals, unit, names)| {
                    let text = number(value.abs(), decimals);
                    let is_zero = text.chars().all(|c| matches!(c, '0' | '.'));
                    (!is_zero).then(|| format!("{text}{unit} {}", compared(value, names)))
                });
            let parts = listed(&parts.collect::<Vec<_>>());
            let parts = match parts.is_empty() {
                true => String::new(),
                false => format!(": the right view is {parts}"),
            };
            let pixels = number(geometry.deviation_px, 1);
            format!(
                "points differ in height by up to {pixels} pixels ({}){parts}",
                amount(raw)
            )
        }
        Dimension::Asynchrony => format!(
            "the right eye is {} by {}",
            compared(raw, ["late", "early"]),
            amount(raw.abs())
        ),
        Dimension::ParallaxDeviation => {
            let from = match record.begins_shot && record.frame > 0 {
                true => "that of the shot before the cut",
                false => "that of the shot so far",
            };
            format!(
                "the depth of the scene is {} {} {from}",
                amount(raw.abs()),
                compared(raw, ["behind", "in front of"]),
            )
        }
        Dimension::Stereoscopy => meaning(record.stereoscopy).into(),
        Dimension::WeakDepth => format!(
            "from the nearest to the farthest points there are only {}",
            amount(raw)
        ),
        Dimension::RichDepth => format!(
            "from the nearest points ({}) to the farthest ones ({}) there are {}",
            signed_percent(percent(|found| found.near_px)),
            signed_percent(percent(|found| found.far_px)),
            amount(raw)
        ),
        Dimension::OverConvergence => format!(
            "the nearest points are in front of the screen by {} % of the picture's width ({})",
            number(-percent(|found| found.near_px), 1),
            amount(raw)
        ),
        Dimension::OverDivergence => format!(
            "the farthest points are behind the screen by {} % of the picture's width ({})",
            number(percent(|found| found.far_px), 1),
            amount(raw)
        ),
        Dimension::FocalGap if is_gap_of_size(record, viewing) => {
            let zoom = measures.geometry.map_or(0.0, |found| found.zoom_percent);
            format!(
                "the right view is {:.1} % {} than the left one",
                zoom.abs(),
                compared(zoom, ["larger", "smaller"])
            )
        }
        Dimension::FocalGap => {
            let gap = measures.sharpness_log2.unwrap_or(raw);
            format!(
                "the right view is {:.1} times {} the left one",
                gap.abs().exp2(),
                compared(gap, ["as sharp as", "less sharp than"])
            )
        }
    }
}

/// Whether `nullcone video align` removes what is wrong in a frame.
pub(super) fn can_align(record: &Record, dimension: Dimension, viewing: &Viewing) -> bool {
    match dimension {
        Dimension::Brightness | Dimension::Colour | Dimension::Vertical | Dimension::Asynchrony => {
            true
        }
        Dimension::Stereoscopy => record.stereoscopy == Stereoscopy::Exchanged,
        Dimension::FocalGap => is_gap_of_size(record, viewing),
        Dimension::ParallaxDeviation
        | Dimension::WeakDepth
        | Dimension::RichDepth
        | Dimension::OverConvergence
        | Dimension::OverDivergence => false,
    }
}

/// What to do about it.
pub(super) fn advice(
    record: &Record,
    dimension: Dimension,
    viewing: &Viewing,
    shots: usize,
) -> &'static str {
    if can_align(record, dimension, viewing) {
        return match dimension {
            Dimension::Asynchrony => {
                "“nullcone video align” removes whole frames of delay; parts of a frame remain."
            }
            _ => "“nullcone video align” removes it.",
        };
    }
    match dimension {
        Dimension::ParallaxDeviation if shots > 1 => {
            "Shift the views of one of the shots horizontally, or let the depth change slowly \
             before the cut."
        }
        Dimension::ParallaxDeviation => {
            "Let the depth of the scene change more slowly: the eyes need time to follow."
        }
        Dimension::Stereoscopy => "Look for the file of the other view: this one does not fit.",
        Dimension::WeakDepth => {
            "It does not strain the eyes, but the video gains little from being stereoscopic: take \
             the cameras farther apart."
        }
        Dimension::RichDepth => {
            "Take the cameras nearer to each other, or leave out what is nearest or farthest. A \
             horizontal shift of the views does not help."
        }
        Dimension::OverConvergence => {
            "Shift the views horizontally, the left one to the left and the right one to the \
             right, which moves everything back, as far as the background allows."
        }
        Dimension::OverDivergence => {
            "Shift the views horizontally, the left one to the right and the right one to the \
             left, which moves everything forward, as far as the foreground allows."
        }
        _ => "Blur cannot be undone: take the sharper view again, or focus both cameras alike.",
    }
}

#[cfg(test)]
mod tests {
    use crate::comfort::{Dimension, Viewing};

    use super::{limits, listed, number, signed_percent};

    #[test]
    fn numbers_have_a_minus_sign_and_no_negative_zero() {
        assert_eq!(number(-1.25, 2), "−1.25");
        assert_eq!(number(-0.04, 1), "0.0");
        assert_eq!(number(-0.4, 0), "0");
        assert_eq!(signed_percent(2.04), "+2.0 %");
        assert_eq!(signed_percent(-2.04), "−2.0 %");
        assert_eq!(signed_percent(0.04), "0.0 %");
    }

    #[test]
    fn names_are_joined() {
        let names = ["a", "b", "c"].map(str::to_owned);
        let all = (0..=3).map(|count| listed(&names[..count]));
        assert_eq!(all.collect::<Vec<_>>(), ["", "a", "a and b", "a, b and c"]);
    }

    /// By the small angle: a degree is 100 · 2055 mm · tan 1° / 1218 mm = 2.9 % of the width.
    #[test]
    fn limits_of_depth_are_parts_of_the_width_too() {
        let text = limits(Dimension::OverConvergence, &Viewing::default());
        assert!(
            text.starts_with("comfortable up to 1.00° (2.9 % of the width)"),
            "{text}"
        );
        let text = limits(Dimension::WeakDepth, &Viewing::default());
        assert!(text.starts_with("comfortable from 0.50 %"), "{text}");
    }
}
