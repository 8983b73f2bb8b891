//! The mean of costs over the region that the arms of a pixel span: all pixels on the horizontal
//! arms of those on its vertical arms.

use super::arms::{Arms, LONGEST};
use super::cost::{HIGHEST, NEVER};
use super::lanes::LANES;
use super::view::View;

/// Rows in memory: a vertical arm with its centre, and the row before it.
const ROWS: usize = 2 * LONGEST + 2;
/// The weight of a row of a region is the number of its pixels, up to this. Then sums over a region
/// fit in 16 bits, and are exact for regions that are narrow.
const HEAVIEST: usize = 15;
const _: () = assert!(
    (2 * LONGEST + 1) * (HEAVIEST * HIGHEST as usize + HEAVIEST / 2 + 1) <= u16::MAX as usize
);

/// The sums over horizontal arms, added up along columns, of the last rows.
#[derive(Clone, Debug)]
pub(super) struct Support {
    arms: Arms,
    /// Sums of the costs of one row from its left end, before each pixel and behind the last.
    running: Vec<u16>,
    /// Sums of rows from the first to each one, in the place of its number modulo [`ROWS`]. They
    /// are right up to multiples of 2¹⁶, and so are their differences, which are smaller.
    sums: Vec<Vec<u16>>,
    weights: Vec<Vec<u16>>,
    /// The rows that have been added.
    next: usize,
}

impl Support {
    /// For rows of `width` pixels with `range` costs each, a whole number of blocks.
    pub(super) fn new(width: usize, range: usize) -> Self {
        Self {
            arms: Arms::new(width),
            running: vec![0; (width + 1) * range],
            sums: vec![vec![0; width * range]; ROWS],
            weights: vec![vec![0; width]; ROWS],
            next: 0,
        }
    }

    /// The bytes of the sums.
    pub(super) fn bytes(width: usize, range: usize) -> usize {
        (ROWS + 1) * width * range * size_of::<u16>()
    }

    /// The first row that is needed for the region of a pixel of `row`, and before which all is
    /// forgotten.
    pub(super) fn begin(&mut self, row: usize) -> usize {
        let first = row.saturating_sub(LONGEST);
        let before = (first + ROWS - 1) % ROWS;
        self.sums[before].fill(0);
        self.weights[before].fill(0);
        self.next = first;
        first
    }

    /// The number of the row to be added next, if the region of a pixel of `row` may need it.
    #[inline(always)]
    pub(super) fn wanted(&self, row: usize, height: usize) -> Option<usize> {
        (self.next < height && self.next <= row + LONGEST).then_some(self.next)
    }

    /// Adds the costs of the wanted row.
    #[inline(always)]
    pub(super) fn add(&mut self, view: &View, costs: &[u8], threshold: u8) {
        let row = self.next;
        self.next += 1;
        let width = view.width();
        let range = costs.len() / width;
        self.run(costs, range);
        self.arms.across(view, row, threshold);
        let [before, here] = [row + ROWS - 1, row].map(|row| row % ROWS);
        let Ok([before, here]) = self.weights.get_disjoint_mut([before, here]) else {
            return;
        };
        let mut ratios = [0u16; 2 * LONGEST + 2];
        for (count, ratio) in ratios.iter_mut().enumerate().skip(HEAVIEST + 1) {
            *ratio = ((HEAVIEST << 16) / count) as u16;
        }
        let [before_sums, here_sums] = [row + ROWS - 1, row].map(|row| row % ROWS);
        let Ok([above, sums]) = self.sums.get_disjoint_mut([before_sums, here_sums]) else {
            return;
        };
        let pixels = sums.chunks_exact_mut(range).zip(above.chunks_exact(range));
        for (column, (sums, above)) in pixels.enumerate() {
            let left = column - usize::from(self.arms.left[column]);
            let right = column + 1 + usize::from(self.arms.right[column]);
            let low = &self.running[left * range..][..range];
            let high = &self.running[right * range..][..range];
            let count = right - left;
            here[column] = before[column].wrapping_add(count.min(HEAVIEST) as u16);
            add_scaled(sums, above, [low, high], ratios[count]);
        }
    }

    /// Sums of a row of costs from its left end.
    #[inline(always)]
    fn run(&mut self, costs: &[u8], range: usize) {
        for (column, costs) in costs.chunks_exact(range).enumerate() {
            let (before, after) = self.running.split_at_mut((column + 1) * range);
            let before = before[column * range..].as_chunks::<LANES>().0;
            let after = after[..range].as_chunks_mut::<LANES>().0;
            let costs = costs.as_chunks::<LANES>().0;
            for ((after, before), cost) in after.iter_mut().zip(before).zip(costs) {
                let mut sums = [0u16; LANES];
                for lane in 0..LANES {
                    sums[lane] = before[lane].wrapping_add(u16::from(cost[lane]));
                }
                *after = sums;
            }
        }
    }

    /// The mean costs of a row whose regions have been added. Costs from `disparities` on are those
    /// of no candidate.
    #[inline(always)]
    pub(super) fn means(
        &mut self,
        view: &View,
        row: usize,
        threshold: u8,
        disparities: usize,
        means: &mut [u8],
    ) {
        let range = means.len() / view.width();
        self.arms.along(view, row, threshold);
        for (column, means) in means.chunks_exact_mut(range).enumerate() {
            let first = (row + ROWS - 1 - usize::from(self.arms.up[column])) % ROWS;
            let last = (row + usize::from(self.arms.down[column])) % ROWS;
            let weight = self.weights[last][column].wrapping_sub(self.weights[first][column]);
            let low = &self.sums[first][column * range..][..range];
            let high = &self.sums[last][column * range..][..range];
            divide(means, [low, high], weight);
            means[disparities..].fill(NEVER);
        }
    }
}

/// `above` plus the difference of two sums, times `ratio` / 2¹⁶ unless that is 0.
#[inline(always)]
fn add_scaled(sums: &mut [u16], above: &[u16], ends: [&[u16]; 2], ratio: u16) {
    let [low, high] = ends.map(|end| end.as_chunks::<LANES>().0);
    let sums = sums.as_chunks_mut::<LANES>().0.iter_mut();
    let blocks = sums
        .zip(above.as_chunks::<LANES>().0)
        .zip(low.iter().zip(high));
    if ratio == 0 {
        for ((sums, above), (low, high)) in blocks {
            let mut total = [0u16; LANES];
            for lane in 0..LANES {
                total[lane] = above[lane].wrapping_add(high[lane].wrapping_sub(low[lane]));
            }
            *sums = total;
        }
    } else {
        for ((sums, above), (low, high)) in blocks {
            let mut total = [0u16; LANES];
            for lane in 0..LANES {
                let sum = high[lane].wrapping_sub(low[lane]);
                total[lane] = above[lane].wrapping_add(high_half(sum, ratio));
            }
            *sums = total;
        }
    }
}

/// The difference of two sums divided by a weight, rounded.
#[inline(always)]
fn divide(means: &mut [u8], ends: [&[u16]; 2], weight: u16) {
    let [low, high] = ends.map(|end| end.as_chunks::<LANES>().0);
    let blocks = means.as_chunks_mut::<LANES>().0.iter_mut();
    // For a weight of 1 the inverse is 2¹⁶ − 1, and 1 is added instead of ½.
    let inverse = ((1u32 << 16) / u32::from(weight.max(1))).min(0xFFFF) as u16;
    let half = (weight / 2).max(1);
    for (block, (low, high)) in blocks.zip(low.iter().zip(high)) {
        let mut quotients = [0u16; LANES];
        for lane in 0..LANES {
            let sum = high[lane].wrapping_sub(low[lane]).wrapping_add(half);
            quotients[lane] = high_half(sum, inverse);
        }
        for lane in 0..LANES {
            block[lane] = quotients[lane] as u8;
        }
    }
}

/// The upper 16 bits of a product.
#[inline(always)]
fn high_half(a: u16, b: u16) -> u16 {
    ((u32::from(a) * u32::from(b)) >> 16) as u16
}

#[cfg(test)]
mod tests {
    use ga_image::plane::Plane;

    use super::*;

    /// A picture of few levels, so that arms have all lengths.
    fn view(width: usize, height: usize) -> View {
        let plane = Plane::from_fn(width, height, |column, row| {
            let hash = (column * 7919 + row * 104_729 + column * row * 31) % 97;
            (40 * (column / 30 + row / 11) + hash / 24) as u8
        });
        let mut view = View::new(width, height, false);
        view.fill(plane.view(), |level| level, 0);
        view
    }

    /// How far an arm reaches, pixel by pixel.
    fn reach(view: &View, [column, row]: [usize; 2], [dx, dy]: [isize; 2], threshold: u8) -> usize {
        let level = |step: usize| {
            let x = column.checked_add_signed(dx * step.cast_signed())?;
            let y = row.checked_add_signed(dy * step.cast_signed())?;
            (y < view.height()).then(|| view.row(y).get(x).copied())?
        };
        let near = |step: &usize| {
            let (Some(end), Some(before), Some(centre)) = (level(*step), level(step - 1), level(0))
            else {
                return false;
            };
            end.abs_diff(before) <= threshold && end.abs_diff(centre) <= threshold
        };
        (1..=LONGEST).take_while(near).count()
    }

    #[test]
    fn means_are_those_of_all_pixels_on_the_arms_of_the_arms() {
        let (width, height, range, disparities) = (75, 70, 32, 20);
        let view = view(width, height);
        let costs: Vec<Vec<u8>> = (0..height)
            .map(|row| {
                let cost = |place: usize| ((place * 37 + row * 101) % usize::from(HIGHEST)) as u8;
                (0..width * range).map(cost).collect()
            })
            .collect();
        let mut support = Support::new(width, range);
        let mut means = vec![0; width * range];
        let threshold = 3;
        let mut longest = 0;
        // A strip that begins below the top.
        support.begin(33);
        for row in 33..height {
            while let Some(row) = support.wanted(row, height) {
                support.add(&view, &costs[row], threshold);
            }
            support.means(&view, row, threshold, disparities, &mut means);
            for column in 0..width {
                let up = reach(&view, [column, row], [0, -1], threshold);
                let down = reach(&view, [column, row], [0, 1], threshold);
                let (mut sum, mut weight) = ([0.0; 20], 0.0);
                for y in row - up..=row + down {
                    let left = reach(&view, [column, y], [-1, 0], threshold);
                    let right = reach(&view, [column, y], [1, 0], threshold);
                    let count = left + right + 1;
                    longest = longest.max(count);
                    let scale = (HEAVIEST as f64 / count as f64).min(1.0);
                    weight += scale * count as f64;
                    for x in column - left..=column + right {
                        for (d, sum) in sum.iter_mut().enumerate() {
                            *sum += scale * f64::from(costs[y][x * range + d]);
                        }
                    }
                }
                let found = &means[column * range..][..range];
                for (d, sum) in sum.iter().enumerate() {
                    let error = f64::from(found[d]) - sum / weight;
                    assert!(error.abs() <= 0.75, "({column}, {row}), {d}: {error}");
                }
                assert!(found[disparities..].iter().all(|cost| *cost == NEVER));
            }
        }
        assert!(
            longest > HEAVIEST + 1,
            "no row of a region is long: {longest}"
        );
    }
}
