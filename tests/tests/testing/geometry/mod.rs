//! The strategies for cga3: they draw what they promise, and every special position occurs. Checked
//! in plain coordinates.

mod pairs;
mod versors;

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use ga_runtime::Element;
use ga_runtime::cga3::{Circle, FlatPoint, Line, Plane, Point, PointPair, Sphere};
use ga_runtime::testing::{cga3, sample};
use nullcone_tests::plain::{cross, dot, length, minus};
use proptest::strategy::Strategy;

const SIZE: f64 = 10.0;
const CASES: usize = 4000;

fn drawn<V: Strategy>(strategy: V) -> Vec<V::Value> {
    sample(&strategy, CASES, 1)
}

/// The share of cases for which a predicate holds.
fn share<T>(cases: &[T], mut predicate: impl FnMut(&T) -> bool) -> f64 {
    cases.iter().filter(|case| predicate(case)).count() as f64 / cases.len() as f64
}

/// Asserts that the share of cases is as expected within 3.5 standard deviations.
#[track_caller]
fn assert_share<T>(cases: &[T], expected: f64, predicate: impl FnMut(&T) -> bool) {
    let found = share(cases, predicate);
    let tolerance = 3.5 * (expected * (1.0 - expected) / cases.len() as f64).sqrt();
    assert!(
        (found - expected).abs() <= tolerance,
        "{found} of the cases, where {expected} is expected"
    );
}

#[test]
fn angles_include_their_landmarks() {
    let angles: Vec<f64> = drawn(cga3::angles());
    assert!(angles.iter().all(|angle| (0.0..=TAU).contains(angle)));
    for landmark in [0.0, FRAC_PI_2, PI, PI + FRAC_PI_2, TAU] {
        assert_share(&angles, 0.125 / 5.0, |&angle| angle == landmark);
    }
    assert_share(&angles, 1.0 / 16.0, |&angle| {
        angle > 0.0 && angle * angle == 0.0
    });
    let is_beside = |angle: f64, place: f64| (1e-13..2e-6).contains(&(angle - place).abs());
    assert_share(&angles, 0.1875 * 2.0 / 3.0, |&angle| is_beside(angle, PI));
    assert_share(&angles, 0.1875 / 3.0, |&angle| is_beside(angle, TAU));
    assert!(share(&angles, |angle| (PI - 2e-6..PI).contains(angle)) > 0.04);
    let singles: Vec<f32> = drawn(cga3::angles());
    assert!(
        singles
            .iter()
            .zip(&angles)
            .all(|(single, double)| *single == *double as f32)
    );
}

#[test]
fn directions_are_unit_vectors_all_around() {
    let directions: Vec<[f64; 3]> = drawn(cga3::directions());
    assert!(directions.iter().all(|&u| (length(u) - 1.0).abs() < 1e-15));
    assert_share(&directions, 0.125, |u| {
        u.iter().filter(|x| **x == 0.0).count() == 2
    });
    let is_beside_an_axis = |u: &[f64; 3]| {
        let across = u
            .iter()
            .filter(|x| x.abs() < 1.001e-3 && **x != 0.0)
            .count();
        across == 2 && u.iter().any(|x| x.abs() > 0.999)
    };
    assert!(share(&directions, is_beside_an_axis) > 0.1);
    // Over a sphere, and over the basis vectors too, the mean of x xᵀ is a third of 1.
    for row in 0..3 {
        for column in 0..3 {
            let mean = directions.iter().map(|u| u[row] * u[column]).sum::<f64>() / CASES as f64;
            let expected = if row == column { 1.0 / 3.0 } else { 0.0 };
            assert!((mean - expected).abs() < 0.025, "{mean} at {row}, {column}");
        }
    }
}

#[test]
fn points_are_in_the_cube() {
    let points: Vec<Point<f64>> = drawn(cga3::points(SIZE));
    assert!(
        points
            .iter()
            .flat_map(|p| p.coordinates())
            .all(|x| x.abs() <= SIZE)
    );
    let any = |p: &Point<f64>, test: &dyn Fn(f64) -> bool| p.coordinates().into_iter().any(test);
    let one_of_three = |chance: f64| 1.0 - (1.0 - chance).powi(3);
    assert_share(&points, one_of_three(1.0 / 24.0), |p| any(p, &|x| x == 0.0));
    assert_share(&points, one_of_three(1.0 / 24.0), |p| {
        any(p, &|x| x == SIZE)
    });
    assert!(share(&points, |p| any(p, &|x| x != 0.0 && x.abs() < 1e-6)) > 0.1);
}

/// Whether the points are collinear, coplanar, coplanar and concyclic, or on one sphere.
fn positions(points: &[[f64; 3]; 5]) -> [bool; 4] {
    let edges = [1, 2, 3, 4].map(|k| minus(points[k], points[0]));
    let span = edges.iter().map(|&e| length(e)).fold(1e-300, f64::max);
    let [a, b, c, d] = edges.map(|edge| edge.map(|x| x / span));
    let pairs = [(a, b), (a, c), (a, d), (b, c), (b, d), (c, d)];
    let on_line = pairs.iter().all(|(u, v)| length(cross(*u, *v)) < 1e-9);
    let triples = [(a, b, c), (a, b, d), (a, c, d), (b, c, d)];
    let in_plane = triples
        .iter()
        .all(|(u, v, w)| dot(cross(*u, *v), *w).abs() < 1e-9);
    // With squares as fourth coordinates, spheres become planes.
    let rows = [a, b, c, d].map(|[x, y, z]| [x, y, z, x * x + y * y + z * z]);
    let on_sphere = determinant(rows).abs() < 1e-9;
    // In a plane, four points are concyclic by Ptolemy's theorem; here the first four, and the last
    // with three of them.
    let on_circle = in_plane && is_cyclic([[0.0; 3], a, b, c]) && is_cyclic([[0.0; 3], a, b, d]);
    [on_line, in_plane, on_circle, on_sphere]
}

fn is_cyclic(p: [[f64; 3]; 4]) -> bool {
    let between = |i: usize, j: usize| length(minus(p[i], p[j]));
    let [x, y, z] = [
        between(0, 1) * between(2, 3),
        between(0, 2) * between(1, 3),
        between(0, 3) * between(1, 2),
    ];
    let largest = x.max(y).max(z);
    (x + y + z - 2.0 * largest).abs() < 1e-9
}

fn determinant<const N: usize>(mut rows: [[f64; N]; N]) -> f64 {
    let mut product = 1.0;
    for k in 0..N {
        let pivot = (k..N).fold(k, |best, i| {
            if rows[i][k].abs() > rows[best][k].abs() {
                i
            } else {
                best
            }
        });
        rows.swap(k, pivot);
        product *= if pivot == k { rows[k][k] } else { -rows[k][k] };
        if rows[k][k] == 0.0 {
            return 0.0;
        }
        let pivot_row = rows[k];
        for row in &mut rows[k + 1..] {
            let factor = row[k] / pivot_row[k];
            for (entry, above) in row.iter_mut().zip(pivot_row) {
                *entry -= factor * above;
            }
        }
    }
    product
}

#[test]
fn point_configurations_take_every_position() {
    let cases: Vec<[[f64; 3]; 5]> = drawn(cga3::point_configurations::<f64, 5>(SIZE))
        .into_iter()
        .map(|points| points.map(Point::coordinates))
        .collect();
    assert!(
        cases
            .iter()
            .flatten()
            .flatten()
            .all(|x| x.abs() <= SIZE * (1.0 + 1e-9))
    );
    let coincide = |case: &[[f64; 3]; 5]| case.iter().all(|place| *place == case[0]);
    assert_share(&cases, 0.1, coincide);
    assert_share(&cases, 0.1, |case| case[0] == case[1] && !coincide(case));
    let near = |case: &[[f64; 3]; 5]| {
        let distance = length(minus(case[0], case[1]));
        distance > 0.0 && distance < 1.001e-3 * SIZE && !positions(case)[1]
    };
    assert!(share(&cases, near) > 0.06);
    let found: Vec<_> = cases
        .iter()
        .filter(|case| case[0] != case[1])
        .map(positions)
        .collect();
    let rate = |predicate: fn(&[bool; 4]) -> bool| share(&found, predicate);
    assert!(rate(|[on_line, ..]| *on_line) > 0.08);
    assert!(rate(|[on_line, in_plane, on_circle, _]| *in_plane && !on_line && !on_circle) > 0.08);
    assert!(rate(|[on_line, _, on_circle, _]| *on_circle && !on_line) > 0.08);
    assert!(rate(|[_, in_plane, _, on_sphere]| *on_sphere && !in_plane) > 0.08);
    assert!(rate(|[_, in_plane, _, on_sphere]| !on_sphere && !in_plane) > 0.2);

    // One point, or none, cannot coincide with another.
    let alone = drawn(cga3::point_configurations::<f32, 1>(SIZE));
    assert!(
        alone
            .iter()
            .all(|[p]| p.coordinates().iter().all(|x| x.is_finite()))
    );
    assert_eq!(
        drawn(cga3::point_configurations::<f64, 0>(SIZE)).len(),
        CASES
    );
}

#[test]
fn flats_are_near_the_cube() {
    let reach = SIZE * 3.0_f64.sqrt() * (1.0 + 1e-12);
    let lines: Vec<Line<f64>> = drawn(cga3::lines(SIZE));
    for line in &lines {
        let (direction, moment) = (line.direction(), line.moment());
        let weight = length(direction);
        assert!((0.0099..=101.0).contains(&weight));
        assert!(dot(direction, moment).abs() <= 1e-14 * weight * weight * reach);
        assert!(length(moment) <= weight * reach);
    }
    assert!(share(&lines, |line| (length(line.direction()) - 1.0).abs() > 1e-3) > 0.4);
    let planes: Vec<Plane<f64>> = drawn(cga3::planes(SIZE));
    for plane in &planes {
        let from_origin = plane
            .signed_distance(Point::default())
            .expect("a plane has a weight");
        assert!(from_origin.abs() <= reach);
    }
    let through_origin = |plane: &Plane<f64>| plane.signed_distance(Point::default()) == Some(0.0);
    assert!(share(&planes, through_origin) > 0.005);
    let flat_points: Vec<FlatPoint<f64>> = drawn(cga3::flat_points(SIZE));
    for flat_point in flat_points {
        let place = flat_point
            .to_point()
            .expect("a flat point has a weight")
            .coordinates();
        assert!(place.iter().all(|x| x.abs() <= SIZE * (1.0 + 1e-15)));
    }
}

#[test]
fn rounds_are_real() {
    let radii = |radius: f64| radius > 0.9e-6 * SIZE && radius < 1.0001 * SIZE;
    let spheres: Vec<Sphere<f64>> = drawn(cga3::spheres(SIZE));
    let parts = |sphere: &Sphere<f64>| {
        (
            sphere.centre().expect("a centre"),
            sphere.radius_squared().expect("a radius"),
        )
    };
    for sphere in &spheres {
        let (centre, squared) = parts(sphere);
        // The square of a small radius is a difference of large numbers.
        assert!(squared < 1.001 * SIZE * SIZE && squared > -1e-12 * SIZE * SIZE);
        assert!(
            centre
                .coordinates()
                .iter()
                .all(|x| x.abs() <= 1.0001 * SIZE)
        );
    }
    assert_share(&spheres, 0.125, |sphere| {
        let (centre, squared) = parts(sphere);
        let distance = dot(centre.coordinates(), centre.coordinates());
        (distance - squared).abs() < 1e-13 * SIZE * SIZE
    });
    assert!(share(&spheres, |sphere| parts(sphere).1 < 1e-4 * SIZE * SIZE) > 0.1);

    let circles = drawn(cga3::circles::<f64>(SIZE));
    assert!(share(&circles, |circle| circle.radius().is_some_and(radii)) > 0.95);
    let pairs = drawn(cga3::point_pairs::<f64>(SIZE));
    assert!(share(&pairs, |pair| pair.radius().is_some_and(radii)) > 0.95);
    // In single precision too, all are real.
    let is_real = |radius: Option<f32>| radius.is_some_and(|radius| radius > 0.0);
    for size in [1.0, SIZE, 1e4] {
        assert!(
            drawn(cga3::spheres::<f32>(size))
                .iter()
                .all(|x| is_real(x.radius()))
        );
        assert!(
            drawn(cga3::circles::<f32>(size))
                .iter()
                .all(|x| is_real(x.radius()))
        );
        assert!(
            drawn(cga3::point_pairs::<f32>(size))
                .iter()
                .all(|x| is_real(x.radius()))
        );
    }
}

#[test]
fn rounds_of_any_kind_are_of_every_kind() {
    let squared: [Vec<Option<f64>>; 3] = [
        drawn(cga3::spheres_of_any_kind(SIZE))
            .iter()
            .map(|x: &Sphere<f64>| x.radius_squared())
            .collect(),
        drawn(cga3::circles_of_any_kind(SIZE))
            .iter()
            .map(|x: &Circle<f64>| x.radius_squared())
            .collect(),
        drawn(cga3::point_pairs_of_any_kind(SIZE))
            .iter()
            .map(|x: &PointPair<f64>| x.radius_squared())
            .collect(),
    ];
    // One radius in eight is small, and its square may be lost in that of the centre.
    for squared in squared {
        let squared: Vec<f64> = squared.into_iter().map(|x| x.expect("a radius")).collect();
        let small = 1e-4 * SIZE * SIZE;
        assert_share(&squared, 0.25, |x| x.abs() < 1e-12 * SIZE * SIZE);
        assert_share(&squared, 0.5 * 0.875, |x| *x >= 0.99 * small);
        assert_share(&squared, 0.25 * 0.875, |x| *x <= -0.99 * small);
        assert!(squared.iter().all(|x| x.abs() < 1.001 * SIZE * SIZE));
    }
}

/// Asserts that all drawn coefficients are finite and some are not zero.
#[track_caller]
fn assert_finite<T: Element<Scalar = f32>>(strategy: impl Strategy<Value = T>) {
    for element in sample(&strategy, 300, 1) {
        let blades = T::BLADES.iter();
        let coefficients: Vec<f32> = blades.map(|&blade| element.coefficient(blade)).collect();
        assert!(coefficients.iter().all(|x| x.is_finite()));
        assert!(coefficients.iter().any(|x| *x != 0.0));
    }
}

#[test]
fn single_precision_is_finite_near_and_far() {
    for size in [1e-3, 1.0, 1e4] {
        assert_finite(cga3::points(size));
        assert_finite(cga3::flat_points(size));
        assert_finite(cga3::lines(size));
        assert_finite(cga3::planes(size));
        assert_finite(cga3::point_pairs(size));
        assert_finite(cga3::point_pairs_of_any_kind(size));
        assert_finite(cga3::circles(size));
        assert_finite(cga3::circles_of_any_kind(size));
        assert_finite(cga3::spheres(size));
        assert_finite(cga3::spheres_of_any_kind(size));
        assert_finite(cga3::translators(size));
        assert_finite(cga3::motors(size));
        assert_finite(cga3::similarities(size, 100.0));
        assert_finite(cga3::pairs_of_lines(size).prop_map(|[a, _]| a));
        assert_finite(cga3::pairs_of_planes(size).prop_map(|[_, b]| b));
        assert_finite(cga3::pairs_of_spheres(size).prop_map(|[_, b]| b));
    }
    assert_finite(cga3::rotors());
    assert_finite(cga3::dilators(100.0));
}
