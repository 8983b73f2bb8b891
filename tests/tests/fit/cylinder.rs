//! Cylinders of many proportions: the search finds the global optimum.

use core::f64::consts::TAU;

use ga_runtime::cga3::Point;
use ga_runtime::geometry::fit::Cylinder;
use nullcone_tests::plain::{cross, dot, length, minus, plus};
use nullcone_tests::random::SplitMix64;

use super::sample::{Figure, noisy};

/// The sum of the squared distances is never above that at the cylinder from which the points were
/// drawn, which the optimum cannot exceed, and its axis is near.
#[test]
fn whole_and_partial_cylinders_of_any_height_are_found() {
    let random = &mut SplitMix64(11);
    let mut worst: f64 = 0.0;
    for scene in 0..600 {
        let truth = Figure::random(random, 10.0, [0.5, 3.0]);
        let arc = if scene % 2 == 0 {
            TAU
        } else {
            1.2 + (TAU - 1.2) * random.unit()
        };
        let height = truth.radius * 10.0_f64.powf(random.within(1.3));
        let noise = truth.radius * 0.01 * random.unit();
        let count = 40 + (random.unit() * 100.0) as usize;
        let points: Vec<_> = (0..count)
            .map(|_| {
                let place = truth.on_cylinder(arc * random.unit(), random.within(height));
                Point::from(noisy(random, place, noise))
            })
            .collect();
        let drawn: f64 = points
            .iter()
            .map(|p| {
                let away = length(cross(minus(p.coordinates(), truth.point), truth.axis));
                (away - truth.radius).powi(2)
            })
            .sum();
        let fit = Cylinder::fit(&points).unwrap();
        let sum = fit.rms().powi(2) * count as f64;
        assert!(
            sum <= drawn,
            "{scene}: {sum} {drawn}, arc {arc}, height {}",
            height / truth.radius
        );
        worst = worst.max((fit.radius() / truth.radius - 1.0).abs());
    }
    println!("the greatest relative error of a radius is {worst}");
}

/// Low rings of few points with large errors, whose tilt the matrix of Gauss and Newton does not
/// see: a search by that alone does not end for some.
#[test]
fn low_rings_are_found() {
    let random = &mut SplitMix64(12);
    for scene in 0..300 {
        let truth = Figure::random(random, 10.0, [0.5, 3.0]);
        let (arc, height) = (2.5 + 3.5 * random.unit(), 0.05 + 0.1 * random.unit());
        let noise = truth.radius * 0.02 * random.unit();
        let points: Vec<_> = (0..15)
            .map(|_| {
                let along = random.within(height * truth.radius);
                let place = truth.on_cylinder(arc * random.unit(), along);
                Point::from(noisy(random, place, noise))
            })
            .collect();
        let fit = Cylinder::fit(&points).unwrap_or_else(|error| panic!("{scene}: {error}"));
        // The origin is the point of the axis nearest to the centroid.
        let centroid = points
            .iter()
            .fold([0.0; 3], |sum, p| plus(sum, p.coordinates()));
        let apart = minus(fit.origin().coordinates(), centroid.map(|x| x / 15.0));
        assert!(dot(apart, fit.axes()[2]).abs() < 1e-12, "{scene}");
    }
}
