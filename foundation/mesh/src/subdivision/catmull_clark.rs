//! Catmull and Clark's scheme.

use super::cage::Smoothing;
use super::sharpness::{Rule, Sharpness};
use super::stencils::{Builder, SparseSum, Weights};
use super::{Cage, Stencils};
use crate::topology::{Neighbours, VertexCorners};
use crate::{Faces, MeshError};

/// A quadrilateral for each corner.
pub(super) fn faces(cage: &Cage) -> Result<Faces, MeshError> {
    let vertices = cage.vertex_count() as u32;
    let first_of_faces = vertices + cage.edges().len() as u32;
    let of_corners = cage.edges().of_corners();
    let mut fine = Vec::with_capacity(of_corners.len());
    for (face, polygon) in cage.faces().iter().enumerate() {
        let edges = &of_corners[cage.faces().corner_range(face)];
        let mut before = edges[edges.len() - 1];
        for (&vertex, &after) in polygon.iter().zip(edges) {
            let middle = first_of_faces + face as u32;
            fine.push([vertex, vertices + after, middle, vertices + before]);
            before = after;
        }
    }
    Faces::from_uniform(fine)
}

/// The rows of the vertices, those of the edges, then those of the faces.
pub(super) fn stencils(cage: &Cage, sharpness: &Sharpness<'_>) -> Stencils {
    let (vertices, corners) = (cage.vertex_count(), cage.faces().corners().len());
    let values = vertices + 6 * cage.edges().len() + 3 * corners;
    let mut rows = Rows {
        cage,
        sharpness,
        builder: Builder::new(vertices, values),
        sum: SparseSum::new(vertices),
    };
    rows.vertices();
    rows.edges();
    rows.faces();
    rows.builder.finish()
}

struct Rows<'a> {
    cage: &'a Cage,
    sharpness: &'a Sharpness<'a>,
    builder: Builder,
    sum: SparseSum,
}

impl Rows<'_> {
    fn vertices(&mut self) {
        let vertices = self.cage.vertex_count() as u32;
        let fixed = self.builder.weights([1.0]);
        if self.cage.smoothing() == Smoothing::Linear {
            (0..vertices).for_each(|vertex| self.builder.shared(fixed, vertex, &[]));
            return;
        }
        let crease = self.builder.weights([0.75, 0.125, 0.125]);
        let neighbours = Neighbours::new(self.cage.edges());
        let corners = VertexCorners::new(self.cage.faces(), vertices as usize);
        let mut smooth: Vec<Option<Weights>> = vec![None; 16];
        let mut others = Vec::new();
        for vertex in 0..vertices {
            let (neighbours, corners) = (neighbours.of(vertex), corners.of(vertex));
            let (rule, next) = if self.sharpness.is_smooth(vertex as usize) {
                (Rule::Smooth, None)
            } else {
                self.sharpness.of_vertex(vertex, neighbours)
            };
            match (rule, next) {
                _ if corners.is_empty() => self.builder.shared(fixed, vertex, &[]),
                (Rule::Smooth, _) => {
                    others.clear();
                    others.extend_from_slice(neighbours);
                    if self.push_diagonals(corners, &mut others) {
                        let valence = neighbours.len();
                        if valence >= smooth.len() {
                            smooth.resize(valence + 1, None);
                        }
                        let weights = *smooth[valence]
                            .get_or_insert_with(|| quadrilateral(&mut self.builder, valence));
                        self.builder.shared(weights, vertex, &others);
                    } else {
                        self.add(vertex, neighbours, corners, Rule::Smooth, 1.0);
                        self.push_sum();
                    }
                }
                (Rule::Crease([a, b]), None) => {
                    self.builder.shared_array(crease, [vertex, a, b]);
                }
                (Rule::Corner, None) => self.builder.shared(fixed, vertex, &[]),
                (rule, Some((next, share))) => {
                    self.add(vertex, neighbours, corners, rule, share);
                    self.add(vertex, neighbours, corners, next, 1.0 - share);
                    self.push_sum();
                }
            }
        }
    }

    fn edges(&mut self) {
        let middle = self.builder.weights([0.5, 0.5]);
        let smooth = self
            .builder
            .weights([0.375, 0.375, 0.0625, 0.0625, 0.0625, 0.0625]);
        let linear = self.cage.smoothing() == Smoothing::Linear;
        let edges = self.cage.edges();
        for (edge, &[a, b]) in (0..).zip(edges.all()) {
            let crease = if linear {
                1.0
            } else {
                self.sharpness.of_new_vertex(edge)
            };
            let sides = edges.sides(edge);
            if crease == 1.0 {
                self.builder.shared_array(middle, [a, b]);
            } else if crease <= 0.0
                && let &[one, other] = sides
                && let (Some([c, d]), Some([e, f])) = (self.far_side(one), self.far_side(other))
            {
                self.builder.shared_array(smooth, [a, b, c, d, e, f]);
            } else {
                for end in [a, b] {
                    self.sum.add(end, 0.25 + 0.25 * crease);
                }
                for &side in sides {
                    self.add_centre(side, 0.25 * (1.0 - crease));
                }
                self.push_sum();
            }
        }
    }

    fn faces(&mut self) {
        let mut weights: Vec<Option<Weights>> = vec![None; 8];
        for polygon in self.cage.faces() {
            let count = polygon.len();
            if count >= weights.len() {
                weights.resize(count + 1, None);
            }
            let weights = *weights[count].get_or_insert_with(|| {
                self.builder
                    .weights(std::iter::repeat_n(1.0 / count as f64, count))
            });
            self.builder.shared(weights, polygon[0], &polygon[1..]);
        }
    }

    /// Adds `share` times the weights of a rule for a vertex to the sum.
    fn add(&mut self, vertex: u32, neighbours: &[u32], corners: &[u32], rule: Rule, share: f64) {
        match rule {
            Rule::Corner => self.sum.add(vertex, share),
            Rule::Crease(ends) => {
                self.sum.add(vertex, 0.75 * share);
                for end in ends {
                    self.sum.add(end, 0.125 * share);
                }
            }
            Rule::Smooth => {
                let n = neighbours.len() as f64;
                self.sum.add(vertex, share * (n - 2.0) / n);
                for &neighbour in neighbours {
                    self.sum.add(neighbour, share / (n * n));
                }
                for &corner in corners {
                    self.add_centre(corner, share / (n * n));
                }
            }
        }
    }

    /// Adds `share` times the mean of the corners of a corner's face.
    fn add_centre(&mut self, corner: u32, share: f64) {
        let face = self.cage.edges().face_of_corner(corner) as usize;
        if let Some(polygon) = self.cage.faces().get(face) {
            for &vertex in polygon {
                self.sum.add(vertex, share / polygon.len() as f64);
            }
        }
    }

    /// Ends the row in the sum.
    fn push_sum(&mut self) {
        let builder = &mut self.builder;
        self.sum.take(|row| {
            // Weights that cancel are left out, but a row is never empty.
            if row.iter().any(|&(_, weight)| weight == 0.0) {
                let row: Vec<_> = row.iter().copied().filter(|term| term.1 != 0.0).collect();
                builder.own(&row);
            } else {
                builder.own(row);
            }
        });
    }

    /// Adds the vertices diagonally opposite the corners; false if some face is not a
    /// quadrilateral.
    fn push_diagonals(&self, corners: &[u32], vertices: &mut Vec<u32>) -> bool {
        for &corner in corners {
            let Some((polygon, place)) = self.quadrilateral(corner) else {
                return false;
            };
            vertices.push(polygon[(place + 2) % 4]);
        }
        true
    }

    /// The vertices of a quadrilateral that are not on its side `side`.
    fn far_side(&self, side: u32) -> Option<[u32; 2]> {
        let (polygon, place) = self.quadrilateral(side)?;
        Some([polygon[(place + 2) % 4], polygon[(place + 3) % 4]])
    }

    /// The face of a corner, if it is a quadrilateral, and which of its corners this is.
    fn quadrilateral(&self, corner: u32) -> Option<(&[u32; 4], usize)> {
        let face = self.cage.edges().face_of_corner(corner) as usize;
        let range = self.cage.faces().corner_range(face);
        let place = corner as usize - range.start;
        let polygon = self.cage.faces().corners()[range].as_array()?;
        Some((polygon, place))
    }
}

/// The weights of a smooth vertex among quadrilaterals: of itself, of its neighbours, of the
/// vertices diagonally opposite.
fn quadrilateral(builder: &mut Builder, valence: usize) -> Weights {
    let n = valence as f64;
    let own = std::iter::once(1.0 - 1.75 / n);
    let neighbours = std::iter::repeat_n(1.5 / (n * n), valence);
    let diagonals = std::iter::repeat_n(0.25 / (n * n), valence);
    builder.weights(own.chain(neighbours).chain(diagonals))
}
