//! Grey noise of several sizes, as the grain of a wall.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

use crate::plane::Plane;

/// A square picture of noise: the mean of layers, each linear between points with random values
/// from 0 to 1. The points of the first layer are `finest` pixels apart, and those of each further
/// one twice as far. It continues over its borders where `size` is a multiple of the farthest
/// distance.
///
/// ```
/// let grain = ga_image::grain::grain(64, 2, 4, 1);
/// let mean = grain.values().iter().sum::<f32>() / 4096.0;
/// assert!((mean - 0.5).abs() < 0.1);
/// ```
#[must_use]
pub fn grain(size: usize, finest: usize, layers: u32, seed: u64) -> Plane {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let layers: Vec<(usize, Vec<f32>)> = (0..layers)
        .map(|layer| {
            let apart = finest.max(1) << layer;
            let count = size.div_ceil(apart);
            let draw = || random.next_u32() as f32 / u32::MAX as f32;
            let values = std::iter::repeat_with(draw).take(count * count);
            (apart, values.collect())
        })
        .collect();
    let count = layers.len().max(1) as f32;
    Plane::from_fn(size, size, |column, row| {
        let values = layers.iter().map(|(apart, values)| {
            let columns = size.div_ceil(*apart);
            let at = |x: usize, y: usize| values[y % columns * columns + x % columns];
            let [left, top] = [column / apart, row / apart];
            let [u, v] = [column, row].map(|place| (place % apart) as f32 / *apart as f32);
            let above = at(left, top) + u * (at(left + 1, top) - at(left, top));
            let below = at(left, top + 1) + u * (at(left + 1, top + 1) - at(left, top + 1));
            above + v * (below - above)
        });
        values.sum::<f32>() / count
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Between points of a layer values are linear; the second differences of a single layer
    /// vanish but at its points.
    #[test]
    fn a_layer_is_linear_between_its_points() {
        let grain = grain(32, 8, 1, 3);
        for row in grain.rows() {
            for (start, three) in row.windows(3).enumerate() {
                let bend = (three[0] - 2.0 * three[1] + three[2]).abs();
                assert!((start + 1) % 8 == 0 || bend < 1e-6, "{start}: {bend}");
            }
        }
        assert_eq!(grain, super::grain(32, 8, 1, 3));
        assert_ne!(grain, super::grain(32, 8, 1, 4));
    }
}
