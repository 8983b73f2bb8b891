//! Pictures with contours over them, as SVG.

use std::fmt::Write as _;

use anyhow::Result;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use ga_image::plane::Plane;
use ga_image::png;

/// The picture with closed curves over it: those marked as holes in blue, the others in orange,
/// with a white edge.
pub(super) fn svg<'a>(
    picture: &Plane<[u8; 3]>,
    curves: impl Iterator<Item = (&'a [[f64; 2]], bool)>,
) -> Result<String> {
    let (width, height) = (picture.width(), picture.height());
    let encoded = STANDARD.encode(png::encode(picture)?);
    let stroke = (width.max(height) as f64 / 400.0).max(0.75);
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" \
         width=\"{width}\" height=\"{height}\">\n\
         <image width=\"{width}\" height=\"{height}\" href=\"data:image/png;base64,{encoded}\"/>\n\
         <g fill=\"none\" stroke-linejoin=\"round\" transform=\"translate(0.5 0.5)\">\n"
    );
    for (points, is_hole) in curves {
        let colour = if is_hole { "#2f7fd0" } else { "#e8631a" };
        let mut places = String::new();
        for (index, [u, v]) in points.iter().enumerate() {
            let gap = if index == 0 { "" } else { " " };
            let _ = write!(places, "{gap}{},{}", rounded(*u), rounded(*v));
        }
        for (colour, stroke) in [("#ffffff", 2.0 * stroke), (colour, stroke)] {
            let _ = writeln!(
                text,
                "<polygon stroke=\"{colour}\" stroke-width=\"{stroke}\" points=\"{places}\"/>"
            );
        }
    }
    text.push_str("</g>\n</svg>\n");
    Ok(text)
}

/// To hundredths of a pixel.
fn rounded(place: f64) -> f64 {
    (100.0 * place).round() / 100.0
}
