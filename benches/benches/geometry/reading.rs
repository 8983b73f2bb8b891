//! Centres, radii, normals and directions, read from figures.

use criterion::Criterion;
use ga_runtime::cga3::{Circle, Line, Plane, PointPair, Sphere};
use nullcone_benches::inputs;

use super::by_hand::{self, Ball};
use super::group;

pub(crate) fn all(criterion: &mut Criterion) {
    let points = inputs::list(1, |numbers| [(); 4].map(|()| numbers.point::<f64>()));
    let spheres: Vec<_> = points
        .iter()
        .map(|[p, q, r, s]| Sphere::through(*p, *q, *r, *s))
        .collect();
    let circles: Vec<_> = points
        .iter()
        .map(|[p, q, r, _]| Circle::through(*p, *q, *r))
        .collect();
    let pairs: Vec<_> = points
        .iter()
        .map(|[p, q, ..]| PointPair::through(*p, *q))
        .collect();
    let planes: Vec<_> = points
        .iter()
        .map(|[p, q, r, _]| Plane::through(*p, *q, *r))
        .collect();
    let lines: Vec<_> = points
        .iter()
        .map(|[p, q, ..]| Line::through(*p, *q))
        .collect();
    let plain_spheres: Vec<_> = spheres.iter().map(|s| by_hand::sphere(*s)).collect();
    let plain_circles: Vec<_> = circles.iter().map(|c| by_hand::circle(*c)).collect();
    let plain_pairs: Vec<_> = pairs.iter().map(|p| by_hand::pair(*p)).collect();
    let plain_planes: Vec<_> = planes.iter().map(|p| by_hand::plane(*p)).collect();
    let plain_lines: Vec<_> = lines.iter().map(|l| by_hand::line(*l)).collect();

    let mut g = group(criterion, "centre of a sphere");
    g.map("nullcone", &spheres, |s| s.centre());
    g.map("glam", &plain_spheres, |s| s.centre());
    drop(g);

    let mut g = group(criterion, "centre and radius of a sphere");
    g.map("nullcone", &spheres, |s| Some((s.centre()?, s.radius()?)));
    g.map("glam", &plain_spheres, |s| -> Option<Ball> { s.ball() });
    drop(g);

    let mut g = group(criterion, "centre of a circle");
    g.map("nullcone", &circles, |c| c.centre());
    g.map("glam", &plain_circles, |c| c.centre());
    drop(g);

    let mut g = group(criterion, "centre, normal and radius of a circle");
    g.map("nullcone", &circles, |c| {
        Some((c.centre()?, c.unit_normal()?, c.radius()?))
    });
    g.map("glam", &plain_circles, |c| c.figure());
    drop(g);

    let mut g = group(criterion, "endpoints of a pair");
    g.map("nullcone", &pairs, |p| p.endpoints());
    g.map("glam", &plain_pairs, |p| p.endpoints());
    drop(g);

    let mut g = group(criterion, "unit normal of a plane");
    g.map("nullcone", &planes, |p| p.unit_normal());
    g.map("glam", &plain_planes, |p| p.normal.try_normalize());
    drop(g);

    let mut g = group(criterion, "unit direction of a line");
    g.map("nullcone", &lines, |l| l.unit_direction());
    g.map("glam", &plain_lines, |l| l.direction.try_normalize());
    drop(g);

    let mut g = group(criterion, "point of a line nearest to the origin");
    g.map("nullcone", &lines, |l| l.support());
    g.map("glam", &plain_lines, |l| {
        let inverse = l.direction.length_squared().recip();
        inverse
            .is_finite()
            .then(|| l.direction.cross(l.moment) * inverse)
    });
}
