//! Pixels whose matching cost has no minimum.
//!
//! Where a view repeats itself along the row, candidates beside each other cost the same, whatever
//! the other view shows: in areas of one level, as those that are saturated, masked or drawn, and
//! along edges that run along the row. Smooth paths carry a disparity there from what surrounds
//! them, and their sums tell nothing of how well it fits.

use std::sync::atomic::{AtomicUsize, Ordering};

use ga_runtime::batch::{Batch, Work};

use super::cost::difference;
use super::features::{Features, is_same_census};
use super::refine::over_rows;
use super::view::View;

/// Sets the confidence to 0 of pixels that would match the next two pixels of their own row, to one
/// side, at no cost. Returns how many others there are.
pub(super) fn doubt(view: &View, confidence: &mut [u8]) -> usize {
    let batch = Batch::new();
    let textured = AtomicUsize::new(0);
    over_rows(confidence, view.width(), |first, rows| {
        let mut count = 0;
        batch.run(Doubt {
            view,
            first,
            rows,
            textured: &mut count,
        });
        textured.fetch_add(count, Ordering::Relaxed);
    });
    textured.into_inner()
}

struct Doubt<'a> {
    view: &'a View,
    first: usize,
    rows: &'a mut [u8],
    textured: &'a mut usize,
}

impl Work for Doubt<'_> {
    const WIDE: bool = true;

    #[inline(always)]
    fn run(self) {
        let width = self.view.width();
        let mut features = Features::new(width, 0);
        let [mut next, mut second] = [(); 2].map(|()| vec![false; width]);
        for (index, confidence) in self.rows.chunks_exact_mut(width).enumerate() {
            let row = self.first + index;
            features.compute_slopes(self.view, row.cast_signed());
            let matches = |column: usize, gap: usize| {
                column + gap < width
                    && has_no_cost(self.view, &features, row, [column, column + gap])
            };
            for (column, is_alike) in next.iter_mut().enumerate() {
                *is_alike = matches(column, 1);
            }
            for (column, is_alike) in second.iter_mut().enumerate() {
                let is_used = next[column] || next.get(column + 1) == Some(&true);
                *is_alike = is_used && matches(column, 2);
            }
            for column in 0..width {
                let after = next[column] && second[column];
                let before = column >= 2 && next[column - 1] && second[column - 2];
                if before || after {
                    confidence[column] = 0;
                } else {
                    *self.textured += 1;
                }
            }
        }
    }
}

/// Whether two pixels of a row would match at no cost. Most do not even in their slopes.
#[inline(always)]
fn has_no_cost(view: &View, features: &Features, row: usize, columns: [usize; 2]) -> bool {
    let [a, b] = columns;
    features.slopes[a] == features.slopes[b]
        && difference(features.levels[a], features.levels[b]) < 4
        && is_same_census(view, row, columns)
}

#[cfg(test)]
mod tests {
    use ga_image::plane::Plane;

    use super::*;

    /// The census reaches four columns and three rows: farther from the texture, a grey square says
    /// nothing, and neither do stripes along the rows. Stripes across them do, and so does texture.
    #[test]
    fn areas_without_texture_along_the_row_are_doubted() {
        let level = |column: usize, row: usize| match (column, row) {
            (20..50, 10..40) => 140,
            (70..100, 10..40) => [20, 90, 200][row % 3],
            (120..150, 10..40) => [20, 90, 200, 240, 60][column % 5],
            _ => {
                let mixed = (column as u32 + 1).wrapping_mul(2_654_435_761) ^ (row as u32 * 977);
                (mixed.wrapping_mul(2_246_822_519) >> 24) as u8
            }
        };
        let plane = Plane::from_fn(170, 50, level);
        let mut view = View::new(170, 50, false);
        view.fill(plane.view(), |level| level, 0);
        let mut confidence = vec![9; 170 * 50];
        let textured = doubt(&view, &mut confidence);
        let doubted = |left: usize| {
            move |place: &usize| {
                let (column, row) = (place % 170, place / 170);
                (left + 4..left + 26).contains(&column) && (13..37).contains(&row)
            }
        };
        let inside = |left| (0..170 * 50).filter(doubted(left)).collect::<Vec<_>>();
        for left in [20, 70] {
            assert!(inside(left).iter().all(|place| confidence[*place] == 0));
        }
        assert!(inside(120).iter().all(|place| confidence[*place] == 9));
        for (place, level) in confidence.iter().enumerate() {
            let (column, row) = (place % 170, place / 170);
            let is_outside = !(10..40).contains(&row) || !(20..100).contains(&column);
            assert!(*level == 9 || !is_outside, "{column}, {row}");
        }
        let doubted = confidence.iter().filter(|level| **level == 0).count();
        assert_eq!(textured, 170 * 50 - doubted);
    }
}
