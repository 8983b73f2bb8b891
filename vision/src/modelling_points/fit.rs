//! The plane that fits the disparities of a cell, from what two cells add up to.

/// Weighted pixels as points (u, v, d): their weight, their mean, and a root of their scatter, the
/// upper triangular R of which RᵀR is the weighted sum of (p − mean)(p − mean)ᵀ.
///
/// A residual from the scatter itself would be the root of a difference of large squares, and so
/// keep half the digits; from R it keeps all of them.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Fit {
    pixels: u64,
    weight: f64,
    mean: [f64; 3],
    root: [[f64; 3]; 3],
}

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
            root: [[0.0; 3]; 3],
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
        let between = apart.map(|difference| (self.weight * share).sqrt() * difference);
        let rows = other.root.into_iter().chain([between]);
        Self {
            pixels: self.pixels + other.pixels,
            weight,
            mean: std::array::from_fn(|k| self.mean[k] + share * apart[k]),
            root: rows.fold(self.root, with_row),
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
        let [[uu, uv, ud], [_, vv, vd], [.., dd]] = self.root;
        let squared = uu * uu + uv * uv + vv * vv;
        let slope = if uu * vv > FLAT * squared {
            let down = vd / vv;
            [(ud - uv * down) / uu, down]
        } else if squared > 0.0 {
            // The root is σ a bᵀ of unit vectors a and b, its pseudoinverse itself turned over.
            [uu * ud / squared, (uv * ud + vv * vd) / squared]
        } else {
            [0.0; 2]
        };
        let remains = [ud - uu * slope[0] - uv * slope[1], vd - vv * slope[1], dd];
        let squares: f64 = remains.iter().map(|part| part * part).sum();
        Some(FittedPlane {
            slope,
            residual: (squares / self.weight).sqrt(),
        })
    }
}

/// The upper triangular root of RᵀR + rᵀr, by rotations that make each entry of the row 0 in turn
/// (W. Givens, Computation of plane unitary rotations transforming a general matrix to triangular
/// form, SIAM Journal 6, 1958).
fn with_row(mut root: [[f64; 3]; 3], mut row: [f64; 3]) -> [[f64; 3]; 3] {
    for k in 0..3 {
        let length = root[k][k].hypot(row[k]);
        if length == 0.0 {
            continue;
        }
        let (cosine, sine) = (root[k][k] / length, row[k] / length);
        for column in k..3 {
            let [above, below] = [root[k][column], row[column]];
            root[k][column] = cosine * above + sine * below;
            row[column] = cosine * below - sine * above;
        }
    }
    root
}
