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
