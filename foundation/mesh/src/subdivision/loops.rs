//! Loop's scheme.

use super::cage::Smoothing;
use super::sharpness::{Rule, Sharpness};
use super::stencils::{Builder, Weights};
use super::{Cage, Stencils};
use crate::topology::Neighbours;
use crate::{Faces, MeshError};

/// Four triangles for each.
pub(super) fn faces(cage: &Cage) -> Result<Faces, MeshError> {
    let vertices = cage.vertex_count() as u32;
    let (triangles, _) = cage.faces().corners().as_chunks::<3>();
    let (edges, _) = cage.edges().of_corners().as_chunks::<3>();
    let mut fine = Vec::with_capacity(4 * triangles.len());
    for (&[a, b, c], edges) in triangles.iter().zip(edges) {
        let [ab, bc, ca] = edges.map(|edge| vertices + edge);
        fine.extend_from_slice(&[[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]);
    }
    Faces::from_uniform(fine)
}

/// The rows of the vertices, then those of the edges.
pub(super) fn stencils(cage: &Cage, sharpness: &Sharpness<'_>) -> Stencils {
    let (edges, vertices) = (cage.edges(), cage.vertex_count());
    let mut rows = Builder::new(vertices, vertices + 2 * edges.len() + 4 * edges.len());
    vertex_rows(cage, sharpness, &mut rows);

    let middle = rows.weights([0.5, 0.5]);
    let smooth = rows.weights([0.375, 0.375, 0.125, 0.125]);
    let corners = cage.faces().corners();
    let linear = cage.smoothing() == Smoothing::Linear;
    for (edge, &[a, b]) in (0..).zip(edges.all()) {
        let crease = if linear {
            1.0
        } else {
            sharpness.of_new_vertex(edge)
        };
        let &[one, other] = edges.sides(edge) else {
            rows.shared_array(middle, [a, b]);
            continue;
        };
        // The vertices opposite the edge, in an order that does not depend on that of the faces.
        let (c, d) = (opposite(corners, one), opposite(corners, other));
        let (c, d) = (c.min(d), c.max(d));
        if crease <= 0.0 {
            rows.shared_array(smooth, [a, b, c, d]);
        } else if crease == 1.0 {
            rows.shared_array(middle, [a, b]);
        } else {
            let (end, far) = (0.375 + 0.125 * crease, 0.125 * (1.0 - crease));
            rows.own(&[(a, end), (b, end), (c, far), (d, far)]);
        }
    }
    rows.finish()
}

fn vertex_rows(cage: &Cage, sharpness: &Sharpness<'_>, rows: &mut Builder) {
    let vertices = cage.vertex_count() as u32;
    let fixed = rows.weights([1.0]);
    let crease = rows.weights([0.75, 0.125, 0.125]);
    if cage.smoothing() == Smoothing::Linear {
        (0..vertices).for_each(|vertex| rows.shared(fixed, vertex, &[]));
        return;
    }
    let neighbours = Neighbours::new(cage.edges());
    let mut smooth: Vec<Option<Weights>> = vec![None; 16];
    for vertex in 0..vertices {
        let neighbours = neighbours.of(vertex);
        let valence = neighbours.len();
        let (rule, next) = if sharpness.is_smooth(vertex as usize) {
            (Rule::Smooth, None)
        } else {
            sharpness.of_vertex(vertex, neighbours)
        };
        match (rule, next) {
            _ if valence == 0 => rows.shared(fixed, vertex, &[]),
            (Rule::Smooth, _) => {
                if valence >= smooth.len() {
                    smooth.resize(valence + 1, None);
                }
                let weights = *smooth[valence].get_or_insert_with(|| {
                    let share = beta(valence);
                    let own = 1.0 - valence as f64 * share;
                    rows.weights(std::iter::once(own).chain(std::iter::repeat_n(share, valence)))
                });
                rows.shared(weights, vertex, neighbours);
            }
            (Rule::Crease([a, b]), None) => rows.shared_array(crease, [vertex, a, b]),
            (Rule::Corner, None) => rows.shared(fixed, vertex, &[]),
            (rule, Some((next, share))) => {
                let mut row = vec![(vertex, 0.0)];
                row.extend(neighbours.iter().map(|&neighbour| (neighbour, 0.0)));
                add(&mut row, rule, share);
                add(&mut row, next, 1.0 - share);
                row.retain(|&(_, weight)| weight != 0.0);
                rows.own(&row);
            }
        }
    }
}

/// The share of each neighbour in a smooth vertex of this valence.
pub(super) fn beta(valence: usize) -> f64 {
    if valence == 6 {
        return 0.0625;
    }
    let n = valence as f64;
    let centre = 0.375 + 0.25 * (std::f64::consts::TAU / n).cos();
    (0.625 - centre * centre) / n
}

/// Adds `share` times the weights of a rule to the row of a vertex and all its neighbours.
fn add(row: &mut [(u32, f64)], rule: Rule, share: f64) {
    match rule {
        Rule::Corner => row[0].1 += share,
        Rule::Crease(ends) => {
            row[0].1 += 0.75 * share;
            for (_, weight) in row[1..].iter_mut().filter(|(v, _)| ends.contains(v)) {
                *weight += 0.125 * share;
            }
        }
        Rule::Smooth => {
            let valence = row.len() - 1;
            let beta = beta(valence);
            row[0].1 += share * (1.0 - valence as f64 * beta);
            for (_, weight) in &mut row[1..] {
                *weight += share * beta;
            }
        }
    }
}

/// The vertex of a triangle that is not on its side `side`.
#[inline]
fn opposite(corners: &[u32], side: u32) -> u32 {
    let first = side - side % 3;
    let before = if side == first { first + 2 } else { side - 1 };
    corners[before as usize]
}
