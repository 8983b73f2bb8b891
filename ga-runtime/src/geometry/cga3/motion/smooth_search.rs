//! The search for the control motors of a smooth spline.

use alloc::vec::Vec;

use super::span::{Span, spans};
use super::spline::{SplineError, bend, value, zero};
use super::spline_end::SplineEnd;
use crate::cga3::{Motor, MotorGenerator};
use crate::geometry::RotationPath;
use crate::geometry::cga3::logarithm::{generator, parts};
use crate::geometry::cga3::matrix::{Matrix, solve_tridiagonal, transposed};
use crate::scalar::Real;
use crate::vga3::Vector;

/// Keys, the spans between them, and one generator more than keys: two more than spans.
type Found<S> = (Vec<(S, Motor<S>)>, Vec<Span<S>>, Vec<MotorGenerator<S>>);

/// The generators `log(~Cᵢ₋₁ Cᵢ)` between the controls with which the curve passes through the
/// keys, and the keys: those given, with more between them where that is needed.
pub(super) fn search<S: Real<Mask = bool>>(
    given: &[(S, Motor<S>)],
    ends: [SplineEnd<S>; 2],
) -> Result<Found<S>, SplineError<S>> {
    let mut keys = given.to_vec();
    let mut spans_between = spans(&keys)?;
    let most = 8 * given.len() + 64;
    let (mut place, _) = keys[0];
    for _ in 0..most {
        let system = System::new(&keys, &spans_between, ends);
        if let Some(index) = system.steps.iter().position(|step| !step.is_number()) {
            let index = key_before(given, keys[index].0);
            return Err(SplineError::OutOfRange { index });
        }
        let stop = match system.solution() {
            Ok(generators) => return Ok((keys, spans_between, generators)),
            Err(stop) => stop,
        };
        let near = stop.saturating_sub(1)..(stop + 2).min(spans_between.len());
        let longest = near.fold(stop, |most, k| {
            let is_longer = spans_between[most]
                .duration
                .less_than(spans_between[k].duration);
            if is_longer { k } else { most }
        });
        let half = S::from_ratio(1, 2);
        let [(start, from), (_, to)] = [keys[longest], keys[longest + 1]];
        place = start;
        let middle = spans_between[longest].duration.mul_add(half, start);
        keys.insert(longest + 1, (middle, from.interpolate(to, half)));
        // An error where no number lies between the two times.
        match spans(&keys) {
            Ok(divided) => spans_between = divided,
            Err(_) => break,
        }
    }
    let index = key_before(given, place);
    Err(SplineError::NotReached { index })
}

/// The last of the given keys that is not after the start of a span.
pub(super) fn key_before<S: Real<Mask = bool>>(given: &[(S, Motor<S>)], start: S) -> usize {
    let after = given.partition_point(|&(at, _)| !start.less_than(at));
    after.saturating_sub(1)
}

/// The equations for the generators x: from key to key, the curve makes the step
///
/// ```text
/// exp(−b xₖ₊₁) exp(a xₖ) exp(c xₖ₊₁) exp(d xₖ₊₂)
/// ```
///
/// with the sums of basis functions at both keys as a, b, c, d. The first generator and the last
/// are given by the second and by the last but one.
///
/// Rotations do not depend on translations, and with known rotations the equations for the
/// translations are linear. Their matrix is the derivative of the rotations, since a motor is a
/// rotor with dual numbers as coefficients.
struct System<S> {
    steps: Vec<Step<S>>,
    ends: [End<S>; 2],
}

/// The motion from a key to the next, its generator, and the factors −b, a, c, d.
struct Step<S> {
    motor: Motor<S>,
    log: MotorGenerator<S>,
    factors: [S; 4],
}

/// Of which generator, counted from that of the step, each factor is.
const PLACES: [usize; 4] = [1, 0, 1, 2];

/// The outermost generator: the one beside it times a factor, plus a given one.
struct End<S> {
    factor: S,
    given: MotorGenerator<S>,
}

impl<S: Real<Mask = bool>> Step<S> {
    fn is_number(&self) -> bool {
        let (g, h) = parts(self.log);
        (g.length() + h.length()).is_finite()
    }
}

impl<S: Real<Mask = bool>> System<S> {
    fn new(keys: &[(S, Motor<S>)], spans: &[Span<S>], ends: [SplineEnd<S>; 2]) -> Self {
        let (zero_, one) = (S::zero(), S::one());
        let steps = keys.windows(2).zip(spans).map(|(pair, span)| {
            let [(_, from), (_, to)] = [pair[0], pair[1]];
            let motor = (from.reverse() * to).along(RotationPath::Short);
            let [first, second, third] = span.shares();
            let factors = [
                -value(second, zero_),
                one - value(first, zero_),
                value(second, one),
                value(third, one),
            ];
            Step {
                motor,
                log: motor.log(),
                factors,
            }
        });
        // At the first key the acceleration is `β″₁ x₀ + β″₂ x₁`, at the last key the same of the
        // last two.
        let [first, second, _] = spans[0].shares().map(|share| bend(share, zero_));
        let [_, before, last] = spans[spans.len() - 1]
            .shares()
            .map(|share| bend(share, one));
        let end = |end, span: &Span<S>, factor: S| match end {
            SplineEnd::Natural => End {
                factor,
                given: zero(),
            },
            SplineEnd::Velocity(velocity) => End {
                factor: zero_,
                given: velocity * (span.duration * S::from_ratio(1, 3)),
            },
        };
        Self {
            steps: steps.collect(),
            ends: [
                end(ends[0], &spans[0], -second / first),
                end(ends[1], &spans[spans.len() - 1], -before / last),
            ],
        }
    }

    /// All generators; or where no solution was found, the index of the step that stops the search.
    fn solution(&self) -> Result<Vec<MotorGenerator<S>>, usize> {
        let mut inner = alloc::vec![zero(); self.steps.len()];
        let smallest = S::from_ratio(1, 256);
        let (mut part, mut advance) = (S::zero(), S::one());
        while part.less_than(S::one()) {
            let next = (part + advance).min(S::one());
            match self.rotations(&inner, next) {
                Ok(found) => {
                    (inner, part) = (found, next);
                    advance += advance;
                }
                Err(stop) if advance.less_than(smallest) => return Err(stop),
                Err(_) => advance = (next - part) * S::from_ratio(1, 2),
            }
        }
        // The first of these finds the translations, the second removes its rounding.
        for _ in 0..2 {
            let corrections = self.corrections(&inner, part)?;
            for (generator, correction) in inner.iter_mut().zip(corrections) {
                *generator += correction;
            }
        }
        Ok(self.with_ends(&inner, part))
    }

    /// The inner generators, their rotations alone, for a part of the motion from key to key, from
    /// those for a part that is near. Fails at the step whose correction does not shrink.
    fn rotations(
        &self,
        near: &[MotorGenerator<S>],
        part: S,
    ) -> Result<Vec<MotorGenerator<S>>, usize> {
        // Corrections that shrink from the first on leave no doubt of the solution to which they
        // lead; below this, the next one is of the size of rounding.
        let (half, enough) = (S::from_ratio(1, 2), S::epsilon().sqrt());
        let mut inner = near.to_vec();
        let mut before = None;
        loop {
            let corrections = self.corrections(&inner, part)?;
            let (mut largest, mut place) = (S::zero(), 0);
            for (index, (generator, correction)) in inner.iter_mut().zip(corrections).enumerate() {
                let (g, _) = parts(correction);
                let size = g.length();
                if !size.less_or_equal(largest) {
                    (largest, place) = (size, index);
                }
                *generator += rotation(g);
            }
            if largest.less_than(enough) {
                return Ok(inner);
            }
            let is_smaller = before.is_none_or(|before: S| largest.less_than(before * half));
            if !largest.is_finite() || !is_smaller {
                return Err(place);
            }
            before = Some(largest);
        }
    }

    /// The step of Newton's method.
    fn corrections(
        &self,
        inner: &[MotorGenerator<S>],
        part: S,
    ) -> Result<Vec<MotorGenerator<S>>, usize> {
        let all = self.with_ends(inner, part);
        let last = self.steps.len() - 1;
        let (mut rows, mut sides) = (Vec::with_capacity(last + 1), Vec::with_capacity(last + 1));
        for (k, step) in self.steps.iter().enumerate() {
            let exponents: [MotorGenerator<S>; 4] =
                core::array::from_fn(|n| all[k + PLACES[n]] * step.factors[n]);
            let motor = exponents.map(MotorGenerator::exp).into_iter();
            let motor = motor
                .reduce(|product, next| product * next)
                .unwrap_or_default();
            let expected = if part.less_than(S::one()) {
                (step.log * part).exp()
            } else {
                step.motor
            };
            let error = (motor.reverse() * expected)
                .along(RotationPath::Short)
                .log();
            let (g, h) = parts(error);
            sides.push([g.coordinates(), h.coordinates()]);

            let mut row = step.derivatives(exponents);
            for (outer, end, is_there) in [(0, 0, k == 0), (2, 1, k == last)] {
                if is_there {
                    let factor = self.ends[end].factor;
                    let outermost = core::mem::replace(&mut row[outer], [[S::zero(); 3]; 3]);
                    add_multiple(&mut row[1], &outermost, factor);
                }
            }
            rows.push(row);
        }
        let solved = solve_tridiagonal(&rows, sides).ok_or(last / 2)?;
        let generators = solved
            .into_iter()
            .map(|[g, h]| generator(g.into(), h.into()));
        Ok(generators.collect())
    }

    fn with_ends(&self, inner: &[MotorGenerator<S>], part: S) -> Vec<MotorGenerator<S>> {
        let outermost =
            |end: &End<S>, beside: MotorGenerator<S>| beside * end.factor + end.given * part;
        let mut all = Vec::with_capacity(inner.len() + 2);
        all.push(outermost(&self.ends[0], inner[0]));
        all.extend_from_slice(inner);
        all.push(outermost(&self.ends[1], inner[inner.len() - 1]));
        all
    }
}

impl<S: Real<Mask = bool>> Step<S> {
    /// The derivatives of the rotation by the three generators: the bivector ξ with `dM = M ξ`,
    /// for each basis bivector in a column.
    fn derivatives(&self, exponents: [MotorGenerator<S>; 4]) -> [Matrix<S, 3>; 3] {
        let (zero, one) = (S::zero(), S::one());
        let axes = [[one, zero, zero], [zero, one, zero], [zero, zero, one]].map(Vector::from);
        let rotations = exponents.map(|exponent| Exponential::of(parts(exponent).0));
        let mut sums = [[[zero; 3]; 3]; 3];
        for (n, rotation) in rotations.iter().enumerate() {
            let columns = axes.map(|axis| {
                let own = rotation.derivative(axis * self.factors[n]);
                let after = rotations[n + 1..].iter();
                after
                    .fold(own, |moved, next| next.reversed(moved))
                    .coordinates()
            });
            add_multiple(&mut sums[PLACES[n]], &transposed(columns), one);
        }
        sums
    }
}

/// The rotor `exp(g)` for a bivector as the vector `(e12, e13, e23)`, where the commutator product
/// of two bivectors is minus the cross product.
struct Exponential<S> {
    g: Vector<S>,
    /// `2 sin φ cos φ/φ`, `2 sin² φ/φ²` with φ = |g|.
    rotation: [S; 2],
    /// `sin² φ/φ²`, `(φ − sin φ cos φ)/φ³`.
    derivative: [S; 2],
}

impl<S: Real<Mask = bool>> Exponential<S> {
    fn of(g: Vector<S>) -> Self {
        let square = g.dot(g);
        let (cosine, ratio, slope) = if square.less_than(S::from_integer(9)) {
            square.sine_by_angle()
        } else {
            let angle = g.length();
            let (sine, cosine) = angle.sin_cos();
            let ratio = sine / angle;
            (cosine, ratio, (cosine - ratio) / angle / angle)
        };
        let sine = ratio * ratio;
        Self {
            g,
            rotation: [ratio * cosine, sine].map(|x| x + x),
            derivative: [sine, cosine.mul_add(slope, sine)],
        }
    }

    /// `exp(−g) w exp(g)`.
    fn reversed(&self, w: Vector<S>) -> Vector<S> {
        self.combined(w, self.rotation)
    }

    /// The ξ of `d exp(g) = exp(g) ξ` for `dg = w`.
    fn derivative(&self, w: Vector<S>) -> Vector<S> {
        self.combined(w, self.derivative)
    }

    fn combined(&self, w: Vector<S>, [first, second]: [S; 2]) -> Vector<S> {
        let once = self.g.cross(w);
        w + once * first + self.g.cross(once) * second
    }
}

fn rotation<S: Real>(g: Vector<S>) -> MotorGenerator<S> {
    generator(g, [S::zero(); 3].into())
}

fn add_multiple<S: Real>(sum: &mut Matrix<S, 3>, matrix: &Matrix<S, 3>, factor: S) {
    for (sum, row) in sum.iter_mut().zip(matrix) {
        for (entry, &x) in sum.iter_mut().zip(row) {
            *entry = x.mul_add(factor, *entry);
        }
    }
}
