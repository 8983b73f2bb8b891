//! A triangle mesh prepared for cutting: only faces with area, and who lies across each side.

use crate::places::first_of_equal;
use crate::topology::Edges;
use crate::{MeshError, TextureSpaceError, bounds};

pub(super) type Vector = ga_runtime::vga3::Vector<f64>;

/// No face, no side.
pub(super) const NONE: u32 = u32::MAX;

/// A face whose height is below this part of its longest side is degenerate.
const FLATTEST: f64 = 1e-9;

/// The faces that have an area, in a unit in which the mesh has size 1.
pub(super) struct Surface {
    pub(super) positions: Vec<Vector>,
    pub(super) triangles: Vec<[u32; 3]>,
    /// For each side (three a face), the side of the neighbouring face that lies on the same edge;
    /// [`NONE`] at the boundary, where more than two faces meet, and where the orientations of the
    /// two faces differ.
    pub(super) across: Vec<u32>,
    /// Unit normals of the faces.
    pub(super) normals: Vec<Vector>,
    pub(super) areas: Vec<f64>,
    /// The centroids of the faces.
    pub(super) centres: Vec<Vector>,
    /// For each face, its number in the mesh.
    pub(super) originals: Vec<u32>,
}

impl Surface {
    pub(super) fn new(
        positions: &[[f64; 3]],
        triangles: &[[u32; 3]],
    ) -> Result<Self, TextureSpaceError> {
        check(positions, triangles)?;
        let positions = normalized(positions);
        let representative = first_of_equal(positions.iter().map(|p| p.coordinates()));

        let mut surface = Self {
            positions,
            triangles: Vec::with_capacity(triangles.len()),
            across: Vec::new(),
            normals: Vec::with_capacity(triangles.len()),
            areas: Vec::with_capacity(triangles.len()),
            centres: Vec::with_capacity(triangles.len()),
            originals: Vec::with_capacity(triangles.len()),
        };
        for (face, triangle) in triangles.iter().enumerate() {
            let triangle = triangle.map(|vertex| representative[vertex as usize]);
            let [a, b, c] = triangle.map(|vertex| surface.positions[vertex as usize]);
            let double = (b - a).cross(c - a);
            let longest = [b - a, c - b, a - c]
                .map(Vector::length_squared)
                .into_iter()
                .fold(0.0, f64::max);
            let length = double.length();
            if !(length > FLATTEST * longest && length > 0.0) {
                continue;
            }
            surface.triangles.push(triangle);
            surface.normals.push(double * (1.0 / length));
            surface.areas.push(0.5 * length);
            surface.centres.push((a + b + c) * (1.0 / 3.0));
            surface.originals.push(face as u32);
        }
        if surface.triangles.is_empty() {
            let faces = triangles.len();
            return Err(TextureSpaceError::NoArea { faces });
        }
        surface.across = across(&surface.triangles, surface.positions.len())?;
        Ok(surface)
    }

    pub(super) fn len(&self) -> usize {
        self.triangles.len()
    }

    /// The neighbours of a face.
    pub(super) fn neighbours(&self, face: u32) -> impl Iterator<Item = u32> + '_ {
        let first = 3 * face as usize;
        let sides = self.across[first..first + 3].iter();
        sides.filter(|&&side| side != NONE).map(|side| side / 3)
    }

    /// For each face, the mean direction of its vector and those of its neighbours.
    pub(super) fn smoothed(&self, vectors: &[Vector]) -> Vec<Vector> {
        let mean = |face: usize| {
            let beside = self.neighbours(face as u32);
            let sum = beside.fold(vectors[face], |sum, beside| sum + vectors[beside as usize]);
            sum.normalized().unwrap_or(vectors[face])
        };
        (0..self.len()).map(mean).collect()
    }

    /// The ends of a side.
    pub(super) fn side(&self, side: u32) -> [Vector; 2] {
        let triangle = self.triangles[side as usize / 3];
        let corner = side as usize % 3;
        [corner, (corner + 1) % 3].map(|corner| self.positions[triangle[corner] as usize])
    }

    /// The corners of a face.
    pub(super) fn corners(&self, face: u32) -> [Vector; 3] {
        self.triangles[face as usize].map(|vertex| self.positions[vertex as usize])
    }
}

fn check(positions: &[[f64; 3]], triangles: &[[u32; 3]]) -> Result<(), TextureSpaceError> {
    let vertices = positions.len();
    for (what, count) in [("vertices", vertices), ("corners", 3 * triangles.len())] {
        if count >= NONE as usize {
            return Err(TextureSpaceError::TooLarge { what, count });
        }
    }
    if triangles.is_empty() {
        return Err(TextureSpaceError::NoFaces);
    }
    let finite = |position: &[f64; 3]| position.iter().all(|x| x.is_finite());
    if let Some(vertex) = positions.iter().position(|position| !finite(position)) {
        return Err(TextureSpaceError::NotFinite { vertex });
    }
    for (face, triangle) in triangles.iter().enumerate() {
        if let Some(&index) = triangle.iter().find(|&&index| index as usize >= vertices) {
            return Err(TextureSpaceError::IndexOutOfRange {
                face,
                index,
                vertices,
            });
        }
    }
    Ok(())
}

/// The positions moved and scaled into the cube from −1 to 1, so that squares of lengths neither
/// overflow nor vanish.
fn normalized(positions: &[[f64; 3]]) -> Vec<Vector> {
    let points = positions.iter().copied().map(Vector::from);
    let [low, high] = bounds(points).unwrap_or_default();
    // Halves first: the sum and the difference of two large numbers may overflow.
    let centre: [f64; 3] = std::array::from_fn(|axis| 0.5 * low[axis] + 0.5 * high[axis]);
    let reach = (0..3)
        .map(|axis| 0.5 * high[axis] - 0.5 * low[axis])
        .fold(0.0, f64::max);
    let reach = if reach > 0.0 { reach } else { 1.0 };
    let scaled = |position: &[f64; 3]| {
        let [x, y, z] = std::array::from_fn(|axis| (position[axis] - centre[axis]) / reach);
        Vector::new(x, y, z)
    };
    positions.iter().map(scaled).collect()
}

fn across(triangles: &[[u32; 3]], vertices: usize) -> Result<Vec<u32>, TextureSpaceError> {
    let edges = Edges::of_triangles(triangles, vertices).map_err(|error| match error {
        MeshError::TooLarge { what, count } => TextureSpaceError::TooLarge { what, count },
        _ => TextureSpaceError::NoFaces,
    })?;
    let start = |side: u32| triangles[side as usize / 3][side as usize % 3];
    let mut across = vec![NONE; 3 * triangles.len()];
    for edge in 0..edges.len() as u32 {
        if let &[a, b] = edges.sides(edge)
            && start(a) != start(b)
            && a / 3 != b / 3
        {
            across[a as usize] = b;
            across[b as usize] = a;
        }
    }
    Ok(across)
}
