//! How far a disparity map is from a known truth, by the measures of the Middlebury stereo
//! evaluation (D. Scharstein and R. Szeliski, "A taxonomy and evaluation of dense two-frame stereo
//! correspondence algorithms", International Journal of Computer Vision 47, 2002).

use ga_image::plane::{Plane, PlaneView, same_size};

use serde::Serialize;

use super::DisparityMap;
use crate::disparity::DisparityMapError;

/// The distance |*d* − *t*| of each disparity *d* from the true one *t*, in pixels.
///
/// Pixels whose truth is 0 or unknown are left out of every measure. Pixels whose truth is known
/// and whose disparity is unknown count as errors beyond every threshold, and are left out of the
/// average.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_vision::disparity::DisparityMap;
/// use ga_vision::disparity::evaluation::ErrorMap;
///
/// let map = |values: [f32; 5]| Plane::from_values(5, 1, values.to_vec()).map(DisparityMap::new);
/// let found = map([4.0, 4.0, 4.0, f32::NAN, 4.0])?;
/// let truth = map([6.0, 3.5, 6.5, 4.0, 0.0])?;
/// let errors = ErrorMap::new(&found, &truth)?;
/// assert_eq!(errors.pixels(), 4);
/// // Those of 2.5 px and of the unknown disparity; one of 2 px is not more than 2 px.
/// assert_eq!(errors.bad(2.0), 50.0);
/// assert_eq!(errors.average_px(), Some((2.0 + 0.5 + 2.5) / 3.0));
/// assert_eq!(errors.density(), 75.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct ErrorMap {
    errors: Plane<f64>,
    pixels: usize,
    known: usize,
}

/// The measures of the Middlebury evaluation, as percentages of the evaluated pixels unless the
/// name has a unit.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ErrorMeasures {
    /// Errors of more than 0.5 px; see [`ErrorMap::bad`].
    pub bad_0_5: f64,
    /// Errors of more than 1 px.
    pub bad_1: f64,
    /// Errors of more than 2 px.
    pub bad_2: f64,
    /// Errors of more than 3 px.
    pub bad_3: f64,
    /// The mean error; see [`ErrorMap::average_px`].
    pub average_px: Option<f64>,
    /// Pixels whose disparity is known.
    pub density: f64,
    /// How many pixels are evaluated.
    pub truth_pixels: usize,
}

impl ErrorMap {
    /// Compares a map with the truth.
    ///
    /// # Errors
    ///
    /// [`DisparityMapError::TruthSize`] when their sizes differ, and [`DisparityMapError::NoTruth`]
    /// when every pixel would be left out.
    pub fn new(found: &DisparityMap, truth: &DisparityMap) -> Result<Self, DisparityMapError> {
        same_size(found.view(), truth.view()).map_err(DisparityMapError::TruthSize)?;
        let (mut pixels, mut known) = (0, 0);
        let errors = Plane::from_fn(truth.width(), truth.height(), |column, row| {
            let truth = truth.get(column, row).filter(|truth| *truth != 0.0);
            let Some(truth) = truth else {
                return f64::NAN;
            };
            pixels += 1;
            let Some(found) = found.get(column, row) else {
                return f64::INFINITY;
            };
            known += 1;
            (f64::from(found) - f64::from(truth)).abs()
        });
        if pixels == 0 {
            return Err(DisparityMapError::NoTruth);
        }
        Ok(Self {
            errors,
            pixels,
            known,
        })
    }

    /// The error of each pixel: NaN where it is left out, infinity where the disparity is unknown.
    #[must_use]
    pub fn view(&self) -> PlaneView<'_, f64> {
        self.errors.view()
    }

    /// How many pixels are evaluated, that is, have a known truth.
    #[must_use]
    pub fn pixels(&self) -> usize {
        self.pixels
    }

    /// The percentage of evaluated pixels whose error is strictly more than `threshold_px`, those
    /// of unknown disparity included.
    #[must_use]
    pub fn bad(&self, threshold_px: f64) -> f64 {
        let errors = self.errors.values().iter();
        self.percentage(errors.filter(|error| **error > threshold_px).count())
    }

    /// The mean error of evaluated pixels whose disparity is known, in pixels, or `None` where
    /// there are none.
    #[must_use]
    pub fn average_px(&self) -> Option<f64> {
        let errors = self
            .errors
            .values()
            .iter()
            .filter(|error| error.is_finite());
        (self.known > 0).then(|| errors.sum::<f64>() / self.known as f64)
    }

    /// The percentage of evaluated pixels whose disparity is known.
    #[must_use]
    pub fn density(&self) -> f64 {
        self.percentage(self.known)
    }

    /// All measures.
    #[must_use]
    pub fn measures(&self) -> ErrorMeasures {
        ErrorMeasures {
            bad_0_5: self.bad(0.5),
            bad_1: self.bad(1.0),
            bad_2: self.bad(2.0),
            bad_3: self.bad(3.0),
            average_px: self.average_px(),
            density: self.density(),
            truth_pixels: self.pixels(),
        }
    }

    fn percentage(&self, count: usize) -> f64 {
        100.0 * count as f64 / self.pixels as f64
    }
}
