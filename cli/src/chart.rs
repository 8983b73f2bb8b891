//! What charts have in common.

use plotters::style::RGBColor;

/// Charts are drawn so many times larger, since the library rounds coordinates to whole numbers.
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
