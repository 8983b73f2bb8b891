//! Blurring of fields of numbers on a grid of pixels.

/// A grid of numbers, row by row.
pub(super) struct Field {
    width: usize,
    values: Vec<f32>,
}

impl Field {
    pub(super) fn new(width: usize, values: Vec<f32>) -> Self {
        Self { width, values }
    }

    pub(super) fn values(&self) -> &[f32] {
        &self.values
    }

    /// Averages over a square neighbourhood of about `radius`, weighted like a tent along each axis
    /// (two box filters). Beyond its border the field is zero.
    pub(super) fn blurred(self, radius: usize) -> Self {
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
        let mut values = vec![0.0; width * height];
        values[8 * width + 10] = 1.0;
        let blurred = Field::new(width, values).blurred(4);
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
    fn a_neighbourhood_wider_than_the_field_is_no_trouble() {
        let blurred = Field::new(2, vec![1.0; 6]).blurred(20);
        assert!(blurred.values().iter().all(|v| v.is_finite()));
    }
}
