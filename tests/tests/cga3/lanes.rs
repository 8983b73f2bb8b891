//! Geometry in lanes against the same geometry of each lane alone, with the same bits, and no value
//! where the single numbers have none.

use ga_runtime::cga3::{
    Circle, Direction, DualPlane, DualQuaternion, DualSphere, FlatPoint, Line, Motor, Plane, Point,
    PointPair, Quadvector, Rotor, RoundVector, Sphere, Trivector,
};
use ga_runtime::geometry::ray::{Hit, Ray, Surface};
use ga_runtime::geometry::relation::Tolerance;
use ga_runtime::scalar::{Dual, Lanes, Mask, Maybe, Optional, Real, Select};
use ga_runtime::vga3::Vector;
use nullcone_tests::random::SplitMix64;
use wide::f64x4;

/// The numbers of everything that is read: one list for each quantity.
type Found<S> = Vec<Maybe<Vec<S>, S>>;

/// Everything that has a value in lanes, of primitives that are made of some numbers.
fn everything<S: Real>(x: [S; 11], tolerance: S) -> Found<S> {
    let [a, b, c, d, e, f, g, h, k, l, m] = x;
    let (point, axis) = (Point::new(a, b, c), [d, e, f]);
    let centre = Point::new(g, h, k);
    let tolerance = Tolerance::new(tolerance, tolerance);
    let mut found = Vec::new();
    macro_rules! push {
        ($($value:expr => $numbers:expr;)*) => {$( found.push($value.map($numbers)); )*};
    }
    let number = |x: S| vec![x];
    let place = |p: Point<S>| p.coordinates().to_vec();
    let vector = |v: [S; 3]| v.to_vec();
    let numbers = |p: Vector<S>| p.coordinates().to_vec();
    macro_rules! from_point {
        ($($primitive:expr;)*) => {$(
            let other = $primitive;
            push! {
                point.distance_to(other) => number;
                point.signed_distance_to(other) => number;
                point.project_onto(other) => place;
                point.reject_from(other) => |d: Direction<S>| d.vector().to_vec();
            }
            found.push(point.is_on(other, tolerance).when(Vec::new()));
        )*};
    }

    let flat = FlatPoint::new(a, b, c, l);
    let line = Line::from_point_direction(centre, axis);
    let plane = Plane::from_point_normal(centre, axis);
    let sphere: Sphere<S> = DualSphere {
        weight: m,
        ..DualSphere::from_centre_radius_squared(centre, l)
    }
    .undual();
    let circle = Circle::new(centre, Direction::from(axis), l);
    let pair = PointPair::new(centre, Direction::from(axis), l);
    from_point! {
        centre; flat; line; plane; sphere; circle; pair;
        line.dual(); plane.dual(); sphere.dual(); circle.dual(); pair.dual(); flat.dual();
        Trivector::from(circle); Trivector::from(line);
        Quadvector::from(sphere); Quadvector::from(plane);
    }
    push! {
        Vector::from(axis).normalized() => numbers;
        Vector::new(a, b, c).project(axis.into()) => numbers;
        Vector::new(a, b, c).reject(axis.into()) => numbers;
        Vector::new(a, b, c).reflect(axis.into()) => numbers;
        line.normalized() => |x: Line<S>| x.coefficients().map(|(_, x)| x).collect();
        plane.normalized() => |x: Plane<S>| x.coefficients().map(|(_, x)| x).collect();
        DualPlane::new(a, b, c, d).normalized() => |x: DualPlane<S>| vec![x.e1, x.e2, x.e3, x.ei];
        DualQuaternion::new(a, b, c, d, e, f, g, h).normalize() =>
            |x: Motor<S>| x.coefficients().map(|(_, x)| x).collect();
        Motor::new_unchecked(a, b, c, d, e, f, g, h).normalized() =>
            |x: Motor<S>| x.coefficients().map(|(_, x)| x).collect();
        Rotor::new_unchecked(a, b, c, d).normalized() =>
            |x: Rotor<S>| x.coefficients().map(|(_, x)| x).collect();
        line.unit_direction() => vector;
        line.support() => place;
        line.foot(point) => place;
        Line::from_direction_moment(axis, [a, b, c]) =>
            |x: Line<S>| [x.direction(), x.moment()].concat();
        plane.unit_normal() => vector;
        plane.support() => place;
        flat.to_point() => place;
        sphere.centre() => place;
        sphere.radius() => number;
        sphere.radius_squared() => number;
        circle.centre() => place;
        circle.radius() => number;
        circle.unit_normal() => vector;
        circle.axis() => |x: Line<S>| [x.direction(), x.moment()].concat();
        pair.centre() => place;
        pair.radius() => number;
        pair.unit_direction() => vector;
        pair.endpoints() => |ends: [Point<S>; 2]| ends.map(Point::coordinates).concat();
        RoundVector::new(a, b, c, l, d).centre() => place;
        RoundVector::new(a, b, c, l, d).radius_squared() => number;
        (sphere & line).endpoints() => |ends: [Point<S>; 2]| ends.map(Point::coordinates).concat();
        (Plane::from_point_normal(centre, [e, f, d]) & circle).endpoints() => |ends: [Point<S>; 2]| ends.map(Point::coordinates).concat();
        (plane & line).to_point() => place;
        (sphere & plane).radius() => number;
        point.reflect_in(plane) => place;
        point.reflect_in(line) => place;
        point.reflect_in(centre) => place;
        point.reflect_in(flat) => place;
        line.reflect_in(plane) => |x: Line<S>| [x.direction(), x.moment()].concat();
    }
    found.extend(rays(x));
    found.extend(between(x));
    found
}

/// Distances of primitives from each other, and whether one is on another or parallel to it.
fn between<S: Real>(x: [S; 11]) -> Found<S> {
    let [a, b, c, d, e, f, g, h, k, l, m] = x;
    let (point, centre) = (Point::new(a, b, c), Point::new(g, h, k));
    // So large that much is within it.
    let tolerance = Tolerance::new(m.abs(), S::from_f64(0.5));
    let mut found = Vec::new();
    macro_rules! distances {
        ($($one:expr, $other:expr;)*) => {$(
            let (one, other) = ($one, $other);
            found.extend([
                one.distance_to(other).map(|x| vec![x]),
                one.signed_distance_to(other).map(|x| vec![x]),
            ]);
        )*};
    }
    macro_rules! tests {
        ($test:ident: $($one:expr, $other:expr;)*) => {$(
            found.push($one.$test($other, tolerance).when(Vec::new()));
        )*};
    }
    let flat = FlatPoint::new(a, b, c, l);
    let line = Line::from_point_direction(centre, [d, e, f]);
    let along = Line::from_point_direction(point, [d, e, m]);
    let plane = Plane::from_point_normal(centre, [d, e, f]);
    let wall = Plane::from_point_normal(point, [e, -d, l]);
    let level = Plane::from_point_normal(point, [d * l, e * l, f * l]);
    let sphere = Sphere::from_centre_radius_squared(centre, l);
    let ball = Sphere::from_centre_radius_squared(point, m * m);
    let pair = PointPair::new(centre, Direction::from([d, e, f]), l);
    let ends = PointPair::through(point, centre);
    distances! {
        flat, centre; flat, flat; flat, line; flat.dual(), plane.dual(); flat, sphere;
        line, point; line, along; line, plane; line, wall; line, sphere; line.dual(), pair;
        plane, flat; plane, line; plane, level; plane, wall; plane.dual(), ball.dual(); plane, pair;
        sphere, point; sphere, sphere; sphere, ball; sphere, along; sphere.dual(), wall.dual();
        pair, point; pair, line; pair, sphere; pair, ends; pair.dual(), plane; ends, line;
        ends, ends; ends, along.dual(); ball, sphere.dual(); sphere, pair; level, wall;
    }
    tests! { is_on:
        flat, line; flat, pair; pair, line; pair, sphere; ends, plane; ends.dual(), ball;
        line, along; line, wall; along.dual(), plane.dual(); plane, level; plane, wall;
        sphere, ball; sphere, line; sphere.dual(), plane; sphere, flat; ball, pair;
    }
    tests! { coincides_with:
        point, flat; flat, pair; pair, ends; line, along; plane, level; sphere, ball;
        sphere, centre;
    }
    macro_rules! inversive_distances {
        ($($one:expr, $other:expr;)*) => {$(
            found.push($one.inversive_distance_to($other).map(|x| vec![x]));
        )*};
    }
    inversive_distances! {
        sphere, ball; sphere.dual(), plane; plane, wall; ball, wall.dual();
    }
    tests! { is_parallel_to:
        line, along; along, plane; line.dual(), wall; plane, level; plane, wall; level, along;
    }
    tests! { is_perpendicular_to:
        line, along; line, plane; line.dual(), wall; plane.dual(), wall; level, along;
    }
    found
}

/// Angles of primitives with each other.
fn angles<S: Real>(x: [S; 11]) -> Found<S> {
    let [a, b, c, d, e, f, g, h, k, l, m] = x;
    let (point, centre) = (Point::new(a, b, c), Point::new(g, h, k));
    let line = Line::from_point_direction(centre, [d, e, f]);
    let along = Line::from_point_direction(point, [d, e, m]);
    let plane = Plane::from_point_normal(centre, [d, e, f]);
    let wall = Plane::from_point_normal(point, [e, -d, l]);
    let sphere = Sphere::from_centre_radius_squared(centre, l);
    let ball = Sphere::from_centre_radius_squared(point, m * m);
    let mut found = vec![
        Vector::new(a, b, c)
            .angle(Vector::new(d, e, f))
            .map(|x| vec![x]),
    ];
    macro_rules! angles {
        ($($one:expr, $other:expr;)*) => {$(
            found.push($one.angle_to($other).map(|x| vec![x]));
        )*};
    }
    angles! {
        line, along; line, plane; along, wall; plane, wall; line.dual(), along; plane.dual(), wall;
        sphere, ball; ball, sphere.dual(); sphere, plane; wall, ball; sphere, along; line, ball;
    }
    found
}

/// What rays hit, and how they go on.
fn rays<S: Real>(x: [S; 11]) -> Found<S> {
    let [a, b, c, d, e, f, g, h, k, l, m] = x;
    let (point, axis, centre) = (Point::new(a, b, c), [d, e, f], Point::new(g, h, k));
    let of_ray = |ray: Ray<S>| {
        let direction = ray.direction().vector();
        [ray.origin().coordinates(), direction].concat()
    };
    let of_hit = |hit: Hit<S>| {
        let mut numbers = [hit.point.coordinates(), hit.normal.vector()].concat();
        let side = S::select(hit.is_front, S::one(), S::zero());
        numbers.extend([hit.distance, side]);
        numbers
    };
    let sphere: Sphere<S> = DualSphere {
        weight: m,
        ..DualSphere::from_centre_radius_squared(centre, l)
    }
    .undual();
    let plane = Plane::from_point_normal(centre, [l, m, d]);
    let disc = Circle::new(centre, Direction::from([m, l, e]), l * l);
    let triangle = [Point::new(k, m, l), Point::new(-g, l, h), centre];
    let mut found = Vec::new();
    for start in [|a, b, _| Ray::new(a, b), |a, _, c| Ray::through(a, c)] {
        let ray = || start(point, axis, centre);
        let hit = |surface: &dyn Surface<S>| ray().and_then(|ray| ray.first_hit(surface));
        let (ball, wall) = (|| hit(&sphere), || hit(&plane));
        let nearer = ball().zip(wall()).map(|(a, b)| {
            let is_nearer = a.distance.less_than(b.distance);
            Hit::select(is_nearer, a, b)
        });
        found.extend([
            ray().map(of_ray),
            ray().map(|ray| ray.line().coefficients().map(|(_, x)| x).collect()),
            ray().map(|ray| [ray.advance(l).at(m).coordinates(), [ray.depth(centre); 3]].concat()),
            ray().and_then(|ray| ray.reflect_in(plane)).map(of_ray),
            ball().map(of_hit),
            wall().map(of_hit),
            hit(&sphere.dual()).map(of_hit),
            hit(&plane.dual()).map(of_hit),
            hit(&disc).map(of_hit),
            hit(&disc.dual()).map(of_hit),
            hit(&triangle).map(of_hit),
            nearer.or_else(ball).or_else(wall).map(of_hit),
            ray()
                .and_then(|ray| ray.entry_and_exit(sphere))
                .map(|[entry, exit]| [of_hit(entry), of_hit(exit)].concat()),
            ray()
                .zip(wall())
                .map(|(ray, hit)| of_ray(ray.reflect(&hit))),
            ray()
                .zip(wall())
                .and_then(|(ray, hit)| ray.refract(&hit, l))
                .map(of_ray),
            ray()
                .zip(ball())
                .map(|(ray, hit)| ray.refract(&hit, l).unwrap_or(ray.reflect(&hit)))
                .map(of_ray),
        ]);
    }
    found
}

/// Coordinates that are usual or not: degenerate, of extreme size, or no numbers.
fn coordinate(random: &mut SplitMix64) -> f64 {
    const ODD: [f64; 12] = [
        0.0,
        -0.0,
        1.0,
        -1.0,
        1e-170,
        1e170,
        1e-13,
        1e13,
        1e-310,
        f64::INFINITY,
        f64::NAN,
        2.0,
    ];
    if random.unit() < 0.85 {
        random.within(4.0)
    } else {
        ODD[(random.unit() * ODD.len() as f64) as usize]
    }
}

/// Rows of eleven numbers, whole parts of which may be zero or equal.
fn rows(random: &mut SplitMix64) -> [[f64; 11]; 4] {
    core::array::from_fn(|_| {
        let mut row: [f64; 11] = core::array::from_fn(|_| coordinate(random));
        match (random.unit() * 10.0) as u32 {
            // No axis; the point at the centre; the point on the axis; a tangent.
            0 => row[3..6].fill(0.0),
            1 => row.copy_within(0..3, 6),
            2 => (0..3).for_each(|i| row[i] = row[6 + i] + 2.0 * row[3 + i]),
            3 => row[9] = 0.0,
            4 => row[10] = 0.0,
            // A ray that touches a sphere.
            6 => row[3..5].fill(0.0),
            5 => row = [-2.0, 1.0, 0.0, 4.0, 0.0, 0.0, 0.5, 0.0, 0.0, 1.0, row[10]],
            _ => {}
        }
        row
    })
}

/// Equal bits, and all NaNs equal.
fn is_same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan()
}

/// Compares the lanes of what was found with what each row gives alone; counts the results of each
/// quantity that do not exist and those that do.
fn compare<S: Real>(
    found: Found<S>,
    rows: [[f64; 11]; 4],
    alone: &[Found<f64>; 4],
    lane_of: impl Fn(S, usize) -> f64,
) -> Vec<[usize; 2]> {
    let mut counts = vec![[0, 0]; found.len()];
    assert!(alone.iter().all(|alone| alone.len() == found.len()));
    for (place, lanes) in found.into_iter().enumerate() {
        let mask = lanes.is_some();
        // For lanes the function is called always.
        let mut numbers = Vec::new();
        let _ = lanes.map(|found| numbers = found);
        for (lane, row) in rows.iter().enumerate() {
            let expected = &alone[lane][place];
            assert_eq!(
                mask.lane(lane),
                expected.is_some(),
                "quantity {place} of {row:?}"
            );
            counts[place][usize::from(mask.lane(lane))] += 1;
            let Some(expected) = expected else { continue };
            assert_eq!(numbers.len(), expected.len());
            for (found, expected) in numbers.iter().zip(expected) {
                let found = lane_of(*found, lane);
                let is_same = is_same(found, *expected);
                assert!(
                    is_same,
                    "quantity {place} of {row:?}: {found} for {expected}"
                );
            }
        }
    }
    counts
}

#[test]
fn lanes_are_single_numbers_side_by_side() {
    let mut random = SplitMix64(27);
    let mut counts = Vec::new();
    for _ in 0..1000 {
        let rows = rows(&mut random);
        let columns: [_; 11] = core::array::from_fn(|k| rows.map(|row| row[k]));
        let alone = rows.map(|row| everything(row, 1e-9));
        let lanes = everything(columns.map(Lanes::from_array), Lanes::splat(1e-9));
        let found = compare(lanes, rows, &alone, |x: Lanes<f64, 4>, lane| x[lane]);
        let _ = compare(
            everything(columns.map(f64x4::from), f64x4::splat(1e-9)),
            rows,
            &alone,
            |x: f64x4, lane| x.to_array()[lane],
        );
        counts.push(found);
    }
    assert_some_exist(&counts);
}

/// Each quantity must exist for some rows and not exist for others.
fn assert_some_exist(counts: &[Vec<[usize; 2]>]) {
    let quantities = counts.first().map_or(0, Vec::len);
    let total = |place: usize, exist: usize| -> usize {
        counts.iter().map(|counts| counts[place][exist]).sum()
    };
    let totals = (0..quantities).map(|place| [total(place, 0), total(place, 1)]);
    assert!(quantities > 0);
    for (place, [none, some]) in totals.enumerate() {
        assert!(none > 0 && some > 0, "quantity {place}: {none} and {some}");
    }
}

/// The vectors of `wide` have an arctangent of their own, so that angles are compared for lanes
/// only.
#[test]
fn angles_in_lanes_are_those_of_each_lane() {
    let mut random = SplitMix64(8);
    let mut counts = Vec::new();
    for _ in 0..500 {
        let rows = rows(&mut random);
        let columns: [_; 11] = core::array::from_fn(|k| rows.map(|row| row[k]));
        let lanes = angles(columns.map(Lanes::from_array));
        let alone = rows.map(angles);
        counts.push(compare(lanes, rows, &alone, |x: Lanes<f64, 4>, lane| {
            x[lane]
        }));
    }
    assert_some_exist(&counts);
}

/// A program that once did not compile: everything that a generic function does with motors is
/// there for lanes.
#[test]
fn motors_in_lanes_are_normalised() {
    let all = Lanes::<f32, 8>::splat;
    let motor: Motor<Lanes<f32, 8>> = Motor::default();
    let between = motor.log().exp().interpolate(motor, all(0.5));
    assert_eq!(between.rotor().scalar(), all(1.0));
    let normalized = between.sqrt().normalized();
    assert!(normalized.is_some().all());
    let same = normalized.unwrap_or(motor);
    let point = Point::new(all(1.0), all(1.0), all(1.0));
    assert_eq!(same.transform(point).distance(point), all(0.0));
}

/// Of dual numbers over lanes, the values are those of the lanes, and the derivatives those of a
/// dual number alone.
#[test]
fn dual_numbers_over_lanes_have_the_derivatives_of_each_lane() {
    fn foot<S: Real>(numbers: [S; 9]) -> Maybe<[S; 3], S> {
        let [a, b, c, d, e, f, g, h, k] = numbers;
        let plane = Plane::from_point_normal(Point::new(a, b, c), [d, e, f]);
        let image = Point::new(g, h, k).reflect_in(plane);
        image.map(Point::coordinates)
    }

    let mut random = SplitMix64(5);
    for round in 0..500 {
        let mut rows: [[f64; 9]; 4] =
            core::array::from_fn(|_| core::array::from_fn(|_| random.within(4.0)));
        rows[round % 4][3..6].fill(0.0);
        let columns: [_; 9] = core::array::from_fn(|k| {
            let column = Lanes::from_array(rows.map(|row| row[k]));
            Dual::<_, 1>::new(column, [Lanes::splat(1.0 + k as f64)])
        });
        let found = foot(columns);
        for (lane, row) in rows.into_iter().enumerate() {
            let varied: [_; 9] =
                core::array::from_fn(|k| Dual::<_, 1>::new(row[k], [1.0 + k as f64]));
            let alone = foot(varied);
            assert_eq!(alone.is_none(), lane == round % 4);
            let lanes = found.lane(lane).map(|image| {
                image.map(|x| Dual::<_, 1>::new(x.value[lane], [x.derivatives[0][lane]]))
            });
            assert_eq!(lanes, alone);
        }
    }
}
