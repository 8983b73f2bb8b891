//! Points, single and in special relative positions.

use core::array::from_fn;
use core::f64::consts::TAU;

use proptest::collection::vec;
use proptest::prelude::*;

use super::numbers::{across, lengths, places, power_of_ten, scaled, sum, unit_vectors};
use crate::cga3::Point;
use crate::scalar::Real;

/// Points of the cube from −`size` to `size`.
///
/// Of the coordinates three in four are drawn uniformly; one in eight is 0 or ±`size`, and one in
/// eight 10⁻³ to 10⁻¹² of `size`.
pub fn points<S: Real>(size: f64) -> impl Strategy<Value = Point<S>> + Clone {
    places(size).prop_map(to_point)
}

/// N points of the cube from −`size` to `size`, in any relative position.
///
/// Three in ten are independent. Otherwise, one in ten each: all coincide; the first two coincide;
/// the second is 10⁻³ to 10⁻¹² of `size` from the first; all lie on one line; in one plane; on one
/// circle; on one sphere.
///
/// ```
/// use ga_runtime::cga3::{Circle, Point};
/// use ga_runtime::testing::cga3;
/// use proptest::prelude::*;
/// // Three points on one line, or two of which coincide, do not determine a circle: its radius is
/// // `None`, or finite.
/// proptest!(|(points in cga3::point_configurations::<f64, 3>(10.0))| {
///     let [p, q, r] = points;
///     prop_assert!(Circle::through(p, q, r).radius().is_none_or(f64::is_finite));
/// });
/// ```
pub fn point_configurations<S: Real, const N: usize>(
    size: f64,
) -> impl Strategy<Value = [Point<S>; N]> + Clone {
    // A point at most half the size from a centre in the cube of half the size is inside the cube.
    let half = 0.5 * size;
    let frame = (places(half), unit_vectors(), unit_vectors(), lengths(half));
    let numbers = vec(-1.0..=1.0_f64, N);
    let angles = vec(0.0..TAU, N);
    prop_oneof![
        3 => vec(places(size), N),
        1 => places(size).prop_map(|place| alloc::vec![place; N]),
        1 => vec(places(size), N).prop_map(|mut list| {
            if N > 1 {
                list[1] = list[0];
            }
            list
        }),
        1 => (vec(places(half), N), unit_vectors(), power_of_ten(-12.0, -3.0)).prop_map(move |(mut list, offset, factor)| {
            if N > 1 {
                list[1] = sum(list[0], scaled(offset, factor * size));
            }
            list
        }),
        1 => (frame.clone(), numbers.clone()).prop_map(|((centre, u, _, length), numbers)| {
            numbers.iter().map(|t| sum(centre, scaled(u, t * length))).collect()
        }),
        1 => (frame.clone(), angles.clone(), numbers).prop_map(|((centre, u, v, length), angles, numbers)| {
            let list = angles.iter().zip(numbers);
            list.map(|(&angle, t)| on_circle(centre, u, v, t * length, angle)).collect()
        }),
        1 => (frame, angles).prop_map(|((centre, u, v, radius), angles)| {
            angles.iter().map(|&angle| on_circle(centre, u, v, radius, angle)).collect()
        }),
        1 => (places(half), lengths(half), vec(unit_vectors(), N)).prop_map(|(centre, radius, directions)| {
            directions.iter().map(|&u| sum(centre, scaled(u, radius))).collect()
        }),
    ]
    .prop_map(|list| from_fn(|place| to_point(list[place])))
}

pub(super) fn to_point<S: Real>(place: [f64; 3]) -> Point<S> {
    Point::from(place.map(S::from_f64))
}

fn on_circle(centre: [f64; 3], u: [f64; 3], v: [f64; 3], radius: f64, angle: f64) -> [f64; 3] {
    let w = across(u, v);
    let (sine, cosine) = angle.sin_cos();
    let offset = sum(scaled(u, cosine * radius), scaled(w, sine * radius));
    sum(centre, offset)
}
