//! Linear light and its encoding as 8-bit sRGB.
//!
//! All lighting and all averaging is done in linear light. The encoding is IEC 61966-2-1: `12.92 c`
//! up to 0.0031308, above it `1.055 c^(1/2.4) − 0.055`.

use std::ops::{Add, AddAssign, Mul};

/// A colour as linear light: the radiance of each channel, 1 the brightest that a screen shows.
///
/// ```
/// use ga_image::colour::LinearColour;
///
/// let grey = LinearColour::from_srgb([188; 3]);
/// assert!((grey.red - 0.5).abs() < 0.005);
/// let quarter = LinearColour::BLACK.lerp(LinearColour::WHITE, 0.25);
/// assert_eq!(quarter, LinearColour::new(0.25, 0.25, 0.25));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LinearColour {
    /// The red channel.
    pub red: f64,
    /// The green channel.
    pub green: f64,
    /// The blue channel.
    pub blue: f64,
}

impl LinearColour {
    /// No light.
    pub const BLACK: Self = Self::new(0.0, 0.0, 0.0);

    /// The brightest neutral light that a screen shows.
    pub const WHITE: Self = Self::new(1.0, 1.0, 1.0);

    /// The colour of these three channels.
    #[must_use]
    pub const fn new(red: f64, green: f64, blue: f64) -> Self {
        Self { red, green, blue }
    }

    /// The linear light of an 8-bit sRGB colour.
    #[must_use]
    pub fn from_srgb(code: [u8; 3]) -> Self {
        Self::from(code.map(|channel| linear_from_srgb(f64::from(channel) / 255.0)))
    }

    /// Red, green and blue.
    #[must_use]
    pub const fn channels(self) -> [f64; 3] {
        [self.red, self.green, self.blue]
    }

    /// This colour for `t = 0`, `other` for `t = 1`, and mixtures of their light between.
    #[must_use]
    pub fn lerp(self, other: Self, t: f64) -> Self {
        self * (1.0 - t) + other * t
    }
}

impl From<[f64; 3]> for LinearColour {
    fn from([red, green, blue]: [f64; 3]) -> Self {
        Self { red, green, blue }
    }
}

impl Add for LinearColour {
    type Output = Self;

    /// The light of both together.
    fn add(self, other: Self) -> Self {
        Self::new(
            self.red + other.red,
            self.green + other.green,
            self.blue + other.blue,
        )
    }
}

impl AddAssign for LinearColour {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Mul<f64> for LinearColour {
    type Output = Self;

    /// The same colour, `factor` times as bright.
    fn mul(self, factor: f64) -> Self {
        Self::new(self.red * factor, self.green * factor, self.blue * factor)
    }
}

impl Mul for LinearColour {
    type Output = Self;

    /// The light of one colour that a surface of the other reflects: the product of each channel.
    fn mul(self, other: Self) -> Self {
        Self::new(
            self.red * other.red,
            self.green * other.green,
            self.blue * other.blue,
        )
    }
}

/// The linear light of an sRGB value s between 0 and 1: s / 12.92 up to 0.04045, above it
/// ((s + 0.055) / 1.055)^2.4.
///
/// ```
/// // Mid grey, from the tables of IEC 61966-2-1.
/// let light = ga_image::colour::linear_from_srgb(128.0 / 255.0);
/// assert!((light - 0.215_860_5).abs() < 1e-7);
/// ```
#[must_use]
pub fn linear_from_srgb(value: f64) -> f64 {
    if value <= 0.04045 {
        value / 12.92
    } else {
        ((value + 0.055) / 1.055).powf(2.4)
    }
}

/// Encodes colours as 8-bit sRGB, from a table of the 255 levels between neighbouring codes.
pub struct SrgbEncoder {
    /// The code of the lower end of each of `STEPS` equal steps of linear light.
    coarse: Vec<u8>,
    /// The least linear light that is encoded as code `i + 1`.
    thresholds: [f64; 255],
}

const STEPS: usize = 4096;

impl Default for SrgbEncoder {
    fn default() -> Self {
        Self::new()
    }
}

impl SrgbEncoder {
    /// An encoder with its table.
    #[must_use]
    pub fn new() -> Self {
        let mut thresholds = [0.0; 255];
        for (code, threshold) in thresholds.iter_mut().enumerate() {
            let halfway = (code as f64 + 0.5) / 255.0;
            *threshold = linear_from_srgb(halfway);
        }
        let mut coarse = Vec::with_capacity(STEPS + 1);
        let mut code = 0;
        for step in 0..=STEPS {
            let light = step as f64 / STEPS as f64;
            while code < 255 && light >= thresholds[code] {
                code += 1;
            }
            coarse.push(code as u8);
        }
        Self { coarse, thresholds }
    }

    /// The nearest 8-bit sRGB colour; light outside 0 to 1 is clamped.
    #[must_use]
    pub fn encode(&self, colour: LinearColour) -> [u8; 3] {
        colour.channels().map(|light| {
            let light = light.clamp(0.0, 1.0);
            let mut code = self.coarse[(light * STEPS as f64) as usize];
            while code < 255 && light >= self.thresholds[usize::from(code)] {
                code += 1;
            }
            code
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decoding_and_encoding_gives_every_code_back() {
        let encoder = SrgbEncoder::new();
        for code in 0..=255 {
            assert_eq!(
                encoder.encode(LinearColour::from_srgb([code; 3])),
                [code; 3]
            );
        }
    }

    #[test]
    fn encoding_follows_the_standard() {
        let encoder = SrgbEncoder::new();
        for i in 0..=10_000 {
            let light = f64::from(i) / 10_000.0;
            let exact = if light <= 0.003_130_8 {
                12.92 * light
            } else {
                1.055 * light.powf(1.0 / 2.4) - 0.055
            };
            let code = f64::from(encoder.encode([light; 3].into())[0]);
            assert!(
                (code - 255.0 * exact).abs() < 0.501,
                "{light}: {code} for {}",
                255.0 * exact
            );
        }
        assert_eq!(encoder.encode([-1.0, 2.0, f64::NAN].into())[..2], [0, 255]);
    }
}
