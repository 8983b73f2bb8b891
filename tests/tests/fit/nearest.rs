//! Nothing near a fit has a smaller sum of squared distances.

use core::f64::consts::TAU;

use ga_runtime::cga2;
use ga_runtime::cga3::{Circle, Line, Plane, Point, Sphere};
use ga_runtime::geometry::fit::{Cylinder, PrimitiveFit};
use nullcone_tests::plain::{Vector, along, cross, dot, length, minus, plus, unit_of};
use nullcone_tests::random::SplitMix64;
use proptest::prelude::*;

use super::sample::{Figure, noisy};

/// The centre or a point, the axis and the radius of a fit.
fn figure<P, const N: usize>(fit: &PrimitiveFit<P, f64, N>) -> Figure {
    Figure {
        point: fit.origin().coordinates(),
        axis: fit.axes()[2],
        radius: fit.radius(),
    }
}

/// Asserts that the sum of the squares of distances is least at a fit: the root mean square is what
/// it says, and it is not smaller at figures nearby.
fn check<P, const N: usize>(
    random: &mut SplitMix64,
    places: &[Vector],
    fit: &PrimitiveFit<P, f64, N>,
    residual: impl Fn(Point<f64>) -> f64,
    distance: impl Fn(&Figure, Vector) -> f64,
) -> Result<(), TestCaseError> {
    let cost = |figure: &Figure| {
        places
            .iter()
            .map(|&x| distance(figure, x).powi(2))
            .sum::<f64>()
    };
    let found = figure(fit);
    let least = cost(&found);
    let rms = (least / places.len() as f64).sqrt();
    prop_assert!((fit.rms() - rms).abs() < 1e-12 * (1.0 + rms));
    for _ in 0..40 {
        let size = 10.0_f64.powf(-1.0 - 5.0 * random.unit()) * found.radius.max(0.3);
        let other = Figure {
            point: plus(found.point, random.vector(size)),
            axis: unit_of(plus(found.axis, random.vector(size))),
            radius: (found.radius + random.within(size)).abs(),
        };
        let near = cost(&other);
        prop_assert!(
            least <= near * (1.0 + 1e-12),
            "{found:?} {other:?} {least} {near}"
        );
    }
    for &place in places {
        prop_assert!((residual(place.into()) - distance(&found, place)).abs() < 1e-12);
    }
    Ok(())
}

fn to_points(places: &[Vector]) -> Vec<Point<f64>> {
    places.iter().copied().map(Point::from).collect()
}

/// Asserts that the axes of a fit are right-handed and orthonormal, and that the third one, which
/// the primitive has too, has a positive component of largest magnitude.
fn check_axes<P, const N: usize>(
    fit: &PrimitiveFit<P, f64, N>,
    of_primitive: Option<Vector>,
) -> Result<(), TestCaseError> {
    let [u, v, n] = fit.axes();
    prop_assert!(length(minus(cross(u, v), n)) < 1e-12 && (length(n) - 1.0).abs() < 1e-12);
    let largest = n.into_iter().fold(
        0.0,
        |most: f64, x| if x.abs() > most.abs() { x } else { most },
    );
    prop_assert!(largest > 0.0, "{n:?}");
    prop_assert!(of_primitive.is_some_and(|axis| length(minus(axis, n)) < 1e-12));
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn fits_are_the_nearest(seed in any::<u64>(), noise in 1e-4..0.05_f64) {
        let random = &mut SplitMix64(seed);
        let truth = Figure::random(random, 5.0, [0.5, 3.0]);
        let arc = 1.0 + 5.0 * random.unit();
        let count = 20;
        let mut places = |point: &mut dyn FnMut(&mut SplitMix64) -> Vector| -> Vec<Vector> {
            (0..count)
                .map(|_| {
                    let place = point(random);
                    noisy(random, place, noise * truth.radius)
                })
                .collect()
        };
        let sphere = places(&mut |random| {
            truth.on_sphere((1.0 - arc / 4.0 * random.unit()).acos(), TAU * random.unit())
        });
        let circle = places(&mut |random| truth.on_circle(arc * random.unit()));
        let cylinder = places(&mut |random| truth.on_cylinder(arc * random.unit(), random.within(2.0)));
        let plane = places(&mut |random| truth.on_plane(random.within(1.0), random.within(2.0)));
        let line = places(&mut |random| along(truth.point, random.within(2.0), truth.axis));

        let from_axis = |f: &Figure, x| length(cross(minus(x, f.point), f.axis));
        let height = |f: &Figure, x| dot(minus(x, f.point), f.axis);
        let fit = Sphere::fit(&to_points(&sphere)).unwrap();
        check(random, &sphere, &fit, |x| fit.residual(x), |f, x| length(minus(x, f.point)) - f.radius)?;
        let fit = Circle::fit(&to_points(&circle)).unwrap();
        check(random, &circle, &fit, |x| fit.residual(x), |f, x| (from_axis(f, x) - f.radius).hypot(height(f, x)))?;
        check_axes(&fit, fit.primitive.unit_normal())?;
        let fit = Cylinder::fit(&to_points(&cylinder)).unwrap();
        check_axes(&fit, fit.primitive.axis.unit_direction())?;
        check(random, &cylinder, &fit, |x| fit.residual(x), |f, x| from_axis(f, x) - f.radius)?;
        let fit = Plane::fit(&to_points(&plane)).unwrap();
        check_axes(&fit, fit.primitive.unit_normal())?;
        check(random, &plane, &fit, |x| fit.residual(x), height)?;
        let fit = Line::fit(&to_points(&line)).unwrap();
        check_axes(&fit, fit.primitive.unit_direction())?;
        check(random, &line, &fit, |x| fit.residual(x), from_axis)?;
    }

    /// Single precision finds what double precision finds for the same points, within the rounding
    /// of a hundred numbers that the errors of the points enlarge.
    #[test]
    fn single_precision_finds_the_same(seed in any::<u64>(), noise in 1e-4..0.03_f64) {
        let random = &mut SplitMix64(seed);
        let truth = Figure::random(random, 2.0, [0.5, 2.0]);
        let mut places = |point: &mut dyn FnMut(&mut SplitMix64) -> Vector| {
            let single: Vec<Point<f32>> = (0..25)
                .map(|_| {
                    let place = point(random);
                    Point::from(noisy(random, place, noise).map(|x| x as f32))
                })
                .collect();
            let double = single.iter().map(|p| Point::from(p.coordinates().map(f64::from)));
            let double: Vec<Point<f64>> = double.collect();
            (single, double)
        };
        macro_rules! compare {
            ($Type:ident, $places:expr) => {{
                let (single, double) = $places;
                let (single, double) = ($Type::fit(&single).unwrap(), $Type::fit(&double).unwrap());
                prop_assert!((f64::from(single.radius()) - double.radius()).abs() < 1e-4);
                prop_assert!((f64::from(single.rms()) - double.rms()).abs() < 1e-5);
                let origin = single.origin().coordinates().map(f64::from);
                prop_assert!(length(minus(origin, double.origin().coordinates())) < 2e-4);
                let axis = single.axes()[2].map(f64::from);
                prop_assert!(length(cross(axis, double.axes()[2])) < 2e-4);
            }};
        }
        compare!(Sphere, places(&mut |random| {
            truth.on_sphere((1.0 - random.unit()).acos(), TAU * random.unit())
        }));
        compare!(Circle, places(&mut |random| truth.on_circle(4.0 * random.unit())));
        compare!(Cylinder, places(&mut |random| {
            truth.on_cylinder(5.0 * random.unit(), random.within(2.0))
        }));
        compare!(Plane, places(&mut |random| truth.on_plane(random.within(1.0), random.within(2.0))));
        compare!(Line, places(&mut |random| along(truth.point, random.within(2.0), truth.axis)));
    }

    /// In the plane, whose lines and circles are compared with their normal and their centre.
    #[test]
    fn fits_in_the_plane_are_the_nearest(seed in any::<u64>(), noise in 1e-4..0.1_f64) {
        let random = &mut SplitMix64(seed);
        let truth = Figure { axis: [0.0, 0.0, 1.0], ..Figure::random(random, 5.0, [0.5, 3.0]) };
        let flat = |[x, y, _]: Vector| cga2::Point::new(x, y);
        let circle: Vec<_> = (0..12)
            .map(|_| {
                let place = truth.on_circle(4.0 * random.unit());
                flat(noisy(random, place, noise * truth.radius))
            })
            .collect();
        let line: Vec<_> = (0..12)
            .map(|_| {
                let place = along(truth.point, random.within(2.0), [0.6, 0.8, 0.0]);
                flat(noisy(random, place, noise))
            })
            .collect();
        let fit = cga2::Circle::fit(&circle).unwrap();
        let [x, y, _] = fit.origin().coordinates();
        let of_circle = |x: f64, y: f64, radius: f64| -> f64 {
            circle.iter().map(|p| ((p.x() - x).hypot(p.y() - y) - radius).powi(2)).sum()
        };
        let least = of_circle(x, y, fit.radius());
        let fit_line = cga2::Line::fit(&line).unwrap();
        // n·x = d.
        let of_line = |angle: f64, d: f64| -> f64 {
            let (s, c) = angle.sin_cos();
            line.iter().map(|p| (c * p.y() - s * p.x() - d).powi(2)).sum()
        };
        let [u, v] = fit_line.primitive.direction();
        check_axes(&fit_line, Some([u, v, 0.0]))?;
        let angle = v.atan2(u);
        let [a, b, _] = fit_line.origin().coordinates();
        let d = u * b - v * a;
        let least_of_line = of_line(angle, d);
        prop_assert!((fit_line.rms() - (least_of_line / 12.0).sqrt()).abs() < 1e-12);
        for p in &line {
            prop_assert!((fit_line.residual(*p) - (u * p.y() - v * p.x() - d)).abs() < 1e-12);
        }
        for _ in 0..40 {
            let size = 10.0_f64.powf(-1.0 - 5.0 * random.unit());
            let [a, b, c] = random.vector(size);
            prop_assert!(least <= of_circle(x + a, y + b, fit.radius() + c) * (1.0 + 1e-12));
            prop_assert!(least_of_line <= of_line(angle + a, d + b) * (1.0 + 1e-12));
        }
    }
}

/// At a minimum the sum of squared distances has no slope, up to rounding. Of short arcs with large
/// errors the circle may be much larger than the one that was drawn, or curved to the other side,
/// but it fits no worse.
#[test]
fn circles_through_noisy_short_arcs_are_minima() {
    let random = &mut SplitMix64(5);
    for _ in 0..2000 {
        let centre = [20.0 * random.unit(), -30.0 * random.unit()];
        let radius = 5.0 + 10.0 * random.unit();
        let (start, arc) = (TAU * random.unit(), 0.2 + random.unit());
        let noise = radius * (0.002 + 0.028 * random.unit());
        let points: Vec<_> = (0..20)
            .map(|k| {
                let angle = start + arc * f64::from(k) / 19.0;
                let distance = radius + random.within(noise);
                let (s, c) = angle.sin_cos();
                cga2::Point::new(centre[0] + distance * c, centre[1] + distance * s)
            })
            .collect();
        let drawn: f64 = points
            .iter()
            .map(|p| ((p.x() - centre[0]).hypot(p.y() - centre[1]) - radius).powi(2))
            .sum();
        let fit = cga2::Circle::fit(&points).unwrap();
        let [x, y, _] = fit.origin().coordinates();
        let (mut slope, mut size, mut cost) = ([0.0; 3], 0.0, 0.0);
        for p in &points {
            let [u, v] = [p.x() - x, p.y() - y];
            let distance = u.hypot(v);
            let residual = distance - fit.radius();
            cost += residual * residual;
            size += residual.abs();
            for (sum, part) in slope.iter_mut().zip([u / distance, v / distance, 1.0]) {
                *sum += residual * part;
            }
        }
        assert!(
            slope.iter().all(|sum| sum.abs() < 1e-8 * size),
            "{slope:?} {size}"
        );
        assert!(cost <= drawn, "{cost} {drawn}");
    }
}
