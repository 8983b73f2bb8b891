//! The disparity of least cost at a pixel.

use super::lanes::{LANES, least_of_words};

/// Disparities are kept as multiples of 1/32 px.
pub(super) const STEPS: u16 = 32;
/// Stands for a disparity that is not known.
pub(super) const UNKNOWN: u16 = u16::MAX;

/// The paths in a sum of path costs.
const PATHS: u16 = 5;

/// The best candidate of a pixel, in numbers from which its disparity and confidence follow.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Winner {
    /// The disparity in whole pixels.
    place: u16,
    cost: u16,
    /// What is compared between whole disparities: of the candidate below, this one and the one
    /// above; equal numbers where there are not all three.
    around: [u16; 3],
}

impl Winner {
    /// In 1/32 px.
    ///
    /// Between whole disparities, two lines of equal and opposite slope are taken through the three
    /// numbers (M. Shimizu and M. Okutomi, "Sub-pixel estimation error cancellation on area-based
    /// matching", International Journal of Computer Vision 63, 2005).
    #[inline(always)]
    pub(super) fn disparity(self) -> u16 {
        let [below, at, above] = self.around.map(i32::from);
        let steeper = below.max(above) - at.min(below).min(above);
        let offset = f32::from(STEPS / 2) * (below - above) as f32 / steeper.max(1) as f32;
        let offset = offset.round_ties_even() as i16;
        (self.place * STEPS).wrapping_add_signed(offset)
    }

    /// How much worse the best candidate is that is not beside this one: 255 · (1 − S / S′), or 0
    /// where there is no other. `second` is what it costs.
    #[inline(always)]
    fn confidence(self, second: u16) -> u8 {
        let ratio = 255.0 * f32::from(self.cost) / f32::from(second.max(1));
        if second == u16::MAX || second == 0 {
            0
        } else {
            255 - ratio as u8
        }
    }
}

/// The winner among the costs of `range` disparities, whose least is `best`. `sums` is a whole
/// number of blocks. Between whole disparities, sums are compared, to which the matching costs,
/// where they are given, are added once more for each path.
#[inline(always)]
pub(super) fn winner(sums: &[u16], best: u16, costs: Option<&[u8]>, range: usize) -> Winner {
    let place = first_with(sums, best);
    let mut around = [0; 3];
    if place > 0 && place + 1 < range {
        around.copy_from_slice(&sums[place - 1..=place + 1]);
        if let Some(costs) = costs {
            for (sum, cost) in around.iter_mut().zip(&costs[place - 1..=place + 1]) {
                *sum += PATHS * u16::from(*cost);
            }
        }
    }
    Winner {
        place: place as u16,
        cost: best,
        around,
    }
}

/// The winners of the pixels of a row. Their disparities and confidences are computed together,
/// since divisions of single numbers are slow.
#[derive(Clone, Debug)]
pub(super) struct WinnerRow {
    places: Vec<u16>,
    costs: Vec<u16>,
    around: [Vec<u16>; 3],
    /// The least costs of candidates that are not beside the winners.
    seconds: Vec<u16>,
}

impl WinnerRow {
    /// For `width` pixels.
    pub(super) fn new(width: usize) -> Self {
        let row = || vec![0; width];
        Self {
            places: row(),
            costs: row(),
            around: [row(), row(), row()],
            seconds: row(),
        }
    }

    /// Sets the winner of a pixel.
    #[inline(always)]
    pub(super) fn set(&mut self, column: usize, winner: Winner) {
        self.places[column] = winner.place;
        self.costs[column] = winner.cost;
        for (row, number) in self.around.iter_mut().zip(winner.around) {
            row[column] = number;
        }
    }

    /// Sets what the confidence of the winner of a pixel is compared with, from the sums among
    /// which it is the winner.
    #[inline(always)]
    pub(super) fn compare(&mut self, column: usize, sums: &[u16], range: usize) {
        let sums = &sums[..range.next_multiple_of(LANES)];
        self.seconds[column] = least_apart_from(sums, self.places[column], range);
    }

    /// The disparities of all winners, in 1/32 px.
    #[inline(always)]
    pub(super) fn disparities(&self, disparities: &mut [u16]) {
        for (column, disparity) in disparities.iter_mut().enumerate() {
            *disparity = self.get(column).disparity();
        }
    }

    /// The confidences of all winners.
    #[inline(always)]
    pub(super) fn confidences(&self, confidences: &mut [u8]) {
        for (column, confidence) in confidences.iter_mut().enumerate() {
            *confidence = self.get(column).confidence(self.seconds[column]);
        }
    }

    #[inline(always)]
    fn get(&self, column: usize) -> Winner {
        let [below, at, above] = &self.around;
        Winner {
            place: self.places[column],
            cost: self.costs[column],
            around: [below[column], at[column], above[column]],
        }
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

/// The least of the first `range` sums that are not at a place or beside it.
#[inline(always)]
fn least_apart_from(sums: &[u16], place: u16, range: usize) -> u16 {
    let (before, range) = (place.wrapping_sub(1), range as u16);
    let mut smallest = [u16::MAX; LANES];
    for (index, block) in sums.as_chunks::<LANES>().0.iter().enumerate() {
        let first = (index * LANES) as u16;
        for lane in 0..LANES {
            let here = first + lane as u16;
            let is_beside = here.wrapping_sub(before) <= 2;
            let sum = if is_beside | (here >= range) {
                u16::MAX
            } else {
                block[lane]
            };
            smallest[lane] = smallest[lane].min(sum);
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
            let mut row = WinnerRow::new(1);
            row.set(0, found);
            row.compare(0, &sums, range);
            let mut confidence = [0];
            row.confidences(&mut confidence);
            let confidence = f64::from(confidence[0]);
            prop_assert!((confidence - expected).abs() <= 1.0, "{confidence} {expected}");
        }

        /// Where the costs around the winner are those of two lines of equal slope, the place where
        /// these meet is found, from sums or from costs in addition to sums that are all equal.
        #[test]
        fn lines_meet_between_whole_disparities(offset in -16i16..=16, slope in 1u16..3) {
            let meeting = 160u16.wrapping_add_signed(offset);
            let line = |place: u16| slope * (32 * place).abs_diff(meeting);
            let sums: Vec<u16> = (0..32).map(line).collect();
            let best = winner(&sums, least_cost(&sums), None, 11).disparity();
            prop_assert_eq!(best, meeting);
            let costs: Vec<u8> = (0..32).map(|place| line(place).min(200) as u8).collect();
            let mut flat = vec![9; 32];
            flat[5] = 8;
            let best = winner(&flat, 8, Some(&costs), 11).disparity();
            prop_assert!(best.abs_diff(meeting) <= 1, "{best}");
        }
    }
}
