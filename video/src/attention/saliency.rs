//! Maps of cells: their normalisation, and their enlargement to pixels.

use ga_image::plane::Plane;
use ga_runtime::batch::{Batch, Work};

/// Itti's N: the map divided by its greatest number, or by `least` where that is larger, times
/// (M − m)², where M is the greatest number then and m the mean of the local maxima elsewhere: not
/// in the region around the greatest that lies above M / 2. So a long contour, or a large object,
/// does not compete with itself.
pub(super) fn normalised(map: Plane, least: f32) -> Plane {
    let greatest = map.values().iter().copied().fold(0.0, f32::max);
    let unit = greatest.max(least);
    let mut map = map.map(|value| (value / unit).max(0.0));
    let greatest = greatest / unit;
    let region = region_of_greatest(&map, 0.5 * greatest);
    let (mut sum, mut count) = (0.0, 0);
    for row in 0..map.height() {
        for column in 0..map.width() {
            if !region.row(row)[column] && is_local_maximum(&map, column, row) {
                sum += map.row(row)[column];
                count += 1;
            }
        }
    }
    let others = if count == 0 { 0.0 } else { sum / count as f32 };
    let factor = (greatest - others) * (greatest - others);
    for value in map.values_mut() {
        *value *= factor;
    }
    map
}

/// The cells above a level that are connected with the first greatest one, also by corners.
fn region_of_greatest(map: &Plane, level: f32) -> Plane<bool> {
    let [width, height] = [map.width(), map.height()];
    let mut region = Plane::filled(width, height, false);
    let values = map.values();
    let greatest = (0..values.len()).reduce(|a, b| if values[b] > values[a] { b } else { a });
    let mut open: Vec<usize> = greatest.into_iter().collect();
    while let Some(cell) = open.pop() {
        if region.values()[cell] {
            continue;
        }
        region.values_mut()[cell] = true;
        let [column, row] = [cell % width, cell / width];
        for row in row.saturating_sub(1)..(row + 2).min(height) {
            for column in column.saturating_sub(1)..(column + 2).min(width) {
                let cell = row * width + column;
                if values[cell] > level && !region.values()[cell] {
                    open.push(cell);
                }
            }
        }
    }
    region
}

/// Whether no neighbour is greater and one is less.
fn is_local_maximum(map: &Plane, column: usize, row: usize) -> bool {
    let value = map.row(row)[column];
    let mut above_one = false;
    for row in row.saturating_sub(1)..(row + 2).min(map.height()) {
        for column in column.saturating_sub(1)..(column + 2).min(map.width()) {
            let other = map.row(row)[column];
            if other > value {
                return false;
            }
            above_one |= other < value;
        }
    }
    above_one
}

/// Writes the numbers of cells to pixels: linear between the centres of cells, which are `side`
/// pixels wide and high, and constant outside them. `side` is even.
pub(super) fn enlarged(cells: &Plane, side: usize, pixels: &mut Plane) {
    Batch::new().run(Enlargement {
        cells,
        side,
        pixels,
    });
}

struct Enlargement<'a> {
    cells: &'a Plane,
    side: usize,
    pixels: &'a mut Plane,
}

impl Work for Enlargement<'_> {
    #[inline(always)]
    fn run(self) {
        let (side, half) = (self.side, self.side / 2);
        // The share of the second of two cells, from the centre of the first on.
        let shares: Vec<f32> = (0..side)
            .map(|pixel| (pixel as f32 + 0.5) / side as f32)
            .collect();
        let last = self.cells.height() - 1;
        let mut between = vec![0.0f32; self.cells.width()];
        for row in 0..self.pixels.height() {
            let (first, second, share) = match row.checked_sub(half) {
                None => (0, 0, 0.0),
                Some(row) => {
                    let first = (row / side).min(last);
                    (first, (first + 1).min(last), shares[row % side])
                }
            };
            let (first, second) = (self.cells.row(first), self.cells.row(second));
            for (cell, (first, second)) in between.iter_mut().zip(first.iter().zip(second)) {
                *cell = first + share * (second - first);
            }
            let target = self.pixels.row_mut(row);
            let (left, rest) = target.split_at_mut(half.min(target.len()));
            left.fill(between[0]);
            for (index, pixels) in rest.chunks_mut(side).enumerate() {
                let first = between[index.min(between.len() - 1)];
                let step = between[(index + 1).min(between.len() - 1)] - first;
                for (pixel, share) in pixels.iter_mut().zip(&shares) {
                    *pixel = first + share * step;
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Peaks of 1 and ½, and one of ¼ at the border: m = ⅜.
    #[test]
    fn a_map_with_other_peaks_is_lowered() {
        let mut map = Plane::filled(9, 5, 0.0);
        for (column, row, value) in [(1, 1, 4.0), (5, 2, 2.0), (8, 4, 1.0)] {
            map.row_mut(row)[column] = value;
        }
        let got = normalised(map.clone(), 0.0);
        let factor = (1.0f32 - 0.375).powi(2);
        assert_eq!(got.get(1, 1), Some(factor));
        assert_eq!(got.get(5, 2), Some(0.5 * factor));
        assert_eq!(got.get(0, 4), Some(0.0));
        // Below the least unit: 4 / 16 and the others in proportion.
        let weak = normalised(map, 16.0);
        assert_eq!(weak.get(1, 1), Some(0.25f32.powi(2) * factor * 0.25));
    }

    /// A ridge of equal numbers is one peak, and a second one competes with it.
    #[test]
    fn a_long_ridge_does_not_compete_with_itself() {
        let mut map = Plane::filled(9, 6, 0.0);
        for row in 0..6 {
            map.row_mut(row)[2] = 4.0;
        }
        assert_eq!(normalised(map.clone(), 0.0).get(2, 3), Some(1.0));
        for row in 0..6 {
            map.row_mut(row)[6] = 3.0;
        }
        assert_eq!(normalised(map, 0.0).get(2, 3), Some(0.0625));
    }

    #[test]
    fn a_flat_map_has_no_peak_and_stays_finite() {
        let flat = normalised(Plane::filled(3, 3, 5.0), 1.0);
        assert!(flat.values().iter().all(|value| *value == 1.0));
        let zero = normalised(Plane::filled(3, 3, 0.0), 1.0);
        assert!(zero.values().iter().all(|value| *value == 0.0));
    }

    #[test]
    fn pixels_lie_on_the_lines_between_the_centres_of_cells() {
        let cells = Plane::from_values(3, 2, vec![0.0, 8.0, 8.0, 4.0, 4.0, 12.0]).unwrap();
        let mut pixels = Plane::filled(11, 7, -1.0);
        enlarged(&cells, 4, &mut pixels);
        assert_eq!(pixels.row(0)[..2], [0.0, 0.0]);
        assert_eq!(pixels.row(0)[2..6], [1.0, 3.0, 5.0, 7.0]);
        assert_eq!(pixels.row(1)[6..], [8.0; 5]);
        // A quarter of a pixel below the centre of the upper cells, times ½.
        assert_eq!(pixels.row(2)[0], 0.5);
        assert_eq!(pixels.row(6)[10], 12.0);
    }
}
