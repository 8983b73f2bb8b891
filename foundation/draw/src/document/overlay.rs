//! Closed curves over a picture.

use std::fmt::Write;

use base64::Engine;
use base64::prelude::BASE64_STANDARD;

/// A closed curve over a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outline<'a> {
    /// The corners in pixels: to the right and down from the centre of the top left pixel.
    pub points: &'a [[f64; 2]],
    /// The colour of the line, as SVG has it.
    pub colour: &'a str,
}

/// A picture of `width` × `height` pixels, encoded as PNG, with closed curves over it as SVG. The
/// curves have white edges, so that they are seen on any ground.
///
/// ```
/// use ga_draw::document::{Outline, overlay};
///
/// let points = [[1.0, 1.0], [6.0, 1.0], [6.0, 4.0]];
/// let svg = overlay(b"\x89PNG", [8, 6], [Outline { points: &points, colour: "#e8631a" }]);
/// assert!(svg.contains("viewBox=\"0 0 8 6\"") && svg.contains("points=\"1,1 6,1 6,4\""));
/// ```
#[must_use]
pub fn overlay<'a>(
    png: &[u8],
    [width, height]: [usize; 2],
    outlines: impl IntoIterator<Item = Outline<'a>>,
) -> String {
    let encoded = BASE64_STANDARD.encode(png);
    let stroke = (width.max(height) as f64 / 400.0).max(0.75);
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" \
         width=\"{width}\" height=\"{height}\">\n\
         <image width=\"{width}\" height=\"{height}\" href=\"data:image/png;base64,{encoded}\"/>\n\
         <g fill=\"none\" stroke-linejoin=\"round\" transform=\"translate(0.5 0.5)\">\n"
    );
    for Outline { points, colour } in outlines {
        let place = |[u, v]: &[f64; 2]| format!("{},{}", rounded(*u), rounded(*v));
        let places: Vec<String> = points.iter().map(place).collect();
        let places = places.join(" ");
        for (colour, stroke) in [("#ffffff", 2.0 * stroke), (colour, stroke)] {
            let _ = writeln!(
                text,
                "<polygon stroke=\"{colour}\" stroke-width=\"{stroke}\" points=\"{places}\"/>"
            );
        }
    }
    text.push_str("</g>\n</svg>\n");
    text
}

/// To hundredths of a pixel.
fn rounded(place: f64) -> f64 {
    (100.0 * place).round() / 100.0
}
