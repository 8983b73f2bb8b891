//! Rotors, translators, motors, dilators and similarities.

use proptest::prelude::*;
use proptest::sample::select;

use super::numbers::{angles, directions, places};
use super::points::points;
use crate::cga3::{Dilator, Motor, Rotor, Similarity, Translator};
use crate::scalar::Real;

/// Unit rotors: rotations by one of the [`angles`](super::angles) in [0, 2π] about one of the
/// [`directions`](super::directions), so that a rotor and its negative both occur, and half turns,
/// full turns and angles near zero.
pub fn rotors<S: Real<Mask = bool>>() -> impl Strategy<Value = Rotor<S>> + Clone {
    (directions(), angles()).prop_filter_map("an axis of length 1", |(axis, angle)| {
        Rotor::from_axis_angle(axis, angle)
    })
}

/// Translations by the coordinates of one of the [`points`](super::points), so also by 0 along some
/// axis and by 10⁻³ to 10⁻¹² of `size`. One in eight is the identity.
pub fn translators<S: Real>(size: f64) -> impl Strategy<Value = Translator<S>> + Clone {
    prop_oneof![7 => places(size), 1 => Just([0.0; 3])]
        .prop_map(|displacement| Translator::from_displacement(displacement.map(S::from_f64)))
}

/// Rigid motions whose translation, or axis, is within a few times `size` of the origin.
///
/// Half are one of the [`rotors`] and then one of the [`translators`]. Otherwise, one in eight
/// each: a rotation about an axis through one of the [`points`](super::points), with no translation
/// along it; a screw along such an axis; a translation alone; 1 or −1. The motor of a translation
/// is minus the translator in half of the cases.
pub fn motors<S: Real<Mask = bool>>(size: f64) -> impl Strategy<Value = Motor<S>> + Clone {
    let sign = select(&[1, -1]);
    prop_oneof![
        4 => (translators(size), rotors())
            .prop_map(|(translation, rotation)| translation * rotation),
        1 => (points(size), rotors()).prop_map(|(point, rotation)| Motor::about(point, rotation)),
        1 => (points(size), rotors(), -size..=size).prop_map(|(point, rotation, slide)| {
            let (axis, _) = rotation.to_axis_angle();
            let slide = S::from_f64(slide);
            Translator::from_displacement(axis.map(|x| x * slide)) * Motor::about(point, rotation)
        }),
        1 => (translators(size), sign.clone())
            .prop_map(|(translation, sign)| signed(translation.into(), sign)),
        1 => sign.prop_map(|sign| signed(Motor::default(), sign)),
    ]
}

/// Scalings about the origin by a factor from 1/`factor` to `factor`, which is greater than 1.
///
/// In three of four the logarithm is drawn uniformly; one in eight is 1, `factor` or 1/`factor`,
/// and one in eight `1 + 10⁻⁹`.
pub fn dilators<S: Real<Mask = bool>>(factor: f64) -> impl Strategy<Value = Dilator<S>> + Clone {
    let range = factor.ln();
    prop_oneof![
        6 => -range..=range,
        1 => select(&[0.0, -1.0, 1.0]).prop_map(move |t| t * range),
        1 => Just(1e-9),
    ]
    .prop_filter_map("a positive factor", |logarithm| {
        Dilator::from_factor(S::from_f64(logarithm.exp()))
    })
}

/// One of the [`dilators`] and then one of the [`motors`].
pub fn similarities<S: Real<Mask = bool>>(
    size: f64,
    factor: f64,
) -> impl Strategy<Value = Similarity<S>> + Clone {
    (motors(size), dilators(factor)).prop_map(|(motion, scaling)| motion * scaling)
}

fn signed<S: Real>(motor: Motor<S>, sign: i64) -> Motor<S> {
    if sign < 0 { -motor } else { motor }
}
