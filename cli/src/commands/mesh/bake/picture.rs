//! Maps as pictures.

use ga_image::colour::{LinearColour, SrgbEncoder};
use ga_image::picture::Picture;
use ga_image::plane::Plane;
use ga_mesh::bake::Map;

use super::report::Range;

/// Components from −1 to 1 as codes from 0 to 255.
pub(super) fn of_normals(map: &Map<3>) -> Picture {
    plane(map, |normal| normal.map(|x| code(0.5 * (x + 1.0)))).into()
}

/// Numbers from 0 to 1 as codes from 0 to 255.
pub(super) fn of_shares(map: &Map<1>) -> Picture {
    plane(map, |[share]| code(share)).into()
}

/// Linear light as sRGB.
pub(super) fn of_colours(map: &Map<3>) -> Picture {
    let encoder = SrgbEncoder::new();
    let encode = |colour: [f32; 3]| encoder.encode(LinearColour::from(colour.map(f64::from)));
    plane(map, encode).into()
}

/// Heights as codes from 0 to 65535, and which heights these are.
pub(super) fn of_heights(map: &Map<1>) -> (Picture, Range) {
    let heights = map.texels.iter().map(|[height]| f64::from(*height));
    let minimum = heights.clone().fold(f64::INFINITY, f64::min);
    let maximum = heights.fold(f64::NEG_INFINITY, f64::max);
    let extent = maximum - minimum;
    let step = if extent > 0.0 { 65_535.0 / extent } else { 0.0 };
    let code = |[height]: [f32; 1]| ((f64::from(height) - minimum) * step).round() as u16;
    (plane(map, code).into(), Range { minimum, maximum })
}

fn code(share: f32) -> u8 {
    (255.0 * share).round() as u8
}

fn plane<const C: usize, P>(map: &Map<C>, pixel: impl Fn([f32; C]) -> P) -> Plane<P>
where
    P: Copy,
{
    let width = map.width as usize;
    Plane::from_fn(width, map.height as usize, |column, row| {
        pixel(map.texels[row * width + column])
    })
}
