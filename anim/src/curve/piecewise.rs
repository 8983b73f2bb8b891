//! Curves as pieces of cubic polynomials.

use super::value::Value;
use crate::curve::CurveError;

/// A curve over time: from each key to the next a polynomial of degree 3 or less,
///
/// ```text
/// c(t) = c₀ + c₁ s + c₂ s² + c₃ s³,   s = t − tᵢ,   tᵢ ≤ t < tᵢ₊₁.
/// ```
///
/// At the last key it has the value of that key. [`Outside`] says what it is before the first key
/// and after the last one. It is built by [`Curve::spline`], [`Curve::catmull_rom`],
/// [`Curve::hermite`], [`Curve::bezier`], [`Curve::linear`] and [`Curve::step`], or several at once
/// by a [`SplineSystem`](super::SplineSystem).
///
/// ```
/// use ga_anim::curve::{Curve, Ends};
/// // Through the sine at 0, π/2, π, 3π/2 and 2π.
/// let times = [0.0, 0.25, 0.5, 0.75, 1.0].map(|part: f64| part * std::f64::consts::TAU);
/// let sine = Curve::spline(&times, &[0.0, 1.0, 0.0, -1.0, 0.0], Ends::Periodic)?;
/// assert!((sine.value(1.0) - 1_f64.sin()).abs() < 0.02);
/// assert!((sine.derivative(1.0) - 1_f64.cos()).abs() < 0.05);
/// // A periodic curve goes on.
/// assert!((sine.value(1.0 + std::f64::consts::TAU) - sine.value(1.0)).abs() < 1e-14);
/// # Ok::<(), ga_anim::curve::CurveError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Curve<V> {
    pub(super) times: Vec<f64>,
    /// From each key to the next, by rising power.
    pub(super) pieces: Vec<[V; 4]>,
    pub(super) last: V,
    pub(super) outside: Outside,
}

/// What a curve is before its first key and after its last one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Outside {
    /// The value at the first or the last key.
    #[default]
    Hold,
    /// The curve again, as often as is needed.
    Repeat,
}

impl<V: Value> Curve<V> {
    /// A curve of checked times and pieces.
    pub(super) fn new(
        times: &[f64],
        pieces: Vec<[V; 4]>,
        last: V,
        outside: Outside,
    ) -> Result<Self, CurveError> {
        let finite = |piece: &[V; 4]| {
            piece.iter().fold(true, |good, c| {
                (0..V::DIMENSION).fold(good, |good, k| good & c.component(k).is_finite())
            })
        };
        match pieces.iter().position(|piece| !finite(piece)) {
            Some(key) => Err(CurveError::OutOfRange { key }),
            None => Ok(Self {
                times: times.to_vec(),
                pieces,
                last,
                outside,
            }),
        }
    }

    /// The same curve with another continuation before the first key and after the last.
    #[must_use]
    pub fn with_outside(mut self, outside: Outside) -> Self {
        self.outside = outside;
        self
    }

    /// The times of the keys; at least one, and rising.
    #[must_use]
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// The time of the first key.
    #[must_use]
    pub fn start(&self) -> f64 {
        self.times[0]
    }

    /// The time of the last key.
    #[must_use]
    pub fn end(&self) -> f64 {
        self.times[self.times.len() - 1]
    }

    /// So many times at equal steps, from the first key to the last; one alone is that of the last.
    ///
    /// ```
    /// use ga_anim::curve::Curve;
    ///
    /// let curve = Curve::linear(&[1.0, 3.0], &[0.0, 1.0])?;
    /// assert_eq!(curve.even_times(5), [1.0, 1.5, 2.0, 2.5, 3.0]);
    /// # Ok::<(), ga_anim::curve::CurveError>(())
    /// ```
    #[must_use]
    pub fn even_times(&self, count: usize) -> Vec<f64> {
        let (start, end) = (self.start(), self.end());
        let time = |index: usize| match index + 1 == count {
            true => end,
            false => start + (end - start) * (index as f64 / (count - 1) as f64),
        };
        (0..count).map(time).collect()
    }

    /// The coefficients c₀, c₁, c₂, c₃ from each key to the next, in powers of the time since the
    /// key. There is one piece fewer than keys.
    #[must_use]
    pub fn pieces(&self) -> &[[V; 4]] {
        &self.pieces
    }

    /// The value at a time, found by bisection: O(log n). A time that is not a number counts as
    /// that of the first key. For many times in order, a [`Cursor`](super::Cursor) is faster.
    #[must_use]
    pub fn value(&self, time: f64) -> V {
        match self.locate(time) {
            Place::Piece(index, s) => value(&self.pieces[index], s),
            Place::Before => self.first(),
            Place::After => self.last,
        }
    }

    /// The first derivative at a time, per unit of time: 0 where the value is held. At a key it is
    /// that of the piece after the key, and at the last key that of the piece before it.
    #[must_use]
    pub fn derivative(&self, time: f64) -> V {
        match self.locate_inside(time) {
            Some((index, s)) => derivative(&self.pieces[index], s),
            None => V::zero(),
        }
    }

    /// The second derivative at a time; at keys as [`Curve::derivative`].
    #[must_use]
    pub fn second_derivative(&self, time: f64) -> V {
        match self.locate_inside(time) {
            Some((index, s)) => second_derivative(&self.pieces[index], s),
            None => V::zero(),
        }
    }

    pub(super) fn first(&self) -> V {
        self.pieces.first().map_or(self.last, |piece| piece[0])
    }

    /// The length of a piece in time.
    pub(super) fn span(&self, index: usize) -> f64 {
        self.times[index + 1] - self.times[index]
    }

    /// The time within the curve that a time stands for.
    pub(super) fn wrapped(&self, time: f64) -> f64 {
        let (start, end) = (self.start(), self.end());
        let period = end - start;
        if self.outside == Outside::Hold
            || (start <= time && time <= end)
            || !time.is_finite()
            || !period.is_finite()
            || self.pieces.is_empty()
        {
            return time;
        }
        (start + (time - start).rem_euclid(period)).min(end)
    }

    /// The piece at a time, and the time since its key.
    pub(super) fn locate(&self, time: f64) -> Place {
        let time = self.wrapped(time);
        let after = self.times.partition_point(|&key| key <= time);
        if after == 0 {
            Place::Before
        } else if after == self.times.len() {
            Place::After
        } else {
            Place::Piece(after - 1, time - self.times[after - 1])
        }
    }

    fn locate_inside(&self, time: f64) -> Option<(usize, f64)> {
        let end = self.pieces.len().checked_sub(1);
        match self.locate(time) {
            Place::Piece(index, s) => Some((index, s)),
            Place::After if time == self.end() => end.map(|index| (index, self.span(index))),
            Place::Before | Place::After => None,
        }
    }
}

/// Where a time lies.
pub(super) enum Place {
    Before,
    Piece(usize, f64),
    After,
}

#[inline(always)]
pub(super) fn value<V: Value>(c: &[V; 4], s: f64) -> V {
    V::from_components(|k| {
        let [a, b, c, d] = [0, 1, 2, 3].map(|power: usize| c[power].component(k));
        ((d * s + c) * s + b) * s + a
    })
}

#[inline(always)]
pub(super) fn derivative<V: Value>(c: &[V; 4], s: f64) -> V {
    V::from_components(|k| {
        let [b, c, d] = [1, 2, 3].map(|power: usize| c[power].component(k));
        (3.0 * d * s + 2.0 * c) * s + b
    })
}

#[inline(always)]
pub(super) fn second_derivative<V: Value>(c: &[V; 4], s: f64) -> V {
    V::from_components(|k| 6.0 * c[3].component(k) * s + 2.0 * c[2].component(k))
}
