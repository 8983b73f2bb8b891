//! Distances along a surface.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use ga_runtime::cga3::Point;
use ga_runtime::vga3::Vector;

use crate::topology::VertexCorners;
use crate::{Faces, MeshError};

/// A place from which distances are measured, given by a vertex near to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Source {
    /// The vertex.
    pub vertex: u32,
    /// Its distance from the place, zero where the place is the vertex. Not negative.
    pub distance: f64,
    /// The number of the place, below 2³² − 1. Vertices near to the same place have the same
    /// number.
    pub place: u32,
}

impl From<u32> for Source {
    /// The vertex itself, as a place of its own.
    fn from(vertex: u32) -> Self {
        Self {
            vertex,
            distance: 0.0,
            place: vertex,
        }
    }
}

/// The distance along the surface from the nearest source to each vertex, in the unit of the
/// positions; infinite for vertices that are farther away than `reach` or not connected.
///
/// Distances spread from vertex to vertex in rising order. Within a triangle two of whose corners
/// are known, the third is as far from the source as in the plane of the triangle, with the source
/// unfolded into it, or else reached along an edge. Where the nearest places of two corners differ,
/// the front between them is taken as straight. In a plane a distance from one place is exact where
/// the straight way enters each triangle between two corners that are nearer to the place than the
/// third, and never too small; elsewhere and on curved surfaces the error falls with the size of
/// the triangles. (R. Kimmel and J. A. Sethian, "Computing geodesic paths on manifolds", PNAS 95,
/// 1998, with the unfolded source of M. Novotni and R. Klein, "Computing geodesic distances on
/// triangular meshes", WSCG 2002.)
///
/// # Errors
///
/// [`MeshError::IndexOutOfRange`] for a triangle, [`MeshError::NotFinite`] for a position, and
/// [`MeshError::PointOutOfRange`] for a source that refers to a vertex that does not exist.
///
/// ```
/// use ga_mesh::geodesic::distances;
///
/// // A sheet of paper, folded by 90° along y: the way from one side to the other goes over the
/// // fold.
/// let places = [[-3.0, 0.0, 0.0], [0.0, -4.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 3.0]];
/// let found = distances(&places, &[[0, 1, 2], [1, 3, 2]], &[0.into()], f64::INFINITY)?;
/// let truth = [0.0, 5.0, 5.0, 6.0];
/// assert!(found.iter().zip(truth).all(|(found, truth)| (found - truth).abs() < 1e-12));
/// # Ok::<(), ga_mesh::MeshError>(())
/// ```
pub fn distances<P: Copy + Into<Point<f64>>>(
    positions: &[P],
    triangles: &[[u32; 3]],
    sources: &[Source],
    reach: f64,
) -> Result<Vec<f64>, MeshError> {
    let places: Vec<Vector<f64>> = positions.iter().map(|&p| Vector::from(p.into())).collect();
    if let Some(vertex) = places.iter().position(|place| !place.is_finite()) {
        let coordinates = places[vertex].coordinates();
        return Err(MeshError::NotFinite {
            vertex,
            coordinates,
        });
    }
    let vertices = places.len();
    let is_beyond = |index: &u32| *index as usize >= vertices;
    for (face, triangle) in triangles.iter().enumerate() {
        if let Some(index) = triangle.iter().copied().find(is_beyond) {
            return Err(MeshError::IndexOutOfRange {
                face,
                index,
                vertices,
            });
        }
    }
    if let Some(point) = sources.iter().position(|source| is_beyond(&source.vertex)) {
        return Err(MeshError::PointOutOfRange {
            point,
            index: sources[point].vertex,
            vertices,
        });
    }
    let faces = Faces::from_polygons(triangles.iter().copied())?;
    let mut front = Front {
        corners: VertexCorners::new(&faces, vertices),
        distances: vec![f64::INFINITY; vertices],
        is_final: vec![false; vertices],
        nearest: vec![0; vertices],
        waiting: BinaryHeap::new(),
        places: &places,
        triangles,
        reach,
    };
    for source in sources {
        front.offer(source.vertex, source.distance, source.place);
    }
    front.spread();
    Ok(front.distances)
}

/// A vertex with the least distance so far; the nearest is the greatest, and among several the one
/// with the lowest index.
#[derive(PartialEq)]
struct Waiting {
    distance: f64,
    vertex: u32,
}

impl Eq for Waiting {}

impl Ord for Waiting {
    fn cmp(&self, other: &Self) -> Ordering {
        let by_distance = other.distance.total_cmp(&self.distance);
        by_distance.then(other.vertex.cmp(&self.vertex))
    }
}

impl PartialOrd for Waiting {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// In place of the number of a place: the distance belongs to a front from several places.
const SEVERAL: u32 = u32::MAX;

/// Distances that spread.
struct Front<'a> {
    places: &'a [Vector<f64>],
    triangles: &'a [[u32; 3]],
    corners: VertexCorners,
    distances: Vec<f64>,
    is_final: Vec<bool>,
    /// The place that each distance comes from, or [`SEVERAL`].
    nearest: Vec<u32>,
    waiting: BinaryHeap<Waiting>,
    reach: f64,
}

impl Front<'_> {
    fn spread(&mut self) {
        while let Some(Waiting { vertex, .. }) = self.waiting.pop() {
            if std::mem::replace(&mut self.is_final[vertex as usize], true) {
                continue;
            }
            for place in 0..self.corners.of(vertex).len() {
                let corner = self.corners.of(vertex)[place] as usize;
                let triangle = self.triangles[corner / 3];
                let [b, c] = [1, 2].map(|k| triangle[(corner + k) % 3]);
                self.update(b, [vertex, c]);
                self.update(c, [vertex, b]);
            }
        }
    }

    /// Offers a corner of a triangle the distances by the other two, the first of which is final.
    fn update(&mut self, corner: u32, [known, other]: [u32; 2]) {
        if self.is_final[corner as usize] {
            return;
        }
        let [c, a, b] = [corner, known, other].map(|vertex| self.places[vertex as usize]);
        let [first, second] = [known, other].map(|vertex| self.distances[vertex as usize]);
        let along_edge = first + a.distance(c);
        let [place, next] = [known, other].map(|vertex| self.nearest[vertex as usize]);
        let (across, from) = match self.is_final[other as usize] {
            false => (None, place),
            true if place == next && place != SEVERAL => {
                (unfolded([a, b, c], [first, second]), place)
            }
            true => (straight([a, b, c], [first, second]), SEVERAL),
        };
        match across.filter(|&across| across < along_edge) {
            Some(across) => self.offer(corner, across, from),
            None => self.offer(corner, along_edge, place),
        }
    }

    fn offer(&mut self, vertex: u32, distance: f64, place: u32) {
        let least = &mut self.distances[vertex as usize];
        if distance < *least && distance <= self.reach {
            *least = distance;
            self.nearest[vertex as usize] = place;
            self.waiting.push(Waiting { distance, vertex });
        }
    }
}

/// The third corner of a triangle, with the first as origin and the second on the first axis.
struct Plane {
    /// The distance between the first two corners.
    length: f64,
    x: f64,
    y: f64,
}

impl Plane {
    fn new([a, b, c]: [Vector<f64>; 3]) -> Option<Self> {
        let edge = b - a;
        let along = edge.normalized()?;
        let to_c = c - a;
        let x = to_c.dot(along);
        Some(Self {
            length: edge.length(),
            x,
            y: (to_c - along * x).length(),
        })
    }

    /// Whether a way that crosses the first axis there leads between the first two corners.
    fn is_between(&self, crossing: f64) -> bool {
        let slack = 1e-12 * self.length;
        (-slack..=self.length + slack).contains(&crossing)
    }
}

/// How far c is from the source whose distances from a and b are given, in the plane of the three
/// and with the source beyond the edge from a to b; `None` where the way does not cross that edge,
/// or there is no such source.
fn unfolded(corners: [Vector<f64>; 3], [first, second]: [f64; 2]) -> Option<f64> {
    let plane = Plane::new(corners)?;
    let Plane { length, x, y } = plane;
    // Distances that contradict the length of the edge have no source.
    if (first - second).abs() > length || first + second < length * (1.0 - 1e-12) {
        return None;
    }
    // The source is at (s, −below).
    let s = 0.5 * ((first - second) * (first + second) / length + length);
    let below = ((first - s) * (first + s)).max(0.0).sqrt();
    let height = below + y;
    let crossing = if height > 0.0 {
        s + (x - s) * below / height
    } else {
        s
    };
    plane.is_between(crossing).then(|| (x - s).hypot(height))
}

/// How far the third corner is behind a straight front that passes the first two at the given
/// distances; `None` where it reaches the third past them.
fn straight(corners: [Vector<f64>; 3], [first, second]: [f64; 2]) -> Option<f64> {
    let plane = Plane::new(corners)?;
    let Plane { length, x, y } = plane;
    let sine = (second - first) / length;
    let cosine = (1.0 - sine * sine).max(0.0).sqrt();
    let crossing = x - sine * y / cosine;
    (sine.abs() < 1.0 && plane.is_between(crossing)).then_some(first + sine * x + cosine * y)
}
