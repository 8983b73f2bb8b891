//! Drawn pairs of lines, planes and spheres.

use ga_runtime::cga3::{Line, Plane, Point, Sphere};
use ga_runtime::testing::cga3;
use nullcone_tests::plain::{cross, dot, length, minus, unit_of};

use super::{CASES, SIZE, drawn, share};

#[test]
fn pairs_of_lines_take_every_position() {
    let pairs: Vec<[Line<f64>; 2]> = drawn(cga3::pairs_of_lines(SIZE));
    /// The sine of the angle, the moment of each line about the other, and the distance of the
    /// nearest points to the origin.
    struct Position {
        sine: f64,
        cosine: f64,
        crossing: f64,
        offset: f64,
    }
    let position = |[a, b]: &[Line<f64>; 2]| {
        let [(u, m), (v, n)] = [a, b].map(|line| {
            let weight = length(line.direction());
            let by_weight = |v: [f64; 3]| v.map(|x| x / weight);
            (by_weight(line.direction()), by_weight(line.moment()))
        });
        Position {
            sine: length(cross(u, v)),
            cosine: dot(u, v),
            crossing: dot(u, n) + dot(v, m),
            offset: length(minus(cross(u, m), cross(v, n))),
        }
    };
    let found: Vec<_> = pairs.iter().map(position).collect();
    let is_parallel = |p: &Position| p.sine < 1e-14;
    // Negative weights reverse lines, so that equal and opposite lines each occur in half of these
    // cases.
    assert!(
        share(&found, |p| is_parallel(p)
            && p.offset < 1e-12
            && p.cosine > 0.0)
            > 0.08
    );
    assert!(
        share(&found, |p| is_parallel(p)
            && p.offset < 1e-12
            && p.cosine < 0.0)
            > 0.08
    );
    assert!(share(&found, |p| is_parallel(p) && p.offset > 1e-3) > 0.08);
    assert!(share(&found, |p| (1e-13..1.1e-3).contains(&p.sine)) > 0.08);
    assert!(share(&found, |p| p.sine > 1e-3 && p.crossing.abs() < 1e-13) > 0.08);
    assert!(share(&found, |p| p.sine > 1e-3 && p.crossing.abs() > 1e-3) > 0.25);
}

#[test]
fn pairs_of_planes_take_every_position() {
    let pairs: Vec<[Plane<f64>; 2]> = drawn(cga3::pairs_of_planes(SIZE));
    let position = |[a, b]: &[Plane<f64>; 2]| {
        let (m, n) = (unit_of(a.normal()), unit_of(b.normal()));
        let offsets =
            [a, b].map(|plane| plane.signed_distance(Point::default()).expect("a weight"));
        let same_side = dot(m, n).signum();
        (
            length(cross(m, n)),
            dot(m, n),
            (offsets[0] - same_side * offsets[1]).abs(),
        )
    };
    let found: Vec<_> = pairs.iter().map(position).collect();
    assert!(share(&found, |(sine, _, gap)| *sine < 1e-14 && *gap < 1e-12) > 0.08);
    assert!(share(&found, |(sine, _, gap)| *sine < 1e-14 && *gap > 1e-3) > 0.08);
    assert!(share(&found, |(sine, ..)| (1e-13..1.1e-3).contains(sine)) > 0.08);
    assert!(share(&found, |(_, cosine, _)| cosine.abs() < 1e-14) > 0.1);
    assert!(
        share(&found, |(sine, cosine, _)| *sine > 1e-2
            && cosine.abs() > 1e-2)
            > 0.3
    );
}

#[test]
fn pairs_of_spheres_take_every_position() {
    let pairs: Vec<[Sphere<f64>; 2]> = drawn(cga3::pairs_of_spheres(SIZE));
    let position = |[a, b]: &[Sphere<f64>; 2]| {
        let centre = |sphere: &Sphere<f64>| sphere.centre().expect("a centre");
        let radius =
            |sphere: &Sphere<f64>| sphere.radius_squared().expect("a radius").max(0.0).sqrt();
        (centre(a).distance(centre(b)), radius(a), radius(b))
    };
    // Both are large enough that their radii can be read back to ten digits.
    let found: Vec<_> = pairs
        .iter()
        .map(position)
        .filter(|(_, r, s)| r.min(*s) > 0.01 * SIZE)
        .collect();
    assert!(found.len() > CASES / 2);
    let near = |x: f64, y: f64| (x - y).abs() < 1e-8;
    let rate =
        |predicate: &dyn Fn(f64, f64, f64) -> bool| share(&found, |&(d, r, s)| predicate(d, r, s));
    assert!(rate(&|d, r, s| near(d, 0.0) && near(r, s)) > 0.08);
    assert!(rate(&|d, r, s| near(d, 0.0) && !near(r, s)) > 0.05);
    assert!(rate(&|d, r, s| near(d, r + s)) > 0.05);
    assert!(rate(&|d, r, s| near(d, (r - s).abs()) && !near(d, 0.0)) > 0.05);
    assert!(rate(&|d, r, s| near(d, r.hypot(s))) > 0.05);
    let crosses = |d: f64, r: f64, s: f64| d > (r - s).abs() + 1e-3 && d < r + s - 1e-3;
    assert!(rate(&|d, r, s| crosses(d, r, s) && !near(d, r.hypot(s))) > 0.05);
    assert!(rate(&|d, r, s| d > r + s + 1e-3) > 0.08);
}
