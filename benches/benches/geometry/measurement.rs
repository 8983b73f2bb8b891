//! Distances, angles, incidence, projection and reflection.
//!
//! `angle_between` of glam is the arc cosine, which loses half of the digits of small angles. The
//! rows "by atan2" are as accurate as ours.

use criterion::Criterion;
use ga_runtime::cga3::{Line, Plane, Sphere};
use ga_runtime::geometry::relation::Tolerance;
use nullcone_benches::inputs;

use super::{by_hand, group};

pub(crate) fn all(criterion: &mut Criterion) {
    let tolerance = Tolerance::<f64>::default();
    let points = inputs::list(1, |numbers| [(); 4].map(|()| numbers.point::<f64>()));
    let first: Vec<_> = points.iter().map(|p| p[0]).collect();
    let second: Vec<_> = points.iter().map(|p| p[1]).collect();
    let planes: Vec<_> = points
        .iter()
        .rev()
        .map(|[p, q, r, _]| Plane::through(*p, *q, *r))
        .collect();
    let lines: Vec<_> = points
        .iter()
        .rev()
        .map(|[p, q, ..]| Line::through(*p, *q))
        .collect();
    let others: Vec<_> = points
        .iter()
        .map(|[_, _, p, q]| Line::through(*p, *q))
        .collect();
    let spheres: Vec<_> = points
        .iter()
        .rev()
        .map(|[p, q, ..]| Sphere::from_centre_radius(*p, 1.0 + q.e1()))
        .collect();
    let turned: Vec<_> = planes.iter().rev().copied().collect();
    let plain_first: Vec<_> = first.iter().map(|p| by_hand::point(*p)).collect();
    let plain_second: Vec<_> = second.iter().map(|p| by_hand::point(*p)).collect();
    let plain_planes: Vec<_> = planes.iter().map(|p| by_hand::plane(*p)).collect();
    let plain_turned: Vec<_> = turned.iter().map(|p| by_hand::plane(*p)).collect();
    let plain_lines: Vec<_> = lines.iter().map(|l| by_hand::line(*l)).collect();
    let plain_others: Vec<_> = others.iter().map(|l| by_hand::line(*l)).collect();
    let plain_spheres: Vec<_> = spheres.iter().map(|s| by_hand::sphere(*s)).collect();

    let mut g = group(criterion, "distance of two points");
    g.zip("nullcone", &first, &second, |p, q| p.distance(*q));
    g.zip("glam", &plain_first, &plain_second, |p, q| p.distance(*q));
    drop(g);

    let mut g = group(criterion, "signed distance of a plane and a point");
    g.zip("nullcone", &planes, &first, |a, p| a.signed_distance(*p));
    g.zip("glam", &plain_planes, &plain_first, |a, p| {
        let inverse = a.normal.length_recip();
        inverse
            .is_finite()
            .then(|| (a.normal.dot(*p) - a.distance) * inverse)
    });
    drop(g);

    let mut g = group(criterion, "distance of a point and a plane");
    g.zip("nullcone", &first, &planes, |p, a| p.distance_to(*a));
    g.zip("glam", &plain_first, &plain_planes, |p, a| {
        let inverse = a.normal.length_recip();
        inverse
            .is_finite()
            .then(|| ((a.normal.dot(*p) - a.distance) * inverse).abs())
    });
    drop(g);

    let mut g = group(criterion, "distance of a line and a point");
    g.zip("nullcone", &lines, &first, |l, p| l.distance(*p));
    g.zip("glam", &plain_lines, &plain_first, |l, p| {
        let inverse = l.direction.length_recip();
        let arm = p.cross(l.direction) - l.moment;
        inverse.is_finite().then(|| arm.length() * inverse)
    });
    drop(g);

    let mut g = group(criterion, "distance of two lines");
    g.zip("nullcone", &lines, &others, |l, k| l.distance_to(*k));
    g.zip("glam", &plain_lines, &plain_others, |l, k| {
        let (p, d) = l.parts()?;
        let (q, e) = k.parts()?;
        let normal = d.cross(e);
        let sine = normal.length();
        Some(if sine < 1e-15 {
            (q - p).cross(d).length()
        } else {
            ((q - p).dot(normal) / sine).abs()
        })
    });
    drop(g);

    let mut g = group(criterion, "signed distance of a point and a sphere");
    g.zip("nullcone", &first, &spheres, |p, s| {
        p.signed_distance_to(*s)
    });
    g.zip("glam", &plain_first, &plain_spheres, |p, s| {
        let ball = s.ball()?;
        Some(p.distance(ball.centre) - ball.radius)
    });
    drop(g);

    let mut g = group(criterion, "projection of a point onto a plane");
    g.zip("nullcone", &first, &planes, |p, a| p.project_onto(*a));
    g.zip("glam", &plain_first, &plain_planes, |p, a| {
        let inverse = a.normal.length_squared().recip();
        inverse
            .is_finite()
            .then(|| *p - a.normal * ((a.normal.dot(*p) - a.distance) * inverse))
    });
    drop(g);

    let mut g = group(criterion, "projection of a point onto a line");
    g.zip("nullcone", &first, &lines, |p, l| p.project_onto(*l));
    g.zip("glam", &plain_first, &plain_lines, |p, l| {
        let inverse = l.direction.length_squared().recip();
        let along = l.direction * l.direction.dot(*p);
        inverse
            .is_finite()
            .then(|| (along + l.direction.cross(l.moment)) * inverse)
    });
    drop(g);

    let mut g = group(criterion, "foot of a point on a line");
    g.zip("nullcone", &lines, &first, |l, p| l.foot(*p));
    g.zip("glam", &plain_lines, &plain_first, |l, p| {
        let inverse = l.direction.length_squared().recip();
        let along = l.direction * l.direction.dot(*p);
        inverse
            .is_finite()
            .then(|| (along + l.direction.cross(l.moment)) * inverse)
    });
    drop(g);

    let mut g = group(criterion, "projection of a point onto a sphere");
    g.zip("nullcone", &first, &spheres, |p, s| p.project_onto(*s));
    g.zip("glam", &plain_first, &plain_spheres, |p, s| {
        let ball = s.ball()?;
        Some(ball.centre + (*p - ball.centre).try_normalize()? * ball.radius)
    });
    drop(g);

    let mut g = group(criterion, "reflection of a point in a plane");
    g.zip("nullcone", &first, &planes, |p, a| p.reflect_in(*a));
    g.zip("glam", &plain_first, &plain_planes, |p, a| {
        let twice = 2.0 / a.normal.length_squared();
        twice
            .is_finite()
            .then(|| *p - a.normal * ((a.normal.dot(*p) - a.distance) * twice))
    });
    drop(g);

    let mut g = group(criterion, "angle of two lines");
    g.zip("nullcone", &lines, &others, |l, k| l.angle_to(*k));
    g.zip("glam", &plain_lines, &plain_others, |l, k| {
        let angle = l.direction.angle_between(k.direction);
        angle.is_finite().then_some(angle)
    });
    g.zip("glam, by atan2", &plain_lines, &plain_others, |l, k| {
        by_hand::angle(l.direction, k.direction)
    });
    drop(g);

    let mut g = group(criterion, "angle of two planes");
    g.zip("nullcone", &planes, &turned, |a, b| a.angle_to(*b));
    g.zip("glam", &plain_planes, &plain_turned, |a, b| {
        let angle = a.normal.angle_between(b.normal);
        angle.is_finite().then_some(angle)
    });
    g.zip("glam, by atan2", &plain_planes, &plain_turned, |a, b| {
        by_hand::angle(a.normal, b.normal)
    });
    drop(g);

    let mut g = group(criterion, "point on a plane, or not");
    g.zip("nullcone", &first, &planes, |p, a| p.is_on(*a, tolerance));
    g.zip("glam", &plain_first, &plain_planes, |p, a| {
        let height = a.normal.dot(*p) - a.distance;
        height.abs() <= tolerance.distance * a.normal.length()
    });
    drop(g);

    let mut g = group(criterion, "point on a line, or not");
    g.zip("nullcone", &first, &lines, |p, l| p.is_on(*l, tolerance));
    g.zip("glam", &plain_first, &plain_lines, |p, l| {
        let arm = p.cross(l.direction) - l.moment;
        arm.length() <= tolerance.distance * l.direction.length()
    });
}
