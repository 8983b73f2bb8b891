//! Exact points give the exact primitive, near to the origin and far from it.

use core::f64::consts::{PI, TAU};

use ga_runtime::cga2;
use ga_runtime::cga3::{Circle, Line, Plane, Point, Sphere};
use ga_runtime::geometry::FitError;
use ga_runtime::geometry::fit::Cylinder;
use nullcone_tests::plain::{Vector, along, cross, dot, length, minus};
use nullcone_tests::random::SplitMix64;
use proptest::prelude::*;

use super::sample::Figure;

/// The promised error, relative to the sum of the size and of the distance from the origin.
const ERROR: f64 = 1e-12;

fn points(count: usize, point: impl FnMut() -> Vector) -> Vec<Point<f64>> {
    let mut point = point;
    (0..count).map(|_| Point::from(point())).collect()
}

/// A distance from the origin of up to ten thousand radii.
fn figure(random: &mut SplitMix64) -> Figure {
    let radius = 10.0_f64.powf(random.within(3.0));
    let distance = radius * 10.0_f64.powf(4.0 * random.unit());
    Figure::random(random, distance, [radius, radius])
}

fn reach(figure: &Figure, size: f64) -> f64 {
    size + length(figure.point)
}

fn off_axis(found: Vector, axis: Vector) -> f64 {
    length(cross(found, axis))
}

/// The distance of a point from the line of a figure.
fn from_axis(figure: &Figure, point: Vector) -> f64 {
    length(cross(minus(point, figure.point), figure.axis))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn spheres(seed in any::<u64>()) {
        let random = &mut SplitMix64(seed);
        let truth = figure(random);
        // Caps from a hundredth of a radian to the whole: the sagitta of a cap is its squared
        // width, and it alone says how large the radius is.
        let cap = if seed % 2 == 0 { PI } else { 10.0_f64.powf(-2.0 * random.unit()) };
        let width = 1.0 - cap.min(PI).cos();
        let count = 12 + (random.unit() * 20.0) as usize;
        let points = points(count, || {
            let cosine = 1.0 - width * random.unit();
            truth.on_sphere(cosine.acos(), TAU * random.unit())
        });
        let fit = Sphere::fit(&points).unwrap();
        let bound = ERROR * reach(&truth, truth.radius) * (1.0f64).max(0.3 / (cap * cap));
        prop_assert!((fit.radius() - truth.radius).abs() < bound, "{}", (fit.radius() - truth.radius) / bound);
        prop_assert!(fit.origin().distance(truth.point.into()) < bound);
        let sphere = fit.primitive;
        prop_assert!(sphere.centre().unwrap().distance(truth.point.into()) < bound);
        prop_assert!(fit.rms() < ERROR * reach(&truth, truth.radius));
        prop_assert!(fit.residual(truth.point.into()) + truth.radius < bound);
    }

    #[test]
    fn circles(seed in any::<u64>()) {
        let random = &mut SplitMix64(seed);
        let truth = figure(random);
        let arc = if seed % 2 == 0 { TAU } else { TAU * 10.0_f64.powf(-2.0 * random.unit()) };
        let count = 10 + (random.unit() * 20.0) as usize;
        let mut k = 0;
        let points = points(count, || {
            k += 1;
            truth.on_circle(arc * k as f64 / count as f64)
        });
        let fit = Circle::fit(&points).unwrap();
        let bound = ERROR * reach(&truth, truth.radius) * (1.0f64).max(10.0 / (arc * arc));
        prop_assert!((fit.radius() - truth.radius).abs() < bound, "{}", (fit.radius() - truth.radius) / bound);
        prop_assert!(fit.origin().distance(truth.point.into()) < bound, "{}", fit.origin().distance(truth.point.into()) / bound);
        let normal = fit.primitive.unit_normal().unwrap();
        prop_assert!(off_axis(normal, truth.axis) < bound / truth.radius);
        prop_assert!(fit.rms() < ERROR * reach(&truth, truth.radius));
    }

    #[test]
    fn circles_of_the_plane(seed in any::<u64>()) {
        let random = &mut SplitMix64(seed);
        let truth = Figure { axis: [0.0, 0.0, 1.0], ..figure(random) };
        let arc = if seed % 2 == 0 { TAU } else { TAU * 10.0_f64.powf(-2.0 * random.unit()) };
        let points: Vec<_> = (0..20)
            .map(|k| {
                let [x, y, _] = truth.on_circle(arc * f64::from(k) / 20.0);
                cga2::Point::new(x, y)
            })
            .collect();
        let fit = cga2::Circle::fit(&points).unwrap();
        let bound = ERROR * reach(&truth, truth.radius) * (1.0f64).max(10.0 / (arc * arc));
        prop_assert!((fit.radius() - truth.radius).abs() < bound);
        let [x, y, z] = fit.origin().coordinates();
        prop_assert!((x - truth.point[0]).hypot(y - truth.point[1]) < bound && z == 0.0);
    }

    #[test]
    fn planes(seed in any::<u64>()) {
        let random = &mut SplitMix64(seed);
        let truth = figure(random);
        // The narrower, the less the points say of the slope across.
        let width = truth.radius * 10.0_f64.powf(-3.0 * random.unit());
        let points = points(15, || truth.on_plane(random.within(truth.radius), random.within(width)));
        let fit = Plane::fit(&points).unwrap();
        let bound = ERROR * reach(&truth, truth.radius);
        let normal = fit.primitive.unit_normal().unwrap();
        prop_assert!(off_axis(normal, truth.axis) < bound / width, "{}", off_axis(normal, truth.axis) * width / bound);
        let offset = dot(minus(fit.origin().coordinates(), truth.point), truth.axis);
        prop_assert!(offset.abs() < bound && fit.rms() < bound);
    }

    #[test]
    fn lines(seed in any::<u64>()) {
        let random = &mut SplitMix64(seed);
        let truth = figure(random);
        let points = points(9, || along(truth.point, random.within(truth.radius), truth.axis));
        let fit = Line::fit(&points).unwrap();
        let bound = ERROR * reach(&truth, truth.radius);
        let direction = fit.primitive.unit_direction().unwrap();
        prop_assert!(off_axis(direction, truth.axis) < bound / truth.radius);
        prop_assert!(from_axis(&truth, fit.origin().coordinates()) < bound && fit.rms() < bound);
    }

    #[test]
    fn cylinders(seed in any::<u64>()) {
        let random = &mut SplitMix64(seed);
        let truth = figure(random);
        let arc = if seed % 2 == 0 { TAU } else { 1.0 + 5.0 * random.unit() };
        let height = truth.radius * 10.0_f64.powf(random.within(1.0));
        let points = points(30, || {
            truth.on_cylinder(arc * random.unit(), random.within(height))
        });
        let fit = Cylinder::fit(&points).unwrap();
        let bound = 4.0 * ERROR * reach(&truth, truth.radius + height)
            * (1.0f64).max(40.0 / arc.powi(3)) * (truth.radius / height).max(1.0);
        prop_assert!((fit.radius() - truth.radius).abs() < bound, "{}", (fit.radius() - truth.radius) / bound);
        let direction = fit.primitive.axis.unit_direction().unwrap();
        prop_assert!(off_axis(direction, truth.axis) < bound / height.min(truth.radius));
        prop_assert!(from_axis(&truth, fit.origin().coordinates()) < bound);
        prop_assert!(fit.rms() < ERROR * reach(&truth, truth.radius + height));
    }

    #[test]
    fn single_precision(seed in any::<u64>()) {
        let random = &mut SplitMix64(seed);
        let truth = Figure::random(random, 3.0, [0.5, 2.0]);
        let single = |p: Vector| Point::from(p.map(|x| x as f32));
        let points: Vec<_> = (0..20)
            .map(|_| single(truth.on_sphere((1.0 - 2.0 * random.unit()).acos(), TAU * random.unit())))
            .collect();
        let fit = Sphere::fit(&points).unwrap();
        prop_assert!((f64::from(fit.radius()) - truth.radius).abs() < 3e-6);
        let points: Vec<_> = (0..20)
            .map(|_| single(truth.on_cylinder(TAU * random.unit(), random.within(2.0))))
            .collect();
        let fit = Cylinder::fit(&points).unwrap();
        prop_assert!((f64::from(fit.radius()) - truth.radius).abs() < 1e-5);
    }
}

/// A fit of points of any size is the scaled fit, or says that it is beyond the range of the
/// scalar.
#[test]
fn sizes_near_the_ends_of_the_range() {
    let random = &mut SplitMix64(5);
    let truth = Figure::random(random, 3.0, [1.0, 2.0]);
    let places: Vec<Vector> = (0..20)
        .map(|_| truth.on_cylinder(TAU * random.unit(), random.within(2.0)))
        .collect();
    let scaled = |size: f64| -> Vec<Point<f64>> {
        places
            .iter()
            .map(|p| Point::from(p.map(|x| x * size)))
            .collect()
    };
    for size in [1e-140, 1e-100, 1e100, 1e140] {
        let points = scaled(size);
        let fit = Cylinder::fit(&points).unwrap();
        assert!((fit.radius() / size - truth.radius).abs() < 1e-12);
        assert!(fit.rms() < 1e-14 * size && fit.covariance_for(size).is_some());
        let [one, same] = [scaled(1.0), points].map(|points| Sphere::fit(&points).unwrap());
        assert!((same.radius() / size / one.radius() - 1.0).abs() < 1e-9);
        assert!((same.rms() / size / one.rms() - 1.0).abs() < 1e-9);
    }
    for size in [1e170, 1e300] {
        assert_eq!(
            Sphere::fit(&scaled(size)).unwrap_err(),
            FitError::OutOfRange
        );
        assert!(Plane::fit(&scaled(size)).map_or(true, |fit| fit.primitive.support().is_some()));
    }
    let apart = [
        [-1.7e308, 0.0, 0.0],
        [1.7e308, 0.0, 0.0],
        [0.0, 1.7e308, 0.0],
    ]
    .map(Point::from);
    assert_eq!(Plane::fit(&apart).unwrap_err(), FitError::OutOfRange);
}
