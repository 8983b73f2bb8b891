//! Snakes: curves that settle at edges.

use std::f64::consts::TAU;

use ga_image::plane::Plane;
use ga_vision::contour::snake::{self, Flow, Potential, Settled, SnakeFault, SnakeOptions};
use ga_vision::contour::{ContourError, outline, perimeter, resampled};
use nullcone_shared_data::shared;

use super::{grey, truth};

/// The share of two regions that is in both: of the pixels of a picture that are white, and of
/// those whose centres a polygon encloses.
fn overlap(picture: &Plane<u8>, polygon: &[[f64; 2]]) -> f64 {
    let (mut both, mut either) = (0, 0);
    for row in 0..picture.height() {
        for column in 0..picture.width() {
            let (u, v) = (column as f64, row as f64);
            let mut is_inside = false;
            let next = polygon.iter().cycle().skip(1);
            for ([a, b], [c, d]) in polygon.iter().zip(next) {
                if (*b > v) != (*d > v) && u < a + (v - b) / (d - b) * (c - a) {
                    is_inside = !is_inside;
                }
            }
            let is_white = picture.get(column, row) > Some(127);
            both += usize::from(is_inside && is_white);
            either += usize::from(is_inside || is_white);
        }
    }
    f64::from(both as u32) / f64::from(either as u32)
}

#[test]
fn snakes_settle_at_shapes() {
    let Some(folder) = shared("oracle/vision/seed1") else {
        return;
    };
    for case in truth(&folder)["snake"].as_array().unwrap() {
        let name = case["file"].as_str().unwrap();
        let picture = grey(folder.join(name));
        let floats = picture.map(|value| f32::from(value) / 255.0);
        for has_flow in [false, true] {
            let potential = if has_flow {
                Potential::flow(&floats, 2.0, &Flow::default())
            } else {
                Potential::edges(&floats, 2.0)
            };
            let start = snake::circle([100.0, 100.0], 80.0, 200);
            let mut energies = Vec::new();
            let options = SnakeOptions::default();
            let potential = potential.unwrap();
            let found = snake::settle(&start, &potential, &options, |step| {
                energies.push(step.energy);
            });
            let found = found.unwrap();
            let share = overlap(&picture, &found.points);
            let radii = found
                .points
                .iter()
                .map(|[u, v]| (u - 100.0).hypot(v - 100.0));
            let radius = case["r0"].as_f64().unwrap();
            let rms = (radii.map(|r| (r - radius).powi(2)).sum::<f64>() / 200.0).sqrt();
            assert!(energies.is_sorted_by(|a, b| a >= b));
            assert!(found.has_converged, "{name} {has_flow}");
            assert!(share >= 0.97, "{name} {has_flow}: {share}");
            assert!(
                !name.contains("disk") || rms <= 0.3,
                "{name} {has_flow}: {rms}"
            );
        }
    }
}

/// A photograph has many edges, along which a snake may slide for long. The end is a minimum: a
/// snake from there with a finer tolerance stays.
#[test]
fn a_snake_of_400_points_settles_on_a_photograph() {
    let Some(folder) = shared("data/vision/quality") else {
        return;
    };
    let picture = grey(folder.join("astronaut.png")).map(|value| f32::from(value) / 255.0);
    let potential = Potential::edges(&picture, 3.0).unwrap();
    let start = snake::circle([220.0, 100.0], 100.0, 400);
    // Sums over points, without their distance. The second pair is scikit-image's example in the
    // units of this potential.
    let spacing = perimeter(&start) / 400.0;
    let sums = [(0.2, 3.0), (0.16, 106.0), (0.2, 10.0), (0.2, 1.0)];
    let usual = SnakeOptions::default();
    let all = sums
        .map(|(tension, rigidity)| (tension * spacing.powi(2), rigidity * spacing.powi(4)))
        .into_iter()
        .chain([(usual.tension, usual.rigidity)]);
    for (tension, rigidity) in all {
        let options = SnakeOptions {
            tension,
            rigidity,
            ..usual
        };
        let mut energies = Vec::new();
        let found = snake::settle(&start, &potential, &options, |step| {
            energies.push(step.energy);
        });
        let found = found.unwrap();
        assert!(found.has_converged && energies.is_sorted_by(|a, b| a >= b));
        // The same energy in the arc length of the shorter curve.
        let shorter = perimeter(&found.points) / perimeter(&start);
        let finer = SnakeOptions {
            tension: tension * shorter.powi(2),
            rigidity: rigidity * shorter.powi(4),
            tolerance: 1e-6,
            ..options
        };
        let end = snake::settle(&found.points, &potential, &finer, |_| {}).unwrap();
        let ways = found.points.iter().zip(&end.points);
        let greatest = ways
            .map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1]))
            .fold(0.0, f64::max);
        assert!(greatest < 0.1, "{greatest}");
    }
}

/// A smooth shape with a waist, drawn with a soft edge, whose curve must not depend on the number
/// of points of the snake.
#[test]
fn the_number_of_points_does_not_change_the_curve() {
    let shape = Plane::from_fn(200, 180, |column, row| {
        let (x, y) = (column as f64 - 100.0, row as f64 - 90.0);
        let edge = 50.0 + 12.0 * (2.0 * y.atan2(x)).cos();
        (edge + 0.5 - x.hypot(y)).clamp(0.0, 1.0) as f32
    });
    let potential = Potential::edges(&shape, 2.0).unwrap();
    let settled = |count: usize| {
        let start = snake::circle([100.0, 90.0], 72.0, count);
        let options = SnakeOptions::default();
        let found = snake::settle(&start, &potential, &options, |_| {}).unwrap();
        assert!(found.has_converged, "{count}");
        found
    };
    let all = [100, 200, 400, 1200].map(settled);
    let [.., reference] = &all;
    for found in &all {
        let ways = [
            (&found.points, &reference.points),
            (&reference.points, &found.points),
        ];
        for (from, to) in ways {
            let far = from.iter().map(|point| distance_to_polygon(*point, to));
            let far = far.fold(0.0, f64::max);
            assert!(far < 0.1, "{} points: {far} px", found.points.len());
        }
        let change = found.energy / reference.energy - 1.0;
        assert!(change.abs() < 0.01, "{} {change}", found.points.len());
    }
}

fn distance_to_polygon([u, v]: [f64; 2], polygon: &[[f64; 2]]) -> f64 {
    let next = polygon.iter().cycle().skip(1);
    let distances = polygon.iter().zip(next).map(|([a, b], [c, d])| {
        let (x, y) = (c - a, d - b);
        let part = ((u - a) * x + (v - b) * y) / (x * x + y * y);
        let part = part.clamp(0.0, 1.0);
        (u - a - part * x).hypot(v - b - part * y)
    });
    distances.fold(f64::INFINITY, f64::min)
}

#[test]
fn outlines_are_those_of_the_largest_things() {
    let disk = |centre: f64, is_dark: bool| {
        Plane::from_fn(60, 50, |column, row| {
            let is_inside = (column as f64 - centre).hypot(row as f64 - 25.0) < 12.0;
            if is_inside == is_dark { 10u8 } else { 200 }
        })
    };
    for is_dark in [false, true] {
        let found = outline(&disk(30.0, is_dark), 4.0).unwrap();
        assert_eq!(found.is_hole, is_dark);
        assert!((found.area() - 144.0 * TAU / 2.0).abs() < 60.0);
    }
    let cut = outline(&disk(55.0, false), 4.0);
    assert!(
        matches!(
            cut,
            Err(ContourError::LeavesPicture {
                pixel: [59, _],
                size: [60, 50]
            })
        ),
        "{cut:?}"
    );
    let none = outline(&disk(30.0, false), 1000.0);
    assert_eq!(none, Err(ContourError::NoBorder { least_area: 1000.0 }));
    let level = outline(&Plane::filled(9, 8, 7u8), 1.0);
    assert_eq!(level, Err(ContourError::OneLevel));
}

/// Points that are placed at equal distances have moved. A snake has not settled while that goes
/// on, and each step says how far.
#[test]
fn resampling_counts_as_a_move() {
    let level = Potential::new(Plane::filled(100, 100, 0.0)).unwrap();
    let start: Vec<[f64; 2]> = (0..40)
        .map(|k| TAU * (f64::from(k) / 40.0).powi(2))
        .map(|angle| [50.0 + 30.0 * angle.cos(), 50.0 + 30.0 * angle.sin()])
        .collect();
    let options = SnakeOptions {
        tension: 0.0,
        rigidity: 0.0,
        resampled_every: Some(1),
        ..SnakeOptions::default()
    };
    let mut before = start.clone();
    let found = snake::settle(&start, &level, &options, |step| {
        let ways = step.points.iter().zip(&before);
        let way = ways
            .map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1]))
            .fold(0.0, f64::max);
        assert!(step.greatest_move >= way - 1e-12, "{}: {way}", step.number);
        before = step.points.to_vec();
    });
    let found = found.unwrap();
    let again = resampled(&found.points, 40);
    for (a, b) in found.points.iter().zip(&again) {
        assert!((a[0] - b[0]).hypot(a[1] - b[1]) < 0.1, "{a:?} {b:?}");
    }
    let length = |k: usize| {
        let [a, b] = [found.points[k], found.points[(k + 1) % 40]];
        (a[0] - b[0]).hypot(a[1] - b[1])
    };
    assert!(found.has_converged && (length(0) / length(20) - 1.0).abs() < 0.1);
}

/// A potential in any unit, here 10³⁰ times as large, has its minimum at the same place.
#[test]
fn the_unit_of_the_potential_does_not_matter() {
    let disk = Plane::from_fn(80, 80, |column, row| {
        let radius = (column as f32 - 40.0).hypot(row as f32 - 40.0);
        (20.5 - radius).clamp(0.0, 1.0)
    });
    let edges = Potential::edges(&disk, 2.0).unwrap();
    let start = snake::circle([40.0, 40.0], 30.0, 100);
    let settled = |scale: f64| {
        let potential = Potential::new(edges.values().map(|value| value * scale as f32)).unwrap();
        let usual = SnakeOptions::default();
        let options = SnakeOptions {
            tension: scale * usual.tension,
            rigidity: scale * usual.rigidity,
            ..usual
        };
        let found = snake::settle(&start, &potential, &options, |_| {}).unwrap();
        assert!(found.has_converged && found.steps > 2, "{scale}");
        found.points
    };
    for (a, b) in settled(1.0).iter().zip(settled(1e30)) {
        assert!((a[0] - b[0]).hypot(a[1] - b[1]) < 0.02, "{a:?} {b:?}");
    }
}

#[test]
fn snakes_that_cannot_be_are_errors() {
    let picture = Plane::from_fn(30, 20, |column, _| column as f32 / 30.0);
    let potential = Potential::edges(&picture, 1.0).unwrap();
    let options = SnakeOptions::default();
    let start = snake::circle([15.0, 10.0], 8.0, 20);
    let fails = |start: &[[f64; 2]], options: &SnakeOptions| {
        snake::settle(start, &potential, options, |_| {}).unwrap_err()
    };
    let few = fails(&start[..5], &options);
    assert_eq!(few, ContourError::SnakeTooFew { count: 5, least: 6 });
    let outside = ContourError::Outside {
        index: 0,
        point: [30.0, 10.0],
        size: [30, 20],
    };
    assert_eq!(
        fails(&snake::circle([15.0, 10.0], 15.0, 20), &options),
        outside
    );
    assert_eq!(
        fails(&[[15.0, 10.0]; 8], &options),
        ContourError::NoLength { spacing: 0.0 }
    );
    let mut wrong = start.clone();
    wrong[7][1] = f64::NAN;
    let error = fails(&wrong, &options);
    assert!(matches!(error, ContourError::Outside { index: 7, .. }));
    let negative = SnakeOptions {
        tension: -1.0,
        ..options
    };
    let setting = ContourError::Setting {
        setting: "tension",
        value: -1.0,
    };
    assert_eq!(fails(&start, &negative), setting);
    assert!(matches!(
        Potential::edges(&picture, -1.0),
        Err(ContourError::Sigma(_))
    ));
    let mut wrong = picture.clone();
    wrong.row_mut(13)[17] = f32::NAN;
    let named = ContourError::PixelNotFinite {
        column: 17,
        row: 13,
    };
    let flow = Flow::default();
    for potential in [
        Potential::edges(&wrong, 2.0),
        Potential::flow(&wrong, 2.0, &flow),
        Potential::new(wrong),
    ] {
        assert_eq!(potential.err(), Some(named.clone()));
    }
    // Both are numbers that a setting can be, and give an energy that none can be.
    let great = SnakeOptions {
        tension: 1e308,
        ..options
    };
    let error = fails(&snake::circle([15.0, 10.0], 9.0, 20), &great);
    assert!(
        matches!(error, ContourError::EnergyNotFinite { tension: 1e308, .. }),
        "{error}"
    );
    let small = Potential::new(Plane::filled(1, 5, 0.0));
    assert_eq!(
        small.err(),
        Some(ContourError::TooSmall {
            width: 1,
            height: 5
        })
    );
}

/// Of 100 points on a circle about a place at the border, those within 1.5 px of its first column.
#[test]
fn snakes_along_the_border_of_a_picture_or_without_area_are_told() {
    let settled = |points: Vec<[f64; 2]>| Settled {
        points,
        energy: 1.0,
        steps: 9,
        has_converged: true,
    };
    let size = [80, 60];
    let whole = settled(snake::circle([40.0, 30.0], 20.0, 100));
    assert!(whole.faults(size).is_empty());
    let mut cut = settled(snake::circle([6.0, 30.0], 16.0, 100));
    for point in &mut cut.points {
        point[0] = point[0].max(0.0);
    }
    let points = cut.points.iter().filter(|point| point[0] <= 1.5).count();
    let expected = SnakeFault::AtBorder { points, count: 100 };
    assert!(points > 20);
    assert_eq!(cut.faults(size), [expected]);
    assert_eq!(cut.faults([60, 80]), [expected]);
    let small = settled(snake::circle([40.0, 30.0], 1.0, 100)).faults(size);
    let line = settled(vec![[10.0, 20.0], [30.0, 25.0], [50.0, 30.0]]).faults(size);
    for faults in [small, line] {
        assert!(matches!(faults[..], [SnakeFault::Collapsed { area }] if area < 3.2));
    }
}
