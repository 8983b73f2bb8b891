//! Places as whole numbers of 16 bits.

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use serde::Serialize;

/// The largest number of 16 bits.
const MOST: f64 = 65535.0;

/// Whole numbers of 16 bits. Along axis k the number n stands for `low[k]` + n · `step[k]`.
#[derive(Debug, Serialize)]
pub(super) struct Numbers {
    low: Vec<f64>,
    step: Vec<f64>,
    numbers: String,
}

/// The bounds of places, in steps of which 16 bits count.
#[derive(Clone, Copy)]
pub(super) struct Scale<const N: usize> {
    low: [f64; N],
    step: [f64; N],
}

impl<const N: usize> Scale<N> {
    pub(super) fn of(places: impl Iterator<Item = [f64; N]>) -> Self {
        let [low, high] = extent(places);
        Self {
            low,
            step: std::array::from_fn(|k| (high[k] - low[k]) / MOST),
        }
    }

    pub(super) fn numbers(&self, place: [f64; N]) -> [u16; N] {
        std::array::from_fn(|k| {
            let steps = (place[k] - self.low[k]) / self.step[k];
            // Bounds without a length have the step zero. Numbers beyond 16 bits are cut off.
            if steps.is_finite() {
                steps.round() as u16
            } else {
                0
            }
        })
    }

    pub(super) fn encode(&self, places: impl Iterator<Item = [u16; N]>) -> Numbers {
        let bytes: Vec<u8> = places.flatten().flat_map(u16::to_le_bytes).collect();
        Numbers {
            low: self.low.to_vec(),
            step: self.step.to_vec(),
            numbers: BASE64_STANDARD.encode(bytes),
        }
    }
}

/// The corners of the box that contains places.
pub(super) fn extent<const N: usize>(places: impl Iterator<Item = [f64; N]>) -> [[f64; N]; 2] {
    let start = [[f64::INFINITY; N], [f64::NEG_INFINITY; N]];
    places.fold(start, |[low, high], place| {
        [
            std::array::from_fn(|k| low[k].min(place[k])),
            std::array::from_fn(|k| high[k].max(place[k])),
        ]
    })
}
