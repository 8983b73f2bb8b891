//! The search for a chessboard in several sizes of a picture.

use std::collections::HashSet;

use ga_image::plane::Plane;
use ga_image::pyramid::halved;
use ga_runtime::vga2::Vector;

use super::BoardSize;
use super::grid;
use super::refinement::Gradient;
use super::saddle::{Saddle, saddles};
use super::whole_board::Candidate;
use crate::calibration::{BoardView, CalibrationError, SeenPoint};
use crate::found_board::FoundBoard;

/// Where the longer side of a picture is within this, it is not made smaller at first.
const FIRST_SIDE: usize = 1000;
/// The least of the shorter side of a picture that is made smaller.
const LEAST_SIDE: usize = 80;

/// A search for a board, whole or in part.
pub(super) struct Search {
    size: BoardSize,
    /// The picture, and each time one of half the size.
    levels: Vec<Plane<f32>>,
    /// The order in which they are looked at, and the saddle points of those that have been.
    order: Vec<usize>,
    saddles: Vec<Vec<Saddle>>,
    /// How many corners the largest grid has, and its columns and rows.
    largest: (usize, [usize; 2]),
}

/// The size of a board or a part, and the pixels of the corners.
type Found = (BoardSize, Vec<[f64; 2]>);

impl Search {
    /// A search in a picture whose white is 1.
    pub(super) fn new(picture: Plane<f32>, size: BoardSize) -> Self {
        let mut levels = vec![picture];
        while let Some(last) = levels.last()
            && last.width().min(last.height()) >= 2 * LEAST_SIDE
        {
            levels.push(halved(last));
        }
        let side = |level: &Plane<f32>| level.width().max(level.height());
        let first = levels.iter().position(|level| side(level) <= FIRST_SIDE);
        let first = first.unwrap_or(levels.len() - 1);
        Self {
            size,
            order: (0..=first).rev().chain(first + 1..levels.len()).collect(),
            levels,
            saddles: Vec::new(),
            largest: (0, [0, 0]),
        }
    }

    /// The whole board.
    pub(super) fn whole(&mut self) -> Result<FoundBoard, CalibrationError> {
        let (_, corners) = self.first_of(&[self.size])?;
        let view = BoardView::complete(&corners);
        let orders = other_orders(self.size);
        Ok(FoundBoard::new(self.size.columns(), view, orders))
    }

    /// The largest part of the board that the border of the picture leaves.
    pub(super) fn part(&mut self) -> Result<FoundBoard, CalibrationError> {
        let (part, corners) = self.first_of(&self.size.parts())?;
        let columns = self.size.columns();
        let seen = corners.into_iter().enumerate().map(|(index, pixel)| {
            let (column, row) = (index % part.columns(), index / part.columns());
            let point = row * columns + column;
            SeenPoint { point, pixel }
        });
        let view = BoardView::of_different(seen.collect());
        Ok(FoundBoard::new(columns, view, Vec::new()))
    }

    /// The first of several sizes in which the board is found.
    fn first_of(&mut self, sizes: &[BoardSize]) -> Result<Found, CalibrationError> {
        let picture = &self.levels[0];
        let mut gradient = None;
        for (place, &level) in self.order.iter().enumerate() {
            if place == self.saddles.len() {
                self.saddles
                    .push(saddles(&self.levels[level], self.size.count())?);
            }
            let saddles = &self.saddles[place];
            // Grids that share saddle points have candidates in common.
            let mut tried = HashSet::new();
            for grid in grid::grids(saddles) {
                if grid.corner_count() > self.largest.0 {
                    self.largest = (grid.corner_count(), grid.extent());
                }
                let boards = |size: &BoardSize| {
                    let (size, boards) = (*size, grid.boards(*size));
                    boards.into_iter().map(move |board| (size, board))
                };
                for (size, indices) in sizes.iter().flat_map(boards) {
                    if tried.contains(&indices) {
                        continue;
                    }
                    // The centre of a pixel of a halved picture is that of a pixel of the picture.
                    let scale = f64::from(1_u32 << level);
                    let corners = indices.iter().map(|&index| saddles[index].place * scale);
                    let corners: Vec<Vector<f64>> = corners.collect();
                    let candidate = Candidate {
                        picture,
                        corners: &corners,
                        size,
                        whole: self.size,
                    };
                    // Of a large board there are many parts, of which few need to be kept.
                    if !candidate.is_cut_where_short() {
                        continue;
                    }
                    tried.insert(indices);
                    if !candidate.is_board() {
                        continue;
                    }
                    let gradient = match &mut gradient {
                        Some(gradient) => gradient,
                        none => none.insert(Gradient::new(picture)?),
                    };
                    if let Some(corners) = gradient.refine(&corners, size) {
                        let corners = corners.into_iter().map(Vector::coordinates);
                        return Ok((size, corners.collect()));
                    }
                }
            }
        }
        let (corners, extent) = self.largest;
        Err(CalibrationError::NotFound {
            size: [self.size.columns(), self.size.rows()],
            corners,
            extent,
        })
    }
}

/// The orders other than the first in which a board looks the same, as indices of its corners.
fn other_orders(size: BoardSize) -> Vec<Vec<usize>> {
    let BoardSize { columns, rows } = size;
    let index = |column: usize, row: usize| row * columns + column;
    let (right, bottom) = (columns - 1, rows - 1);
    let rotated = |from: &dyn Fn(usize, usize) -> usize| -> Vec<usize> {
        let corners = 0..size.count();
        corners.map(|k| from(k % columns, k / columns)).collect()
    };
    let mut orders = Vec::new();
    if (columns + rows).is_multiple_of(2) {
        orders.push(rotated(&|column, row| index(right - column, bottom - row)));
    }
    if columns == rows && columns.is_multiple_of(2) {
        orders.push(rotated(&|column, row| index(right - row, column)));
        orders.push(rotated(&|column, row| index(row, bottom - column)));
    }
    orders
}
