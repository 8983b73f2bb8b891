//! Spheres, circles and point pairs.

use proptest::prelude::*;

use super::numbers::{directions, places, radii, scaled, sum, unit_vectors, weights};
use super::points::to_point;
use crate::cga3::{Circle, Point, PointPair, Sphere};
use crate::scalar::Real;

/// Real spheres about one of the [`points`](super::points), times one of the
/// [`weights`](super::weights).
///
/// Of the radii three in four are drawn uniformly from a hundredth of `size` to `size`, one in
/// eight is `size`, and one in eight 10⁻² to 10⁻⁶ of it, to 6·10⁻³ in `f32`, where a smaller radius
/// is not distinguishable from zero. One sphere in eight passes through the origin.
pub fn spheres<S: Real>(size: f64) -> impl Strategy<Value = Sphere<S>> + Clone {
    let through_origin = (unit_vectors(), radii::<S>(size))
        .prop_map(|(direction, radius)| (scaled(direction, radius), radius));
    let balls = prop_oneof![7 => (places(size), radii::<S>(size)), 1 => through_origin];
    (balls, weights::<S>())
        .prop_map(|((centre, radius), weight)| to_sphere(centre, radius) * weight)
}

/// Real circles about one of the [`points`](super::points) with one of the
/// [`directions`](super::directions) as normal, times one of the [`weights`](super::weights). Radii
/// are those of [`spheres`].
pub fn circles<S: Real<Mask = bool>>(size: f64) -> impl Strategy<Value = Circle<S>> + Clone {
    let parts = (places(size), directions(), radii::<S>(size), weights::<S>());
    parts.prop_filter_map("a circle within the range of the scalar", |parts| {
        let (centre, normal, radius, weight) = parts;
        let radius = S::from_f64(radius);
        let circle = Circle::from_centre_normal_radius(to_point(centre), normal, radius)?;
        Some(circle * weight)
    })
}

/// Real point pairs `p∧q`, times one of the [`weights`](super::weights). The centre is one of the
/// [`points`](super::points), the axis one of the [`directions`](super::directions); half the
/// distance of the two is drawn as the radii of [`spheres`] are.
pub fn point_pairs<S: Real>(size: f64) -> impl Strategy<Value = PointPair<S>> + Clone {
    let parts = (
        places(size),
        unit_vectors(),
        radii::<S>(size),
        weights::<S>(),
    );
    parts.prop_map(|(centre, direction, length, weight)| {
        let p: Point<S> = to_point(sum(centre, scaled(direction, -length)));
        let q: Point<S> = to_point(sum(centre, scaled(direction, length)));
        (p ^ q) * weight
    })
}

/// Two real spheres in any relative position, with weights.
///
/// Three in ten are independent. Otherwise, one in ten each: the same sphere; concentric; tangent
/// from outside; tangent from inside; crossing at a right angle; crossing; apart.
pub fn pairs_of_spheres<S: Real>(size: f64) -> impl Strategy<Value = [Sphere<S>; 2]> + Clone {
    let frame = (
        places(size),
        unit_vectors(),
        radii::<S>(size),
        radii::<S>(size),
    );
    let beside = |centre, direction, distance| sum(centre, scaled(direction, distance));
    let pairs = prop_oneof![
        3 => (frame.clone(), places(size)).prop_map(|((c, _, r, s), d)| [(c, r), (d, s)]),
        1 => frame.clone().prop_map(|(c, _, r, _)| [(c, r), (c, r)]),
        1 => frame.clone().prop_map(|(c, _, r, s)| [(c, r), (c, s)]),
        1 => frame.clone().prop_map(move |(c, u, r, s)| [(c, r), (beside(c, u, r + s), s)]),
        1 => frame.clone().prop_map(move |(c, u, r, s)| [(c, r), (beside(c, u, r - s), s)]),
        1 => frame.clone().prop_map(move |(c, u, r, s)| [(c, r), (beside(c, u, r.hypot(s)), s)]),
        1 => (frame.clone(), 0.0..1.0_f64).prop_map(move |((c, u, r, s), t)| {
            let distance = (r - s).abs() * (1.0 - t) + (r + s) * t;
            [(c, r), (beside(c, u, distance), s)]
        }),
        1 => (frame, 0.01..1.0_f64).prop_map(move |((c, u, r, s), t)| {
            [(c, r), (beside(c, u, (r + s) * (1.0 + t)), s)]
        }),
    ];
    (pairs, weights::<S>(), weights::<S>()).prop_map(|([(c, r), (d, s)], first, second)| {
        [to_sphere(c, r) * first, to_sphere(d, s) * second]
    })
}

/// Spheres, half of them real, a quarter with radius zero and a quarter imaginary, times one of the
/// [`weights`](super::weights). Centres, and the sizes of radii, are those of [`spheres`].
pub fn spheres_of_any_kind<S: Real>(size: f64) -> impl Strategy<Value = Sphere<S>> + Clone {
    let parts = (places(size), squared_radii::<S>(size), weights::<S>());
    parts.prop_map(|(centre, squared, weight)| {
        Sphere::from_centre_radius_squared(to_point(centre), S::from_f64(squared)) * weight
    })
}

/// Circles, half of them real, a quarter tangent elements and a quarter imaginary, times one of the
/// [`weights`](super::weights). Centres, normals and the sizes of radii are those of [`circles`].
pub fn circles_of_any_kind<S: Real<Mask = bool>>(
    size: f64,
) -> impl Strategy<Value = Circle<S>> + Clone {
    let parts = (
        places(size),
        directions(),
        squared_radii::<S>(size),
        weights::<S>(),
    );
    parts.prop_filter_map("a circle within the range of the scalar", |parts| {
        let (centre, normal, squared, weight) = parts;
        let squared = S::from_f64(squared);
        let circle = Circle::from_centre_normal_radius_squared(to_point(centre), normal, squared)?;
        Some(circle * weight)
    })
}

/// Point pairs, half of them real, a quarter tangent elements and a quarter imaginary, times one of
/// the [`weights`](super::weights). Centres, axes and the sizes of radii are those of
/// [`point_pairs`].
pub fn point_pairs_of_any_kind<S: Real<Mask = bool>>(
    size: f64,
) -> impl Strategy<Value = PointPair<S>> + Clone {
    let parts = (
        places(size),
        directions(),
        squared_radii::<S>(size),
        weights::<S>(),
    );
    parts.prop_filter_map("a point pair within the range of the scalar", |parts| {
        let (centre, axis, squared, weight) = parts;
        let squared = S::from_f64(squared);
        let pair = PointPair::from_centre_axis_radius_squared(to_point(centre), axis, squared)?;
        Some(pair * weight)
    })
}

fn squared_radii<S: Real>(size: f64) -> impl Strategy<Value = f64> + Clone {
    prop_oneof![
        2 => radii::<S>(size).prop_map(|radius| radius * radius),
        1 => Just(0.0),
        1 => radii::<S>(size).prop_map(|radius| -radius * radius),
    ]
}

fn to_sphere<S: Real>(centre: [f64; 3], radius: f64) -> Sphere<S> {
    Sphere::from_centre_radius(to_point(centre), S::from_f64(radius))
}
