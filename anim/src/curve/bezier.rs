//! Bézier keys whose handles have times of their own.

use super::error::check_times;
use super::value::Value;
use crate::curve::CurveError;

/// A key with a handle on either side, as in editors of animation curves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BezierKey<V> {
    /// Its time.
    pub time: f64,
    /// Its value.
    pub value: V,
    /// The time and the value of the handle before it.
    pub before: (f64, V),
    /// The time and the value of the handle after it.
    pub after: (f64, V),
}

/// A curve through Bézier keys: from each key to the next the cubic Bézier curve in time and value
/// with the control points key, handle after it, handle before the next key, next key.
///
/// Its time is (1 − u)³ t₀ + 3 (1 − u)² u t₁ + 3 (1 − u) u² t₂ + u³ t₃ with a parameter u between 0
/// and 1. The handles are between both keys in time, so it rises with u, and there is one value for
/// each time. Where all handles are at thirds of the time, u is proportional to it, and
/// [`Curve::bezier`](super::Curve::bezier) is the same curve and faster.
///
/// ```
/// use ga_anim::curve::{BezierCurve, BezierKey};
/// // Slow at both ends.
/// let keys = [
///     BezierKey { time: 0.0, value: 0.0, before: (0.0, 0.0), after: (0.5, 0.0) },
///     BezierKey { time: 1.0, value: 2.0, before: (0.5, 2.0), after: (1.0, 2.0) },
/// ];
/// let ease = BezierCurve::new(&keys)?;
/// assert_eq!([ease.value(0.0), ease.value(0.5), ease.value(1.0)], [0.0, 1.0, 2.0]);
/// assert!(ease.value(0.1) < 0.05);
/// # Ok::<(), ga_anim::curve::CurveError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct BezierCurve<V> {
    keys: Vec<BezierKey<V>>,
}

impl<V: Value> BezierCurve<V> {
    /// The curve through one or more keys. The handle before the first key and that after the last
    /// one are not used.
    ///
    /// # Errors
    ///
    /// No keys, numbers that are not finite, times that do not rise, and [`CurveError::Handle`].
    pub fn new(keys: &[BezierKey<V>]) -> Result<Self, CurveError> {
        let times: Vec<f64> = keys.iter().map(|key| key.time).collect();
        check_times(&times, 1)?;
        for (index, key) in keys.iter().enumerate() {
            let values = [
                ("the value", key.value),
                ("the handle before", key.before.1),
                ("the handle after", key.after.1),
            ];
            for (what, value) in values {
                for channel in 0..V::DIMENSION {
                    let value = value.component(channel);
                    if !value.is_finite() {
                        return Err(CurveError::NotFinite {
                            what,
                            key: index,
                            channel,
                            value,
                        });
                    }
                }
            }
        }
        for (index, pair) in keys.windows(2).enumerate() {
            let inside = pair[0].time..=pair[1].time;
            for (key, (time, _)) in [(index, pair[0].after), (index + 1, pair[1].before)] {
                if !inside.contains(&time) {
                    return Err(CurveError::Handle { key, time });
                }
            }
            if !(pair[1].time - pair[0].time).is_finite() {
                return Err(CurveError::OutOfRange { key: index });
            }
        }
        Ok(Self {
            keys: keys.to_vec(),
        })
    }

    /// The keys; at least one.
    #[must_use]
    pub fn keys(&self) -> &[BezierKey<V>] {
        &self.keys
    }

    /// The value at a time. Before the first key and after the last one it is that of the key, and
    /// a time that is not a number counts as that of the first key.
    #[must_use]
    pub fn value(&self, time: f64) -> V {
        let after = self.keys.partition_point(|key| key.time <= time);
        let Some(before) = after.checked_sub(1) else {
            return self.keys[0].value;
        };
        let Some(to) = self.keys.get(after) else {
            return self.keys[before].value;
        };
        let from = &self.keys[before];
        let length = to.time - from.time;
        let share = |time: f64| (time - from.time) / length;
        let u = parameter(share(from.after.0), share(to.before.0), share(time));
        let control = [from.value, from.after.1, to.before.1, to.value];
        let weights = bernstein(u);
        V::from_components(|k| {
            control
                .iter()
                .zip(weights)
                .map(|(c, w)| c.component(k) * w)
                .sum()
        })
    }
}

fn bernstein(u: f64) -> [f64; 4] {
    let v = 1.0 - u;
    [v * v * v, 3.0 * v * v * u, 3.0 * v * u * u, u * u * u]
}

/// The parameter at which the Bézier polynomial with the control values 0, p, q, 1 has a value, all
/// from 0 to 1: Newton's method within an interval that shrinks.
fn parameter(p: f64, q: f64, value: f64) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    let mut u = value;
    // Bisection alone needs 53 steps and a few.
    for _ in 0..80 {
        let [_, b, c, d] = bernstein(u);
        let error = b * p + c * q + d - value;
        if error > 0.0 {
            high = u;
        } else {
            low = u;
        }
        let v = 1.0 - u;
        let slope = 3.0 * (v * v * p + 2.0 * v * u * (q - p) + u * u * (1.0 - q));
        let newton = u - error / slope;
        let next = if newton > low && newton < high {
            newton
        } else {
            0.5 * (low + high)
        };
        if error == 0.0 || (next - u).abs() <= f64::EPSILON * u {
            break;
        }
        u = next;
    }
    u
}
