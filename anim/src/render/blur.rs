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

    /// Averages over a square neighbourhood of about `radius`, weighted like a tent along each axis (two box filters).
    /// Beyond its border the field is zero.
    pub(super) fn blurred(self, radius: usize) -> Self {
        let reach = radius.div_ceil(2);
        (0..4).fold(self, |field, _| field.averaged_and_transposed(reach))
    }

    /// The mean of each value and `reach` values on either side along its row, written to the transposed place.
    fn averaged_and_transposed(&self, reach: usize) -> Self {
        let (width, height) = (self.width, self.values.len() / self.width);
        let share = 1.0 / (2 * reach + 1) as f32;
        let mut values = vec![0.0; self.values.len()];
        for (row, line) in self.values.chunks_exact(width).enumerate() {
            // Sums of at most a few hundred values near 1: running errors stay far below one shade.
            let mut sum: f32 = line[..reach.min(width)].iter().sum();
            for column in 0..width {
                if column + reach < width {
                    sum += line[column + reach];
                }
                values[column * height + row] = sum * share;
                if column >= reach {
                    sum -= line[column - reach];
                }
            }
        }
        Self {
            width: height,
            values,
        }
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
