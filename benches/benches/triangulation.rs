//! Pairs of pixels of two cameras to points, beside a matrix that moves as many points.

use std::error::Error;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use ga_camera::Intrinsics;
use ga_camera::observation::observe;
use ga_camera::rig::StereoRig;
use ga_camera::triangulation::{
    CovarianceColumns, Method, PixelColumns, PointColumns, TwoViews, triangulate_views,
};
use ga_runtime::cga3::Point;
use glam::{DMat4, DQuat, DVec3, DVec4};
use nullcone_benches::comparison;
use std::hint::black_box;

/// How many pairs: few enough for the second-level cache.
const COUNT: usize = 1024;

/// A rig with a slightly rotated right camera, and what it sees with noise of half a pixel.
struct Scene {
    rig: StereoRig,
    left: Vec<[f64; 2]>,
    right: Vec<[f64; 2]>,
}

fn scene() -> Result<Scene, Box<dyn Error>> {
    let left = Intrinsics::new([1332.2, 1318.5], [331.2, 235.3])?;
    let right = Intrinsics::new([1311.3, 1297.9], [339.1, 232.6])?;
    let (sine, cosine) = 0.03_f64.sin_cos();
    let rotation = [[cosine, 0.0, sine], [0.0, 1.0, 0.0], [-sine, 0.0, cosine]];
    let rig = StereoRig::from_matrices(left, right, rotation, [-0.2, -0.005, 0.008])?;
    let points: Vec<Point<f64>> = (0..COUNT)
        .map(|index| {
            let step = index as f64;
            let depth = 5.0 + 2.0 * (0.37 * step).sin();
            Point::new((1.3 * step).sin(), 0.8 * (2.1 * step).cos(), depth)
        })
        .collect();
    Ok(Scene {
        left: observe(&rig.left, &points, 0.5, 1)?,
        right: observe(&rig.right, &points, 0.5, 2)?,
        rig,
    })
}

fn columns(pixels: &[[f64; 2]]) -> [Vec<f64>; 2] {
    [0, 1].map(|axis| pixels.iter().map(|pixel| pixel[axis]).collect())
}

fn pixel_pairs(criterion: &mut Criterion) {
    let Ok(scene) = scene() else { return };
    let Ok(views) = TwoViews::new(&scene.rig.left, &scene.rig.right) else {
        return;
    };
    let pixels = [columns(&scene.left), columns(&scene.right)];
    let [left, right] = pixels.each_ref().map(|[u, v]| PixelColumns { u, v });
    let mut points = PointColumns::default();
    let mut covariances = CovarianceColumns::default();

    let mut group = criterion.benchmark_group("triangulation/pixel-pairs-f64");
    group.throughput(Throughput::Elements(COUNT as u64));
    let methods = [
        ("nullcone, midpoint", Method::Midpoint),
        ("nullcone, weighted by depth", Method::DepthWeighted),
        ("nullcone, optimal", Method::Optimal),
    ];
    for (name, method) in methods {
        group.bench_function(name, |bencher| {
            bencher.iter(|| views.triangulate(method, left, right, black_box(&mut points)));
        });
    }
    for (name, method) in [methods[0], methods[2]] {
        group.bench_function(format!("{name} with covariance"), |bencher| {
            bencher.iter(|| {
                views.triangulate(method, left, right, black_box(&mut points))?;
                views.covariances(0.5, &points, black_box(&mut covariances))
            });
        });
    }
    group.bench_function("nullcone, single rays", |bencher| {
        bencher.iter(|| scene.rig.triangulate_all(&scene.left, &scene.right).ok());
    });

    let rotation = DQuat::from_rotation_y(0.03);
    let matrix = DMat4::from_rotation_translation(rotation, DVec3::new(-0.2, 0.0, 0.0));
    let vectors: Vec<DVec4> = scene
        .left
        .iter()
        .map(|pixel| DVec4::new(pixel[0], pixel[1], 1.0, 1.0))
        .collect();
    let mut moved = vectors.clone();
    group.bench_function("glam DMat4 times vector", |bencher| {
        bencher.iter(|| {
            for (vector, moved) in black_box(&vectors).iter().zip(black_box(&mut moved)) {
                *moved = matrix * *vector;
            }
        });
    });
}

fn many_views(criterion: &mut Criterion) {
    let Ok(scene) = scene() else { return };
    let cameras = [
        scene.rig.left,
        scene.rig.right,
        scene.rig.left,
        scene.rig.right,
    ];
    let mut group = criterion.benchmark_group("triangulation/four-views-f64");
    group.throughput(Throughput::Elements(COUNT as u64));
    group.bench_function("nullcone", |bencher| {
        bencher.iter(|| {
            for (left, right) in scene.left.iter().zip(&scene.right) {
                let _ = black_box(triangulate_views(&cameras, &[*left, *right, *left, *right]));
            }
        });
    });
}

criterion_group! {
    name = benches;
    config = comparison::criterion();
    targets = pixel_pairs, many_views
}
criterion_main!(benches);
