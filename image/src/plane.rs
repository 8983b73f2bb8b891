//! Planes of pixels and their blur.

/// A grid of numbers, one for each pixel, row by row.
#[derive(Clone, Debug, PartialEq)]
pub struct Plane {
    width: usize,
    values: Vec<f32>,
}

impl Plane {
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
    pub fn filled(width: usize, height: usize, value: f32) -> Self {
        Self {
            width,
            values: vec![value; width * height],
        }
    }

    /// The plane of the values `change` gives for those of this one.
    #[must_use]
    pub fn map(&self, change: impl FnMut(f32) -> f32) -> Self {
        Self {
            width: self.width,
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
        self.values.len().checked_div(self.width).unwrap_or(0)
    }

    /// All values, row by row.
    #[must_use]
    pub fn values(&self) -> &[f32] {
        &self.values
    }

    /// All values, to be changed.
    pub fn values_mut(&mut self) -> &mut [f32] {
        &mut self.values
    }

    /// The value of a pixel, or `None` outside the plane.
    #[must_use]
    pub fn get(&self, column: usize, row: usize) -> Option<f32> {
        let index = row.checked_mul(self.width)?.checked_add(column)?;
        (column < self.width)
            .then(|| self.values.get(index).copied())
            .flatten()
    }

    /// Averages over a square neighbourhood of about `radius` pixels, weighted like a tent along
    /// each axis (two box filters). Outside its border the plane counts as zero.
    #[must_use]
    pub fn blurred(self, radius: usize) -> Self {
        if self.values.is_empty() {
            return self;
        }
        let reach = radius.div_ceil(2);
        let down = self.averaged_down(reach).averaged_down(reach);
        let across = down.transposed().averaged_down(reach).averaged_down(reach);
        across.transposed()
    }

    /// The mean of each value and `reach` values on either side in its column. Whole rows are added
    /// at a time, which compilers turn into vector instructions.
    fn averaged_down(&self, reach: usize) -> Self {
        let width = self.width;
        let share = 1.0 / (2 * reach + 1) as f32;
        // Sums of at most a few hundred values near 1: running errors stay far below one shade.
        let mut sums = vec![0.0; width];
        let mut values = Vec::with_capacity(self.values.len());
        let rows: Vec<&[f32]> = self.values.chunks_exact(width).collect();
        for row in rows.iter().take(reach) {
            add_to(&mut sums, row, 1.0);
        }
        for row in 0..rows.len() {
            if let Some(entering) = rows.get(row + reach) {
                add_to(&mut sums, entering, 1.0);
            }
            values.extend(sums.iter().map(|sum| sum * share));
            if let Some(leaving) = row.checked_sub(reach) {
                add_to(&mut sums, rows[leaving], -1.0);
            }
        }
        Self { width, values }
    }

    fn transposed(&self) -> Self {
        /// Squares small enough that their rows and columns stay in the cache.
        const BLOCK: usize = 16;
        let (width, height) = (self.width, self.values.len() / self.width);
        let mut values = vec![0.0; self.values.len()];
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
            values,
        }
    }
}

fn add_to(sums: &mut [f32], row: &[f32], sign: f32) {
    for (sum, value) in sums.iter_mut().zip(row) {
        *sum += sign * value;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_single_value_becomes_a_tent_of_the_same_sum() {
        let (width, height) = (21, 17);
        let mut plane = Plane::filled(width, height, 0.0);
        plane.values_mut()[8 * width + 10] = 1.0;
        let blurred = plane.blurred(4);
        let tent = |d: usize| (5.0 - d as f32).max(0.0) / 25.0;
        for row in 0..height {
            for column in 0..width {
                let expected = tent(row.abs_diff(8)) * tent(column.abs_diff(10));
                let got = blurred.values()[row * width + column];
                assert!(
                    (got - expected).abs() < 1e-6,
                    "({column}, {row}): {got}, not {expected}"
                );
            }
        }
    }

    #[test]
    fn a_neighbourhood_may_be_wider_than_the_plane() {
        let blurred = Plane::filled(2, 3, 1.0).blurred(20);
        assert!(blurred.values().iter().all(|v| v.is_finite()));
        assert_eq!(Plane::filled(0, 5, 1.0).blurred(3).values(), []);
    }
}
