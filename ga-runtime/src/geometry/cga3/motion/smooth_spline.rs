//! Splines of motions whose acceleration is continuous.

use alloc::vec::Vec;

use super::spline::{MotorSpline, Piece, SplineError, bend, check, is_number, zero};
use crate::cga3::{Motor, MotorGenerator};
use crate::geometry::RotationPath;
use crate::scalar::Real;

/// What holds at an end of a [smooth spline](MotorSpline::smooth).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SplineEnd<S> {
    /// The acceleration there is zero.
    Natural,
    /// The velocity there, in the frame of the moved body, as of [`MotorSpline::velocity`].
    Velocity(MotorGenerator<S>),
}

impl<S: Real<Mask = bool>> MotorSpline<S> {
    /// The spline through two or more keys, each a time and a motor, whose velocity and
    /// acceleration are continuous (C²). Its third derivative jumps at the keys.
    ///
    /// This is the cumulative form of the cubic B-spline (Kim, Kim and Shin, A general construction
    /// scheme for unit quaternion curves with simple high order derivatives, SIGGRAPH 1995), for
    /// motors: with control motors C and the sums `βᵢ = Σⱼ≥ᵢ Bⱼ(t)` of the basis functions, it is
    ///
    /// ```text
    /// M(t) = C₀ exp(β₁ log(~C₀ C₁)) exp(β₂ log(~C₁ C₂)) …
    /// ```
    ///
    /// For translations it is the cubic spline of points. The control motors are found by
    /// correcting them with the solution of the tridiagonal system of that spline, again and again,
    /// until the keys are reached to rounding. This takes the longer the larger the rotations from
    /// key to key are, and may fail for those above 45° or so; [`MotorSpline::through`] has no such
    /// limit. From key to key the curve takes the shorter rotation, for any signs of the key
    /// motors.
    ///
    /// # Errors
    /// Those of [`MotorSpline::with_velocities`], and [`SplineError::NotReached`] where the
    /// rotations from key to key are too large for the corrections to converge.
    ///
    /// ```
    /// use ga_runtime::cga3::{Motor, Translator};
    /// use ga_runtime::geometry::motion::{MotorSpline, SplineEnd};
    /// let key = |t: f64, x: f64| (t, Motor::from(Translator::from_displacement([x, 0.0, 0.0])));
    /// let keys = [key(0.0, 0.0), key(1.0, 1.0), key(2.0, 0.0)];
    /// let spline = MotorSpline::smooth(&keys, [SplineEnd::Natural; 2]).unwrap();
    /// // The natural cubic spline: x(t) = ½(3t − t³) from 0 to 1.
    /// let x = spline.evaluate(0.5).unwrap().translator().displacement()[0];
    /// assert!((x - 0.6875).abs() < 1e-15);
    /// // The displacement has the second derivative −3 at the middle key; −½ of it is in e1i.
    /// assert!((spline.acceleration(1.0).unwrap().e1i - 1.5).abs() < 1e-14);
    /// ```
    pub fn smooth(keys: &[(S, Motor<S>)], ends: [SplineEnd<S>; 2]) -> Result<Self, SplineError<S>> {
        check(keys)?;
        for (index, end) in [(0, ends[0]), (keys.len() - 1, ends[1])] {
            if let SplineEnd::Velocity(velocity) = end
                && !is_number(velocity)
            {
                return Err(SplineError::NotFinite { index });
            }
        }
        let spans = spans(keys)?;
        let mut search = Search::new(keys, &spans, ends);
        search.converge()?;
        let controls = search.controls;
        let mut pieces = Vec::with_capacity(spans.len());
        for (index, span) in spans.iter().enumerate() {
            let piece = span.piece(&controls[index..]);
            if !piece.parts.into_iter().all(is_number) {
                return Err(SplineError::OutOfRange { index });
            }
            pieces.push(piece);
        }
        let (end, _) = keys[keys.len() - 1];
        let last = controls[controls.len() - 1];
        Ok(Self::of_pieces(pieces, end, last))
    }
}

/// The time between two keys, with the four basis functions that are not zero there, as polynomials
/// in the position from 0 to 1, the lowest power first.
struct Span<S> {
    start: S,
    duration: S,
    basis: [[S; 4]; 4],
}

impl<S: Real<Mask = bool>> Span<S> {
    /// The sums of the basis functions from the second, the third and the fourth on.
    fn shares(&self) -> [[S; 4]; 3] {
        let [_, b1, b2, b3] = self.basis;
        let sum = |a: [S; 4], b: [S; 4]| core::array::from_fn(|k| a[k] + b[k]);
        let last_two = sum(b2, b3);
        [sum(b1, last_two), last_two, b3]
    }

    /// The piece of the curve, from the four controls of the span.
    fn piece(&self, controls: &[Motor<S>]) -> Piece<S> {
        Piece {
            start: self.start,
            duration: self.duration,
            from: controls[0],
            parts: [0, 1, 2].map(|k| (controls[k].reverse() * controls[k + 1]).log()),
            shares: self.shares(),
        }
    }
}

/// The spans between keys, with the knots at the keys, those at the ends fourfold.
fn spans<S: Real<Mask = bool>>(keys: &[(S, Motor<S>)]) -> Result<Vec<Span<S>>, SplineError<S>> {
    let last = keys.len() - 1;
    let knot = |index: usize, shift: isize| {
        let place = index.saturating_add_signed(shift).min(last);
        keys[place].0
    };
    (0..last)
        .map(|index| {
            let start = knot(index, 0);
            let duration = knot(index, 1) - start;
            // Differences of knots from the start, in durations.
            let at = |shift| (knot(index, shift) - start) / duration;
            let [left, right] = [[0, -1, -2], [1, 2, 3]].map(|shifts: [isize; 3]| shifts.map(at));
            let is_usable = duration.is_finite() && duration.recip().is_finite();
            let are_usable = left.into_iter().chain(right).all(Real::is_finite);
            if !is_usable || !are_usable {
                return Err(SplineError::OutOfRange { index });
            }
            Ok(Span {
                start,
                duration,
                basis: basis(left, right),
            })
        })
        .collect()
}

/// The basis functions by the recurrence of Cox and de Boor (Piegl and Tiller, The NURBS Book,
/// 1997, algorithm A2.2), on polynomials: the span is from 0 to 1, and `left` and `right` are the
/// knots from its ends outwards.
fn basis<S: Real>(left: [S; 3], right: [S; 3]) -> [[S; 4]; 4] {
    let zero = S::zero();
    let mut basis = [[zero; 4]; 4];
    basis[0][0] = S::one();
    for degree in 1..4 {
        let mut saved = [zero; 4];
        for r in 0..degree {
            let (above, below) = (right[r], left[degree - 1 - r]);
            let share = basis[r].map(|c| c / (above - below));
            // Times `above − s` and times `s − below`.
            let shifted = [zero, share[0], share[1], share[2]];
            basis[r] = core::array::from_fn(|k| saved[k] + above * share[k] - shifted[k]);
            saved = core::array::from_fn(|k| shifted[k] - below * share[k]);
        }
        basis[degree] = saved;
    }
    basis
}

/// The search for the control motors of which the curve passes through the keys.
struct Search<'a, S> {
    keys: &'a [(S, Motor<S>)],
    spans: &'a [Span<S>],
    ends: [SplineEnd<S>; 2],
    /// At a natural end: the part of the way from the first control to the third at which the
    /// second is.
    natural: [S; 2],
    /// One more than keys at each end.
    controls: Vec<Motor<S>>,
}

impl<'a, S: Real<Mask = bool>> Search<'a, S> {
    fn new(keys: &'a [(S, Motor<S>)], spans: &'a [Span<S>], ends: [SplineEnd<S>; 2]) -> Self {
        let mut at = keys[0].1;
        let mut controls = Vec::with_capacity(keys.len() + 2);
        controls.push(at);
        for &(_, key) in keys {
            let between = at.reverse() * key;
            at = if between.scalar().less_than(S::zero()) {
                -key
            } else {
                key
            };
            controls.push(at);
        }
        controls.push(at);
        // Without acceleration β″₁ log(~C₀ C₁) + β″₂ log(~C₁ C₂) is zero at the first key, so the
        // three controls lie on one screw; at the last key the same.
        let (zero, one) = (S::zero(), S::one());
        let [first, second, _] = spans[0].shares().map(|share| bend(share, zero));
        let [_, before, last] = spans[spans.len() - 1]
            .shares()
            .map(|share| bend(share, one));
        let part = |near: S, far: S| (one - near / far).recip();
        Self {
            keys,
            spans,
            ends,
            natural: [part(first, second), part(last, before)],
            controls,
        }
    }

    fn converge(&mut self) -> Result<(), SplineError<S>> {
        let goal = S::epsilon() * S::from_integer(1024);
        let (mut relaxation, mut before) = (S::one(), None);
        let mut farthest = 0;
        for _ in 0..400 {
            self.place_ends();
            let (errors, index, worst) = self.errors();
            if !worst.is_finite() {
                return Err(SplineError::OutOfRange { index });
            }
            let is_slow =
                before.is_some_and(|before: S| !worst.less_than(before * S::from_ratio(4, 5)));
            if worst.less_than(goal) {
                if is_slow {
                    return Ok(());
                }
            } else if is_slow {
                // Corrections that overshoot turn round; smaller ones do not.
                relaxation = (relaxation * S::from_ratio(7, 10)).max(S::from_ratio(1, 10));
            }
            (before, farthest) = (Some(worst), index);
            self.correct(errors, relaxation);
        }
        Err(SplineError::NotReached { index: farthest })
    }

    /// Puts the controls beside the ends where the conditions there say.
    fn place_ends(&mut self) {
        let third = S::from_ratio(1, 3);
        let count = self.controls.len();
        // With two keys the two controls depend on each other.
        let rounds = if count == 4 { 64 } else { 1 };
        for _ in 0..rounds {
            let [first, second] = [self.controls[0], self.controls[2]];
            self.controls[1] = match self.ends[0] {
                SplineEnd::Natural => first.interpolate(second, self.natural[0]),
                SplineEnd::Velocity(velocity) => {
                    first * (velocity * (self.spans[0].duration * third)).exp()
                }
            };
            let [before, last] = [self.controls[count - 3], self.controls[count - 1]];
            self.controls[count - 2] = match self.ends[1] {
                SplineEnd::Natural => last.interpolate(before, self.natural[1]),
                SplineEnd::Velocity(velocity) => {
                    let duration = self.spans[self.spans.len() - 1].duration;
                    last * (velocity * -(duration * third)).exp()
                }
            };
        }
    }

    /// The motions by which the controls of the inner keys should move, to first order, if they
    /// were alone; and the key that is farthest from the curve, relative to the size of the keys.
    fn errors(&self) -> (Vec<MotorGenerator<S>>, usize, S) {
        let size = |motor: Motor<S>| {
            let [x, y, z] = motor.translator().displacement().map(S::abs);
            x.max(y).max(z)
        };
        let one = S::one();
        let extent = self
            .keys
            .iter()
            .fold(one, |most, &(_, key)| most.max(size(key)));
        let (mut worst, mut index) = (S::zero(), 0);
        let inner = self.spans.iter().enumerate().skip(1);
        let errors = inner.map(|(key, span)| {
            let at = span.piece(&self.controls[key..]).motor(S::zero());
            let between = at.reverse() * self.keys[key].1;
            let error = if between.scalar().less_than(S::zero()) {
                (-between).log()
            } else {
                between.log()
            };
            let turn = error.e12.abs().max(error.e13.abs()).max(error.e23.abs());
            let shift = error.e1i.abs().max(error.e2i.abs()).max(error.e3i.abs());
            let found = turn + shift / extent;
            if !found.less_or_equal(worst) {
                (worst, index) = (found, key);
            }
            // The control of this key is seen in another frame than the curve. A rotation of the
            // control moves the curve about an axis that lies half-way between the two frames.
            let to_control = at.reverse() * self.controls[key + 1];
            let half = to_control.along(RotationPath::Short).sqrt();
            half.reverse().transform(error)
        });
        (errors.collect(), index, worst)
    }

    /// Corrects the inner controls by a part of the solution of the tridiagonal system
    /// `B₀ δₖ + B₁ δₖ₊₁ + B₂ δₖ₊₂ = errorₖ` at every inner key, by elimination without pivots: its
    /// rows are positive and dominated by the diagonal, or nearly so.
    fn correct(&mut self, mut errors: Vec<MotorGenerator<S>>, relaxation: S) {
        let count = errors.len();
        let mut above: Vec<S> = Vec::with_capacity(count);
        for row in 0..count {
            let [before, mut diagonal, mut after] =
                [0, 1, 2].map(|k| self.spans[row + 1].basis[k][0]);
            // What the controls beside the ends follow of their neighbours.
            if row == 0 && matches!(self.ends[0], SplineEnd::Natural) {
                diagonal += before * self.natural[0];
            }
            if row + 1 == count {
                if matches!(self.ends[1], SplineEnd::Natural) {
                    diagonal += after * self.natural[1];
                }
                after = S::zero();
            }
            if row > 0 {
                diagonal -= before * above[row - 1];
                errors[row] = errors[row] - errors[row - 1] * before;
            }
            above.push(after / diagonal);
            errors[row] *= diagonal.recip();
        }
        let mut next = zero();
        for row in (0..count).rev() {
            next = errors[row] - next * above[row];
            let control = &mut self.controls[row + 2];
            *control *= (next * relaxation).exp();
        }
    }
}
