//! The coordinates in which boxes are stored.

use ga_runtime::vga3::Vector;

/// Coordinates in which all triangles lie between −1 and 1, so that `f32` holds their boxes at any
/// size and place of the mesh. The scale is a power of two.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    pub(super) centre: Vector<f64>,
    pub(super) scale: f64,
}

/// A bound of the rounding errors of a position in the frame, for each unit of its size: several
/// times the 2⁻²⁴ of a conversion to `f32`.
const POSITION_ERROR: f32 = 1.0 / (1 << 22) as f32;

impl Frame {
    pub(super) fn of_bounds([low, high]: [Vector<f64>; 2]) -> Self {
        let half = (high * 0.5 - low * 0.5).coordinates();
        let half = half.into_iter().fold(f64::MIN_POSITIVE, f64::max);
        // Rounded up to a power of two, within the range of normal numbers.
        let exponent = half.log2().ceil().clamp(-1000.0, 1000.0);
        Self {
            centre: low * 0.5 + high * 0.5,
            scale: (-exponent).exp2(),
        }
    }

    pub(super) fn position(&self, position: Vector<f64>) -> Vector<f64> {
        (position - self.centre) * self.scale
    }

    /// A position in single precision, and a bound of the errors of its coordinates. `far` is the
    /// size of the numbers from which the position was computed. The bound is infinite where the
    /// position is too large for sums of squares in single precision.
    #[inline(always)]
    pub(super) fn rounded(position: Vector<f64>, far: f64) -> ([f32; 3], f32) {
        let position = position.coordinates();
        let size = position.into_iter().map(f64::abs).fold(1.0, f64::max);
        if size >= 1e15 {
            return ([0.0; 3], f32::INFINITY);
        }
        let error = POSITION_ERROR * size as f32 + (far * (1.0 / (1_u64 << 48) as f64)) as f32;
        (position.map(|x| x as f32), error)
    }
}

/// The next smaller number of single precision, at least.
pub(super) fn rounded_down(x: f64) -> f32 {
    (x as f32).next_down()
}

/// The next larger number of single precision, at least.
pub(super) fn rounded_up(x: f64) -> f32 {
    (x as f32).next_up()
}
