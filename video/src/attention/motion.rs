//! What moves otherwise than the whole picture.

use super::block::{Block, Frames, Vector};
use super::cell::{CELL, cells};
use ga_image::plane::Plane;
use ga_runtime::batch::{Batch, Work};

use super::reduction::reduced;
use super::search::Elimination;

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
        let middle = parts.len() / 2;
        *parts.select_nth_unstable(middle).1
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

#[cfg(test)]
mod tests {
    use super::super::block::{AREA, NOISE};
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
