//! Small meshes, and the steps that all tests repeat.

use ga_mesh::Faces;
use ga_mesh::subdivision::{Cage, Corner, Crease, Rules, Tags};

/// Positions and polygons.
#[derive(Clone, Debug)]
pub(crate) struct Shape {
    pub(crate) positions: Vec<[f64; 3]>,
    pub(crate) faces: Vec<Vec<u32>>,
}

impl Shape {
    pub(crate) fn new<P: AsRef<[u32]>>(positions: &[[f64; 3]], faces: &[P]) -> Self {
        Self {
            positions: positions.to_vec(),
            faces: faces.iter().map(|face| face.as_ref().to_vec()).collect(),
        }
    }

    pub(crate) fn faces(&self) -> Faces {
        Faces::from_polygons(&self.faces).unwrap()
    }

    pub(crate) fn cage(&self, rules: Rules, tags: &Tags) -> Cage {
        let cage = Cage::new(self.faces(), self.positions.len(), rules).unwrap();
        cage.with_tags(tags).unwrap()
    }

    /// The same with every polygon split into triangles.
    pub(crate) fn triangulated(&self) -> Self {
        let triangles = self.faces().triangles(&self.positions);
        Self::new(&self.positions, &triangles)
    }
}

/// The faces and positions after some levels, applying the stencils of one level after another.
pub(crate) fn refine(
    shape: &Shape,
    rules: Rules,
    tags: &Tags,
    levels: usize,
) -> (Cage, Vec<[f64; 3]>) {
    let (mut cage, mut positions) = (shape.cage(rules, tags), shape.positions.clone());
    for _ in 0..levels {
        let fine = cage.refine().unwrap();
        positions = fine.stencils.applied(&positions).unwrap();
        cage = fine.cage;
    }
    (cage, positions)
}

pub(crate) fn crease(a: u32, b: u32, sharpness: f64) -> Crease {
    Crease {
        vertices: [a, b],
        sharpness,
    }
}

pub(crate) fn corner(vertex: u32, sharpness: f64) -> Corner {
    Corner { vertex, sharpness }
}

/// The cube from −1 to 1; vertex number and coordinates have the same bits, x lowest.
pub(crate) fn cube() -> Shape {
    let position = |v: u32| [0, 1, 2].map(|axis| f64::from(v >> axis & 1) * 2.0 - 1.0);
    let faces = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    Shape::new(
        &std::array::from_fn::<_, 8, _>(|v| position(v as u32)),
        &faces,
    )
}

/// The edges of a shape, the lower vertex first.
pub(crate) fn edges(shape: &Shape) -> Vec<[u32; 2]> {
    let mut edges = Vec::new();
    for face in &shape.faces {
        for (place, &from) in face.iter().enumerate() {
            let to = face[(place + 1) % face.len()];
            edges.push([from.min(to), from.max(to)]);
        }
    }
    edges.sort_unstable();
    edges.dedup();
    edges
}

/// Quadrilaterals in `rows` rows of `columns`, on a curved surface.
pub(crate) fn grid(columns: u32, rows: u32) -> Shape {
    let vertex = |column, row| row * (columns + 1) + column;
    let mut positions = Vec::new();
    for row in 0..=rows {
        for column in 0..=columns {
            let (x, y) = (f64::from(column), f64::from(row));
            positions.push([
                x + 0.1 * y * y,
                y - 0.07 * x * y,
                0.2 * (x * 1.3).sin() - 0.1 * y * x,
            ]);
        }
    }
    let mut faces = Vec::new();
    for row in 0..rows {
        for column in 0..columns {
            faces.push([
                vertex(column, row),
                vertex(column + 1, row),
                vertex(column + 1, row + 1),
                vertex(column, row + 1),
            ]);
        }
    }
    Shape::new(&positions, &faces)
}

/// A ring of quadrilaterals around an apex, with the apex as the last vertex: `sides` triangles
/// inside, as many quadrilaterals around them.
pub(crate) fn umbrella(sides: u32) -> Shape {
    let mut positions = Vec::new();
    for (radius, height) in [(1.0, 0.4), (2.2, -0.3)] {
        for side in 0..sides {
            let angle = std::f64::consts::TAU * f64::from(side) / f64::from(sides) + 0.2;
            let wave = 0.15 * f64::from(side % 3);
            positions.push([
                radius * angle.cos() + wave,
                radius * angle.sin(),
                height - wave,
            ]);
        }
    }
    positions.push([0.1, -0.05, 1.0]);
    let mut faces = Vec::new();
    for side in 0..sides {
        let next = (side + 1) % sides;
        faces.push(vec![side, next, 2 * sides]);
        faces.push(vec![side, side + sides, next + sides, next]);
    }
    Shape::new(&positions, &faces)
}

pub(crate) fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    let difference = [0, 1, 2].map(|axis| a[axis] - b[axis]);
    difference.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// The points agree one by one.
#[track_caller]
pub(crate) fn assert_close(found: &[[f64; 3]], expected: &[[f64; 3]], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    for (place, (&found, &expected)) in found.iter().zip(expected).enumerate() {
        let far = distance(found, expected);
        assert!(
            far <= tolerance,
            "point {place}: {found:?}, not {expected:?}"
        );
    }
}
