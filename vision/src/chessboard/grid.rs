//! From saddle points to grids: neighbours along edges, one after the other, as in A. Geiger and
//! others, "Automatic camera and range sensor calibration using a single shot", 2012, but with
//! conditions on the edges in place of an energy.

use std::collections::{BTreeMap, VecDeque};

use ga_runtime::vga2::Vector;

use super::BoardSize;
use super::places::Places;
use super::saddle::Saddle;

/// The greatest distance of a corner from where its neighbours suggest it, in steps of the grid.
const REACH: f64 = 0.35;
/// The greatest sine of the angle between an edge and the line to the next corner.
const EDGE_TOLERANCE: f64 = 0.45;
/// The same, for the first neighbours of a corner.
const FIRST_TOLERANCE: f64 = 0.3;
/// The least strength of a corner, as a part of that of the corner beside it.
const LEAST_STRENGTH: f64 = 0.2;
/// Column and row of a corner in a grid, from that of its first corner.
type Cell = [i32; 2];

const DIRECTIONS: [Cell; 4] = [[1, 0], [0, 1], [-1, 0], [0, -1]];

/// Corners in columns and rows. Rows follow columns in the direction from u to v, so that a grid is
/// never mirrored. The squares between a corner of even column + row and its diagonal neighbours
/// towards greater, or lesser, columns and rows are bright.
#[derive(Clone, Debug)]
pub(super) struct Grid<'a> {
    saddles: &'a [Saddle],
    cells: BTreeMap<Cell, usize>,
}

/// Grids that grow from saddle points until each point has had its turn or belongs to one. A point
/// may belong to several: a grid of clutter beside a board must not keep corners from that of the
/// board.
pub(super) fn grids(saddles: &[Saddle]) -> Vec<Grid<'_>> {
    /// A few saddle points in a row are found in any texture.
    const LEAST_CORNERS: usize = 6;
    let places = Places::new(saddles);
    let mut is_free = vec![true; saddles.len()];
    let mut grids = Vec::new();
    for seed in 0..saddles.len() {
        if is_free[seed] {
            let grid = Grid::grown(saddles, &places, seed);
            if grid.corner_count() >= LEAST_CORNERS {
                grid.cells
                    .values()
                    .for_each(|&index| is_free[index] = false);
                grids.push(grid);
            }
        }
    }
    grids
}

impl<'a> Grid<'a> {
    fn grown(saddles: &'a [Saddle], places: &Places, seed: usize) -> Self {
        let cells = BTreeMap::from([([0, 0], seed)]);
        let mut grid = Self { saddles, cells };
        let mut is_free = vec![true; saddles.len()];
        is_free[seed] = false;
        let mut waiting = VecDeque::from([[0, 0]]);
        while let Some(cell) = waiting.pop_front() {
            for direction in DIRECTIONS {
                let next = sum(cell, direction);
                if grid.cells.contains_key(&next) {
                    continue;
                }
                if let Some(index) = grid.neighbour(cell, direction, places, &is_free) {
                    is_free[index] = false;
                    grid.cells.insert(next, index);
                    waiting.push_back(next);
                    // The steps from the new corner may lead to others that were missed before.
                    let around = DIRECTIONS.map(|way| sum(next, way));
                    waiting.extend(around.iter().filter(|near| grid.cells.contains_key(*near)));
                }
            }
        }
        grid
    }

    pub(super) fn corner_count(&self) -> usize {
        self.cells.len()
    }

    /// Columns and rows of the smallest rectangle that contains the grid.
    pub(super) fn extent(&self) -> [usize; 2] {
        [0, 1].map(|axis| {
            let [least, greatest] = self.range(axis);
            (greatest - least + 1).unsigned_abs() as usize
        })
    }

    fn range(&self, axis: usize) -> [i32; 2] {
        let places = || self.cells.keys().map(|cell| cell[axis]);
        [places().min().unwrap_or(0), places().max().unwrap_or(0)]
    }

    fn saddle(&self, cell: Cell) -> Option<&Saddle> {
        self.cells.get(&cell).map(|&index| &self.saddles[index])
    }

    fn place(&self, cell: Cell) -> Option<Vector<f64>> {
        self.saddle(cell).map(|saddle| saddle.place)
    }

    /// The saddle point that is the neighbour of a corner in a direction of the grid.
    fn neighbour(
        &self,
        cell: Cell,
        direction: Cell,
        places: &Places,
        is_free: &[bool],
    ) -> Option<usize> {
        let own = self.saddle(cell)?;
        let axis = usize::from(direction[0] == 0);
        // Edges begin with the bright quadrant on one side and end at a corner where it is on the
        // other: kinds alternate.
        let kind = (axis + (cell[0] + cell[1]).rem_euclid(2) as usize) % 2;
        let edge = own.edges[kind];
        let is_neighbour = |tolerance: f64| {
            move |&index: &usize| {
                let other = &self.saddles[index];
                let line = other.place - own.place;
                let greatest = tolerance * line.length();
                is_free[index]
                    && other.strength >= LEAST_STRENGTH * own.strength
                    && (edge ^ line).e12.abs() < greatest
                    && (other.edges[1 - kind] ^ line).e12.abs() < greatest
            }
        };
        let nearest = |goal: Vector<f64>| {
            move |a: &usize, b: &usize| {
                let distance = |&index: &usize| (self.saddles[index].place - goal).length();
                distance(a).total_cmp(&distance(b))
            }
        };
        let Some(step) = self.step(cell, direction) else {
            let forwards = self.saddle([0, 0])?.edges[axis];
            let forwards = forwards * f64::from(direction[0] + direction[1]);
            let edge = edge * (edge | forwards).signum();
            let is_ahead = |&index: &usize| (edge | (self.saddles[index].place - own.place)) > 0.0;
            let all = 0..self.saddles.len();
            let ahead = all.filter(is_ahead).filter(is_neighbour(FIRST_TOLERANCE));
            return ahead.min_by(nearest(own.place));
        };
        let goal = own.place + step;
        let reach = REACH * step.length();
        let near = places.about(goal, reach);
        let near = near.filter(|&index| (self.saddles[index].place - goal).length() < reach);
        near.filter(is_neighbour(EDGE_TOLERANCE))
            .min_by(nearest(goal))
    }

    /// The step from a corner to its neighbour that the corners around suggest.
    fn step(&self, cell: Cell, direction: Cell) -> Option<Vector<f64>> {
        let own = self.place(cell)?;
        let [across, back] = [[direction[1], direction[0]], opposite(direction)];
        let beside = [across, opposite(across)].into_iter().filter_map(|side| {
            let from = sum(cell, side);
            Some(self.place(sum(from, direction))? - self.place(from)?)
        });
        let behind = self.place(sum(cell, back)).map(|place| own - place);
        let steps: Vec<Vector<f64>> = beside.chain(behind).collect();
        let total = steps
            .iter()
            .fold(Vector::default(), |sum, step| sum + *step);
        (!steps.is_empty()).then(|| total * (1.0 / steps.len() as f64))
    }

    /// The saddle points of all complete rectangles of a size, row by row. The likeliest first: a
    /// board begins at a dark square, and, where several of its corners do, at the one nearest to
    /// the top left of the picture.
    pub(super) fn boards(&self, size: BoardSize) -> Vec<Vec<usize>> {
        let [lefts, tops] = [self.range(0), self.range(1)];
        let mut boards = Vec::new();
        for columns in DIRECTIONS {
            for left in lefts[0]..=lefts[1] {
                for top in tops[0]..=tops[1] {
                    let first = [left, top];
                    let rectangle = Rectangle { first, columns };
                    let cells = rectangle
                        .cells(size)
                        .map(|cell| self.cells.get(&cell).copied());
                    let Some(indices) = cells.collect::<Option<Vec<usize>>>() else {
                        continue;
                    };
                    let corners = indices.iter().map(|&index| self.saddles[index].place);
                    let corners: Vec<Vector<f64>> = corners.collect();
                    if is_even(&corners, size) {
                        let distance = corners[0].e1 + corners[0].e2;
                        boards.push((rectangle.begins_bright(), distance, indices));
                    }
                }
            }
        }
        boards.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        boards.into_iter().map(|(_, _, indices)| indices).collect()
    }
}

/// The corners of a board in a grid: from the first corner on, the columns in a direction, and the
/// rows in the direction that follows it.
#[derive(Clone, Copy, Debug)]
struct Rectangle {
    first: Cell,
    columns: Cell,
}

impl Rectangle {
    fn rows(self) -> Cell {
        [-self.columns[1], self.columns[0]]
    }

    /// Its cells, row by row.
    fn cells(self, size: BoardSize) -> impl Iterator<Item = Cell> {
        let at = move |column: usize, row: usize| {
            [0, 1].map(|axis| {
                let [column, row] = [column, row].map(|k| i32::try_from(k).unwrap_or(i32::MAX / 4));
                self.first[axis] + self.columns[axis] * column + self.rows()[axis] * row
            })
        };
        (0..size.rows()).flat_map(move |row| (0..size.columns()).map(move |column| at(column, row)))
    }

    /// Whether the square between the first corner and its diagonal neighbour is bright.
    fn begins_bright(self) -> bool {
        let [x, y] = sum(self.columns, self.rows());
        let is_even = (self.first[0] + self.first[1]).rem_euclid(2) == 0;
        (x == y) == is_even
    }
}

/// Whether the steps from each corner to its neighbours on either side are similar.
fn is_even(corners: &[Vector<f64>], size: BoardSize) -> bool {
    /// The greatest difference between two steps, as a part of their sum. Perspective of a board as
    /// near as its own size gives 0.2; a grid that leaves out corners gives a third.
    const GREATEST: f64 = 0.28;
    let (columns, rows) = (size.columns(), size.rows());
    let is_similar = |index: usize, stride: usize| {
        let [before, here, after] = [index - stride, index, index + stride].map(|k| corners[k]);
        let [first, second] = [here - before, after - here];
        (second - first).length() < GREATEST * (first + second).length()
    };
    (0..corners.len()).all(|index| {
        let (column, row) = (index % columns, index / columns);
        (column == 0 || column + 1 == columns || is_similar(index, 1))
            && (row == 0 || row + 1 == rows || is_similar(index, columns))
    })
}

fn sum(a: Cell, b: Cell) -> Cell {
    [a[0] + b[0], a[1] + b[1]]
}

fn opposite(direction: Cell) -> Cell {
    direction.map(|k| -k)
}
