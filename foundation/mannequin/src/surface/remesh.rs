//! Even triangles: splits long edges, collapses short ones, flips edges towards six neighbours a
//! vertex, and moves the vertices along the surface to the middle of their neighbours.
//!
//! The method is that of Botsch and Kobbelt, A remeshing approach to multiresolution modeling,
//! Symposium on Geometry Processing 2004, with an edge length that may vary over the surface. The
//! surface may be cut off by the plane x = 0: its rim stays in the plane, so that the surface and
//! its mirror image close up to a manifold.

use ga_mesh::normals::area_vector;

use super::marching_tetrahedra::Surface;
use super::topology::Topology;
use crate::Vector;
use crate::shape::solid::project;

/// Makes the edges of a surface about `length(position)` long, with its vertices where `distance`
/// vanishes.
pub(crate) fn remesh(
    surface: Surface,
    rounds: usize,
    length: impl Fn(Vector) -> f64,
    distance: impl Fn(Vector) -> f64,
) -> Surface {
    let mut mesh = Remesher::new(surface, length);
    for round in 0..rounds {
        mesh.split_long_edges();
        mesh.collapse_short_edges();
        mesh.flip_edges();
        mesh.relax(&distance);
        if round + 1 == rounds {
            for _ in 0..3 {
                mesh.flip_edges();
                mesh.relax(&distance);
            }
        }
    }
    let mut surface = mesh.finish();
    for position in &mut surface.positions {
        let on_rim = position.e1 == 0.0;
        *position = project(&distance, *position);
        if on_rim {
            position.e1 = 0.0;
        }
    }
    surface
}

struct Remesher<L> {
    positions: Vec<Vector>,
    /// The edge length wanted at each vertex.
    lengths: Vec<f64>,
    topology: Topology,
    /// Whether a vertex lies on the rim.
    rim: Vec<bool>,
    length: L,
}

impl<L: Fn(Vector) -> f64> Remesher<L> {
    fn new(surface: Surface, length: L) -> Self {
        let topology = Topology::new(surface.positions.len(), surface.triangles);
        let rim = topology.rim();
        let lengths = surface.positions.iter().map(|p| length(*p)).collect();
        Remesher {
            positions: surface.positions,
            lengths,
            topology,
            rim,
            length,
        }
    }

    /// Length of an edge as a multiple of what is wanted there.
    fn relative_length(&self, a: u32, b: u32) -> f64 {
        let (a, b) = (a as usize, b as usize);
        self.positions[a].distance(self.positions[b]) * 2.0 / (self.lengths[a] + self.lengths[b])
    }

    fn split_long_edges(&mut self) {
        for [a, b] in self.topology.edges() {
            if self.relative_length(a, b) <= 4.0 / 3.0 {
                continue;
            }
            let position = self.positions[a as usize].lerp(self.positions[b as usize], 0.5);
            let on_rim = self.topology.is_rim(a, b);
            self.topology.split(a, b);
            self.positions.push(position);
            self.lengths.push((self.length)(position));
            self.rim.push(on_rim);
        }
    }

    fn collapse_short_edges(&mut self) {
        // The shortest first, which keeps the remaining edges even.
        let mut short: Vec<(f64, [u32; 2])> = self
            .topology
            .edges()
            .into_iter()
            .map(|edge| (self.relative_length(edge[0], edge[1]), edge))
            .filter(|(length, _)| *length < 0.8)
            .collect();
        short.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        for (_, [a, b]) in short {
            if self.topology.has_edge(a, b) && self.relative_length(a, b) < 0.8 {
                self.try_collapse(a, b);
            }
        }
    }

    /// Collapses the edge into one vertex if the surface stays a manifold and no triangle turns
    /// over.
    fn try_collapse(&mut self, a: u32, b: u32) {
        let (rim_a, rim_b) = (self.rim[a as usize], self.rim[b as usize]);
        let on_rim = self.topology.is_rim(a, b);
        if rim_a && rim_b && !on_rim {
            return;
        }
        let (keep, drop) = if rim_b && !rim_a { (b, a) } else { (a, b) };
        let target = if rim_a == rim_b {
            self.positions[a as usize].lerp(self.positions[b as usize], 0.5)
        } else {
            self.positions[keep as usize]
        };
        let around_keep = self.topology.neighbours(keep);
        let around_drop = self.topology.neighbours(drop);
        let shared = around_keep
            .iter()
            .filter(|n| around_drop.contains(n))
            .count();
        if shared != if on_rim { 1 } else { 2 } {
            return;
        }
        // An inner edge between two vertices of the rim would meet its own mirror image.
        let bridge = |n: &&u32| self.rim[**n as usize] && **n != keep && !around_keep.contains(n);
        if self.rim[keep as usize]
            && !self.rim[drop as usize]
            && around_drop.iter().any(|n| bridge(&n))
        {
            return;
        }
        let wanted = self.lengths[keep as usize].max(self.lengths[drop as usize]);
        let too_long = |n: &u32| self.positions[*n as usize].distance(target) > wanted * 4.0 / 3.0;
        if around_keep.iter().chain(&around_drop).any(too_long) {
            return;
        }
        for (vertex, other) in [(keep, drop), (drop, keep)] {
            let triangles = self.topology.triangles_around(vertex);
            if self.turns_over(vertex, target, triangles.filter(|t| !t.contains(&other))) {
                return;
            }
        }
        self.topology.collapse(keep, drop);
        self.positions[keep as usize] = target;
        self.lengths[keep as usize] = (self.length)(target);
    }

    fn flip_edges(&mut self) {
        for [a, b] in self.topology.edges() {
            let Some([c, d]) = self.topology.opposite(a, b) else {
                continue;
            };
            if self.topology.has_edge(c, d) || (self.rim[c as usize] && self.rim[d as usize]) {
                continue;
            }
            // Six triangles meet inside, and on the rim half as many.
            let excess = |v: u32, change: i32| {
                let wanted = if self.rim[v as usize] { 3 } else { 6 };
                let off = self.topology.triangle_count(v) as i32 + change - wanted;
                off * off
            };
            let before = excess(a, 0) + excess(b, 0) + excess(c, 0) + excess(d, 0);
            let after = excess(a, -1) + excess(b, -1) + excess(c, 1) + excess(d, 1);
            if after >= before {
                continue;
            }
            let [pa, pb, pc, pd] = [a, b, c, d].map(|v| self.positions[v as usize]);
            let old = normal([pa, pb, pc]) + normal([pb, pa, pd]);
            let new = [normal([pc, pa, pd]), normal([pd, pb, pc])];
            let old = old.normalized().unwrap_or_default();
            if new.iter().all(|n| n.dot(old) > 0.7) {
                self.topology.flip(a, b, c, d);
            }
        }
    }

    /// Moves every vertex towards the mean of the triangles around it, within the surface.
    fn relax(&mut self, distance: &impl Fn(Vector) -> f64) {
        for v in 0..self.positions.len() {
            let triangles = self.topology.triangles_around(v as u32);
            let here = self.positions[v];
            let (mut up, mut centre, mut total) = (Vector::ZERO, Vector::ZERO, 0.0);
            for t in triangles.clone() {
                let [a, b, c] = t.map(|i| self.positions[i as usize]);
                let area = area_vector([a, b, c]);
                // Small where short edges are wanted, so that these areas do not drain.
                let wanted: f64 = t.iter().map(|i| self.lengths[*i as usize]).sum();
                let weight = area.length() / (wanted * wanted);
                centre += (a + b + c) * (weight / 3.0);
                total += weight;
                up += area;
            }
            if total <= 0.0 {
                continue;
            }
            let mut step = centre * (1.0 / total) - here;
            if self.rim[v] {
                // With its mirror image, what draws a vertex of the rim stays in the plane.
                step.e1 = 0.0;
                up.e1 = 0.0;
            }
            let up = up.normalized().unwrap_or_default();
            let drifted = here + step - up * step.dot(up);
            let target = drifted - up * distance(drifted);
            if !self.turns_over(v as u32, target, triangles) {
                self.positions[v] = target;
                self.lengths[v] = (self.length)(target);
            }
        }
    }

    /// Whether the normal of one of the triangles would rotate by more than 60° if one of its
    /// vertices moved.
    fn turns_over(
        &self,
        vertex: u32,
        target: Vector,
        mut triangles: impl Iterator<Item = [u32; 3]>,
    ) -> bool {
        triangles.any(|t| {
            let old = t.map(|v| self.positions[v as usize]);
            let new = t.map(|v| {
                if v == vertex {
                    target
                } else {
                    self.positions[v as usize]
                }
            });
            normal(old).dot(normal(new)) < 0.5
        })
    }

    fn finish(self) -> Surface {
        let mut number = vec![u32::MAX; self.positions.len()];
        let mut surface = Surface::default();
        for t in self.topology.live_triangles() {
            let corners = t.map(|v| {
                if number[v as usize] == u32::MAX {
                    number[v as usize] = surface.positions.len() as u32;
                    surface.positions.push(self.positions[v as usize]);
                }
                number[v as usize]
            });
            surface.triangles.push(corners);
        }
        surface
    }
}

/// The unit normal of a triangle; zero for one without area.
fn normal(corners: [Vector; 3]) -> Vector {
    area_vector(corners).normalized().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::marching_tetrahedra::{Grid, march};
    use std::collections::HashMap;

    fn ball(point: Vector) -> f64 {
        point.length() - 1.0
    }

    /// Half a ball, cut off at x = 0.
    fn half_ball() -> Surface {
        let grid = Grid {
            origin: Vector::new(0.0, -1.25, -1.25),
            spacing: 0.1,
            cubes: [13, 25, 25],
        };
        march(grid, 1.0, |point, _| ball(point))
    }

    fn edges(surface: &Surface) -> HashMap<(u32, u32), usize> {
        let mut edges = HashMap::new();
        for t in &surface.triangles {
            for k in 0..3 {
                *edges.entry((t[k], t[(k + 1) % 3])).or_insert(0) += 1;
            }
        }
        edges
    }

    /// Fails unless the surface is a disc whose rim lies in the plane x = 0.
    fn assert_half(surface: &Surface) {
        let edges = edges(surface);
        assert!(
            edges.values().all(|count| *count == 1),
            "an edge is there twice"
        );
        let mut rim = 0;
        for (a, b) in edges.keys() {
            let in_plane = [a, b].map(|v| surface.positions[*v as usize].e1 == 0.0);
            if edges.contains_key(&(*b, *a)) {
                assert_ne!(in_plane, [true; 2], "an inner edge is its own mirror image");
            } else {
                rim += 1;
                assert_eq!(in_plane, [true; 2], "the rim leaves the plane");
            }
        }
        let on_plane = surface.positions.iter().filter(|p| p.e1 == 0.0).count();
        assert_eq!(on_plane, rim, "the plane holds the rim and nothing else");
        let edge_count = (edges.len() + rim) / 2;
        assert_eq!(
            surface.positions.len() + surface.triangles.len(),
            edge_count + 1
        );
    }

    #[test]
    fn marching_gives_a_disc_that_faces_outwards() {
        let surface = half_ball();
        assert_half(&surface);
        let corners = surface
            .triangles
            .iter()
            .map(|t| t.map(|v| surface.positions[v as usize]));
        let volume: f64 = corners.map(|[a, b, c]| a.dot(b.cross(c)) / 6.0).sum();
        assert!(
            (volume / (2.0 / 3.0 * std::f64::consts::PI) - 1.0).abs() < 0.01,
            "{volume}"
        );
    }

    #[test]
    fn remeshing_keeps_the_disc_and_evens_the_edges() {
        for wanted in [0.06, 0.2] {
            let surface = remesh(half_ball(), 5, |_| wanted, ball);
            assert_half(&surface);
            assert!(surface.positions.iter().all(|p| ball(*p).abs() < 1e-6));
            for (a, b) in edges(&surface).keys() {
                let [a, b] = [a, b].map(|v| surface.positions[*v as usize]);
                let length = a.distance(b);
                assert!(
                    (0.5..1.7).contains(&(length / wanted)),
                    "{length} of {wanted}"
                );
            }
        }
    }

    #[test]
    fn what_is_thinner_than_an_edge_keeps_its_topology() {
        // A finger to the side, two upright ones beside the plane, a slab in it.
        let reach = |p: Vector, axis: Vector| p.distance(axis * p.dot(axis).clamp(-0.9, 0.9));
        let solids: [&dyn Fn(Vector) -> f64; 3] = [
            &|p| reach(p, Vector::X) - 0.1,
            &|p| reach(p, Vector::Y) - 0.1,
            &|p| Vector::new(6.0 * p.e1, p.e2, p.e3).length() - 1.0,
        ];
        for distance in solids {
            for wanted in [0.1, 0.15, 0.2, 0.3, 0.5] {
                let grid = Grid {
                    origin: Vector::new(0.0, -1.25, -1.25),
                    spacing: 0.05,
                    cubes: [25, 50, 50],
                };
                let rough = march(grid, 6.0, |point, _| distance(point));
                assert_half(&remesh(rough, 5, |_| wanted, distance));
            }
        }
    }

    #[test]
    fn edges_are_short_where_short_ones_are_wanted() {
        let wanted = |p: Vector| if p.e2 > 0.0 { 0.07 } else { 0.15 };
        let surface = remesh(half_ball(), 5, wanted, ball);
        assert_half(&surface);
        let above = surface.positions.iter().filter(|p| p.e2 > 0.0).count();
        // The number of vertices goes with the inverse square of the length.
        let ratio = above as f64 / (surface.positions.len() - above) as f64;
        assert!((3.0..6.0).contains(&ratio), "{ratio}");
    }
}
