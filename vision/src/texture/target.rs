//! The surface that is textured: triangles with their places in the texture, and charts.

use std::collections::HashMap;

use crate::texture::TextureError;
use ga_mesh::atlas::{self, Options};
use ga_mesh::normals::area_vector;
use ga_mesh::query::Bvh;
use ga_mesh::topology::Edges;
use ga_mesh::{Mesh, MeshAtlas};
use ga_runtime::vga3::Vector;

/// A mesh with an atlas, and what the projection of views needs of it.
pub(super) struct Target {
    /// The mesh, with the coordinates of the atlas as its first set.
    pub(super) mesh: Mesh,
    /// Whether the atlas was made here.
    pub(super) unwrapped: bool,
    pub(super) report: atlas::Report,
    pub(super) positions: Vec<Vector<f64>>,
    pub(super) triangles: Vec<[u32; 3]>,
    /// The texture coordinates of the corners of each triangle.
    pub(super) coordinates: Vec<[[f64; 2]; 3]>,
    /// The unit normal of each triangle; zero for a degenerate one.
    pub(super) normals: Vec<Vector<f64>>,
    /// The chart of each triangle.
    pub(super) charts: Vec<u32>,
    pub(super) chart_count: usize,
    /// How long the side of the texture would be on the surface, in each chart on average.
    pub(super) chart_sides: Vec<f64>,
    pub(super) seams: Vec<Seam>,
    pub(super) bvh: Bvh,
}

/// An edge of the surface that has two different images in the texture: those of its ends, in the
/// same order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Seam {
    pub(super) sides: [[[f64; 2]; 2]; 2],
}

impl Target {
    /// The mesh with its own coordinates where every corner has one, otherwise, or if `unwrap` says
    /// so, with those of a new atlas.
    pub(super) fn new(mesh: &Mesh, options: &Options, unwrap: bool) -> Result<Self, TextureError> {
        let places: Vec<[f64; 3]> = mesh.coordinates().collect();
        let triangles = mesh.triangles();
        if triangles.is_empty() {
            return Err(TextureError::NoTriangles);
        }
        // Others have chosen the margins of its own coordinates.
        let MeshAtlas {
            mesh: placed,
            coordinates,
            report,
            is_new,
        } = MeshAtlas::new(mesh, options, unwrap, 0)?;
        let positions: Vec<Vector<f64>> = places.iter().copied().map(Vector::from).collect();
        let corners = |t: &[u32; 3]| t.map(|vertex| positions[vertex as usize]);
        let normal = |t: &[u32; 3]| area_vector(corners(t)).normalized().unwrap_or_default();
        let normals: Vec<Vector<f64>> = triangles.iter().map(normal).collect();
        if normals.iter().all(|normal| *normal == Vector::ZERO) {
            return Err(TextureError::NoTriangles);
        }
        let (charts, chart_count, seams) = charts(&places, &triangles, &coordinates)?;
        let mut areas = vec![[0.0; 2]; chart_count];
        for ((&chart, triangle), [a, b, c]) in charts.iter().zip(&triangles).zip(&coordinates) {
            let [on_surface, in_texture] = &mut areas[chart as usize];
            *on_surface += area_vector(corners(triangle)).length();
            *in_texture += ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).abs();
        }
        let side = |[on_surface, in_texture]: [f64; 2]| (on_surface / in_texture).sqrt();
        Ok(Self {
            mesh: if is_new { placed } else { mesh.clone() },
            unwrapped: is_new,
            report,
            bvh: Bvh::new(&places, &triangles)?,
            positions,
            triangles,
            coordinates,
            normals,
            charts,
            chart_count,
            chart_sides: areas.into_iter().map(side).collect(),
            seams,
        })
    }

    /// The corners of each triangle.
    pub(super) fn corners(&self) -> impl Iterator<Item = [Vector<f64>; 3]> + '_ {
        let corner = |vertex: u32| self.positions[vertex as usize];
        self.triangles.iter().map(move |t| t.map(corner))
    }
}

/// The chart of each triangle, their number, and the seams between charts. Triangles with a common
/// edge are in one chart where their coordinates agree at it. Positions that are equal are one
/// vertex.
fn charts(
    positions: &[[f64; 3]],
    triangles: &[[u32; 3]],
    coordinates: &[[[f64; 2]; 3]],
) -> Result<(Vec<u32>, usize, Vec<Seam>), TextureError> {
    let mut numbers = HashMap::new();
    let first: Vec<u32> = (0..)
        .zip(positions)
        .map(|(vertex, place)| {
            // Adding zero makes the two zeros equal.
            let key = place.map(|x| (x + 0.0).to_bits());
            *numbers.entry(key).or_insert(vertex)
        })
        .collect();
    let merged: Vec<[u32; 3]> = triangles
        .iter()
        .map(|t| t.map(|vertex| first[vertex as usize]))
        .collect();
    let edges = Edges::of_triangles(&merged, positions.len())?;
    let image = |side: u32| {
        let (triangle, corner) = (side as usize / 3, side as usize % 3);
        let next = (corner + 1) % 3;
        let ends = [corner, next].map(|corner| coordinates[triangle][corner]);
        let [from, to] = [corner, next].map(|corner| merged[triangle][corner]);
        if from < to { ends } else { [ends[1], ends[0]] }
    };
    let mut seams = Vec::new();
    let mut joined: Vec<Vec<u32>> = vec![Vec::new(); triangles.len()];
    for edge in 0..edges.len() as u32 {
        let [from, to] = edges.ends(edge);
        if from == to {
            continue;
        }
        for pair in edges.sides(edge).windows(2) {
            let sides = [image(pair[0]), image(pair[1])];
            if sides[0] == sides[1] {
                let [a, b] = [pair[0] / 3, pair[1] / 3];
                joined[a as usize].push(b);
                joined[b as usize].push(a);
            } else {
                seams.push(Seam { sides });
            }
        }
    }
    const NONE: u32 = u32::MAX;
    let mut charts = vec![NONE; triangles.len()];
    let mut count = 0;
    let mut next = Vec::new();
    for seed in 0..triangles.len() {
        if charts[seed] != NONE {
            continue;
        }
        charts[seed] = count;
        next.push(seed as u32);
        while let Some(triangle) = next.pop() {
            for &other in &joined[triangle as usize] {
                if charts[other as usize] == NONE {
                    charts[other as usize] = count;
                    next.push(other);
                }
            }
        }
        count += 1;
    }
    Ok((charts, count as usize, seams))
}
