//! The rules of subdivision once more, by searching and with sorted maps: face points, edge points
//! and vertex points are computed from each other, as the papers describe them.

use std::collections::BTreeMap;

use ga_mesh::subdivision::{Boundary, CreaseMethod, Rules, Scheme, Tags};

use crate::shapes::Shape;

type Point = [f64; 3];

/// A control mesh with positions and sharpness.
#[derive(Clone)]
pub(crate) struct Dense {
    pub(crate) points: Vec<Point>,
    pub(crate) faces: Vec<Vec<u32>>,
    creases: BTreeMap<[u32; 2], f64>,
    corners: BTreeMap<u32, f64>,
    rules: Rules,
}

#[derive(Clone, Copy, PartialEq, Debug)]
enum Kind {
    Smooth,
    Crease,
    Corner,
}

fn sum(points: impl IntoIterator<Item = (f64, Point)>) -> Point {
    let mut sum = [0.0; 3];
    for (weight, point) in points {
        for axis in 0..3 {
            sum[axis] += weight * point[axis];
        }
    }
    sum
}

fn mean(points: &[Point]) -> Point {
    let share = 1.0 / points.len() as f64;
    sum(points.iter().map(|&point| (share, point)))
}

fn between(a: Point, b: Point, share_of_a: f64) -> Point {
    sum([(share_of_a, a), (1.0 - share_of_a, b)])
}

fn pair(a: u32, b: u32) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

impl Dense {
    pub(crate) fn new(shape: &Shape, rules: Rules, tags: &Tags) -> Self {
        let creases = tags.creases.iter().map(|crease| {
            let [a, b] = crease.vertices;
            (pair(a, b), crease.sharpness)
        });
        Self {
            points: shape.positions.clone(),
            faces: shape.faces.clone(),
            creases: creases.collect(),
            corners: tags
                .corners
                .iter()
                .map(|corner| (corner.vertex, corner.sharpness))
                .collect(),
            rules,
        }
    }

    /// The edges with the faces at each.
    fn edges(&self) -> BTreeMap<[u32; 2], Vec<usize>> {
        let mut edges: BTreeMap<[u32; 2], Vec<usize>> = BTreeMap::new();
        for (index, face) in self.faces.iter().enumerate() {
            for place in 0..face.len() {
                let next = face[(place + 1) % face.len()];
                edges
                    .entry(pair(face[place], next))
                    .or_default()
                    .push(index);
            }
        }
        edges
    }

    fn edge_sharpness(&self, edge: [u32; 2], faces: &[usize]) -> f64 {
        if faces.len() == 1 {
            f64::INFINITY
        } else {
            self.creases.get(&edge).copied().unwrap_or(0.0)
        }
    }

    fn vertex_sharpness(&self, vertex: u32) -> f64 {
        let faces = self
            .faces
            .iter()
            .filter(|face| face.contains(&vertex))
            .count();
        if self.rules.boundary == Boundary::EdgeAndCorner && faces == 1 {
            return f64::INFINITY;
        }
        self.corners.get(&vertex).copied().unwrap_or(0.0)
    }

    /// Sharpness of one of several edges at a vertex, one level on.
    fn next_sharpness(&self, own: f64, others: &[f64]) -> f64 {
        if own >= 10.0 {
            return own;
        }
        let finite: Vec<f64> = others
            .iter()
            .copied()
            .filter(|&s| s > 0.0 && s < 10.0)
            .collect();
        let mut next = own;
        if self.rules.creases == CreaseMethod::Chaikin && own > 0.0 && !finite.is_empty() {
            next = (3.0 * own + finite.iter().sum::<f64>() / finite.len() as f64) / 4.0;
        }
        f64::max(next - 1.0, 0.0)
    }

    pub(crate) fn refined(&self) -> Self {
        let edges = self.edges();
        let point = |vertex: u32| self.points[vertex as usize];
        let corners = |face: usize| {
            self.faces[face]
                .iter()
                .map(|&v| point(v))
                .collect::<Vec<_>>()
        };
        let face_points: Vec<Point> = (0..self.faces.len())
            .map(|face| mean(&corners(face)))
            .collect();
        let mut refined = Self {
            points: Vec::new(),
            faces: Vec::new(),
            creases: BTreeMap::new(),
            corners: BTreeMap::new(),
            ..self.clone()
        };

        // All edges at each vertex, with their sharpness now and at the next level.
        let mut around = vec![Vec::new(); self.points.len()];
        for (&edge, faces) in &edges {
            for (end, other) in [(edge[0], edge[1]), (edge[1], edge[0])] {
                around[end as usize].push((other, self.edge_sharpness(edge, faces)));
            }
        }
        let next_around: Vec<Vec<(u32, f64)>> = around
            .iter()
            .map(|edges| {
                let next = |place: usize| {
                    let (other, own) = edges[place];
                    let others: Vec<f64> = (0..edges.len())
                        .filter(|&at| at != place)
                        .map(|at| edges[at].1)
                        .collect();
                    (other, self.next_sharpness(own, &others))
                };
                (0..edges.len()).map(next).collect()
            })
            .collect();
        let next_of = |vertex: u32, other: u32| {
            let edges = &next_around[vertex as usize];
            edges.iter().find(|edge| edge.0 == other).unwrap().1
        };

        let mut edge_points = Vec::new();
        for (&[a, b], faces) in &edges {
            let middle = between(point(a), point(b), 0.5);
            let smooth = if faces.len() == 1 {
                middle
            } else {
                let of_faces = between(face_points[faces[0]], face_points[faces[1]], 0.5);
                match self.rules.scheme {
                    // 3/8 (a + b) + 1/8 (c + d), by the centres of the triangles.
                    Scheme::Loop => between(middle, of_faces, 0.25),
                    Scheme::CatmullClark => between(middle, of_faces, 0.5),
                }
            };
            let sharpness = self.edge_sharpness([a, b], faces);
            let stays = next_of(a, b) > 0.0 && next_of(b, a) > 0.0;
            let share = if stays { 1.0 } else { sharpness };
            edge_points.push(between(middle, smooth, share));
        }

        for vertex in 0..self.points.len() as u32 {
            let (now, next) = (&around[vertex as usize], &next_around[vertex as usize]);
            let sharpness = self.vertex_sharpness(vertex);
            let next_sharpness = if sharpness >= 10.0 {
                sharpness
            } else {
                (sharpness - 1.0).max(0.0)
            };
            let kind = self.kind(sharpness, now);
            let next_kind = self.kind(next_sharpness, next);
            let mut result = self.vertex_point(vertex, kind, now, &face_points);
            if kind != next_kind && kind != Kind::Smooth {
                let mut ending = Vec::new();
                for (&(_, before), &(_, after)) in now.iter().zip(next) {
                    if before > 0.0 && after <= 0.0 {
                        ending.push(before);
                    }
                }
                if sharpness > 0.0 && next_sharpness <= 0.0 {
                    ending.push(sharpness);
                }
                let share = (ending.iter().sum::<f64>() / ending.len() as f64).min(1.0);
                let later = self.vertex_point(vertex, next_kind, next, &face_points);
                result = between(result, later, share);
            }
            refined.points.push(result);
            if next_sharpness > 0.0 {
                refined.corners.insert(vertex, next_sharpness);
            }
        }
        refined.points.extend(&edge_points);

        let (vertices, edge_count) = (self.points.len() as u32, edges.len() as u32);
        let number: BTreeMap<[u32; 2], u32> = edges.keys().copied().zip(vertices..).collect();
        for (&[a, b], &middle) in &number {
            for (end, other) in [(a, b), (b, a)] {
                refined.creases.insert([end, middle], next_of(end, other));
            }
        }
        for (index, face) in self.faces.iter().enumerate() {
            let count = face.len();
            let edge = |place: usize| number[&pair(face[place % count], face[(place + 1) % count])];
            let centre = vertices + edge_count + index as u32;
            for (place, &vertex) in face.iter().enumerate() {
                let mut child = vec![vertex, edge(place)];
                if self.rules.scheme == Scheme::CatmullClark {
                    child.push(centre);
                }
                child.push(edge(place + count - 1));
                refined.faces.push(child);
            }
            if self.rules.scheme == Scheme::Loop {
                refined.faces.push((0..count).map(edge).collect());
            }
        }
        if self.rules.scheme == Scheme::CatmullClark {
            refined.points.extend(face_points);
        }
        refined
    }

    fn kind(&self, sharpness: f64, edges: &[(u32, f64)]) -> Kind {
        let sharp = edges
            .iter()
            .filter(|&&(_, sharpness)| sharpness > 0.0)
            .count();
        match sharp {
            _ if sharpness > 0.0 => Kind::Corner,
            0 | 1 => Kind::Smooth,
            2 => Kind::Crease,
            _ => Kind::Corner,
        }
    }

    fn vertex_point(
        &self,
        vertex: u32,
        kind: Kind,
        edges: &[(u32, f64)],
        face_points: &[Point],
    ) -> Point {
        let own = self.points[vertex as usize];
        if kind == Kind::Corner || edges.is_empty() {
            return own;
        }
        let point = |&(other, _): &(u32, f64)| self.points[other as usize];
        if kind == Kind::Crease {
            let sharp = edges.iter().filter(|(_, sharpness)| *sharpness > 0.0);
            let ends: Vec<Point> = sharp.map(point).collect();
            return between(own, mean(&ends), 0.75);
        }
        let ring: Vec<Point> = edges.iter().map(point).collect();
        let n = ring.len() as f64;
        match self.rules.scheme {
            Scheme::Loop => {
                // Loop's thesis: α = (3/8 + cos(2π/n)/4)² + 3/8 is the vertex's own share.
                let alpha = (0.375 + (std::f64::consts::TAU / n).cos() / 4.0).powi(2) + 0.375;
                between(own, mean(&ring), alpha)
            }
            Scheme::CatmullClark => {
                // Catmull and Clark: Q/n + 2 R/n + S (n − 3)/n, with the mean Q of the face points
                // and the mean R of the midpoints of the edges.
                let at: Vec<Point> = (0..self.faces.len())
                    .filter(|&face| self.faces[face].contains(&vertex))
                    .map(|face| face_points[face])
                    .collect();
                let middles: Vec<Point> = ring.iter().map(|&end| between(own, end, 0.5)).collect();
                sum([
                    (1.0 / n, mean(&at)),
                    (2.0 / n, mean(&middles)),
                    ((n - 3.0) / n, own),
                ])
            }
        }
    }
}
