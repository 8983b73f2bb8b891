//! Pictures seen through a map of places.

use crate::interpolation::{mixed, six_cubic_weights};
use crate::plane::{Plane, PlaneError, PlaneView, PlaneViewMut};
use crate::sample::{Pixel, Sample};

/// Where each pixel of a new picture lies in an old one, computed once for many pictures.
///
/// Places are in pixels of the old picture from its top left corner, so that the centre of the
/// pixel in column *c* and row *r* is at (*c* + ½, *r* + ½). Pixels are interpolated linearly
/// between the centres of the four nearest, or as [`Interpolation`] says. Near the border, where
/// some of the pixels are missing, the outermost ones continue; what lies outside the old picture
/// gets a given value. A pixel of weight 0 has no influence, whatever its value.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_image::warp::Warp;
///
/// let picture = Plane::from_values(3, 1, vec![10u8, 20, 40])?;
/// // Half a pixel to the left.
/// let warp = Warp::new([3, 1], [3, 1], |[x, y]| Some([x + 0.5, y]));
/// assert_eq!(warp.warped(&picture, 0)?.values(), [15, 30, 40]);
/// // The last of them lies on the border, which belongs to the picture.
/// assert_eq!(warp.inside().values(), [true, true, true]);
/// # Ok::<(), ga_image::plane::PlaneError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Warp {
    source: [usize; 2],
    places: Plane<Place>,
    interpolation: Interpolation,
}

/// How values between the centres of pixels follow from those of the pixels around them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Interpolation {
    /// Linearly along both axes, from the four nearest.
    #[default]
    Linear,
    /// By cubic convolution along both axes, from six columns and six rows, which keeps pictures
    /// sharp; see [`six_cubic_weights`]. Beside edges values may leave the range of the pixels
    /// around.
    Cubic,
}

/// The pixel up and left of a place, and the parts of the way to the next column and row. A
/// negative part marks a place outside the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Place {
    column: u32,
    row: u32,
    right: f32,
    down: f32,
}

const OUTSIDE: Place = Place {
    column: 0,
    row: 0,
    right: -1.0,
    down: -1.0,
};

impl Warp {
    /// A map for pictures of the size `source`, from the place in the old picture of each place in
    /// the new one; `None` for what is not in the old picture. Sizes are columns and rows.
    #[must_use]
    pub fn new(
        size: [usize; 2],
        source: [usize; 2],
        mut place: impl FnMut([f64; 2]) -> Option<[f64; 2]>,
    ) -> Self {
        let places = Plane::from_fn(size[0], size[1], |column, row| {
            let centre = [column as f64 + 0.5, row as f64 + 0.5];
            place(centre).map_or(OUTSIDE, |place| Place::new(place, source))
        });
        Self {
            source,
            places,
            interpolation: Interpolation::default(),
        }
    }

    /// The same map with another interpolation.
    ///
    /// ```
    /// use ga_image::plane::Plane;
    /// use ga_image::warp::{Interpolation, Warp};
    ///
    /// // The squares of 0 to 5, half a pixel farther: cubic convolution is exact for them.
    /// let squares = Plane::from_values(6, 1, vec![0.0_f32, 1.0, 4.0, 9.0, 16.0, 25.0])?;
    /// let warp = Warp::new([6, 1], [6, 1], |[x, y]| Some([(x + 0.5).min(6.0), y]));
    /// let warp = warp.with_interpolation(Interpolation::Cubic);
    /// assert!((warp.warped(&squares, 0.0)?.values()[2] - 6.25).abs() < 1e-5);
    /// # Ok::<(), ga_image::plane::PlaneError>(())
    /// ```
    #[must_use]
    pub fn with_interpolation(mut self, interpolation: Interpolation) -> Self {
        self.interpolation = interpolation;
        self
    }

    /// Columns and rows of the new pictures.
    #[must_use]
    pub fn size(&self) -> [usize; 2] {
        [self.places.width(), self.places.height()]
    }

    /// Columns and rows of the old pictures.
    #[must_use]
    pub fn source_size(&self) -> [usize; 2] {
        self.source
    }

    /// Which pixels of the new picture lie in the old one.
    #[must_use]
    pub fn inside(&self) -> Plane<bool> {
        self.places.map(|place| place.right >= 0.0)
    }

    /// Writes the new picture of an old one, with `outside` for what lies outside it. Nothing is
    /// allocated.
    ///
    /// # Errors
    /// [`PlaneError::Differs`] where a picture does not have the size of the map.
    pub fn apply<'a, P: Pixel>(
        &self,
        picture: impl Into<PlaneView<'a, P>>,
        outside: P,
        mut result: PlaneViewMut<'_, P>,
    ) -> Result<(), PlaneError> {
        let picture = picture.into();
        same_size([picture.width(), picture.height()], self.source)?;
        same_size([result.width(), result.height()], self.size())?;
        for (row, places) in self.places.rows().enumerate() {
            for (pixel, place) in result.row_mut(row).iter_mut().zip(places) {
                *pixel = if place.right < 0.0 {
                    outside
                } else {
                    match self.interpolation {
                        Interpolation::Linear => place.linear(picture),
                        Interpolation::Cubic => place.cubic(picture),
                    }
                };
            }
        }
        Ok(())
    }

    /// The new picture of an old one, as [`apply`](Self::apply) writes it.
    ///
    /// # Errors
    /// As [`apply`](Self::apply).
    pub fn warped<'a, P: Pixel>(
        &self,
        picture: impl Into<PlaneView<'a, P>>,
        outside: P,
    ) -> Result<Plane<P>, PlaneError> {
        let mut result = Plane::filled(self.places.width(), self.places.height(), outside);
        self.apply(picture, outside, result.view_mut())?;
        Ok(result)
    }
}

fn same_size(first: [usize; 2], second: [usize; 2]) -> Result<(), PlaneError> {
    if first == second {
        Ok(())
    } else {
        Err(PlaneError::Differs { first, second })
    }
}

impl Place {
    fn new([x, y]: [f64; 2], [width, height]: [usize; 2]) -> Self {
        let is_inside = x >= 0.0 && y >= 0.0 && x <= width as f64 && y <= height as f64;
        if !is_inside || width == 0 || height == 0 {
            return OUTSIDE;
        }
        let (column, right) = split(x, width);
        let (row, down) = split(y, height);
        Self {
            column,
            row,
            right,
            down,
        }
    }

    fn linear<P: Pixel>(self, picture: PlaneView<'_, P>) -> P {
        let (column, row) = (self.column as usize, self.row as usize);
        let right = (column + 1).min(picture.width() - 1);
        let below = (row + 1).min(picture.height() - 1);
        let (upper, lower) = (picture.row(row), picture.row(below));
        let corners = [upper[column], upper[right], lower[column], lower[right]];
        let mut result = P::default();
        let channels = P::samples_mut(std::slice::from_mut(&mut result));
        for (channel, value) in channels.iter_mut().enumerate() {
            let values = [0, 1, 2, 3]
                .map(|k: usize| P::samples(std::slice::from_ref(&corners[k]))[channel].to_f32());
            *value = P::Sample::from_f32(mixed(values, [self.right, self.down]));
        }
        result
    }

    fn cubic<P: Pixel>(self, picture: PlaneView<'_, P>) -> P {
        let around = |first: u32, length: usize| {
            let (first, last) = (first as usize, length - 1);
            [0, 1, 2, 3, 4, 5].map(|step: usize| (first + step).saturating_sub(2).min(last))
        };
        let columns = around(self.column, picture.width());
        let rows = around(self.row, picture.height());
        let [across, down] =
            [self.right, self.down].map(|part| six_cubic_weights(part.into()).map(|w| w as f32));
        let mut result = P::default();
        let channels = P::samples_mut(std::slice::from_mut(&mut result));
        for (channel, value) in channels.iter_mut().enumerate() {
            let mut sum = 0.0;
            for (row, by_row) in rows.into_iter().zip(down) {
                let pixels = picture.row(row);
                for (column, by_column) in columns.into_iter().zip(across) {
                    let weight = by_row * by_column;
                    // A pixel that has no part may be infinite.
                    if weight != 0.0 {
                        let pixel = std::slice::from_ref(&pixels[column]);
                        sum += weight * P::samples(pixel)[channel].to_f32();
                    }
                }
            }
            *value = P::Sample::from_f32(sum);
        }
        result
    }
}

/// The index of the pixel whose centre is at or before a coordinate, and the part of the way to the
/// next centre.
fn split(coordinate: f64, count: usize) -> (u32, f32) {
    let from_first = (coordinate - 0.5).clamp(0.0, (count - 1) as f64);
    let index = from_first.floor();
    (index as u32, (from_first - index) as f32)
}
