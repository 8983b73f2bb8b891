//! The logarithm of any even versor.
//!
//! An even versor is `V = C + S` with the bivector S and `C = cosh √(B²)`, a scalar and a 4-vector,
//! for `B = log V`. C commutes with S, `S² = C² − 1`, and `B = S h` where h is the function
//! `arcosh C / √(C² − 1)` of C. With `C = cosh x cos y + J sinh x sin y` and `J² = −1` that is one
//! scaling by x with one rotation by y; where the square of the 4-vector is positive both are
//! rotations, and x is imaginary.
//!
//! Every even versor with `V ~V = 1` has a logarithm: where V is the negative of a scaling or of a
//! translation, a full turn that commutes with it gives the sign.

use super::conformal_exponential::{coefficients, is_finite, times};
use super::number_pair::{arsinh_ratio, arsinh_ratio_factors, nested_series};
use crate::cga3::{
    Bivector, Even, EvenVersor, Quadvector, RoundVector, Similarity, SimilarityGenerator,
};
use crate::scalar::Real;

impl<S: Real<Mask = bool>> EvenVersor<S> {
    /// A bivector B with `exp(B) = V`. Every even versor with `V ~V = 1` has one. If V is not
    /// finite, all coefficients of the result are NaN; if squares of coefficients of V are beyond
    /// the range of the scalar, some of them are.
    ///
    /// The angles of the rotations are on the branch of [`Motor::log`](crate::cga3::Motor::log): a
    /// rotation is by θ in [0, 2π], so that `exp(B)` restores the sign of V too, and for two
    /// commuting rotations by angles `θ ≥ φ ≥ 0` the sum is at most 2π. Where V does not determine
    /// the plane of a full turn, one is chosen: −1 is a full turn in e12, and the negative of a
    /// scaling or translation contains a full turn in a plane that commutes with it.
    ///
    /// Near 2π, where a small change of V changes the plane of the rotation, errors grow as one
    /// over the distance from it.
    ///
    /// ```
    /// use ga_runtime::cga3::{EvenVersor, Rotor, Similarity, Transversor};
    /// let rotation = Rotor::from_axis_angle([0.0, 0.6, 0.8], 2.5).unwrap();
    /// let similarity = Similarity::from_parts([1.0, 2.0, 3.0], rotation, 4.0).unwrap();
    /// let bend = Transversor::from_vector([0.1, 0.2, 0.3_f64]);
    /// let versor = EvenVersor::from(bend) * EvenVersor::from(similarity);
    /// let again = versor.log().exp().unwrap();
    /// assert!((again.e12oi() - versor.e12oi()).abs() < 1e-14);
    /// ```
    #[must_use]
    pub fn log(self) -> Bivector<S> {
        let (zero, one) = (S::zero(), S::one());
        let (scalar, sine, rest) = parts(self);
        if !is_finite(self.into()) {
            let nan = S::from_f64(f64::NAN);
            return Bivector::new(nan, nan, nan, nan, nan, nan, nan, nan, nan, nan);
        }
        let pi = S::from_f64(core::f64::consts::PI);
        let still = Even {
            scalar: zero,
            ..self.into()
        };
        if scalar.less_than(zero) && is_rounding(still, one) {
            return Bivector {
                e12: pi,
                ..Bivector::default()
            };
        }
        let (square, square_error) = fourvector_square(rest);
        let size = largest(self.into());
        let (difference, error) = sine_squares(scalar, sine, [square, square_error], size);
        let two = one + one;
        let is_ahead = zero.less_than(scalar);
        let extent = difference.abs() + two * square.abs().sqrt();
        if is_ahead && !S::from_ratio(1, 32).less_than(extent) {
            let number = [difference + two * square, two * scalar];
            let [h, k] = nested_series(number, square, arsinh_ratio_factors());
            return sine * h + times(sine, rest) * k;
        }
        // Every coefficient has a rounding error of the size of the largest coefficient.
        let error = error + size * largest(sine.into());
        if !is_ahead && is_negligible(-difference, error) && is_rounding(rest.into(), size) {
            return -sine * arsinh_ratio(difference.max(zero)) + whole_turn(sine) * pi;
        }
        let half = S::from_ratio(1, 2);
        // √(difference² − 4 square), without squaring anything as large as the square of a
        // coefficient.
        let reach = two * square.abs().sqrt();
        let scale = difference.abs().max(reach);
        let (part, other) = (difference / scale, reach / scale);
        let gap = if zero.less_than(square) {
            ((part - other) * (part + other)).max(zero).sqrt() * scale
        } else {
            (part * part + other * other).sqrt() * scale
        };
        if zero.less_than(square) && gap.less_than(difference.abs() * half) {
            return isoclinic(scalar, sine, rest, [square.sqrt(), size]);
        }
        // The squares of sinh x and of sin y; the one computed without cancellation comes first.
        let (growth, turn) = if difference.less_than(zero) {
            let turn = (gap - difference) * half;
            (-square / turn, turn)
        } else {
            let growth = (gap + difference) * half;
            let turn = if zero.less_than(growth) {
                (-square / growth).max(zero)
            } else {
                zero
            };
            (growth, turn)
        };
        let (ratio, cosh) = (arsinh_ratio(growth), (one + growth).sqrt());
        let (sin, cos) = (turn.sqrt(), scalar / cosh);
        let angle = sin.atan2(cos);
        let sum = growth + turn;
        let h = (ratio * growth * cos + angle * sin * cosh) / sum;
        let cotangent = if zero.less_than(sin) {
            angle * cos / sin
        } else {
            one
        };
        let k = (cotangent - ratio * cosh) / sum;
        sine * h + times(sine, rest) * k
    }
}

impl<S: Real<Mask = bool>> Similarity<S> {
    /// The generator G with `exp(G)` the similarity, on the branch of [`EvenVersor::log`]. For the
    /// factor 1 it is the generator of the motor, and it is accurate for factors close to 1.
    ///
    /// ```
    /// use ga_runtime::cga3::{Dilator, Similarity};
    /// let growth = Similarity::from(Dilator::from_factor(4.0_f64).unwrap());
    /// assert!((growth.log().eoi - 2.0_f64.ln()).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn log(self) -> SimilarityGenerator<S> {
        EvenVersor::from(self).log().extract_similarity_generator()
    }
}

/// The scalar, the bivector and the 4-vector.
pub(super) fn parts<S: Real>(v: EvenVersor<S>) -> (S, Bivector<S>, Quadvector<S>) {
    let even = Even::from(v);
    (
        even.scalar,
        even.extract_bivector(),
        even.extract_quadvector(),
    )
}

/// The square of a bivector's scalar part, and the sum of the sizes of its terms.
fn bivector_square<S: Real>(b: Bivector<S>) -> (S, S) {
    let turns = b.e12 * b.e12 + b.e13 * b.e13 + b.e23 * b.e23;
    let growth = b.eoi * b.eoi;
    let mixed = [b.e1o * b.e1i, b.e2o * b.e2i, b.e3o * b.e3i];
    let size = mixed[0].abs() + mixed[1].abs() + mixed[2].abs();
    (b.scalar_product(b), turns + growth + size + size)
}

/// The square of a 4-vector, and the sum of the sizes of its terms.
fn fourvector_square<S: Real>(q: Quadvector<S>) -> (S, S) {
    let mixed = (q.e123o * q.e123i).abs();
    let flat = q.e12oi * q.e12oi + q.e13oi * q.e13oi + q.e23oi * q.e23oi;
    (q.scalar_product(q), flat + mixed + mixed)
}

/// `sinh² x − sin² y`, which is the scalar part of S² minus twice the square of the 4-vector, from
/// S or from the scalar part of V alone, whichever rounds less, and the size of its terms. The
/// product of the two squares is minus the square of the 4-vector.
fn sine_squares<S: Real<Mask = bool>>(
    scalar: S,
    sine: Bivector<S>,
    [square, square_error]: [S; 2],
    size: S,
) -> (S, S) {
    let (from_sine, sine_error) = bivector_square(sine);
    let one = S::one();
    // The scalar has been rounded to the size of the other coefficients.
    let cosine_error = one + scalar.abs() * size;
    if cosine_error.less_than(sine_error) {
        let difference = (scalar - one) * (scalar + one) - square;
        (difference, cosine_error + square_error)
    } else {
        (from_sine - (square + square), sine_error + square_error)
    }
}

fn largest<S: Real>(element: Even<S>) -> S {
    let coefficients = coefficients(element).into_iter();
    coefficients.fold(S::zero(), |most, x| most.max(x.abs()))
}

/// Whether an element is negligible in comparison with one of the given size.
fn is_rounding<S: Real<Mask = bool>>(element: Even<S>, size: S) -> bool {
    !(S::from_integer(16) * S::epsilon() * size).less_than(largest(element))
}

/// Whether a square is zero up to rounding, for terms of the given size.
fn is_negligible<S: Real<Mask = bool>>(square: S, terms: S) -> bool {
    !(S::from_integer(16) * S::epsilon() * terms).less_than(square)
}

/// Two rotations by nearly the same angle: on the subspace where the unit 4-vector J is 1 they
/// rotate by the difference of their angles, where it is −1 by the sum. The sizes are those of the
/// 4-vector and of the largest coefficient.
fn isoclinic<S: Real<Mask = bool>>(
    scalar: S,
    sine: Bivector<S>,
    rest: Quadvector<S>,
    [size, whole]: [S; 2],
) -> Bivector<S> {
    let (zero, half) = (S::zero(), S::from_ratio(1, 2));
    let turned = times(sine, rest) * size.recip();
    let mut log = Bivector::default();
    for sign in [S::one(), -S::one()] {
        let part = (sine + turned * sign) * half;
        let cosine = scalar + sign * size;
        let (square, terms) = bivector_square(part);
        let sine_squared = (-(square + square)).max(zero);
        let is_still = is_negligible(sine_squared, terms + terms + whole * largest(part.into()))
            || is_rounding(part.into(), whole);
        log += if is_still && cosine.less_than(zero) {
            half_of_whole_turn(rest, size, sign) * S::from_f64(core::f64::consts::PI)
        } else if is_still {
            part
        } else {
            let sine = sine_squared.sqrt();
            part * (sine.atan2(cosine) / sine)
        };
    }
    log
}

/// `A (1 ± J)/2` for a unit bivector A that commutes with J: the part of e12 that commutes.
fn half_of_whole_turn<S: Real<Mask = bool>>(rest: Quadvector<S>, size: S, sign: S) -> Bivector<S> {
    let unit = rest * size.recip();
    let axis = unit.dual();
    let square = axis.scalar_product(axis);
    let [e1, e2] = [[1, 0], [0, 1]].map(|[x, y]| {
        let vector = RoundVector::new(
            S::from_integer(x),
            S::from_integer(y),
            S::zero(),
            S::zero(),
            S::zero(),
        );
        vector - axis * ((vector | axis) / square)
    });
    let blade = e1 ^ e2;
    let blade = blade * (-(blade.scalar_product(blade))).sqrt().recip();
    (blade + times(blade, unit) * sign) * S::from_ratio(1, 2)
}

/// A unit 2-blade of a rotation that commutes with a 2-blade that is not of a rotation; e12 for
/// zero.
fn whole_turn<S: Real<Mask = bool>>(generator: Bivector<S>) -> Bivector<S> {
    let (zero, one) = (S::zero(), S::one());
    let mut best = Bivector {
        e12: one,
        ..Bivector::default()
    };
    let across = generator.dual();
    let mut quality = zero;
    for place in [2, 1, 0, 3, 4] {
        let [x, y, z, o, i] = [0, 1, 2, 3, 4].map(|k| if k == place { one } else { zero });
        let blade = RoundVector::new(x, y, z, o, i) | across;
        let (square, terms) = bivector_square(blade);
        let found = -square / terms;
        if quality.less_than(found) {
            quality = found;
            best = blade;
        }
    }
    unit_plane(best)
}

/// The unit 2-blade of a rotation that is nearest to a bivector: the outer product of two vectors
/// of its plane, since the bivector may be a blade up to rounding only, and a full turn needs one.
fn unit_plane<S: Real<Mask = bool>>(bivector: Bivector<S>) -> Bivector<S> {
    let (zero, one) = (S::zero(), S::one());
    let (mut first, mut quality) = (RoundVector::default(), zero);
    for place in 0..5 {
        let [x, y, z, o, i] = [0, 1, 2, 3, 4].map(|k| if k == place { one } else { zero });
        let vector = RoundVector::new(x, y, z, o, i) | bivector;
        let flat = vector.e1 * vector.e1 + vector.e2 * vector.e2 + vector.e3 * vector.e3;
        let size = flat + vector.eo * vector.eo + vector.ei * vector.ei;
        let found = vector.scalar_product(vector) / size;
        if quality.less_than(found) {
            (first, quality) = (vector, found);
        }
    }
    let second = first | bivector;
    let blade = second ^ first;
    blade * (-(blade.scalar_product(blade))).sqrt().recip()
}
