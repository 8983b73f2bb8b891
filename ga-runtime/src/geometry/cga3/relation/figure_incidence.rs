//! Which figures lie on others.

use super::figure_distance::{from_place, from_sphere};
use super::tolerance::{angle_within, within};
use super::{Figure, Tolerance};
use crate::scalar::{Mask, Optional, Real};
use crate::vga3::Vector;

pub(super) fn is_on<S: Real>(a: Figure<S>, b: Figure<S>, tolerance: Tolerance<S>) -> S::Mask {
    let (Figure::Circle { centre, radius, .. } | Figure::Sphere { centre, radius }) = a else {
        return is_all_on(a, b, tolerance);
    };
    let is_point = within(radius, tolerance.distance);
    let centre_is_on = is_point
        .when(())
        .is_some_and(|()| is_all_on(Figure::Point(centre), b, tolerance));
    let is_round = (!is_point).when(());
    centre_is_on | is_round.is_some_and(|()| is_all_on(a, b, tolerance))
}

/// The same for a circle or a sphere whose radius is not within the tolerance.
fn is_all_on<S: Real>(a: Figure<S>, b: Figure<S>, tolerance: Tolerance<S>) -> S::Mask {
    let near = |x: S| within(x, tolerance.distance);
    let place_is_on = |p: Vector<S>| from_place(b, p).is_some_and(near);
    let turned = |u: Vector<S>, v: Vector<S>| {
        angle_within(u.cross(v).length(), u.dot(v).abs(), tolerance.angle)
    };
    match (a, b) {
        (Figure::Point(p), _) => place_is_on(p),
        (Figure::PointPair([p, q]), _) => place_is_on(p) & place_is_on(q),
        (Figure::Line { point, direction }, Figure::Line { direction: e, .. }) => {
            turned(direction, e)
                .when(())
                .is_some_and(|()| place_is_on(point))
        }
        (Figure::Line { point, direction }, Figure::Plane { normal, .. }) => {
            let [sine, cosine] = [
                direction.dot(normal).abs(),
                direction.cross(normal).length(),
            ];
            let turned = angle_within(sine, cosine, tolerance.angle);
            turned.when(()).is_some_and(|()| place_is_on(point))
        }
        (Figure::Plane { normal, distance }, Figure::Plane { normal: m, .. }) => {
            let turned = turned(normal, m).when(());
            turned.is_some_and(|()| place_is_on(normal * distance))
        }
        (
            Figure::Sphere { centre, radius },
            Figure::Sphere {
                centre: c,
                radius: r,
            },
        ) => near((centre - c).length()) & near(radius - r),
        (
            Figure::Circle {
                centre,
                normal,
                radius,
            },
            Figure::Plane {
                normal: m,
                distance,
            },
        ) => near((centre.dot(m) - distance).abs() + normal.cross(m).length() * radius),
        (Figure::Circle { .. }, Figure::Sphere { centre, radius }) => from_sphere(a, centre)
            .is_some_and(|[least, most]| near(least - radius) & near(most - radius)),
        (
            Figure::Circle {
                centre,
                normal,
                radius,
            },
            Figure::Circle {
                centre: c,
                normal: m,
                radius: r,
            },
        ) => {
            let tilt = normal.cross(m).length() * radius;
            near((centre - c).length()) & near(radius - r) & near(tilt)
        }
        _ => S::Mask::splat(false),
    }
}
