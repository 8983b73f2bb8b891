//! Marching tetrahedra: the surface of a solid on a grid, always a manifold.
//!
//! Every cube of the grid is cut into six tetrahedra along its main diagonal (Kuhn's
//! triangulation), the same way everywhere, so that neighbours meet in whole faces. Within a
//! tetrahedron the surface is one triangle or one quadrilateral; there are no ambiguous cases and
//! the pieces always fit together (Doi and Koide, An efficient method of triangulating equi-valued
//! surfaces by using tetrahedral cells, IEICE Transactions 1991).

use std::collections::HashMap;

use crate::Vector;

/// Triangles, counter-clockwise seen from outside.
#[derive(Clone, Debug, Default)]
pub(crate) struct Surface {
    pub(crate) positions: Vec<Vector>,
    pub(crate) triangles: Vec<[u32; 3]>,
}

/// A box of equal cubes: its least corner, the edge of a cube and the number of cubes each way.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Grid {
    pub(crate) origin: Vector,
    pub(crate) spacing: f64,
    pub(crate) cubes: [usize; 3],
}

/// Cubes along the edges of the blocks of space that are passed over where they are empty: large
/// ones, and the small ones in each of them.
const BLOCK: usize = 8;
const SMALL_BLOCK: usize = 4;
/// Corners of cubes along the edge of a large block.
const CORNERS: usize = BLOCK + 1;

/// The surface on which `distance` vanishes, cut off at the sides of the grid.
///
/// `distance(point, limit)` is the signed distance, up to a factor of at most `stretch`; a value
/// above `limit` may be replaced by any lower bound that is itself above `limit`.
pub(crate) fn march(grid: Grid, stretch: f64, distance: impl Fn(Vector, f64) -> f64) -> Surface {
    let mut marcher = Marcher {
        grid,
        surface: Surface::default(),
        vertices: HashMap::new(),
    };
    let is_empty = |base: [usize; 3], size: usize| {
        let centre = grid.point(base.map(|c| c as f64 + 0.5 * size as f64));
        let limit = 0.5 * grid.spacing * size as f64 * 3.0_f64.sqrt() * stretch;
        distance(centre, limit).abs() > limit
    };
    // The distances at the corners of a large block, unknown in empty small ones.
    let mut values = Vec::new();
    for base in cells(grid.cubes.map(|n| n.div_ceil(BLOCK))) {
        let base = base.map(|c| c * BLOCK);
        if is_empty(base, BLOCK) {
            continue;
        }
        values.clear();
        values.resize(CORNERS.pow(3), None);
        for small in cells([BLOCK / SMALL_BLOCK; 3]) {
            let small = small.map(|c| c * SMALL_BLOCK);
            if is_empty(sum(base, small), SMALL_BLOCK) {
                continue;
            }
            for offset in cells([SMALL_BLOCK + 1; 3]) {
                let corner = sum(small, offset);
                values[index(corner)].get_or_insert_with(|| {
                    let at = sum(base, corner).map(|c| c as f64);
                    distance(grid.point(at), grid.spacing * 2.0)
                });
            }
        }
        marcher.block(base, &values);
    }
    marcher.surface
}

impl Grid {
    /// The place of these coordinates, counted in cubes from the least corner.
    fn point(&self, at: [f64; 3]) -> Vector {
        self.origin + Vector::from(at) * self.spacing
    }
}

struct Marcher {
    grid: Grid,
    surface: Surface,
    /// The vertex on each edge of the grid that the surface crosses, by the numbers of the edge's
    /// ends.
    vertices: HashMap<(u64, u64), u32>,
}

/// A corner of the grid and the distance there.
#[derive(Clone, Copy)]
struct Corner {
    at: [usize; 3],
    value: f64,
}

impl Marcher {
    /// The surface in a large block; a cube with an unknown corner lies in an empty small one.
    fn block(&mut self, base: [usize; 3], values: &[Option<f64>]) {
        let stop = std::array::from_fn(|k| BLOCK.min(self.grid.cubes[k] - base[k]));
        for low in cells(stop) {
            let corner = |bits: usize| sum(low, [bits & 1, bits >> 1 & 1, bits >> 2]);
            let known: [Option<f64>; 8] = std::array::from_fn(|bits| values[index(corner(bits))]);
            let inside = known.iter().flatten().filter(|value| **value < 0.0).count();
            if inside == 0 || inside == 8 || known.contains(&None) {
                continue;
            }
            for (path, even) in KUHN {
                let tetrahedron = path.map(|bits| Corner {
                    at: sum(base, corner(bits)),
                    value: known[bits].unwrap_or_default(),
                });
                self.tetrahedron(&tetrahedron, even);
            }
        }
    }

    /// `positive`: whether the last three corners run counter-clockwise seen from the first.
    fn tetrahedron(&mut self, corners: &[Corner; 4], positive: bool) {
        let (mut inside, mut outside) = (Vec::with_capacity(4), Vec::with_capacity(4));
        for (i, corner) in corners.iter().enumerate() {
            if corner.value < 0.0 {
                inside.push(i);
            } else {
                outside.push(i);
            }
        }
        if inside.is_empty() || outside.is_empty() {
            return;
        }
        let order: Vec<usize> = inside.iter().chain(&outside).copied().collect();
        let flip = positive != even([order[0], order[1], order[2], order[3]]);
        let mut at = |i: usize, o: usize| self.vertex(&corners[i], &corners[o]);
        let polygon: Vec<u32> = match inside[..] {
            [a] => outside.iter().map(|&o| at(a, o)).collect(),
            [a, b] => vec![
                at(a, outside[0]),
                at(a, outside[1]),
                at(b, outside[1]),
                at(b, outside[0]),
            ],
            [a, b, c] => vec![at(a, outside[0]), at(b, outside[0]), at(c, outside[0])],
            _ => return,
        };
        for i in 1..polygon.len() - 1 {
            let [a, b, c] = [polygon[0], polygon[i], polygon[i + 1]];
            self.surface
                .triangles
                .push(if flip { [a, c, b] } else { [a, b, c] });
        }
    }

    fn vertex(&mut self, a: &Corner, b: &Corner) -> u32 {
        let number = |corner: &Corner| {
            let [x, y, z] = corner.at.map(|c| c as u64);
            x | y << 21 | z << 42
        };
        let key = (number(a).min(number(b)), number(a).max(number(b)));
        let Self {
            grid,
            surface,
            vertices,
        } = self;
        *vertices.entry(key).or_insert_with(|| {
            // Kept off the ends of the edge, so that no triangle is without area.
            let t = (a.value / (a.value - b.value)).clamp(0.02, 0.98);
            let point = |corner: &Corner| grid.point(corner.at.map(|c| c as f64));
            surface.positions.push(point(a).lerp(point(b), t));
            (surface.positions.len() - 1) as u32
        })
    }
}

/// The six tetrahedra of a cube: the corners (bit k: upper end in direction k) on the six shortest
/// ways along edges from corner 0 to corner 7, and whether the three steps are an even permutation
/// of the axes.
const KUHN: [([usize; 4], bool); 6] = [
    ([0, 1, 3, 7], true),
    ([0, 2, 6, 7], true),
    ([0, 4, 5, 7], true),
    ([0, 1, 5, 7], false),
    ([0, 2, 3, 7], false),
    ([0, 4, 6, 7], false),
];

fn even(order: [usize; 4]) -> bool {
    let mut inversions = 0;
    for i in 0..4 {
        for j in i + 1..4 {
            inversions += usize::from(order[i] > order[j]);
        }
    }
    inversions % 2 == 0
}

/// The cells of a box of so many each way, the first coordinate changing fastest.
fn cells(counts: [usize; 3]) -> impl Iterator<Item = [usize; 3]> {
    let [x, y, z] = counts;
    (0..x * y * z).map(move |i| [i % x, i / x % y, i / (x * y)])
}

fn sum(a: [usize; 3], b: [usize; 3]) -> [usize; 3] {
    std::array::from_fn(|k| a[k] + b[k])
}

/// Where the distance at a corner of a large block is kept.
fn index([x, y, z]: [usize; 3]) -> usize {
    x + CORNERS * (y + CORNERS * z)
}
