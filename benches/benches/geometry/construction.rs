//! Figures from points, centres, normals and radii.

use criterion::Criterion;
use ga_runtime::cga3::{Circle, Line, Plane, PointPair, Rotor, Sphere};
use ga_runtime::vga3::Vector;
use glam::DQuat;
use nullcone_benches::inputs;

use super::by_hand;
use super::group;

pub(crate) fn all(criterion: &mut Criterion) {
    let points = inputs::list(1, |numbers| [(); 4].map(|()| numbers.point::<f64>()));
    let vectors: Vec<_> = points.iter().map(|p| p.map(by_hand::point)).collect();

    let mut g = group(criterion, "sphere from centre and radius");
    g.map("nullcone", &points, |[p, q, ..]| {
        Sphere::from_centre_radius(*p, q.e1())
    });
    g.map("glam", &vectors, |[p, q, ..]| by_hand::Sphere {
        weight: 1.0,
        centre: *p,
        radius_squared: q.x * q.x,
    });
    drop(g);

    let mut g = group(criterion, "plane from point and normal");
    g.map("nullcone", &points, |[p, n, ..]| {
        Plane::from_point_normal(*p, n.coordinates())
    });
    g.map("glam", &vectors, |[p, n, ..]| by_hand::Plane {
        normal: *n,
        distance: n.dot(*p),
    });
    drop(g);

    let mut g = group(criterion, "plane through three points");
    g.map("nullcone", &points, |[p, q, r, _]| {
        Plane::through(*p, *q, *r)
    });
    g.map("glam", &vectors, |[p, q, r, _]| {
        by_hand::Plane::through(*p, *q, *r)
    });
    drop(g);

    let mut g = group(criterion, "line through two points");
    g.map("nullcone", &points, |[p, q, ..]| Line::through(*p, *q));
    g.map("glam", &vectors, |[p, q, ..]| {
        by_hand::Line::through(*p, *q)
    });
    drop(g);

    let mut g = group(criterion, "pair of two points, and back");
    g.map("nullcone", &points, |[p, q, ..]| {
        PointPair::through(*p, *q).endpoints()
    });
    g.map("glam", &vectors, |[p, q, ..]| {
        by_hand::Round::pair(*p, *q).endpoints()
    });
    drop(g);

    let mut g = group(criterion, "circle from centre, normal and radius");
    g.map("nullcone", &points, |[p, n, r, _]| {
        Circle::from_centre_normal_radius(*p, n.coordinates(), r.e1())
    });
    g.map("glam", &vectors, |[p, n, r, _]| {
        n.try_normalize().map(|direction| by_hand::Round {
            centre: *p,
            direction,
            radius_squared: r.x * r.x,
        })
    });
    drop(g);

    let mut g = group(
        criterion,
        "circle through three points, its centre, normal and radius",
    );
    g.map("nullcone", &points, |[p, q, r, _]| {
        let circle = Circle::through(*p, *q, *r);
        Some((circle.centre()?, circle.unit_normal()?, circle.radius()?))
    });
    g.map("glam", &vectors, |[p, q, r, _]| {
        by_hand::Round::circle(*p, *q, *r).figure()
    });
    drop(g);

    let mut g = group(
        criterion,
        "sphere through four points, its centre and radius",
    );
    g.map("nullcone", &points, |[p, q, r, s]| {
        let sphere = Sphere::through(*p, *q, *r, *s);
        Some((sphere.centre()?, sphere.radius()?))
    });
    g.map("glam", &vectors, |points| {
        by_hand::Sphere::through(*points).ball()
    });
    drop(g);

    let mut g = group(criterion, "unit vector");
    let plain: Vec<_> = points.iter().map(|p| Vector::from(p[0])).collect();
    g.map("nullcone", &plain, |v| v.normalized());
    g.map("glam", &vectors, |v| v[0].try_normalize());
    drop(g);

    let mut g = group(criterion, "rotation between two directions");
    g.map("nullcone", &points, |[p, q, ..]| {
        Rotor::between(p.coordinates(), q.coordinates())
    });
    g.map("glam", &vectors, |[p, q, ..]| {
        let (p, q) = (p.try_normalize()?, q.try_normalize()?);
        Some(DQuat::from_rotation_arc(p, q))
    });
}
