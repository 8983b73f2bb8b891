//! The best match of a block in a whole range of motions.

use super::block::{Frames, Vector};
use super::cell::CELL;
use ga_image::plane::Plane;

/// The side of a quarter of a block.
const QUARTER: usize = CELL / 2;

/// The quarters of a block, from its corner.
const QUARTERS: [[usize; 2]; 4] = [[0, 0], [QUARTER, 0], [0, QUARTER], [QUARTER, QUARTER]];

/// How far a motion goes along each axis at most.
pub(super) const RANGE: usize = 8;

/// Places of a row to which a block may have moved.
const SPAN: usize = 2 * RANGE + 1;

/// Searches all motions up to [`RANGE`], and compares pixels at few of them.
///
/// The sum of absolute differences of two blocks is at least the sum over their quarters of the
/// absolute difference of the sums of levels. Motions for which this bound is not below the least
/// sum that is known are left out, so that the result is that of a comparison with all of them (X.
/// Q. Gao, C. J. Duanmu, C. R. Zou, "A multilevel successive elimination algorithm for block
/// matching motion estimation", 2000).
pub(super) struct Elimination<'a> {
    frames: &'a Frames<'a>,
    /// The sums of the levels of the quarters that begin at each pixel.
    previous: Plane<u16>,
    current: Plane<u16>,
}

impl<'a> Elimination<'a> {
    #[inline(always)]
    pub(super) fn new(frames: &'a Frames<'a>) -> Self {
        Self {
            previous: quarters(frames.previous),
            current: quarters(frames.current),
            frames,
        }
    }

    /// The motion of the block at a place with the least sum of absolute differences. Of equal
    /// ones, no motion counts before all others, and these in the order from the lowest and
    /// rightmost place of the block before to the highest and leftmost. The nearer the guesses are
    /// to the result, the less is compared.
    #[inline(always)]
    pub(super) fn search(&self, place: [usize; 2], guesses: [Vector; 2]) -> Vector {
        let frames = self.frames;
        let still = frames.error(place, [0; 2]).unwrap_or(u32::MAX);
        let mut best = ([0; 2], still);
        // The least sum that is known, perhaps of a motion that is not yet reached in the order.
        let mut least = still;
        for guess in guesses {
            let error = frames.error(place, guess);
            least = error.map_or(least, |error| error.min(least));
        }
        let first = place.map(|start| start.saturating_sub(RANGE));
        let last = [0, 1].map(|axis| (place[axis] + RANGE).min(frames.last[axis]));
        let mut bounds = [0; SPAN];
        for row in (first[1]..=last[1]).rev() {
            let bounds = &mut bounds[..=last[0] - first[0]];
            self.bounds(place, [first[0], row], bounds);
            let is_near = |bound: u16| u32::from(bound) <= least;
            if !bounds
                .iter()
                .fold(false, |any, bound| any | is_near(*bound))
            {
                continue;
            }
            for (step, bound) in bounds.iter().enumerate().rev() {
                let bound = u32::from(*bound);
                if bound > least || bound >= best.1 {
                    continue;
                }
                let motion = [
                    place[0].cast_signed() - (first[0] + step).cast_signed(),
                    place[1].cast_signed() - row.cast_signed(),
                ];
                if let Some(error) = frames.error(place, motion)
                    && error < best.1
                {
                    best = (motion, error);
                    least = least.min(error);
                }
            }
        }
        best.0
    }

    /// The bounds for the blocks before that begin at `[left, row]` and beside it.
    #[inline(always)]
    fn bounds(&self, place: [usize; 2], [left, row]: [usize; 2], bounds: &mut [u16]) {
        bounds.fill(0);
        let width = self.current.width();
        for [across, down] in QUARTERS {
            let own = self.current.values()[(place[1] + down) * width + place[0] + across];
            let others = &self.previous.values()[(row + down) * width + left + across..];
            for (bound, other) in bounds.iter_mut().zip(others) {
                *bound += own.abs_diff(*other);
            }
        }
    }
}

/// The sums of the levels in each square of four by four pixels, by the place of its corner.
#[inline(always)]
fn quarters(picture: &Plane<u8>) -> Plane<u16> {
    let [width, height] =
        [picture.width(), picture.height()].map(|side| side.saturating_sub(QUARTER - 1));
    let mut sums = Plane::filled(width, height, 0);
    let mut columns = vec![0u16; picture.width()];
    for row in 0..height {
        columns.fill(0);
        for levels in (row..row + QUARTER).map(|row| picture.row(row)) {
            for (sum, level) in columns.iter_mut().zip(levels) {
                *sum += u16::from(*level);
            }
        }
        for (sum, columns) in sums.row_mut(row).iter_mut().zip(columns.windows(QUARTER)) {
            *sum = columns.iter().sum();
        }
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What a comparison with all motions finds, in the order that `search` states.
    fn exhaustive(frames: &Frames<'_>, place: [usize; 2]) -> Vector {
        let range = RANGE.cast_signed();
        let mut best = ([0; 2], frames.error(place, [0; 2]).unwrap());
        for down in -range..=range {
            for across in -range..=range {
                if let Some(error) = frames.error(place, [across, down])
                    && error < best.1
                {
                    best = ([across, down], error);
                }
            }
        }
        best.0
    }

    /// Noise of some levels over a slope, a wave or nothing, seen by a camera that moves.
    fn frames(kind: u32, size: [usize; 2]) -> [Plane<u8>; 2] {
        let mut state = 17 + kind;
        let mut random = |levels: u32| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            ((u64::from(state) * u64::from(levels)) >> 32) as u8
        };
        let noise = Plane::from_fn(size[0] + 20, size[1] + 20, |_, _| random(1 + 16 * kind));
        let [first, second] = [[0, 0], [5, 3]].map(|[left, top]| {
            Plane::from_fn(size[0], size[1], |column, row| {
                let [x, y] = [column + left, row + top];
                let level = match kind % 3 {
                    0 => 80,
                    1 => 40 + x + y / 2,
                    _ => (100.0 + 40.0 * (0.4 * x as f64).sin() * (0.3 * y as f64).cos()) as usize,
                };
                // A part that does not move with the camera.
                let still = (20..40).contains(&column) && (10..30).contains(&row);
                let grain = match still {
                    true => noise.row(row)[column],
                    false => noise.row(y)[x],
                };
                (level as u8)
                    .saturating_add(grain / 2)
                    .saturating_add(random(3))
            })
        });
        [first, second]
    }

    #[test]
    fn elimination_finds_what_a_comparison_with_all_motions_finds() {
        for kind in 0..9 {
            for size in [[8, 8], [9, 30], [70, 50]] {
                let [previous, current] = frames(kind, size);
                let frames = Frames::new(&previous, &current);
                let elimination = Elimination::new(&frames);
                let mut before = [0; 2];
                for row in 0..=frames.last[1] {
                    for column in 0..=frames.last[0] {
                        let place = [column, row];
                        let expected = exhaustive(&frames, place);
                        for guesses in [[[0; 2]; 2], [before, [5, 3]], [[100, -100], [-7, 8]]] {
                            let found = elimination.search(place, guesses);
                            assert_eq!(found, expected, "{kind}, {size:?}, {place:?}");
                        }
                        before = expected;
                    }
                }
            }
        }
    }

    /// Where all levels have risen, the error of the true motion is its bound, and that of a guess.
    #[test]
    fn a_guess_whose_error_is_its_bound_is_found() {
        let [previous, _] = frames(4, [60, 50]);
        let current = Plane::from_fn(60, 50, |column, row| {
            previous.row(row.saturating_sub(2))[column.saturating_sub(3)].saturating_add(4)
        });
        let frames = Frames::new(&previous, &current);
        let elimination = Elimination::new(&frames);
        let place = [25, 20];
        assert_eq!(frames.error(place, [3, 2]), Some(4 * 64));
        assert_eq!(exhaustive(&frames, place), [3, 2]);
        assert_eq!(elimination.search(place, [[3, 2], [0, 0]]), [3, 2]);
        assert_eq!(elimination.search(place, [[0, 0]; 2]), [3, 2]);
    }

    #[test]
    fn bounds_are_not_above_errors() {
        let [previous, current] = frames(5, [40, 30]);
        let frames = Frames::new(&previous, &current);
        let elimination = Elimination::new(&frames);
        let place = [12, 10];
        let mut equal = 0;
        for row in 4..20 {
            let mut bounds = [0; 9];
            elimination.bounds(place, [8, row], &mut bounds);
            for (step, bound) in bounds.into_iter().enumerate() {
                let motion = [4 - step.cast_signed(), 10 - row.cast_signed()];
                let error = frames.error(place, motion).unwrap();
                assert!(u32::from(bound) <= error, "{bound} and {error}");
                equal += usize::from(error < 2 * u32::from(bound));
            }
        }
        // They are bounds that leave something out.
        assert!(equal > 0);
    }
}
