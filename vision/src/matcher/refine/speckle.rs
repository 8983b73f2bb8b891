//! Small islands of disparities, which are mostly wrong.

use super::super::winner::{STEPS, UNKNOWN};

/// Runs of pixels of a row whose disparities differ by at most 1 px from each to the next, joined
/// to islands where pixels above each other differ by at most that.
#[derive(Clone, Debug, Default)]
pub(in super::super) struct Islands {
    /// First pixel and end of each run, as places in the map.
    runs: Vec<[u32; 2]>,
    /// Another run of the same island, or itself.
    parents: Vec<u32>,
    /// The pixels of the island, where the run is its own parent.
    sizes: Vec<u32>,
}

impl Islands {
    /// Marks the disparities of islands of fewer than `least` pixels as unknown.
    pub(in super::super) fn remove(&mut self, map: &mut [u16], width: usize, least: u32) {
        self.runs.clear();
        self.parents.clear();
        self.sizes.clear();
        let mut above = 0..0;
        for start in (0..map.len()).step_by(width) {
            let first = self.runs.len();
            self.split(&map[start..][..width], start);
            let here = first..self.runs.len();
            self.join(map, width, above, here.clone());
            above = here;
        }
        for run in 0..self.runs.len() {
            let root = self.root(run as u32);
            if self.sizes[root as usize] < least {
                let [start, end] = self.runs[run];
                map[start as usize..end as usize].fill(UNKNOWN);
            }
        }
    }

    /// Adds the runs of a row that begins at the place `start`.
    fn split(&mut self, row: &[u16], start: usize) {
        let mut column = 0;
        while column < row.len() {
            let from = column;
            column += 1;
            if row[from] == UNKNOWN {
                continue;
            }
            while column < row.len() && near(row[column - 1], row[column]) {
                column += 1;
            }
            self.parents.push(self.runs.len() as u32);
            self.sizes.push((column - from) as u32);
            self.runs
                .push([(start + from) as u32, (start + column) as u32]);
        }
    }

    /// Joins runs of two rows.
    fn join(&mut self, map: &[u16], width: usize, above: Range, here: Range) {
        let (mut upper, mut lower) = (above.start, here.start);
        while upper < above.end && lower < here.end {
            let [start_above, end_above] = self.runs[upper].map(|place| place as usize + width);
            let [start, end] = self.runs[lower].map(|place| place as usize);
            let mut common = start.max(start_above)..end.min(end_above);
            if common.any(|place| near(map[place], map[place - width])) {
                self.unite(upper as u32, lower as u32);
            }
            if end_above <= end {
                upper += 1;
            } else {
                lower += 1;
            }
        }
    }

    fn unite(&mut self, a: u32, b: u32) {
        let (a, b) = (self.root(a), self.root(b));
        if a != b {
            let (small, large) = if self.sizes[a as usize] < self.sizes[b as usize] {
                (a, b)
            } else {
                (b, a)
            };
            self.parents[small as usize] = large;
            self.sizes[large as usize] += self.sizes[small as usize];
        }
    }

    fn root(&mut self, mut run: u32) -> u32 {
        while self.parents[run as usize] != run {
            let next = self.parents[self.parents[run as usize] as usize];
            self.parents[run as usize] = next;
            run = next;
        }
        run
    }
}

type Range = std::ops::Range<usize>;

fn near(a: u16, b: u16) -> bool {
    a != UNKNOWN && b != UNKNOWN && a.abs_diff(b) <= STEPS
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// Islands found by following neighbours from each pixel.
    fn followed(map: &[u16], width: usize, least: u32) -> Vec<u16> {
        let mut kept = map.to_vec();
        for start in 0..map.len() {
            let mut seen = vec![start];
            let mut next = 0;
            while let Some(place) = seen.get(next).copied() {
                next += 1;
                let column = place % width;
                let candidates = [
                    (column > 0).then(|| place - 1),
                    (column + 1 < width).then(|| place + 1),
                    place.checked_sub(width),
                    (place + width < map.len()).then(|| place + width),
                ];
                for other in candidates.into_iter().flatten() {
                    if near(map[place], map[other]) && !seen.contains(&other) {
                        seen.push(other);
                    }
                }
            }
            if (seen.len() as u32) < least {
                kept[start] = UNKNOWN;
            }
        }
        kept
    }

    proptest! {
        #[test]
        fn islands_are_what_can_be_reached(
            width in 1usize..12,
            values in prop::collection::vec(0u16..5, 1..120),
            least in 1u32..12,
        ) {
            let height = values.len().div_ceil(width);
            let value = |place: usize| match values.get(place) {
                Some(4) | None => UNKNOWN,
                Some(value) => value * 25,
            };
            let mut map: Vec<u16> = (0..width * height).map(value).collect();
            let expected = followed(&map, width, least);
            Islands::default().remove(&mut map, width, least);
            prop_assert_eq!(map, expected);
        }
    }
}
