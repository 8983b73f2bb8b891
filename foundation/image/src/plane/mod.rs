//! Planes: grids of pixels, owned and borrowed.

mod error;
mod view;

pub use error::PlaneError;
pub use view::{PlaneView, PlaneViewMut, same_size};

/// A grid of pixels, row by row without gaps.
///
/// A pixel may be any `Copy` type: a number for a picture in grey, for depth or for a weight;
/// `[u8; 3]` for a picture in colour, whose channels then lie beside each other. A rectangle of a
/// plane is a [`PlaneView`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Plane<T = f32> {
    width: usize,
    height: usize,
    values: Vec<T>,
}

impl<T: Copy> Plane<T> {
    /// A plane with the same value everywhere.
    ///
    /// ```
    /// use ga_image::plane::Plane;
    ///
    /// let mut plane = Plane::filled(3, 2, 0.0);
    /// plane.values_mut()[3] = 0.5;
    /// assert_eq!(plane.get(0, 1), Some(0.5));
    /// assert_eq!(plane.map(|value| 2.0 * value).get(0, 1), Some(1.0));
    /// assert_eq!(plane.get(3, 0), None);
    /// ```
    #[must_use]
    pub fn filled(width: usize, height: usize, value: T) -> Self {
        Self {
            width,
            height,
            values: vec![value; width * height],
        }
    }

    /// The plane of what `value` gives for each column and row.
    #[must_use]
    pub fn from_fn(width: usize, height: usize, mut value: impl FnMut(usize, usize) -> T) -> Self {
        let mut values = Vec::with_capacity(width * height);
        for row in 0..height {
            values.extend((0..width).map(|column| value(column, row)));
        }
        Self {
            width,
            height,
            values,
        }
    }

    /// The plane of these values, row by row.
    ///
    /// # Errors
    ///
    /// [`PlaneError::Length`] when their number is not `width * height`.
    pub fn from_values(width: usize, height: usize, values: Vec<T>) -> Result<Self, PlaneError> {
        if width.checked_mul(height) == Some(values.len()) {
            Ok(Self {
                width,
                height,
                values,
            })
        } else {
            Err(PlaneError::Length {
                width,
                height,
                length: values.len(),
            })
        }
    }

    /// The plane of what `change` gives for the values of this one.
    #[must_use]
    pub fn map<U: Copy>(&self, change: impl FnMut(T) -> U) -> Plane<U> {
        Plane {
            width: self.width,
            height: self.height,
            values: self.values.iter().copied().map(change).collect(),
        }
    }

    /// Columns.
    #[must_use]
    pub fn width(&self) -> usize {
        self.width
    }

    /// Rows.
    #[must_use]
    pub fn height(&self) -> usize {
        self.height
    }

    /// Whether there are no pixels.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// All values, row by row.
    #[must_use]
    pub fn values(&self) -> &[T] {
        &self.values
    }

    /// All values, to be changed.
    pub fn values_mut(&mut self) -> &mut [T] {
        &mut self.values
    }

    /// All values, row by row.
    #[must_use]
    pub fn into_values(self) -> Vec<T> {
        self.values
    }

    /// The value of a pixel, or `None` outside the plane.
    #[must_use]
    pub fn get(&self, column: usize, row: usize) -> Option<T> {
        self.view().get(column, row)
    }

    /// One row.
    ///
    /// # Panics
    ///
    /// When `row` is not less than the height.
    #[must_use]
    pub fn row(&self, row: usize) -> &[T] {
        self.view().row(row)
    }

    /// One row, to be changed.
    ///
    /// # Panics
    ///
    /// When `row` is not less than the height.
    #[must_use]
    pub fn row_mut(&mut self, row: usize) -> &mut [T] {
        assert!(row < self.height, "row {row} of {}", self.height);
        let width = self.width;
        &mut self.values[row * width..][..width]
    }

    /// All rows, from the top.
    pub fn rows(&self) -> impl DoubleEndedIterator<Item = &[T]> + ExactSizeIterator {
        self.view().rows()
    }

    /// The whole plane, borrowed.
    #[must_use]
    pub fn view(&self) -> PlaneView<'_, T> {
        PlaneView {
            values: &self.values,
            width: self.width,
            height: self.height,
            stride: self.width,
        }
    }

    /// The whole plane, borrowed to be changed.
    #[must_use]
    pub fn view_mut(&mut self) -> PlaneViewMut<'_, T> {
        PlaneViewMut {
            values: &mut self.values,
            width: self.width,
            height: self.height,
            stride: self.width,
        }
    }

    /// The plane with rows and columns exchanged.
    #[must_use]
    pub fn transposed(&self) -> Self {
        /// Squares small enough that their rows and columns stay in the cache.
        const BLOCK: usize = 16;
        let (width, height) = (self.width, self.height);
        let mut values = self.values.clone();
        for top in (0..height).step_by(BLOCK) {
            for left in (0..width).step_by(BLOCK) {
                for row in top..(top + BLOCK).min(height) {
                    for column in left..(left + BLOCK).min(width) {
                        values[column * height + row] = self.values[row * width + column];
                    }
                }
            }
        }
        Self {
            width: height,
            height: width,
            values,
        }
    }
}

impl<T: Copy, const N: usize> Plane<[T; N]> {
    /// A picture whose channels are these planes.
    ///
    /// ```
    /// use ga_image::plane::Plane;
    ///
    /// let grey = Plane::filled(2, 1, 7u8);
    /// let picture = Plane::interleaved([&grey, &grey.map(|v| v + 1), &grey])?;
    /// assert_eq!(picture.values(), [[7, 8, 7]; 2]);
    /// assert_eq!(picture.channel(1).unwrap().values(), [8, 8]);
    /// # Ok::<(), ga_image::plane::PlaneError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`PlaneError::Differs`] when the planes have different sizes, and [`PlaneError::TooSmall`]
    /// when there are none.
    pub fn interleaved(channels: [&Plane<T>; N]) -> Result<Self, PlaneError> {
        let Some(first) = channels.first() else {
            return Err(PlaneError::TooSmall {
                width: 0,
                height: 0,
                least: 1,
            });
        };
        for channel in channels {
            same_size(first.view(), channel.view())?;
        }
        let values = (0..first.values.len()).map(|index| channels.map(|c| c.values[index]));
        Ok(Self {
            width: first.width,
            height: first.height,
            values: values.collect(),
        })
    }

    /// One channel of a picture, or `None` where there is no such channel.
    #[must_use]
    pub fn channel(&self, channel: usize) -> Option<Plane<T>> {
        (channel < N).then(|| self.map(|pixel| pixel[channel]))
    }
}

impl<T: Copy> PlaneView<'_, T> {
    /// A copy of the pixels.
    #[must_use]
    pub fn to_plane(self) -> Plane<T> {
        Plane {
            width: self.width,
            height: self.height,
            values: self.rows().collect::<Vec<_>>().concat(),
        }
    }

    /// The plane of what `change` gives for each pixel.
    #[must_use]
    pub fn map<U: Copy>(self, mut change: impl FnMut(T) -> U) -> Plane<U> {
        let mut values = Vec::with_capacity(self.width * self.height);
        for row in self.rows() {
            values.extend(row.iter().map(|value| change(*value)));
        }
        Plane {
            width: self.width,
            height: self.height,
            values,
        }
    }
}

impl<'a, T: Copy> From<&'a Plane<T>> for PlaneView<'a, T> {
    fn from(plane: &'a Plane<T>) -> Self {
        plane.view()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_that_do_not_fill_the_plane_are_an_error() {
        assert!(Plane::from_values(2, 2, vec![1u8; 5]).is_err());
        assert!(Plane::from_values(usize::MAX, 2, vec![1u8; 5]).is_err());
        assert_eq!(
            Plane::from_values(2, 1, vec![1u8; 2]),
            Ok(Plane::filled(2, 1, 1))
        );
    }

    #[test]
    fn transposing_exchanges_rows_and_columns() {
        let plane = Plane::from_fn(37, 18, |column, row| (100 * row + column) as u16);
        let transposed = plane.transposed();
        for row in 0..18 {
            for column in 0..37 {
                assert_eq!(transposed.get(row, column), plane.get(column, row));
            }
        }
        assert_eq!(transposed.transposed(), plane);
    }
}
