//! Where figures meet, and the common perpendicular of two lines.
//!
//! The meets of spheres give a circle or a pair of points as an element, real or imaginary, by its
//! centre, normal and squared radius. The rows of glam give centre, normal and radius of a real
//! circle, or two points; the rows "imaginary ones too" give what ours do.

use criterion::Criterion;
use ga_runtime::cga3::{Line, Plane, Sphere};
use ga_runtime::geometry::relation::Tolerance;
use glam::DVec3;
use nullcone_benches::inputs;

use super::by_hand;
use super::group;

pub(crate) fn all(criterion: &mut Criterion) {
    let tolerance = Tolerance::<f64>::default();
    let points = inputs::list(1, |numbers| [(); 4].map(|()| numbers.point::<f64>()));
    let planes: Vec<_> = points
        .iter()
        .map(|[p, q, r, s]| {
            [
                Plane::through(*p, *q, *r),
                Plane::through(*q, *r, *s),
                Plane::through(*r, *s, *p),
            ]
        })
        .collect();
    let lines: Vec<_> = points
        .iter()
        .rev()
        .map(|[p, q, r, s]| [Line::through(*p, *q), Line::through(*r, *s)])
        .collect();
    let spheres: Vec<_> = points
        .iter()
        .map(|[p, q, r, s]| {
            let sphere = |c, x: f64| Sphere::from_centre_radius(c, 1.0 + 0.5 * x);
            [sphere(*p, q.e1()), sphere(*r, s.e1())]
        })
        .collect();
    let plain_planes: Vec<_> = planes.iter().map(|p| p.map(by_hand::plane)).collect();
    let plain_lines: Vec<_> = lines.iter().map(|l| l.map(by_hand::line)).collect();
    let plain_spheres: Vec<_> = spheres.iter().map(|s| s.map(by_hand::sphere)).collect();

    let mut g = group(criterion, "line of two planes");
    g.map("nullcone", &planes, |[a, b, _]| a.meet(*b, tolerance));
    g.map("nullcone, as a product", &planes, |[a, b, _]| *a & *b);
    g.map("glam", &plain_planes, |[a, b, _]| {
        let (a, b) = (a.normalized()?, b.normalized()?);
        let along = a.normal.cross(b.normal);
        let sine = along.length();
        let direction = along / sine;
        let place = (b.normal.cross(direction) * a.distance
            + direction.cross(a.normal) * b.distance)
            / sine;
        (sine > tolerance.angle).then(|| by_hand::Line {
            direction,
            moment: place.cross(direction),
        })
    });
    drop(g);

    let mut g = group(criterion, "point of a line and a plane");
    g.zip("nullcone", &lines, &planes, |[l, _], [a, ..]| {
        l.meet(*a, tolerance)
    });
    g.zip(
        "nullcone, as a product",
        &lines,
        &planes,
        |[l, _], [a, ..]| (*l & *a).to_point(),
    );
    g.zip("glam", &plain_lines, &plain_planes, |[l, _], [a, ..]| {
        let (place, direction) = l.parts()?;
        let a = a.normalized()?;
        let slope = direction.dot(a.normal);
        let height = place.dot(a.normal) - a.distance;
        (slope.abs() > tolerance.angle).then(|| place - direction * (height / slope))
    });
    drop(g);

    let mut g = group(criterion, "point of three planes");
    g.map("nullcone", &planes, |[a, b, c]| (*a & *b & *c).to_point());
    g.map("glam", &plain_planes, |[a, b, c]| {
        let first = b.normal.cross(c.normal);
        let inverse = a.normal.dot(first).recip();
        let place = (a.distance * first
            + b.distance * c.normal.cross(a.normal)
            + c.distance * a.normal.cross(b.normal))
            * inverse;
        inverse.is_finite().then_some(place)
    });
    drop(g);

    let mut g = group(criterion, "points of a line and a sphere");
    g.zip("nullcone", &lines, &spheres, |[l, _], [s, _]| {
        l.meet(*s, tolerance)
    });
    g.zip(
        "nullcone, as a product, and the endpoints",
        &lines,
        &spheres,
        |[l, _], [s, _]| (*l & *s).endpoints(),
    );
    g.zip("glam", &plain_lines, &plain_spheres, |[l, _], [s, _]| {
        let (place, direction) = l.parts()?;
        let (centre, squared) = (s.centre()?, s.radius_squared);
        let along = (centre - place).dot(direction);
        let foot = place + direction * along;
        let half = squared - foot.distance_squared(centre);
        let reach = direction * half.sqrt();
        (half >= 0.0).then(|| -> [DVec3; 2] { [foot - reach, foot + reach] })
    });
    g.zip(
        "glam, imaginary ones too",
        &plain_lines,
        &plain_spheres,
        |[l, _], [s, _]| {
            let (place, direction) = l.parts()?;
            let (centre, squared) = (s.centre()?, s.radius_squared);
            let along = (centre - place).dot(direction);
            let foot = place + direction * along;
            let half = squared - foot.distance_squared(centre);
            let pair = by_hand::Round {
                centre: foot,
                direction,
                radius_squared: half,
            };
            (half.abs() > tolerance.distance).then_some((pair, half > 0.0))
        },
    );
    drop(g);

    let mut g = group(criterion, "circle of a plane and a sphere");
    g.zip("nullcone", &planes, &spheres, |[a, ..], [s, _]| {
        a.meet(*s, tolerance)
    });
    g.zip(
        "nullcone, as a product",
        &planes,
        &spheres,
        |[a, ..], [s, _]| *a & *s,
    );
    g.zip("glam", &plain_planes, &plain_spheres, |[a, ..], [s, _]| {
        let a = a.normalized()?;
        let (centre, squared) = (s.centre()?, s.radius_squared);
        let height = centre.dot(a.normal) - a.distance;
        let left = squared - height * height;
        (left >= 0.0).then(|| (centre - a.normal * height, a.normal, left.sqrt()))
    });
    g.zip(
        "glam, imaginary ones too",
        &plain_planes,
        &plain_spheres,
        |[a, ..], [s, _]| {
            let a = a.normalized()?;
            let (centre, squared) = (s.centre()?, s.radius_squared);
            let height = centre.dot(a.normal) - a.distance;
            let left = squared - height * height;
            let foot = centre - a.normal * height;
            let circle = by_hand::Round {
                centre: foot,
                direction: -a.normal,
                radius_squared: left,
            };
            // Which of the two cases it is, and none for a tangent.
            (left.abs() > tolerance.distance).then_some((circle, left > 0.0))
        },
    );
    drop(g);

    let mut g = group(criterion, "circle of two spheres");
    g.map("nullcone", &spheres, |[s, t]| s.meet(*t, tolerance));
    g.map("nullcone, as a product", &spheres, |[s, t]| *s & *t);
    g.map("glam", &plain_spheres, |[s, t]| {
        let (a, b) = (s.centre()?, t.centre()?);
        let (r, s) = (s.radius_squared, t.radius_squared);
        let way = b - a;
        let distance = way.length();
        let normal = way / distance;
        let along = 0.5 * (distance + (r - s) / distance);
        let left = r - along * along;
        (left >= 0.0).then(|| (a + normal * along, normal, left.sqrt()))
    });
    g.map("glam, imaginary ones too", &plain_spheres, |[s, t]| {
        let (a, b) = (s.centre()?, t.centre()?);
        let (r, s) = (s.radius_squared, t.radius_squared);
        let way = b - a;
        let distance = way.length();
        let normal = way / distance;
        let along = 0.5 * (distance + (r - s) / distance);
        let left = r - along * along;
        let circle = by_hand::Round {
            centre: a + normal * along,
            direction: normal,
            radius_squared: left,
        };
        (left.abs() > tolerance.distance).then_some((circle, left > 0.0))
    });
    drop(g);

    let mut g = group(criterion, "common perpendicular of two lines");
    g.map("nullcone", &lines, |[l, k]| {
        l.common_perpendicular(*k, tolerance)
    });
    g.map("glam", &plain_lines, |[l, k]| {
        let ((p, d), (q, e)) = (l.parts()?, k.parts()?);
        let normal = d.cross(e);
        let sine = normal.length();
        let normal = normal / sine;
        let between = q - p;
        let first = p + d * (between.cross(e).dot(normal) / sine);
        let second = q + e * (between.cross(d).dot(normal) / sine);
        let line = by_hand::Line {
            direction: normal,
            moment: first.cross(normal),
        };
        (sine > tolerance.angle).then(|| ([first, second], line, between.dot(normal).abs()))
    });
}
