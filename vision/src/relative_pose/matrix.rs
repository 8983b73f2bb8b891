//! Essential and fundamental matrices: the borders between two views and algebra.

use ga_runtime::cga3::{Motor, Rotor, Translator};
use ga_runtime::vga3::Vector;
use nalgebra_035::{Matrix3, SMatrix, SVD};

/// The essential matrix `E = [t]× R` of a motion from the left camera's frame to the right one's,
/// `x_right = R x_left + t`, scaled to a sum of squares of 2: `rᵀ E l = 0` for the directions l and
/// r in which the two cameras see one point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EssentialMatrix {
    rows: [Vector<f64>; 3],
}

/// The fundamental matrix F of two views, scaled to a sum of squares of 1: `rᵀ F l = 0` for the
/// pixels `l = (u, v, 1)` and `r = (u', v', 1)` of one point. It is of rank 2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FundamentalMatrix {
    rows: [Vector<f64>; 3],
}

impl EssentialMatrix {
    /// The matrix of a motion. `None` where it has no translation or is not finite.
    #[must_use]
    pub fn from_motor(left_to_right: Motor<f64>) -> Option<Self> {
        let [r1, r2, r3] = left_to_right.rotor().to_matrix().map(Vector::from);
        let [x, y, z] = left_to_right.translator().displacement();
        Self::normalised([r3 * y - r2 * z, r1 * z - r3 * x, r2 * x - r1 * y])
    }

    /// A matrix by rows, scaled to a sum of squares of 2. `None` for zero, and where a number is
    /// not finite.
    pub(super) fn normalised(rows: [Vector<f64>; 3]) -> Option<Self> {
        scaled(rows, std::f64::consts::SQRT_2).map(|rows| Self { rows })
    }

    /// The matrix by rows.
    #[must_use]
    pub fn rows(&self) -> [[f64; 3]; 3] {
        self.rows.map(Vector::coordinates)
    }

    /// The distance to another matrix or its negative, whichever is less, as the root of the mean
    /// square of its two singular values: about the angle by which a small rotation or a small
    /// change of the direction of the translation moves it.
    pub(super) fn distance(&self, other: &Self) -> f64 {
        let square = |sign: f64| -> f64 {
            let rows = self.rows.iter().zip(&other.rows);
            rows.map(|(a, b)| (*a - *b * sign).length_squared()).sum()
        };
        (0.5 * square(1.0).min(square(-1.0))).sqrt()
    }

    /// `rᵀ E l`: zero where the rays in the directions l and r meet. It is the product of the two
    /// lines, `l ∨ r`, of which one has been moved to the frame of the other.
    #[must_use]
    pub fn residual(&self, left: Vector<f64>, right: Vector<f64>) -> f64 {
        right.dot(self.times(left))
    }

    /// `E l`: the normal of the plane of all rays of the right camera that meet a ray of the left
    /// one.
    pub(super) fn times(&self, left: Vector<f64>) -> Vector<f64> {
        times(&self.rows, left)
    }

    /// `Eᵀ r`.
    pub(super) fn transposed_times(&self, right: Vector<f64>) -> Vector<f64> {
        transposed_times(&self.rows, right)
    }

    /// The four motions with this matrix, with translations of length 1: two rotations, which
    /// differ by 180° about the line between the cameras, and both signs of the translation.
    /// `None` where the singular value decomposition fails.
    #[must_use]
    pub fn motors(&self) -> Option<[Motor<f64>; 4]> {
        let matrix = Matrix3::from_fn(|row, column| self.rows()[row][column]);
        let SVD {
            u: Some(mut u),
            v_t: Some(mut v_t),
            ..
        } = SVD::new(matrix, true, true)
        else {
            return None;
        };
        // The last columns belong to the singular value 0, and their signs are free.
        if u.determinant() < 0.0 {
            u.column_mut(2).neg_mut();
        }
        if v_t.determinant() < 0.0 {
            v_t.row_mut(2).neg_mut();
        }
        let right_angle = Matrix3::new(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0);
        let translation = [u[(0, 2)], u[(1, 2)], u[(2, 2)]];
        let motion = |quarter: Matrix3<f64>, sign: f64| {
            let rotation = u * quarter * v_t;
            let rows = [0, 1, 2].map(|r| [0, 1, 2].map(|c| rotation[(r, c)]));
            let displacement = translation.map(|x| sign * x);
            Rotor::from_matrix(rows)
                .map(|rotor| Translator::from_displacement(displacement) * rotor)
        };
        let back = right_angle.transpose();
        Some([
            motion(right_angle, 1.0)?,
            motion(right_angle, -1.0)?,
            motion(back, 1.0)?,
            motion(back, -1.0)?,
        ])
    }
}

impl FundamentalMatrix {
    /// A matrix by rows, scaled to a sum of squares of 1. `None` for zero, and where a number is
    /// not finite.
    pub(super) fn normalised(rows: [Vector<f64>; 3]) -> Option<Self> {
        scaled(rows, 1.0).map(|rows| Self { rows })
    }

    /// The nearest matrix of rank 2. `None` where the singular value decomposition fails.
    pub(super) fn of_rank_two(self) -> Option<Self> {
        let rows = self.rows();
        let matrix = Matrix3::from_fn(|row, column| rows[row][column]);
        let mut decomposed = SVD::new(matrix, true, true);
        // The singular values fall.
        decomposed.singular_values[2] = 0.0;
        let nearest = decomposed.recompose().ok()?;
        let row = |r: usize| Vector::new(nearest[(r, 0)], nearest[(r, 1)], nearest[(r, 2)]);
        Self::normalised([row(0), row(1), row(2)])
    }

    /// The matrix by rows.
    #[must_use]
    pub fn rows(&self) -> [[f64; 3]; 3] {
        self.rows.map(Vector::coordinates)
    }

    /// `rᵀ F l` over the length of its gradient by the four pixel coordinates: to first order the
    /// distance, in pixels, by which the two pixels must be moved to satisfy the epipolar condition
    /// (P. D. Sampson, "Fitting conic sections to very scattered data", 1982).
    #[must_use]
    pub fn sampson_distance(&self, left: [f64; 2], right: [f64; 2]) -> f64 {
        let [l, r] = [left, right].map(|[u, v]| Vector::new(u, v, 1.0));
        let (at_left, at_right) = (times(&self.rows, l), transposed_times(&self.rows, r));
        let gradient = [at_left.e1, at_left.e2, at_right.e1, at_right.e2];
        let square: f64 = gradient.iter().map(|x| x * x).sum();
        r.dot(at_left) / square.sqrt()
    }
}

fn times(rows: &[Vector<f64>; 3], vector: Vector<f64>) -> Vector<f64> {
    let [x, y, z] = rows.map(|row| row.dot(vector));
    Vector::new(x, y, z)
}

fn transposed_times(rows: &[Vector<f64>; 3], vector: Vector<f64>) -> Vector<f64> {
    rows[0] * vector.e1 + rows[1] * vector.e2 + rows[2] * vector.e3
}

fn scaled(rows: [Vector<f64>; 3], norm: f64) -> Option<[Vector<f64>; 3]> {
    let square: f64 = rows.iter().map(|row| row.length_squared()).sum();
    let scale = norm / square.sqrt();
    let rows = rows.map(|row| row * scale);
    (scale.is_finite() && rows.iter().all(|row| row.is_finite())).then_some(rows)
}

/// An orthonormal basis of the N-dimensional space of matrices M, by rows, with `rᵀ M l = 0` for
/// pairs of vectors l and r, or of the nearest such space for more than 9 − N pairs. `None` where
/// the decomposition fails.
pub(super) fn null_space<const N: usize>(pairs: &[[Vector<f64>; 2]]) -> Option<[[f64; 9]; N]> {
    let row = |[left, right]: &[Vector<f64>; 2]| -> [f64; 9] {
        let (l, r) = (left.coordinates(), right.coordinates());
        std::array::from_fn(|k| r[k / 3] * l[k % 3])
    };
    let v_t = if pairs.len() <= 9 {
        let mut matrix = SMatrix::<f64, 9, 9>::zeros();
        for (index, pair) in pairs.iter().enumerate() {
            for (column, value) in row(pair).into_iter().enumerate() {
                matrix[(index, column)] = value;
            }
        }
        SVD::try_new(matrix, false, true, f64::EPSILON, 200)?.v_t?
    } else {
        let rows = pairs.iter().flat_map(row);
        let matrix = nalgebra_035::DMatrix::from_row_iterator(pairs.len(), 9, rows);
        let v_t = SVD::try_new(matrix, false, true, f64::EPSILON, 200)?.v_t?;
        SMatrix::from_fn(|r, c| v_t[(r, c)])
    };
    Some(std::array::from_fn(|n| {
        std::array::from_fn(|k| v_t[(9 - N + n, k)])
    }))
}
