//! Random samples.

/// The generator SplitMix64 (Steele, Lea and Flood, Fast splittable pseudorandom number generators,
/// OOPSLA 2014). Equal seeds give equal numbers on every machine.
pub(super) struct SplitMix64(u64);

impl SplitMix64 {
    pub(super) fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^ (bits >> 31)
    }

    /// Puts a random sample in front, each with the same probability.
    pub(super) fn draw(&mut self, order: &mut [usize], sample: usize) {
        for place in 0..sample.min(order.len()) {
            let left = (order.len() - place) as u64;
            // The high half of the product is uniform up to 2⁻⁶⁴ times the number of points.
            let offset = (u128::from(self.bits()) * u128::from(left)) >> 64;
            order.swap(place, place + offset as usize);
        }
    }
}
