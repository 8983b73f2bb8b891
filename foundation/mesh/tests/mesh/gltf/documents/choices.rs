//! Random choices, from a list of numbers.

use ga_mesh::gltf::Extras;
use serde_json::json;

/// Choices for a document, taken from the front; zeros once they are used up.
pub(super) struct Choices<'a>(pub(super) std::slice::Iter<'a, u32>);

impl Choices<'_> {
    pub(super) fn number(&mut self) -> u32 {
        self.0.next().copied().unwrap_or(0)
    }

    pub(super) fn below(&mut self, limit: usize) -> usize {
        self.number() as usize % limit
    }

    pub(super) fn yes(&mut self) -> bool {
        self.number() % 2 == 1
    }

    /// Between 0 and 1.
    pub(super) fn fraction(&mut self) -> f32 {
        (self.number() >> 8) as f32 / (1 << 24) as f32
    }

    /// Any finite number of single precision, but not so large that sums overflow.
    pub(super) fn float(&mut self) -> f32 {
        let number = f32::from_bits(self.number());
        if number.abs() < 1e30 {
            number
        } else {
            self.fraction()
        }
    }

    pub(super) fn floats<const N: usize>(&mut self) -> [f32; N] {
        std::array::from_fn(|_| self.float())
    }

    pub(super) fn unit<const N: usize>(&mut self) -> [f32; N] {
        let vector: [f64; N] = std::array::from_fn(|_| f64::from(self.fraction()) - 0.5);
        let length = vector.iter().map(|c| c * c).sum::<f64>().sqrt();
        if length < 1e-3 {
            return std::array::from_fn(|i| if i == N - 1 { 1.0 } else { 0.0 });
        }
        vector.map(|c| (c / length) as f32)
    }

    pub(super) fn name(&mut self) -> Option<String> {
        self.yes().then(|| format!("näme \"{}\"", self.below(100)))
    }

    pub(super) fn extras(&mut self) -> Extras {
        self.yes()
            .then(|| json!({"count": self.number(), "list": [1.5, null, "x"]}))
    }

    pub(super) fn list<T>(&mut self, count: usize, mut item: impl FnMut(&mut Self) -> T) -> Vec<T> {
        (0..count).map(|_| item(self)).collect()
    }
}
