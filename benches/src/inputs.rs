//! Inputs for the benchmarks: the same random numbers in every run.

use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

use crate::precision::Precision;

/// The number of inputs of each benchmark: enough that the compiler cannot treat them as constants,
/// few enough for the first-level cache.
pub const INPUTS: usize = 1024;

/// Reproducible numbers in [−1, 1).
#[derive(Clone, Debug)]
pub struct Numbers(ChaCha8Rng);

impl Numbers {
    /// The sequence of a seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self(ChaCha8Rng::seed_from_u64(seed))
    }

    /// The next number.
    pub fn number<S: Precision>(&mut self) -> S {
        let bits = self.0.next_u64();
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
