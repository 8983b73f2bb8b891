//! Thin-plate splines on the sphere.

use crate::capture::CaptureError;
use ga_runtime::vga3::Vector;
use nalgebra_035::{DMatrix, Dyn, LU};

/// Keys that are nearer to each other, in radians, have the same direction: their values would have
/// to be divided by the square of this angle.
const SAME: f64 = 1e-4;

/// The most keys. Their system takes 512 MiB.
const MOST_KEYS: usize = 8192;

/// The spline of least bending on the unit sphere through values at some of its points, the keys:
///
/// ```text
/// f(u) = c₀ + Σ cₖ q(u, uₖ)    Σ cₖ = 0    f(uₖ) given
/// q(u, v) = ∫ (1 − h)² (1 − 2 h u·v + h²)^(−½) dh    h from 0 to 1
///         = ½ (ln(1 + 1/√W) (12 W² − 4 W) − 12 W^(3/2) + 6 W + 1)    W = |u − v|²/4
/// ```
///
/// It is the counterpart of the plane's thin-plate spline: `∫ (Δf)²` is least but for a change of
/// the norm that makes q elementary (G. Wahba, "Spline interpolation and smoothing on the sphere",
/// SIAM Journal on Scientific and Statistical Computing 2, 1981, with m = 2). It has a continuous
/// derivative, reproduces constants, stays bounded far from all keys, and depends linearly on the
/// values: `f(u) = Σ wₖ(u) f(uₖ)` with [`weights`](Self::weights) whose sum is 1.
#[derive(Clone, Debug)]
pub struct SphericalSpline {
    keys: Vec<Vector<f64>>,
    factors: LU<f64, Dyn, Dyn>,
}

impl SphericalSpline {
    /// The spline with these unit vectors as keys.
    ///
    /// # Errors
    /// [`CaptureError::NoKeys`]; [`CaptureError::TooManyKeys`] above 8192;
    /// [`CaptureError::SameDirection`] for two keys that are not 10⁻⁴ radians apart.
    ///
    /// ```
    /// use ga_runtime::vga3::Vector;
    /// use ga_vision::capture::SphericalSpline;
    ///
    /// let spline = SphericalSpline::new(&[Vector::X, Vector::Y, Vector::Z])?;
    /// let at_key = spline.weights(Vector::Y);
    /// assert!((at_key[1] - 1.0).abs() < 1e-14 && at_key[0].abs() < 1e-14);
    /// // The middle is as near to each key.
    /// let middle = spline.weights(Vector::new(1.0, 1.0, 1.0) / 3.0_f64.sqrt());
    /// assert!(middle.iter().all(|weight| (weight - 1.0 / 3.0).abs() < 1e-14));
    /// # Ok::<(), ga_vision::capture::CaptureError>(())
    /// ```
    pub fn new(keys: &[Vector<f64>]) -> Result<Self, CaptureError> {
        if keys.is_empty() {
            return Err(CaptureError::NoKeys);
        }
        if keys.len() > MOST_KEYS {
            return Err(CaptureError::TooManyKeys {
                keys: keys.len(),
                most: MOST_KEYS,
            });
        }
        for (second, key) in keys.iter().enumerate() {
            let same = keys[..second].iter().position(|k| k.distance(*key) < SAME);
            if let Some(first) = same {
                return Err(CaptureError::SameDirection {
                    first,
                    second,
                    angle: keys[first].distance(*key),
                });
            }
        }
        let count = keys.len();
        let system = DMatrix::from_fn(count + 1, count + 1, |row, column| {
            match (keys.get(row), keys.get(column)) {
                (Some(&u), Some(&v)) => kernel(u, v),
                (None, None) => 0.0,
                _ => 1.0,
            }
        });
        Ok(Self {
            keys: keys.to_vec(),
            factors: system.lu(),
        })
    }

    /// The unit vectors of the keys.
    #[must_use]
    pub fn keys(&self) -> &[Vector<f64>] {
        &self.keys
    }

    /// The weight of each key's value in the value at a unit vector.
    #[must_use]
    pub fn weights(&self, direction: Vector<f64>) -> Vec<f64> {
        let mut weights = vec![0.0; self.keys.len()];
        self.write_weights(&[direction], &mut weights);
        weights
    }

    /// The weights at several unit vectors, one after the other.
    pub(super) fn write_weights(&self, directions: &[Vector<f64>], weights: &mut [f64]) {
        let count = self.keys.len();
        // The system is symmetric, so that the weights solve it with the kernel on the right.
        let mut columns = DMatrix::from_fn(count + 1, directions.len(), |row, column| {
            let key = self.keys.get(row);
            key.map_or(1.0, |&key| kernel(key, directions[column]))
        });
        // Keys with different directions have a regular system (Wahba, theorem 1).
        self.factors.solve_mut(&mut columns);
        for (weights, column) in weights.chunks_exact_mut(count).zip(columns.column_iter()) {
            for (weight, value) in weights.iter_mut().zip(column.iter()) {
                *weight = *value;
            }
        }
    }
}

/// q(u, v), see [`SphericalSpline`].
fn kernel(u: Vector<f64>, v: Vector<f64>) -> f64 {
    // From the difference, which keeps digits where the vectors are near to each other.
    let w = (0.25 * (u - v).length_squared()).min(1.0);
    if w <= 0.0 {
        return 0.5;
    }
    let root = w.sqrt();
    let logarithm = root.recip().ln_1p();
    0.5 * (logarithm * (12.0 * w - 4.0) * w - 12.0 * w * root + 6.0 * w + 1.0)
}
