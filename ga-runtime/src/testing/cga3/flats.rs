//! Lines, planes and flat points, single and in special relative positions.

use proptest::prelude::*;

use super::numbers::{
    across, directions, places, power_of_ten, scaled, sum, unit_vectors, weights,
};
use super::points::{points, to_point};
use crate::cga3::{FlatPoint, Infinity, Line, Plane};
use crate::scalar::Real;

/// Lines through one of the [`points`] in one of the [`directions`](super::directions), times one
/// of the [`weights`](super::weights).
pub fn lines<S: Real>(size: f64) -> impl Strategy<Value = Line<S>> + Clone {
    (points(size), directions(), weights::<S>()).prop_map(|(point, direction, weight)| {
        Line::from_point_direction(point, direction) * weight
    })
}

/// Planes through one of the [`points`] with one of the [`directions`](super::directions) as
/// normal, times one of the [`weights`](super::weights).
pub fn planes<S: Real>(size: f64) -> impl Strategy<Value = Plane<S>> + Clone {
    (points(size), directions(), weights())
        .prop_map(|(point, normal, weight)| Plane::from_point_normal(point, normal) * weight)
}

/// Flat points `p∧ei` of the [`points`], times one of the [`weights`](super::weights).
pub fn flat_points<S: Real>(size: f64) -> impl Strategy<Value = FlatPoint<S>> + Clone {
    (points::<S>(size), weights::<S>()).prop_map(|(point, weight)| (point ^ Infinity) * weight)
}

/// Two lines in any relative position, with weights.
///
/// Three in eight are independent, and nearly all of these are skew. Otherwise, one in eight each:
/// the same line; the same with opposite direction; parallel; parallel up to an angle of 10⁻³ to
/// 10⁻¹² radians; crossing in a point.
pub fn pairs_of_lines<S: Real>(size: f64) -> impl Strategy<Value = [Line<S>; 2]> + Clone {
    let frame = (places(size), unit_vectors(), places(size), unit_vectors());
    let angle = power_of_ten(-12.0, -3.0);
    let pairs = prop_oneof![
        3 => frame.clone().prop_map(|(p, u, q, v)| [(p, u), (q, v)]),
        1 => frame.clone().prop_map(|(p, u, ..)| [(p, u), (p, u)]),
        1 => frame.clone().prop_map(|(p, u, ..)| [(p, u), (p, scaled(u, -1.0))]),
        1 => frame.clone().prop_map(|(p, u, q, _)| [(p, u), (q, u)]),
        1 => (frame.clone(), angle).prop_map(|((p, u, q, v), angle)| {
            [(p, u), (q, sum(u, scaled(across(u, v), angle)))]
        }),
        1 => frame.prop_map(|(p, u, _, v)| [(p, u), (p, v)]),
    ];
    (pairs, weights::<S>(), weights::<S>()).prop_map(|([a, b], first, second)| {
        let line = |(place, direction): ([f64; 3], [f64; 3])| {
            Line::from_point_direction(to_point(place), direction.map(S::from_f64))
        };
        [line(a) * first, line(b) * second]
    })
}

/// Two planes in any relative position, with weights.
///
/// Half are independent. Otherwise, one in eight each: the same plane; parallel; parallel up to an
/// angle of 10⁻³ to 10⁻¹² radians; at right angles.
pub fn pairs_of_planes<S: Real>(size: f64) -> impl Strategy<Value = [Plane<S>; 2]> + Clone {
    let frame = (places(size), unit_vectors(), places(size), unit_vectors());
    let angle = power_of_ten(-12.0, -3.0);
    let pairs = prop_oneof![
        4 => frame.clone().prop_map(|(p, m, q, n)| [(p, m), (q, n)]),
        1 => frame.clone().prop_map(|(p, m, ..)| [(p, m), (p, m)]),
        1 => frame.clone().prop_map(|(p, m, q, _)| [(p, m), (q, m)]),
        1 => (frame.clone(), angle).prop_map(|((p, m, q, n), angle)| {
            [(p, m), (q, sum(m, scaled(across(m, n), angle)))]
        }),
        1 => frame.prop_map(|(p, m, q, n)| [(p, m), (q, across(m, n))]),
    ];
    (pairs, weights::<S>(), weights::<S>()).prop_map(|([a, b], first, second)| {
        let plane = |(place, normal): ([f64; 3], [f64; 3])| {
            Plane::from_point_normal(to_point(place), normal.map(S::from_f64))
        };
        [plane(a) * first, plane(b) * second]
    })
}
