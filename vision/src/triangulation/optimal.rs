//! The pair of pixels nearest to a measured pair whose rays meet: what Lindstrom calls optimal
//! triangulation.

use ga_runtime::scalar::Real;
use ga_runtime::vga3::Vector;

/// The steps along the gradients. Lindstrom takes two; the third makes the sum of the squares right
/// to more digits for points near an epipole.
const STEPS: usize = 3;

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

    /// The same over another scalar.
    #[inline(always)]
    pub(super) fn map<T: Real>(&self, number: impl Fn(f64) -> T + Copy) -> Epipolar<T> {
        let vector = |vector: Vector<f64>| {
            let [x, y, z] = vector.coordinates().map(number);
            Vector::new(x, y, z)
        };
        Epipolar {
            rows: self.rows.map(vector),
            columns: self.columns.map(vector),
            principal: self.principal.map(|principal| principal.map(number)),
            focal: self.focal.map(number),
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
        let [focal, by_focal] = self.focal;
        let homogeneous = |pixel: [S; 2], principal: [S; 2]| {
            let [u, v] = pixel;
            Vector::new(
                (u - principal[0]) * by_focal,
                (v - principal[1]) * by_focal,
                S::one(),
            )
        };
        let (q, p) = (
            homogeneous(left, self.principal[0]),
            homogeneous(right, self.principal[1]),
        );
        let first = [self.rows[0].dot(p), self.rows[1].dot(p)];
        let second = [self.columns[0].dot(q), self.columns[1].dot(q)];
        let value = q.e3 * self.rows[2].dot(p) + (q.e1 * first[0] + q.e2 * first[1]);

        let (mut n, mut m) = (first, second);
        let mut steps = [[S::zero(); 2]; 2];
        for _ in 0..STEPS {
            let factor = self.along([first, second], [n, m], value);
            steps = [n, m].map(|gradient| gradient.map(|g| g * factor));
            let [by_first, by_second] = steps;
            n = [0, 1].map(|k| {
                first[k] - (self.rows[k].e1 * by_second[0] + self.rows[k].e2 * by_second[1])
            });
            m = [0, 1].map(|k| {
                second[k] - (self.columns[k].e1 * by_first[0] + self.columns[k].e2 * by_first[1])
            });
        }
        let projected = |step: [S; 2], gradient: [S; 2]| {
            let square = dot(gradient, gradient);
            let part = S::select(
                square.is_zero(),
                S::zero(),
                dot(step, gradient) / S::select(square.is_zero(), S::one(), square),
            );
            gradient.map(|g| g * part * focal)
        };
        let ([du, dv], [dx, dy]) = (projected(steps[0], n), projected(steps[1], m));
        [[left[0] - du, left[1] - dv], [right[0] - dx, right[1] - dy]]
    }

    /// How far along n and m the condition is satisfied that has the value `value` and the gradients
    /// `first` and `second` at the measured pair: the smaller root of `a λ² − 2 b λ + c = 0`.
    #[inline(always)]
    fn along(&self, [first, second]: [[S; 2]; 2], [n, m]: [[S; 2]; 2], value: S) -> S {
        let bent = [0, 1].map(|k| self.rows[k].e1 * m[0] + self.rows[k].e2 * m[1]);
        let a = dot(n, bent);
        let b = (dot(first, n) + dot(second, m)) * S::from_ratio(1, 2);
        let root = (b * b - a * value).max(S::zero()).sqrt();
        let sum = b + root;
        S::select(
            sum.is_zero(),
            S::zero(),
            value / S::select(sum.is_zero(), S::one(), sum),
        )
    }
}

#[inline(always)]
fn dot<S: Real>([a, b]: [S; 2], [c, d]: [S; 2]) -> S {
    a * c + b * d
}
