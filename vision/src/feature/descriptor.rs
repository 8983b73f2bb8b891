//! Descriptors: bits that say which of two places near a corner is brighter.

use std::f64::consts::TAU;

use ga_image::plane::Plane;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, Normal};

/// Places are within this distance of the corner.
const RADIUS: i32 = 15;
const BITS: usize = 256;

/// Bits that describe the surroundings of a corner.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Descriptor(pub(super) [u64; BITS / 64]);

impl Descriptor {
    /// The number of bits that differ.
    #[inline(always)]
    #[must_use]
    pub fn distance(&self, other: &Self) -> u32 {
        let pairs = self.0.iter().zip(&other.0);
        pairs.map(|(a, b)| (a ^ b).count_ones()).sum()
    }
}

/// The pairs of places that are compared, as offsets from a corner of angle 0.
///
/// The idea is that of M. Calonder and others, "BRIEF: binary robust independent elementary
/// features", 2010, and of E. Rublee and others, "ORB: an efficient alternative to SIFT or SURF",
/// 2011. The places are drawn from a normal distribution with a fixed seed.
pub(super) struct Pattern([[[f64; 2]; 2]; BITS]);

impl Pattern {
    pub(super) fn new() -> Self {
        const SEED: u64 = 0x6e75_6c6c;
        let mut random = ChaCha8Rng::seed_from_u64(SEED);
        // The standard deviation is positive and finite.
        let normal = Normal::new(0.0, f64::from(RADIUS) / 2.2);
        let mut place = || loop {
            let place = [0; 2].map(|_| normal.map_or(0.0, |normal| normal.sample(&mut random)));
            if place[0].hypot(place[1]) <= f64::from(RADIUS) {
                return place;
            }
        };
        Self(std::array::from_fn(|_| [place(), place()]))
    }

    /// The bits of the surroundings of a place, with the pattern rotated by an angle. The place
    /// must be inside the picture by more than the radius.
    pub(super) fn describe(&self, blurred: &Plane<f32>, place: [f64; 2], angle: f64) -> Descriptor {
        let (sine, cosine) = angle.sin_cos();
        let at = |[x, y]: [f64; 2]| {
            let column = (place[0] + cosine * x - sine * y).round() as usize;
            let row = (place[1] + sine * x + cosine * y).round() as usize;
            blurred.row(row)[column]
        };
        let mut words = [0; BITS / 64];
        for (index, [first, second]) in self.0.iter().enumerate() {
            let bit = u64::from(at(*first) < at(*second));
            words[index / 64] |= bit << (index % 64);
        }
        Descriptor(words)
    }
}

/// The direction from a place to the centroid of the grey levels around it, in [0, 2π) (P. L.
/// Rosin, "Measuring corner properties", 1999).
pub(super) fn direction(blurred: &Plane<f32>, place: [f64; 2]) -> f64 {
    let [column, row] = place.map(|x| x.round() as i32);
    let (mut u, mut v) = (0.0, 0.0);
    for y in -RADIUS..=RADIUS {
        let half = f64::from(RADIUS * RADIUS - y * y).sqrt() as i32;
        let line = blurred.row((row + y) as usize);
        for x in -half..=half {
            let grey = f64::from(line[(column + x) as usize]);
            u += f64::from(x) * grey;
            v += f64::from(y) * grey;
        }
    }
    v.atan2(u).rem_euclid(TAU)
}
