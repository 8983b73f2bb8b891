//! Random textures that move, and pictures from files.

use std::path::Path;

use ga_image::plane::Plane;
use ga_image::ycbcr::YCbCr;
use ga_video::{Planes, Samples};

/// Reproducible random numbers (splitmix64).
pub(super) struct Random(pub(super) u64);

impl Random {
    pub(super) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        mixed(self.0)
    }

    pub(super) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// A path of a camera whose velocity changes at random.
pub(super) fn walk(random: &mut Random, steps: usize) -> Vec<[f64; 2]> {
    let (mut place, mut velocity) = ([0.0; 2], [0.0; 2]);
    let step = |_| {
        for axis in 0..2 {
            velocity[axis] = 0.85 * velocity[axis] + random.between(-1.5, 1.5);
            place[axis] += velocity[axis];
        }
        place
    };
    (0..steps).map(step).collect()
}

fn mixed(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}

/// Smooth noise of four octaves, from 0 to 255, at any place.
pub(super) fn texture(seed: u64, x: f64, y: f64) -> f64 {
    let mut sum = 0.0;
    for octave in 0..4_u64 {
        let scale = (1 << octave) as f64 / 48.0;
        sum += 0.7_f64.powi(octave as i32) * lattice(seed ^ octave, x * scale, y * scale);
    }
    128.0 + 70.0 * sum
}

/// Smooth noise from −1 to 1 with values at whole places.
pub(super) fn lattice(seed: u64, x: f64, y: f64) -> f64 {
    let (column, row) = (x.floor(), y.floor());
    let smooth = |t: f64| t * t * (3.0 - 2.0 * t);
    let (fx, fy) = (smooth(x - column), smooth(y - row));
    let value = |i: i64, j: i64| {
        let place = (column as i64 + i) as u64 ^ ((row as i64 + j) as u64).rotate_left(32);
        (mixed(mixed(place) ^ seed) >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    };
    let mix = |a: f64, b: f64, t: f64| a + t * (b - a);
    mix(
        mix(value(0, 0), value(1, 0), fx),
        mix(value(0, 1), value(1, 1), fx),
        fy,
    )
}

/// A grey view of a function of the place.
pub(super) fn grey(size: [usize; 2], mut level: impl FnMut(f64, f64) -> f64) -> Samples {
    let luma = Plane::from_fn(size[0], size[1], |column, row| {
        level(column as f64, row as f64).round() as u8
    });
    Samples::Eight(Planes {
        luma,
        ..Planes::default()
    })
}

/// A picture in colour, with colour differences for each pixel.
pub(super) fn read(path: &Path) -> Samples {
    let picture = ga_image::file::read(path).unwrap().to_rgb::<u8>();
    let colours = YCbCr::default();
    let encoded = picture.map(|rgb| colours.from_rgb(rgb));
    let plane = |channel| encoded.channel(channel).unwrap();
    Samples::Eight(Planes {
        luma: plane(0),
        differences: [plane(1), plane(2)],
    })
}
