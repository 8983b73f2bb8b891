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

/// Cubes along the edge of a block, the unit in which empty space is passed over.
const BLOCK: usize = 8;

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
    let half_diagonal = 0.5 * grid.spacing * BLOCK as f64 * 3.0_f64.sqrt();
    let corners = BLOCK + 1;
    let mut values = vec![0.0; corners * corners * corners];
    let blocks = grid.cubes.map(|n| n.div_ceil(BLOCK));
    for bz in 0..blocks[2] {
        for by in 0..blocks[1] {
            for bx in 0..blocks[0] {
                let base = [bx * BLOCK, by * BLOCK, bz * BLOCK];
                let centre = grid.point(base.map(|c| c as f64 + 0.5 * BLOCK as f64));
                let limit = half_diagonal * stretch;
                if distance(centre, limit).abs() > limit {
                    continue;
                }
                for (i, value) in values.iter_mut().enumerate() {
                    let offset = [i % corners, i / corners % corners, i / (corners * corners)];
                    let at = std::array::from_fn(|k| (base[k] + offset[k]) as f64);
                    *value = distance(grid.point(at), grid.spacing * 2.0);
                }
                marcher.block(base, &values);
            }
        }
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
    fn block(&mut self, base: [usize; 3], values: &[f64]) {
        let corners = BLOCK + 1;
        let stop: [usize; 3] = std::array::from_fn(|k| BLOCK.min(self.grid.cubes[k] - base[k]));
        for z in 0..stop[2] {
            for y in 0..stop[1] {
                for x in 0..stop[0] {
                    let cube: [Corner; 8] = std::array::from_fn(|bits| {
                        let offset = [x + (bits & 1), y + (bits >> 1 & 1), z + (bits >> 2)];
                        Corner {
                            at: std::array::from_fn(|k| base[k] + offset[k]),
                            value: values[offset[0] + corners * (offset[1] + corners * offset[2])],
                        }
                    });
                    let inside = cube.iter().filter(|corner| corner.value < 0.0).count();
                    if inside == 0 || inside == 8 {
                        continue;
                    }
                    for (path, even) in KUHN {
                        let tetrahedron = path.map(|bits| cube[bits]);
                        self.tetrahedron(&tetrahedron, even);
                    }
                }
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
