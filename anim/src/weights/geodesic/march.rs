//! The spreading of distances from all bones together.

use std::cmp::{Ordering, Reverse};
use std::collections::BinaryHeap;

use ga_mesh::query::Bvh;
use ga_runtime::vga3::Vector;

use super::network::{Network, sees};
use crate::weights::distance::{Bone, distance_to_bone, nearest_on_bone};

/// How many cells around a bone may see it, along each axis.
const REACH: usize = 2;

/// The nearest bones of each vertex with their distances, nearest first.
pub(super) struct Found {
    first: usize,
    count: usize,
    lists: Vec<(u32, f64)>,
    lengths: Vec<u32>,
}

impl Found {
    pub(super) fn of_vertex(&self, vertex: usize) -> &[(u32, f64)] {
        self.of(self.first + vertex)
    }

    fn of(&self, node: usize) -> &[(u32, f64)] {
        let start = node * self.count;
        &self.lists[start..start + self.lengths[node] as usize]
    }

    fn distance(&self, node: usize, bone: u32) -> Option<f64> {
        let list = self.of(node);
        list.iter()
            .find(|(other, _)| *other == bone)
            .map(|(_, distance)| *distance)
    }

    /// Adds a bone to the list of a node, if there is room and it is not there.
    fn push(&mut self, node: usize, bone: u32, distance: f64) -> bool {
        let length = self.lengths[node] as usize;
        if length == self.count || self.distance(node, bone).is_some() {
            return false;
        }
        self.lists[node * self.count + length] = (bone, distance);
        self.lengths[node] += 1;
        true
    }
}

/// A distance of a bone that a node may have. The order is total, so that the result does not
/// depend on the order in which they are found.
#[derive(Clone, Copy, PartialEq)]
struct Candidate {
    distance: f64,
    node: u32,
    bone: u32,
}

impl Eq for Candidate {}

impl Ord for Candidate {
    fn cmp(&self, other: &Self) -> Ordering {
        self.distance
            .total_cmp(&other.distance)
            .then(self.bone.cmp(&other.bone))
            .then(self.node.cmp(&other.node))
    }
}

impl PartialOrd for Candidate {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// The `count` nearest bones of each cell and vertex.
pub(super) fn march(
    network: &Network,
    places: &[Vector<f64>],
    bones: &[Bone],
    count: usize,
    bvh: &Bvh,
) -> Found {
    let first = network.cell_count();
    let mut found = Found {
        first,
        count,
        lists: vec![(0, 0.0); network.len() * count],
        lengths: vec![0; network.len()],
    };
    let mut heap = seeds(network, places, bones, bvh);
    while let Some(Reverse(Candidate {
        distance,
        node,
        bone,
    })) = heap.pop()
    {
        let node = node as usize;
        if !found.push(node, bone, distance) {
            continue;
        }
        let mut offer = |node: usize, distance: f64| {
            if found.lengths[node] < count as u32 && found.distance(node, bone).is_none() {
                heap.push(Reverse(Candidate {
                    distance,
                    node: node as u32,
                    bone,
                }));
            }
        };
        let Some(vertex) = node.checked_sub(first) else {
            for axis in 0..3 {
                for other in network.volume.neighbours(node, axis).into_iter().flatten() {
                    offer(other, eikonal(network, &found, other, bone));
                }
            }
            let centre = network.volume.centre(node);
            for &vertex in network.vertices_of(node) {
                let place = places[vertex as usize];
                offer(first + vertex as usize, distance + centre.distance(place));
            }
            continue;
        };
        for &other in network.along_edges(vertex) {
            let length = places[vertex].distance(places[other as usize]);
            offer(first + other as usize, distance + length);
        }
        for &cell in network.cells_of(vertex) {
            let length = places[vertex].distance(network.volume.centre(cell as usize));
            offer(cell as usize, distance + length);
        }
    }
    found
}

/// The cells and vertices near to each bone that see it, with their distances in space.
fn seeds(
    network: &Network,
    places: &[Vector<f64>],
    bones: &[Bone],
    bvh: &Bvh,
) -> BinaryHeap<Reverse<Candidate>> {
    let (volume, first) = (&network.volume, network.cell_count());
    let near = REACH as f64 * volume.side;
    let mut heap = BinaryHeap::new();
    for (bone, ends) in (0..).zip(bones) {
        let before = heap.len();
        let mut offer = |node: usize, place: Vector<f64>| {
            let on_bone = nearest_on_bone(place, *ends);
            if sees(bvh, on_bone, place) {
                let distance = place.distance(on_bone);
                heap.push(Reverse(Candidate {
                    distance,
                    node: node as u32,
                    bone,
                }));
            }
        };
        for cell in cells_along(network, *ends) {
            offer(cell, volume.centre(cell));
        }
        if network.has_interior() {
            for (vertex, place) in places.iter().enumerate() {
                if distance_to_bone(place.coordinates(), *ends) < near {
                    offer(first + vertex, *place);
                }
            }
        }
        if heap.len() > before {
            continue;
        }
        // A bone outside of the body begins at the vertex that is nearest to it.
        let distances = places
            .iter()
            .map(|place| distance_to_bone(place.coordinates(), *ends));
        let nearest = distances.enumerate().min_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((vertex, distance)) = nearest {
            let node = (first + vertex) as u32;
            heap.push(Reverse(Candidate {
                distance,
                node,
                bone,
            }));
        }
    }
    heap
}

/// The cells near to a bone, each once.
fn cells_along(network: &Network, ends: Bone) -> Vec<usize> {
    let volume = &network.volume;
    if volume.inside.is_empty() {
        return Vec::new();
    }
    let [head, tail] = ends.map(Vector::from);
    // No more than cross the whole grid: a bone may be far longer than the mesh.
    let steps = ((head.distance(tail) / volume.side).ceil() as usize).clamp(1, 4096);
    let mut cells = Vec::new();
    for step in 0..=steps {
        cells.extend(volume.around(head.lerp(tail, step as f64 / steps as f64), REACH));
    }
    cells.sort_unstable();
    cells.dedup();
    cells
}

/// The distance of a bone at a cell from those at its neighbours.
fn eikonal(network: &Network, found: &Found, cell: usize, bone: u32) -> f64 {
    let near = [0, 1, 2].map(|axis| {
        let neighbours = network.volume.neighbours(cell, axis).into_iter().flatten();
        neighbours
            .filter_map(|other| found.distance(other, bone))
            .fold(f64::INFINITY, f64::min)
    });
    one_sided(near, network.volume.side)
}

/// The solution L of |∇L| = 1 with one-sided differences from the lesser neighbour along each axis,
/// `Σ max(L − near, 0)² = side²`.
fn one_sided(mut near: [f64; 3], side: f64) -> f64 {
    near.sort_by(f64::total_cmp);
    let [a, b, c] = near;
    let mut distance = a + side;
    if distance > b {
        let difference = a - b;
        distance = 0.5
            * (a + b
                + (2.0 * side * side - difference * difference)
                    .max(0.0)
                    .sqrt());
        if distance > c {
            let (sum, squares) = (a + b + c, a * a + b * b + c * c);
            let root = (sum * sum - 3.0 * (squares - side * side)).max(0.0).sqrt();
            distance = (sum + root) / 3.0;
        }
    }
    distance
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn the_slope_of_a_distance_is_one(
            near in prop::array::uniform3(0.0..3.0),
            side in 0.1..2.0,
            missing in 0usize..3,
        ) {
            for known in [near, { let mut some = near; some[missing] = f64::INFINITY; some }] {
                let distance = one_sided(known, side);
                let squares = known.map(|near| (distance - near).max(0.0).powi(2));
                let slope = squares.iter().sum::<f64>() / (side * side);
                prop_assert!((slope - 1.0).abs() < 1e-9, "{slope}");
            }
        }
    }
}
