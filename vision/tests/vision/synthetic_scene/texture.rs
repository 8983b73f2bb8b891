//! A texture without waves shorter than a given length, so that pictures of it are not aliased.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, Uniform};

const WAVES: usize = 24;

/// A sum of plane waves.
pub(crate) struct Texture {
    /// Wave vectors in radians a metre, and phases.
    waves: Vec<([f64; 2], f64)>,
}

impl Texture {
    /// Waves with lengths from `grain` to four times as much, in all directions.
    pub(crate) fn new(grain: f64, seed: u64) -> Self {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let unit = Uniform::new(0.0, 1.0).unwrap();
        let mut share = || unit.sample(&mut random);
        let waves = (0..WAVES).map(|_| {
            let (sine, cosine) = (std::f64::consts::TAU * share()).sin_cos();
            let number = std::f64::consts::TAU / (grain * 4f64.powf(share()));
            let phase = std::f64::consts::TAU * share();
            ([number * cosine, number * sine], phase)
        });
        Self {
            waves: waves.collect(),
        }
    }

    /// The level of grey at a place in metres, from 0 to 255.
    pub(crate) fn level(&self, [x, y]: [f64; 2]) -> f64 {
        let waves = self.waves.iter();
        let sum: f64 = waves
            .map(|([a, b], phase)| (a * x + b * y + phase).cos())
            .sum();
        // The variance of the sum is half the number of waves.
        let deviations = sum / (0.5 * WAVES as f64).sqrt();
        (127.5 + 45.0 * deviations).clamp(0.0, 255.0)
    }
}
