//! Maps as pictures.

use ga_image::colour::{LinearColour, SrgbEncoder};
use ga_image::picture::Picture;
use ga_image::plane::Plane;
use ga_mesh::bake::Map;
use serde::Serialize;

/// What the numbers of a displacement map mean: code 0 is the minimum and code 65535 the maximum,
/// in the unit of the meshes, and codes between are linear.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct HeightRange {
    /// The height of code 0.
    pub minimum: f64,
    /// The height of code 65535.
    pub maximum: f64,
}

/// Components from −1 to 1 as codes from 0 to 255.
#[must_use]
pub fn normal_picture(map: &Map<3>) -> Picture {
    plane(map, |normal| normal.map(|x| code(0.5 * (x + 1.0)))).into()
}

/// Numbers from 0 to 1 as codes from 0 to 255.
#[must_use]
pub fn share_picture(map: &Map<1>) -> Picture {
    plane(map, |[share]| code(share)).into()
}

/// Linear light as sRGB.
#[must_use]
pub fn colour_picture(map: &Map<3>) -> Picture {
    let encoder = SrgbEncoder::new();
    let encode = |colour: [f32; 3]| encoder.encode(LinearColour::from(colour.map(f64::from)));
    plane(map, encode).into()
}

/// Heights below this share of the mesh's diagonal are rounding errors.
const ROUNDING: f64 = 1e-12;

/// Heights as codes from 0 to 65535, and which heights these are. Heights that differ by rounding
/// errors alone, on a mesh with this diagonal, are all the least one.
#[must_use]
pub fn height_picture(map: &Map<1>, diagonal: f64) -> (Picture, HeightRange) {
    let heights = map.texels.iter().map(|[height]| f64::from(*height));
    let minimum = heights.clone().fold(f64::INFINITY, f64::min);
    let maximum = heights.fold(f64::NEG_INFINITY, f64::max);
    let extent = maximum - minimum;
    // The numbers of a map have single precision.
    let precision = f64::from(f32::EPSILON) * minimum.abs().max(maximum.abs());
    if extent <= precision.max(ROUNDING * diagonal) {
        let range = HeightRange {
            minimum,
            maximum: minimum,
        };
        return (plane(map, |_| 0u16).into(), range);
    }
    let step = 65_535.0 / extent;
    let code = |[height]: [f32; 1]| ((f64::from(height) - minimum) * step).round() as u16;
    (plane(map, code).into(), HeightRange { minimum, maximum })
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

#[cfg(test)]
mod tests {
    use super::*;

    fn heights(texels: [f32; 2], diagonal: f64) -> (Vec<u16>, HeightRange) {
        let map = Map {
            width: 2,
            height: 1,
            texels: texels.map(|height| [height]).to_vec(),
        };
        let (picture, range) = height_picture(&map, diagonal);
        let Picture::Grey16(codes) = picture else {
            panic!("heights have 16 bits");
        };
        (codes.into_values(), range)
    }

    #[test]
    fn rounding_errors_are_not_stretched() {
        for (texels, diagonal) in [
            ([0.0, 3e-18], 1.0),
            ([-5e-10, 0.0], 1000.0),
            ([0.5, 0.5 + f32::EPSILON / 2.0], 1.0),
        ] {
            let (codes, range) = heights(texels, diagonal);
            assert_eq!(codes, [0, 0], "{texels:?}");
            assert_eq!(range.minimum, range.maximum);
        }
    }

    #[test]
    fn small_heights_of_small_meshes_are_shown() {
        let (codes, range) = heights([0.0, 3e-18], 1e-16);
        assert_eq!(codes, [0, 65_535]);
        assert_eq!(range.maximum, f64::from(3e-18f32));
    }
}
