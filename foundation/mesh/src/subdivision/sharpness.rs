//! Which rule holds at each edge and vertex.

use super::cage::Smoothing;
use super::{Cage, Corner, Crease, CreaseMethod, INFINITELY_SHARP};
use crate::topology::Edges;

/// The sharpness of the edges and vertices of one level.
///
/// The rules are those of `Sdc::Crease` and `Sdc::Scheme` in OpenSubdiv.
pub(super) struct Sharpness<'a> {
    cage: &'a Cage,
    edges: &'a Edges,
    /// For each edge; empty without creases. The boundary is not in it.
    of_edges: Vec<f64>,
    /// The vertices at the ends of creases with the creases there, in rising order; for Chaikin's
    /// method alone.
    ends: Vec<(u32, u32)>,
    marks: Vec<Mark>,
}

/// What is known of a vertex at once.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Mark {
    /// No edge at the vertex is sharp, nor is the vertex.
    Smooth,
    /// Something is sharp.
    Sharp,
    /// The vertex lies on the boundary.
    Boundary,
}

/// The rule of a vertex.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Rule {
    /// No sharp edge, or one (a dart).
    Smooth,
    /// Two sharp edges, to these neighbours.
    Crease([u32; 2]),
    /// A sharp vertex, or more than two sharp edges.
    Corner,
}

impl<'a> Sharpness<'a> {
    pub(super) fn new(cage: &'a Cage) -> Self {
        let edges = cage.edges();
        let mut marks = vec![Mark::Smooth; cage.vertex_count()];
        for edge in 0..edges.len() as u32 {
            if edges.is_boundary(edge) {
                for end in edges.ends(edge) {
                    marks[end as usize] = Mark::Boundary;
                }
            }
        }
        let mut of_edges = Vec::new();
        if !cage.creases().is_empty() {
            of_edges.resize(edges.len(), 0.0);
            for &Crease {
                vertices: [a, b],
                sharpness,
            } in cage.creases()
            {
                if let Some(edge) = edges.between(a, b) {
                    of_edges[edge as usize] = sharpness;
                }
                for end in [a, b] {
                    marks[end as usize] = marks[end as usize].max(Mark::Sharp);
                }
            }
        }
        for corner in cage.corners() {
            let mark = &mut marks[corner.vertex as usize];
            *mark = (*mark).max(Mark::Sharp);
        }
        let mut ends = Vec::new();
        if cage.rules().creases == CreaseMethod::Chaikin {
            for (place, crease) in cage.creases().iter().enumerate() {
                ends.extend(crease.vertices.map(|end| (end, place as u32)));
            }
            ends.sort_unstable();
        }
        Self {
            cage,
            edges,
            of_edges,
            ends,
            marks,
        }
    }

    /// Whether neither a vertex nor an edge at it is sharp.
    #[inline]
    pub(super) fn is_smooth(&self, vertex: usize) -> bool {
        self.marks[vertex] == Mark::Smooth
    }

    /// How much of the rule of a crease the new vertex on an edge gets; the rest is of the smooth
    /// rule. By Chaikin's method both halves of an edge sharper than 1 may become smooth at once;
    /// OpenSubdiv then extrapolates with the sharpness, and so a share may be more than 1.
    #[inline]
    pub(super) fn of_new_vertex(&self, edge: u32) -> f64 {
        if self.of_edges.is_empty() && self.edges.sides(edge).len() == 2 {
            return 0.0;
        }
        let sharpness = self.edge(edge);
        if sharpness <= 0.0 || self.method() == CreaseMethod::Normal {
            return sharpness.clamp(0.0, 1.0);
        }
        let ends = self.edges.ends(edge);
        let stays = ends.iter().all(|&end| self.refined(edge, end) > 0.0);
        if stays { 1.0 } else { sharpness }
    }

    /// The rule of a vertex with these neighbours; and, where it changes to another at the next
    /// level, that one and how much of the present one holds.
    pub(super) fn of_vertex(&self, vertex: u32, neighbours: &[u32]) -> (Rule, Option<(Rule, f64)>) {
        let sharp: Vec<(u32, u32)> = neighbours
            .iter()
            .filter_map(|&neighbour| {
                let edge = self.edges.between(vertex, neighbour)?;
                (self.edge(edge) > 0.0).then_some((edge, neighbour))
            })
            .collect();
        let sharpness = self.vertex(vertex);
        let rule = Rule::new(sharpness, sharp.iter().map(|&(_, neighbour)| neighbour));
        if rule == Rule::Smooth {
            return (rule, None);
        }
        let refined: Vec<f64> = sharp
            .iter()
            .map(|&(edge, _)| self.refined(edge, vertex))
            .collect();
        let refined_vertex = lessened(sharpness);
        let still_sharp = sharp
            .iter()
            .zip(&refined)
            .filter(|&(_, &refined)| refined > 0.0);
        let next = Rule::new(
            refined_vertex,
            still_sharp.map(|(&(_, neighbour), _)| neighbour),
        );
        if std::mem::discriminant(&rule) == std::mem::discriminant(&next) {
            return (rule, None);
        }

        // The mean sharpness of what ceases to be sharp.
        let (mut sum, mut count) = (0.0, 0.0);
        if sharpness > 0.0 && refined_vertex <= 0.0 {
            (sum, count) = (sharpness, 1.0);
        }
        for (&(edge, _), &refined) in sharp.iter().zip(&refined) {
            if refined <= 0.0 {
                sum += self.edge(edge);
                count += 1.0;
            }
        }
        let share = if count > 0.0 {
            f64::min(sum / count, 1.0)
        } else {
            0.0
        };
        (rule, Some((next, share)))
    }

    /// Whether the edge between two neighbours is sharp.
    pub(super) fn is_sharp(&self, a: u32, b: u32) -> bool {
        let edge = self.edges.between(a, b);
        edge.is_some_and(|edge| self.edge(edge) > 0.0)
    }

    /// The creases of the next level.
    pub(super) fn refined_creases(&self) -> Vec<Crease> {
        let mut creases = Vec::with_capacity(2 * self.cage.creases().len());
        for &Crease {
            vertices: [a, b], ..
        } in self.cage.creases()
        {
            let Some(edge) = self.edges.between(a, b) else {
                continue;
            };
            let middle = self.cage.vertex_count() as u32 + edge;
            for end in [a, b] {
                let sharpness = self.refined(edge, end);
                if sharpness > 0.0 {
                    creases.push(Crease {
                        vertices: [end, middle],
                        sharpness,
                    });
                }
            }
        }
        creases.sort_unstable_by_key(|crease| crease.vertices);
        creases
    }

    /// The corners of the next level.
    pub(super) fn refined_corners(&self) -> Vec<Corner> {
        let lessened = self.cage.corners().iter().map(|corner| Corner {
            sharpness: lessened(corner.sharpness),
            ..*corner
        });
        lessened.filter(|corner| corner.sharpness > 0.0).collect()
    }

    fn method(&self) -> CreaseMethod {
        self.cage.rules().creases
    }

    fn edge(&self, edge: u32) -> f64 {
        if self.edges.is_boundary(edge) {
            return f64::INFINITY;
        }
        self.of_edges.get(edge as usize).copied().unwrap_or(0.0)
    }

    fn vertex(&self, vertex: u32) -> f64 {
        let fixed = self.cage.smoothing() == Smoothing::FixedBoundary;
        if fixed && self.marks[vertex as usize] == Mark::Boundary {
            return f64::INFINITY;
        }
        let corners = self.cage.corners();
        match corners.binary_search_by_key(&vertex, |corner| corner.vertex) {
            Ok(place) => corners[place].sharpness,
            Err(_) => 0.0,
        }
    }

    /// The sharpness that the half of an edge at one of its ends has at the next level.
    fn refined(&self, edge: u32, end: u32) -> f64 {
        let sharpness = self.edge(edge);
        if self.method() == CreaseMethod::Normal || sharpness >= INFINITELY_SHARP {
            return lessened(sharpness);
        }
        let (mut sum, mut count) = (0.0, 0.0);
        let first = self.ends.partition_point(|&(vertex, _)| vertex < end);
        let at_end = self.ends[first..]
            .iter()
            .take_while(|&&(vertex, _)| vertex == end);
        for &(_, other) in at_end {
            let other = &self.cage.creases()[other as usize];
            let semi_sharp = other.sharpness < INFINITELY_SHARP;
            if semi_sharp && self.edges.ends(edge) != other.vertices {
                sum += other.sharpness;
                count += 1.0;
            }
        }
        if count > 0.0 {
            (0.75 * sharpness + 0.25 * sum / count - 1.0).max(0.0)
        } else {
            lessened(sharpness)
        }
    }
}

impl Rule {
    /// The rule of a vertex of this sharpness with sharp edges to these neighbours.
    fn new(sharpness: f64, mut sharp: impl Iterator<Item = u32>) -> Self {
        if sharpness > 0.0 {
            return Self::Corner;
        }
        match (sharp.next(), sharp.next(), sharp.next()) {
            (_, None, _) => Self::Smooth,
            (Some(a), Some(b), None) => Self::Crease([a, b]),
            _ => Self::Corner,
        }
    }
}

/// What is left of a sharpness at the next level, by the normal method.
fn lessened(sharpness: f64) -> f64 {
    if sharpness >= INFINITELY_SHARP {
        sharpness
    } else {
        (sharpness - 1.0).max(0.0)
    }
}
