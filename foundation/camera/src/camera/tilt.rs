//! The tilt of a sensor against the plane of the lens.

use super::error::CameraError;

/// A sensor that is rotated about x by τx, then about y by τy: the image is projected from the
/// lens's centre onto the tilted plane,
///
/// ```text
/// s (x', y', 1) = [R₃₃ 0 −R₁₃; 0 R₃₃ −R₂₃; 0 0 1] R(τx, τy) (x, y, 1)
/// ```
///
/// (A. Louhichi et al., A model-based approach for compensation of the Scheimpflug effect, 2007; as
/// in OpenCV).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Tilt {
    matrix: Matrix,
    inverse: Matrix,
    by_angle: [Matrix; 2],
}

type Matrix = [[f64; 3]; 3];

impl Tilt {
    /// `None` for a sensor that is not tilted.
    pub(super) fn new(x: f64, y: f64) -> Result<Option<Self>, CameraError> {
        if x == 0.0 && y == 0.0 {
            return Ok(None);
        }
        for (name, value) in [("tauX", x), ("tauY", y)] {
            if value.abs() >= std::f64::consts::FRAC_PI_2 {
                return Err(CameraError::Coefficient {
                    name,
                    value,
                    expected: "an angle below π/2",
                });
            }
        }
        let about_x = [
            [1.0, 0.0, 0.0],
            [0.0, x.cos(), x.sin()],
            [0.0, -x.sin(), x.cos()],
        ];
        let about_y = [
            [y.cos(), 0.0, -y.sin()],
            [0.0, 1.0, 0.0],
            [y.sin(), 0.0, y.cos()],
        ];
        let by_x = [
            [0.0; 3],
            [0.0, -x.sin(), x.cos()],
            [0.0, -x.cos(), -x.sin()],
        ];
        let by_y = [
            [-y.sin(), 0.0, -y.cos()],
            [0.0; 3],
            [y.cos(), 0.0, -y.sin()],
        ];
        let rotation = product(about_y, about_x);
        let rotation_by = [product(about_y, by_x), product(by_y, about_x)];
        let projection = onto_sensor(rotation, 1.0);
        let depth = rotation[2][2];
        let back = [
            [1.0 / depth, 0.0, rotation[0][2] / depth],
            [0.0, 1.0 / depth, rotation[1][2] / depth],
            [0.0, 0.0, 1.0],
        ];
        Ok(Some(Self {
            matrix: product(projection, rotation),
            inverse: product(transpose(rotation), back),
            by_angle: rotation_by.map(|by| {
                sum(
                    product(onto_sensor(by, 0.0), rotation),
                    product(projection, by),
                )
            }),
        }))
    }

    /// The image on the tilted sensor of an image in the plane of the lens.
    pub(super) fn apply(&self, image: [f64; 2]) -> [f64; 2] {
        dehomogenized(&self.matrix, image)
    }

    /// The image in the plane of the lens of one on the tilted sensor.
    pub(super) fn remove(&self, image: [f64; 2]) -> [f64; 2] {
        dehomogenized(&self.inverse, image)
    }

    /// The derivatives of [`apply`](Self::apply): by the image, and by the two angles, by rows.
    pub(super) fn derivatives(&self, image: [f64; 2]) -> ([[f64; 2]; 2], [[f64; 2]; 2]) {
        let [x, y, w] = times(&self.matrix, image);
        let place = [x / w, y / w];
        let quotient_rule =
            |change: [f64; 3], row: usize| (change[row] - place[row] * change[2]) / w;
        let column = |k: usize| self.matrix.map(|row| row[k]);
        let by_image = [0, 1].map(|row| [0, 1].map(|k| quotient_rule(column(k), row)));
        let changes = self.by_angle.map(|matrix| times(&matrix, image));
        let by_angle = [0, 1].map(|row| [0, 1].map(|k| quotient_rule(changes[k], row)));
        (by_image, by_angle)
    }
}

/// The projection onto the sensor, or its derivative where `one` is 0.
fn onto_sensor(rotation: Matrix, one: f64) -> Matrix {
    let [x, y, z] = rotation.map(|row| row[2]);
    [[z, 0.0, -x], [0.0, z, -y], [0.0, 0.0, one]]
}

fn product(a: Matrix, b: Matrix) -> Matrix {
    a.map(|row| [0, 1, 2].map(|k| row[0] * b[0][k] + row[1] * b[1][k] + row[2] * b[2][k]))
}

fn sum(a: Matrix, b: Matrix) -> Matrix {
    [0, 1, 2].map(|row| [0, 1, 2].map(|k| a[row][k] + b[row][k]))
}

fn transpose(a: Matrix) -> Matrix {
    [0, 1, 2].map(|k| a.map(|row| row[k]))
}

fn times(a: &Matrix, [x, y]: [f64; 2]) -> [f64; 3] {
    a.map(|row| row[0] * x + row[1] * y + row[2])
}

fn dehomogenized(a: &Matrix, image: [f64; 2]) -> [f64; 2] {
    let [x, y, w] = times(a, image);
    [x / w, y / w]
}
