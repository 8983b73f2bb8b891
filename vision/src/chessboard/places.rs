//! Saddle points by where they are.

use std::collections::HashMap;

use ga_runtime::vga2::Vector;

use super::saddle::Saddle;

/// The side of a part of the picture in pixels: about that of a square of a board.
const SIDE: f64 = 20.0;

/// The indices of saddle points in each part of a picture.
pub(super) struct Places(HashMap<[i32; 2], Vec<usize>>);

impl Places {
    pub(super) fn new(saddles: &[Saddle]) -> Self {
        let mut parts: HashMap<[i32; 2], Vec<usize>> = HashMap::new();
        for (index, saddle) in saddles.iter().enumerate() {
            parts.entry(part(saddle.place)).or_default().push(index);
        }
        Self(parts)
    }

    /// The saddle points in the parts of the picture that are within reach of a place, in an order
    /// that depends on nothing else.
    pub(super) fn about(&self, place: Vector<f64>, reach: f64) -> impl Iterator<Item = usize> {
        let corner = Vector::new(reach, reach);
        let [first, last] = [part(place - corner), part(place + corner)];
        let rows = first[1]..=last[1];
        let parts = rows.flat_map(move |y| (first[0]..=last[0]).map(move |x| [x, y]));
        parts.flat_map(|part| self.0.get(&part).into_iter().flatten().copied())
    }
}

fn part(place: Vector<f64>) -> [i32; 2] {
    // A conversion from a great number gives the greatest.
    place.coordinates().map(|x| (x / SIDE).floor() as i32)
}
