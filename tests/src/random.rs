//! Reproducible random numbers.

use crate::plain::{Vector, length, times};

/// The generator SplitMix64 (Steele, Lea and Flood 2014), by its seed.
pub struct SplitMix64(pub u64);

impl SplitMix64 {
    /// All 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^ (bits >> 31)
    }

    /// A number in [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A number in [−size, size).
    pub fn within(&mut self, size: f64) -> f64 {
        (2.0 * self.unit() - 1.0) * size
    }

    /// A vector with components in [−size, size).
    pub fn vector(&mut self, size: f64) -> Vector {
        std::array::from_fn(|_| self.within(size))
    }

    /// A unit vector.
    pub fn axis(&mut self) -> Vector {
        loop {
            let v = self.vector(1.0);
            let size = length(v);
            if 0.1 < size && size < 1.0 {
                return times(v, 1.0 / size);
            }
        }
    }

    /// A finite number of any magnitude.
    pub fn finite(&mut self) -> f64 {
        loop {
            let number = f64::from_bits(self.bits());
            if number.is_finite() {
                return number;
            }
        }
    }
}
