//! 4 × 4 matrices, as a textbook has them.

use ga_anim::gltf::RigidTransform;

pub(crate) type Vector = [f64; 3];
/// Row by row.
pub(crate) type Matrix = [[f64; 4]; 4];

pub(crate) const IDENTITY: Matrix = [
    [1.0, 0.0, 0.0, 0.0],
    [0.0, 1.0, 0.0, 0.0],
    [0.0, 0.0, 1.0, 0.0],
    [0.0, 0.0, 0.0, 1.0],
];

pub(crate) fn product(a: &Matrix, b: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..4).map(|k| a[i][k] * b[k][j]).sum()))
}

pub(crate) fn apply(m: &Matrix, [x, y, z]: Vector) -> Vector {
    std::array::from_fn(|i| m[i][0] * x + m[i][1] * y + m[i][2] * z + m[i][3])
}

/// By Gauss and Jordan's elimination.
pub(crate) fn inverse(m: &Matrix) -> Matrix {
    let (mut a, mut b) = (*m, IDENTITY);
    for pivot in 0..4 {
        let best = (pivot..4)
            .max_by(|&i, &j| a[i][pivot].abs().total_cmp(&a[j][pivot].abs()))
            .unwrap();
        a.swap(pivot, best);
        b.swap(pivot, best);
        let scale = 1.0 / a[pivot][pivot];
        for k in 0..4 {
            a[pivot][k] *= scale;
            b[pivot][k] *= scale;
        }
        for row in (0..4).filter(|&row| row != pivot) {
            let factor = a[row][pivot];
            for k in 0..4 {
                a[row][k] -= factor * a[pivot][k];
                b[row][k] -= factor * b[pivot][k];
            }
        }
    }
    b
}

/// The matrix of a transform; the quaternion may have any length.
pub(crate) fn matrix(transform: &RigidTransform) -> Matrix {
    let norm = transform.rotation.iter().map(|c| c * c).sum::<f64>().sqrt();
    let [x, y, z, w] = transform.rotation.map(|c| c / norm);
    let [tx, ty, tz] = transform.translation;
    [
        [
            1.0 - 2.0 * (y * y + z * z),
            2.0 * (x * y - w * z),
            2.0 * (x * z + w * y),
            tx,
        ],
        [
            2.0 * (x * y + w * z),
            1.0 - 2.0 * (x * x + z * z),
            2.0 * (y * z - w * x),
            ty,
        ],
        [
            2.0 * (x * z - w * y),
            2.0 * (y * z + w * x),
            1.0 - 2.0 * (x * x + y * y),
            tz,
        ],
        [0.0, 0.0, 0.0, 1.0],
    ]
}

pub(crate) fn assert_near(a: &[Vector], b: &[Vector], tolerance: f64) {
    assert_eq!(a.len(), b.len());
    for (vertex, (a, b)) in a.iter().zip(b).enumerate() {
        for axis in 0..3 {
            assert!(
                (a[axis] - b[axis]).abs() <= tolerance,
                "vertex {vertex}: {a:?} and {b:?}"
            );
        }
    }
}
