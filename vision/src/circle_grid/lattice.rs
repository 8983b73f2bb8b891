//! From discs to lattices: neighbours along two steps, one after the other.

use std::collections::{BTreeMap, VecDeque};

use ga_runtime::vga2::Vector;

use super::disc::Disc;

/// How many times each of the two steps a point of a lattice is from its first point.
pub(super) type Cell = [i32; 2];

const DIRECTIONS: [Cell; 4] = [[1, 0], [0, 1], [-1, 0], [0, -1]];
/// The greatest distance of a disc from where its neighbours suggest it, in steps.
const REACH: f64 = 0.3;
/// The greatest ratio of the areas of neighbours.
const GREATEST_RATIO: f64 = 2.0;

/// Discs at the points of a lattice, whose second step is clockwise from the first.
pub(super) struct Lattice<'a> {
    discs: &'a [Disc],
    steps: [Vector<f64>; 2],
    cells: BTreeMap<Cell, usize>,
}

/// The lattices that grow from discs, until each has had its turn or belongs to one.
pub(super) fn lattices(discs: &[Disc]) -> impl Iterator<Item = Lattice<'_>> {
    let mut is_free = vec![true; discs.len()];
    (0..discs.len()).filter_map(move |seed| {
        let lattice = is_free[seed].then(|| Lattice::grown(discs, seed))??;
        lattice
            .cells
            .values()
            .for_each(|&index| is_free[index] = false);
        Some(lattice)
    })
}

impl<'a> Lattice<'a> {
    /// How many discs it has.
    pub(super) fn len(&self) -> usize {
        self.cells.len()
    }

    /// The lattice about a disc whose steps are those to its nearest neighbour and to the nearest
    /// one that is not about in the same line.
    fn grown(discs: &'a [Disc], seed: usize) -> Option<Self> {
        /// The least sine of the angle between the steps.
        const LEAST_SINE: f64 = 0.4;
        let own = discs[seed];
        let steps = discs.iter().enumerate();
        let steps = steps.filter(|(index, disc)| *index != seed && are_alike(&own, disc));
        let mut steps: Vec<Vector<f64>> = steps.map(|(_, disc)| disc.centre - own.centre).collect();
        steps.sort_by(|a, b| a.length().total_cmp(&b.length()));
        let first = *steps.first()?;
        let sine = |step: &Vector<f64>| (first ^ *step).e12 / (first.length() * step.length());
        let second = *steps.iter().find(|step| sine(step).abs() > LEAST_SINE)?;
        let second = second * sine(&second).signum();
        let mut lattice = Self {
            discs,
            steps: [first, second],
            cells: BTreeMap::from([([0, 0], seed)]),
        };
        let mut is_free = vec![true; discs.len()];
        is_free[seed] = false;
        let mut waiting = VecDeque::from([[0, 0]]);
        while let Some(cell) = waiting.pop_front() {
            for direction in DIRECTIONS {
                let next = sum(cell, direction);
                if lattice.cells.contains_key(&next) {
                    continue;
                }
                if let Some(index) = lattice.neighbour(cell, direction, &is_free) {
                    is_free[index] = false;
                    lattice.cells.insert(next, index);
                    waiting.push_back(next);
                    // From the new point others may be reached that were missed before.
                    let around = DIRECTIONS.map(|way| sum(next, way));
                    let around = around
                        .iter()
                        .filter(|near| lattice.cells.contains_key(*near));
                    waiting.extend(around);
                }
            }
        }
        Some(lattice)
    }

    fn place(&self, cell: Cell) -> Option<Vector<f64>> {
        self.cells.get(&cell).map(|&index| self.discs[index].centre)
    }

    /// The disc next to a point in a direction of the lattice.
    fn neighbour(&self, cell: Cell, direction: Cell, is_free: &[bool]) -> Option<usize> {
        let own = &self.discs[*self.cells.get(&cell)?];
        let step = self.step(cell, direction, own.centre);
        let goal = own.centre + step;
        let distance = |index: usize| (self.discs[index].centre - goal).length();
        let near = (0..self.discs.len()).filter(|&index| {
            is_free[index]
                && distance(index) < REACH * step.length()
                && are_alike(own, &self.discs[index])
        });
        near.min_by(|&a, &b| distance(a).total_cmp(&distance(b)))
    }

    /// The step from a point to its neighbour that the points around suggest.
    fn step(&self, cell: Cell, direction: Cell, own: Vector<f64>) -> Vector<f64> {
        let across = [direction[1], direction[0]];
        let back = direction.map(|k| -k);
        let beside = [across, across.map(|k| -k)].into_iter().filter_map(|side| {
            let from = sum(cell, side);
            Some(self.place(sum(from, direction))? - self.place(from)?)
        });
        let behind = self.place(sum(cell, back)).map(|place| own - place);
        let steps: Vec<Vector<f64>> = beside.chain(behind).collect();
        if steps.is_empty() {
            let [first, second] = self.steps;
            return first * f64::from(direction[0]) + second * f64::from(direction[1]);
        }
        let total = steps
            .iter()
            .fold(Vector::default(), |sum, step| sum + *step);
        total * (1.0 / steps.len() as f64)
    }

    /// All orders of the discs in which the lattice has given cells, no more and no fewer, after a
    /// change of its steps that keeps their orientation: seen obliquely, the shortest steps need
    /// not be those of the board.
    pub(super) fn orders(&self, cells: &[Cell]) -> Vec<Vec<usize>> {
        if cells.len() != self.cells.len() {
            return Vec::new();
        }
        let least = |cells: &mut dyn Iterator<Item = Cell>| {
            cells.fold([i32::MAX; 2], |least, cell| {
                [0, 1].map(|k| least[k].min(cell[k]))
            })
        };
        let corner = least(&mut self.cells.keys().copied());
        let changes = changes_of_steps().filter_map(|[a, b]| {
            let moved = |cell: &Cell| [0, 1].map(|k| a[k] * cell[0] + b[k] * cell[1]);
            let own = least(&mut cells.iter().map(moved));
            let disc = |cell: &Cell| {
                let cell = moved(cell);
                self.cells
                    .get(&[0, 1].map(|k| cell[k] - own[k] + corner[k]))
            };
            cells.iter().map(|cell| disc(cell).copied()).collect()
        });
        changes.collect()
    }
}

/// Small pairs of steps by which all points of a lattice are reached, the second clockwise from the
/// first.
fn changes_of_steps() -> impl Iterator<Item = [Cell; 2]> {
    const RANGE: std::ops::RangeInclusive<i32> = -2..=2;
    let steps = || RANGE.flat_map(|x| RANGE.map(move |y| [x, y]));
    let pairs = steps().flat_map(move |a| steps().map(move |b| [a, b]));
    pairs.filter(|[a, b]| a[0] * b[1] - a[1] * b[0] == 1)
}

fn are_alike(a: &Disc, b: &Disc) -> bool {
    a.area < GREATEST_RATIO * b.area && b.area < GREATEST_RATIO * a.area
}

fn sum(a: Cell, b: Cell) -> Cell {
    [a[0] + b[0], a[1] + b[1]]
}
