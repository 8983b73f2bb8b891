//! What charts have in common.

use anyhow::Result;
use plotters::coord::Shift;
use plotters::prelude::*;

/// The factor by which charts are drawn larger, since the library rounds coordinates to whole
/// numbers.
pub(crate) const FINE: u32 = 8;

/// Colours that people with any colour vision tell apart (Okabe and Ito, 2008).
pub(crate) const COLOURS: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(230, 159, 0),
    RGBColor(60, 60, 60),
];

/// A chart that was drawn [`FINE`] times as large, with its width and height as it is shown; the
/// view box keeps the fine coordinates.
pub(crate) fn shown_small(svg: &str, (width, height): (u32, u32)) -> String {
    let size = |factor: u32| {
        format!(
            "width=\"{}\" height=\"{}\"",
            width * factor,
            height * factor
        )
    };
    svg.replacen(&size(FINE), &size(1), 1)
}

/// A part of a chart, in fine coordinates.
pub(crate) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// How a series is drawn.
#[derive(Clone, Copy)]
pub(crate) enum Mark {
    Line,
    Dot,
    Bar,
}

/// Draws the names of series with their marks one below another, at the left of an area beside the
/// chart.
pub(crate) fn draw_legend(area: &Area<'_>, series: &[(Mark, RGBColor, String)]) -> Result<()> {
    let fine = |pixels: usize| (pixels * FINE as usize) as i32;
    for (place, (mark, colour, name)) in series.iter().enumerate() {
        let y = fine(24 + 22 * place);
        match mark {
            Mark::Line => {
                let ends = vec![(fine(2), y), (fine(26), y)];
                area.draw(&PathElement::new(ends, colour.stroke_width(3 * FINE)))?;
            }
            Mark::Dot => area.draw(&Circle::new((fine(16), y), fine(4), colour.filled()))?,
            Mark::Bar => {
                let corners = [(fine(11), y - fine(5)), (fine(22), y + fine(5))];
                area.draw(&Rectangle::new(corners, colour.filled()))?;
            }
        }
        let font = ("sans-serif", 13 * FINE).into_font();
        area.draw(&Text::new(name.as_str(), (fine(34), y - fine(7)), font))?;
    }
    Ok(())
}

/// A text of at most this number of characters, which ends with … where some are left out.
pub(crate) fn shortened(text: &str, most: usize) -> String {
    if text.chars().count() <= most {
        return text.to_owned();
    }
    let start: String = text.chars().take(most.saturating_sub(1)).collect();
    format!("{}…", start.trim_end())
}

#[cfg(test)]
mod tests {
    use super::shortened;

    #[test]
    fn a_long_text_ends_with_an_ellipsis() {
        assert_eq!(shortened("üben", 4), "üben");
        assert_eq!(shortened("clear pictures", 7), "clear…");
        assert_eq!(shortened("clearness", 7), "clearn…");
    }
}
