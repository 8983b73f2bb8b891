//! Blur by two box filters.

use crate::plane::Plane;

impl Plane {
    /// Averages over a square neighbourhood of about `radius` pixels, weighted like a tent along
    /// each axis (two box filters). Outside its border the plane counts as zero.
    #[must_use]
    pub fn blurred(self, radius: usize) -> Self {
        if self.is_empty() {
            return self;
        }
        let reach = radius.div_ceil(2);
        let down = averaged_down(&averaged_down(&self, reach), reach);
        let across = averaged_down(&averaged_down(&down.transposed(), reach), reach);
        across.transposed()
    }
}

/// The mean of each value and `reach` values on either side in its column. Whole rows are added at
/// a time, which compilers turn into vector instructions.
fn averaged_down(plane: &Plane, reach: usize) -> Plane {
    let share = 1.0 / (2 * reach + 1) as f32;
    // Sums of at most a few hundred values near 1: running errors stay far below one shade.
    let mut sums = vec![0.0; plane.width()];
    let mut averaged = plane.clone();
    let rows: Vec<&[f32]> = plane.rows().collect();
    for row in rows.iter().take(reach) {
        add_to(&mut sums, row, 1.0);
    }
    for row in 0..rows.len() {
        if let Some(entering) = rows.get(row + reach) {
            add_to(&mut sums, entering, 1.0);
        }
        for (mean, sum) in averaged.row_mut(row).iter_mut().zip(&sums) {
            *mean = sum * share;
        }
        if let Some(leaving) = row.checked_sub(reach) {
            add_to(&mut sums, rows[leaving], -1.0);
        }
    }
    averaged
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
