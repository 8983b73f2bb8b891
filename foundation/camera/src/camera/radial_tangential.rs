//! Radial–tangential distortion with rational terms, thin prism and tilted sensor.

use super::error::CameraError;
use super::monotone::{inverse, least_positive_root};
use super::tilt::Tilt;

/// The names of the coefficients, in OpenCV's order.
pub(super) const NAMES: [&str; 14] = [
    "k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6", "s1", "s2", "s3", "s4", "tauX", "tauY",
];

/// The distortion of a rectilinear lens, as OpenCV defines it (D. Brown, Decentering distortion of
/// lenses, Photogrammetric Engineering 32, 1966; the rational factor: D. Claus and A. Fitzgibbon, A
/// rational function lens distortion model, CVPR 2005).
///
/// With `x = X/Z`, `y = Y/Z` and `s = x² + y²`, a point is seen at
///
/// ```text
/// x' = q x + 2 p₁ x y + p₂ (s + 2x²) + s₁ s + s₂ s²
/// y' = q y + p₁ (s + 2y²) + 2 p₂ x y + s₃ s + s₄ s²
/// q = (1 + k₁ s + k₂ s² + k₃ s³)/(1 + k₄ s + k₅ s² + k₆ s³)
/// ```
///
/// and, where τx or τy is not zero, this image is projected onto a sensor that is rotated by τx
/// about x and by τy about y. All coefficients but the angles, in radians, are pure numbers.
///
/// The radial factor is one-to-one up to a radius; what lies beyond is outside the
/// [field](Self::field_radius), and not seen.
///
/// ```
/// use ga_camera::{Intrinsics, Lens, RadialTangential};
/// let lens = RadialTangential::new(&[-0.3, 0.1, 1e-3, -2e-3, 0.0])?;
/// let camera = Intrinsics::new([500.0, 500.0], [320.0, 240.0])?.with_lens(lens);
/// let direction = camera.direction([20.0, 50.0])?;
/// let pixel = camera.project(direction.coordinates().into())?;
/// assert!((pixel[0] - 20.0).abs() < 1e-10 && (pixel[1] - 50.0).abs() < 1e-10);
/// # Ok::<(), ga_camera::CameraError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RadialTangential {
    coefficients: [f64; 14],
    tilt: Option<Tilt>,
    field: f64,
}

/// A distorted image and its derivatives by the undistorted one and by the coefficients, by rows.
pub(super) struct Distorted {
    pub(super) image: [f64; 2],
    pub(super) by_image: [[f64; 2]; 2],
    pub(super) by_coefficients: [[f64; 14]; 2],
}

/// Why an image has no undistorted one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum NoInverse {
    OutsideField,
    NotConverged,
}

impl RadialTangential {
    /// The distortion with the coefficients `k1 k2 p1 p2 [k3 [k4 k5 k6 [s1 s2 s3 s4 [τx τy]]]]`:
    /// 4, 5, 8, 12 or 14 of them, in OpenCV's order.
    ///
    /// # Errors
    /// [`CameraError::CoefficientCount`] for another number of coefficients,
    /// [`CameraError::Coefficient`] for one that is not finite and for an angle of π/2 or more.
    pub fn new(coefficients: &[f64]) -> Result<Self, CameraError> {
        if ![4, 5, 8, 12, 14].contains(&coefficients.len()) {
            return Err(CameraError::CoefficientCount {
                found: coefficients.len(),
                expected: "4, 5, 8, 12 or 14",
            });
        }
        let mut all = [0.0; 14];
        all[..coefficients.len()].copy_from_slice(coefficients);
        for (name, value) in NAMES.into_iter().zip(all) {
            if !value.is_finite() {
                return Err(CameraError::Coefficient {
                    name,
                    value,
                    expected: "finite",
                });
            }
        }
        Ok(Self {
            coefficients: all,
            tilt: Tilt::new(all[12], all[13])?,
            field: field_radius(&all),
        })
    }

    /// All coefficients, in OpenCV's order: `k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4 τx τy`.
    #[must_use]
    pub fn coefficients(&self) -> [f64; 14] {
        self.coefficients
    }

    /// The tangent of the angle from the optical axis up to which the radial factor maps circles to
    /// larger and larger circles; infinity where it always does.
    #[must_use]
    pub fn field_radius(&self) -> f64 {
        self.field
    }

    /// The distorted image of the point `(x, y, 1)`, without regard to the field.
    pub(super) fn distort(&self, image: [f64; 2]) -> [f64; 2] {
        let flat = self.distort_on_plane(image);
        self.tilt.map_or(flat, |tilt| tilt.apply(flat))
    }

    pub(super) fn is_in_field(&self, [x, y]: [f64; 2]) -> bool {
        x * x + y * y < self.field * self.field
    }

    fn distort_on_plane(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [_, _, p1, p2, _, _, _, _, s1, s2, s3, s4, _, _] = self.coefficients;
        let s = x * x + y * y;
        let (upper, lower) = self.quotient(s);
        let factor = upper / lower;
        let cross = 2.0 * x * y;
        [
            x * factor + p1 * cross + p2 * (s + 2.0 * x * x) + (s1 + s2 * s) * s,
            y * factor + p1 * (s + 2.0 * y * y) + p2 * cross + (s3 + s4 * s) * s,
        ]
    }

    /// Numerator and denominator of the radial factor at a squared radius.
    fn quotient(&self, s: f64) -> (f64, f64) {
        let [k1, k2, _, _, k3, k4, k5, k6, ..] = self.coefficients;
        (
            1.0 + s * (k1 + s * (k2 + s * k3)),
            1.0 + s * (k4 + s * (k5 + s * k6)),
        )
    }

    /// The radial factor and its derivative by the squared radius.
    fn factor(&self, s: f64) -> (f64, f64) {
        let [k1, k2, _, _, k3, k4, k5, k6, ..] = self.coefficients;
        let (upper, lower) = self.quotient(s);
        let upper_slope = k1 + s * (2.0 * k2 + s * 3.0 * k3);
        let lower_slope = k4 + s * (2.0 * k5 + s * 3.0 * k6);
        let factor = upper / lower;
        (factor, (upper_slope - factor * lower_slope) / lower)
    }

    fn plane_jacobian(&self, [x, y]: [f64; 2]) -> [[f64; 2]; 2] {
        let [_, _, p1, p2, _, _, _, _, s1, s2, s3, s4, _, _] = self.coefficients;
        let s = x * x + y * y;
        let (factor, slope) = self.factor(s);
        let mixed = 2.0 * (x * y * slope + p1 * x + p2 * y);
        let (prism_x, prism_y) = (2.0 * (s1 + 2.0 * s2 * s), 2.0 * (s3 + 2.0 * s4 * s));
        [
            [
                factor + 2.0 * (x * x * slope + p1 * y + 3.0 * p2 * x) + prism_x * x,
                mixed + prism_x * y,
            ],
            [
                mixed + prism_y * x,
                factor + 2.0 * (y * y * slope + 3.0 * p1 * y + p2 * x) + prism_y * y,
            ],
        ]
    }

    pub(super) fn derivatives(&self, image: [f64; 2]) -> Distorted {
        let [x, y] = image;
        let s = x * x + y * y;
        let (upper, lower) = self.quotient(s);
        let (rising, falling) = (1.0 / lower, -upper / (lower * lower));
        let powers = [s, s * s, s * s * s];
        let cross = 2.0 * x * y;
        // The last two, by the angles, are those of the tilt.
        let row = |at: f64, by_p1: f64, by_p2: f64, prism: [f64; 4]| {
            let [k1, k2, k3] = powers.map(|power| at * power * rising);
            let [k4, k5, k6] = powers.map(|power| at * power * falling);
            let [s1, s2, s3, s4] = prism;
            [
                k1, k2, by_p1, by_p2, k3, k4, k5, k6, s1, s2, s3, s4, 0.0, 0.0,
            ]
        };
        let by_coefficients = [
            row(x, cross, s + 2.0 * x * x, [s, s * s, 0.0, 0.0]),
            row(y, s + 2.0 * y * y, cross, [0.0, 0.0, s, s * s]),
        ];
        let flat = Distorted {
            image: self.distort_on_plane(image),
            by_image: self.plane_jacobian(image),
            by_coefficients,
        };
        match self.tilt {
            None => Distorted {
                by_coefficients: self.with_untilted_angles(flat.by_coefficients, flat.image),
                ..flat
            },
            Some(tilt) => tilted(&flat, &tilt),
        }
    }

    /// The derivatives by the two angles where both are zero: the sensor's plane recedes by
    /// `τy x − τx y`, and the image moves towards the axis in proportion.
    fn with_untilted_angles(
        &self,
        mut by_coefficients: [[f64; 14]; 2],
        [x, y]: [f64; 2],
    ) -> [[f64; 14]; 2] {
        for (row, at) in by_coefficients.iter_mut().zip([x, y]) {
            row[12] = at * y;
            row[13] = -at * x;
        }
        by_coefficients
    }

    /// The inverse of [`distort`](Self::distort), inside the field.
    pub(super) fn undistort(&self, image: [f64; 2]) -> Result<[f64; 2], NoInverse> {
        let flat = self.tilt.map_or(image, |tilt| tilt.remove(image));
        let radius = flat[0].hypot(flat[1]);
        let radial = inverse(radius, self.field, |r| {
            let (factor, slope) = self.factor(r * r);
            (r * factor, factor + 2.0 * r * r * slope)
        });
        let [_, _, p1, p2, _, _, _, _, s1, s2, s3, s4, _, _] = self.coefficients;
        let is_radial = [p1, p2, s1, s2, s3, s4].iter().all(|c| *c == 0.0);
        let start = match radial {
            Some(found) if radius > 0.0 => flat.map(|x| x / radius * found),
            Some(_) => flat,
            None if is_radial => return Err(NoInverse::OutsideField),
            // The other terms may bring an image a little beyond the radial border back inside.
            None if self.field.is_finite() => flat.map(|x| x / radius * 0.99 * self.field),
            None => return Err(NoInverse::OutsideField),
        };
        if is_radial {
            return Ok(start);
        }
        let found = self.newton(flat, start)?;
        let [[a, b], [c, d]] = self.plane_jacobian(found);
        if self.is_in_field(found) && a * d - b * c > 0.0 {
            Ok(found)
        } else {
            Err(NoInverse::OutsideField)
        }
    }

    /// Newton's method in two variables, with steps that are halved until the distance falls.
    fn newton(&self, target: [f64; 2], start: [f64; 2]) -> Result<[f64; 2], NoInverse> {
        let miss = |place: [f64; 2]| {
            let [x, y] = self.distort_on_plane(place);
            [target[0] - x, target[1] - y]
        };
        let scale = 1.0 + target[0].abs() + target[1].abs();
        let mut place = start;
        let mut rest = miss(place);
        for _ in 0..100 {
            let distance = rest[0].hypot(rest[1]);
            if distance == 0.0 {
                break;
            }
            let [[a, b], [c, d]] = self.plane_jacobian(place);
            let determinant = a * d - b * c;
            let step = [
                (d * rest[0] - b * rest[1]) / determinant,
                (a * rest[1] - c * rest[0]) / determinant,
            ];
            let mut length = 1.0;
            let better = loop {
                let next = [place[0] + length * step[0], place[1] + length * step[1]];
                let left = miss(next);
                if left[0].hypot(left[1]) < distance {
                    break Some((next, left));
                }
                length *= 0.5;
                if length < 1e-4 {
                    break None;
                }
            };
            let Some((next, left)) = better else { break };
            (place, rest) = (next, left);
        }
        // The limit is far above rounding and far below a thousandth of a pixel.
        if rest[0].hypot(rest[1]) <= 1e-12 * scale {
            Ok(place)
        } else {
            Err(NoInverse::NotConverged)
        }
    }
}

fn tilted(flat: &Distorted, tilt: &Tilt) -> Distorted {
    let (outer, by_angle) = tilt.derivatives(flat.image);
    let combine =
        |row: usize, upper: f64, lower: f64| outer[row][0] * upper + outer[row][1] * lower;
    let by_image =
        [0, 1].map(|row| [0, 1].map(|k| combine(row, flat.by_image[0][k], flat.by_image[1][k])));
    let by_coefficients = [0, 1].map(|row| {
        let [upper, lower] = &flat.by_coefficients;
        let mut all: [f64; 14] = std::array::from_fn(|k| combine(row, upper[k], lower[k]));
        all[12..].copy_from_slice(&by_angle[row]);
        all
    });
    Distorted {
        image: tilt.apply(flat.image),
        by_image,
        by_coefficients,
    }
}

/// The radius at which the radial factor `r N(r²)/D(r²)` stops rising, or has a pole.
fn field_radius(coefficients: &[f64; 14]) -> f64 {
    let [k1, k2, _, _, k3, k4, k5, k6, ..] = *coefficients;
    // d(r N/D)/dr = ((N + 2s N') D − 2s N D')/D² with s = r².
    let (upper, lower) = ([1.0, k1, k2, k3], [1.0, k4, k5, k6]);
    let mut slope = [0.0; 7];
    for (i, n) in upper.into_iter().enumerate() {
        for (j, d) in lower.into_iter().enumerate() {
            slope[i + j] += n * d * (1.0 + 2.0 * (i as f64 - j as f64));
        }
    }
    least_positive_root(&slope)
        .min(least_positive_root(&lower))
        .sqrt()
}
