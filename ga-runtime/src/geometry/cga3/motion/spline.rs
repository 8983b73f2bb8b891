//! Splines of motions through keys.

use alloc::vec::Vec;
use core::fmt::{Debug, Display, Formatter, Result as FmtResult};

use super::blend::is_finite;
use crate::cga3::{Motor, MotorGenerator};
use crate::scalar::Real;

/// A motion through key motors at given times, with a continuous velocity.
///
/// Between two keys M and N, with a duration h between them and the velocities v and w, it is
///
/// `M exp(β₁(s) hv/3) exp(β₂(s) g) exp(β₃(s) hw/3)`, `g = log(exp(−hv/3) ~M N exp(−hw/3))`,
///
/// with s from 0 to 1, `β₁ = 1 − (1 − s)³`, `β₂ = 3s² − 2s³`, `β₃ = s³`: the cubic Hermite curve of
/// Kim, Kim and Shin (A general construction scheme for unit quaternion curves with simple high
/// order derivatives, SIGGRAPH 1995), for motors. For translations it is the cubic Hermite spline
/// of points. Velocities are in the frame of the moved body, `M' = M v`, a generator per unit of
/// time; a body that rotates at the angular velocity ω about its own origin, which moves at the
/// velocity u, both in its own frame, has `v = −½(ω₁ e23 − ω₂ e13 + ω₃ e12) − ½ u ei`.
///
/// [`MotorSpline::smooth`] gives a curve whose acceleration is continuous too.
///
/// The curve is equivariant under changes of frames on either side. Keys on one screw, at times in
/// proportion, give that screw at constant speed. From key to key the curve takes the shorter
/// rotation, for any signs of the key motors. The sign of the result is continuous, so at a key it
/// may differ from the sign of the key motor.
///
/// ```
/// use ga_runtime::cga3::{Motor, Rotor, Translator};
/// use ga_runtime::geometry::motion::MotorSpline;
/// let screw = |t: f64| {
///     Translator::from_displacement([0.0, 0.0, t])
///         * Rotor::from_axis_angle([0.0, 0.0, 1.0], t).unwrap()
/// };
/// let spline = MotorSpline::through(&[0.0, 1.0, 3.0, 3.5].map(|t| (t, screw(t)))).unwrap();
/// let motor: Motor<f64> = spline.evaluate(2.0).unwrap();
/// assert!((motor.translator().displacement()[2] - 2.0).abs() < 1e-14);
/// // Rotates by one radian and rises by one per unit of time: −½ e12 − ½ e3i.
/// let velocity = spline.velocity(2.0).unwrap();
/// assert!((velocity.e12 + 0.5).abs() < 1e-14 && (velocity.e3i + 0.5).abs() < 1e-14);
/// // Before the first key and after the last it is constant.
/// assert_eq!(spline.evaluate(-1.0), Some(screw(0.0)));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct MotorSpline<S> {
    pieces: Vec<Piece<S>>,
    end: S,
    last: Motor<S>,
}

/// The piece from one key to the next: `from` and the exponentials of the parts, each times its
/// share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Piece<S> {
    pub(super) start: S,
    pub(super) duration: S,
    pub(super) from: Motor<S>,
    pub(super) parts: [MotorGenerator<S>; 3],
    /// Cubic polynomials in the position along the piece, from 0 to 1, the lowest power first.
    pub(super) shares: [[S; 4]; 3],
}

/// Keys for which there is no spline.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum SplineError<S> {
    /// There are fewer than two keys.
    TooFewKeys {
        /// The number of keys.
        found: usize,
    },
    /// The time of a key is not finite.
    Time {
        /// The index of the key, from 0.
        index: usize,
        /// Its time.
        time: S,
    },
    /// The time of a key is not after that of the key before it.
    NotRising {
        /// The index of the key, from 0.
        index: usize,
        /// Its time.
        time: S,
    },
    /// The motor or the velocity of a key is not finite.
    NotFinite {
        /// The index of the key, from 0.
        index: usize,
    },
    /// The motion from this key to the next is beyond the range of the scalar.
    OutOfRange {
        /// The index of the key, from 0.
        index: usize,
    },
    /// The search for a smooth spline ends near this key: the motion there is too large for the
    /// time it has.
    NotReached {
        /// The index of the key, from 0.
        index: usize,
    },
}

impl<S: Debug> Display for SplineError<S> {
    fn fmt(&self, f: &mut Formatter<'_>) -> FmtResult {
        match self {
            Self::TooFewKeys { found } => write!(f, "a spline needs two keys, not {found}"),
            Self::Time { index, time } => write!(f, "the time of key {index} is {time:?}"),
            Self::NotRising { index, time } => {
                write!(f, "key {index} at {time:?} is not after the one before it")
            }
            Self::NotFinite { index } => write!(f, "key {index} is not finite"),
            Self::OutOfRange { index } => {
                write!(
                    f,
                    "the motion from key {index} to the next is beyond the range of the scalar"
                )
            }
            Self::NotReached { index } => {
                write!(f, "no smooth spline through key {index} was found")
            }
        }
    }
}

impl<S: Debug> core::error::Error for SplineError<S> {}

impl<S: Real<Mask = bool>> MotorSpline<S> {
    /// The spline through two or more keys, each a time and a motor, with velocities computed from
    /// the keys.
    ///
    /// At an inner key, the velocity is that of the parabola through three keys,
    /// `(h₊ v₋ + h₋ v₊)/(h₋ + h₊)` with the durations h₋, h₊ and the velocities v₋, v₊ of the
    /// screws on both sides (that of Catmull and Rom for equal durations); at the ends it is that
    /// of the screw. Where a large motion follows a small one the curve may overshoot;
    /// [`MotorSpline::with_velocities`] takes velocities of your choice.
    ///
    /// # Errors
    /// Fewer than two keys, times that are not finite or do not increase, motors that are not
    /// finite, motions from key to key beyond the range of the scalar.
    pub fn through(keys: &[(S, Motor<S>)]) -> Result<Self, SplineError<S>> {
        check(keys)?;
        let legs: Vec<_> = keys.windows(2).map(Leg::between).collect();
        let velocity = |index: usize| match (index.checked_sub(1), legs.get(index)) {
            (Some(before), Some(after)) => legs[before].slope_to(after),
            (None, Some(after)) => after.slope(),
            (before, None) => before.map_or_else(zero, |before| legs[before].slope()),
        };
        let moving: Vec<_> = keys
            .iter()
            .enumerate()
            .map(|(index, &(time, motor))| (time, motor, velocity(index)))
            .collect();
        Self::joined(&moving)
    }

    /// The spline through two or more keys, each a time, a motor and the velocity there.
    ///
    /// # Errors
    /// Those of [`MotorSpline::through`], and velocities that are not finite.
    ///
    /// ```
    /// use ga_runtime::cga3::{Motor, MotorGenerator};
    /// use ga_runtime::geometry::motion::{MotorSpline, SplineError};
    /// // A full turn about e3 ends where it began; its velocity distinguishes it from standing
    /// // still.
    /// let round = MotorGenerator::new(-std::f64::consts::PI, 0.0, 0.0, 0.0, 0.0, 0.0);
    /// let keys = [(0.0, Motor::default(), round), (1.0, Motor::default(), round)];
    /// let spline = MotorSpline::with_velocities(&keys).unwrap();
    /// assert!(spline.evaluate(0.5).unwrap().scalar().abs() < 1e-15);
    /// let again = MotorSpline::with_velocities(&[keys[1], keys[0]]);
    /// assert_eq!(again, Err(SplineError::NotRising { index: 1, time: 0.0 }));
    /// ```
    pub fn with_velocities(
        keys: &[(S, Motor<S>, MotorGenerator<S>)],
    ) -> Result<Self, SplineError<S>> {
        let still: Vec<_> = keys.iter().map(|&(time, motor, _)| (time, motor)).collect();
        check(&still)?;
        match keys
            .iter()
            .position(|&(_, _, velocity)| !is_number(velocity))
        {
            Some(index) => Err(SplineError::NotFinite { index }),
            None => Self::joined(keys),
        }
    }

    /// The time of the first key.
    #[must_use]
    pub fn start(&self) -> S {
        self.pieces.first().map_or(self.end, |piece| piece.start)
    }

    /// The time of the last key.
    #[must_use]
    pub fn end(&self) -> S {
        self.end
    }

    /// The motor at a time: before the first key that of the first, after the last that of the
    /// last. `None` for a time that is not a number.
    #[must_use]
    pub fn evaluate(&self, time: S) -> Option<Motor<S>> {
        if is_nan(time) {
            return None;
        }
        if !time.less_than(self.end) {
            return Some(self.last);
        }
        let (piece, s) = self.piece_at(time)?;
        Some(piece.motor(s))
    }

    /// The velocity at a time in the frame of the moved body, a generator per unit of time: the V
    /// of `M' = M V`. It is zero before the first key and after the last; at these two keys it is
    /// that of the adjacent piece. `None` for a time that is not a number.
    #[must_use]
    pub fn velocity(&self, time: S) -> Option<MotorGenerator<S>> {
        if is_nan(time) {
            return None;
        }
        if time.less_than(self.start()) || self.end.less_than(time) {
            return Some(zero());
        }
        let (piece, s) = self.piece_at(time)?;
        Some(piece.velocity(s))
    }

    /// The acceleration at a time in the frame of the moved body, the derivative of the
    /// [velocity](Self::velocity). It is zero before the first key and after the last; at a key it
    /// is that of the piece that begins there, at the last that of the piece before. `None` for a
    /// time that is not a number.
    #[must_use]
    pub fn acceleration(&self, time: S) -> Option<MotorGenerator<S>> {
        if is_nan(time) {
            return None;
        }
        if time.less_than(self.start()) || self.end.less_than(time) {
            return Some(zero());
        }
        let (piece, s) = self.piece_at(time)?;
        Some(piece.acceleration(s))
    }

    /// The spline of these pieces, up to the last key.
    pub(super) fn of_pieces(pieces: Vec<Piece<S>>, end: S, last: Motor<S>) -> Self {
        Self { pieces, end, last }
    }

    /// The piece at a time up to the end, and the position along it, in [0, 1].
    fn piece_at(&self, time: S) -> Option<(&Piece<S>, S)> {
        let after = self
            .pieces
            .partition_point(|piece| !time.less_than(piece.start));
        match after.checked_sub(1) {
            Some(index) => {
                let piece = &self.pieces[index];
                let s = (time - piece.start) / piece.duration;
                Some((piece, s.min(S::one())))
            }
            None => self.pieces.first().map(|piece| (piece, S::zero())),
        }
    }

    fn joined(keys: &[(S, Motor<S>, MotorGenerator<S>)]) -> Result<Self, SplineError<S>> {
        let mut pieces = Vec::with_capacity(keys.len() - 1);
        let (_, mut from, _) = keys[0];
        for (index, pair) in keys.windows(2).enumerate() {
            let [(start, _, leaving), (end, to, arriving)] = [pair[0], pair[1]];
            let duration = end - start;
            let third = duration * S::from_ratio(1, 3);
            let (first, last) = (leaving * third, arriving * third);
            let mut rest = (-first).exp() * from.reverse() * to * (-last).exp();
            let mut arrival = to;
            if rest.scalar().less_than(S::zero()) {
                (rest, arrival) = (-rest, -arrival);
            }
            let parts = [first, rest.log(), last];
            let is_usable = duration.is_finite() && duration.recip().is_finite();
            if !is_usable || !parts.into_iter().all(is_number) {
                return Err(SplineError::OutOfRange { index });
            }
            pieces.push(Piece {
                start,
                duration,
                from,
                parts,
                shares: [[0, 3, -3, 1], [0, 0, 3, -2], [0, 0, 0, 1]]
                    .map(|shares| shares.map(S::from_integer)),
            });
            from = arrival;
        }
        let (end, ..) = keys[keys.len() - 1];
        Ok(Self {
            pieces,
            end,
            last: from,
        })
    }
}

impl<S: Real<Mask = bool>> Piece<S> {
    pub(super) fn motor(&self, s: S) -> Motor<S> {
        self.parts
            .into_iter()
            .zip(self.shares)
            .fold(self.from, |motor, (part, share)| {
                motor * (part * value(share, s)).exp()
            })
    }

    fn velocity(&self, s: S) -> MotorGenerator<S> {
        self.rates(s).0 * self.duration.recip()
    }

    fn acceleration(&self, s: S) -> MotorGenerator<S> {
        let scale = self.duration.recip();
        self.rates(s).1 * scale * scale
    }

    /// The velocity and the acceleration by s, in the frame of the moved body.
    fn rates(&self, s: S) -> (MotorGenerator<S>, MotorGenerator<S>) {
        let two = S::from_integer(2);
        let start = (zero(), zero());
        let parts = self.parts.into_iter().zip(self.shares);
        // Those of the parts so far, transformed by the next one, and its own. The frame in which
        // they are given turns with its velocity, which adds a commutator.
        parts.fold(start, |(velocity, acceleration), (part, share)| {
            let back = (part * -value(share, s)).exp();
            let own = part * slope(share, s);
            let velocity = back.transform(velocity);
            let change = velocity.commutator(own) * two + part * bend(share, s);
            (velocity + own, back.transform(acceleration) + change)
        })
    }
}

/// A cubic polynomial.
pub(super) fn value<S: Real>([c0, c1, c2, c3]: [S; 4], s: S) -> S {
    c3.mul_add(s, c2).mul_add(s, c1).mul_add(s, c0)
}

/// Its derivative.
fn slope<S: Real>([_, c1, c2, c3]: [S; 4], s: S) -> S {
    let (two, three) = (S::from_integer(2), S::from_integer(3));
    (three * c3).mul_add(s, two * c2).mul_add(s, c1)
}

/// Its second derivative.
pub(super) fn bend<S: Real>([_, _, c2, c3]: [S; 4], s: S) -> S {
    let (two, six) = (S::from_integer(2), S::from_integer(6));
    (six * c3).mul_add(s, two * c2)
}

/// The screw from one key to the next.
struct Leg<S> {
    duration: S,
    log: MotorGenerator<S>,
}

impl<S: Real<Mask = bool>> Leg<S> {
    fn between(keys: &[(S, Motor<S>)]) -> Self {
        let [(start, from), (end, to)] = [keys[0], keys[1]];
        let between = from.reverse() * to;
        let short = if between.scalar().less_than(S::zero()) {
            -between
        } else {
            between
        };
        Self {
            duration: end - start,
            log: short.log(),
        }
    }

    fn slope(&self) -> MotorGenerator<S> {
        self.log * self.duration.recip()
    }

    /// The velocity at the key between this screw and the next.
    fn slope_to(&self, next: &Self) -> MotorGenerator<S> {
        // With halves, so that the sum of the durations does not overflow.
        let half = S::from_ratio(1, 2);
        let both = self.duration * half + next.duration * half;
        let share = |duration: S| duration * half / both;
        self.slope() * share(next.duration) + next.slope() * share(self.duration)
    }
}

pub(super) fn check<S: Real<Mask = bool>>(keys: &[(S, Motor<S>)]) -> Result<(), SplineError<S>> {
    if keys.len() < 2 {
        return Err(SplineError::TooFewKeys { found: keys.len() });
    }
    for (index, &(time, motor)) in keys.iter().enumerate() {
        if !time.is_finite() {
            return Err(SplineError::Time { index, time });
        }
        if index > 0 && !keys[index - 1].0.less_than(time) {
            return Err(SplineError::NotRising { index, time });
        }
        if !is_finite(motor) {
            return Err(SplineError::NotFinite { index });
        }
    }
    Ok(())
}

pub(super) fn is_number<S: Real<Mask = bool>>(generator: MotorGenerator<S>) -> bool {
    [
        generator.e12,
        generator.e13,
        generator.e23,
        generator.e1i,
        generator.e2i,
        generator.e3i,
    ]
    .into_iter()
    .all(|x| x.is_finite())
}

fn is_nan<S: Real<Mask = bool>>(x: S) -> bool {
    !(x.less_than(S::zero()) || S::zero().less_than(x) || x.is_finite())
}

pub(super) fn zero<S: Real>() -> MotorGenerator<S> {
    let zero = S::zero();
    MotorGenerator::new(zero, zero, zero, zero, zero, zero)
}
