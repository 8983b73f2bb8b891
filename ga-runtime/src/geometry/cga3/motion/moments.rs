//! The rotation of well-spread pairs of vectors, from sums over one pass.

use crate::cga3::Rotor;
use crate::geometry::cga3::matrix::{Matrix, solve};
use crate::geometry::number::is_regular;
use crate::scalar::{Real, Ring};
use crate::vga3::Vector;

/// Sums over weighted pairs of vectors x and y, with the squares of both together for N = 1, where
/// they are about equally long, and apart for N = 2.
#[derive(Clone, Copy)]
pub(super) struct Moments<S, const N: usize> {
    /// `Σ w`.
    pub(super) total: S,
    /// `Σ w x` and `Σ w y`.
    pub(super) sums: [Vector<S>; 2],
    /// `Σ w x yᵀ`.
    products: Matrix<S, 3>,
    /// `Σ w x²` and `Σ w y²`, or their sum.
    squares: [S; N],
}

impl<S: Real<Mask = bool>, const N: usize> Moments<S, N> {
    /// The sums of pairs, given `Σ w` where it is known; `None` where a weight is negative. Numbers
    /// that are not finite give sums that are not.
    #[inline]
    pub(super) fn of(
        pairs: impl Iterator<Item = (S, Vector<S>, Vector<S>)>,
        known_total: Option<S>,
    ) -> Option<Self> {
        let zero = S::zero();
        let mut total = zero;
        let mut sums = [Vector::default(); 2];
        let mut products = [[zero; 3]; 3];
        // Component by component, so that vector registers are added up only at the end.
        let mut squares = [Vector::default(); N];
        let mut is_negative = false;
        for (weight, x, y) in pairs {
            is_negative |= weight.less_than(zero);
            total += weight;
            let (wx, wy) = (x * weight, y * weight);
            sums[0] += wx;
            sums[1] += wy;
            for (row, a) in products.iter_mut().zip(wx.coordinates()) {
                for (entry, b) in row.iter_mut().zip(y.coordinates()) {
                    *entry = a.mul_add(b, *entry);
                }
            }
            squares[0] += wx.component_product(x);
            squares[N - 1] += wy.component_product(y);
        }
        (!is_negative).then_some(Self {
            total: known_total.unwrap_or(total),
            sums,
            products,
            squares: squares.map(|square| square.e1 + square.e2 + square.e3),
        })
    }

    /// The moments about the means; `None` where the means are so far from the origin that digits
    /// would be lost.
    #[inline]
    pub(super) fn about_means(mut self) -> Option<Self> {
        let means = self.sums.map(|sum| sum.divided(self.total));
        for (row, a) in self.products.iter_mut().zip(means[0].coordinates()) {
            for (entry, b) in row.iter_mut().zip(self.sums[1].coordinates()) {
                *entry = a.neg_mul_add(b, *entry);
            }
        }
        let about_origin = self.squares;
        self.squares[0] -= means[0].dot(self.sums[0]);
        self.squares[N - 1] -= means[1].dot(self.sums[1]);
        let most = S::from_integer(16);
        let mut squares = about_origin.into_iter().zip(self.squares);
        squares
            .all(|(origin, mean)| origin.less_than(mean * most))
            .then_some(self)
    }

    /// The rotor R for which `Σ w |y − s R x|²` is least, of non-negative scalar part, and the
    /// factor `s = Σ w y·R x / Σ w x²`, which is exact for N = 2 only; `None` where the sums are
    /// not finite, or where the vectors are too close to a line, or to several equally good
    /// rotations, for the sums to fix R to the accuracy of the scalar.
    ///
    /// With the moments divided by `√(Σ w x² Σ w y²)`, or by half the sum of both squares, the
    /// largest eigenvalue λ of Horn's matrix K is at most 1, and Newton's method from there finds
    /// it as a root of the characteristic polynomial (Theobald, Rapid calculation of RMSDs using a
    /// quaternion-based characteristic polynomial, Acta Crystallographica A 61, 2005). Each column
    /// of the adjugate of `K − λ` is a multiple of the quaternion of R. One Newton step for R
    /// follows.
    pub(super) fn rotation(&self) -> Option<(Rotor<S>, S)> {
        let [x_square, y_square] = if N == 1 {
            [self.squares[0] * S::from_ratio(1, 2); 2]
        } else {
            [self.squares[0], self.squares[N - 1]]
        };
        if !(is_regular(self.total) && is_regular(x_square) && is_regular(y_square)) {
            return None;
        }
        let [x_size, y_size] = [x_square.sqrt(), y_square.sqrt()];
        let inverse = (x_size * y_size).recip();
        let moments = self.products.map(|row| row.map(|entry| entry * inverse));
        let [w, x, y, z] = quaternion(moments)?;
        let (rotor, trace) = improved(Rotor::from_quaternion([x, y, z], w)?, moments)?;
        Some((rotor, trace * (y_size / x_size)))
    }
}

/// Horn's symmetric matrix of the moments `Σ w x yᵀ`: `Σ w y·R x` is the value of its quadratic
/// form at the quaternion (w, x, y, z) of R.
pub(in super::super) fn horn<S: Real>(moments: Matrix<S, 3>) -> Matrix<S, 4> {
    let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = moments;
    [
        [xx + yy + zz, yz - zy, zx - xz, xy - yx],
        [yz - zy, xx - yy - zz, xy + yx, zx + xz],
        [zx - xz, xy + yx, yy - xx - zz, yz + zy],
        [xy - yx, zx + xz, yz + zy, zz - xx - yy],
    ]
}

/// A multiple of the eigenvector of the largest eigenvalue of Horn's matrix, which is at most 1;
/// `None` where the eigenvalue is close to another one.
fn quaternion<S: Real<Mask = bool>>(moments: Matrix<S, 3>) -> Option<[S; 4]> {
    const MOST_STEPS: usize = 20;
    // The least product of the distances of the eigenvalue from the others, which is the slope.
    let least_slope = S::from_ratio(1, 10);
    let done = S::epsilon() * S::from_integer(256);
    let mut k = horn(moments);
    // The characteristic polynomial is λ⁴ + c2 λ² + c1 λ + c0.
    let two = S::from_integer(2);
    let [x, y, z] = moments.map(Vector::from);
    let c2 = -two * (x.dot(x) + y.dot(y) + z.dot(z));
    let c1 = -S::from_integer(8) * x.cross(y).dot(z);
    let c0 = Minors::of(k).determinant();
    let (mut root, mut slope) = (S::one(), S::zero());
    for _ in 0..MOST_STEPS {
        let inner = root.mul_add(root, c2) * root;
        let value = (inner + c1).mul_add(root, c0);
        slope = (two * root * root).mul_add(root, inner + inner + c1);
        let step = value / slope;
        root -= step;
        if step.abs().less_than(done) {
            break;
        }
    }
    if !least_slope.less_than(slope) {
        return None;
    }
    for (place, row) in k.iter_mut().enumerate() {
        row[place] -= root;
    }
    let columns = Minors::of(k).adjugate(k);
    let mut best = 0;
    for place in 1..4 {
        if columns[best][best]
            .abs()
            .less_than(columns[place][place].abs())
        {
            best = place;
        }
    }
    // The adjugate is a negative multiple of the square: this makes the largest component positive.
    Some(columns[best].map(|entry| -entry))
}

/// The 2×2 minors of the first two rows and of the last two rows of a 4×4 matrix.
struct Minors<S> {
    upper: [S; 6],
    lower: [S; 6],
}

impl<S: Ring> Minors<S> {
    fn of([a, b, c, d]: Matrix<S, 4>) -> Self {
        let pairs = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)];
        Self {
            upper: pairs.map(|(i, j)| a[i] * b[j] - b[i] * a[j]),
            lower: pairs.map(|(i, j)| c[i] * d[j] - d[i] * c[j]),
        }
    }

    fn determinant(&self) -> S {
        let ([s0, s1, s2, s3, s4, s5], [t0, t1, t2, t3, t4, t5]) = (self.upper, self.lower);
        s0 * t5 - s1 * t4 + s2 * t3 + s3 * t2 - s4 * t1 + s5 * t0
    }

    /// The adjugate of the matrix, which must be symmetric.
    fn adjugate(&self, matrix: Matrix<S, 4>) -> Matrix<S, 4> {
        let ([s0, s1, s2, s3, s4, s5], [_, t1, t2, t3, t4, t5]) = (self.upper, self.lower);
        let [a, b, c, d] = matrix;
        let (xy, xz, xw) = (
            a[2] * t4 - a[1] * t5 - a[3] * t3,
            d[1] * s5 - d[2] * s4 + d[3] * s3,
            c[2] * s4 - c[1] * s5 - c[3] * s3,
        );
        let (yz, yw) = (
            d[2] * s2 - d[0] * s5 - d[3] * s1,
            c[0] * s5 - c[2] * s2 + c[3] * s1,
        );
        let zw = c[1] * s2 - c[0] * s4 - c[3] * s0;
        [
            [b[1] * t5 - b[2] * t4 + b[3] * t3, xy, xz, xw],
            [xy, a[0] * t5 - a[2] * t2 + a[3] * t1, yz, yw],
            [xz, yz, d[0] * s4 - d[1] * s2 + d[3] * s0, zw],
            [xw, yw, zw, c[0] * s3 - c[1] * s1 + c[2] * s0],
        ]
    }
}

/// A Newton step for a rotor near the best one, with the trace of the moments of the rotated
/// vectors; `None` where the step is not small. With `p = R x`, a rotation by δ changes `Σ w y·p`
/// by `δ·τ − ½ δᵀ(tr K − K)δ`, where `τ = Σ w p × y` and K is the symmetric part of `Σ w p yᵀ`.
fn improved<S: Real<Mask = bool>>(rotor: Rotor<S>, moments: Matrix<S, 3>) -> Option<(Rotor<S>, S)> {
    let half = S::from_ratio(1, 2);
    let [x, y, z] = moments.map(Vector::from);
    let rotated = rotor
        .to_matrix()
        .map(|[a, b, c]| (x * a + y * b + z * c).coordinates());
    let torque = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| rotated[i][j] - rotated[j][i]);
    let trace = rotated[0][0] + rotated[1][1] + rotated[2][2];
    let mut stiffness = rotated;
    for row in 0..3 {
        for column in 0..3 {
            let symmetric = (rotated[row][column] + rotated[column][row]) * half;
            stiffness[row][column] = if row == column {
                trace - symmetric
            } else {
                -symmetric
            };
        }
    }
    let step = Vector::from(solve(stiffness, torque)?);
    if !step.length_squared().less_than(S::epsilon()) {
        return None;
    }
    // The rotor of a small rotation is (1, ½ δ), up to the cube of δ and to its length.
    let [x, y, z] = (step * half).coordinates();
    let rotated = Rotor::new_unchecked(S::one(), -z, y, -x) * rotor;
    let (vector, scalar) = rotated.to_quaternion();
    let rotor = Rotor::from_quaternion(vector, scalar)?;
    Some((with_scalar_above_zero(rotor), trace))
}

/// The rotor of the same rotation with a scalar part that is not negative. The scalar part of a
/// half turn may be rounded to either side of zero: then the sign stays and it becomes zero.
fn with_scalar_above_zero<S: Real<Mask = bool>>(rotor: Rotor<S>) -> Rotor<S> {
    let scalar = rotor.scalar();
    if !scalar.less_than(S::zero()) {
        return rotor;
    }
    if !(-scalar).less_than(S::epsilon() * S::from_integer(4)) {
        return -rotor;
    }
    Rotor::new_unchecked(S::zero(), rotor.e12(), rotor.e13(), rotor.e23())
}
