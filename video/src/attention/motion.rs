//! What moves otherwise than the whole picture.

use ga_image::plane::Plane;
use ga_numerics::order_statistics::median_element;
use ga_runtime::batch::{Batch, Work};

use super::reduction::reduced;
use super::search::Elimination;
use super::{CELL, cells};

/// How far the best of the candidates is refined, in reduced pixels.
const REFINEMENT: isize = 2;

/// The mean deviation in levels below which a block has no texture that could be found again, and
/// the error of a match that noise may cause.
const NOISE: u32 = 2;

/// Pixels of a block.
const AREA: u32 = (CELL * CELL) as u32;

pub(super) type Vector = [isize; 2];

/// |v − v_global| in reduced pixels, for each cell.
///
/// A block counts as moving by itself as far as its own motion explains it better than the global
/// one. It has no motion where a constant explains it better than any match, as where something
/// appears, and after cuts.
pub(super) fn relative(previous: &Plane<u8>, current: &Plane<u8>) -> Plane {
    let [columns, rows] = cells(current);
    let mut relative = Plane::filled(columns, rows, 0.0);
    if current.width().min(current.height()) >= CELL {
        Batch::new().run(Relative {
            previous,
            current,
            relative: &mut relative,
        });
    }
    relative
}

struct Relative<'a> {
    previous: &'a Plane<u8>,
    current: &'a Plane<u8>,
    relative: &'a mut Plane,
}

impl Work for Relative<'_> {
    #[inline(always)]
    fn run(self) {
        let size = [self.relative.width(), self.relative.height()];
        let coarse = coarse(self.previous, self.current, size);
        let frames = Frames::new(self.previous, self.current);
        let mut blocks = Vec::with_capacity(coarse.len());
        for row in 0..size[1] {
            for column in 0..size[0] {
                let place = frames.place([column * CELL, row * CELL]);
                let candidates = candidates(&coarse, size, [column, row]);
                blocks.push(frames.block(place, candidates));
            }
        }
        let global = global(&blocks);
        for (target, block) in self.relative.values_mut().iter_mut().zip(&blocks) {
            *target = frames.deviation(block, global);
        }
    }
}

/// A block and its best match.
struct Block {
    place: [usize; 2],
    /// How far it has moved since the previous frame.
    motion: Vector,
    /// The sum of absolute differences from the match.
    error: u32,
    /// The sum of absolute differences from its own mean.
    texture: u32,
}

impl Block {
    fn has_motion(&self) -> bool {
        self.texture >= NOISE * AREA && self.error < self.texture
    }
}

/// The motions at half size, doubled.
#[inline(always)]
fn coarse(previous: &Plane<u8>, current: &Plane<u8>, [columns, rows]: [usize; 2]) -> Vec<Vector> {
    let [previous, current] = [previous, current].map(|plane| reduced(plane.view(), 2));
    if current.width().min(current.height()) < CELL {
        return vec![[0; 2]; columns * rows];
    }
    let frames = Frames::new(&previous, &current);
    let elimination = Elimination::new(&frames);
    let mut found: Vec<Vector> = Vec::with_capacity(columns * rows);
    for row in 0..rows {
        for column in 0..columns {
            // Around the middle of the cell, which is 4 × 4 pixels here.
            let corner = [column, row].map(|cell| (cell * CELL / 2).saturating_sub(CELL / 4));
            let place = frames.place(corner);
            let cell = found.len();
            let before = |distance: usize| {
                let place = cell.checked_sub(distance);
                place.and_then(|place| found.get(place)).copied()
            };
            let guesses = [1, columns].map(|distance| before(distance).unwrap_or_default());
            found.push(elimination.search(place, guesses));
        }
    }
    found
        .into_iter()
        .map(|motion| motion.map(|part| 2 * part))
        .collect()
}

/// No motion, and those of the cell and of its four neighbours.
#[inline(always)]
fn candidates(coarse: &[Vector], size: [usize; 2], [column, row]: [usize; 2]) -> [Vector; 6] {
    let [columns, rows] = size;
    let at = |column: usize, row: usize| coarse[row * columns + column];
    [
        [0; 2],
        at(column, row),
        at(column.saturating_sub(1), row),
        at((column + 1).min(columns - 1), row),
        at(column, row.saturating_sub(1)),
        at(column, (row + 1).min(rows - 1)),
    ]
}

/// The motion of the camera: the median of the motions, then the mean of those near it.
fn global(blocks: &[Block]) -> [f32; 2] {
    let motions = blocks.iter().filter(|block| block.has_motion());
    let motions: Vec<Vector> = motions.map(|block| block.motion).collect();
    if motions.is_empty() {
        return [0.0; 2];
    }
    let median = [0, 1].map(|axis| {
        let mut parts: Vec<isize> = motions.iter().map(|motion| motion[axis]).collect();
        median_element(&mut parts).unwrap_or(0)
    });
    let is_near = |motion: &&Vector| (0..2).all(|axis| motion[axis].abs_diff(median[axis]) <= 1);
    let near = motions.iter().filter(is_near);
    let (mut sum, mut count) = ([0.0; 2], 0.0);
    for motion in near {
        sum = [0, 1].map(|axis| sum[axis] + motion[axis] as f32);
        count += 1.0;
    }
    if count > 0.0 {
        sum.map(|sum| sum / count)
    } else {
        median.map(|part| part as f32)
    }
}

/// Two frames of one size, with at least as many columns and rows as a block.
pub(super) struct Frames<'a> {
    pub(super) previous: &'a Plane<u8>,
    pub(super) current: &'a Plane<u8>,
    /// The last places where a block may begin.
    pub(super) last: [usize; 2],
}

impl<'a> Frames<'a> {
    #[inline(always)]
    pub(super) fn new(previous: &'a Plane<u8>, current: &'a Plane<u8>) -> Self {
        Self {
            previous,
            current,
            last: [current.width() - CELL, current.height() - CELL],
        }
    }

    /// The place of a block, moved to the inside of the frame.
    #[inline(always)]
    fn place(&self, [column, row]: [usize; 2]) -> [usize; 2] {
        [column.min(self.last[0]), row.min(self.last[1])]
    }

    /// The best of the candidates, refined.
    #[inline(always)]
    fn block(&self, place: [usize; 2], candidates: [Vector; 6]) -> Block {
        let mut best = ([0; 2], u32::MAX);
        for motion in candidates {
            self.search(place, motion, 0, &mut best);
        }
        let middle = best.0;
        self.search(place, middle, REFINEMENT, &mut best);
        let (motion, error) = best;
        Block {
            place,
            motion,
            error,
            texture: self.texture(place),
        }
    }

    /// Tries the motions around one; the first of equal ones stays.
    #[inline(always)]
    fn search(&self, place: [usize; 2], middle: Vector, range: isize, best: &mut (Vector, u32)) {
        for down in -range..=range {
            for across in -range..=range {
                let motion = [middle[0] + across, middle[1] + down];
                if let Some(error) = self.error(place, motion)
                    && error < best.1
                {
                    *best = (motion, error);
                }
            }
        }
    }

    /// The sum of absolute differences between a block and its place before a motion, or `None`
    /// where that was not wholly within the frame.
    #[inline(always)]
    pub(super) fn error(&self, place: [usize; 2], motion: Vector) -> Option<u32> {
        let column = place[0].checked_add_signed(-motion[0])?;
        let row = place[1].checked_add_signed(-motion[1])?;
        if column > self.last[0] || row > self.last[1] {
            return None;
        }
        let width = self.current.width();
        let now = &self.current.values()[place[1] * width + place[0]..];
        let before = &self.previous.values()[row * width + column..];
        // Eight differences are less than 2¹⁶.
        let mut sums = [0u16; CELL];
        for line in 0..CELL {
            let now = now[line * width..].first_chunk::<CELL>()?;
            let before = before[line * width..].first_chunk::<CELL>()?;
            for column in 0..CELL {
                sums[column] += u16::from(now[column].abs_diff(before[column]));
            }
        }
        Some(sums.into_iter().map(u32::from).sum())
    }

    /// The sum of absolute differences of a block from its mean.
    #[inline(always)]
    fn texture(&self, [column, row]: [usize; 2]) -> u32 {
        let lines = || (row..row + CELL).map(|row| &self.current.row(row)[column..][..CELL]);
        let sum: u32 = lines().flatten().map(|level| u32::from(*level)).sum();
        let mean = ((sum + AREA / 2) / AREA) as u8;
        let deviations = lines().flatten().map(|level| level.abs_diff(mean));
        deviations.map(u32::from).sum()
    }

    /// How far a block moves otherwise than all, as far as that is certain.
    #[inline(always)]
    fn deviation(&self, block: &Block, global: [f32; 2]) -> f32 {
        if !block.has_motion() {
            return 0.0;
        }
        // The global motion may lie between whole pixels.
        let [low, high] = [f32::floor, f32::ceil].map(|round| global.map(round));
        let mut with_all = None;
        for x in [low[0], high[0]] {
            for y in [low[1], high[1]] {
                let error = self.error(block.place, [x as isize, y as isize]);
                with_all = with_all.into_iter().chain(error).min();
            }
        }
        let Some(with_all) = with_all else {
            return 0.0;
        };
        let gained = with_all.saturating_sub(block.error) as f32;
        let gain = gained / (block.texture + NOISE * AREA) as f32;
        // Certain from three quarters on, noise below one quarter.
        let certainty = (2.0 * gain - 0.5).clamp(0.0, 1.0);
        let [x, y] = [0, 1].map(|axis| block.motion[axis] as f32 - global[axis]);
        certainty * x.hypot(y)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_motions_of_neighbours_are_candidates() {
        // The cell in column c and row r has found [c, r].
        let coarse: Vec<Vector> = (0..12).map(|cell| [cell % 4, cell / 4]).collect();
        let inside = candidates(&coarse, [4, 3], [2, 1]);
        assert_eq!(inside, [[0, 0], [2, 1], [1, 1], [3, 1], [2, 0], [2, 2]]);
        let corner = candidates(&coarse, [4, 3], [3, 2]);
        assert_eq!(corner, [[0, 0], [3, 2], [2, 2], [3, 2], [3, 1], [3, 2]]);
    }

    /// A texture that has moved by a pixel to the right.
    #[test]
    fn a_block_moves_with_all_between_two_whole_pixels() {
        let [previous, current] = [0, 1].map(|moved| {
            let level = |column: usize, row: usize| {
                let (x, y) = (column + 40 - moved, row);
                (x * x / 3 + 7 * y * y + 11 * x * y) as u8
            };
            Plane::from_fn(40, 40, level)
        });
        let frames = Frames::new(&previous, &current);
        let place = [16, 16];
        let block = Block {
            place,
            motion: [1, 0],
            error: 0,
            texture: frames.texture(place),
        };
        assert_eq!(frames.error(place, [1, 0]), Some(0));
        // The camera has moved by half a pixel: the next whole one explains the block.
        assert_eq!(frames.deviation(&block, [0.5, 0.0]), 0.0);
        assert!(frames.deviation(&block, [-0.5, 0.0]) > 0.5);
    }

    #[test]
    fn blocks_without_texture_and_without_a_match_have_no_motion() {
        let block = |texture, error| Block {
            place: [0, 0],
            motion: [1, 1],
            error,
            texture,
        };
        assert!(block(NOISE * AREA, 0).has_motion());
        assert!(!block(NOISE * AREA - 1, 0).has_motion());
        assert!(!block(NOISE * AREA, NOISE * AREA).has_motion());
    }
}
