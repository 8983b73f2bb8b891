//! Points of a curve for a picture.

use super::{Curve, Distance, Outside};

impl Curve<f64> {
    /// Times and values that look like the curve in a picture in which its keys are so many pixels
    /// apart at most: within a tenth of a pixel of it where that can be had with 20,000 points,
    /// otherwise at 2001 even times.
    ///
    /// ```
    /// use ga_anim::curve::{Curve, Ends};
    ///
    /// let arc = Curve::spline(&[0.0, 1.0, 2.0], &[0.0, 1.0, 0.0], Ends::NotAKnot)?;
    /// let drawn = arc.drawn(500.0);
    /// // 8 ε = c″ Δ² with c″ = 2.
    /// let chord = (8.0 / (10.0 * 500.0) / 2.0_f64).sqrt();
    /// assert!((drawn.len() as f64 - 2.0 / chord).abs() < 4.0);
    /// # Ok::<(), ga_anim::curve::CurveError>(())
    /// ```
    #[must_use]
    pub fn drawn(&self, pixels: f64) -> Vec<(f64, f64)> {
        const MOST: usize = 20_000;
        let values = self.pieces().iter().map(|piece| piece[0]);
        let [low, high] = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], y| {
            [low.min(y), high.max(y)]
        });
        let tolerance = (high - low) / (10.0 * pixels);
        let points = self.resampled_within(tolerance, Distance::EqualTime, MOST);
        if let Ok(points) = points {
            return points.times.into_iter().zip(points.values).collect();
        }
        let held = self.clone().with_outside(Outside::Hold);
        let times = self.even_times(2001).into_iter();
        times.map(|time| (time, held.value(time))).collect()
    }
}
