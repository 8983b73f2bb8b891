//! Disparity maps: for each pixel of a rectified left view, how many pixels further left the right
//! view shows the same point.
//!
//! The point that the left view shows at column *u* lies at column *u* − *d* of the same row of the
//! right view. The disparity *d* is large for what is near, and 0 at infinity for cameras with
//! parallel optical axes and equal principal points.
//!
//! - [`DisparityMap`]: the map itself; [`file`](mod@file): maps in PFM, PNG and PGM files.
//! - [`range`](mod@range): the range of the disparities of two views.
//! - [`evaluation`]: how far a map is from a known truth; [`visibility`]: where both cameras see
//!   it.
//! - [`picture`]: maps and their errors in colours.

mod error;
pub mod evaluation;
pub mod file;
mod map_error;
pub mod picture;
pub mod range;
pub mod visibility;

pub use error::StereoError;
pub use map_error::DisparityMapError;

use ga_image::plane::{Plane, PlaneView};

/// The disparity of each pixel of the left view, in pixels; NaN where it is unknown.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_vision::disparity::DisparityMap;
///
/// let map = DisparityMap::new(Plane::from_values(3, 1, vec![1.5, f32::INFINITY, 4.0])?);
/// assert_eq!(map.get(0, 0), Some(1.5));
/// assert_eq!(map.get(1, 0), None);
/// assert_eq!((map.known(), map.range()), (2, Some([1.5, 4.0])));
/// # Ok::<(), ga_image::plane::PlaneError>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct DisparityMap {
    pixels: Plane<f32>,
}

impl DisparityMap {
    /// The map of these disparities in pixels. Those that are not finite are unknown.
    #[must_use]
    pub fn new(mut pixels: Plane<f32>) -> Self {
        for value in pixels.values_mut() {
            if !value.is_finite() {
                *value = f32::NAN;
            }
        }
        Self { pixels }
    }

    /// Columns.
    #[must_use]
    pub fn width(&self) -> usize {
        self.pixels.width()
    }

    /// Rows.
    #[must_use]
    pub fn height(&self) -> usize {
        self.pixels.height()
    }

    /// The disparity of a pixel, or `None` where it is unknown or outside the map.
    #[must_use]
    pub fn get(&self, column: usize, row: usize) -> Option<f32> {
        let value = self.pixels.get(column, row)?;
        value.is_finite().then_some(value)
    }

    /// One row; NaN where the disparity is unknown.
    ///
    /// # Panics
    ///
    /// When `row` is not less than the height.
    #[must_use]
    pub fn row(&self, row: usize) -> &[f32] {
        self.pixels.row(row)
    }

    /// All disparities; NaN where one is unknown.
    #[must_use]
    pub fn plane(&self) -> &Plane<f32> {
        &self.pixels
    }

    /// All disparities, borrowed; NaN where one is unknown.
    #[must_use]
    pub fn view(&self) -> PlaneView<'_, f32> {
        self.pixels.view()
    }

    /// All disparities; NaN where one is unknown.
    #[must_use]
    pub fn into_plane(self) -> Plane<f32> {
        self.pixels
    }

    /// How many disparities are known.
    #[must_use]
    pub fn known(&self) -> usize {
        self.known_values().count()
    }

    /// The least and the greatest known disparity, or `None` where all are unknown.
    #[must_use]
    pub fn range(&self) -> Option<[f32; 2]> {
        let spread = |[low, high]: [f32; 2], value: f32| [low.min(value), high.max(value)];
        self.known_values()
            .map(|v| [v, v])
            .reduce(|range, [v, _]| spread(range, v))
    }

    fn known_values(&self) -> impl Iterator<Item = f32> {
        let values = self.pixels.values().iter().copied();
        values.filter(|value| value.is_finite())
    }
}

impl PartialEq for DisparityMap {
    /// Whether the sizes and all disparities are equal, and the same ones are unknown.
    fn eq(&self, other: &Self) -> bool {
        let same = |(a, b): (&f32, &f32)| a == b || (a.is_nan() && b.is_nan());
        let values = self.pixels.values().iter().zip(other.pixels.values());
        (self.width(), self.height()) == (other.width(), other.height())
            && values.into_iter().all(same)
    }
}
