//! The places through which distances spread: the cells inside, then the vertices.

use ga_mesh::query::Bvh;
use ga_mesh::topology::{Edges, Neighbours};
use ga_runtime::cga3::Point;
use ga_runtime::geometry::ray::Ray;
use ga_runtime::vga3::Vector;

use super::volume::Volume;

/// Cells and vertices, and what is connected.
#[derive(Debug)]
pub(super) struct Network {
    pub(super) volume: Volume,
    /// For each vertex the cells that see it.
    cells: Vec<Vec<u32>>,
    /// For each cell the vertices that it sees.
    vertices: Vec<Vec<u32>>,
    neighbours: Option<Neighbours>,
}

impl Network {
    /// `None` for a mesh without triangles or without extent.
    pub(super) fn new(
        places: &[Vector<f64>],
        triangles: &[[u32; 3]],
        bvh: &Bvh,
        resolution: usize,
    ) -> Option<Self> {
        let volume = Volume::new(bvh, resolution)?;
        let mut vertices = vec![Vec::new(); volume.inside.len()];
        let cells: Vec<Vec<u32>> = (0..)
            .zip(places)
            .map(|(vertex, &place)| {
                let mut seeing = volume.around(place, 1);
                seeing.retain(|&cell| sees(bvh, volume.centre(cell), place));
                for &cell in &seeing {
                    vertices[cell].push(vertex);
                }
                seeing.into_iter().map(|cell| cell as u32).collect()
            })
            .collect();
        let neighbours = Edges::of_triangles(triangles, places.len())
            .ok()
            .map(|edges| Neighbours::new(&edges));
        Some(Self {
            volume,
            cells,
            vertices,
            neighbours,
        })
    }

    /// Whether there are cells inside.
    pub(super) fn has_interior(&self) -> bool {
        !self.volume.inside.is_empty()
    }

    /// How many cells there are; the vertices follow them.
    pub(super) fn cell_count(&self) -> usize {
        self.volume.inside.len()
    }

    /// How many cells and vertices there are.
    pub(super) fn len(&self) -> usize {
        self.cell_count() + self.cells.len()
    }

    /// The cells that see a vertex.
    pub(super) fn cells_of(&self, vertex: usize) -> &[u32] {
        &self.cells[vertex]
    }

    /// The vertices that a cell sees.
    pub(super) fn vertices_of(&self, cell: usize) -> &[u32] {
        &self.vertices[cell]
    }

    /// The vertices at the other ends of the edges of a vertex.
    pub(super) fn along_edges(&self, vertex: usize) -> &[u32] {
        self.neighbours
            .as_ref()
            .map_or(&[], |neighbours| neighbours.of(vertex as u32))
    }
}

/// Whether the surface is not between two places, of which the second may lie on it.
pub(super) fn sees(bvh: &Bvh, from: Vector<f64>, to: Vector<f64>) -> bool {
    match Ray::through(Point::from(from), Point::from(to)) {
        Some(ray) => !bvh.is_hit(ray, from.distance(to) * (1.0 - 1e-6)),
        None => true,
    }
}
