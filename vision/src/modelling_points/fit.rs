//! The plane that fits the disparities of a cell, from sums that two cells add up to.

use nalgebra_035::{Matrix2, Vector2};

/// Weighted pixels as points (u, v, d): their weight, their mean, and their scatter, the weighted
/// sum of (p − mean)(p − mean)ᵀ, whose six entries are uu, uv, vv, ud, vd, dd.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Fit {
    pixels: u64,
    weight: f64,
    mean: [f64; 3],
    scatter: [f64; 6],
}

/// The axes of each entry of the scatter.
const ENTRIES: [[usize; 2]; 6] = [[0, 0], [0, 1], [1, 1], [0, 2], [1, 2], [2, 2]];

/// A spread of the pixels that is less than this share of the greatest one is taken for none: the
/// pixels lie in one line or are one.
const FLAT: f64 = 1e-9;

/// The plane of least weighted squares through the mean.
pub(super) struct FittedPlane {
    pub(super) slope: [f64; 2],
    pub(super) residual: f64,
}

impl Fit {
    /// One pixel; without a weight where its disparity is not finite or its weight is 0.
    pub(super) fn of_pixel([column, row]: [usize; 2], disparity: f32, weight: f32) -> Self {
        if !disparity.is_finite() || weight <= 0.0 {
            return Self::default();
        }
        Self {
            pixels: 1,
            weight: f64::from(weight),
            mean: [column as f64, row as f64, f64::from(disparity)],
            scatter: [0.0; 6],
        }
    }

    /// The pixels of both (T. Chan, G. Golub and R. LeVeque, Algorithms for computing the sample
    /// variance, The American Statistician 37, 1983).
    pub(super) fn merged(self, other: Self) -> Self {
        if self.pixels == 0 {
            return other;
        }
        if other.pixels == 0 {
            return self;
        }
        let weight = self.weight + other.weight;
        let share = other.weight / weight;
        let apart: [f64; 3] = std::array::from_fn(|k| other.mean[k] - self.mean[k]);
        Self {
            pixels: self.pixels + other.pixels,
            weight,
            mean: std::array::from_fn(|k| self.mean[k] + share * apart[k]),
            scatter: std::array::from_fn(|entry| {
                let [a, b] = ENTRIES[entry];
                let between = self.weight * share * apart[a] * apart[b];
                self.scatter[entry] + other.scatter[entry] + between
            }),
        }
    }

    pub(super) fn pixels(&self) -> usize {
        self.pixels as usize
    }

    /// The weighted mean of column, row and disparity.
    pub(super) fn mean(&self) -> [f64; 3] {
        self.mean
    }

    /// The plane that fits best; of those that fit equally well, where the pixels lie in one line,
    /// the one of least slope. `None` without a pixel.
    pub(super) fn plane(&self) -> Option<FittedPlane> {
        if self.pixels == 0 {
            return None;
        }
        let [uu, uv, vv, ud, vd, dd] = self.scatter;
        let along = Vector2::new(ud, vd);
        let spread = Matrix2::new(uu, uv, uv, vv);
        let slope = spread
            .pseudo_inverse(FLAT * (uu + vv))
            .map_or_else(|_| Vector2::zeros(), |inverse| inverse * along);
        let squares = (dd - slope.dot(&along)).max(0.0);
        Some(FittedPlane {
            slope: slope.into(),
            residual: (squares / self.weight).sqrt(),
        })
    }
}
