//! How well the unknowns are determined where the residuals are not linear in them.

use nalgebra_035::{Cholesky, DMatrix, DVector};

use super::covariance::Covariance;

/// The covariance of unknowns to second order, from that to first order and the cost after a step;
/// all unknowns are shared.
///
/// Where the cost is a quadratic form, errors of the unknowns spread as an ellipsoid, `variance ·
/// (JᵀWJ)⁻¹`. Where one direction is determined far worse than the others, as the direction of a
/// translation beside a rotation that shows almost the same, the valley of the cost along it bends,
/// and errors leave the thin ellipsoid. In coordinates y in which the ellipsoid is the unit ball
/// the cost is `variance · (|y|² + T(y, y, y)/3 + …)`, and what is as likely as the cost says has
/// the second moments about the minimum (L. Tierney and J. B. Kadane, "Accurate approximations for
/// posterior moments and marginal densities", 1986)
///
/// ```text
/// I + (Σᵢ Bᵢᵢ)(Σᵢ Bᵢᵢ)ᵀ + 2 Σᵢⱼ Bᵢⱼ Bᵢⱼᵀ + …,   B = −T/2
/// ```
///
/// The terms that are left out contain fourth derivatives and the bend along a direction itself;
/// together they make the moments smaller along the valley, so that what is returned is rather too
/// large there.
///
/// The numbers of T are differences of the cost between places that are one standard deviation
/// away along one to three of the axes. `None` where there is no covariance to first order, or no
/// cost at such a place.
pub(super) fn curved(
    first: &Covariance,
    count: usize,
    variance: f64,
    cost: impl FnMut(&[f64]) -> Option<f64>,
) -> Option<Covariance> {
    let matrix = DMatrix::from_fn(count, count, |row, column| first.shared(row, column));
    let Some(factor) = Cholesky::new(matrix.clone()) else {
        // No variance, as of exact observations.
        return Some(Covariance::new(matrix, Vec::new()));
    };
    let axes = factor.l();
    let cubic = Cubic::new(&axes, variance, cost)?;
    let bent = |i: usize, j: usize| DVector::from_fn(count, |k, _| -0.5 * cubic.entry([i, j, k]));
    let mut moments = DMatrix::identity(count, count);
    let mut mean = DVector::zeros(count);
    for i in 0..count {
        mean += bent(i, i);
        for j in 0..count {
            let bent = bent(i, j);
            moments += 2.0 * &bent * bent.transpose();
        }
    }
    moments += &mean * mean.transpose();
    let curved = &axes * moments * axes.transpose();
    let is_finite = curved.iter().all(|value| value.is_finite());
    is_finite.then(|| Covariance::new(curved, Vec::new()))
}

/// The third derivatives of half of the cost over the variance, along axes.
struct Cubic {
    /// By indices that do not rise.
    entries: Vec<Vec<Vec<f64>>>,
}

impl Cubic {
    fn new(
        axes: &DMatrix<f64>,
        variance: f64,
        mut cost: impl FnMut(&[f64]) -> Option<f64>,
    ) -> Option<Self> {
        // The odd part of the cost is T(y, y, y)/6, to third order.
        let mut odd = |parts: &[(usize, f64)]| -> Option<f64> {
            let step = parts.iter().fold(
                DVector::zeros(axes.nrows()),
                |sum: DVector<f64>, (axis, sign)| sum + axes.column(*axis) * *sign,
            );
            let both = [cost(step.as_slice())?, cost((-step).as_slice())?];
            Some((both[0] - both[1]) / (4.0 * variance))
        };
        let count = axes.ncols();
        let mut found = Self {
            entries: (0..count)
                .map(|i| (0..=i).map(|j| vec![0.0; j + 1]).collect())
                .collect(),
        };
        for i in 0..count {
            found.entries[i][i][i] = 6.0 * odd(&[(i, 1.0)])?;
        }
        for i in 0..count {
            for j in 0..i {
                let [sum, difference] = [odd(&[(i, 1.0), (j, 1.0)])?, odd(&[(i, 1.0), (j, -1.0)])?];
                let [first, second] = [i, j].map(|k| found.entries[k][k][k] / 3.0);
                found.entries[i][j][j] = sum + difference - first;
                found.entries[i][i][j] = sum - difference - second;
            }
        }
        for i in 0..count {
            for j in 0..i {
                for k in 0..j {
                    let whole = odd(&[(i, 1.0), (j, 1.0), (k, 1.0)])?;
                    let cubes: f64 = [i, j, k].iter().map(|n| found.entry([*n; 3])).sum();
                    let pairs = [(i, j), (i, k), (j, k), (j, i), (k, i), (k, j)];
                    let mixed: f64 = pairs.iter().map(|(a, b)| found.entry([*a, *a, *b])).sum();
                    found.entries[i][j][k] = whole - (cubes + 3.0 * mixed) / 6.0;
                }
            }
        }
        Some(found)
    }

    fn entry(&self, mut indices: [usize; 3]) -> f64 {
        indices.sort_unstable();
        let [k, j, i] = indices;
        self.entries[i][j][k]
    }
}
