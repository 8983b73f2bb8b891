//! What a camera makes of the light that it gets: exposure and noise, for pictures that are made
//! where real ones are stood for.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

use crate::colour::linear_from_srgb;
use crate::plane::Plane;

/// How a camera is set.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_image::sensor::Sensor;
///
/// let picture = Plane::filled(4, 3, [128; 3]);
/// // Twice the light of sRGB 128 is sRGB 176.
/// let bright = Sensor { exposure: 2.0, noise: 0.0 }.store(&picture, 1, 0);
/// assert_eq!(bright.get(0, 0), Some([176; 3]));
/// assert_eq!(Sensor::default().store(&picture, 1, 0), picture);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sensor {
    /// A factor of the light, which is cut at white.
    pub exposure: f64,
    /// The standard deviation of the noise in each channel, normal and in steps of 8 bits.
    pub noise: f64,
}

impl Default for Sensor {
    /// The light as it is, without noise.
    fn default() -> Self {
        Self {
            exposure: 1.0,
            noise: 0.0,
        }
    }
}

impl Sensor {
    /// A picture as it is stored. Equal seeds and numbers give equal noise; of one seed, the noise
    /// of pictures with different numbers is independent.
    #[must_use]
    pub fn store(self, picture: &Plane<[u8; 3]>, seed: u64, number: u64) -> Plane<[u8; 3]> {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        random.set_stream(number);
        let exposed: Vec<f64> = (0..=u8::MAX).map(|code| self.exposed(code)).collect();
        picture.map(|pixel| {
            pixel.map(|code| {
                let normal: f64 = StandardNormal.sample(&mut random);
                let value = exposed[usize::from(code)] + self.noise * normal;
                value.round().clamp(0.0, 255.0) as u8
            })
        })
    }

    /// The code of a channel in this exposure, not rounded.
    fn exposed(self, code: u8) -> f64 {
        let light = self.exposure * linear_from_srgb(f64::from(code) / 255.0);
        255.0 * srgb_from_linear(light.clamp(0.0, 1.0))
    }
}

/// The sRGB value of a share of light, by IEC 61966-2-1.
fn srgb_from_linear(light: f64) -> f64 {
    if light <= 0.003_130_8 {
        12.92 * light
    } else {
        1.055 * light.powf(1.0 / 2.4) - 0.055
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_noise_has_its_deviation_and_differs_between_pictures() {
        let picture = Plane::filled(200, 100, [120; 3]);
        let sensor = Sensor {
            noise: 3.0,
            ..Sensor::default()
        };
        let [first, same, other] = [0, 0, 1].map(|number| sensor.store(&picture, 7, number));
        assert_eq!(first, same);
        assert_ne!(first, other);
        let values: Vec<f64> = first
            .values()
            .iter()
            .flatten()
            .map(|code| f64::from(*code) - 120.0)
            .collect();
        let count = values.len() as f64;
        let mean = values.iter().sum::<f64>() / count;
        let variance = values
            .iter()
            .map(|value| (value - mean).powi(2))
            .sum::<f64>()
            / count;
        // Rounding adds a twelfth; four standard deviations of both estimates.
        assert!(mean.abs() < 4.0 * 3.0 / count.sqrt(), "{mean}");
        assert!(
            (variance - 9.083).abs() < 4.0 * 9.083 * (2.0 / count).sqrt(),
            "{variance}"
        );
    }

    #[test]
    fn white_is_the_most() {
        let picture = Plane::from_fn(2, 1, |column, _| [[0, 255][column]; 3]);
        let bright = Sensor {
            exposure: 4.0,
            noise: 0.0,
        };
        assert_eq!(bright.store(&picture, 0, 0), picture);
    }
}
