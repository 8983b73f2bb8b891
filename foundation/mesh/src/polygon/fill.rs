//! Triangles where the library leaves corners out.

use rustc_hash::FxHashMap;

use super::plane::Plane;

/// All triangles of a polygon, of which some are given, in rising order.
///
/// The crate `earcut` leaves out corners that lie on a straight line or at the place of their
/// neighbour, which others may share. Between its triangles, and between them and the sides of the
/// polygon, gaps without area remain. The triangles that close a gap of k corners are k − 2; where
/// the longest side of the gap belongs to a triangle, that one is split instead, so that none of
/// the new ones is without area either.
pub(super) fn fill(plane: &Plane, given: &[[u32; 3]]) -> Vec<[u32; 3]> {
    let count = plane.len() as u32;
    let mut triangles = Triangles::default();
    // For each corner the corners after it to which a triangle on the far side has an edge.
    let mut ends = vec![Vec::new(); plane.len()];
    for &triangle in given {
        let mut triangle = triangle;
        triangle.sort_unstable();
        triangles.add(triangle);
        ends[triangle[0] as usize].push(triangle[2]);
    }
    // The polygon is cut by each edge of a triangle; what lies between the corners a and b is done
    // when the rest is.
    let mut open = vec![[0, count - 1]];
    while let Some([a, b]) = open.pop() {
        if b - a < 2 {
            continue;
        }
        if let Some(middle) = triangles.third(b, a) {
            open.extend([[a, middle], [middle, b]]);
            continue;
        }
        let mut gap = vec![a];
        let mut corner = a;
        while corner != b {
            let inside = |end: &&u32| **end <= b && [corner, **end] != [a, b];
            let ends = ends[corner as usize].iter().filter(inside);
            corner = ends.copied().max().unwrap_or(corner + 1);
            gap.push(corner);
        }
        open.extend(triangles.close(plane, &gap));
    }
    triangles.listed()
}

/// Triangles by their edges.
#[derive(Default)]
struct Triangles {
    /// The third corner of the triangle at an edge, by the ends of the edge in the order in which
    /// the triangle runs along it.
    thirds: FxHashMap<[u32; 2], u32>,
}

impl Triangles {
    fn third(&self, from: u32, to: u32) -> Option<u32> {
        self.thirds.get(&[from, to]).copied()
    }

    fn add(&mut self, [a, b, c]: [u32; 3]) {
        self.thirds.extend([([a, b], c), ([b, c], a), ([c, a], b)]);
    }

    fn remove(&mut self, [a, b, c]: [u32; 3]) {
        for edge in [[a, b], [b, c], [c, a]] {
            self.thirds.remove(&edge);
        }
    }

    /// Closes a gap between these corners, and returns the edges behind which there may be others.
    fn close(&mut self, plane: &Plane, gap: &[u32]) -> Vec<[u32; 2]> {
        // The gap runs along each side against the triangle behind it.
        let last = gap.len() - 1;
        let sides = (0..=last).map(|i| [gap[i], gap[(i + 1) % gap.len()]]);
        let behind = |[a, b]: [u32; 2]| self.third(b, a).map(|third| ([a, b], third));
        let length = |&[a, b]: &[u32; 2]| plane.square_distance(a, b);
        let longest = sides.clone().max_by(|x, y| length(x).total_cmp(&length(y)));
        let split = longest.and_then(behind);
        let mut edges: Vec<[u32; 2]> = sides.clone().take(last).collect();
        match split {
            Some((side, third)) => {
                self.remove([side[1], side[0], third]);
                for [a, b] in sides.filter(|other| *other != side) {
                    self.add([a, b, third]);
                }
                if side[0] < side[1] {
                    edges.retain(|edge| *edge != side);
                    edges.extend([[side[0], third], [third, side[1]]]);
                }
            }
            None => (1..last).for_each(|i| self.add([gap[0], gap[i], gap[i + 1]])),
        }
        edges
    }

    fn listed(&self) -> Vec<[u32; 3]> {
        let all = self.thirds.iter().map(|(&[a, b], &c)| [a, b, c]);
        let mut all: Vec<_> = all.filter(|[a, b, c]| a < b && b < c).collect();
        all.sort_unstable();
        all
    }
}
