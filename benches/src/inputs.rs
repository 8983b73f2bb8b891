//! Inputs for the benchmarks: the same random numbers in every run.

use ga_runtime::cga3::{Motor, Point, Rotor, Translator};

use crate::precision::Precision;

/// The number of inputs of each benchmark: enough that the compiler cannot treat them as constants,
/// few enough for the first-level cache.
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
    pub fn number<S: Precision>(&mut self) -> S {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ bits >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ bits >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^= bits >> 31;
        S::from_f64((bits >> 11) as f64 / (1_u64 << 52) as f64 - 1.0)
    }

    /// The next N numbers.
    pub fn numbers<S: Precision, const N: usize>(&mut self) -> [S; N] {
        std::array::from_fn(|_| self.number())
    }

    /// A point of the cube from −1 to 1 along each axis.
    pub fn point<S: Precision>(&mut self) -> Point<S> {
        Point::from(self.numbers())
    }

    /// A rotation by up to 3 radians.
    pub fn rotor<S: Precision>(&mut self) -> Rotor<S> {
        let (axis, angle) = (self.numbers(), self.number());
        Rotor::from_axis_angle(axis, S::from_integer(3) * angle).unwrap_or_default()
    }

    /// A rigid motion.
    pub fn motor<S: Precision>(&mut self) -> Motor<S> {
        let displacement = self.numbers();
        Translator::from_displacement(displacement) * self.rotor()
    }
}

/// A list of [`INPUTS`] inputs.
pub fn list<T>(seed: u64, mut make: impl FnMut(&mut Numbers) -> T) -> Vec<T> {
    let mut numbers = Numbers::new(seed);
    (0..INPUTS).map(|_| make(&mut numbers)).collect()
}
