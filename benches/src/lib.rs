//! Inputs for the benchmarks: the same random numbers in every run.

/// How many inputs each benchmark goes through in turn, so that nothing is a constant to the compiler.
pub const INPUTS: usize = 1024;

/// Reproducible numbers in (−1, 1) (SplitMix64: Steele, Lea and Flood 2014).
#[derive(Clone, Debug)]
pub struct Numbers(u64);

impl Numbers {
    /// The sequence of a seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// The next number.
    pub fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ bits >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ bits >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^= bits >> 31;
        (bits >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// The next three numbers.
    pub fn vector(&mut self) -> [f64; 3] {
        [self.number(), self.number(), self.number()]
    }
}
