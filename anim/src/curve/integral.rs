//! Integrals of curves over time.

use super::piecewise::{Curve, Outside};
use super::value::Value;

impl<V: Value> Curve<V> {
    /// The integral over time from one time to another, in closed form. Where the value is held
    /// before the first key and after the last one, or the curve repeats, that is counted too. The
    /// integral in the other direction has the opposite sign. O(n).
    ///
    /// `None` where a time is not finite.
    ///
    /// ```
    /// use ga_anim::curve::Curve;
    /// let speed = Curve::linear(&[0.0, 2.0], &[0.0, 4.0])?;
    /// assert_eq!(speed.integral(0.0, 2.0), Some(4.0));
    /// assert_eq!(speed.integral(3.0, 1.0), Some(-7.0));
    /// # Ok::<(), ga_anim::curve::CurveError>(())
    /// ```
    #[must_use]
    pub fn integral(&self, from: f64, to: f64) -> Option<V> {
        if !(from.is_finite() && to.is_finite()) {
            return None;
        }
        let [before, after] = [from, to].map(|time| self.since_start(time));
        Some(V::from_components(|k| {
            after.component(k) - before.component(k)
        }))
    }

    /// The integral from the first key to a time.
    fn since_start(&self, time: f64) -> V {
        let (start, end) = (self.start(), self.end());
        if start <= time && time <= end {
            return self.inside(time);
        }
        let period = end - start;
        if self.outside == Outside::Repeat && period > 0.0 && period.is_finite() {
            let turns = ((time - start) / period).floor();
            let rest = (time - start - turns * period).clamp(0.0, period);
            let (whole, part) = (self.inside(end), self.inside(start + rest));
            return V::from_components(|k| turns * whole.component(k) + part.component(k));
        }
        if time < start {
            let first = self.first();
            return V::from_components(|k| (time - start) * first.component(k));
        }
        let whole = self.inside(end);
        V::from_components(|k| whole.component(k) + (time - end) * self.last.component(k))
    }

    fn inside(&self, time: f64) -> V {
        let mut sum = V::zero();
        for (piece, key) in self.pieces.iter().zip(self.times.windows(2)) {
            if time <= key[0] {
                break;
            }
            let s = time.min(key[1]) - key[0];
            sum = V::from_components(|k| {
                let [a, b, c, d] = [0, 1, 2, 3].map(|power: usize| piece[power].component(k));
                sum.component(k) + (((d * 0.25 * s + c / 3.0) * s + b * 0.5) * s + a) * s
            });
        }
        sum
    }
}
