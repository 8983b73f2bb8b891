//! The length of a curve, and the time at which a length is reached.

use super::piecewise::{Curve, derivative};
use super::value::Value;
use crate::curve::CurveError;

/// Halvings of a piece after which a sharp bend of the speed no longer matters.
const MOST_HALVINGS: u32 = 50;

/// The lengths of a curve along its way, ∫ |c′(t)| dt, from its first key to its last. For a curve
/// of numbers it is the sum of rises and falls.
///
/// The integrals are those of Gauss and Kronrod with 15 points (Piessens et al., "QUADPACK", 1983),
/// over halves and halves of halves until the rule of 7 points agrees to 10⁻¹³ of the length. A
/// step of the value without a slope, as in [`Curve::step`], has no length.
///
/// ```
/// use ga_anim::curve::{ArcLength, Curve};
/// let path = Curve::linear(&[0.0, 1.0, 4.0], &[[0.0, 0.0], [3.0, 4.0], [3.0, 10.0]])?;
/// let length = ArcLength::new(&path)?;
/// assert!((length.total() - 11.0).abs() < 1e-13);
/// // Half of the way is reached at 1.25 seconds.
/// assert!((length.time_at(5.5) - 1.25).abs() < 1e-13);
/// # Ok::<(), ga_anim::curve::CurveError>(())
/// ```
#[derive(Clone, Debug)]
pub struct ArcLength<'a, V> {
    curve: &'a Curve<V>,
    /// The length from the first key to each key.
    lengths: Vec<f64>,
}

impl<'a, V: Value> ArcLength<'a, V> {
    /// Measures a curve.
    ///
    /// # Errors
    ///
    /// [`CurveError::OutOfRange`] where speeds or lengths are beyond the range of `f64`, although
    /// the values of the curve are not.
    pub fn new(curve: &'a Curve<V>) -> Result<Self, CurveError> {
        let mut lengths = Vec::with_capacity(curve.times.len());
        lengths.push(0.0);
        let mut sum = 0.0;
        for (index, piece) in curve.pieces.iter().enumerate() {
            let span = curve.span(index);
            if !most_length(piece, span).is_finite() {
                return Err(CurveError::OutOfRange { key: index });
            }
            sum += length(piece, 0.0, span);
            if !sum.is_finite() {
                return Err(CurveError::OutOfRange { key: index });
            }
            lengths.push(sum);
        }
        Ok(Self { curve, lengths })
    }

    /// The length from the first key to the last.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.lengths[self.lengths.len() - 1]
    }

    /// The length from the first key to a time: 0 before that key, and all of it after the last.
    #[must_use]
    pub fn at(&self, time: f64) -> f64 {
        let times = &self.curve.times;
        let after = times.partition_point(|&key| key <= time);
        match (
            after.checked_sub(1),
            self.curve.pieces.get(after.wrapping_sub(1)),
        ) {
            (None, _) => 0.0,
            (Some(index), Some(piece)) => {
                self.lengths[index] + length(piece, 0.0, time - times[index])
            }
            (Some(_), None) => self.total(),
        }
    }

    /// The time at which a length is reached: the start for a length of 0 or less, and the end for
    /// one beyond the total. Times at equal steps of length give equal distances along the curve.
    #[must_use]
    pub fn time_at(&self, target: f64) -> f64 {
        let after = self.lengths.partition_point(|&length| length <= target);
        let (Some(index), true) = (after.checked_sub(1), after < self.lengths.len()) else {
            return if after == 0 {
                self.curve.start()
            } else {
                self.curve.end()
            };
        };
        let (piece, span) = (&self.curve.pieces[index], self.curve.span(index));
        let rest = target - self.lengths[index];
        let all = self.lengths[index + 1] - self.lengths[index];
        // Newton's method within an interval that shrinks; the length is measured from `low`.
        let (mut low, mut high, mut below) = (0.0, span, 0.0);
        let mut s = span * (rest / all);
        for _ in 0..100 {
            let found = below + length(piece, low, s);
            let error = found - rest;
            if error > 0.0 {
                high = s;
            } else {
                (low, below) = (s, found);
            }
            let newton = s - error / speed(piece, s);
            let next = if newton > low && newton < high {
                newton
            } else {
                0.5 * (low + high)
            };
            if error == 0.0 || (next - s).abs() <= f64::EPSILON * span {
                break;
            }
            s = next;
        }
        self.curve.times[index] + s
    }
}

/// |c′|, without overflow of the squares.
fn speed<V: Value>(piece: &[V; 4], s: f64) -> f64 {
    let rate = derivative(piece, s);
    let largest = (0..V::DIMENSION).fold(0.0, |m: f64, k| m.max(rate.component(k).abs()));
    if largest == 0.0 || V::DIMENSION == 1 {
        return largest;
    }
    let squares = (0..V::DIMENSION).map(|k| (rate.component(k) / largest).powi(2));
    largest * squares.sum::<f64>().sqrt()
}

/// A bound of the length of a piece over a duration, and of all sums on the way to it.
fn most_length<V: Value>(piece: &[V; 4], span: f64) -> f64 {
    let of_component = |k: usize| {
        let [b, c, d] = [1, 2, 3].map(|power: usize| piece[power].component(k).abs());
        (3.0 * d * span + 2.0 * c) * span + b
    };
    let most_speed: f64 = (0..V::DIMENSION).map(of_component).sum();
    // The weights of a rule add up to 2.
    2.0 * most_speed * span.max(1.0)
}

/// The length of a part of a piece.
fn length<V: Value>(piece: &[V; 4], from: f64, to: f64) -> f64 {
    let (whole, error) = gauss_kronrod(piece, from, to);
    let tolerance = 1e-13 * whole;
    if error <= tolerance {
        return whole;
    }
    let mut sum = 0.0;
    let mut parts = vec![(from, to, 0)];
    while let Some((from, to, depth)) = parts.pop() {
        let (part, error) = gauss_kronrod(piece, from, to);
        let middle = 0.5 * (from + to);
        // The share of a part in the tolerance falls more slowly than its length.
        let share = tolerance * 0.75_f64.powi(depth);
        let small = depth as u32 >= MOST_HALVINGS || !(from < middle && middle < to);
        if error <= share || error <= 4.0 * f64::EPSILON * part || small {
            sum += part;
        } else {
            parts.push((middle, to, depth + 1));
            parts.push((from, middle, depth + 1));
        }
    }
    sum
}

/// The integral of the speed by 15 points, and its difference from that by 7 of them.
fn gauss_kronrod<V: Value>(piece: &[V; 4], from: f64, to: f64) -> (f64, f64) {
    let (half, middle) = (0.5 * (to - from), 0.5 * (to + from));
    let centre = speed(piece, middle);
    let mut kronrod = KRONROD[7] * centre;
    let mut gauss = GAUSS[3] * centre;
    for i in 0..7 {
        let pair = speed(piece, middle - half * NODES[i]) + speed(piece, middle + half * NODES[i]);
        kronrod += KRONROD[i] * pair;
        if i % 2 == 1 {
            gauss += GAUSS[i / 2] * pair;
        }
    }
    (half * kronrod, (half * (kronrod - gauss)).abs())
}

const NODES: [f64; 7] = [
    0.991_455_371_120_812_6,
    0.949_107_912_342_758_5,
    0.864_864_423_359_769_1,
    0.741_531_185_599_394_4,
    0.586_087_235_467_691_1,
    0.405_845_151_377_397_2,
    0.207_784_955_007_898_47,
];
const KRONROD: [f64; 8] = [
    0.022_935_322_010_529_224,
    0.063_092_092_629_978_56,
    0.104_790_010_322_250_18,
    0.140_653_259_715_525_92,
    0.169_004_726_639_267_9,
    0.190_350_578_064_785_4,
    0.204_432_940_075_298_9,
    0.209_482_141_084_727_82,
];
const GAUSS: [f64; 4] = [
    0.129_484_966_168_869_7,
    0.279_705_391_489_276_64,
    0.381_830_050_505_118_9,
    0.417_959_183_673_469_4,
];
