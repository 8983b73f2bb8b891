//! Borrowed planes, and rectangles of them, without copying.

use super::PlaneError;

/// The pixels of a plane, or of a rectangle in a plane, borrowed.
///
/// Rows are contiguous; the first pixel of each row lies [`stride`](Self::stride) pixels after that
/// of the row above.
///
/// ```
/// use ga_image::plane::Plane;
///
/// let plane = Plane::from_fn(4, 3, |column, row| (10 * row + column) as u8);
/// let middle = plane.view().part(1, 1, 2, 2).unwrap();
/// assert_eq!(middle.row(0), [11, 12]);
/// assert_eq!(middle.row(1), [21, 22]);
/// assert_eq!(middle.stride(), 4);
/// assert!(plane.view().part(3, 0, 2, 1).is_none());
/// ```
#[derive(Clone, Copy, Debug)]
pub struct PlaneView<'a, T = f32> {
    pub(super) values: &'a [T],
    pub(super) width: usize,
    pub(super) height: usize,
    pub(super) stride: usize,
}

impl<'a, T: Copy> PlaneView<'a, T> {
    /// A view of numbers that lie row by row, `stride` from one row to the next.
    ///
    /// # Errors
    ///
    /// [`PlaneError`] when the rows overlap (the stride is less than the width) or `values` ends
    /// before the last row does.
    pub fn new(
        values: &'a [T],
        width: usize,
        height: usize,
        stride: usize,
    ) -> Result<Self, PlaneError> {
        check(values.len(), width, height, stride)?;
        Ok(Self {
            values,
            width,
            height,
            stride,
        })
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

    /// The number of pixels from the first of a row to the first of the next row.
    #[must_use]
    pub fn stride(&self) -> usize {
        self.stride
    }

    /// Whether there are no pixels.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.width == 0 || self.height == 0
    }

    /// The pixel at a place, or `None` outside the view.
    #[must_use]
    pub fn get(&self, column: usize, row: usize) -> Option<T> {
        (column < self.width && row < self.height).then(|| self.values[row * self.stride + column])
    }

    /// One row.
    ///
    /// # Panics
    ///
    /// When `row` is not less than the height.
    #[must_use]
    pub fn row(&self, row: usize) -> &'a [T] {
        assert!(row < self.height, "row {row} of {}", self.height);
        if self.width == 0 {
            return &[];
        }
        &self.values[row * self.stride..][..self.width]
    }

    /// All rows, from the top.
    pub fn rows(self) -> impl DoubleEndedIterator<Item = &'a [T]> + ExactSizeIterator {
        (0..self.height).map(move |row| self.row(row))
    }

    /// A rectangle, given by the place of its first pixel and its size; `None` where it does not
    /// lie within the view.
    #[must_use]
    pub fn part(&self, left: usize, top: usize, width: usize, height: usize) -> Option<Self> {
        let start = part_start(
            self.width,
            self.height,
            self.stride,
            [left, top, width, height],
        )?;
        Some(Self {
            values: self.values.get(start..).unwrap_or_default(),
            width,
            height,
            stride: self.stride,
        })
    }
}

impl<T> Default for PlaneView<'_, T> {
    /// A view without pixels.
    fn default() -> Self {
        Self {
            values: &[],
            width: 0,
            height: 0,
            stride: 0,
        }
    }
}

impl<T: Copy + PartialEq> PartialEq for PlaneView<'_, T> {
    /// Whether the sizes and all pixels are equal; strides may differ.
    fn eq(&self, other: &Self) -> bool {
        (self.width, self.height) == (other.width, other.height) && self.rows().eq(other.rows())
    }
}

/// The pixels of a plane, or of a rectangle in a plane, borrowed to be changed.
///
/// ```
/// use ga_image::plane::Plane;
///
/// let mut plane = Plane::filled(4, 3, 0u8);
/// plane.view_mut().part(1, 1, 2, 1).unwrap().fill(9);
/// assert_eq!(plane.row(1), [0, 9, 9, 0]);
/// ```
#[derive(Debug)]
pub struct PlaneViewMut<'a, T = f32> {
    pub(super) values: &'a mut [T],
    pub(super) width: usize,
    pub(super) height: usize,
    pub(super) stride: usize,
}

impl<'a, T: Copy> PlaneViewMut<'a, T> {
    /// A view of numbers that lie row by row, `stride` from one row to the next.
    ///
    /// # Errors
    ///
    /// As [`PlaneView::new`].
    pub fn new(
        values: &'a mut [T],
        width: usize,
        height: usize,
        stride: usize,
    ) -> Result<Self, PlaneError> {
        check(values.len(), width, height, stride)?;
        Ok(Self {
            values,
            width,
            height,
            stride,
        })
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

    /// The same pixels, to be read.
    #[must_use]
    pub fn view(&self) -> PlaneView<'_, T> {
        PlaneView {
            values: self.values,
            width: self.width,
            height: self.height,
            stride: self.stride,
        }
    }

    /// One row.
    ///
    /// # Panics
    ///
    /// When `row` is not less than the height.
    #[must_use]
    pub fn row_mut(&mut self, row: usize) -> &mut [T] {
        assert!(row < self.height, "row {row} of {}", self.height);
        if self.width == 0 {
            return &mut [];
        }
        &mut self.values[row * self.stride..][..self.width]
    }

    /// All rows, from the top. A view without columns has none.
    pub fn rows_mut(&mut self) -> impl DoubleEndedIterator<Item = &mut [T]> + ExactSizeIterator {
        let (width, height) = (self.width, self.height);
        self.values
            .chunks_mut(self.stride.max(1))
            .take(height)
            .map(move |row| &mut row[..width])
    }

    /// A rectangle, given by the place of its first pixel and its size; `None` where it does not
    /// lie within the view.
    #[must_use]
    pub fn part(self, left: usize, top: usize, width: usize, height: usize) -> Option<Self> {
        let start = part_start(
            self.width,
            self.height,
            self.stride,
            [left, top, width, height],
        )?;
        Some(Self {
            values: self.values.get_mut(start..).unwrap_or_default(),
            width,
            height,
            stride: self.stride,
        })
    }

    /// Gives all pixels the same value.
    pub fn fill(&mut self, value: T) {
        for row in self.rows_mut() {
            row.fill(value);
        }
    }

    /// Copies the pixels of another view of the same size.
    ///
    /// # Errors
    ///
    /// [`PlaneError::Differs`] when the sizes differ; nothing is changed then.
    pub fn copy_from<'b>(&mut self, source: impl Into<PlaneView<'b, T>>) -> Result<(), PlaneError>
    where
        T: 'b,
    {
        let source = source.into();
        same_size(self.view(), source)?;
        for (to, from) in self.rows_mut().zip(source.rows()) {
            to.copy_from_slice(from);
        }
        Ok(())
    }

    /// Copies the pixels of another view with the upper left corner at a pixel. What reaches
    /// beyond the edges is left out.
    ///
    /// ```
    /// use ga_image::plane::Plane;
    ///
    /// let mut sheet = Plane::filled(4, 3, 0u8);
    /// sheet.view_mut().put(&Plane::filled(2, 2, 7), [3, 1]);
    /// assert_eq!(sheet.values(), [0, 0, 0, 0, 0, 0, 0, 7, 0, 0, 0, 7]);
    /// ```
    pub fn put<'b>(&mut self, source: impl Into<PlaneView<'b, T>>, [left, top]: [usize; 2])
    where
        T: 'b,
    {
        let source = source.into();
        for (to, from) in self.rows_mut().skip(top).zip(source.rows()) {
            for (to, from) in to.iter_mut().skip(left).zip(from) {
                *to = *from;
            }
        }
    }
}

/// That two views have the same size.
///
/// # Errors
///
/// [`PlaneError::Differs`].
pub fn same_size<T: Copy, U: Copy>(
    a: PlaneView<'_, T>,
    b: PlaneView<'_, U>,
) -> Result<(), PlaneError> {
    let (first, second) = ([a.width, a.height], [b.width, b.height]);
    if first == second {
        Ok(())
    } else {
        Err(PlaneError::Differs { first, second })
    }
}

fn check(length: usize, width: usize, height: usize, stride: usize) -> Result<(), PlaneError> {
    if stride < width {
        return Err(PlaneError::Stride { stride, width });
    }
    let needed = match height {
        0 => Some(0),
        _ if width == 0 => Some(0),
        _ => (height - 1)
            .checked_mul(stride)
            .and_then(|n| n.checked_add(width)),
    };
    match needed {
        Some(needed) if needed <= length => Ok(()),
        _ => Err(PlaneError::Length {
            width,
            height,
            length,
        }),
    }
}

/// The index of the first pixel of a rectangle (left, top, width, height), or `None` where it does
/// not lie within a view of this size.
fn part_start(width: usize, height: usize, stride: usize, part: [usize; 4]) -> Option<usize> {
    let [left, top, part_width, part_height] = part;
    let within = left.checked_add(part_width)? <= width && top.checked_add(part_height)? <= height;
    // A rectangle without pixels may begin behind the last pixel.
    within.then(|| top.saturating_mul(stride).saturating_add(left))
}

#[cfg(test)]
mod tests {
    use super::super::Plane;
    use super::*;

    #[test]
    fn sizes_that_do_not_fit_the_numbers_are_errors() {
        let values = [0u8; 10];
        assert!(PlaneView::new(&values, 4, 2, 6).is_ok());
        assert_eq!(
            PlaneView::new(&values, 4, 3, 4),
            Err(PlaneError::Length {
                width: 4,
                height: 3,
                length: 10
            })
        );
        assert_eq!(
            PlaneView::new(&values, 4, 2, 3),
            Err(PlaneError::Stride {
                stride: 3,
                width: 4
            })
        );
        assert!(PlaneView::new(&values, usize::MAX, usize::MAX, usize::MAX).is_err());
        assert!(PlaneView::<u8>::new(&[], 0, usize::MAX, 0).is_ok());
    }

    #[test]
    fn parts_of_no_size_and_at_the_end_are_parts() {
        let plane = Plane::filled(3, 2, 1u16);
        assert!(plane.view().part(3, 2, 0, 0).unwrap().is_empty());
        assert_eq!(plane.view().part(2, 1, 1, 1).unwrap().row(0), [1]);
        assert!(plane.view().part(usize::MAX, 0, 2, 1).is_none());
    }

    #[test]
    fn copying_into_a_part_changes_that_part() {
        let mut plane = Plane::filled(3, 3, 0u8);
        let source = Plane::from_fn(2, 2, |column, row| (1 + column + 2 * row) as u8);
        let mut part = plane.view_mut().part(1, 1, 2, 2).unwrap();
        part.copy_from(&source).unwrap();
        assert!(part.copy_from(&Plane::filled(2, 3, 7u8)).is_err());
        assert_eq!(plane.values(), [0, 0, 0, 0, 1, 2, 0, 3, 4]);
    }
}
