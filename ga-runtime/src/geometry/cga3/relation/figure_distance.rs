//! Distances of figures.

use super::least::{circle_to_circle, line_to_circle};
use super::{Figure, hypotenuse, parallel};
use crate::scalar::{Mask, Maybe, Optional, Real};
use crate::vga3::Vector;

/// How the least distance of two figures is found that no formula gives: those of a circle from a
/// line and from another circle.
pub(super) type Search<S> = fn(Figure<S>, Figure<S>) -> Maybe<S, S>;

pub(super) fn distance<S: Real>(a: Figure<S>, b: Figure<S>, search: Search<S>) -> Maybe<S, S> {
    use Figure::{Circle, Line, Plane, Point, PointPair, Sphere};
    let always = S::Mask::splat(true);
    match (a, b) {
        (PointPair([p, q]), x) | (x, PointPair([p, q])) => {
            let both = from_place(x, p).zip(from_place(x, q));
            both.map(|(to_p, to_q)| to_p.min(to_q))
        }
        (Sphere { centre, radius }, x) | (x, Sphere { centre, radius }) => {
            from_sphere(x, centre).map(|between| from_surface(between, radius))
        }
        (Plane { normal, distance }, x) | (x, Plane { normal, distance }) => {
            always.when(height(x, normal, distance).abs())
        }
        (Point(p), x) | (x, Point(p)) => from_place(x, p),
        (
            Line { point, direction },
            Line {
                point: q,
                direction: e,
            },
        ) => always.when(line_to_line([point, direction], [q, e])),
        (Line { .. } | Circle { .. }, Circle { .. }) | (Circle { .. }, Line { .. }) => search(a, b),
    }
    .filter(|distance| distance.is_finite())
}

fn finite<S: Real>(x: S) -> Maybe<S, S> {
    x.is_finite().when(x)
}

/// The least distance of a figure from a place.
pub(super) fn from_place<S: Real>(figure: Figure<S>, place: Vector<S>) -> Maybe<S, S> {
    finite(match figure {
        Figure::Point(p) => p.distance(place),
        Figure::PointPair(pair) => {
            let [to_p, to_q] = pair.map(|p| finite(p.distance(place)));
            return to_p.zip(to_q).map(|(to_p, to_q)| to_p.min(to_q));
        }
        Figure::Line { point, direction } => (place - point).across(direction).length(),
        Figure::Plane { normal, distance } => (place.dot(normal) - distance).abs(),
        Figure::Circle {
            centre,
            normal,
            radius,
        } => from_circle(place - centre, normal, radius)[0],
        Figure::Sphere { centre, radius } => (place.distance(centre) - radius).abs(),
    })
}

/// The [`Search`] for single numbers.
pub(super) fn searched<S: Real<Mask = bool>>(a: Figure<S>, b: Figure<S>) -> Option<S> {
    use Figure::{Circle, Line};
    match (a, b) {
        (
            Line { point, direction },
            Circle {
                centre,
                normal,
                radius,
            },
        )
        | (
            Circle {
                centre,
                normal,
                radius,
            },
            Line { point, direction },
        ) => {
            let from = (centre - point).across(direction);
            Some(line_to_circle(direction, from, normal, radius))
        }
        (
            Circle {
                centre,
                normal,
                radius,
            },
            Circle {
                centre: c,
                normal: m,
                radius: r,
            },
        ) => {
            let from = c - centre;
            // Along the smaller circle the distance from the other one varies slowly.
            Some(if r.less_than(radius) {
                circle_to_circle(from, m, r, normal, radius)
            } else {
                circle_to_circle(-from, normal, radius, m, r)
            })
        }
        _ => None,
    }
}

/// The distance between two lines, each given by a point and its unit direction.
fn line_to_line<S: Real>([p, d]: [Vector<S>; 2], [q, e]: [Vector<S>; 2]) -> S {
    let between = q - p;
    let normal = d.cross(e);
    let sine = normal.length();
    let parallel = sine
        .less_than(parallel())
        .when(())
        .map(|()| between.across(d).length());
    parallel.unwrap_or((between.dot(normal) / sine).abs())
}

/// The least distance from the surface of a sphere, for points whose distance from its centre is
/// between two bounds.
fn from_surface<S: Real>([least, most]: [S; 2], radius: S) -> S {
    let zero = S::zero();
    let outside = (least - radius).max(zero);
    // Unbounded figures extend beyond every sphere.
    let inside = S::select(most.is_finite(), radius - most, zero);
    outside.max(inside)
}

pub(super) fn signed_distance<S: Real>(
    a: Figure<S>,
    b: Figure<S>,
    search: Search<S>,
) -> Maybe<S, S> {
    use Figure::{Plane, Sphere};
    match (a, b) {
        (
            Sphere { centre, radius },
            Sphere {
                centre: c,
                radius: r,
            },
        ) => finite(centre.distance(c) - radius - r),
        (Sphere { centre, radius }, x) | (x, Sphere { centre, radius }) => {
            let from_centre = from_sphere(x, centre);
            from_centre.and_then(|[least, _]| finite(least - radius))
        }
        (Plane { normal, distance }, x) | (x, Plane { normal, distance }) => {
            finite(height(x, normal, distance))
        }
        _ => distance(a, b, search),
    }
}

/// The least and the greatest distance of a figure's points from the centre of a sphere, or from
/// its surface, negative inside it; the greatest is infinite for unbounded figures.
pub(super) fn from_sphere<S: Real>(figure: Figure<S>, centre: Vector<S>) -> Maybe<[S; 2], S> {
    let always = S::Mask::splat(true);
    match figure {
        Figure::Point(p) => always.when([(p - centre).length(); 2]),
        Figure::PointPair([p, q]) => {
            let [p, q] = [p, q].map(|p| (p - centre).length());
            always.when([p.min(q), p.max(q)])
        }
        Figure::Line { .. } | Figure::Plane { .. } => {
            from_place(figure, centre).map(|least| [least, S::one() / S::zero()])
        }
        Figure::Circle {
            centre: c,
            normal,
            radius,
        } => always.when(from_circle(centre - c, normal, radius)),
        Figure::Sphere { centre: c, radius } => {
            let between = (centre - c).length();
            let least = (between - radius).max(radius - between);
            always.when([least, between + radius])
        }
    }
}

/// The least and the greatest distance of the points of a circle from a place, which is given from
/// the centre.
pub(super) fn from_circle<S: Real>(place: Vector<S>, normal: Vector<S>, radius: S) -> [S; 2] {
    let (height, reach) = (place.dot(normal), place.across(normal).length());
    [
        hypotenuse(reach - radius, height),
        hypotenuse(reach + radius, height),
    ]
}

/// The height of a figure's point that is nearest to a plane, zero where it meets the plane.
// Outlined, since within its caller lengths would be calls.
#[inline(never)]
fn height<S: Real>(figure: Figure<S>, normal: Vector<S>, distance: S) -> S {
    let height = |p: Vector<S>| p.dot(normal) - distance;
    // All heights occur where a direction is not parallel to the plane.
    let parallel = |sine: S| sine.less_than(parallel()).when(());
    let around = |middle: S, reach: S| gap([middle - reach, middle + reach]);
    match figure {
        Figure::Point(p) => height(p),
        Figure::PointPair([p, q]) => {
            let [p, q] = [p, q].map(height);
            gap([p.min(q), p.max(q)])
        }
        Figure::Line { point, direction } => parallel(direction.dot(normal).abs())
            .map(|()| height(point))
            .unwrap_or(S::zero()),
        Figure::Plane {
            normal: m,
            distance,
        } => parallel(normal.cross(m).length())
            .map(|()| height(m * distance))
            .unwrap_or(S::zero()),
        Figure::Circle {
            centre,
            normal: m,
            radius,
        } => around(height(centre), normal.cross(m).length() * radius),
        Figure::Sphere { centre, radius } => around(height(centre), radius),
    }
}

/// The number nearest to zero in an interval.
fn gap<S: Real>([least, most]: [S; 2]) -> S {
    let zero = S::zero();
    let around_zero = S::select(most.less_than(zero), most, (least + most) * zero);
    S::select(zero.less_than(least), least, around_zero)
}
