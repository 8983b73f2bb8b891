//! Fisheye lenses.

use std::f64::consts::PI;

use super::error::CameraError;
use super::monotone::{inverse, least_positive_root};

/// The names of the coefficients, in OpenCV's order.
pub(super) const NAMES: [&str; 4] = ["k1", "k2", "k3", "k4"];

/// A fisheye lens, as OpenCV defines it (J. Kannala and S. Brandt, A generic camera model and
/// calibration method for conventional, wide-angle, and fish-eye lenses, PAMI 28, 2006).
///
/// A point at the angle θ from the optical axis is seen in its own azimuth, at the radius
///
/// ```text
/// θ' = θ (1 + k₁ θ² + k₂ θ⁴ + k₃ θ⁶ + k₄ θ⁸)
/// ```
///
/// With all coefficients zero, radii are proportional to angles (the equidistant projection).
/// Angles of π/2 and more are allowed, so points beside and behind the camera may be seen.
///
/// The radius rises up to an angle; what lies beyond is outside the [field](Self::field_angle), and
/// not seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fisheye {
    coefficients: [f64; 4],
    field: f64,
}

/// An image and its derivatives by the point and by the coefficients, by rows.
pub(super) struct FisheyeImage {
    pub(super) image: [f64; 2],
    pub(super) by_point: [[f64; 3]; 2],
    pub(super) by_coefficients: [[f64; 4]; 2],
}

impl Fisheye {
    /// The lens with the coefficients k₁ to k₄.
    ///
    /// # Errors
    /// [`CameraError::CoefficientCount`] for another number of coefficients,
    /// [`CameraError::Coefficient`] for one that is not finite.
    pub fn new(coefficients: &[f64]) -> Result<Self, CameraError> {
        let coefficients: [f64; 4] =
            coefficients
                .try_into()
                .map_err(|_| CameraError::CoefficientCount {
                    found: coefficients.len(),
                    expected: "4",
                })?;
        for (name, value) in NAMES.into_iter().zip(coefficients) {
            if !value.is_finite() {
                return Err(CameraError::Coefficient {
                    name,
                    value,
                    expected: "finite",
                });
            }
        }
        let [k1, k2, k3, k4] = coefficients;
        let slope = [1.0, 3.0 * k1, 5.0 * k2, 7.0 * k3, 9.0 * k4];
        Ok(Self {
            coefficients,
            field: least_positive_root(&slope).sqrt().min(PI),
        })
    }

    /// The coefficients k₁ to k₄.
    #[must_use]
    pub fn coefficients(&self) -> [f64; 4] {
        self.coefficients
    }

    /// The angle from the optical axis up to which larger angles are seen at larger radii, at most
    /// π, in radians.
    #[must_use]
    pub fn field_angle(&self) -> f64 {
        self.field
    }

    /// The radius of an angle, and its derivative.
    fn radius(&self, angle: f64) -> (f64, f64) {
        let [k1, k2, k3, k4] = self.coefficients;
        let t = angle * angle;
        (
            angle * (1.0 + t * (k1 + t * (k2 + t * (k3 + t * k4)))),
            1.0 + t * (3.0 * k1 + t * (5.0 * k2 + t * (7.0 * k3 + t * 9.0 * k4))),
        )
    }

    pub(super) fn is_in_field(&self, [x, y, z]: [f64; 3]) -> bool {
        x.hypot(y).atan2(z) < self.field
    }

    /// The image of a point, without regard to the field.
    pub(super) fn image(&self, [x, y, z]: [f64; 3]) -> [f64; 2] {
        let away = x.hypot(y);
        if away == 0.0 {
            return [0.0; 2];
        }
        let (radius, _) = self.radius(away.atan2(z));
        [x / away * radius, y / away * radius]
    }

    /// With the unit vector u of the azimuth, the distance ρ from the axis and `n² = ρ² + z²`:
    /// `∂/∂(x, y) = (θ'/ρ) (1 − u uᵀ) + (dθ'/dθ) (z/n²) u uᵀ` and `∂/∂z = −(dθ'/dθ) (ρ/n²) u`.
    pub(super) fn derivatives(&self, [x, y, z]: [f64; 3]) -> FisheyeImage {
        let away = x.hypot(y);
        let distance_squared = away * away + z * z;
        let angle = away.atan2(z);
        let (radius, slope) = self.radius(angle);
        let azimuth = if away > 0.0 {
            [x / away, y / away]
        } else {
            [1.0, 0.0]
        };
        let across = if away > 0.0 { radius / away } else { 1.0 / z };
        let along = slope * z / distance_squared;
        let inwards = -slope * away / distance_squared;
        let powers = [3, 5, 7, 9].map(|power| angle.powi(power));
        let [u, v] = azimuth;
        let mixed = (along - across) * u * v;
        FisheyeImage {
            image: azimuth.map(|u| u * radius),
            by_point: [
                [across * v * v + along * u * u, mixed, inwards * u],
                [mixed, across * u * u + along * v * v, inwards * v],
            ],
            by_coefficients: azimuth.map(|u| powers.map(|power| u * power)),
        }
    }

    /// The direction that is seen at an image, of length 1; `None` outside the field.
    pub(super) fn direction(&self, [x, y]: [f64; 2]) -> Option<[f64; 3]> {
        let radius = x.hypot(y);
        let angle = inverse(radius, self.field, |angle| self.radius(angle))?;
        if radius == 0.0 {
            return Some([0.0, 0.0, 1.0]);
        }
        let (sine, cosine) = angle.sin_cos();
        Some([x / radius * sine, y / radius * sine, cosine])
    }
}
