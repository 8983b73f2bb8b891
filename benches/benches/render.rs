//! Pictures of a mesh of 70,000 triangles, 1280 × 720.

use std::f64::consts::TAU;
use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use ga_render::{Buffers, Scene, Style, View, ViewDirection, render};
use nullcone_benches::comparison;

const AROUND: u32 = 350;
const ACROSS: u32 = 100;

/// A torus of 70,000 triangles.
fn torus() -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    for i in 0..AROUND {
        let (sin_u, cos_u) = (TAU * f64::from(i) / f64::from(AROUND)).sin_cos();
        for j in 0..ACROSS {
            let (sin_v, cos_v) = (TAU * f64::from(j) / f64::from(ACROSS)).sin_cos();
            let radius = 1.0 + 0.4 * cos_v;
            positions.push([radius * cos_u, 0.4 * sin_v, radius * sin_u]);
            let (next_i, next_j) = ((i + 1) % AROUND, (j + 1) % ACROSS);
            let at = |i: u32, j: u32| i * ACROSS + j;
            let (a, b) = (at(i, j), at(i, next_j));
            let (c, d) = (at(next_i, next_j), at(next_i, j));
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    (positions, triangles)
}

fn pictures(criterion: &mut Criterion) {
    let (positions, triangles) = torus();
    let scene = Scene::new(&positions, &triangles);
    let plain = Style {
        width: 1280,
        height: 720,
        supersampling: 2,
        depth_contrast: 0.0,
        ..Style::default()
    };
    let view = ViewDirection {
        elevation: 0.6,
        ..ViewDirection::default()
    };
    let points = positions.iter().copied();
    let camera = View::fit(points, view, 0.6, plain.aspect(), 0.05).expect("a torus has extent");

    let mut group = criterion.benchmark_group("render");
    group.sample_size(10);
    let shadow = Style {
        self_shadow: 1.0,
        ..plain
    };
    let all = Style {
        ambient_occlusion: 1.0,
        ..shadow
    };
    for (name, style) in [
        ("lit", plain),
        ("shadow", shadow),
        ("shadow-occlusion", all),
    ] {
        group.bench_function(name, |bencher| {
            bencher.iter(|| render(black_box(&scene), &camera, &style));
        });
    }
    group.bench_function("buffers", |bencher| {
        bencher.iter(|| Buffers::new(black_box(&scene), &camera, 1280, 720).map(|b| b.depth()));
    });
    group.finish();
}

criterion_group! { name = benches; config = comparison::criterion(); targets = pictures }
criterion_main!(benches);
