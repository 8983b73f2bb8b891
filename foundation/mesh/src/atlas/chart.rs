//! One chart as a mesh of its own, and its flat image.

use rustc_hash::FxHashMap;

use super::Vector;
use super::surface::{NONE, Surface};

/// A vector of the plane.
pub(super) type Flat = [f64; 2];

#[derive(Clone)]
/// Some faces of a surface, with vertices of their own. Vertices are split where the faces around
/// them are not connected within the chart, so that the chart is a manifold with boundary.
pub(super) struct Chart {
    /// The faces, by their numbers in the surface.
    pub(super) faces: Vec<u32>,
    pub(super) triangles: Vec<[u32; 3]>,
    pub(super) positions: Vec<Vector>,
    /// For each side (three a face), the side of the chart across it, or [`NONE`] at its boundary.
    pub(super) across: Vec<u32>,
}

/// How the flat image of a chart differs from the chart.
#[derive(Clone, Copy, Debug)]
pub(super) struct Distortion {
    /// The area on the surface.
    pub(super) area: f64,
    /// The area of the image.
    pub(super) flat_area: f64,
    /// The sum of the squared L2 stretch of each triangle times its area.
    pub(super) stretched: f64,
    /// The least area of a triangle of the image divided by its area on the surface.
    pub(super) least: f64,
}

impl Distortion {
    /// The L2 stretch at the best scale.
    pub(super) fn stretch(&self) -> f64 {
        (self.stretched * self.flat_area).max(0.0).sqrt() / self.area
    }

    /// The factor for lengths with which the atlas of many charts has the least stretch.
    pub(super) fn scale(&self) -> f64 {
        (self.stretched / self.flat_area).sqrt().sqrt()
    }
}

impl Chart {
    pub(super) fn new(surface: &Surface, faces: Vec<u32>) -> Self {
        let place: FxHashMap<u32, u32> = (0..).zip(&faces).map(|(at, &face)| (face, at)).collect();
        let mut across = vec![NONE; 3 * faces.len()];
        for (local, &face) in faces.iter().enumerate() {
            for corner in 0..3 {
                let other = surface.across[3 * face as usize + corner];
                if other != NONE
                    && let Some(&beside) = place.get(&(other / 3))
                {
                    across[3 * local + corner] = 3 * beside + other % 3;
                }
            }
        }

        // Corners that meet at a side within the chart are one vertex.
        let mut parent: Vec<u32> = (0..across.len() as u32).collect();
        for (side, &other) in across.iter().enumerate() {
            if other != NONE && (side as u32) < other {
                join(&mut parent, side as u32, next(other));
                join(&mut parent, next(side as u32), other);
            }
        }
        let mut number = vec![NONE; parent.len()];
        let mut positions = Vec::new();
        let mut triangles = vec![[0; 3]; faces.len()];
        for corner in 0..parent.len() as u32 {
            let root = root(&mut parent, corner) as usize;
            let (face, at) = (corner as usize / 3, corner as usize % 3);
            if number[root] == NONE {
                number[root] = positions.len() as u32;
                let vertex = surface.triangles[faces[face] as usize][at];
                positions.push(surface.positions[vertex as usize]);
            }
            triangles[face][at] = number[root];
        }
        Self {
            faces,
            triangles,
            positions,
            across,
        }
    }

    /// The corners of a face, in space.
    pub(super) fn corners(&self, face: usize) -> [Vector; 3] {
        self.triangles[face].map(|vertex| self.positions[vertex as usize])
    }

    /// The ends of a side.
    pub(super) fn side(&self, side: u32) -> [u32; 2] {
        let triangle = self.triangles[side as usize / 3];
        let corner = side as usize % 3;
        [triangle[corner], triangle[(corner + 1) % 3]]
    }

    /// The sides at the boundary, in rising order.
    pub(super) fn boundary(&self) -> impl Iterator<Item = u32> + '_ {
        let sides = (0..).zip(&self.across);
        sides.filter_map(|(side, &other)| (other == NONE).then_some(side))
    }

    /// The closed boundary curves, each a list of sides, the longest curve first.
    pub(super) fn loops(&self) -> Vec<Vec<u32>> {
        let mut leaving = vec![NONE; self.positions.len()];
        for side in self.boundary() {
            leaving[self.side(side)[0] as usize] = side;
        }
        let mut loops = Vec::new();
        for first in self.boundary() {
            let mut sides = Vec::new();
            let mut vertex = self.side(first)[0];
            loop {
                let side = std::mem::replace(&mut leaving[vertex as usize], NONE);
                if side == NONE {
                    break;
                }
                sides.push(side);
                vertex = self.side(side)[1];
            }
            if !sides.is_empty() {
                loops.push(sides);
            }
        }
        let length =
            |sides: &Vec<u32>| -> f64 { sides.iter().map(|&side| self.length(side)).sum() };
        loops.sort_by(|a, b| length(b).total_cmp(&length(a)));
        loops
    }

    /// The length of a side in space.
    pub(super) fn length(&self, side: u32) -> f64 {
        let [a, b] = self.side(side);
        self.positions[a as usize].distance(self.positions[b as usize])
    }

    /// How far an image, a place in the plane for each vertex, is from being isometric.
    pub(super) fn distortion(&self, image: &[Flat]) -> Distortion {
        let mut sum = Distortion {
            area: 0.0,
            flat_area: 0.0,
            stretched: 0.0,
            least: f64::INFINITY,
        };
        for (face, triangle) in self.triangles.iter().enumerate() {
            let corners = self.corners(face);
            let flat = triangle.map(|vertex| image[vertex as usize]);
            let (area, flat_area, squared) = stretch(corners, flat);
            sum.area += area;
            sum.flat_area += flat_area;
            sum.stretched += area * squared;
            sum.least = sum.least.min(flat_area / area);
        }
        sum
    }
}

/// The area of a triangle, the signed area of its image, and the square of the L2 stretch of the
/// map from the image to the triangle: half the sum of the squares of its singular values.
pub(super) fn stretch([p, q, r]: [Vector; 3], flat: [Flat; 3]) -> (f64, f64, f64) {
    let (e, f) = (q - p, r - p);
    let area = 0.5 * e.cross(f).length();
    let (a, b) = (minus(flat[1], flat[0]), minus(flat[2], flat[0]));
    let double = cross(a, b);
    // The columns of the map are (e b₂ − f a₂)/double and (f a₁ − e b₁)/double.
    let columns = [e * b[1] - f * a[1], f * a[0] - e * b[0]];
    let squares: f64 = columns.into_iter().map(Vector::length_squared).sum();
    (area, 0.5 * double, 0.5 * squares / (double * double))
}

pub(super) fn minus(a: Flat, b: Flat) -> Flat {
    [a[0] - b[0], a[1] - b[1]]
}

pub(super) fn cross(a: Flat, b: Flat) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// The next side of the same face; the next corner.
pub(super) fn next(side: u32) -> u32 {
    if side % 3 == 2 { side - 2 } else { side + 1 }
}

fn root(parent: &mut [u32], mut corner: u32) -> u32 {
    while parent[corner as usize] != corner {
        let above = parent[parent[corner as usize] as usize];
        parent[corner as usize] = above;
        corner = above;
    }
    corner
}

fn join(parent: &mut [u32], a: u32, b: u32) {
    let (a, b) = (root(parent, a), root(parent, b));
    // The lower number stays the root, which keeps the numbers of vertices in order of the faces.
    parent[a.max(b) as usize] = a.min(b);
}
