//! The vertices of a primitive in the world.

use ga_runtime::vga3::Vector;

use super::super::{Document, Node, Primitive, Transform, hierarchy};
use crate::FormatError;

/// The upper three rows of a 4 × 4 matrix.
type Matrix = [[f64; 4]; 3];

/// The vertices of a primitive in the world, and directions at them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Placed {
    /// The places of the vertices.
    pub positions: Vec<[f64; 3]>,
    /// Unit normals, empty where the primitive has none; zero where a vertex has none.
    pub normals: Vec<Vector<f64>>,
    /// Unit tangents, empty where the primitive has none; zero where a vertex has none.
    pub tangents: Vec<Vector<f64>>,
    /// Whether the vertices are mirrored, so that faces must be reversed.
    pub is_mirrored: bool,
}

/// The transforms of a document's nodes and joints.
pub(super) struct World<'a> {
    document: &'a Document,
    nodes: Vec<Matrix>,
}

impl<'a> World<'a> {
    pub(super) fn new(document: &'a Document) -> Result<Self, FormatError> {
        let nodes = document.world_matrices()?;
        Ok(Self { document, nodes })
    }

    /// The vertices of a primitive of the mesh of a node.
    pub(super) fn place(&self, index: usize, node: &Node, primitive: &Primitive) -> Placed {
        let weights = self.weights(node);
        let positions = morph(&primitive.positions, weights, |t| {
            &primitive.targets[t].positions
        });
        let normals = morph(&primitive.normals, weights, |t| {
            &primitive.targets[t].normals
        });
        let plain: Vec<[f32; 3]> = primitive
            .tangents
            .iter()
            .map(|&[x, y, z, _]| [x, y, z])
            .collect();
        let tangents = morph(&plain, weights, |t| &primitive.targets[t].tangents);
        let palette = node.skin.map(|skin| self.palette(skin));
        let matrix = |vertex: usize| match &palette {
            Some(palette) => blend(palette, primitive, vertex),
            None => self.nodes[index],
        };
        let linear = |vertex: usize| Linear::new(&matrix(vertex));
        let numbered = |list: Vec<[f64; 3]>| list.into_iter().enumerate();
        Placed {
            is_mirrored: primitive.vertex_count() > 0 && linear(0).determinant < 0.0,
            positions: numbered(positions)
                .map(|(v, p)| point(&matrix(v), p))
                .collect(),
            normals: numbered(normals)
                .map(|(v, n)| linear(v).normal(n))
                .collect(),
            tangents: numbered(tangents)
                .map(|(v, t)| linear(v).tangent(t))
                .collect(),
        }
    }

    /// The weights of the morph targets of a node's mesh.
    fn weights(&self, node: &'a Node) -> &'a [f32] {
        let of_mesh = node.mesh.map(|mesh| &self.document.meshes[mesh].weights);
        node.weights
            .as_ref()
            .or(of_mesh)
            .map_or(&[], |weights| weights)
    }

    /// For each joint of a skin, the matrix that takes the mesh at rest to the world.
    fn palette(&self, skin: usize) -> Vec<Matrix> {
        let skin = &self.document.skins[skin];
        let joints = skin.joints.iter().enumerate();
        joints
            .map(
                |(index, &joint)| match skin.inverse_bind_matrices.get(index) {
                    Some(&inverse) => {
                        let inverse = Transform::Matrix(inverse).to_matrix();
                        hierarchy::product(&self.nodes[joint], &inverse)
                    }
                    None => self.nodes[joint],
                },
            )
            .collect()
    }
}

/// Vectors with the displacements of morph targets: p + Σ wᵢ dᵢ.
fn morph<'a>(
    base: &[[f32; 3]],
    weights: &[f32],
    deltas: impl Fn(usize) -> &'a [[f32; 3]],
) -> Vec<[f64; 3]> {
    let mut sums: Vec<[f64; 3]> = base.iter().map(|vector| vector.map(f64::from)).collect();
    for (target, &weight) in weights.iter().enumerate() {
        for (sum, delta) in sums.iter_mut().zip(deltas(target)) {
            for axis in 0..3 {
                sum[axis] += f64::from(weight) * f64::from(delta[axis]);
            }
        }
    }
    sums
}

/// The mean of the joints' matrices, weighted by their influence on a vertex.
fn blend(palette: &[Matrix], primitive: &Primitive, vertex: usize) -> Matrix {
    let mut sum = [[0.0; 4]; 3];
    let mut total = 0.0;
    for (joints, weights) in primitive.joints.iter().zip(&primitive.weights) {
        for (joint, weight) in joints[vertex].into_iter().zip(weights[vertex]) {
            let (matrix, weight) = (&palette[usize::from(joint)], f64::from(weight));
            total += weight;
            for (sum, row) in sum.iter_mut().zip(matrix) {
                for (sum, entry) in sum.iter_mut().zip(row) {
                    *sum += weight * entry;
                }
            }
        }
    }
    sum.map(|row| row.map(|entry| entry / total))
}

fn point(matrix: &Matrix, [x, y, z]: [f64; 3]) -> [f64; 3] {
    matrix.map(|[a, b, c, d]| a * x + b * y + c * z + d)
}

/// What a matrix does to directions.
struct Linear {
    rows: [Vector<f64>; 3],
    /// The rows of the cofactors: the inverse transpose times the determinant.
    cofactors: [Vector<f64>; 3],
    determinant: f64,
}

impl Linear {
    fn new(matrix: &Matrix) -> Self {
        let [a, b, c] = matrix.map(|[x, y, z, _]| Vector::new(x, y, z));
        let cofactors = [b.cross(c), c.cross(a), a.cross(b)];
        Self {
            determinant: a.dot(cofactors[0]),
            rows: [a, b, c],
            cofactors,
        }
    }

    fn normal(&self, normal: [f64; 3]) -> Vector<f64> {
        let image = apply(self.cofactors, normal);
        unit(if self.determinant < 0.0 {
            -image
        } else {
            image
        })
    }

    fn tangent(&self, tangent: [f64; 3]) -> Vector<f64> {
        unit(apply(self.rows, tangent))
    }
}

fn apply(rows: [Vector<f64>; 3], vector: [f64; 3]) -> Vector<f64> {
    let vector = Vector::from(vector);
    rows.map(|row| row.dot(vector)).into()
}

/// The vector with length 1, or zero.
fn unit(vector: Vector<f64>) -> Vector<f64> {
    vector.normalized().unwrap_or_default()
}
