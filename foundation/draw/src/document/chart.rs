//! What charts have in common that are drawn with the crate `plotters`: the picture, colours, fonts
//! and the legend.
//!
//! ```
//! use ga_draw::document::chart::{self, COLOURS, FINE};
//! use plotters::prelude::*;
//!
//! let svg = chart::svg((300, 200), |area| {
//!     let mut chart = ChartBuilder::on(area).build_cartesian_2d(0.0..1.0, 0.0..2.0)?;
//!     let line = [(0.0, 0.0), (1.0, 2.0)];
//!     chart.draw_series(LineSeries::new(line, COLOURS[0].stroke_width(2 * FINE)))?;
//!     Ok(())
//! })?;
//! assert!(svg.starts_with("<svg width=\"300\" height=\"200\" viewBox=\"0 0 2400 1600\""));
//! # Ok::<(), chart::ChartError>(())
//! ```

use std::io;

use plotters::coord::Shift;
use plotters::prelude::*;

/// The factor by which charts are drawn larger, since `plotters` rounds coordinates to whole
/// numbers.
pub const FINE: u32 = 8;

/// Colours that people with any colour vision tell apart (Okabe and Ito, 2008).
pub const COLOURS: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(230, 159, 0),
    RGBColor(60, 60, 60),
];

/// Why a chart cannot be drawn.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ChartError {
    /// The backend fails.
    #[error("cannot draw the chart: {0}")]
    Drawing(#[from] DrawingAreaErrorKind<io::Error>),
    /// The coordinates are so large that their extent is not finite, or there are none.
    #[error("the numbers are too large for a picture")]
    TooLarge,
}

/// A part of a chart, in fine coordinates.
pub type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// A picture of this width and height on white, as SVG. It is drawn in coordinates that are
/// [`FINE`] times as large.
///
/// # Errors
///
/// Those of the drawing.
pub fn svg(
    (width, height): (u32, u32),
    draw: impl FnOnce(&Area<'_>) -> Result<(), ChartError>,
) -> Result<String, ChartError> {
    let mut text = String::new();
    {
        let root = SVGBackend::with_string(&mut text, (width * FINE, height * FINE));
        let root = root.into_drawing_area();
        root.fill(&WHITE)?;
        draw(&root)?;
        root.present()?;
    }
    Ok(shown_small(&text, (width, height)))
}

/// Letters of a height in pixels of the picture as it is shown.
#[must_use]
pub fn font<'a>(height: u32) -> FontDesc<'a> {
    ("sans-serif", height * FINE).into_font()
}

/// A chart that was drawn [`FINE`] times as large, with its width and height as it is shown; the
/// view box keeps the fine coordinates.
fn shown_small(svg: &str, (width, height): (u32, u32)) -> String {
    let size = |factor: u32| {
        format!(
            "width=\"{}\" height=\"{}\"",
            width * factor,
            height * factor
        )
    };
    svg.replacen(&size(FINE), &size(1), 1)
}

/// How a series is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// A line.
    Line,
    /// A dot at each place.
    Dot,
    /// Bars.
    Bar,
}

/// Draws the names of series with their marks one below another, at the left of an area beside the
/// chart.
///
/// # Errors
///
/// Those of the drawing.
pub fn draw_legend(area: &Area<'_>, series: &[(Mark, RGBColor, String)]) -> Result<(), ChartError> {
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
        area.draw(&Text::new(name.as_str(), (fine(34), y - fine(7)), font(13)))?;
    }
    Ok(())
}

/// A text of at most this number of characters, which ends with … where some are left out.
#[must_use]
pub fn shortened(text: &str, most: usize) -> String {
    if text.chars().count() <= most {
        return text.to_owned();
    }
    let start: String = text.chars().take(most.saturating_sub(1)).collect();
    format!("{}…", start.trim_end())
}

/// A text of at most this number of characters, in whose middle … stands for what is left out.
#[must_use]
pub fn shortened_between(text: &str, most: usize) -> String {
    let count = text.chars().count();
    if count <= most {
        return text.to_owned();
    }
    let shown = most.saturating_sub(1);
    let start: String = text.chars().take(shown / 2).collect();
    let end: String = text.chars().skip(count - shown.div_ceil(2)).collect();
    format!("{start}…{end}")
}

#[cfg(test)]
mod tests {
    use super::{shortened, shortened_between};

    #[test]
    fn a_long_text_keeps_its_ends() {
        assert_eq!(shortened_between("über_crf20", 10), "über_crf20");
        assert_eq!(shortened_between("über_0_crf20", 10), "über…crf20");
        assert_eq!(shortened_between("clip", 1), "…");
    }

    #[test]
    fn a_long_text_ends_with_an_ellipsis() {
        assert_eq!(shortened("üben", 4), "üben");
        assert_eq!(shortened("clear pictures", 7), "clear…");
        assert_eq!(shortened("clearness", 7), "clearn…");
    }
}
