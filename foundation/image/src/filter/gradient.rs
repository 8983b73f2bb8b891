//! Gradients: the slopes of a picture along its columns and rows.

use ga_runtime::batch::{Batch, Work};

use super::Border;
use crate::plane::{Plane, PlaneError, PlaneView, same_size};

/// Weights of 3 × 3 pixels whose sum is a multiple of the slope. Along the direction of the slope
/// they are −1, 0, 1; across it the slopes of three rows or columns are added with weights w:
///
/// ```text
/// dx(c, r) = Σₖ wₖ (I(c + 1, r + k) − I(c − 1, r + k)),  k = −1, 0, 1
/// dy(c, r) = Σₖ wₖ (I(c + k, r + 1) − I(c + k, r − 1))
/// ```
///
/// for the level I of the pixel in column c and row r. Beyond its border the picture is continued
/// by a [`Border`].
///
/// Slopes are positive where the picture becomes brighter to the right (dx) or downwards (dy), and
/// are not divided by the sum of the weights: a ramp that rises by 1 in each pixel has the slope
/// 8 by Sobel and 32 by Scharr. They are those of OpenCV's `Sobel` and `Scharr`.
///
/// ```
/// use ga_image::filter::{Border, Gradient};
/// use ga_image::plane::Plane;
///
/// let ramp = Plane::from_fn(9, 5, |column, row| (3 * column + 2 * row) as u8);
/// let [dx, dy] = Gradient::Sobel.of(&ramp, Border::Mirror);
/// assert_eq!([dx.get(4, 2), dy.get(4, 2)], [Some(3 * 8), Some(2 * 8)]);
/// // A picture that is mirrored at its border is level there.
/// assert_eq!([dx.get(0, 2), dy.get(4, 0)], [Some(0), Some(0)]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gradient {
    /// Across the slope 1, 2, 1 (I. Sobel and G. Feldman, 1968).
    Sobel,
    /// Across the slope 3, 10, 3: the direction depends less on the grid (H. Scharr, "Optimale
    /// Operatoren in der Digitalen Bildverarbeitung", 2000).
    Scharr,
}

impl Gradient {
    /// The slopes along columns and rows, `[dx, dy]`.
    #[must_use]
    pub fn of<'a>(self, picture: impl Into<PlaneView<'a, u8>>, border: Border) -> [Plane<i16>; 2] {
        let picture = picture.into();
        let mut slopes = [(); 2].map(|()| Plane::filled(picture.width(), picture.height(), 0));
        let [dx, dy] = &mut slopes;
        self.run(picture, border, Some(dx), Some(dy));
        slopes
    }

    /// Writes the slopes along columns and rows to planes of the picture's size.
    ///
    /// # Errors
    ///
    /// [`PlaneError::Differs`] when a plane has another size.
    pub fn of_into<'a>(
        self,
        picture: impl Into<PlaneView<'a, u8>>,
        border: Border,
        dx: &mut Plane<i16>,
        dy: &mut Plane<i16>,
    ) -> Result<(), PlaneError> {
        let picture = picture.into();
        same_size(picture, dx.view())?;
        same_size(picture, dy.view())?;
        self.run(picture, border, Some(dx), Some(dy));
        Ok(())
    }

    /// Writes the slope along columns only.
    ///
    /// # Errors
    ///
    /// [`PlaneError::Differs`] when the plane has another size.
    pub fn horizontal_into<'a>(
        self,
        picture: impl Into<PlaneView<'a, u8>>,
        border: Border,
        dx: &mut Plane<i16>,
    ) -> Result<(), PlaneError> {
        let picture = picture.into();
        same_size(picture, dx.view())?;
        self.run(picture, border, Some(dx), None);
        Ok(())
    }

    /// Writes the slope along rows only.
    ///
    /// # Errors
    ///
    /// [`PlaneError::Differs`] when the plane has another size.
    pub fn vertical_into<'a>(
        self,
        picture: impl Into<PlaneView<'a, u8>>,
        border: Border,
        dy: &mut Plane<i16>,
    ) -> Result<(), PlaneError> {
        let picture = picture.into();
        same_size(picture, dy.view())?;
        self.run(picture, border, None, Some(dy));
        Ok(())
    }

    /// The weights across the slope: of the two sides and of the middle.
    pub(crate) const fn weights(self) -> [i16; 2] {
        match self {
            Self::Sobel => [1, 2],
            Self::Scharr => [3, 10],
        }
    }

    fn run(
        self,
        picture: PlaneView<'_, u8>,
        border: Border,
        dx: Option<&mut Plane<i16>>,
        dy: Option<&mut Plane<i16>>,
    ) {
        if picture.is_empty() {
            return;
        }
        Batch::new().run(Slopes {
            rows: SlopeRows::new(picture, self, border),
            dx,
            dy,
        });
    }
}

struct Slopes<'a, 'b> {
    rows: SlopeRows<'a>,
    dx: Option<&'b mut Plane<i16>>,
    dy: Option<&'b mut Plane<i16>>,
}

impl Work for Slopes<'_, '_> {
    #[inline(always)]
    fn run(mut self) {
        for row in 0..self.rows.picture.height() {
            if let Some(dx) = &mut self.dx {
                self.rows.horizontal(row, dx.row_mut(row));
            }
            if let Some(dy) = &mut self.dy {
                self.rows.vertical(row, dy.row_mut(row));
            }
        }
    }
}

/// The slopes of a picture, row by row.
pub(crate) struct SlopeRows<'a> {
    picture: PlaneView<'a, u8>,
    weights: [i16; 2],
    border: Border,
    /// The columns that continue a row on the left and on the right.
    outside: [usize; 2],
    /// A combination of three rows, continued by one column on both sides.
    combined: Vec<i16>,
}

impl<'a> SlopeRows<'a> {
    /// For a picture that is not empty.
    pub(crate) fn new(picture: PlaneView<'a, u8>, gradient: Gradient, border: Border) -> Self {
        let width = picture.width();
        Self {
            picture,
            weights: gradient.weights(),
            border,
            outside: [
                border.index(-1, width),
                border.index(width.cast_signed(), width),
            ],
            combined: vec![0; width + 2],
        }
    }

    /// The rows above, at and below a row.
    #[inline(always)]
    fn around(&self, row: usize) -> [&'a [u8]; 3] {
        let row = row.cast_signed();
        [row - 1, row, row + 1].map(|row| {
            let inside = self.border.index(row, self.picture.height());
            self.picture.row(inside)
        })
    }

    /// Continues the combined row on both sides.
    #[inline(always)]
    fn close(&mut self) {
        let [left, right] = self.outside.map(|column| self.combined[column + 1]);
        let last = self.combined.len() - 1;
        self.combined[0] = left;
        self.combined[last] = right;
    }

    #[inline(always)]
    pub(crate) fn horizontal(&mut self, row: usize, dx: &mut [i16]) {
        let [above, here, below] = self.around(row);
        let [side, middle] = self.weights;
        let sums = &mut self.combined[1..][..here.len()];
        for (((sum, a), h), b) in sums.iter_mut().zip(above).zip(here).zip(below) {
            *sum = side * (i16::from(*a) + i16::from(*b)) + middle * i16::from(*h);
        }
        self.close();
        let sums = &self.combined;
        for ((slope, left), right) in dx.iter_mut().zip(sums).zip(&sums[2..]) {
            *slope = right - left;
        }
    }

    #[inline(always)]
    pub(crate) fn vertical(&mut self, row: usize, dy: &mut [i16]) {
        let [above, _, below] = self.around(row);
        let [side, middle] = self.weights;
        let differences = &mut self.combined[1..][..above.len()];
        for ((difference, a), b) in differences.iter_mut().zip(above).zip(below) {
            *difference = i16::from(*b) - i16::from(*a);
        }
        self.close();
        let d = &self.combined;
        for (((slope, left), at), right) in dy.iter_mut().zip(d).zip(&d[1..]).zip(&d[2..]) {
            *slope = side * (left + right) + middle * at;
        }
    }
}
