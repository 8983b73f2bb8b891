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
    /// Whether each cell is inside.
    is_inside: Bits,
    /// For each word of `is_inside`, how many cells before it are inside.
    before: Vec<u32>,
    /// For each cell, whether the surface passes between its centre and the next along each axis.
    blocked: [Bits; 3],
}

/// A bit for each cell: there are up to 17 million, for a mesh of any number of triangles.
#[derive(Clone, Debug)]
struct Bits(Vec<u64>);

impl Bits {
    fn new(cells: usize) -> Self {
        Self(vec![0; cells.div_ceil(64)])
    }

    fn insert(&mut self, cell: usize) {
        self.0[cell / 64] |= 1 << (cell % 64);
    }

    /// Whether a cell has its bit; those beyond the last have none.
    fn contains(&self, cell: usize) -> bool {
        let word = self.0.get(cell / 64);
        word.is_some_and(|word| word >> (cell % 64) & 1 == 1)
    }
}

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
            is_inside: Bits::new(cells),
            before: Vec::with_capacity(cells.div_ceil(64)),
            blocked: [(); 3].map(|()| Bits::new(cells)),
        };
        let mut once = Bits::new(cells);
        for axis in 0..3 {
            volume.scan(bvh, axis, &mut once);
        }
        for word in 0..volume.is_inside.0.len() {
            volume.before.push(volume.inside.len() as u32);
            for cell in 64 * word..64 * (word + 1) {
                if volume.is_inside.contains(cell) {
                    volume.inside.push(cell as u32);
                }
            }
        }
        Some(volume)
    }

    /// The place of a cell in `inside`.
    fn number(&self, cell: usize) -> Option<usize> {
        let in_word = self.is_inside.0.get(cell / 64)? << (63 - cell % 64);
        // The bit of the cell itself is the highest now.
        (in_word >> 63 == 1)
            .then(|| self.before[cell / 64] as usize + in_word.count_ones() as usize - 1)
    }

    /// Follows all lines of centres along an axis through the mesh. A cell is inside by two votes
    /// of three axes, so that a ray through an edge or a small hole decides nothing; `once` has
    /// those with a vote.
    fn scan(&mut self, bvh: &Bvh, axis: usize, once: &mut Bits) {
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
                    if winding != 0 {
                        if once.contains(cell) {
                            self.is_inside.insert(cell);
                        }
                        once.insert(cell);
                    }
                    let next = (step + 1) as f64 * self.side;
                    while let Some(found) = hits.next_if(|found| found.hit.distance < next) {
                        let (distance, side) = (found.hit.distance, found.hit.side());
                        self.blocked[axis].insert(cell);
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
        // Cells at the border of the grid are outside, so that no neighbour is in another row.
        [
            cell.checked_sub(stride)
                .filter(|&before| !self.blocked[axis].contains(before))
                .and_then(|before| self.number(before)),
            (!self.blocked[axis].contains(cell))
                .then_some(cell + stride)
                .and_then(|after| self.number(after)),
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
                    found.extend(self.number(self.cell([i, j, k])));
                }
            }
        }
        found
    }
}
