//! The disparity of least cost at a pixel.

use super::lanes::{LANES, least_of_words};

/// Disparities are kept as multiples of 1/32 px.
pub(super) const STEPS: u16 = 32;
/// Stands for a disparity that is not known.
pub(super) const UNKNOWN: u16 = u16::MAX;

/// The paths in a sum of path costs.
const PATHS: i32 = 5;

/// The best candidate of a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Winner {
    /// In 1/32 px.
    pub(super) disparity: u16,
    /// The same in whole pixels.
    place: usize,
    cost: u16,
}

impl Winner {
    /// How much worse the best candidate is that is not beside this one: 255 · (1 − S / S′), or 0
    /// where there is no other. `sums` are those of which this is the winner, and are changed.
    #[inline(always)]
    pub(super) fn confidence(&self, sums: &mut [u16], range: usize) -> u8 {
        sums[self.place] = u16::MAX;
        if self.place > 0 {
            sums[self.place - 1] = u16::MAX;
        }
        if self.place + 1 < range {
            sums[self.place + 1] = u16::MAX;
        }
        if range < sums.len() {
            sums[range..].fill(u16::MAX);
        }
        let second = least_cost(sums);
        if second == u16::MAX || second == 0 {
            0
        } else {
            255 - (255.0 * f32::from(self.cost) / f32::from(second)) as u8
        }
    }
}

/// The winner among the costs of `range` disparities, whose least is `best`. `sums` is a whole
/// number of blocks.
///
/// Between whole disparities, two lines of equal and opposite slope are taken through the three
/// sums around the least (M. Shimizu and M. Okutomi, "Sub-pixel estimation error cancellation on
/// area-based matching", International Journal of Computer Vision 63, 2005), to which the matching
/// costs, where they are given, are added once more for each path.
#[inline(always)]
pub(super) fn winner(sums: &[u16], best: u16, costs: Option<&[u8]>, range: usize) -> Winner {
    let place = first_with(sums, best);
    let mut disparity = place as u16 * STEPS;
    if place > 0 && place + 1 < range {
        let total = |place: usize| {
            let cost = costs.map_or(0, |costs| costs[place]);
            i32::from(sums[place]) + PATHS * i32::from(cost)
        };
        let [below, above] = [total(place - 1), total(place + 1)];
        let steeper = below.max(above) - total(place).min(below.min(above));
        if steeper > 0 {
            let offset = f32::from(STEPS / 2) * (below - above) as f32 / steeper as f32;
            disparity = disparity.wrapping_add_signed(offset.round_ties_even() as i16);
        }
    }
    Winner {
        disparity,
        place,
        cost: best,
    }
}

/// The least of the sums.
#[inline(always)]
pub(super) fn least_cost(sums: &[u16]) -> u16 {
    let mut smallest = [u16::MAX; LANES];
    for block in sums.as_chunks::<LANES>().0 {
        for lane in 0..LANES {
            smallest[lane] = smallest[lane].min(block[lane]);
        }
    }
    least_of_words(smallest)
}

/// The first place with a number.
#[inline(always)]
fn first_with(sums: &[u16], number: u16) -> usize {
    let mut places = [u16::MAX; LANES];
    for (index, block) in sums.as_chunks::<LANES>().0.iter().enumerate() {
        let start = (index * LANES) as u16;
        let mut here = [u16::MAX; LANES];
        for lane in 0..LANES {
            here[lane] = if block[lane] == number {
                start + lane as u16
            } else {
                u16::MAX
            };
        }
        for lane in 0..LANES {
            places[lane] = places[lane].min(here[lane]);
        }
    }
    usize::from(least_of_words(places))
}

/// The best candidate of each pixel of the other view, from the costs of this view's pixels: those
/// of a pixel of the other view lie along a diagonal.
#[derive(Clone, Debug)]
pub(super) struct Opposite {
    least: Vec<u16>,
    disparities: Vec<u16>,
}

impl Opposite {
    /// For rows of `width` pixels with `range` candidates, a whole number of blocks.
    pub(super) fn new(width: usize, range: usize) -> Self {
        Self {
            least: vec![0; width + range],
            disparities: vec![0; width + range],
        }
    }

    /// Begins a row. Candidates of the cost `never` or above are not taken.
    #[inline(always)]
    pub(super) fn clear(&mut self, never: u16) {
        self.least.fill(never);
        self.disparities.fill(0);
    }

    /// Takes the costs of the candidates of the pixel `column` of this view.
    #[inline(always)]
    pub(super) fn take(&mut self, column: usize, width: usize, sums: &[u16]) {
        let start = width - 1 - column;
        let least = &mut self.least[start..][..sums.len()];
        let disparities = &mut self.disparities[start..][..sums.len()];
        let least = least.as_chunks_mut::<LANES>().0.iter_mut();
        let disparities = disparities.as_chunks_mut::<LANES>().0;
        let sums = sums.as_chunks::<LANES>().0;
        for (index, ((least, found), sums)) in least.zip(disparities).zip(sums).enumerate() {
            let first = (index * LANES) as u16;
            let (old, cost, mut better) = (*least, *sums, *found);
            let mut lower = [0u16; LANES];
            for lane in 0..LANES {
                let place = first + lane as u16;
                better[lane] = if cost[lane] < old[lane] {
                    place
                } else {
                    better[lane]
                };
                lower[lane] = old[lane].min(cost[lane]);
            }
            *least = lower;
            *found = better;
        }
    }

    /// The disparities in whole pixels of the other view's row, mirrored.
    #[inline(always)]
    pub(super) fn disparities(&self, width: usize) -> &[u16] {
        &self.disparities[..width]
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn sums() -> impl Strategy<Value = (Vec<u16>, usize)> {
        (1usize..3 * LANES).prop_flat_map(|range| {
            let padded = range.next_multiple_of(LANES);
            // What stands behind the sums of the candidates is higher than all of them.
            let candidates = prop::collection::vec(0u16..1200, range);
            candidates.prop_map(move |mut sums| {
                sums.resize(padded, 1275);
                (sums, range)
            })
        })
    }

    proptest! {
        /// From the definition. Where no candidate is left to compare with, nothing is certain.
        #[test]
        fn confidence_compares_with_what_is_not_beside((sums, range) in sums()) {
            let found = winner(&sums, least_cost(&sums), None, range);
            let place = (0..range).min_by_key(|d| sums[*d]).unwrap_or(0);
            let others = (0..range).filter(|d| d.abs_diff(place) > 1);
            let expected = match others.map(|d| f64::from(sums[d])).reduce(f64::min) {
                Some(second) if second > 0.0 => 255.0 * (1.0 - f64::from(sums[place]) / second),
                _ => 0.0,
            };
            let confidence = f64::from(found.confidence(&mut sums.clone(), range));
            prop_assert!((confidence - expected).abs() <= 1.0, "{confidence} {expected}");
        }

        /// Where the costs around the winner are those of two lines of equal slope, the place where
        /// these meet is found, from sums or from costs in addition to sums that are all equal.
        #[test]
        fn lines_meet_between_whole_disparities(offset in -16i16..=16, slope in 1u16..3) {
            let meeting = 160u16.wrapping_add_signed(offset);
            let line = |place: u16| slope * (32 * place).abs_diff(meeting);
            let sums: Vec<u16> = (0..32).map(line).collect();
            let best = winner(&sums, least_cost(&sums), None, 11).disparity;
            prop_assert_eq!(best, meeting);
            let costs: Vec<u8> = (0..32).map(|place| line(place).min(200) as u8).collect();
            let mut flat = vec![9; 32];
            flat[5] = 8;
            let best = winner(&flat, 8, Some(&costs), 11).disparity;
            prop_assert!(best.abs_diff(meeting) <= 1, "{best}");
        }
    }
}
