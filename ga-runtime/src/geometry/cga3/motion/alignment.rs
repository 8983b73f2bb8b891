//! The signs of motors that are to be added: a motor and its negative are the same motion, and a
//! sum needs signs that are consistent.

use crate::cga3::Motor;
use crate::scalar::Real;

/// The motors, each with the sign that brings it nearer to the motor of the largest weight (the
/// first of several); `None` for no motors. A motor that is half a turn away from that one, within
/// rounding, takes the sign that brings it nearer to the sum of the others.
#[inline]
pub(super) fn aligned<S, I>(weighted: I) -> Option<impl Iterator<Item = (S, Motor<S>)>>
where
    S: Real<Mask = bool>,
    I: Iterator<Item = (S, Motor<S>)> + Clone,
{
    let (_, guide) = weighted.clone().reduce(
        |best, next| {
            if best.0.less_than(next.0) { next } else { best }
        },
    )?;
    let guide = rotor_coordinates(guide);
    let cosine = move |motor| rotor_product(guide, rotor_coordinates(motor));
    let others = weighted
        .clone()
        .any(|(_, motor)| is_doubtful(cosine(motor)))
        .then(|| {
            weighted
                .clone()
                .map(|(weight, motor)| (weight, motor, cosine(motor)))
                .filter(|&(.., cosine)| !is_doubtful(cosine))
                .fold([S::zero(); 4], |sum, (weight, motor, cosine)| {
                    let weight = S::select(cosine.less_than(S::zero()), -weight, weight);
                    let rotor = rotor_coordinates(motor);
                    core::array::from_fn(|k| rotor[k].mul_add(weight, sum[k]))
                })
        });
    Some(weighted.map(move |(weight, motor)| {
        let mut cosine = cosine(motor);
        if let Some(others) = others.filter(|_| is_doubtful(cosine)) {
            cosine = rotor_product(others, rotor_coordinates(motor));
        }
        let is_opposite = cosine.less_than(S::zero());
        (weight, if is_opposite { -motor } else { motor })
    }))
}

/// A number with the sign that brings a motor nearer to a guide; `None` where they are half a turn
/// apart, within rounding.
#[inline]
pub(crate) fn relative_sign<S: Real<Mask = bool>>(guide: Motor<S>, motor: Motor<S>) -> Option<S> {
    let cosine = rotor_product(rotor_coordinates(guide), rotor_coordinates(motor));
    (!is_doubtful(cosine)).then_some(cosine)
}

/// Whether the sign of the cosine of half an angle is due to rounding.
#[inline]
fn is_doubtful<S: Real<Mask = bool>>(cosine: S) -> bool {
    !(S::epsilon() * S::from_integer(64)).less_than(cosine.abs())
}

/// The coefficients of the rotation: a unit quaternion, up to the signs of its basis.
#[inline]
pub(super) fn rotor_coordinates<S: Real>(motor: Motor<S>) -> [S; 4] {
    [motor.scalar(), motor.e12(), motor.e13(), motor.e23()]
}

/// For two rotors: the cosine of half the angle between them.
#[inline]
fn rotor_product<S: Real>(a: [S; 4], b: [S; 4]) -> S {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]
}
