//! Evaluation at times that follow each other.

use super::piecewise::{Curve, Place, derivative, second_derivative, value};
use super::value::Value;
use crate::curve::CurveError;

/// A place on a curve, from which the next is found quickly: in O(1) amortised where times rise or
/// fall, in O(log n) after a leap.
///
/// ```
/// use ga_anim::curve::Curve;
/// let curve = Curve::linear(&[0.0, 1.0, 3.0], &[0.0, 10.0, 30.0])?;
/// let mut cursor = curve.cursor();
/// let values = [0.5, 1.0, 2.0, 9.0, 0.25].map(|time| cursor.value(time));
/// assert_eq!(values, [5.0, 10.0, 20.0, 30.0, 2.5]);
/// # Ok::<(), ga_anim::curve::CurveError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Cursor<'a, V> {
    curve: &'a Curve<V>,
    index: usize,
    /// The piece at the index, from `start` up to `end` exclusive.
    piece: [V; 4],
    start: f64,
    end: f64,
}

impl<V: Value> Curve<V> {
    /// The value at each of some times, which may be in any order; O(1) each where they rise.
    ///
    /// # Errors
    ///
    /// [`CurveError::Length`] when there is not one place for each time.
    pub fn sample_into(&self, times: &[f64], values: &mut [V]) -> Result<(), CurveError> {
        if values.len() != times.len() {
            let (times, found) = (times.len(), values.len());
            return Err(CurveError::Length {
                what: "places",
                times,
                found,
            });
        }
        let mut cursor = self.cursor();
        let mut done = 0;
        while done < times.len() {
            // All that follow in the same piece, in a loop without branches.
            done += cursor.run(&times[done..], &mut values[done..]);
            if let Some(&time) = times.get(done) {
                values[done] = cursor.value(time);
                done += 1;
            }
        }
        Ok(())
    }

    /// A cursor at the first key, for values at rising times.
    #[must_use]
    pub fn cursor(&self) -> Cursor<'_, V> {
        Cursor::new(self)
    }
}

impl<'a, V: Value> Cursor<'a, V> {
    fn new(curve: &'a Curve<V>) -> Self {
        let start = curve.start();
        // No time lies in an empty piece.
        let mut cursor = Self {
            curve,
            index: 0,
            piece: [V::zero(); 4],
            start,
            end: start,
        };
        if !curve.pieces.is_empty() {
            cursor.enter(0);
        }
        cursor
    }

    /// The value at a time; see [`Curve::value`].
    #[inline]
    #[must_use]
    pub fn value(&mut self, time: f64) -> V {
        if self.start <= time && time < self.end {
            return value(&self.piece, time - self.start);
        }
        match self.seek(time) {
            Some(s) => value(&self.piece, s),
            None => self.curve.value(time),
        }
    }

    /// The first derivative at a time; see [`Curve::derivative`].
    #[inline]
    #[must_use]
    pub fn derivative(&mut self, time: f64) -> V {
        if self.start <= time && time < self.end {
            return derivative(&self.piece, time - self.start);
        }
        match self.seek(time) {
            Some(s) => derivative(&self.piece, s),
            None => self.curve.derivative(time),
        }
    }

    /// The second derivative at a time; see [`Curve::second_derivative`].
    #[inline]
    #[must_use]
    pub fn second_derivative(&mut self, time: f64) -> V {
        if self.start <= time && time < self.end {
            return second_derivative(&self.piece, time - self.start);
        }
        match self.seek(time) {
            Some(s) => second_derivative(&self.piece, s),
            None => self.curve.second_derivative(time),
        }
    }

    /// The values at the first of some times, as many as are in the piece of the cursor. Returns
    /// their number.
    fn run(&self, times: &[f64], values: &mut [V]) -> usize {
        let (start, end, piece) = (self.start, self.end, self.piece);
        let inside = times
            .iter()
            .take_while(|&&time| start <= time && time < end)
            .count();
        for (place, &time) in values.iter_mut().zip(&times[..inside]) {
            *place = value(&piece, time - start);
        }
        inside
    }

    /// Goes to the piece at a time and returns the time since its key; `None` outside the curve.
    #[inline(never)]
    fn seek(&mut self, time: f64) -> Option<f64> {
        let time = self.curve.wrapped(time);
        let times = &self.curve.times;
        let neighbours = [
            Some(self.index + 1),
            self.index.checked_sub(1),
            Some(self.index),
        ];
        for index in neighbours.into_iter().flatten() {
            if index + 1 < times.len() && times[index] <= time && time < times[index + 1] {
                self.enter(index);
                return Some(time - self.start);
            }
        }
        match self.curve.locate(time) {
            Place::Piece(index, s) => {
                self.enter(index);
                Some(s)
            }
            Place::Before | Place::After => None,
        }
    }

    fn enter(&mut self, index: usize) {
        self.index = index;
        self.piece = self.curve.pieces[index];
        (self.start, self.end) = (self.curve.times[index], self.curve.times[index + 1]);
    }
}
