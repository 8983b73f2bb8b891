//! Splines of motions whose acceleration is continuous.

use alloc::vec::Vec;

use super::smooth_search::{key_before, search};
use super::span::Span;
use super::spline::{MotorSpline, Piece, SplineError, check, is_number, value};
use super::spline_end::SplineEnd;
use crate::cga3::{Motor, MotorGenerator};
use crate::scalar::Real;

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
    /// For translations it is the cubic spline of points. The generators `log(~Cᵢ₋₁ Cᵢ)`, whose
    /// rotations may exceed a full turn, are found by Newton's method. Where its corrections do not
    /// shrink at once, the rotations from key to key grow from zero to what they are, and the
    /// solution is followed (Allgower and Georg, Introduction to Numerical Continuation Methods,
    /// 2003, chapter 2). Of several solutions, this usually gives the one that comes from rest.
    ///
    /// Keys at times of very different distances may have no such solution if they are rotated far
    /// against each other. Then the longest of the spans where the search ends is divided: a key is
    /// added at the middle of its time, on the screw between its keys, and so on until there is a
    /// solution. The curve remains C² and passes through all keys, and its third derivative jumps
    /// at the added ones too. Where distances of time differ less than fourfold and rotations are
    /// below 90°, a key is hardly ever added.
    ///
    /// From key to key the curve takes the shorter rotation, for any signs of the key motors; in
    /// between it overshoots as cubic splines do, the more the larger the rotations are.
    ///
    /// # Errors
    /// Those of [`MotorSpline::with_velocities`], and [`SplineError::NotReached`] where more than
    /// 64 spans and 8 for each key would have to be divided, as where keys far rotated against each
    /// other are at distances of 10⁻³⁰⁰ and of 1.
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
        let given = keys;
        let (keys, spans, generators) = search(given, ends)?;
        let mut pieces = Vec::with_capacity(spans.len());
        let (_, mut at) = keys[0];
        for (index, span) in spans.iter().enumerate() {
            let piece = piece(span, at, &generators[index..]);
            if !piece.parts.into_iter().all(is_number) {
                let index = key_before(given, span.start);
                return Err(SplineError::OutOfRange { index });
            }
            let (_, next) = keys[index + 1];
            let is_opposite = (piece.motor(S::one()).reverse() * next)
                .scalar()
                .less_than(S::zero());
            at = if is_opposite { -next } else { next };
            pieces.push(piece);
        }
        let (end, _) = keys[keys.len() - 1];
        Ok(Self::of_pieces(pieces, end, at))
    }
}

/// The piece of the curve that begins at a key, from the generators between the four controls
/// of the span.
fn piece<S: Real<Mask = bool>>(
    span: &Span<S>,
    key: Motor<S>,
    generators: &[MotorGenerator<S>],
) -> Piece<S> {
    let shares = span.shares();
    let parts = [generators[0], generators[1], generators[2]];
    // The third basis function is zero at the key.
    let from = [1, 0].into_iter().fold(key, |at, k| {
        at * (parts[k] * -value(shares[k], S::zero())).exp()
    });
    Piece {
        start: span.start,
        duration: span.duration,
        from,
        parts,
        shares,
    }
}
