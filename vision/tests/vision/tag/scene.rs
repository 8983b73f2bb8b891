//! Planes before a camera, in pictures that the tests render themselves.

use ga_image::filter::{Border, Gaussian};
use ga_image::plane::Plane;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, Normal};

/// A map from a plane to pixels: `λ (u, v, 1) = H (x, y, 1)`, row by row.
#[derive(Clone, Copy, Debug)]
pub(super) struct View {
    matrix: [[f64; 3]; 3],
}

impl View {
    /// The plane at a distance in front of a camera, rotated by the angles in degrees about x, y
    /// and z in turn, with the middle of it at a pixel.
    pub(super) fn new(
        [tilt, turn, roll]: [f64; 3],
        middle: [f64; 2],
        (focal, distance): (f64, f64),
        pixel: [f64; 2],
    ) -> Self {
        let ([a, b, c], [d, e, f]) = (
            [tilt, turn, roll].map(|angle| angle.to_radians().sin()),
            [tilt, turn, roll].map(|angle| angle.to_radians().cos()),
        );
        // The first two columns of Rx Ry Rz.
        let first = [e * f, d * c + a * b * f, a * c - d * b * f];
        let second = [-e * c, d * f - a * b * c, a * f + d * b * c];
        let rows: [[f64; 3]; 3] = std::array::from_fn(|k| {
            let third = -first[k] * middle[0] - second[k] * middle[1];
            [
                first[k],
                second[k],
                third + if k == 2 { distance } else { 0.0 },
            ]
        });
        let image = |axis: usize| -> [f64; 3] {
            std::array::from_fn(|k| focal * rows[axis][k] + pixel[axis] * rows[2][k])
        };
        Self {
            matrix: [image(0), image(1), rows[2]],
        }
    }

    /// The same with y upwards on the plane.
    pub(super) fn upwards(self) -> Self {
        Self {
            matrix: self.matrix.map(|[x, y, z]| [x, -y, z]),
        }
    }

    pub(super) fn pixel(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [u, v, w] = self.matrix.map(|[a, b, c]| a * x + b * y + c);
        [u / w, v / w]
    }

    /// The place of the plane that is seen at a pixel: the solution of two linear equations.
    fn place(&self, [u, v]: [f64; 2]) -> [f64; 2] {
        let [first, second, third] = self.matrix;
        let row = |image: [f64; 3], at: f64| [0, 1, 2].map(|k| image[k] - at * third[k]);
        let ([a, b, c], [d, e, f]) = (row(first, u), row(second, v));
        let determinant = a * e - b * d;
        [(b * f - c * e) / determinant, (c * d - a * f) / determinant]
    }

    /// The picture of a plane whose brightness is given from 0 to 1, with the standard deviations
    /// of blur in pixels and of noise in levels.
    pub(super) fn picture(
        &self,
        [width, height]: [usize; 2],
        brightness: impl Fn([f64; 2]) -> f64,
        (blur, noise): (f64, f64),
        seed: u64,
    ) -> Plane<u8> {
        // Places in a pixel of which no two are in one row or column, evenly spread along both.
        const SAMPLES: usize = 24;
        let place = |k: usize| (k as f64 + 0.5) / SAMPLES as f64 - 0.5;
        let samples = (0..SAMPLES).map(|k| [place(k), place(7 * k % SAMPLES)]);
        let samples: Vec<[f64; 2]> = samples.collect();
        let sharp = Plane::from_fn(width, height, |column, row| {
            let levels = samples
                .iter()
                .map(|[du, dv]| brightness(self.place([column as f64 + du, row as f64 + dv])));
            let sum: f64 = levels.sum();
            (30.0 + 190.0 * sum / SAMPLES as f64) as f32
        });
        let blurred = Gaussian::new(blur).unwrap().blur(&sharp, Border::Mirror);
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let normal = Normal::new(0.0, noise).unwrap();
        blurred.map(|level| {
            (f64::from(level) + normal.sample(&mut random))
                .round()
                .clamp(0.0, 255.0) as u8
        })
    }
}

/// The root of the mean square distance of pixels.
pub(super) fn rms(pairs: impl Iterator<Item = ([f64; 2], [f64; 2])>) -> f64 {
    let squares: Vec<f64> = pairs
        .map(|(a, b)| (a[0] - b[0]).powi(2) + (a[1] - b[1]).powi(2))
        .collect();
    (squares.iter().sum::<f64>() / squares.len().max(1) as f64).sqrt()
}
