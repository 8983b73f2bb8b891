//! Scenes and plain arithmetic that tests share.

use ga_image::colour::LinearColour;
use ga_render::{Light, Lighting, Style};

pub(crate) const UNIT_SQUARE: [[u32; 3]; 2] = [[0, 1, 2], [0, 2, 3]];

/// Texture coordinates of [`square`].
pub(crate) const CORNERS: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];

/// The square from (−1, −1) to (1, 1) at a height over the plane of x and y, facing +z.
pub(crate) fn square(z: f64) -> [[f64; 3]; 4] {
    CORNERS.map(|[u, v]| [2.0 * u - 1.0, 2.0 * v - 1.0, z])
}

/// A square picture with one light, no highlights and a black background.
pub(crate) fn one_light(size: u32, direction: [f64; 3], colour: LinearColour) -> Style {
    let dark = Light {
        direction: [0.0, 1.0, 0.0],
        colour: LinearColour::BLACK,
    };
    Style {
        width: size,
        height: size,
        supersampling: 1,
        gloss: 0.0,
        depth_contrast: 0.0,
        lighting: Lighting {
            key: Light { direction, colour },
            fill: dark,
            sky: LinearColour::BLACK,
            bounce: LinearColour::BLACK,
        },
        background: [LinearColour::BLACK; 2],
        ..Style::default()
    }
}

pub(crate) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

pub(crate) fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// The 8-bit sRGB code of linear light.
pub(crate) fn code(light: f64) -> f64 {
    let encoded = if light <= 0.003_130_8 {
        12.92 * light
    } else {
        1.055 * light.powf(1.0 / 2.4) - 0.055
    };
    255.0 * encoded.clamp(0.0, 1.0)
}
