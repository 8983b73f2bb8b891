//! Snakes and curves in space. A copy of the picture, in the same run, is the unit.
//!
//! The snake is that of scikit-image's example: 400 points from a circle round a face in a
//! photograph, with the usual tension and rigidity and with those of the example in the units of
//! this potential, until no point moves by more than 0.01 pixels. scikit-image needs 183 ms for it.

use std::error::Error;
use std::f64::consts::TAU;
use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use ga_camera::rig::StereoRig;
use ga_camera::{Camera, Intrinsics};
use ga_image::file;
use ga_image::grey::Luma;
use ga_image::plane::Plane;
use ga_runtime::cga3::Point;
use ga_vision::contour::snake::{Flow, Potential, SnakeOptions, circle, settle};
use ga_vision::contour::space_curve::{SpaceCurveOptions, space_curve};
use nullcone_benches::comparison;
use nullcone_shared_data::shared;

fn snakes(criterion: &mut Criterion) {
    let Some(folder) = shared("data/vision/quality") else {
        return;
    };
    let picture = file::read(folder.join("astronaut.png")).expect("the photograph is a picture");
    let picture: Plane<u8> = picture.to_grey(Luma::Bt601);
    let floats = picture.map(|value| f32::from(value) / 255.0);
    let potential = Potential::edges(&floats, 3.0).expect("the photograph has edges");
    let start = circle([220.0, 100.0], 100.0, 400);
    // The example sums over points, without their distance.
    let spacing = TAU * 100.0 / 400.0;
    let mut group = criterion.benchmark_group("snake/astronaut");
    for (name, options) in [
        (
            "the example's stiffness",
            SnakeOptions {
                tension: 0.16 * spacing.powi(2),
                rigidity: 106.0 * spacing.powi(4),
                ..SnakeOptions::default()
            },
        ),
        ("default", SnakeOptions::default()),
    ] {
        group.bench_function(name, |bench| {
            bench.iter(|| settle(black_box(&start), &potential, &options, |_| {}))
        });
    }
    group.bench_function("potential of edges", |bench| {
        bench.iter(|| Potential::edges(black_box(&floats), 3.0))
    });
    group.bench_function("potential of the flow", |bench| {
        bench.iter(|| Potential::flow(black_box(&floats), 3.0, &Flow::default()))
    });
    let mut copy = picture.clone();
    group.bench_function("copy", |bench| {
        bench.iter(|| {
            copy.values_mut()
                .copy_from_slice(black_box(picture.values()));
            black_box(&copy);
        })
    });
}

/// A circle in space from two contours of 400 points.
fn curves(criterion: &mut Criterion) {
    let (rig, [left, right]) = views().expect("both cameras see the circle");
    let options = SpaceCurveOptions::default();
    let mut group = criterion.benchmark_group("space-curve/400");
    group.bench_function("nullcone", |bench| {
        bench.iter(|| space_curve(&rig, black_box(&left), black_box(&right), &options))
    });
}

/// The pixels of a contour.
type Pixels = Vec<[f64; 2]>;

fn views() -> Result<(StereoRig, [Pixels; 2]), Box<dyn Error>> {
    let intrinsics = Intrinsics::new([800.0, 800.0], [320.0, 240.0])?;
    let identity = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let rig = StereoRig::from_matrices(intrinsics, intrinsics, identity, [-0.2, 0.0, 0.0])?;
    let circle: Vec<Point<f64>> = (0..400)
        .map(|k| (TAU * f64::from(k) / 400.0).sin_cos())
        .map(|(sin, cos)| Point::new(0.3 * cos, 0.3 * sin, 2.0))
        .collect();
    let seen = |camera: &Camera| {
        let pixels = camera.project_all(&circle);
        pixels.map_err(|(_, error)| error)
    };
    let views = [seen(&rig.left)?, seen(&rig.right)?];
    Ok((rig, views))
}

criterion_group! { name = benches; config = comparison::criterion(); targets = snakes, curves }
criterion_main!(benches);
