//! Blur by a Gaussian.

use super::Border;
use super::separable::convolve;
use crate::plane::{Plane, PlaneError, PlaneView};
use crate::sample::Pixel;

/// A Gaussian of standard deviation σ pixels along each axis, cut off at a radius and divided by
/// its sum: w(d) ∝ exp(−d² / 2σ²) for whole d from −r to r.
///
/// ```
/// use ga_image::filter::{Border, Gaussian};
/// use ga_image::plane::Plane;
///
/// let mut plane = Plane::filled(21, 21, [0.0, 1.0]);
/// plane.values_mut()[10 * 21 + 10] = [1.0, 1.0];
/// let gaussian = Gaussian::new(1.5)?;
/// assert_eq!(gaussian.radius(), 6);
/// let blurred = gaussian.blur(&plane, Border::Reflect);
/// let peak = gaussian.weights()[6];
/// assert!((blurred.get(10, 10).unwrap()[0] - (peak * peak) as f32).abs() < 1e-7);
/// # Ok::<(), ga_image::plane::PlaneError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Gaussian {
    weights: Vec<f64>,
}

impl Gaussian {
    /// A Gaussian cut off at 4 σ, as SciPy does by default.
    ///
    /// # Errors
    ///
    /// [`PlaneError::Gaussian`] unless σ is positive and not above 16384.
    pub fn new(sigma: f64) -> Result<Self, PlaneError> {
        Self::truncated(sigma, 4.0)
    }

    /// A Gaussian cut off at `truncate` σ, rounded to the nearest number of pixels, halves upwards.
    ///
    /// # Errors
    ///
    /// [`PlaneError::Gaussian`] unless σ is positive and the radius is between 0 and 65536.
    pub fn truncated(sigma: f64, truncate: f64) -> Result<Self, PlaneError> {
        let radius = (truncate * sigma + 0.5).floor();
        if !(sigma > 0.0 && (0.0..=65536.0).contains(&radius)) {
            return Err(PlaneError::Gaussian { sigma, truncate });
        }
        let radius = radius as i32;
        let weight = |d: i32| (-0.5 * (f64::from(d) / sigma).powi(2)).exp();
        let sum: f64 = (-radius..=radius).map(weight).sum();
        Ok(Self {
            weights: (-radius..=radius).map(|d| weight(d) / sum).collect(),
        })
    }

    /// The number of pixels on either side that take part.
    #[must_use]
    pub fn radius(&self) -> usize {
        self.weights.len() / 2
    }

    /// The weights along one axis, from −r to r. Their sum is 1.
    #[must_use]
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// The blurred picture. Sums are taken in `f32`, and integers are rounded once at the end.
    #[must_use]
    pub fn blur<'a, P: Pixel>(
        &self,
        picture: impl Into<PlaneView<'a, P>>,
        border: Border,
    ) -> Plane<P> {
        let outwards = &self.weights[self.radius()..];
        let weights: Vec<f32> = outwards.iter().map(|w| *w as f32).collect();
        convolve(picture.into(), &weights, border)
    }
}
