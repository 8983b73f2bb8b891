//! The pair of pixels nearest to a measured pair whose rays meet: what Lindstrom calls optimal
//! triangulation.

use ga_runtime::scalar::Real;
use ga_runtime::vga3::Vector;

/// The steps along the gradients before the last one. Lindstrom takes one; the second makes the sum
/// of the squares right to more digits for points near an epipole.
const STEPS: usize = 2;

/// The epipolar geometry of two cameras in coordinates of equal noise: pixels from the principal
/// point, divided by one focal length for both axes of both views.
///
/// The rays of `q = (q₁, q₂, 1)` and `p = (p₁, p₂, 1)` meet where their mutual moment, which is
/// bilinear, is zero: `Σ qᵢ Eᵢⱼ pⱼ = 0`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Epipolar<S> {
    /// The rows of E.
    pub(super) rows: [Vector<S>; 3],
    /// Its columns.
    pub(super) columns: [Vector<S>; 3],
    /// The principal points.
    pub(super) principal: [[S; 2]; 2],
    /// The common focal length, and its reciprocal.
    pub(super) focal: [S; 2],
}

impl Epipolar<f64> {
    /// From the entries of E by rows.
    pub(super) fn new(entries: [[f64; 3]; 3], principal: [[f64; 2]; 2], focal: f64) -> Self {
        let column = |k: usize| Vector::new(entries[0][k], entries[1][k], entries[2][k]);
        Self {
            rows: entries.map(Vector::from),
            columns: [column(0), column(1), column(2)],
            principal,
            focal: [focal, focal.recip()],
        }
    }
}

impl<S: Real> Epipolar<S> {
    /// The pair of pixels nearest to the measured ones that satisfies the epipolar condition: the
    /// sum of the squared distances is least (P. Lindstrom, Triangulation made easy, CVPR 2010).
    ///
    /// Each step takes the gradients of the condition where the last one ended, and solves it along
    /// them, which is a quadratic equation. The last step only projects on the gradients, after
    /// which the condition holds up to rounding.
    #[inline(always)]
    pub(super) fn nearest(&self, left: [S; 2], right: [S; 2]) -> [[S; 2]; 2] {
        let [focal, _] = self.focal;
        let q = self.homogeneous(left, self.principal[0]);
        let p = self.homogeneous(right, self.principal[1]);
        let first = [self.rows[0].dot(p), self.rows[1].dot(p)];
        let second = [self.columns[0].dot(q), self.columns[1].dot(q)];
        let value = self.rows[2].dot(p) + dot([q.e1, q.e2], first);

        let (mut n, mut m) = (first, second);
        let (mut by_first, mut by_second) = ([S::zero(); 2], [S::zero(); 2]);
        for _ in 0..STEPS {
            let factor = self.along([first, second], [n, m], value);
            by_first = scaled(n, factor);
            by_second = scaled(m, factor);
            n = difference(first, flat(&self.rows, by_second));
            m = difference(second, flat(&self.columns, by_first));
        }
        let first = scaled(n, quotient(dot(by_first, n), dot(n, n)) * focal);
        let second = scaled(m, quotient(dot(by_second, m), dot(m, m)) * focal);
        [difference(left, first), difference(right, second)]
    }

    /// A pixel in coordinates of equal noise.
    #[inline(always)]
    fn homogeneous(&self, [u, v]: [S; 2], [column, row]: [S; 2]) -> Vector<S> {
        let [_, by_focal] = self.focal;
        Vector::new((u - column) * by_focal, (v - row) * by_focal, S::one())
    }

    /// How far along n and m the condition is satisfied that has the value `value` and the
    /// gradients `first` and `second` at the measured pair: the smaller root of
    /// `a λ² − 2 b λ + c = 0`.
    #[inline(always)]
    fn along(&self, [first, second]: [[S; 2]; 2], [n, m]: [[S; 2]; 2], value: S) -> S {
        let a = dot(n, flat(&self.rows, m));
        let b = (dot(first, n) + dot(second, m)) * S::from_ratio(1, 2);
        let root = (b * b - a * value).max(S::zero()).sqrt();
        quotient(value, b + root)
    }
}

/// What the first two rows or columns of E make of a displacement in the other picture.
#[inline(always)]
fn flat<S: Real>(rows: &[Vector<S>; 3], [x, y]: [S; 2]) -> [S; 2] {
    [
        rows[0].e1 * x + rows[0].e2 * y,
        rows[1].e1 * x + rows[1].e2 * y,
    ]
}

#[inline(always)]
fn dot<S: Real>([a, b]: [S; 2], [c, d]: [S; 2]) -> S {
    a * c + b * d
}

#[inline(always)]
fn scaled<S: Real>([x, y]: [S; 2], factor: S) -> [S; 2] {
    [x * factor, y * factor]
}

#[inline(always)]
fn difference<S: Real>([a, b]: [S; 2], [c, d]: [S; 2]) -> [S; 2] {
    [a - c, b - d]
}

/// The quotient, and zero for a divisor of zero: at an epipole the condition has no gradient.
#[inline(always)]
fn quotient<S: Real>(dividend: S, divisor: S) -> S {
    S::select(divisor.is_zero(), S::zero(), dividend / divisor)
}
