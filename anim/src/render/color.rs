//! Linear light and its encoding as 8-bit sRGB.
//!
//! All lighting and all averaging is done in linear light. The encoding is IEC 61966-2-1: `12.92 c`
//! up to 0.0031308, above it `1.055 c^(1/2.4) − 0.055`.

use super::vector::Vector;

/// Red, green and blue as linear light, 1 the brightest that can be shown.
pub type LinearColor = [f64; 3];

/// The linear light of an 8-bit sRGB colour.
///
/// ```
/// use ga_anim::render::from_srgb;
/// assert_eq!(from_srgb([255, 0, 255]), [1.0, 0.0, 1.0]);
/// assert!((from_srgb([188, 188, 188])[0] - 0.5).abs() < 0.005);
/// ```
pub fn from_srgb(color: [u8; 3]) -> LinearColor {
    color.map(|channel| {
        let c = f64::from(channel) / 255.0;
        if c <= 0.04045 {
            c / 12.92
        } else {
            ((c + 0.055) / 1.055).powf(2.4)
        }
    })
}

/// Encodes many colours: the 255 levels between neighbouring codes are computed once.
pub(crate) struct Encoder {
    /// The code of the lower end of each of `STEPS` equal steps of linear light.
    coarse: Vec<u8>,
    /// The least linear light that is encoded as code `i + 1`.
    thresholds: [f64; 255],
}

const STEPS: usize = 4096;

impl Encoder {
    pub(crate) fn new() -> Self {
        let mut thresholds = [0.0; 255];
        for (code, threshold) in thresholds.iter_mut().enumerate() {
            let halfway = (code as f64 + 0.5) / 255.0;
            *threshold = if halfway <= 0.04045 {
                halfway / 12.92
            } else {
                ((halfway + 0.055) / 1.055).powf(2.4)
            };
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

    /// The nearest 8-bit sRGB colour; light outside 0..1 is clamped.
    pub(crate) fn encode(&self, color: Vector) -> [u8; 3] {
        color.map(|light| {
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
    fn every_code_comes_back() {
        let encoder = Encoder::new();
        for code in 0..=255 {
            assert_eq!(encoder.encode(from_srgb([code; 3])), [code; 3]);
        }
    }

    #[test]
    fn encoding_follows_the_standard() {
        let encoder = Encoder::new();
        for i in 0..=10_000 {
            let light = f64::from(i) / 10_000.0;
            let exact = if light <= 0.003_130_8 {
                12.92 * light
            } else {
                1.055 * light.powf(1.0 / 2.4) - 0.055
            };
            let code = f64::from(encoder.encode([light; 3])[0]);
            assert!(
                (code - 255.0 * exact).abs() < 0.501,
                "{light}: {code} for {}",
                255.0 * exact
            );
        }
        assert_eq!(encoder.encode([-1.0, 2.0, f64::NAN])[..2], [0, 255]);
    }
}
