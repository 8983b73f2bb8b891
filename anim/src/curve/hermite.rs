//! Cubic pieces given by values and slopes at their ends.

use super::error::{check_times, check_values};
use super::piecewise::{Curve, Outside};
use super::value::Value;
use crate::curve::CurveError;

impl<V: Value> Curve<V> {
    /// The cubic Hermite curve: from each key to the next the cubic polynomial with the values of
    /// both keys, the slope `after` of the first and the slope `before` of the second, per unit of
    /// time. With s from 0 to 1 and the duration h it is
    ///
    /// ```text
    /// (2s³ − 3s² + 1) y₀ + (s³ − 2s² + s) h y₀′ + (3s² − 2s³) y₁ + (s³ − s²) h y₁′.
    /// ```
    ///
    /// This is CUBICSPLINE of glTF 2.0 (appendix C.5), whose in-tangents are `before` and whose
    /// out-tangents are `after`. Where both are equal the slope is continuous.
    ///
    /// # Errors
    ///
    /// No keys, lists of different lengths, numbers that are not finite, times that do not rise,
    /// and [`CurveError::OutOfRange`].
    ///
    /// ```
    /// use ga_anim::curve::Curve;
    /// // t³ from −1 to 2 is one such piece.
    /// let cube = Curve::hermite(&[-1.0, 2.0], &[-1.0, 8.0], &[3.0, 12.0], &[3.0, 12.0])?;
    /// assert_eq!([cube.value(0.0), cube.value(1.0), cube.derivative(1.0)], [0.0, 1.0, 3.0]);
    /// # Ok::<(), ga_anim::curve::CurveError>(())
    /// ```
    pub fn hermite(
        times: &[f64],
        values: &[V],
        before: &[V],
        after: &[V],
    ) -> Result<Self, CurveError> {
        check_times(times, 1)?;
        check_values("values", values, times.len())?;
        check_values("slopes before keys", before, times.len())?;
        check_values("slopes after keys", after, times.len())?;
        let pieces = (1..times.len()).map(|key| {
            let h = times[key] - times[key - 1];
            hermite(
                h,
                [values[key - 1], values[key]],
                [after[key - 1], before[key]],
            )
        });
        Self::new(
            times,
            pieces.collect(),
            values[values.len() - 1],
            Outside::Hold,
        )
    }

    /// The spline of Catmull and Rom: the cubic Hermite curve whose slope at an inner key is that
    /// of the parabola through it and both neighbours,
    ///
    /// ```text
    /// yᵢ′ = (hᵢ δᵢ₋₁ + hᵢ₋₁ δᵢ) / (hᵢ₋₁ + hᵢ),   δᵢ = (yᵢ₊₁ − yᵢ) / hᵢ,
    /// ```
    ///
    /// and at the ends that of the line to the neighbour. At equal distances in time the slope is
    /// (yᵢ₊₁ − yᵢ₋₁)/2h; at others the curve is that of P. J. Barry and R. N. Goldman ("A
    /// recursive evaluation algorithm for a class of Catmull–Rom splines", SIGGRAPH 1988).
    ///
    /// # Errors
    ///
    /// As [`Curve::hermite`].
    pub fn catmull_rom(times: &[f64], values: &[V]) -> Result<Self, CurveError> {
        check_times(times, 1)?;
        check_values("values", values, times.len())?;
        let line = |from: usize| {
            let h = times[from + 1] - times[from];
            let [a, b] = [values[from], values[from + 1]];
            (
                h,
                V::from_components(|k| (b.component(k) - a.component(k)) / h),
            )
        };
        let last = times.len() - 1;
        let slope = |key: usize| {
            if last == 0 {
                return V::zero();
            }
            let (before, after) = (line(key.max(1) - 1), line(key.min(last - 1)));
            let share = after.0 / (before.0 + after.0);
            V::from_components(|k| {
                let [d0, d1] = [before.1.component(k), after.1.component(k)];
                d1 + (d0 - d1) * share
            })
        };
        let slopes: Vec<V> = (0..=last).map(slope).collect();
        Self::hermite(times, values, &slopes, &slopes).map_err(|error| match error {
            CurveError::NotFinite { key, .. } => CurveError::OutOfRange {
                key: key.min(last.max(1) - 1),
            },
            other => other,
        })
    }

    /// The curve of Bézier keys with handles at thirds of the time: from each key to the next the
    /// cubic Bézier curve with the control values y₀, `after` of the first key, `before` of the
    /// second, and y₁. For handles at other times see [`BezierCurve`](super::BezierCurve).
    ///
    /// # Errors
    ///
    /// As [`Curve::hermite`].
    pub fn bezier(
        times: &[f64],
        values: &[V],
        before: &[V],
        after: &[V],
    ) -> Result<Self, CurveError> {
        check_times(times, 1)?;
        check_values("values", values, times.len())?;
        check_values("handles before keys", before, times.len())?;
        check_values("handles after keys", after, times.len())?;
        let pieces = (1..times.len()).map(|key| {
            let h = times[key] - times[key - 1];
            let control = [values[key - 1], after[key - 1], before[key], values[key]];
            let combined = |weights: [f64; 4], power: i32| {
                V::from_components(|k| {
                    let terms = control.iter().zip(weights);
                    terms.map(|(c, w)| c.component(k) * w).sum::<f64>() / h.powi(power)
                })
            };
            [
                control[0],
                combined([-3.0, 3.0, 0.0, 0.0], 1),
                combined([3.0, -6.0, 3.0, 0.0], 2),
                combined([-1.0, 3.0, -3.0, 1.0], 3),
            ]
        });
        Self::new(
            times,
            pieces.collect(),
            values[values.len() - 1],
            Outside::Hold,
        )
    }
}

/// The coefficients of the Hermite polynomial over a duration.
fn hermite<V: Value>(h: f64, y: [V; 2], slopes: [V; 2]) -> [V; 4] {
    let coefficient = |power: usize| {
        V::from_components(|k| {
            let [y0, y1] = [y[0].component(k), y[1].component(k)];
            let [d0, d1] = [slopes[0].component(k), slopes[1].component(k)];
            let line = (y1 - y0) / h;
            match power {
                0 => y0,
                1 => d0,
                2 => ((line - d0) + (line - d0) + (line - d1)) / h,
                _ => ((d0 - line) + (d1 - line)) / h / h,
            }
        })
    };
    [0, 1, 2, 3].map(coefficient)
}
