//! One pass over a strip of rows, from the top downwards, with one row of costs in memory.

use std::ops::Range;

use ga_runtime::batch::Work;

use super::cost::{Candidates, NEVER, row_costs};
use super::features::Features;
use super::lanes::{LANES, least_of_words};
use super::path::{PathRow, Penalties};
use super::support::Support;
use super::view::View;
use super::winner::{Opposite, WinnerRow, winner};

/// The rows above a strip from which its paths begin.
pub(super) const WARM_UP: usize = 16;
/// Paths that arrive at each pixel: from the left, from the right, and three from above.
const PATHS: usize = 5;

/// What a pass needs in memory.
#[derive(Clone, Debug)]
pub(super) struct Scratch {
    features: [Features; 2],
    /// The costs of one row, and their means over regions.
    costs: Vec<u8>,
    means: Vec<u8>,
    support: Option<Support>,
    /// The paths from the upper left, from above and from the upper right, of the row above and of
    /// this row.
    above: [PathRow; 3],
    here: [PathRow; 3],
    forward: PathRow,
    backward: PathRow,
    sums: Vec<u16>,
    winners: WinnerRow,
    opposite: Opposite,
}

impl Scratch {
    /// For rows of `width` pixels with `range` disparities.
    pub(super) fn new(width: usize, range: usize, has_support: bool) -> Self {
        let padded = range.next_multiple_of(LANES);
        let features = || Features::new(width, padded);
        let path = || PathRow::new(width, padded);
        Self {
            features: [features(), features()],
            costs: vec![0; width * padded],
            means: vec![0; if has_support { width * padded } else { 0 }],
            support: has_support.then(|| Support::new(width, padded)),
            above: [path(), path(), path()],
            here: [path(), path(), path()],
            forward: path(),
            backward: path(),
            sums: vec![0; padded],
            winners: WinnerRow::new(width),
            opposite: Opposite::new(width, padded),
        }
    }

    /// The bytes that it takes, without what does not grow with both `width` and `range`.
    pub(super) fn bytes(width: usize, range: usize, has_support: bool) -> usize {
        let padded = range.next_multiple_of(LANES);
        let support = if has_support {
            width * padded + Support::bytes(width, padded)
        } else {
            0
        };
        // One row of costs, and eight of paths.
        9 * width * padded + support
    }
}

/// What a pass finds in its strip.
#[derive(Debug)]
pub(super) struct Found<'a> {
    /// The disparities of the reference view in 1/32 px.
    pub(super) disparities: &'a mut [u16],
    /// How clear they are, from 0 to 255, where that is wanted.
    pub(super) confidence: Option<&'a mut [u8]>,
    /// The disparities of the other view in whole pixels, where they are wanted; its columns are
    /// mirrored.
    pub(super) opposite: Option<&'a mut [u16]>,
}

impl<'a> Found<'a> {
    /// The first `length` pixels; the others are left.
    pub(super) fn split_off(&mut self, length: usize) -> Self {
        fn first<'a, T>(slice: &mut &'a mut [T], length: usize) -> &'a mut [T] {
            let (first, rest) = std::mem::take(slice).split_at_mut(length);
            *slice = rest;
            first
        }
        Self {
            disparities: first(&mut self.disparities, length),
            confidence: self.confidence.as_mut().map(|all| first(all, length)),
            opposite: self.opposite.as_mut().map(|all| first(all, length)),
        }
    }
}

/// What all strips of a pass have in common.
#[derive(Clone, Copy, Debug)]
pub(super) struct Task<'a> {
    pub(super) reference: &'a View,
    pub(super) other: &'a View,
    pub(super) range: usize,
    pub(super) penalties: &'a Penalties,
    /// The cost of candidates outside the other view.
    pub(super) outside: u8,
    /// How much levels may differ along the arms of a pixel.
    pub(super) threshold: u8,
}

/// The pass over the strip `rows`.
pub(super) struct Sweep<'a> {
    pub(super) task: Task<'a>,
    pub(super) rows: Range<usize>,
    pub(super) scratch: &'a mut Scratch,
    pub(super) found: Found<'a>,
}

impl Work for Sweep<'_> {
    const WIDE: bool = true;

    #[inline(always)]
    fn run(mut self) {
        let width = self.task.reference.width();
        let start = self.rows.start.saturating_sub(WARM_UP);
        for row in start..self.rows.end {
            self.costs(row, row == start);
            self.paths(row, row == start);
            if let Some(index) = row.checked_sub(self.rows.start) {
                self.winners(index * width);
            }
            let scratch = &mut *self.scratch;
            std::mem::swap(&mut scratch.above, &mut scratch.here);
        }
    }
}

impl Sweep<'_> {
    /// The costs of a row, averaged over regions where there is memory for that.
    #[inline(always)]
    fn costs(&mut self, row: usize, is_first: bool) {
        let Task {
            reference,
            other,
            range,
            outside,
            threshold,
            ..
        } = self.task;
        let Scratch {
            features: [left, right],
            costs,
            means,
            support,
            sums,
            ..
        } = &mut *self.scratch;
        let stride = sums.len();
        let candidates = Candidates::new([reference, other], range, outside);
        let Some(support) = support else {
            left.compute(reference, row);
            right.compute(other, row);
            row_costs(left, right, &candidates, NEVER, costs, stride);
            return;
        };
        if is_first {
            support.begin(row);
        }
        while let Some(row) = support.wanted(row, reference.height()) {
            left.compute(reference, row);
            right.compute(other, row);
            row_costs(left, right, &candidates, 0, costs, stride);
            support.add(reference, costs, threshold);
        }
        support.means(reference, row, threshold, range, means);
    }

    /// The paths from above and along the row. Each step along the row waits for the one before it,
    /// so that the two directions are computed side by side.
    #[inline(always)]
    fn paths(&mut self, row: usize, is_first: bool) {
        let view = self.task.reference;
        let penalties = self.task.penalties;
        let width = view.width();
        let scratch = &mut *self.scratch;
        let stride = scratch.sums.len();
        let levels = view.row(row);
        let levels_above = view.row(row.saturating_sub(1));
        let all_costs = if scratch.support.is_some() {
            &scratch.means
        } else {
            &scratch.costs
        };
        for (column, costs) in all_costs.chunks_exact(stride).enumerate() {
            let level = levels[column];
            for path in 0..scratch.above.len() {
                let (here, above) = (&mut scratch.here[path], &scratch.above[path]);
                match (column + path).checked_sub(1) {
                    Some(from) if !is_first && from < width => {
                        let pair = [level, levels_above[from]];
                        here.advance(column, costs, (above, from), penalties, pair);
                    }
                    _ => here.begin(column, costs),
                }
            }
            let forward = &mut scratch.forward;
            match column.checked_sub(1) {
                Some(from) => {
                    let pair = [level, levels[from]];
                    forward.advance_within(column, costs, from, penalties, pair);
                }
                None => forward.begin(column, costs),
            }
            let backward = &mut scratch.backward;
            let (from, column) = (width - column, width - 1 - column);
            let costs = &all_costs[column * stride..][..stride];
            if from < width {
                let pair = [levels[column], levels[from]];
                backward.advance_within(column, costs, from, penalties, pair);
            } else {
                backward.begin(column, costs);
            }
        }
    }

    /// The winners of a row, from the pixel `place` of the strip.
    #[inline(always)]
    fn winners(&mut self, place: usize) {
        let width = self.task.reference.width();
        let scratch = &mut *self.scratch;
        let stride = scratch.sums.len();
        let has_opposite = self.found.opposite.is_some();
        scratch.opposite.clear(PATHS as u16 * u16::from(NEVER));
        let costs = if scratch.support.is_some() {
            &scratch.means
        } else {
            &scratch.costs
        };
        for (column, costs) in costs.chunks_exact(stride).enumerate().rev() {
            let [a, b, c] = &scratch.here;
            let paths = [
                a.pixel(column),
                b.pixel(column),
                c.pixel(column),
                scratch.forward.pixel(column),
                scratch.backward.pixel(column),
            ];
            let least = sum(paths, &mut scratch.sums);
            if has_opposite {
                scratch.opposite.take(column, width, &scratch.sums);
            }
            // Sums favour whole disparities, since a change costs the same penalty on both sides.
            // Costs of single pixels are too noisy to mend that.
            let costs = scratch.support.is_some().then_some(costs);
            let best = winner(&scratch.sums, least, costs, self.task.range);
            scratch.winners.set(column, best);
            if self.found.confidence.is_some() {
                scratch
                    .winners
                    .compare(column, &scratch.sums, self.task.range);
            }
        }
        scratch
            .winners
            .disparities(&mut self.found.disparities[place..][..width]);
        if let Some(confidence) = &mut self.found.confidence {
            scratch
                .winners
                .confidences(&mut confidence[place..][..width]);
        }
        if let Some(opposite) = &mut self.found.opposite {
            let found = scratch.opposite.disparities(width);
            opposite[place..][..width].copy_from_slice(found);
        }
    }
}

/// The sums of the path costs; returns the least.
#[inline(always)]
fn sum(paths: [&[u8]; PATHS], sums: &mut [u16]) -> u16 {
    let [a, b, c, d, e] = paths;
    let [a, b] = [a.as_chunks::<LANES>().0, b.as_chunks::<LANES>().0];
    let [c, d, e] = [
        c.as_chunks::<LANES>().0,
        d.as_chunks::<LANES>().0,
        e.as_chunks::<LANES>().0,
    ];
    let mut least = [u16::MAX; LANES];
    for (index, sums) in sums.as_chunks_mut::<LANES>().0.iter_mut().enumerate() {
        let (a, b, c) = (&a[index], &b[index], &c[index]);
        let (d, e) = (&d[index], &e[index]);
        let mut total = [0; LANES];
        for lane in 0..LANES {
            total[lane] = u16::from(a[lane])
                + u16::from(b[lane])
                + u16::from(c[lane])
                + u16::from(d[lane])
                + u16::from(e[lane]);
        }
        for lane in 0..LANES {
            least[lane] = least[lane].min(total[lane]);
        }
        *sums = total;
    }
    least_of_words(least)
}

#[cfg(test)]
mod tests {
    use ga_image::plane::Plane;
    use ga_runtime::batch::Batch;
    use proptest::prelude::*;

    use super::*;
    use crate::matcher::winner::{least_cost, winner};

    const RANGE: usize = 11;
    const OUTSIDE: u8 = 31;

    fn view(plane: &Plane<u8>, mirrored: bool) -> View {
        let mut view = View::new(plane.width(), plane.height(), mirrored);
        view.fill(plane.view(), |level| level, 0);
        view
    }

    /// The matching cost of two pixels, from its definition.
    fn cost(left: &Plane<u8>, right: &Plane<u8>, column: usize, row: usize, d: usize) -> i32 {
        let Some(target) = column.checked_sub(d) else {
            return i32::from(OUTSIDE);
        };
        let level = |plane: &Plane<u8>, x: usize, y: usize, dx: isize, dy: isize| {
            let last = [plane.width(), plane.height()].map(|n| n.cast_signed() - 1);
            let x = (x.cast_signed() + dx).clamp(0, last[0]);
            let y = (y.cast_signed() + dy).clamp(0, last[1]);
            i32::from(plane.row(y.cast_unsigned())[x.cast_unsigned()])
        };
        let mut distance = 0;
        for dy in -3..=3 {
            for dx in -4..=4 {
                let darker = |plane, x| level(plane, x, row, dx, dy) < level(plane, x, row, 0, 0);
                distance += i32::from(darker(left, column) != darker(right, target));
            }
        }
        let slope = |plane, x| {
            let side = |dx| -> i32 {
                let weights = [(-1, 1), (0, 2), (1, 1)];
                weights
                    .iter()
                    .map(|(dy, w)| w * level(plane, x, row, dx, *dy))
                    .sum()
            };
            ((side(1) - side(-1)) >> 2).clamp(-128, 127)
        };
        let brightness = (level(left, column, row, 0, 0) - level(right, target, row, 0, 0)).abs();
        3 * distance / 2
            + brightness.min(12) / 4
            + (slope(left, column) - slope(right, target)).abs().min(8)
    }

    /// The path costs of all pixels in one direction, from the equation.
    fn paths(
        costs: &[Vec<[i32; RANGE]>],
        left: &Plane<u8>,
        [dx, dy]: [isize; 2],
        large: impl Fn(i32) -> i32,
        small: i32,
    ) -> Vec<Vec<[i32; RANGE]>> {
        let (width, height) = (left.width(), left.height());
        let mut paths = costs.to_vec();
        for row in 0..height {
            for step in 0..width {
                let column = if dx < 0 { width - 1 - step } else { step };
                let x = column.checked_add_signed(-dx).filter(|x| *x < width);
                let (Some(x), Some(y)) = (x, row.checked_add_signed(-dy)) else {
                    continue;
                };
                let before = paths[y][x];
                let least = before.iter().copied().min().unwrap_or(0);
                let [a, b] = [(column, row), (x, y)].map(|(x, y)| i32::from(left.row(y)[x]));
                for d in 0..RANGE {
                    let mut best = before[d].min(least + large((a - b).abs()));
                    if d > 0 {
                        best = best.min(before[d - 1] + small);
                    }
                    if d + 1 < RANGE {
                        best = best.min(before[d + 1] + small);
                    }
                    paths[row][column][d] = costs[row][column][d] + best - least;
                }
            }
        }
        paths
    }

    fn pair() -> impl Strategy<Value = (Plane<u8>, Plane<u8>)> {
        (12usize..30, 9usize..20).prop_flat_map(|(width, height)| {
            let view = move || {
                // Dark and bright pixels and steps between, so that all penalties occur.
                let level = prop_oneof![0u8..12, 100u8..140, any::<u8>()];
                prop::collection::vec(level, width * height)
                    .prop_map(move |levels| Plane::from_values(width, height, levels).unwrap())
            };
            (view(), view())
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(40))]

        #[test]
        fn path_costs_are_those_of_the_equation(
            (left, right) in pair(),
            median in 1u8..30,
        ) {
            let (width, height) = (left.width(), left.height());
            let penalties = Penalties::new(median, 0.0);
            let k = (f64::from(median) / 6.0).clamp(1.0, 3.0);
            let small = (12.0 * k).round();
            let large = |g: i32| {
                (60.0 * k / f64::from(1 + g / 4)).clamp(small + 2.0, 150.0).floor() as i32
            };
            let costs: Vec<Vec<[i32; RANGE]>> = (0..height)
                .map(|row| {
                    let pixel = |column| {
                        std::array::from_fn(|d| cost(&left, &right, column, row, d))
                    };
                    (0..width).map(pixel).collect()
                })
                .collect();
            let directions = [[1, 1], [0, 1], [-1, 1], [1, 0], [-1, 0]];
            let expected = directions
                .map(|direction| paths(&costs, &left, direction, large, small as i32));
            let views = [view(&left, false), view(&right, true)];
            let task = Task {
                reference: &views[0],
                other: &views[1],
                range: RANGE,
                penalties: &penalties,
                outside: OUTSIDE,
                threshold: 3,
            };
            let mut scratch = Scratch::new(width, RANGE, false);
            for rows in 1..=height {
                let mut disparities = vec![0; rows * width];
                let mut confidence = vec![0; rows * width];
                let mut opposite = vec![0; rows * width];
                Batch::new().run(Sweep {
                    task,
                    rows: 0..rows,
                    scratch: &mut scratch,
                    found: Found {
                        disparities: &mut disparities,
                        confidence: Some(&mut confidence),
                        opposite: Some(&mut opposite),
                    },
                });
                let row = rows - 1;
                let [a, b, c] = &scratch.above;
                let found = [a, b, c, &scratch.forward, &scratch.backward];
                for column in 0..width {
                    let mut sums = vec![u16::MAX; LANES];
                    for d in 0..RANGE {
                        sums[d] = 0;
                        for (found, expected) in found.iter().zip(&expected) {
                            let value = i32::from(found.pixel(column)[d]);
                            prop_assert_eq!(value, expected[row][column][d]);
                            sums[d] += value as u16;
                        }
                    }
                    let place = (0..RANGE).min_by_key(|d| sums[*d]).unwrap_or(0);
                    let best = winner(&sums, least_cost(&sums), None, RANGE);
                    prop_assert!(best.disparity().abs_diff(32 * place as u16) <= 16);
                    prop_assert_eq!(disparities[row * width + column], best.disparity());
                }
                for target in 0..width {
                    let candidates = (0..RANGE.min(width - target)).map(|d| {
                        let total: i32 = expected.iter().map(|p| p[row][target + d][d]).sum();
                        (total, d)
                    });
                    let least = candidates.clone().map(|(total, _)| total).min();
                    let place = usize::from(opposite[row * width + width - 1 - target]);
                    let chosen = candidates.clone().find(|(_, d)| *d == place);
                    prop_assert_eq!(chosen.map(|(total, _)| total), least);
                }
            }
        }
    }
}
