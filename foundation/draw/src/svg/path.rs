//! Numbers and paths as text.

use std::fmt::Write as _;

use crate::camera::Pixel;

pub(super) fn outlines(regions: &[Vec<Pixel>]) -> String {
    regions.iter().map(|points| line(points, true)).collect()
}

/// The data of a path through points, to a tenth of a pixel.
pub(super) fn line(points: &[Pixel], closed: bool) -> String {
    let mut text = String::new();
    for (k, [x, y]) in points.iter().enumerate() {
        let letter = match k {
            0 => "M",
            1 => "L",
            _ => " ",
        };
        let _ = write!(text, "{letter}{} {}", number(*x), number(*y));
    }
    if closed {
        text.push('Z');
    }
    text
}

/// A number to a tenth.
pub(super) fn number(x: f64) -> String {
    decimals(x, 10.0)
}

/// A number to a thousandth.
pub(super) fn number3(x: f64) -> String {
    decimals(x, 1e3)
}

fn decimals(x: f64, parts: f64) -> String {
    // Coordinates far outside the picture are never seen, and renderers reject large numbers.
    let x = if x.is_finite() {
        x.clamp(-1e6, 1e6)
    } else {
        0.0
    };
    // Adding zero turns a negative zero into zero.
    ((x * parts).round() / parts + 0.0).to_string()
}
