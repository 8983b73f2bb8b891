//! Joining neighbouring charts whose union still projects well.

use rustc_hash::FxHashMap;

use super::Vector;
use super::surface::{NONE, Surface};

/// The cosine of the largest angle between a face of a union and the mean normal: 62°.
const CONE: f64 = 0.47;

/// The greatest L2 stretch of the projection of a union.
const STRETCH: f64 = 1.06;

/// Joins charts, the smallest first, each with the neighbour that it shares the longest border
/// with. A chart that is joined keeps the number of the other.
pub(super) fn merge(surface: &Surface, normals: &[Vector], chart_of: &mut [u32], charts: usize) {
    let mut union = Union::new(surface, normals, chart_of, charts);
    let mut order: Vec<u32> = (0..charts as u32).collect();
    order.sort_by(|&a, &b| {
        let area = |chart: u32| union.areas[chart as usize];
        area(a).total_cmp(&area(b)).then(a.cmp(&b))
    });
    let mut changed = true;
    while std::mem::take(&mut changed) {
        for &chart in &order {
            while !union.faces[chart as usize].is_empty() {
                let Some(partner) = union.partner(chart) else {
                    break;
                };
                union.join(chart, partner);
                changed = true;
            }
        }
    }
    for (chart, faces) in union.faces.iter().enumerate() {
        for &face in faces {
            chart_of[face as usize] = chart as u32;
        }
    }
}

struct Union<'a> {
    surface: &'a Surface,
    normals: &'a [Vector],
    faces: Vec<Vec<u32>>,
    /// Sums of normals times areas.
    sums: Vec<Vector>,
    areas: Vec<f64>,
    /// The lengths of the borders with each neighbour.
    borders: Vec<FxHashMap<u32, f64>>,
}

impl<'a> Union<'a> {
    fn new(surface: &'a Surface, normals: &'a [Vector], chart_of: &[u32], charts: usize) -> Self {
        let mut union = Self {
            surface,
            normals,
            faces: vec![Vec::new(); charts],
            sums: vec![Vector::default(); charts],
            areas: vec![0.0; charts],
            borders: vec![FxHashMap::default(); charts],
        };
        for (face, &chart) in chart_of.iter().enumerate() {
            if chart == NONE {
                continue;
            }
            let area = surface.areas[face];
            union.faces[chart as usize].push(face as u32);
            union.sums[chart as usize] += normals[face] * area;
            union.areas[chart as usize] += area;
            for side in 3 * face as u32..3 * face as u32 + 3 {
                let other = surface.across[side as usize];
                if other == NONE {
                    continue;
                }
                let beside = chart_of[other as usize / 3];
                if beside != NONE && beside != chart {
                    let [a, b] = surface.side(side);
                    let border = union.borders[chart as usize].entry(beside).or_default();
                    *border += a.distance(b);
                }
            }
        }
        union
    }

    /// The neighbour with the longest common border among those with which the union projects
    /// well.
    fn partner(&self, chart: u32) -> Option<u32> {
        let mut neighbours: Vec<(u32, f64)> = self.borders[chart as usize]
            .iter()
            .map(|(&beside, &length)| (beside, length))
            .collect();
        neighbours.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
        let allowed = |&(beside, _): &(u32, f64)| self.projects([chart, beside]);
        neighbours
            .into_iter()
            .find(allowed)
            .map(|(beside, _)| beside)
    }

    fn projects(&self, pair: [u32; 2]) -> bool {
        let sum = self.sums[pair[0] as usize] + self.sums[pair[1] as usize];
        let Some(axis) = sum.normalized() else {
            return false;
        };
        let mut stretched = 0.0;
        for chart in pair {
            for &face in &self.faces[chart as usize] {
                let cosine = self.normals[face as usize].dot(axis);
                if cosine < CONE {
                    return false;
                }
                let squared = 0.5 * (1.0 + 1.0 / (cosine * cosine));
                stretched += self.surface.areas[face as usize] * squared;
            }
        }
        // The projected area is the component of the sum along the axis.
        let area = self.areas[pair[0] as usize] + self.areas[pair[1] as usize];
        stretched * sum.dot(axis) <= STRETCH * STRETCH * area * area
    }

    /// Adds `chart` to `other`.
    fn join(&mut self, chart: u32, other: u32) {
        let (from, to) = (chart as usize, other as usize);
        let faces = std::mem::take(&mut self.faces[from]);
        self.faces[to].extend(faces);
        let sum = self.sums[from];
        self.sums[to] += sum;
        self.areas[to] += std::mem::take(&mut self.areas[from]);
        let borders = std::mem::take(&mut self.borders[from]);
        self.borders[to].remove(&chart);
        for (beside, length) in borders {
            if beside == other {
                continue;
            }
            *self.borders[to].entry(beside).or_default() += length;
            let back = &mut self.borders[beside as usize];
            if let Some(length) = back.remove(&chart) {
                *back.entry(other).or_default() += length;
            }
        }
    }
}
