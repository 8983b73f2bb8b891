//! The inside of a mesh as cubic cells.

use ga_mesh::query::Bvh;
use ga_runtime::cga3::Point;
use ga_runtime::geometry::ray::{Ray, Side};
use ga_runtime::vga3::Vector;

/// A grid of cells about a mesh.
#[derive(Clone, Debug)]
pub(super) struct Volume {
    /// The centre of the first cell.
    origin: Vector<f64>,
    /// The side of a cell.
    pub(super) side: f64,
    size: [usize; 3],
    /// The cells inside, in rising order.
    pub(super) inside: Vec<u32>,
    /// For each cell, its place in `inside`, or [`OUTSIDE`].
    number: Vec<u32>,
    /// For each cell, whether the surface passes between its centre and the next along each axis.
    blocked: [Vec<bool>; 3],
}

const OUTSIDE: u32 = u32::MAX;

impl Volume {
    /// The cells of a mesh with this many along its longest side; `None` for a mesh without extent.
    pub(super) fn new(bvh: &Bvh, resolution: usize) -> Option<Self> {
        let [low, high] = bvh.bounds()?.map(Vector::from);
        let extent = (high - low).coordinates();
        let side = extent.into_iter().fold(0.0, f64::max) / resolution as f64;
        if side <= 0.0 || !side.is_finite() {
            return None;
        }
        let size = extent.map(|length| (length / side).ceil() as usize + 3);
        // Off the middle, so that no line of centres runs along faces of boxes.
        let first = Vector::new(0.513, 0.471, 0.537) * side;
        let cells = size.iter().product();
        let mut volume = Self {
            origin: low - first,
            side,
            size,
            inside: Vec::new(),
            number: vec![OUTSIDE; cells],
            blocked: [(); 3].map(|()| vec![false; cells]),
        };
        let mut votes = vec![0u8; cells];
        for axis in 0..3 {
            volume.scan(bvh, axis, &mut votes);
        }
        // Two of three, so that a ray through an edge or a small hole decides nothing.
        for (cell, votes) in votes.into_iter().enumerate() {
            if votes >= 2 {
                volume.number[cell] = volume.inside.len() as u32;
                volume.inside.push(cell as u32);
            }
        }
        Some(volume)
    }

    /// Follows all lines of centres along an axis through the mesh.
    fn scan(&mut self, bvh: &Bvh, axis: usize, votes: &mut [u8]) {
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        let mut direction = [0.0; 3];
        direction[axis] = 1.0;
        let stride = self.stride(axis);
        for j in 0..self.size[v] {
            for i in 0..self.size[u] {
                let mut place = [0; 3];
                (place[u], place[v]) = (i, j);
                let start = self.centre_of(place);
                let Some(ray) = Ray::new(Point::from(start), direction) else {
                    continue;
                };
                let first = self.cell(place);
                let (mut winding, mut last) = (0i32, (-1.0, None));
                let mut hits = bvh.all_hits(ray).into_iter().peekable();
                for step in 0..self.size[axis] {
                    let cell = first + step * stride;
                    votes[cell] += u8::from(winding != 0);
                    let next = (step + 1) as f64 * self.side;
                    while let Some(found) = hits.next_if(|found| found.hit.distance < next) {
                        let (distance, side) = (found.hit.distance, found.hit.side);
                        self.blocked[axis][cell] = true;
                        // The two triangles of an edge are crossed once.
                        let is_same = distance - last.0 < 1e-9 * self.side && last.1 == Some(side);
                        if !is_same {
                            winding += if side == Side::Front { 1 } else { -1 };
                        }
                        last = (distance, Some(side));
                    }
                }
            }
        }
    }

    fn stride(&self, axis: usize) -> usize {
        self.size[..axis].iter().product()
    }

    fn cell(&self, [i, j, k]: [usize; 3]) -> usize {
        i + self.size[0] * (j + self.size[1] * k)
    }

    fn centre_of(&self, place: [usize; 3]) -> Vector<f64> {
        let [x, y, z] = place.map(|index| index as f64 * self.side);
        self.origin + Vector::new(x, y, z)
    }

    /// The centre of a cell inside, by its number.
    pub(super) fn centre(&self, number: usize) -> Vector<f64> {
        let cell = self.inside[number] as usize;
        let rest = cell / self.size[0];
        self.centre_of([
            cell % self.size[0],
            rest % self.size[1],
            rest / self.size[1],
        ])
    }

    /// The neighbours before and after a cell inside along an axis that the surface does not
    /// separate from it.
    pub(super) fn neighbours(&self, number: usize, axis: usize) -> [Option<usize>; 2] {
        let (cell, stride) = (self.inside[number] as usize, self.stride(axis));
        let inside = |cell: usize| match self.number.get(cell) {
            Some(&number) if number != OUTSIDE => Some(number as usize),
            _ => None,
        };
        // Cells at the border of the grid are outside, so that no neighbour is in another row.
        [
            cell.checked_sub(stride)
                .filter(|&before| !self.blocked[axis][before])
                .and_then(inside),
            (!self.blocked[axis][cell])
                .then_some(cell + stride)
                .and_then(inside),
        ]
    }

    /// The cells inside whose centres are within a number of cells of a place along each axis.
    pub(super) fn around(&self, place: Vector<f64>, reach: usize) -> Vec<usize> {
        let offset = (place - self.origin)
            .coordinates()
            .map(|x| (x / self.side).floor());
        let range = |axis: usize| {
            let low = (offset[axis] - reach as f64 + 1.0).max(0.0) as usize;
            let high = (offset[axis] + reach as f64 + 1.0).max(0.0) as usize;
            low..high.min(self.size[axis])
        };
        let mut found = Vec::new();
        for k in range(2) {
            for j in range(1) {
                for i in range(0) {
                    let number = self.number[self.cell([i, j, k])];
                    if number != OUTSIDE {
                        found.push(number as usize);
                    }
                }
            }
        }
        found
    }
}
