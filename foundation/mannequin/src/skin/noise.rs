//! Numbers without a pattern that depend on the place alone.

use crate::Vector;

/// Value noise: random numbers at the points of a grid of unit cubes, joined smoothly. Between −1
/// and 1, with a mean near 0.
pub(super) fn noise(place: Vector) -> f64 {
    let corner = place.coordinates().map(f64::floor);
    let t = std::array::from_fn(|axis| {
        let t = place[axis] - corner[axis];
        t * t * (3.0 - 2.0 * t)
    });
    let [x, y, z]: [f64; 3] = t;
    let cell = corner.map(|c| c as i64);
    let at = |dx, dy, dz| 2.0 * random([cell[0] + dx, cell[1] + dy, cell[2] + dz]) - 1.0;
    let along = |dy, dz| at(0, dy, dz) * (1.0 - x) + at(1, dy, dz) * x;
    let level = |dz| along(0, dz) * (1.0 - y) + along(1, dz) * y;
    level(0) * (1.0 - z) + level(1) * z
}

/// Three octaves of [`noise`], each half as strong and twice as fine as the one before.
pub(super) fn rough(place: Vector) -> f64 {
    (noise(place) + 0.5 * noise(place * 2.0) + 0.25 * noise(place * 4.0)) / 1.75
}

/// The depth of the spot in whose middle a place lies: 1 in the middle of a spot, 0 outside all.
/// In each unit cube there is a spot with the given chance, with radii up to `radius`.
pub(super) fn spots(place: Vector, chance: f64, radius: f64) -> f64 {
    let cell = place.coordinates().map(|c| c.floor() as i64);
    let mut depth = 0.0f64;
    for index in 0..27 {
        let cube = [
            cell[0] + index % 3 - 1,
            cell[1] + index / 3 % 3 - 1,
            cell[2] + index / 9 - 1,
        ];
        let random = |salt: i64| random([cube[0] + 7919 * salt, cube[1], cube[2] - 104_729 * salt]);
        if random(1) > chance {
            continue;
        }
        let middle =
            Vector::from([0, 1, 2].map(|axis| cube[axis] as f64 + random(2 + axis as i64)));
        let radius = radius * (0.4 + 0.6 * random(5));
        depth = depth.max(1.0 - place.distance(middle) / radius);
    }
    depth.max(0.0)
}

/// A number between 0 and 1 for each point of a grid, by the finaliser of MurmurHash3.
fn random(point: [i64; 3]) -> f64 {
    let mut bits = point.iter().fold(0x9e37_79b9_7f4a_7c15u64, |bits, c| {
        (bits ^ c.cast_unsigned())
            .wrapping_mul(0xff51_afd7_ed55_8ccd)
            .rotate_left(31)
    });
    bits = (bits ^ (bits >> 33)).wrapping_mul(0xc4ce_b9fe_1a85_ec53);
    bits ^= bits >> 33;
    (bits >> 11) as f64 / (1u64 << 53) as f64
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn place() -> impl Strategy<Value = Vector> {
        proptest::array::uniform3(-50.0..50.0).prop_map(Vector::from)
    }

    /// Places just before and behind the border of cubes that is next to a place along an axis.
    fn sides(place: Vector, axis: usize) -> [Vector; 2] {
        [-1e-6, 1e-6].map(|step| {
            let mut side = place.coordinates();
            side[axis] = place[axis].round() + step;
            side.into()
        })
    }

    proptest! {
        /// Spots of other cubes reach into a cube, so that a border between two is not to be seen:
        /// the depth changes by no more than a way divided by the least radius.
        #[test]
        fn spots_go_on_over_the_borders_of_cubes(place in place(), radius in 0.1..1.0) {
            for axis in 0..3 {
                let [before, behind] = sides(place, axis).map(|side| spots(side, 0.9, radius));
                prop_assert!((before - behind).abs() <= 2.1e-6 / (0.4 * radius));
                prop_assert!((0.0..=1.0).contains(&before));
            }
        }

        #[test]
        fn noise_goes_on_over_the_borders_of_cubes(place in place()) {
            for axis in 0..3 {
                let [before, behind] = sides(place, axis).map(noise);
                // At a border the slope along the axis is 0.
                prop_assert!((before - behind).abs() < 1e-9);
                prop_assert!(before.abs() <= 1.0 && rough(place).abs() <= 1.0);
            }
        }
    }

    /// Uniform numbers between −1 and 1, of which the middle of a cube is the mean of eight.
    #[test]
    fn noise_has_the_mean_and_the_spread_of_uniform_numbers() {
        let corners = (0..8000).map(|k| [k % 20, k / 20 % 20, k / 400].map(f64::from));
        let values: Vec<f64> = corners.map(|corner| noise(corner.into())).collect();
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
        let squares: Vec<f64> = values.iter().map(|value| value * value).collect();
        // The standard deviation of the mean is 1 / √(3 · 8000) = 0.0065.
        assert!(mean(&values).abs() < 0.026);
        assert!((mean(&squares) - 1.0 / 3.0).abs() < 0.014);
        let corner = |k: i32| {
            noise(Vector::new(
                f64::from(k % 2),
                f64::from(k / 2 % 2),
                f64::from(k / 4),
            ))
        };
        let middle = (0..8).map(corner).sum::<f64>() / 8.0;
        assert!((noise(Vector::new(0.5, 0.5, 0.5)) - middle).abs() < 1e-12);
    }
}
