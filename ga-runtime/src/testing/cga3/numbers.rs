//! Geometric numbers: coordinates, directions, angles, weights.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use proptest::prelude::*;
use proptest::sample::select;

use crate::scalar::{Mask, Real};
use crate::vga3::Vector;

/// Angles in [0, 2π].
///
/// Half are drawn uniformly; one in eight is 0, ½π, π, 3/2 π or 2π; one in eight is small, from
/// 10⁻¹⁶ to 0.1, and one in sixteen so small that its square is zero; the rest differ from π by
/// 10⁻⁶ to 10⁻¹², or are less than 2π by as much.
pub fn angles<S: Real>() -> impl Strategy<Value = S> + Clone {
    prop_oneof![
        8 => 0.0..=TAU,
        2 => select(&[0.0, FRAC_PI_2, PI, PI + FRAC_PI_2, TAU]),
        2 => power_of_ten(-16.0, -1.0),
        1 => select(&[1e-300, 1e-200]),
        3 => (select(&[PI, PI, TAU]), power_of_ten(-12.0, -6.0), any::<bool>()).prop_map(
            |(place, offset, above)| if above && place == PI { place + offset } else { place - offset },
        ),
    ]
    .prop_map(S::from_f64)
}

/// Vectors of length 1 up to rounding.
///
/// Three in four are drawn uniformly from the unit sphere; one in eight is a basis vector or its
/// negative; one in eight differs from such a vector by 10⁻³ to 10⁻¹².
pub fn directions<S: Real>() -> impl Strategy<Value = [S; 3]> + Clone {
    unit_vectors().prop_map(|direction| direction.map(S::from_f64))
}

/// Weights of homogeneous objects: an object times such a number is the same object. Half are 1,
/// the others from 10⁻² to 10² in size, of either sign.
pub fn weights<S: Real>() -> impl Strategy<Value = S> + Clone {
    prop_oneof![
        Just(1.0),
        (power_of_ten(-2.0, 2.0), any::<bool>()).prop_map(|(size, negative)| if negative {
            -size
        } else {
            size
        }),
    ]
    .prop_map(S::from_f64)
}

/// A coordinate: three in four drawn uniformly from −`size` to `size`, one in eight 0 or ±`size`,
/// one in eight 10⁻³ to 10⁻¹² of `size`.
pub(super) fn coordinates(size: f64) -> impl Strategy<Value = f64> + Clone {
    prop_oneof![
        6 => -size..=size,
        1 => select(&[0.0, -1.0, 1.0]).prop_map(move |factor| factor * size),
        1 => (power_of_ten(-12.0, -3.0), any::<bool>())
            .prop_map(move |(factor, negative)| if negative { -factor * size } else { factor * size }),
    ]
}

pub(super) fn places(size: f64) -> impl Strategy<Value = [f64; 3]> + Clone {
    let coordinate = coordinates(size);
    [coordinate.clone(), coordinate.clone(), coordinate]
}

pub(super) fn unit_vectors() -> impl Strategy<Value = [f64; 3]> + Clone {
    let anywhere = (-1.0..=1.0_f64, 0.0..TAU).prop_map(|(z, azimuth)| {
        let across = (1.0 - z * z).sqrt();
        [across * azimuth.cos(), across * azimuth.sin(), z]
    });
    let axis = (0..3_usize, select(&[-1.0, 1.0])).prop_map(|(place, sign)| {
        let mut axis = [0.0; 3];
        axis[place] = sign;
        axis
    });
    let beside_an_axis = (axis.clone(), anywhere.clone(), power_of_ten(-12.0, -3.0))
        .prop_map(|(axis, offset, size)| normalized(sum(axis, scaled(offset, size))));
    prop_oneof![6 => anywhere, 1 => axis, 1 => beside_an_axis]
}

/// A length: three in four drawn uniformly from a hundredth of `size` to `size`; one in eight
/// `size`; one in eight 10⁻² to 10⁻⁶ of it.
pub(super) fn lengths(size: f64) -> impl Strategy<Value = f64> + Clone {
    lengths_from(1e-6, size)
}

/// A radius that rounding does not make indistinguishable from zero for a round about one of the
/// [`places`]: as [`lengths`], but at least 6·10⁻³ of `size` for scalars such as `f32`.
pub(super) fn radii<S: Real>(size: f64) -> impl Strategy<Value = f64> + Clone {
    let is_coarse = S::from_f64(1e-14).less_than(S::epsilon()).any();
    lengths_from(if is_coarse { 6e-3 } else { 1e-6 }, size)
}

fn lengths_from(least: f64, size: f64) -> impl Strategy<Value = f64> + Clone {
    prop_oneof![
        6 => 0.01 * size..=size,
        1 => Just(size),
        1 => power_of_ten(least.log10(), -2.0).prop_map(move |factor| factor * size),
    ]
}

/// A power of ten whose exponent is drawn uniformly.
pub(super) fn power_of_ten(least: f64, most: f64) -> impl Strategy<Value = f64> + Clone {
    (least..=most).prop_map(|exponent| 10.0_f64.powf(exponent))
}

pub(super) fn sum(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(super) fn scaled(a: [f64; 3], factor: f64) -> [f64; 3] {
    a.map(|x| x * factor)
}

/// A unit vector orthogonal to both; orthogonal to the first alone where they are parallel.
pub(super) fn across(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    let cross = |b: [f64; 3]| Vector::from(a).cross(b.into()).coordinates();
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let candidates = [b, axes[0], axes[1]].map(cross);
    let long_enough = |v: &&[f64; 3]| v.iter().map(|x| x * x).sum::<f64>() > 1e-4;
    normalized(
        *candidates
            .iter()
            .find(long_enough)
            .unwrap_or(&candidates[2]),
    )
}

fn normalized(a: [f64; 3]) -> [f64; 3] {
    let length = a.iter().map(|x| x * x).sum::<f64>().sqrt();
    a.map(|x| x / length)
}
