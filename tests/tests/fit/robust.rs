//! Points of which half are gross errors.

use core::f64::consts::{PI, TAU};

use ga_runtime::cga3::{Circle, Line, Plane, Point, Sphere};
use ga_runtime::geometry::fit::{Cylinder, Loss, PrimitiveFit, RobustFit, RobustSettings};
use nullcone_tests::plain::{Vector, along, cross, dot, length, minus, plus};
use nullcone_tests::random::SplitMix64;

use super::sample::{Figure, noisy};

/// The standard deviation of the noise, and how far points may be that agree.
const NOISE: f64 = 0.01;
const THRESHOLD: f64 = 0.04;
/// Points that are right, and as many that are wrong.
const HALF: usize = 60;

/// Every other point is wrong: anywhere in a cube about the figure.
fn half_wrong(
    random: &mut SplitMix64,
    figure: &Figure,
    mut point: impl FnMut(&mut SplitMix64) -> Vector,
) -> Vec<Point<f64>> {
    let mut all = Vec::new();
    for _ in 0..HALF {
        let right = point(random);
        all.push(Point::from(noisy(random, right, NOISE)));
        all.push(Point::from(plus(figure.point, random.vector(3.0))));
    }
    all
}

/// Asserts that the inliers are the points nearer than the threshold, nearly all of them are right,
/// and nearly all right points are among them.
fn check_inliers<P, const N: usize>(found: &RobustFit<P, f64, N>, residual: impl Fn(usize) -> f64) {
    let near: Vec<usize> = (0..2 * HALF)
        .filter(|&k| residual(k).abs() < THRESHOLD)
        .collect();
    assert_eq!(found.inliers, near);
    let right = near.iter().filter(|k| **k % 2 == 0).count();
    assert!(right >= HALF - 3, "{right}");
    assert!(
        (0.5..1.7).contains(&(found.scale / NOISE)),
        "{}",
        found.scale
    );
    let deviation = found
        .fit
        .standard_deviation()
        .expect("more points than unknowns");
    assert!((0.5..1.7).contains(&(deviation / NOISE)));
}

/// The centre or a point, the axis and the radius.
fn parts<P, const N: usize>(fit: &PrimitiveFit<P, f64, N>) -> (Vector, Vector, f64) {
    (fit.origin().coordinates(), fit.axes()[2], fit.radius())
}

macro_rules! recovered {
    ($Type:ident, $points:expr, $settings:expr) => {{
        let points = $points;
        let found = $Type::fit_robustly(&points, $settings).unwrap();
        check_inliers(&found, |k| found.fit.residual(points[k]));
        assert_eq!(found, $Type::fit_robustly(&points, $settings).unwrap());
        parts(&found.fit)
    }};
}

#[test]
fn half_of_the_points_may_be_wrong() {
    const SCENES: u64 = 40;
    let bound = 0.03;
    for seed in 0..SCENES {
        let random = &mut SplitMix64(seed);
        let truth = Figure::random(random, 20.0, [1.0, 2.0]);
        let settings = &RobustSettings {
            seed,
            loss: [Loss::Tukey, Loss::Huber][seed as usize % 2],
            ..RobustSettings::new(THRESHOLD)
        };
        let off = |point: Vector| minus(point, truth.point);

        let sphere = half_wrong(random, &truth, |random| {
            truth.on_sphere((1.0 - random.unit()).acos(), TAU * random.unit())
        });
        let (centre, _, radius) = recovered!(Sphere, sphere, settings);
        assert!(length(off(centre)) < bound && (radius - truth.radius).abs() < bound);

        let circle = half_wrong(random, &truth, |random| truth.on_circle(PI * random.unit()));
        let (centre, axis, radius) = recovered!(Circle, circle, settings);
        assert!(length(off(centre)) < bound && (radius - truth.radius).abs() < bound);
        assert!(length(cross(axis, truth.axis)) < bound);

        let plane = half_wrong(random, &truth, |random| {
            truth.on_plane(random.within(3.0), random.within(3.0))
        });
        let (point, axis, _) = recovered!(Plane, plane, settings);
        assert!(dot(off(point), truth.axis).abs() < bound);
        assert!(length(cross(axis, truth.axis)) < bound);

        let line = half_wrong(random, &truth, |random| {
            along(truth.point, random.within(3.0), truth.axis)
        });
        let (point, axis, _) = recovered!(Line, line, settings);
        assert!(length(cross(off(point), truth.axis)) < bound);
        assert!(length(cross(axis, truth.axis)) < bound);

        // Samples of cylinders take long without optimisation.
        if seed % 10 != 0 {
            continue;
        }
        let cylinder = half_wrong(random, &truth, |random| {
            truth.on_cylinder(TAU * random.unit(), random.within(2.0))
        });
        let (point, axis, radius) = recovered!(Cylinder, cylinder, settings);
        assert!(length(cross(off(point), truth.axis)) < bound, "{seed}");
        assert!(length(cross(axis, truth.axis)) < bound && (radius - truth.radius).abs() < bound);
    }
}

/// Exact points among wrong ones, of which the median distance is zero, are found to rounding.
#[test]
fn exact_points_among_wrong_ones_are_exact() {
    for seed in 0..20 {
        let random = &mut SplitMix64(seed);
        let truth = Figure::random(random, 5.0, [1.0, 2.0]);
        let mut points = Vec::new();
        for _ in 0..30 {
            points.push(Point::from(
                truth.on_sphere((1.0 - 2.0 * random.unit()).acos(), TAU * random.unit()),
            ));
            // At least a tenth away from the sphere.
            let outside = truth.radius + 0.1 + random.unit();
            points.push(Point::from(along(truth.point, outside, random.axis())));
        }
        // One is so far away that it would take all digits of the others.
        points.push(Point::new(1e15, 0.0, 0.0));
        let found = Sphere::fit_robustly(&points, &RobustSettings::new(0.01)).unwrap();
        assert!(found.fit.origin().distance(truth.point.into()) < 1e-13);
        assert!((found.fit.radius() - truth.radius).abs() < 1e-13);
        assert_eq!(found.inliers, (0..60).step_by(2).collect::<Vec<_>>());
    }
}

/// The number of samples follows from the confidence: where all points agree, one sample is
/// enough; where half of them agree, `ln(1 − p)/ln(1 − 2⁻ⁿ)` samples of n points.
#[test]
fn as_many_samples_are_drawn_as_the_confidence_needs() {
    let random = &mut SplitMix64(9);
    let truth = Figure::random(random, 5.0, [1.0, 2.0]);
    let plane = |random: &mut SplitMix64| truth.on_plane(random.within(3.0), random.within(3.0));
    let right: Vec<_> = (0..40).map(|_| Point::from(plane(random))).collect();
    let settings = RobustSettings::new(THRESHOLD);
    assert_eq!(Plane::fit_robustly(&right, &settings).unwrap().samples, 1);
    let half = half_wrong(random, &truth, plane);
    for (confidence, expected) in [(0.9, 17.2), (0.999, 51.7), (0.999_999, 103.5)] {
        let found = Plane::fit_robustly(
            &half,
            &RobustSettings {
                confidence,
                ..settings
            },
        )
        .unwrap();
        // A few wrong points agree by chance, and some right ones do not.
        let drawn = found.samples as f64;
        assert!(
            (0.7..1.2).contains(&(drawn / expected)),
            "{drawn}, not {expected}"
        );
    }
    let few = RobustSettings {
        samples: 3,
        ..settings
    };
    assert_eq!(
        Plane::fit_robustly(&half, &few).map_or(3, |found| found.samples),
        3
    );
}

/// The scale from the median is that of the noise, for one and for two components.
#[test]
fn the_median_gives_the_scale() {
    let random = &mut SplitMix64(3);
    let truth = Figure::random(random, 1.0, [1.0, 2.0]);
    let count = 4000;
    let mut points = |point: &dyn Fn(f64, f64) -> Vector| -> Vec<Point<f64>> {
        (0..count)
            .map(|_| {
                let place = point(random.within(1.0), random.within(1.0));
                Point::from(noisy(random, place, NOISE))
            })
            .collect()
    };
    let plane = points(&|x, y| truth.on_plane(x, y));
    let line = points(&|x, _| along(truth.point, x, truth.axis));
    let settings = &RobustSettings::new(10.0 * NOISE);
    let (plane, line) = (
        Plane::fit_robustly(&plane, settings).unwrap(),
        Line::fit_robustly(&line, settings).unwrap(),
    );
    // The standard deviation of the median is about 1.9 % at this number.
    assert!((plane.scale / NOISE - 1.0).abs() < 0.06, "{}", plane.scale);
    assert!((line.scale / NOISE - 1.0).abs() < 0.06, "{}", line.scale);
    for deviation in [
        plane.fit.standard_deviation(),
        line.fit.standard_deviation(),
    ] {
        // 95 % of the efficiency: the covariance is larger by 1/0.95.
        let ratio = (deviation.unwrap() / NOISE).powi(2);
        assert!((ratio - 1.0 / 0.95).abs() < 0.07, "{ratio}");
    }
}
