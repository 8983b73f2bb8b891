//! How far a disparity map is from a known truth, by the measures of the stereo evaluations of
//! Middlebury (D. Scharstein and R. Szeliski, "A taxonomy and evaluation of dense two-frame stereo
//! correspondence algorithms", International Journal of Computer Vision 47, 2002) and KITTI (M.
//! Menze and A. Geiger, "Object scene flow for autonomous vehicles", Conference on Computer Vision
//! and Pattern Recognition, 2015).

use ga_image::plane::{Plane, PlaneView, same_size};

use serde::Serialize;

use super::DisparityMap;
use super::visibility::{Seen, Visibility};
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
    truth: Plane<f32>,
    pixels: usize,
    known: usize,
}

/// The measures of the evaluations, as percentages of the evaluated pixels unless the name has a
/// unit.
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
    /// Errors of more than 3 px and 5 % of the truth; see [`ErrorMap::d1`].
    pub d1: f64,
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
        let errors = Plane::from_fn(truth.width(), truth.height(), |column, row| {
            let truth = truth.get(column, row).filter(|truth| *truth != 0.0);
            match (truth, found.get(column, row)) {
                (None, _) => f64::NAN,
                (Some(_), None) => f64::INFINITY,
                (Some(truth), Some(found)) => (f64::from(found) - f64::from(truth)).abs(),
            }
        });
        Self::of(errors, truth.plane().clone()).ok_or(DisparityMapError::NoTruth)
    }

    /// `None` where every pixel is left out.
    fn of(errors: Plane<f64>, truth: Plane<f32>) -> Option<Self> {
        let counted = errors.values().iter().filter(|error| !error.is_nan());
        let (pixels, known) = (
            counted.clone().count(),
            counted.filter(|e| e.is_finite()).count(),
        );
        (pixels > 0).then_some(Self {
            errors,
            truth,
            pixels,
            known,
        })
    }

    /// The same without the pixels that are not wanted, whose column and row are given. `None`
    /// where none is left.
    #[must_use]
    pub fn within(&self, is_wanted: impl Fn(usize, usize) -> bool) -> Option<Self> {
        let errors =
            Plane::from_fn(
                self.errors.width(),
                self.errors.height(),
                |column, row| match is_wanted(column, row) {
                    true => self.errors.row(row)[column],
                    false => f64::NAN,
                },
            );
        Self::of(errors, self.truth.clone())
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

    /// The percentage of evaluated pixels whose error is strictly more than 3 px and strictly more
    /// than 5 % of the true disparity, those of unknown disparity included.
    #[must_use]
    pub fn d1(&self) -> f64 {
        let errors = self.errors.values().iter().zip(self.truth.values());
        let is_outlier = |(error, truth): &(&f64, &f32)| {
            **error > 3.0 && **error > 0.05 * f64::from(truth.abs())
        };
        self.percentage(errors.filter(is_outlier).count())
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
            d1: self.d1(),
            average_px: self.average_px(),
            density: self.density(),
            truth_pixels: self.pixels(),
        }
    }

    fn percentage(&self, count: usize) -> f64 {
        100.0 * count as f64 / self.pixels as f64
    }
}

/// The measures of all pixels, and apart those of the ones that both cameras see and of those that
/// the left one alone sees.
#[derive(Clone, Debug, Serialize)]
pub struct Evaluation {
    /// All pixels that count.
    #[serde(flatten)]
    pub all: ErrorMeasures,
    /// Those that both cameras see; `None` where that is not known or none counts.
    pub visible: Option<ErrorMeasures>,
    /// Those that only the left camera sees.
    pub occluded: Option<ErrorMeasures>,
    /// The errors of all.
    #[serde(skip)]
    pub errors: ErrorMap,
}

impl Evaluation {
    /// Compares a map with the truth, where the visibility is given for the pixels that count.
    ///
    /// ```
    /// use ga_image::plane::Plane;
    /// use ga_vision::disparity::DisparityMap;
    /// use ga_vision::disparity::evaluation::Evaluation;
    /// use ga_vision::disparity::visibility::Visibility;
    ///
    /// let map = |values: [f32; 4]| Plane::from_values(4, 1, values.into()).map(DisparityMap::new);
    /// let (found, truth) = (map([20.0, 20.0, 20.0, 20.0])?, map([20.0, 21.0, 28.0, 90.0])?);
    /// // Middlebury's levels: 0 is left out, 255 is seen by both.
    /// let mask = Plane::from_values(4, 1, vec![255u8, 255, 128, 0])?;
    /// let mask = ga_image::png::encode(&mask)?;
    /// let found = Evaluation::new(&found, &truth, Some(&Visibility::decode_mask(&mask)?))?;
    /// assert_eq!((found.all.truth_pixels, found.all.average_px), (3, Some(3.0)));
    /// assert_eq!(found.visible.unwrap().average_px, Some(0.5));
    /// // More than 3 px and 5 % of 28 px.
    /// assert_eq!(found.occluded.unwrap().d1, 100.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// Those of [`ErrorMap::new`], and [`DisparityMapError::MaskSize`].
    pub fn new(
        found: &DisparityMap,
        truth: &DisparityMap,
        visibility: Option<&Visibility>,
    ) -> Result<Self, DisparityMapError> {
        let mut errors = ErrorMap::new(found, truth)?;
        let [mut visible, mut occluded] = [None; 2];
        if let Some(visibility) = visibility {
            let states = visibility.view();
            same_size(truth.view(), states).map_err(DisparityMapError::MaskSize)?;
            let state = |column: usize, row: usize| states.row(row)[column];
            let apart = |wanted: Seen| errors.within(|u, v| state(u, v) == Some(wanted));
            let measures = |wanted| apart(wanted).map(|errors| errors.measures());
            (visible, occluded) = (measures(Seen::ByBoth), measures(Seen::ByLeft));
            let counting = errors.within(|column, row| state(column, row).is_some());
            errors = counting.ok_or(DisparityMapError::NoTruth)?;
        }
        Ok(Self {
            all: errors.measures(),
            visible,
            occluded,
            errors,
        })
    }
}
