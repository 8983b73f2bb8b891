//! Covariances, by simulation.
//!
//! For true parameters p, estimates p̂ of noisy sets and their covariance C, the Mahalanobis square
//! `(p̂ − p)ᵀ C⁻¹ (p̂ − p)` has the chi-square distribution of N degrees of freedom: its mean is N
//! and its variance 2N.

use core::f64::consts::{PI, TAU};

use ga_runtime::cga2;
use ga_runtime::cga3::{Circle, Line, Plane, Point, Sphere};
use ga_runtime::geometry::fit::{Cylinder, Loss, PrimitiveFit, RobustSettings};
use nalgebra_035::{DMatrix, DVector};
use nullcone_tests::plain::{Vector, along, cross, dot, minus};
use nullcone_tests::random::SplitMix64;

use super::sample::{Figure, noisy};

const SETS: usize = 1000;
const NOISE: f64 = 0.002;

/// The mean of the Mahalanobis squares of sets, for a given standard deviation and for that of the
/// residuals.
fn mean_squares<const N: usize>(
    mut set: impl FnMut() -> ([f64; N], [[[f64; N]; N]; 2]),
) -> [f64; 2] {
    let mut sums = [0.0; 2];
    for _ in 0..SETS {
        let (error, covariances) = set();
        let error = DVector::from_row_slice(&error);
        for (sum, covariance) in sums.iter_mut().zip(covariances) {
            let matrix = DMatrix::from_fn(N, N, |i, j| covariance[i][j]);
            let solved = matrix.lu().solve(&error).expect("a regular covariance");
            *sum += error.dot(&solved);
        }
    }
    sums.map(|sum| sum / SETS as f64)
}

/// Both means are N within five standard deviations of a mean of that number of squares, and, where
/// the variance is estimated from f degrees of freedom, by the factor f/(f − 2).
fn check<const N: usize>(name: &str, means: [f64; 2], freedom: f64) {
    let unknowns = N as f64;
    let spread = 5.0 * (2.0 * unknowns / SETS as f64).sqrt();
    println!("{name}: {means:?} of {N}, within {spread:.3}");
    assert!((means[0] - unknowns).abs() < spread, "{name}: {means:?}");
    let expected = unknowns * freedom / (freedom - 2.0);
    assert!(
        (means[1] - expected).abs() < 1.2 * spread,
        "{name}: {means:?}, {expected}"
    );
}

fn covariances<P, const N: usize>(fit: &PrimitiveFit<P, f64, N>) -> [[[f64; N]; N]; 2] {
    [
        fit.covariance_for(NOISE).expect("determined parameters"),
        fit.covariance().expect("determined parameters"),
    ]
}

/// The components of the true axis along the first two axes of a fit are minus the errors of its
/// own to first order.
fn tilt<P, const N: usize>(fit: &PrimitiveFit<P, f64, N>, axis: Vector) -> [f64; 2] {
    let [u, v, n] = fit.axes();
    let sign = dot(n, axis).signum();
    [u, v].map(|side| -sign * dot(side, axis))
}

/// The displacement of the fitted axis from the true line along the first two axes of a fit.
fn shift<P, const N: usize>(fit: &PrimitiveFit<P, f64, N>, truth: &Figure) -> [f64; 2] {
    let [u, v, n] = fit.axes();
    let origin = fit.origin().coordinates();
    // The true line at the height of the origin.
    let height = dot(minus(origin, truth.point), n) / dot(truth.axis, n);
    let apart = minus(origin, along(truth.point, height, truth.axis));
    [u, v].map(|side| dot(side, apart))
}

fn sets(
    random: &mut SplitMix64,
    count: usize,
    mut point: impl FnMut(&mut SplitMix64) -> Vector,
) -> Vec<Vector> {
    (0..count)
        .map(|_| {
            let place = point(random);
            noisy(random, place, NOISE)
        })
        .collect()
}

fn points(places: Vec<Vector>) -> Vec<Point<f64>> {
    places.into_iter().map(Point::from).collect()
}

fn truth(random: &mut SplitMix64) -> Figure {
    Figure::random(random, 5.0, [1.0, 2.0])
}

#[test]
fn spheres() {
    let random = &mut SplitMix64(1);
    let truth = truth(random);
    let means = mean_squares(|| {
        let cap = |random: &mut SplitMix64| {
            truth.on_sphere((1.0 - 0.6 * random.unit()).acos(), TAU * random.unit())
        };
        let fit = Sphere::fit(&points(sets(random, 30, cap))).unwrap();
        let [x, y, z] = minus(fit.origin().coordinates(), truth.point);
        ([x, y, z, fit.radius() - truth.radius], covariances(&fit))
    });
    check::<4>("sphere", means, 26.0);
}

#[test]
fn circles() {
    let random = &mut SplitMix64(2);
    let truth = truth(random);
    let means = mean_squares(|| {
        let arc = |random: &mut SplitMix64| truth.on_circle(PI * random.unit());
        let fit = Circle::fit(&points(sets(random, 30, arc))).unwrap();
        let [a, b] = tilt(&fit, truth.axis);
        let apart = minus(fit.origin().coordinates(), truth.point);
        let [x, y, z] = fit.axes().map(|axis| dot(axis, apart));
        (
            [a, b, x, y, z, fit.radius() - truth.radius],
            covariances(&fit),
        )
    });
    check::<6>("circle", means, 54.0);
}

#[test]
fn circles_of_the_plane() {
    let random = &mut SplitMix64(3);
    let truth = Figure {
        axis: [0.0, 0.0, 1.0],
        ..truth(random)
    };
    let means = mean_squares(|| {
        let arc = |random: &mut SplitMix64| truth.on_circle(PI * random.unit());
        let flat = sets(random, 30, arc);
        let flat: Vec<_> = flat
            .into_iter()
            .map(|[x, y, _]| cga2::Point::new(x, y))
            .collect();
        let fit = cga2::Circle::fit(&flat).unwrap();
        let [x, y, _] = minus(fit.origin().coordinates(), truth.point);
        ([x, y, fit.radius() - truth.radius], covariances(&fit))
    });
    check::<3>("circle of the plane", means, 27.0);
}

#[test]
fn planes_and_weights() {
    let random = &mut SplitMix64(4);
    let truth = truth(random);
    let means = mean_squares(|| {
        // The noise of each point has the variance NOISE²/w.
        let weighted: Vec<_> = (0..30)
            .map(|_| {
                let weight = 0.2 + 3.0 * random.unit();
                let place = truth.on_plane(random.within(2.0), random.within(0.7));
                (
                    weight,
                    Point::from(noisy(random, place, NOISE / weight.sqrt())),
                )
            })
            .collect();
        let fit = Plane::fit_weighted(&weighted).unwrap();
        let [a, b] = tilt(&fit, truth.axis);
        let n = fit.axes()[2];
        // The distance along the normal from the true plane to the origin of the fit.
        let height =
            dot(minus(fit.origin().coordinates(), truth.point), truth.axis) / dot(n, truth.axis);
        ([a, b, height], covariances(&fit))
    });
    check::<3>("plane, weighted", means, 27.0);
}

#[test]
fn lines() {
    let random = &mut SplitMix64(5);
    let truth = truth(random);
    let means = mean_squares(|| {
        let line = |random: &mut SplitMix64| along(truth.point, random.within(2.0), truth.axis);
        let fit = Line::fit(&points(sets(random, 20, line))).unwrap();
        let ([a, b], [x, y]) = (tilt(&fit, truth.axis), shift(&fit, &truth));
        ([a, b, x, y], covariances(&fit))
    });
    check::<4>("line", means, 36.0);
}

#[test]
fn cylinders() {
    let random = &mut SplitMix64(6);
    let truth = truth(random);
    let means = mean_squares(|| {
        let part =
            |random: &mut SplitMix64| truth.on_cylinder(4.0 * random.unit(), random.within(2.0));
        let fit = Cylinder::fit(&points(sets(random, 40, part))).unwrap();
        let ([a, b], [x, y]) = (tilt(&fit, truth.axis), shift(&fit, &truth));
        ([a, b, x, y, fit.radius() - truth.radius], covariances(&fit))
    });
    check::<5>("cylinder", means, 35.0);
}

/// The covariance of M-estimates, which holds for many points, to a tenth.
#[test]
fn robust_estimates() {
    for (seed, loss) in [(7, Loss::Huber), (8, Loss::Tukey)] {
        let random = &mut SplitMix64(seed);
        let truth = truth(random);
        let settings = RobustSettings {
            loss,
            ..RobustSettings::new(8.0 * NOISE)
        };
        let means = mean_squares(|| {
            let cap = |random: &mut SplitMix64| {
                truth.on_sphere((1.0 - 0.8 * random.unit()).acos(), TAU * random.unit())
            };
            let mut all = points(sets(random, 150, cap));
            for _ in 0..10 {
                all.push(Point::from(along(
                    truth.point,
                    2.0 * truth.radius,
                    random.axis(),
                )));
            }
            let fit = Sphere::fit_robustly(&all, &settings).unwrap().fit;
            let [x, y, z] = minus(fit.origin().coordinates(), truth.point);
            ([x, y, z, fit.radius() - truth.radius], covariances(&fit))
        });
        println!("{loss:?}: {means:?}");
        assert!((means[1] / 4.0 - 1.0).abs() < 0.1, "{loss:?}: {means:?}");
    }
}

/// Where the points do not determine a parameter, there is no covariance.
#[test]
fn what_is_not_determined_has_no_covariance() {
    // Two circles about one axis: exact, but all cylinders through them share only these two.
    let ring = |z: f64| {
        (0..8).map(move |k| {
            let angle = TAU * f64::from(k) / 8.0;
            Point::new(angle.cos(), angle.sin(), z)
        })
    };
    let both: Vec<_> = ring(0.0).chain(ring(1.0)).collect();
    let fit = Cylinder::fit(&both).unwrap();
    assert!((fit.radius() - 1.0).abs() < 1e-12);
    let covariance = fit.covariance_for(1.0).unwrap();
    // The radius is the mean of sixteen distances; the shift at the middle of both rings that of
    // components: variances 1/16 and 2/16.
    assert!((covariance[4][4] - 1.0 / 16.0).abs() < 1e-12);
    assert!((covariance[2][2] - 2.0 / 16.0).abs() < 1e-12);
    // A tilt moves the rings by half the height to both sides.
    assert!((covariance[0][0] - 0.5).abs() < 1e-12, "{covariance:?}");
    let tilted = cross(fit.axes()[2], [0.0, 0.0, 1.0]);
    assert!(dot(tilted, tilted) < 1e-24);
}
