//! Rounds that meet, and rays that hit them.

use ga_runtime::cga3::{Circle, Line, Plane, Point, Sphere};
use ga_runtime::geometry::ray::Ray;

use super::scene::{Measured, Offset, Precision, Scene, exact, norm, off, unit_of};
use crate::plain::{O, along, cross, dot, frame, largest, minus, plus, times};
use crate::twofold::Twofold;

/// A smaller and a larger sphere, of the radius that is the size.
pub(super) struct Meeting<S> {
    pub(super) smaller: Sphere<S>,
    pub(super) larger: Sphere<S>,
    /// The squared radius of the circle in which they meet, and its centre.
    pub(super) squared: Twofold,
    pub(super) centre: Offset,
    /// The ratio of the larger radius and the distance of the centres, at least 1.
    pub(super) condition: f64,
    /// The displacement that makes them touch.
    pub(super) to_contact: f64,
}

impl<S: Precision> Meeting<S> {
    /// Spheres the nearest points of which are cut by a plane at this height, in units of the
    /// smaller radius, from the centre of the smaller. At a height of 1 they touch.
    pub(super) fn new(scene: &mut Scene<S>, height: f64) -> Option<Self> {
        let [large, small] = [1.0, 1e3_f64.powf(-scene.numbers.unit())]
            .map(|ratio| S::from_f64(ratio * scene.size()));
        let (larger, smaller): (f64, f64) = (large.into(), small.into());
        let height = height * smaller;
        let squared = larger * larger - smaller * smaller + height * height;
        let step = times(scene.numbers.axis(), height + squared.sqrt());
        let points = [O, step].map(|offset| scene.at(offset));
        let [p, q] = points.map(|point| scene.offset(point));
        let (between, r, s) = (minus(q, p), exact(small), exact(large));
        let square = dot(between, between);
        let share = (square + (r - s) * (r + s)) / (square + square);
        let apart = square.sqrt();
        let contacts = [r + s, s - r].map(|reach| (apart - reach).rounded().abs());
        let gap = apart.rounded();
        (scene.resolves(smaller) && gap > larger / 32.0).then(|| Self {
            smaller: Sphere::from_centre_radius(points[0], small),
            larger: Sphere::from_centre_radius(points[1], large),
            squared: r * r - share * share * square,
            centre: along(p, share, between),
            condition: (larger / gap).max(1.0),
            to_contact: contacts[0].min(contacts[1]),
        })
    }
}

/// The condition is that of the spheres, and of the radius ρ of the circle in which they meet: it
/// grows as r/ρ for the radius r of the smaller.
pub(super) fn spheres_meet<S: Precision>(
    scene: &mut Scene<S>,
    circles: impl Fn(&Meeting<S>) -> Vec<Circle<S>>,
) -> Measured {
    let height = scene.numbers.within(0.97);
    let meeting = Meeting::new(scene, height)?;
    let radius = meeting.squared.sqrt();
    let smaller: f64 = meeting.smaller.radius()?.into();
    let condition = meeting.condition * smaller / radius.rounded();
    let error = |circle: &Circle<S>| {
        let moved = scene.away(circle.centre(), meeting.centre);
        off(circle.radius(), radius).max(moved)
    };
    let error = circles(&meeting).iter().map(error).reduce(f64::max);
    let is_grazing = radius.rounded() < smaller / 32.0;
    if is_grazing {
        return None;
    }
    scene.measured(error.unwrap_or(f64::INFINITY), condition)
}

pub(super) fn plane_meets_sphere<S: Precision>(scene: &mut Scene<S>) -> Measured {
    let direction = scene.numbers.axis();
    let step = scene.numbers.within(0.9 * scene.size());
    let foot = scene.at(times(direction, step));
    let normal = direction.map(S::from_f64);
    let sphere = Sphere::from_centre_radius(scene.at(O), scene.size);
    let circle = Plane::from_point_normal(foot, normal) & sphere;
    let normal = unit_of(normal.map(exact));
    let height = dot(scene.offset(foot), normal);
    let squared = exact(scene.size) * exact(scene.size) - height * height;
    let error = largest([
        off(circle.radius(), squared.sqrt()),
        scene.away(circle.centre(), times(normal, height)),
    ]);
    scene.measured(error, 1.0)
}

/// Two points of a line at a distance, in radii, from the centre of the sphere about the place, and
/// the offsets of the nearest point and of a unit vector along the line.
pub(super) fn line_at<S: Precision>(
    scene: &mut Scene<S>,
    height: f64,
) -> ([Point<S>; 2], [Offset; 2]) {
    let direction = scene.numbers.axis();
    let [side, _] = frame(direction);
    let foot = times(side, height * scene.size());
    let points = [-2.0, 3.0].map(|t| scene.at(along(foot, t * scene.size(), direction)));
    let [start, end] = points.map(|point| scene.offset(point));
    let way = unit_of(minus(end, start));
    (points, [minus(start, times(way, dot(start, way))), way])
}

/// Two points of a line at up to 0.9 radii from the centre, and the points in which it meets the
/// sphere.
fn secant<S: Precision>(scene: &mut Scene<S>) -> ([Point<S>; 2], [Offset; 2]) {
    let height = scene.numbers.within(0.9);
    let (points, [nearest, way]) = line_at(scene, height);
    let squared = exact(scene.size) * exact(scene.size) - dot(nearest, nearest);
    let step = times(way, squared.sqrt());
    (points, [minus(nearest, step), plus(nearest, step)])
}

pub(super) fn line_meets_sphere<S: Precision>(scene: &mut Scene<S>) -> Measured {
    let ([p, q], meets) = secant(scene);
    let pair = Line::through(p, q) & Sphere::from_centre_radius(scene.at(O), scene.size);
    scene.measured(scene.ends_away(pair, meets), 1.0)
}

pub(super) fn first_hit<S: Precision>(scene: &mut Scene<S>) -> Measured {
    let ([p, q], [first, _]) = secant(scene);
    let sphere = Sphere::from_centre_radius(scene.at(O), scene.size);
    let hit = Ray::through(p, q).and_then(|ray| ray.first_hit(sphere));
    let expected = norm(minus(first, scene.offset(p)));
    let error = off(hit.map(|hit| hit.distance), expected);
    scene.measured(error, 1.0)
}

pub(super) fn plane_meets_circle<S: Precision>(scene: &mut Scene<S>) -> Measured {
    let normals = [(); 2].map(|()| scene.numbers.axis().map(S::from_f64));
    let [n, m] = normals.map(|normal| unit_of(normal.map(exact)));
    let side = cross(n, m);
    let across = cross(side, n);
    let step = scene.numbers.within(scene.size());
    let foot = scene.at(times(across.map(Twofold::rounded), step));
    let circle = Circle::from_centre_normal_radius(scene.at(O), normals[0], scene.size)?;
    let pair = Plane::from_point_normal(foot, normals[1]) & circle;
    // In the plane of the circle, from its centre to the line in which the planes meet.
    let centre = times(across, dot(scene.offset(foot), m) / dot(side, side));
    let squared = exact(scene.size) * exact(scene.size) - dot(centre, centre);
    let way = times(unit_of(side), squared.sqrt());
    let error = scene.ends_away(pair, [minus(centre, way), plus(centre, way)]);
    let is_grazing = squared.rounded() < scene.size() * scene.size() / 8.0;
    if norm(side).rounded() < 0.2 || is_grazing {
        return None;
    }
    scene.measured(error, 1.0)
}
